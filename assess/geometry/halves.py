"""A closed surface divided by a plane into the halves above and below it.

Triangles that the plane crosses are clipped, all others stay as they are, and each half is closed by a cap: the area
that the border of the half encloses in the plane, so that faces lying in the plane with nothing behind them leave no
film. No vertex is moved and none is merged, so mass properties of the halves are those of the body to rounding.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass

import numpy as np
import shapely

from assess.geometry.boolean import triangulate
from assess.geometry.surface import Surface, differs_from_previous, drop_degenerate
from spectra.arrays import BoolArray, FloatArray, IntArray

STRAIGHT = 1e-14  # of the loop's size: corners of a section flatter than this are rounding
GRID = 1e-10  # of the section's size: to which corners of outlines that cross themselves are rounded
SAME_AREA = 1e-9  # of the section's area: by which outlines that cross themselves are told


@dataclass(frozen=True)
class Half:
    """What lies on one side of a plane.

    surface : closed; without triangles where nothing lies there
    face : where it meets the plane, in the plane's coordinates from the origin given [m]
    """

    surface: Surface
    face: shapely.Geometry


def halve(surface: Surface, heights: FloatArray, *, origin: FloatArray, axes: FloatArray) -> tuple[Half, Half]:
    """Divide a closed surface by a plane that passes through it.

    Parameters
    ----------
    surface : closed: along each edge as many triangles run one way as the other
    heights : of its vertices above the plane; those at 0 are taken to lie in it [n] [m]
    origin : point of the plane [3] [m]
    axes : of the plane's frame as rows, the last its normal [3, 3]

    Returns
    -------
    the halves above and below
    """
    vertices, triangles = surface
    side = np.sign(heights).astype(np.int8)
    a, b, c = (side[corner] for corner in triangles.T)
    low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
    crossed = (low < 0) & (high > 0)
    pieces, piece_side, ends = _clip(triangles[crossed], np.column_stack([a, b, c])[crossed], count=len(vertices))
    first, second = ends.T
    share = (heights[first] / (heights[first] - heights[second]))[:, None]
    start = vertices[first] - origin
    crossings = start + share * (vertices[second] - origin - start)
    in_plane = np.concatenate([side == 0, np.ones(len(ends), dtype=np.bool_)])
    places = np.zeros((len(in_plane), 2))
    at = np.flatnonzero(side == 0)
    places[at] = (vertices[at] - origin) @ axes[:2].T
    places[len(vertices) :] = crossings @ axes[:2].T
    points = np.concatenate([vertices, crossings + origin])
    points[at] = places[at] @ axes[:2] + origin
    upper = np.concatenate([triangles[(low >= 0) & (high > 0)], pieces[piece_side > 0]])
    lower = np.concatenate([triangles[(low < 0) & (high <= 0)], pieces[piece_side < 0]])
    rim = _rim(upper, in_plane)
    face, cap = _enclosed(rim, places)
    above = Half(_compact(points, np.concatenate([upper, cap[:, ::-1]])), face)
    if ((low == 0) & (high == 0)).any():  # faces in the plane bound one half alone
        face, cap = _enclosed(_rim(lower, in_plane)[:, ::-1], places)
    return above, Half(_compact(points, np.concatenate([lower, cap])), face)


def _clip(crossed: IntArray, sides: IntArray, *, count: int) -> tuple[IntArray, IntArray, IntArray]:
    """Clip triangles [k, 3] with corners on both sides of a plane; count : of vertices before those that are made.

    Each is turned so that it begins at the corner in the plane, or else at the one that is alone on its side.

    Returns
    -------
    pieces [p, 3]; the side of each, 1 or -1 [p]; the ends of each edge on which a vertex is made, in their order [e, 2]
    """
    balance = sides.sum(axis=1)
    begin = np.argmax(sides == -balance[:, None], axis=1)
    order = (begin[:, None] + np.arange(3)) % 3
    p, q, r = np.take_along_axis(crossed, order, axis=1).T
    s, t, u = np.take_along_axis(sides, order, axis=1).T
    at_corner, alone = balance == 0, balance != 0
    edges = np.concatenate([np.stack(pair, axis=1) for pair in ((q, r), (p, q), (p, r))])
    chosen = np.concatenate([at_corner, alone, alone])
    low, high = np.sort(edges[chosen], axis=1).T
    key, index = np.unique(low * count + high, return_inverse=True)
    made = np.zeros(len(chosen), dtype=np.int64)
    made[chosen] = count + index.reshape(-1)
    x, y, z = made.reshape(3, -1)
    pieces = [
        np.stack(each, axis=1)[which]
        for each, which in (
            ((p, q, x), at_corner), ((p, x, r), at_corner), ((p, y, z), alone), ((y, q, r), alone), ((y, r, z), alone),
        )
    ]  # fmt: skip
    of = [t[at_corner], u[at_corner], s[alone], -s[alone], -s[alone]]
    return np.concatenate(pieces), np.concatenate(of), np.stack(np.divmod(key, count), axis=1)


def _rim(triangles: IntArray, in_plane: BoolArray) -> IntArray:
    """Return the directed edges [b, 2] in the plane along which triangles end; those there and back cancel."""
    on = in_plane[triangles]
    following = [1, 2, 0]
    along = on & on[:, following]
    start, end = triangles[along], triangles[:, following][along]
    key = np.minimum(start, end) * len(in_plane) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    first = np.flatnonzero(differs_from_previous(key[order]))
    if not len(first):
        return np.empty((0, 2), dtype=np.int64)
    net = np.add.reduceat(np.where(start < end, 1, -1)[order], first)
    ends = np.stack(np.divmod(key[order[first]], len(in_plane)), axis=1)
    kept = np.repeat(np.where(net[:, None] > 0, ends, ends[:, ::-1]), np.abs(net), axis=0)
    return np.asarray(kept, dtype=np.int64)


def _enclosed(edges: IntArray, places: FloatArray) -> tuple[shapely.Geometry, IntArray]:
    """Return the area within directed edges [b, 2], to the left of them, and its triangles [k, 3], anticlockwise.

    places : of the vertices in the plane [n, 2] [m]
    """
    loops = _loops(edges, places)
    if not loops:
        return shapely.MultiPolygon(), np.empty((0, 3), dtype=np.int64)
    rings = [places[loop] for loop in loops]
    triangles = drop_degenerate(np.concatenate(loops)[triangulate(rings)])  # as between loops that touch
    signed = sum(_signed_area(ring) for ring in rings)
    face: shapely.Geometry = shapely.MultiPolygon()
    with suppress(shapely.GEOSException):  # of lines that cross one another
        face = shapely.build_area(shapely.MultiLineString([_closed_line(ring) for ring in rings]))
    if not shapely.is_valid(face) or abs(shapely.area(face) - signed) > SAME_AREA * abs(
        signed
    ):  # a body that passes through itself
        corners = places[triangles]
        grid = GRID * float(np.ptp(corners, axis=(0, 1)).max())
        parts = np.asarray(shapely.polygons(corners), dtype=np.object_)
        face = shapely.union_all(parts[shapely.area(parts) > grid**2], grid_size=grid)
    return face, triangles


def _loops(edges: IntArray, places: FloatArray) -> list[IntArray]:
    """Return the closed loops of directed edges [b, 2], each without repeats and from its leftmost, lowest corner."""
    following: dict[int, list[int]] = {}
    for start, end in edges.tolist():
        following.setdefault(start, []).append(end)
    loops: list[IntArray] = []
    while following:
        path: list[int] = [next(iter(following))]
        place = {path[0]: 0}
        while path:
            ways = following[path[-1]]
            to = ways.pop()
            if not ways:
                del following[path[-1]]
            if to not in place:
                place[to] = len(path)
                path.append(to)
                continue
            loop = np.array(path[place[to] :])
            for each in path[place[to] + 1 :]:
                del place[each]
            del path[place[to] + 1 :]
            if len(path) == 1 and to not in following:
                path.clear()
            at = places[loop]
            loops.append(np.roll(loop, -int(np.lexsort((at[:, 1], at[:, 0]))[0])))
    return loops


def _closed_line(ring: FloatArray) -> shapely.LineString:
    """Return a ring [k, 2] as a closed line, without corners that are straight to rounding."""
    line = shapely.LineString(np.concatenate([ring, ring[:1]]))
    thinned = line.simplify(STRAIGHT * float(np.ptp(ring, axis=0).max()), preserve_topology=False)
    return thinned if isinstance(thinned, shapely.LineString) and len(thinned.coords) > 3 else line


def _signed_area(ring: FloatArray) -> float:
    """Return the area of a ring [k, 2], positive where it runs anticlockwise [m2]."""
    x, y = (ring - ring[0]).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2.0


def _compact(points: FloatArray, triangles: IntArray) -> Surface:
    """Return a surface without the vertices that it does not use."""
    used = np.zeros(len(points), dtype=np.bool_)
    used[triangles] = True
    return points[used], (np.cumsum(used) - 1)[triangles]
