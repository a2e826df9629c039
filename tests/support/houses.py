"""Synthetic houses: walls, floors and what stands on them as solids, and the files that programs would write of them.

Each part is planted with its kind and thickness, so that what is read can be held against what was drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from assess.geometry.boolean import subtract
from assess.geometry.solid import Solid, polyhedron
from spectra.arrays import FloatArray
from tests.support import mesh_files

Rectangle = tuple[float, float, float, float]
"""x0, y0, x1, y1 [m]."""
PLANS: dict[str, tuple[tuple[float, float], ...]] = {
    "rectangle": ((0, 0), (9, 0), (9, 7), (0, 7)),
    "L": ((0, 0), (12, 0), (12, 6), (6, 6), (6, 11), (0, 11)),
    "court": ((0, 0), (16, 0), (16, 14), (0, 14)),
}
"""Outlines, anticlockwise [m]."""
COURT: tuple[tuple[float, float], ...] = ((5, 5), (5, 9), (11, 9), (11, 5))
"""The outline of a courtyard, clockwise: the building is on its left."""
FLOORS: dict[str, tuple[Rectangle, ...]] = {
    "rectangle": ((0, 0, 9, 7),),
    "L": ((0, 0, 12, 6), (0, 5.5, 6, 11)),
    "court": ((0, 0, 16, 5.5), (0, 8.5, 16, 14), (0, 5, 5.5, 9), (10.5, 5, 16, 9)),
}
"""Between the outer faces of the walls that each floor spans between."""
THICKNESS, STOREY, SLAB = 0.5, 3.2, 0.25  # m


@dataclass(frozen=True)
class Planted:
    """A part as it was drawn: its kind, its thickness [m] and its body."""

    name: str
    kind: str
    thickness: float
    solid: Solid


@dataclass(frozen=True)
class House:
    """What a house is made of.

    plan : a key of `PLANS`
    storeys : how many
    split : whether walls end at each floor
    overlap : whether walls are drawn over one another at corners, or butt
    gap : between walls and what they butt on [m]
    openings : whether each outer wall has a door or a window
    party : whether a wall divides the house in two
    top : "flat", "gables" or "parapets"
    chimney, tower : whether there is one; a tower stands beside the house and carries a spire
    bearing : of the floors on the walls [m]
    """

    plan: str = "rectangle"
    storeys: int = 1
    split: bool = True
    overlap: bool = False
    gap: float = 0.0
    openings: bool = True
    party: bool = False
    top: str = "flat"
    chimney: bool = False
    tower: bool = False
    bearing: float = 0.15

    @property
    def height(self) -> float:
        """Of the eaves [m]."""
        return self.storeys * STOREY

    def parts(self) -> tuple[Planted, ...]:
        """Return all parts."""
        return (*self._walls(), *self._floors(), *self._tops())

    def _walls(self) -> Iterator[Planted]:
        levels = [(k * STOREY, STOREY) for k in range(self.storeys)] if self.split else [(0.0, self.height)]
        for base, height in levels:
            for number, (rectangle, along) in enumerate(self._wall_rectangles()):
                wall = prism(rectangle, base, height)
                if self.openings and min(rectangle[2] - rectangle[0], rectangle[3] - rectangle[1]) < THICKNESS + 0.01:
                    wall = _pierced(wall, rectangle, along, base, door=base == 0.0 and number % 2 == 0)
                yield Planted(f"wall {number} at {base:g}", "wall", THICKNESS, wall)

    def _wall_rectangles(self) -> Iterator[tuple[Rectangle, int]]:
        """Return the rectangle of each wall and the axis of its length."""
        outlines = [PLANS[self.plan], *([COURT] if self.plan == "court" else [])]
        for outline in outlines:
            corners = np.array(outline, dtype=float)
            for k in range(len(corners)):
                yield self._wall_of_edge(corners, k)
        if self.party:
            end = THICKNESS + self.gap
            yield (4.25, end, 4.75, PLANS[self.plan][2][1] - end), 1

    def _wall_of_edge(self, corners: FloatArray, k: int) -> tuple[Rectangle, int]:
        """Return the wall on the inner side of an edge; the corner at its start is another's unless they overlap."""
        a, b, before, after = (corners[(k + i) % len(corners)] for i in (0, 1, -1, 2))
        u = (b - a) / np.linalg.norm(b - a)
        inwards = np.array([-u[1], u[0]])
        starts_convex, ends_convex = _left(a - before, b - a), _left(b - a, after - b)
        start = a + u * ((0.0 if self.overlap else THICKNESS + self.gap) if starts_convex else self.gap)
        end = b + u * (0.0 if ends_convex else THICKNESS)
        points = np.array([start, end, start + THICKNESS * inwards, end + THICKNESS * inwards])
        (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
        return (float(x0), float(y0), float(x1), float(y1)), int(abs(u[1]) > 0.5)

    def _floors(self) -> Iterator[Planted]:
        inset = THICKNESS - self.bearing
        for storey in range(1, self.storeys + 1 if self.top != "gables" else self.storeys):
            for number, (x0, y0, x1, y1) in enumerate(FLOORS[self.plan]):
                slab = prism((x0 + inset, y0 + inset, x1 - inset, y1 - inset), storey * STOREY - SLAB, SLAB)
                if self.party:
                    half = [(x0 + inset, 4.4), (4.6, x1 - inset)]
                    for side, (left, right) in enumerate(half):
                        each = prism((left, y0 + inset, right, y1 - inset), storey * STOREY - SLAB, SLAB)
                        yield Planted(f"floor {storey}.{side}", "floor", SLAB, each)
                else:
                    yield Planted(f"floor {storey}.{number}", "floor", SLAB, slab)

    def _tops(self) -> Iterator[Planted]:
        eaves, (width, depth) = self.height, PLANS[self.plan][2]
        if self.top == "parapets":
            yield Planted("parapet", "parapet", 0.3, prism((0.0, 0.0, width, 0.3), eaves, 0.9))
        if self.top == "gables":
            for name, x in (("gable west", 0.0), ("gable east", width - THICKNESS)):
                outline = [(0.0, 0.0), (depth, 0.0), (depth / 2.0, 2.0)]
                yield Planted(name, "gable", THICKNESS, extrude(outline, x, x + THICKNESS, eaves))
            for name, side in (("roof south", 0.0), ("roof north", depth)):
                ridge = depth / 2.0
                outline = [(side, 0.0), (ridge, 2.0), (ridge, 2.2), (side, 0.2)]
                thickness = 0.2 * np.cos(np.arctan2(2.0, ridge))  # square to the slope
                yield Planted(name, "roof", float(thickness), extrude(outline, 0.0, width, eaves))
        if self.chimney:
            base = eaves + (0.2 if self.top == "gables" else 0.0)
            yield Planted("chimney", "chimney", 0.5, prism((2.0, 0.0, 2.6, 0.5), base, 1.5))
        if self.tower:
            x0, x1, top = -4.5, -0.5, 2.0 * self.height + 6.0
            ring = subtract(
                prism((x0, 0.0, x1, 4.0), 0.0, top), [prism((x0 + 0.8, 0.8, x1 - 0.8, 3.2), -1.0, top + 2.0)]
            )
            assert ring is not None
            yield Planted("tower", "tower", 4.0, ring)
            yield Planted("spire", "tower", 4.0, pyramid((x0, 0.0, x1, 4.0), top, 8.0))


def turned(parts: Sequence[Planted], *, angle: float, noise: float = 0.0, seed: int = 0) -> tuple[Planted, ...]:
    """Return parts turned about z, each corner moved by up to the noise [m]."""
    c, s, rng = np.cos(angle), np.sin(angle), np.random.default_rng(seed)
    A = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    found = []
    for part in parts:
        away = rng.normal(size=part.solid.vertices.shape)
        away *= noise * rng.uniform(size=(len(away), 1)) ** (1.0 / 3.0) / np.linalg.norm(away, axis=1, keepdims=True)
        moved = polyhedron(part.solid.vertices @ A.T + away, part.solid.triangles, density=1.0, name=part.name)
        found.append(replace(part, solid=moved))
    return tuple(found)


def write_groups(file: Path, parts: Sequence[Planted], *, unit: float = 1.0) -> Path:
    """Write OBJ, an object to each part."""
    before, content = 0, b""
    for part in parts:
        vertices = part.solid.vertices / unit
        content += mesh_files.obj(vertices, part.solid.triangles, name=part.name, before=before)
        before += len(vertices)
    file.write_bytes(content)
    return file


def write_merged(file: Path, parts: Sequence[Planted], *, unit: float = 1.0) -> Path:
    """Write one mesh of all parts, as STL or OBJ by the file's name."""
    starts = np.cumsum([0, *(len(part.solid.vertices) for part in parts[:-1])])
    vertices = np.concatenate([part.solid.vertices for part in parts]) / unit
    triangles = np.concatenate([part.solid.triangles + start for part, start in zip(parts, starts, strict=True)])
    write = mesh_files.stl_text if file.suffix == ".stl" else mesh_files.obj
    file.write_bytes(write(vertices, triangles))
    return file


IFC_CLASSES = {"floor": "IfcSlab", "roof": "IfcRoof", "chimney": "IfcChimney", "tower": "IfcBuildingElementProxy"}


def write_ifc(
    file: Path, parts: Sequence[Planted], *, unit: float = 1.0, extra: Sequence[tuple[str, Planted]] = ()
) -> Path:
    """Write IFC, an element to each part with its storey; extra: others, by their class."""
    import ifcopenshell.api.aggregate as aggregate
    import ifcopenshell.api.context as context
    import ifcopenshell.api.geometry as geometry
    import ifcopenshell.api.project as project
    import ifcopenshell.api.root as root
    import ifcopenshell.api.spatial as spatial
    import ifcopenshell.api.unit as units

    model: Any = project.create_file()
    top = root.create_entity(model, ifc_class="IfcProject", name="house")
    prefix = {1.0: None, 1e-3: "MILLI"}[unit]
    units.assign_unit(model, units=[units.add_si_unit(model, unit_type="LENGTHUNIT", prefix=prefix)])
    whole = context.add_context(model, context_type="Model")
    body = context.add_context(
        model, context_type="Model", context_identifier="Body", target_view="MODEL_VIEW", parent=whole
    )
    building = root.create_entity(model, ifc_class="IfcBuilding", name="house")
    aggregate.assign_object(model, products=[building], relating_object=top)
    storeys = {}
    for kind, part in [*((IFC_CLASSES.get(part.kind, "IfcWall"), part) for part in parts), *extra]:
        level = round(float(part.solid.vertices[:, 2].min()) // STOREY * STOREY, 2)
        if level not in storeys:
            storeys[level] = root.create_entity(model, ifc_class="IfcBuildingStorey", name=f"level {level:g}")
            storeys[level].Elevation = level / unit
            aggregate.assign_object(model, products=[storeys[level]], relating_object=building)
        made = root.create_entity(model, ifc_class=kind, name=part.name)
        geometry.edit_object_placement(model, product=made, matrix=np.eye(4))
        shape = geometry.add_mesh_representation(
            model, context=body, vertices=[part.solid.vertices.tolist()], faces=[part.solid.triangles.tolist()]
        )
        geometry.assign_representation(model, product=made, representation=shape)
        spatial.assign_container(model, products=[made], relating_structure=storeys[level])
    model.write(str(file))
    return file


def prism(rectangle: Rectangle, base: float, height: float) -> Solid:
    """Return an upright box."""
    x0, y0, x1, y1 = rectangle
    return extrude([(y0, 0.0), (y1, 0.0), (y1, height), (y0, height)], x0, x1, base)


def extrude(outline: Sequence[tuple[float, float]], x0: float, x1: float, base: float) -> Solid:
    """Return a convex outline in y and z over a base, extruded along x."""
    points, n = np.array(outline), len(outline)
    ends = [np.column_stack([np.full(n, x), points[:, 0], points[:, 1] + base]) for x in (x0, x1)]
    return _between(ends[0], ends[1], [(0, k, k + 1) for k in range(1, n - 1)])


def pyramid(rectangle: Rectangle, base: float, height: float) -> Solid:
    """Return a pyramid over a rectangle."""
    x0, y0, x1, y1 = rectangle
    corners = [(x0, y0, base), (x1, y0, base), (x1, y1, base), (x0, y1, base)]
    tip = ((x0 + x1) / 2.0, (y0 + y1) / 2.0, base + height)
    triangles = [(0, 2, 1), (0, 3, 2), *((k, (k + 1) % 4, 4) for k in range(4))]
    return _outwards(np.array([*corners, tip]), np.array(triangles))


def vault(
    radius: float, thickness: float, *, length: float, base: float, at: tuple[float, float] = (0.0, 0.0)
) -> Solid:
    """Return a barrel vault along x, a half ring of 16 flat pieces; an arch where it is short."""
    angles = np.linspace(0.0, np.pi, 17)
    rings = [np.column_stack([r * np.cos(angles), r * np.sin(angles)]) for r in (radius + thickness, radius)]
    outline, n = np.concatenate([rings[0], rings[1][::-1]]), 34
    quads = [(k, k + 1, n - 2 - k, n - 1 - k) for k in range(16)]
    faces = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    first, last = (
        np.column_stack([np.full(n, at[0] + x), outline[:, 0] + at[1], outline[:, 1] + base])
        for x in (-length / 2, length / 2)
    )
    return _between(first, last, faces)


def bent_wall(radius: float, thickness: float, *, height: float) -> Solid:
    """Return a half ring in plan towards +y, of 12 flat pieces."""
    angles, n = np.linspace(0.0, np.pi, 13), 26
    rings = [np.column_stack([r * np.cos(angles), r * np.sin(angles)]) for r in (radius, radius - thickness)]
    outline = np.concatenate([rings[0], rings[1][::-1]])
    quads = [(k, k + 1, n - 2 - k, n - 1 - k) for k in range(12)]
    faces = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return _between(np.column_stack([outline, np.zeros(n)]), np.column_stack([outline, np.full(n, height)]), faces)


def _between(first: FloatArray, last: FloatArray, faces: Sequence[tuple[int, int, int]]) -> Solid:
    """Return the solid between two outlines [n, 3] of the same faces."""
    n = len(first)
    sides = [(k, (k + 1) % n) for k in range(n)]
    triangles = [
        *((a, c, b) for a, b, c in faces),
        *((a + n, b + n, c + n) for a, b, c in faces),
        *((a, b, b + n) for a, b in sides),
        *((a, b + n, a + n) for a, b in sides),
    ]
    return _outwards(np.concatenate([first, last]), np.array(triangles))


def _outwards(vertices: FloatArray, triangles: Any) -> Solid:
    """Return the solid of a surface that faces one way, whichever."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    outwards = float(np.einsum("mi,mi->m", a - vertices.mean(axis=0), np.cross(b - a, c - a)).sum()) > 0.0
    return polyhedron(vertices, triangles if outwards else triangles[:, ::-1], density=1.0, name="")


def _left(one: FloatArray, other: FloatArray) -> bool:
    """Return whether the second of two edges turns to the left."""
    return bool(one[0] * other[1] - one[1] * other[0] > 0.0)


def _pierced(wall: Solid, rectangle: Rectangle, along: int, base: float, *, door: bool) -> Solid:
    """Return a wall with a door, or a window, in its middle."""
    low, high = np.array(rectangle[:2]), np.array(rectangle[2:])
    middle = (low + high) / 2.0
    low, high = low - 0.5, high + 0.5
    low[along], high[along] = middle[along] - 0.6, middle[along] + 0.6
    bottom, height = (base - 0.5, 2.7) if door else (base + 1.0, 1.4)
    found = subtract(wall, [prism((low[0], low[1], high[0], high[1]), bottom, height)])
    assert found is not None
    return found
