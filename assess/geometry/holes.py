"""Holes of a surface: closed loops of open edges, and the plane faces that close them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from assess.geometry.surface import Surface, find_edges, open_edges
from spectra.arrays import FloatArray, IntArray

LARGEST = 0.2  # of the surface, holes closed: more than this is not closed by a guess
UNCERTAINTY = 0.01  # of the volume: by how much the plane that closes a hole may be wrong
LEVEL = 1e-6  # of a loop's size: loops this near one plane bound one hole, a ring


@dataclass(frozen=True)
class Hole:
    """A hole in a surface.

    Attributes
    ----------
    loops : vertices in order, as the missing face runs round it: its outer border, then its inner ones
    triangles : that close it [k, 3]; none where its border crosses itself
    area : of its plane [m2]
    deviation : largest distance of its border from that plane [m]
    centre : [3] [m]
    """

    loops: tuple[IntArray, ...]
    triangles: IntArray
    area: float
    deviation: float
    centre: FloatArray

    @property
    def edges(self) -> int:
        """The number of edges of its border."""
        return sum(len(loop) for loop in self.loops)


@dataclass(frozen=True)
class _Ring:
    """A loop of vertices with its plane: area vector [3] [m2], centre [3] [m], size and deviation [m]."""

    loop: IntArray
    points: FloatArray
    normal: FloatArray
    centre: FloatArray
    size: float
    deviation: float


def find_holes(surface: Surface) -> list[Hole]:
    """Find the holes of a surface; coplanar nested loops bound one hole, like the foot of a tube."""
    vertices, triangles = surface
    rings = [_ring(vertices, loop) for loop in closed_loops(open_edges(find_edges(triangles))[:, ::-1])]
    rings.sort(key=lambda ring: -float(np.linalg.norm(ring.normal)))
    groups: list[list[_Ring]] = []
    for ring in rings:
        around = next((group for group in groups if _is_inner(ring, group[0])), None)
        if around is None:
            groups.append([ring])
        else:
            around.append(ring)
    return [_hole(group) for group in groups]


def closed_loops(edges: IntArray) -> list[IntArray]:
    """Trace closed loops of vertices along directed edges [b, 2]; chains that end are dropped."""
    onwards: dict[int, list[int]] = {}
    for start, end in edges.tolist():
        onwards.setdefault(start, []).append(end)
    found = []
    for start in onwards:
        while onwards[start]:
            found += _trace_loops(start, onwards)
    return found


def _trace_loops(start: int, onwards: dict[int, list[int]]) -> list[IntArray]:
    """Trace the loops met on one walk from a vertex; edges walked are taken from `onwards`."""
    found = []
    path, place = [start], {start: 0}
    while onwards.get(path[-1]):
        vertex = onwards[path[-1]].pop()
        if vertex not in place:
            place[vertex] = len(path)
            path.append(vertex)
            continue
        loop = path[place[vertex] :]
        found.append(np.array(loop, dtype=np.int64))
        for passed in loop[1:]:
            del place[passed]
        del path[place[vertex] + 1 :]
    return found


def _ring(vertices: FloatArray, loop: IntArray) -> _Ring:
    """Return a loop with the plane of its area vector (Newell's) through its middle."""
    points = vertices[loop]
    centre = points.mean(axis=0)
    around = points - centre
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0) / 2.0
    length = float(np.linalg.norm(normal))
    off = np.abs(around @ (normal / length)) if length > 0.0 else np.linalg.norm(around, axis=1)
    return _Ring(loop, points, normal, centre, float(np.ptp(points, axis=0).max()), float(off.max()))


def _is_inner(ring: _Ring, outer: _Ring) -> bool:
    """Return whether a loop lies in the plane of another, inside it, and runs the opposite way."""
    if ring.normal @ outer.normal >= 0.0:
        return False
    axes = _axes(outer.normal)
    at, to = (ring.points - outer.centre) @ axes.T, (outer.points - outer.centre) @ axes.T
    if np.abs(at[:, 2]).max() > max(LEVEL * outer.size, outer.deviation):
        return False
    face = shapely.Polygon(to[:, :2])
    return bool(face.is_valid and shapely.contains_xy(face, at[:, 0], at[:, 1]).all())


def _hole(rings: Sequence[_Ring]) -> Hole:
    """Return the hole inside the first of the rings and around the others."""
    outer = rings[0]
    loops = tuple(ring.loop for ring in rings)
    area = max(float(np.linalg.norm(sum((ring.normal for ring in rings), start=np.zeros(3)))), 0.0)
    deviation = max(ring.deviation for ring in rings)
    return Hole(loops, _triangulate(rings), area, deviation, outer.centre)


def _triangulate(rings: Sequence[_Ring]) -> IntArray:
    """Triangulate the loops in their plane (constrained Delaunay) [k, 3]; none where they cross."""
    outer = rings[0]
    if len(rings) == 1 and len(outer.loop) == 3:
        return outer.loop[None]
    axes = _axes(outer.normal)
    flat = [((ring.points - outer.centre) @ axes.T)[:, :2] for ring in rings]
    polygon = shapely.Polygon(flat[0], flat[1:])
    if not polygon.is_valid or polygon.area == 0.0:
        return np.empty((0, 3), dtype=np.int64)
    corners = np.concatenate(flat).tolist()
    index = dict(zip(map(tuple, corners), np.concatenate([ring.loop for ring in rings]).tolist(), strict=True))
    pieces = shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))
    turned = (shapely.get_coordinates(shapely.orient_polygons(piece))[:3].tolist() for piece in pieces)
    return np.array([[index[x, y] for x, y in corner] for corner in turned], dtype=np.int64)


def _axes(normal: FloatArray) -> FloatArray:
    """Return two directions in a plane and its unit normal as rows [3, 3], right-handed."""
    length = float(np.linalg.norm(normal))
    n = normal / length if length > 0.0 else np.array([0.0, 0.0, 1.0])
    first = np.cross(n, np.eye(3)[int(np.argmin(np.abs(n)))])
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(n, first), n])
