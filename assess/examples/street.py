"""A street of forty façades as a table: sizes, masonry, floors and ties of each, drawn by a seeded generator.

The street is made up. Houses of two and three storeys stand on rock at its upper end and on soft soil by the river.
Every third house has ties at its floor; in the others the beams are nailed to the wall.
"""

from __future__ import annotations

from random import Random

HOUSES, SEED = 40, 1
BOX, LOADS = "bodies.facade.box", "mechanisms.facade.loads"
COLUMNS = (
    "id",
    "title",
    "site.spectrum.soil",
    f"{BOX}.thickness [m]",
    f"{BOX}.length [m]",
    f"{BOX}.height [m]",
    "materials.stone.density [kg/m^3]",
    f"{LOADS}.0.mass [kg]",
    f"{LOADS}.0.at.1 [m]",
    f"{LOADS}.1.mass [kg]",
    f"{LOADS}.1.at.1 [m]",
    f"{LOADS}.2.force [kN]",
    f"{LOADS}.2.at.1 [m]",
)


def table() -> str:
    """Return the table of the street as CSV, one façade a row; no cell holds a comma."""
    random = Random(SEED)
    rows = (COLUMNS, *(_facade(number, random) for number in range(1, HOUSES + 1)))
    return "".join(f"{','.join(row)}\n" for row in rows)


def _facade(number: int, random: Random) -> tuple[str, ...]:
    """Return the row of a house: floors and roof press by what they span, the upper floor at half the height."""
    storeys = random.choice((2, 2, 3))
    height, length = 3.1 * storeys + random.uniform(-0.4, 0.6), random.uniform(4.5, 8.5)
    thickness = random.uniform(0.45, 0.80)
    span, floor = random.uniform(3.5, 5.5), height / storeys * (storeys - 1)
    return (
        f"V{number:02}",
        f"Via dei Mulini {number}",
        "A" if number <= 14 else "B" if number <= 30 else "C",
        f"{thickness:.2f}",
        f"{length:.2f}",
        f"{height:.2f}",
        f"{random.uniform(1750, 2150):.0f}",
        f"{length * span / 2 * 250:.0f}",
        f"{floor:.2f}",
        f"{length * span / 2 * 160:.0f}",
        f"{height:.2f}",
        f"{random.uniform(*((15, 40) if number % 3 == 0 else (1, 3))):.1f}",
        f"{floor:.2f}",
    )
