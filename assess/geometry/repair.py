"""Repair of meshes that are not closed, where the intended shape is plain; each step says what it did.

A hole is bounded by closed loops of open edges; plane faces close it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import shapely

from assess.errors import GeometryError
from assess.geometry.shells import unify_shells
from assess.geometry.surface import (
    Surface,
    adjacent_triangles,
    area,
    connected_groups,
    coordinate_values,
    drop_degenerate,
    find_edges,
    neighbours,
    open_edges,
    point_text,
    volume,
    volume_change,
)
from assess.messages.message import Message, Quantity, count_noun, note, whole_number
from spectra.arrays import FloatArray, IntArray

if TYPE_CHECKING:
    from scipy.spatial import KDTree

NEAR = 1e-4  # of the body's size: corners of an open border nearer than this are one
Steps = tuple[Message, ...]


def repair(surface: Surface, *, where: str) -> tuple[Surface, Steps]:
    """Close the surface of a mesh and return it with what was done; a good mesh is returned unchanged.

    Triangles are oriented consistently; double ones removed; open borders joined where they touch; plane holes of at
    most a fifth of the surface closed; inverted shells reversed, overlapping ones united. What remains open is refused.

    Parameters
    ----------
    surface : merged: each position once
    where : named in errors

    Raises
    ------
    GeometryError : the surface cannot be closed
    """
    done: Steps = ()
    across = adjacent_triangles(surface[1])
    if across is None:
        for step in (
            _orient_consistently,
            _drop_double_triangles,
            _weld_borders,
            _split_edges,
            _orient_consistently,
            _fill_holes,
        ):
            surface, more = step(surface)
            _refuse_empty(surface, where=where)
            done = (*done, *more)
        _refuse_open(surface, where=where)
    surface, more = unify_shells(surface, across, where=where)
    _refuse_empty(surface, where=where)
    return surface, (*done, *more)


LARGEST_HOLES = 0.2  # of the surface, holes closed: more than this is not closed by a guess
HOLE_UNCERTAINTY = 0.01  # of the volume: by how much the plane that closes a hole may be wrong
LEVEL = 1e-6  # of a loop's size: loops this near one plane bound one hole, a ring


@dataclass(frozen=True)
class Hole:
    """A hole in a surface.

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


def _orient_consistently(surface: Surface) -> tuple[Surface, Steps]:
    """Orient neighbours so that they run along their common edge in opposite directions; the minority is reversed.

    Each triangle is in a graph twice, as it is and reversed; neighbours are linked in the senses that agree. The two
    components of a sheet are its two orientations. A one-sided sheet (Möbius strip) is left.
    """
    vertices, triangles = surface
    n = len(triangles)
    (i, j), alike = (array.T for array in neighbours(find_edges(triangles)))
    across = np.where(alike, j, j + n)
    sense = connected_groups(np.column_stack([np.r_[i, i + n], np.r_[across, (across + n) % (2 * n)]]), count=2 * n)
    here, there = sense[:n], sense[n:]
    many = np.bincount(here, minlength=2 * n)
    turn = (many[there] > many[here]) | ((many[there] == many[here]) & (there < here))
    if not turn.any():
        return surface, ()
    faces = np.where(turn[:, None], triangles[:, ::-1], triangles)
    return (vertices, faces), (note("triangles-reversed", number=whole_number(int(turn.sum()))),)


def _drop_double_triangles(surface: Surface) -> tuple[Surface, Steps]:
    """Keep each triangle once, and drop pairs that lie back to back if that leaves fewer gaps."""
    vertices, triangles = surface
    order = np.argsort(triangles, axis=1)
    odd = np.isin(order @ [9, 3, 1], [0 * 9 + 2 * 3 + 1, 1 * 9 + 0 * 3 + 2, 2 * 9 + 1 * 3 + 0])
    kinds, first, index = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True, return_inverse=True)
    if len(kinds) == len(triangles):
        return surface, ()
    net = np.bincount(index.ravel(), weights=np.where(odd, -1, 1), minlength=len(kinds))
    each = (vertices, triangles[np.sort(first)])
    without_films = (vertices, np.where(net[:, None] > 0, kinds, kinds[:, ::-1])[net != 0])
    best = (
        without_films
        if len(without_films[1])
        and _count_open_edges(without_films) <= _count_open_edges(_orient_consistently(each)[0])
        else each
    )
    if _count_open_edges(best) > _count_open_edges(surface):  # they belong to different shells
        return surface, ()
    gone, change = whole_number(len(triangles) - len(best[1])), volume_change(volume(*surface), volume(*best))
    return best, (note("double-triangles-removed", number=gone, change=change),)


def _count_open_edges(surface: Surface) -> int:
    """Count the edges where the surface is not closed."""
    return int(np.count_nonzero(find_edges(surface[1]).balance))


def _weld_borders(surface: Surface) -> tuple[Surface, Steps]:
    """Merge corners of open borders that nearly coincide."""
    from scipy.spatial import KDTree

    vertices, triangles = surface
    rim = np.unique(open_edges(find_edges(triangles)))
    reach = NEAR * float(np.ptp(vertices, axis=0).max())
    pairs = np.array(sorted(KDTree(vertices[rim]).query_pairs(reach)) if len(rim) else [], dtype=np.int64)
    if not len(pairs):
        return surface, ()
    group = connected_groups(pairs, count=len(rim))
    kept = rim[np.unique(group, return_index=True)[1]][group]
    target = np.arange(len(vertices))
    target[rim] = kept
    new = (vertices, drop_degenerate(target[triangles]))
    done = note(
        "border-corners-joined",
        number=whole_number(int((kept != rim).sum())),
        reach=Quantity(reach, "short length", 2),
        change=volume_change(volume(*surface), volume(*new)),
    )
    return new, (done,)


def _split_edges(surface: Surface) -> tuple[Surface, Steps]:
    """Split triangles where corners of an open border lie on their open edge."""
    vertices, triangles = surface
    total = 0
    for _ in range(3):  # a triangle has three edges, split one after another
        triangles, number = _split_each_once(vertices, triangles)
        total += number
    if not total:
        return surface, ()
    return (vertices, triangles), (note("edges-split", number=whole_number(total)),)


def _split_each_once(vertices: FloatArray, triangles: IntArray) -> tuple[IntArray, int]:
    """Split each triangle along one open edge at most; return the triangles and how many were split."""
    from scipy.spatial import KDTree

    edges = find_edges(triangles)
    rim = np.unique(open_edges(edges))
    if not len(rim):
        return triangles, 0
    tree = KDTree(vertices[rim])
    reach = NEAR * float(np.ptp(vertices, axis=0).max())
    new: dict[int, IntArray] = {}
    for edge in edges.order[edges.first[edges.count == 1]].tolist():
        if edge // 3 in new:
            continue
        a, b = edges.directed[edge]
        way = _vertices_between(vertices, a, b, rim, tree, reach=reach)
        if len(way):
            steps = np.concatenate([[a], way, [b]])
            apex = np.full(len(steps) - 1, triangles[edge // 3].sum() - a - b)
            new[edge // 3] = np.column_stack([steps[:-1], steps[1:], apex])
    return np.concatenate([np.delete(triangles, list(new), axis=0), *new.values()]), len(new)


def _vertices_between(vertices: FloatArray, a: int, b: int, rim: IntArray, tree: KDTree, *, reach: float) -> IntArray:
    """Return those of the vertices `rim` that lie between a and b on their line, in order."""
    along = vertices[b] - vertices[a]
    length = float(np.linalg.norm(along))
    near = rim[tree.query_ball_point((vertices[a] + vertices[b]) / 2.0, length / 2.0 + reach)]
    off = vertices[near] - vertices[a]
    at = off @ along / length
    aside = np.linalg.norm(off - np.outer(at / length, along), axis=1)
    on = (aside < reach) & (at > reach) & (at < length - reach)
    return np.asarray(near[on][np.argsort(at[on])], dtype=np.int64)


def _fill_holes(surface: Surface) -> tuple[Surface, Steps]:
    """Close all holes by planes, if they are nearly plane and a small part of the surface; else none."""
    vertices, triangles = surface
    holes = _find_holes(surface)
    if not holes or _unclosable(surface, holes):
        return surface, ()
    new = (vertices, np.concatenate([triangles, *(hole.triangles for hole in holes)]))
    closed = sum(hole.area for hole in holes)
    done = note(
        "holes-closed",
        number=whole_number(len(holes)),
        edges=whole_number(sum(hole.edges for hole in holes)),
        area=Quantity(closed, "area", 3),
        share=Quantity(100.0 * closed / area(*new), "percent", 3),
        change=volume_change(volume(*surface), volume(*new)),
        **coordinate_values(holes[0].centre),
    )
    return new, (done,)


def _unclosable(surface: Surface, holes: list[Hole]) -> str:
    """Return why the holes cannot be closed by planes; empty where they can."""
    if not all(len(hole.triangles) for hole in holes):
        return "its border crosses itself"
    vertices, triangles = surface
    whole = np.concatenate([triangles, *(hole.triangles for hole in holes)])
    share = sum(hole.area for hole in holes) / area(vertices, whole)
    if share > LARGEST_HOLES:
        return f"{100.0 * share:.3g} % of the surface, too much to close by a guess"
    doubt = sum(hole.area * hole.deviation for hole in holes)
    if doubt > HOLE_UNCERTAINTY * abs(volume(vertices, whole)):
        return f"up to {max(hole.deviation for hole in holes):.2g} m off a plane, too uneven to close by a guess"
    return ""


def _refuse_empty(surface: Surface, *, where: str) -> None:
    """Raise where mending has left no triangle."""
    if not len(surface[1]):
        raise GeometryError(f"{where}: it encloses nothing: mending leaves no triangle of it; close the surface")


def _refuse_open(surface: Surface, *, where: str) -> None:
    """Raise where the surface is still not closed."""
    vertices, triangles = surface
    edges = find_edges(triangles)
    if edges.closed:
        return
    holes = _find_holes(surface)
    if holes:
        number = count_noun(int((edges.count == 1).sum()), "open edge")
        why = _unclosable(surface, holes) or "besides edges of three triangles"
        raise GeometryError(
            f"{where}: it is open: {number} around {count_noun(len(holes), 'hole')}, the largest around "
            f"{point_text(holes[0].centre)} m, {why}; close the surface"
        )
    wrong = edges.balance != 0
    start, end = vertices[edges.directed[edges.order[edges.first[wrong]].min()]]
    what = "shared by three or more triangles" if (edges.count[wrong] > 2).any() else "where triangles cannot run alike"
    raise GeometryError(
        f"{where}: {count_noun(int(wrong.sum()), 'edge')} {what} (the first from {point_text(start)} "
        f"to {point_text(end)} m); separate touching parts into bodies of their own, and remove inner faces"
    )


def _find_holes(surface: Surface) -> list[Hole]:
    """Find the holes of a surface; coplanar nested loops bound one hole, like the foot of a tube."""
    vertices, triangles = surface
    rings = [_ring(vertices, loop) for loop in _closed_loops(open_edges(find_edges(triangles))[:, ::-1])]
    rings.sort(key=lambda ring: -float(np.linalg.norm(ring.normal)))
    groups: list[list[_Ring]] = []
    for ring in rings:
        around = next((group for group in groups if _is_inner(ring, group[0])), None)
        if around is None:
            groups.append([ring])
        else:
            around.append(ring)
    return [_hole(group) for group in groups]


def _closed_loops(edges: IntArray) -> list[IntArray]:
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
