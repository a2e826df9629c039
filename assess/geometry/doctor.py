"""What is wrong with the elements of a model file, what cures it where it was drawn, and what reading it has mended."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from assess.geometry.boolean import find_overlap
from assess.geometry.mesh import InventoryEntry
from assess.messages.message import Message, Quantity

RECALCULATE = "turn the normals of all faces outwards, and export again"
MERGE = "merge the corners that coincide, and export again"
OVERLAPPING = "may stay at corners and seats, where a building counts it once; else end one at the face of the other"
ALONGSIDE = "they run beside one another: draw two leaves face to face, or delete one if it is one wall drawn twice"
LEFT_OPEN = "close its surface where it was drawn, and export again"

DEFECTS: Mapping[str, tuple[str, str, str]] = {
    "triangles-reversed": ("triangles that run against their neighbours: {number}", RECALCULATE, "reversed"),
    "body-reversed": ("all its triangles face inwards", RECALCULATE, "reversed"),
    "shells-reversed": ("closed shells that face inwards and lie in no material: {number}", RECALCULATE, "reversed"),
    "double-triangles-removed": ("triangles on others: {number}", "delete faces that stand twice", "removed"),
    "border-corners-joined": ("corners of open borders up to {reach} beside others: {number}", MERGE, "joined"),
    "edges-split": ("edges of triangles on which corners of others lie: {number}", MERGE, "split there"),
    "holes-closed": (
        "holes: {number}, {area} in all, the first around x = {x}, y = {y}, z = {z}",
        "draw the faces that are missing",
        "closed by planes",
    ),
    "flat-shells-removed": ("closed shells without volume: {number}", "delete loose faces", "removed"),
    "shells-united": (
        "overlaps among its {number} closed shells, near x = {x}, y = {y}, z = {z}",
        "unite them, or draw each as an element of its own",
        "united",
    ),
}
"""What was wrong where a repair was made, by its key, with the numbers of its message; what cures it; what was done."""

LEFT: Mapping[str, str] = {
    "self-overlap": "mend it where it was drawn, or split it into bodies",
    "many-shells": "draw each shell as an element of its own",
    "element-incomplete": "repair or export this element again",
    "not-all-built": "repair or export this element again",
    "size": "check its size, or give its unit (--unit, mesh_unit)",
    "size-in-unit": "check its size, or give its unit (--unit, mesh_unit)",
    "size-thick": "check its size, or give its unit (--unit, mesh_unit)",
    "size-thick-in-unit": "check its size, or give its unit (--unit, mesh_unit)",
    "far-from-origin": "move the model near the origin before exporting it",
}
"""What cures what was left as it is, by the key of its message."""


@dataclass(frozen=True)
class Diagnosis:
    """One defect of an element.

    element : as the file calls it; two of them where they overlap
    defect : what is wrong
    cure : what mends it where it was drawn
    mended : what was done on reading it; empty where nothing was
    moved : by how much that changed the volume [m3]; None where nothing was mended
    """

    element: str
    defect: str
    cure: str
    mended: str = ""
    moved: float | None = None


def diagnose(entry: InventoryEntry) -> tuple[Diagnosis, ...]:
    """Return the defects of a part of a model, in the order in which they were met; none of a sound one."""
    return tuple(_diagnoses(entry))


def find_overlaps(entries: Sequence[InventoryEntry]) -> tuple[tuple[Diagnosis, float], ...]:
    """Return each pair of parts of a model that are drawn over one another, with the volume that they share [m3]."""
    entries_of = [entry for entry in entries if entry.solid is not None]
    bodies = [(entry.element.shown, entry.solid) for entry in entries_of if entry.solid is not None]
    if not bodies:
        return ()
    boxes = [shapely.box(*body.vertices[:, :2].min(axis=0), *body.vertices[:, :2].max(axis=0)) for _, body in bodies]
    one, other = shapely.STRtree(boxes).query(boxes)
    found = []
    for i, j in zip(one[one < other].tolist(), other[one < other].tolist(), strict=True):
        shared = find_overlap(bodies[i][1], bodies[j][1])
        if shared is not None:
            cure = ALONGSIDE if _run_alongside(entries_of[i], entries_of[j]) else OVERLAPPING
            percent = Quantity(100.0 * shared.share, "percent", 3)
            defect = f"they share {Quantity(shared.volume, 'volume', 3)}, {percent} of the smaller one"
            found.append(
                (
                    Diagnosis(f"{bodies[i][0]}, {bodies[j][0]}", defect, cure),
                    shared.volume,
                )
            )
    return tuple(found)


PARALLEL = 0.94  # cosine: faces within 20 degrees of one another
BESIDE = 0.5  # of the shorter of two walls: leaves that lie over one another do so over more of their length


def _run_alongside(one: InventoryEntry, other: InventoryEntry) -> bool:
    """Return whether two walls that overlap are leaves side by side, not walls that cross or go on from one another."""
    if one.thin is None or other.thin is None or one.solid is None or other.solid is None:
        return False
    if abs(one.thin[0] * other.thin[0] + one.thin[1] * other.thin[1]) < PARALLEL:
        return False
    run = np.array([-one.thin[1], one.thin[0], 0.0])
    ends = [
        (float(along.min()), float(along.max())) for along in (one.solid.vertices @ run, other.solid.vertices @ run)
    ]
    shared = min(high for _, high in ends) - max(low for low, _ in ends)
    return shared > BESIDE * min(high - low for low, high in ends)


def _diagnoses(entry: InventoryEntry) -> Iterator[Diagnosis]:
    name = entry.element.shown
    if entry.why_not:
        defect, _, cure = entry.why_not.rpartition("; ")
        yield Diagnosis(name, defect or cure, cure if defect else LEFT_OPEN)
        return
    moved = _volumes_moved(entry.warnings, entry.volume or 0.0)
    for each, volume in zip(entry.warnings, moved, strict=True):
        if each.key in DEFECTS:
            defect, cure, mended = DEFECTS[each.key]
            yield Diagnosis(name, defect.format(**each.values), cure, mended, volume)
        elif each.key in LEFT:
            yield Diagnosis(name, each.text, LEFT[each.key])


def _volumes_moved(steps: Sequence[Message], volume: float) -> list[float]:
    """Return by how much each repair changed the volume [m3], from the share of the new one that it states.

    volume : after the last [m3]
    """
    found: list[float] = []
    for each in reversed(steps):
        change = each.values.get("change")
        moved = volume * change.value / 100.0 if isinstance(change, Quantity) else 0.0
        found.append(moved)
        volume -= moved
    return found[::-1]
