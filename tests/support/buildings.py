"""Buildings of boxes, whose parts are known: houses of storeys, with what touches what."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from assess.geometry.contact import find_contact
from assess.geometry.solid import Solid, box, profile
from assess.model.structure import COVERINGS, PLATES, Opening, Part, PartContact, PartKind, Structure

STONE, TIMBER = 1900.0, 400.0


def part_of(
    name: str, solid: Solid, kind: PartKind = "wall", *, normal=(1.0, 0.0), outward=False, density=STONE, **more
) -> Part:
    """Return a part by its body, which may face along x or y."""
    across = np.array([*normal, 0.0])
    along = np.array([-across[1], across[0], 0.0])
    z = solid.vertices[:, 2]
    return Part(
        name=name,
        kind=kind,
        solid=replace(solid, name=name),
        base=float(z.min()),
        top=float(z.max()),
        thickness=float(np.ptp(solid.vertices @ across)),
        length=float(np.ptp(solid.vertices @ along)),
        height=float(np.ptp(z)),
        normal=tuple(map(float, across)),
        along=tuple(map(float, along)),
        outward=outward,
        density=density,
        **more,
    )


def block(x, y, z, *, density=STONE) -> Solid:
    """Return a box between two x, two y and two z [m]."""
    (x0, x1), (y0, y1), (z0, z1) = x, y, z
    return box(
        thickness=x1 - x0,
        length=y1 - y0,
        height=z1 - z0,
        density=density,
        base=((x0 + x1) / 2, (y0 + y1) / 2, z0),
        name="block",
    )


def touching(parts: Sequence[Part]) -> tuple[PartContact, ...]:
    """Return the contacts of parts, whatever stands, bears or leans on what."""
    found = []
    for number, one in enumerate(parts):
        for other in parts[number + 1 :]:
            lower, upper = sorted((one, other), key=lambda part: (part.kind in COVERINGS, part.base, part.name))
            met = find_contact(lower.solid, upper.solid)
            if met is None or met.area < 0.01:
                continue
            relation = "leans-on" if not met.bearing else "bears-on" if upper.kind in COVERINGS else "stands-on"
            aside = float(met.centroid @ np.array(lower.normal)) - lower.middle if lower.kind in PLATES else 0.0
            found.append(
                PartContact(
                    upper.name, lower.name, relation, met.area, 0.0, aside, float(met.centroid[2]),
                    tuple(map(float, met.centroid)), tuple(map(float, met.normal)),
                )
            )  # fmt: skip
    return tuple(found)


def house(*, storeys: int = 2, whole: bool = False, caps: bool = False) -> Structure:
    """Return a house of 9 m by 7 m: façades along x at y = 0 and y = 7, side walls between them, floors, a flat roof.

    whole : walls are not divided at the floors; caps : with a gable on the left, a parapet and a chimney
    """
    heights = [(0.0, 3.0 * storeys)] if whole else [(3.0 * i, 3.0 * i + 3.0) for i in range(storeys)]
    parts = []
    for i, z in enumerate(heights):
        mark = "" if whole else f" {i + 1}"
        window = (Opening(2.0, 3.0, z[0] + 1.0, z[0] + 2.2),)
        parts += [
            part_of(f"Front{mark}", block((0, 9), (0, 0.5), z), normal=(0, -1), outward=True, openings=window),
            part_of(f"Back{mark}", block((0, 9), (6.5, 7), z), normal=(0, 1), outward=True),
            part_of(f"Left{mark}", block((0, 0.5), (0.5, 6.5), z), normal=(-1, 0), outward=True),
            part_of(f"Right{mark}", block((8.5, 9), (0.5, 6.5), z), normal=(1, 0), outward=True),
        ]
    for i in range(storeys):
        z = 3.0 * (i + 1)
        kind = "roof" if i == storeys - 1 else "floor"
        reach = (0.0, 7.0) if kind == "roof" else (0.25, 6.75)
        level = (z, z + 0.2) if kind == "roof" else (z - 0.2, z)
        parts.append(
            part_of(
                f"{kind.title()} {i + 1}", block((0.5, 8.5), reach, level, density=TIMBER), kind,
                normal=(0, 1), density=TIMBER,
            )
        )  # fmt: skip
    if caps:
        top = 3.0 * storeys
        gable = profile([(-3.0, top), (3.0, top), (0.0, top + 2.0)], length=0.5, density=STONE, name="gable")
        turned = gable.vertices[:, [1, 0, 2]] * (1, -1, 1) + (0.25, 3.5, 0.0)
        moved = replace(
            gable, vertices=turned, centroid=np.array([0.25, 3.5, gable.centroid[2]]),
            inertia=gable.inertia[np.ix_([1, 0, 2], [1, 0, 2])],
        )  # fmt: skip
        parts += [
            part_of("Gable", moved, "gable", normal=(-1, 0), outward=True),
            part_of("Chimney", block((8.5, 9), (3, 3.5), (top, top + 1.8)), "chimney"),
        ]
    return Structure(parts=tuple(parts), contacts=touching(parts))
