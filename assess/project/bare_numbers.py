"""Numbers alone that look as if another unit had been meant: accelerations in g, sizes in mm or inches, lb/ft3."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from scipy.constants import g

from assess.messages.message import Message, Quantity, warning
from assess.project.key_text import Key, key_text, look_up
from assess.project.usual_units import USUAL

HUGE = 60.0  # m: a body larger than this, by a number alone, was rather meant in another unit
BUILT = {"thickness": (0.1, 6.0), "length": (0.2, HUGE), "height": (0.2, HUGE)}  # m, of what is assessed
SHORTER = ("mm", "in", "cm", "ft")  # units that sizes are typed in, besides m
WEAK = 0.1 * g  # m/s2: below it a number alone was rather meant in g
SPECTRUM: Key = ("site", "spectrum")
PLACES: tuple[Key, ...] = (("site", "pga"), *((*SPECTRUM, key) for key in ("s_ds", "s_d1", "s_s", "s_1", "a_g")))
MATERIALS: Mapping[str, tuple[str, tuple[tuple[float, float, str], ...]]] = {
    "density": ("density", ((1.0, 4.0, "t/m^3"), (10.0, 35.0, "kN/m^3"), (60.0, 200.0, "lb/ft^3"))),
    "young_modulus": ("stress", ((0.05, 100.0, "GPa"), (100.0, 1e5, "MPa"), (1e5, 2e7, "psi"))),
    "compressive_strength": ("stress", ((0.1, 200.0, "MPa"), (200.0, 5e4, "psi"))),
    "tensile_strength": ("stress", ((0.001, 10.0, "MPa"), (10.0, 2e3, "psi"))),
}
"""For each number of a material its dimension and the ranges in SI that no masonry has, each with the unit meant."""


def bare_number_messages(raw: Mapping[str, Any]) -> Iterator[Message]:
    """Warn of each plain number of the file that is implausible for an earthquake, a wall or a masonry."""
    yield from _weak(raw)
    for name, body in _tables(raw, "bodies"):
        yield from _of_sizes(("bodies", name), body)
    for name, material in _tables(raw, "materials"):
        yield from _of_material(("materials", name), material)


def _tables(raw: Mapping[str, Any], table: str) -> Iterable[tuple[str, Mapping[str, Any]]]:
    named = look_up(raw, (table,))[1]
    return [(name, each) for name, each in _of(named) if isinstance(each, Mapping)]


def _of(table: object) -> Iterable[tuple[str, Any]]:
    return table.items() if isinstance(table, Mapping) else ()


def _of_sizes(body: Key, raw: Mapping[str, Any]) -> Iterator[Message]:
    """Warn of each size of a box or profile if one of them is huge and all are written without a unit."""
    sizes = {key: (words, size) for key, words, size in _sizes(raw) if is_number(size)}
    if not any(size > HUGE for _, size in sizes.values()):
        return
    units = [unit for unit in SHORTER if all(_is_built(words, size, unit) for words, size in sizes.values())]
    for key, (_, size) in sizes.items():
        if size > HUGE or units:
            likely = " / ".join(f'"{Quantity(size)} {unit}"' for unit in units or ("mm",))
            yield warning("box-size", key_text((*body, *key)), given=Quantity(size, "length"), likely=likely)


def _sizes(raw: Mapping[str, Any]) -> Iterator[tuple[Key, str, Any]]:
    """Yield the sizes of a body with their keys and names."""
    for name, size in _of(raw.get("box")):
        if name in BUILT:
            yield ("box", name), name, size
    corners = raw.get("profile")
    if isinstance(corners, list) and corners:
        yield ("length",), "length", raw.get("length")
        for name, axis in (("thickness", 0), ("height", 1)):
            yield ("profile",), name, _extent(corners, axis)


def _extent(corners: Sequence[Any], axis: int) -> float | None:
    """Return the extent along an axis of corners written without a unit."""
    along = [corner[axis] for corner in corners if isinstance(corner, list) and len(corner) == 2]
    return max(along) - min(along) if along and all(map(is_number, along)) else None


def _is_built(words: str, size: float, unit: str) -> bool:
    least, most = BUILT[words]
    return least <= size * float(USUAL["length"][unit]) <= most


def is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _of_material(material: Key, raw: Mapping[str, Any]) -> Iterator[Message]:
    """Warn of each number of a material that no masonry has, with the unit that was likely meant."""
    for name, (dimension, ranges) in MATERIALS.items():
        value: Any = raw.get(name)
        unit = next((unit for low, high, unit in ranges if is_number(value) and low <= value < high), "")
        if unit:
            given = Quantity(value, dimension)
            yield warning(
                "material-unit", key_text((*material, name)), given=given, likely=f'"{Quantity(value)} {unit}"'
            )


def _weak(raw: Mapping[str, Any]) -> Iterator[Message]:
    levels = look_up(raw, ("analysis", "levels"))[1] or ()
    rows = look_up(raw, (*SPECTRUM, "hazard"))[1] or ()
    listed: list[Key] = [("analysis", "levels", place) for place in range(len(levels))]
    listed += [(*SPECTRUM, "hazard", place, "a_g") for place in range(len(rows))]
    for key in (*PLACES, *listed):
        value = look_up(raw, key)[1]
        if isinstance(value, int | float) and value < WEAK:
            given, as_g = Quantity(value, "acceleration"), Quantity(value / g, "ground acceleration", 3)
            yield warning("unit", key_text(key), given=given, as_g=as_g, number=Quantity(value))
