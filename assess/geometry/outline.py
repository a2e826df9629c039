"""The outline of a body seen from the side: the border of its projection on a plane."""

from __future__ import annotations

import numpy as np
import shapely

from assess.geometry.surface import marks_changes
from spectra.arrays import BoolArray, FloatArray, IntArray

Point = tuple[float, float]
Outline = tuple[tuple[Point, ...], ...]

FLAT = 1e-12  # of the body's size squared: triangles smaller than this in projection are seen edge-on
STRAIGHT = 1e-9  # of the body's size: corners flatter than this are no corners
FEW_EDGES = 1500  # edges of the contour that are made to cross one another however they lie
MANY_EDGES = 20_000  # edges that are so where they seldom meet:
MEETINGS = 4  # of one edge with others; its neighbours are two
BATCH = 1000  # triangles united at least, before others are looked up in their union
SQUARES = 64  # of the coarse grid, along the body
PER_CELL = 4  # triangles in a cell of the grid that finds the rim


def outline(points: FloatArray, triangles: IntArray) -> Outline:
    """Return the outer borders of the projection of closed surfaces: of the union of all triangles facing the viewer.

    Parameters
    ----------
    points : vertices projected on the plane [n, 2] [m]
    triangles : of closed surfaces, anticlockwise where they face the viewer [m, 3]

    Returns
    -------
    closed rings of (x, z) [m], anticlockwise from the leftmost point, the first point repeated at the end, rings from
    left to right; holes are omitted; straight lines have no intermediate points
    """
    points = np.asfortranarray(points)  # x of all, then z: extremes of short rows are slow
    middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
    size = float(np.ptp(points, axis=0).max())
    placed = points - middle
    facing = _facing(placed, triangles, smallest=FLAT * size**2)
    edges = placed[_contour(facing, len(points))]
    whole = _enclose(edges) if _seldom_cross(edges) else _unite_triangles(placed[facing], size=size)
    rings = [_exterior_ring(part, straight=STRAIGHT * size) + middle for part in shapely.get_parts(whole)]
    return tuple(sorted(tuple((float(x), float(z)) for x, z in ring) for ring in rings))


def distance(rings: Outline, point: Point) -> float:
    """Return the distance of a point from the inside of closed rings, 0 on or inside one [m].

    Parameters
    ----------
    rings : closed rings of (x, z) [m]
    point : (x, z) [m]
    """
    whole = shapely.union_all([shapely.Polygon(ring) for ring in rings])
    return float(shapely.distance(whole, shapely.Point(point)))


def _facing(points: FloatArray, triangles: IntArray, *, smallest: float) -> IntArray:
    """Return the triangles [k, 3] that run anticlockwise and have more than the smallest area [m2]."""
    a, b, c = triangles.T
    x, z = points.T
    (ax, az), (bx, bz) = ((x[other] - x[a], z[other] - z[a]) for other in (b, c))
    return np.asarray(triangles[ax * bz - az * bx > 2.0 * smallest], dtype=np.int64)


def _contour(facing: IntArray, count: int) -> IntArray:
    """Return the edges [k, 2] with no facing triangle on one side; count : of vertices.

    All other edges are inside: with facing triangles on both sides, the border of their union does not run along them.
    """
    start, end = facing.ravel(), facing[:, [1, 2, 0]].ravel()
    key = np.minimum(start, end)
    key *= count
    key += np.maximum(start, end)
    key *= 2
    key += start < end
    key.sort()
    key = key[marks_changes(key)]
    both = np.flatnonzero(key[1:] - key[:-1] == 1)
    both = both[key[both] % 2 == 0]  # one edge, either way
    alone = np.ones(len(key), dtype=np.bool_)
    alone[both] = alone[both + 1] = False
    return np.column_stack(np.divmod(key[alone] // 2, count))


def _seldom_cross(edges: FloatArray) -> bool:
    """Return whether the edges [k, 2, 2] are few, or not many with boxes that seldom overlap."""
    if not FEW_EDGES < len(edges) <= MANY_EDGES:
        return len(edges) <= FEW_EDGES
    lines = np.asarray(shapely.linestrings(edges), dtype=np.object_)
    return len(shapely.STRtree(lines).query(lines)[0]) <= (MEETINGS + 1) * len(edges)


def _enclose(edges: FloatArray) -> shapely.Geometry:
    """Return the area enclosed by edges [k, 2, 2], holes filled; fast unless thousands of edges cross."""
    crossing = shapely.union_all(shapely.linestrings(edges))
    faces = shapely.get_parts(shapely.polygonize([crossing]))
    return _fill_holes(shapely.coverage_union_all(faces))


def _unite_triangles(corners: FloatArray, *, size: float) -> shapely.Geometry:
    """Unite triangles [k, 3, 2], holes filled.

    A scan has hundreds of thousands of triangles, nearly all of them far from the border, and its rough skin seen
    edge-on has edges that cross everywhere. So the rim is united first, its holes are filled, and only triangles that
    still protrude are added. The result is exact however the rim was chosen, because every triangle is either in a
    union or was found covered by one.
    """
    rim = _rim(corners.mean(axis=1), size=size)
    body = _extend(shapely.MultiPolygon(), corners[rim])
    others = corners[~rim]
    return _extend(body, others[~_covered_by_grid(body, others, size=size)])


def _rim(centres: FloatArray, *, size: float) -> BoolArray:
    """Return which triangles, by their centres [k, 2], lie in a cell of a square grid beside an empty cell [k]."""
    cells = max(1, int(np.sqrt(len(centres) / PER_CELL)))
    column, row = (centres * (cells / size) + cells / 2.0).astype(np.int64).T + 2
    occupied = np.zeros((cells + 5, cells + 5), dtype=np.bool_)
    occupied[column, row] = True
    return np.asarray(_dilate(~occupied)[column, row], dtype=np.bool_)


def _dilate(cells: BoolArray) -> BoolArray:
    """Return the cells and their eight neighbours."""
    wide = cells | np.roll(cells, 1, axis=0) | np.roll(cells, -1, axis=0)
    return np.asarray(wide | np.roll(wide, 1, axis=1) | np.roll(wide, -1, axis=1), dtype=np.bool_)


def _covered_by_grid(body: shapely.Geometry, corners: FloatArray, *, size: float) -> BoolArray:
    """Return which triangles [k, 3, 2] lie in squares of a coarse grid that the body covers, a fast test [k]."""
    edges = np.linspace(-0.5, 0.5, SQUARES + 1) * size
    low, high = np.meshgrid(edges[:-1], edges[:-1], indexing="ij"), np.meshgrid(edges[1:], edges[1:], indexing="ij")
    shapely.prepare(body)
    covered = shapely.covers(body, shapely.box(low[0], low[1], high[0], high[1]))
    a, b, c = (corners[:, i] for i in range(3))
    first, last = (
        ((find(find(a, b), c) / size + 0.5) * SQUARES).astype(np.int64).clip(0, SQUARES - 1)
        for find in (np.minimum, np.maximum)
    )
    (i, j), (k, m) = first.T, last.T
    all_four = covered[i, j] & covered[i, m] & covered[k, j] & covered[k, m]
    return np.asarray(all_four & (k - i <= 1) & (m - j <= 1), dtype=np.bool_)


def _extend(body: shapely.Geometry, corners: FloatArray) -> shapely.Geometry:
    """Unite a body with triangles [k, 3, 2], holes filled.

    The larger triangles come first, because they cover many of the smaller.
    """
    polygons = np.asarray(shapely.polygons(corners), dtype=np.object_)
    left = polygons[np.argsort(-shapely.area(polygons), kind="stable")]
    while True:
        shapely.prepare(body)
        left = left[~shapely.covers(body, left)]
        if not len(left):
            return body
        many = max(BATCH, len(left) // 3)
        body, left = _fill_holes(shapely.union_all([body, *left[:many]])), left[many:]


def _fill_holes(polygons: shapely.Geometry) -> shapely.Geometry:
    """Return one or several polygons as one geometry, their holes filled."""
    return shapely.union_all(shapely.polygons(shapely.get_exterior_ring(shapely.get_parts(polygons))))


def _exterior_ring(polygon: shapely.Geometry, *, straight: float) -> FloatArray:
    """Return the outer ring [k, 2], anticlockwise from its leftmost (then lowest) point, without straight points."""
    ring = shapely.get_coordinates(shapely.get_exterior_ring(shapely.orient_polygons(polygon)))[:-1]
    start = np.lexsort((ring[:, 1], ring[:, 0]))[0]  # an extreme point: a true corner, which may stay
    turned = np.roll(ring, -start, axis=0)
    closed = shapely.linestrings(np.concatenate([turned, turned[:1]]))
    return np.asarray(shapely.get_coordinates(shapely.simplify(closed, straight)), dtype=np.float64)
