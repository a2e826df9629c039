"""A body in the vertical plane of its motion, as a mechanism uses it: mass, base and outline.

The plane's coordinates are x, the distance along the direction of motion from the origin, and z, the elevation. The
outline is the border of the body's projection on the plane.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import NDArray

from assess.errors import GeometryError
from assess.geometry.solid import Solid, keep_of_bodies
from assess.geometry.surface import differs_from_previous
from spectra.arrays import BoolArray, FloatArray, IntArray

Point = tuple[float, float]
Base = tuple[Point, Point]
Outline = tuple[tuple[Point, ...], ...]
BASE_TOLERANCE = 1e-6  # of the body's size: vertices this near the lowest belong to the base


@dataclass(frozen=True)
class PlanarBody:
    """Mass, centroid, inertia and shape of a body in the plane of motion.

    name : of the body or block
    mass : [kg]
    centroid : x, z [m]
    inertia : J about the horizontal axis across the direction, through the centroid [kg m2]
    outline : closed rings of (x, z) [m]; empty where the body has no geometry
    base : (x, z) of the two extreme lines of the face it stands on, in the order of x [m]: of the lowest face, at one
        elevation, or of a cut, each at its own; equal where the body stands on a point or an edge; None where the body
        has no geometry
    """

    name: str
    mass: float
    centroid: Point
    inertia: float
    outline: Outline
    base: Base | None


def planar_body(solid: Solid, *, direction: Sequence[float]) -> PlanarBody:
    """Project a solid on the vertical plane of a direction.

    Parameters
    ----------
    solid : the body
    direction : horizontal vector of any length [3]

    Raises
    ------
    GeometryError : the direction is zero, not horizontal or not finite
    """
    rings = _outline_of((solid,), tuple(_horizontal(direction).tolist()))
    return replace(planar_body_without_outline(solid, direction=direction), outline=rings)


@keep_of_bodies
def _outline_of(solids: tuple[Solid, ...], along: tuple[float, ...]) -> Outline:
    (solid,) = solids
    points = np.column_stack([solid.vertices @ np.array(along), solid.vertices[:, 2]])
    # x to z turns away from a viewer who looks across `along`
    return projected_outline(points, solid.triangles[:, ::-1])


def planar_body_without_outline(solid: Solid, *, direction: Sequence[float]) -> PlanarBody:
    """Project a solid on the vertical plane of a direction, without its outline, which takes most of the time.

    Parameters
    ----------
    solid : the body
    direction : horizontal vector of any length [3]

    Raises
    ------
    GeometryError : the direction is zero, not horizontal or not finite
    """
    along = _horizontal(direction)
    across = np.array([-along[1], along[0], 0.0])
    points = np.column_stack([solid.vertices @ along, solid.vertices[:, 2]])
    return PlanarBody(
        name=solid.name,
        mass=solid.mass,
        centroid=(float(solid.centroid @ along), float(solid.centroid[2])),
        inertia=float(across @ solid.inertia @ across),
        outline=(),
        base=_base(points, size=float(np.ptp(solid.vertices, axis=0).max())),
    )


def planar_body_from_values(*, mass: float, centroid: Point, inertia: float, name: str) -> PlanarBody:
    """Return a planar body given by its values alone, without geometry.

    Parameters
    ----------
    mass : [kg]
    centroid : x, z [m]
    inertia : about the centroid [kg m2]
    name : of the body, for errors

    Raises
    ------
    GeometryError : mass is not positive, inertia negative, or a number not finite
    """
    if not (np.isfinite(mass) and mass > 0.0):
        raise GeometryError(f'body "{name}": mass is {mass:g} kg; give a positive finite number')
    if not (np.isfinite(inertia) and inertia >= 0.0):
        raise GeometryError(f'body "{name}": inertia is {inertia:g} kg m2; give a finite number, zero or more')
    if len(centroid) != 2 or not np.isfinite(centroid).all():
        raise GeometryError(f'body "{name}": centroid is {centroid!r}; give two finite numbers x, z')
    return PlanarBody(name, float(mass), (float(centroid[0]), float(centroid[1])), float(inertia), (), None)


def join_bodies(bodies: Sequence[PlanarBody]) -> PlanarBody:
    """Join bodies in the plane of motion; one body is returned unchanged."""
    return bodies[0] if len(bodies) == 1 else join_planar(bodies, name=" + ".join(body.name for body in bodies))


def join_planar(bodies: Sequence[PlanarBody], *, name: str) -> PlanarBody:
    """Join planar bodies that move as one block, by the parallel-axis theorem in the plane.

    The base is that of the lowest body; bodies that stand equally low share one.

    Parameters
    ----------
    bodies : with or without geometry, at least one
    name : of the block

    Raises
    ------
    GeometryError : no bodies are given
    """
    if not bodies:
        raise GeometryError(f'block "{name}": it joins no bodies; name at least one')
    m = np.array([body.mass for body in bodies])
    at = np.array([body.centroid for body in bodies])
    centre = at[0] + m @ (at - at[0]) / m.sum()
    J = float(sum(body.inertia for body in bodies) + m @ np.sum((at - centre) ** 2, axis=1))
    rings = tuple(sorted(ring for body in bodies for ring in body.outline))
    corners = [point for ring in rings for point in ring]
    size = float(np.ptp(corners, axis=0).max()) if corners else 0.0
    bases = [body.base for body in bodies if body.base is not None]
    return PlanarBody(name, float(m.sum()), (float(centre[0]), float(centre[1])), J, rings, _lowest(bases, size))


def top_edge(body: PlanarBody) -> Base | None:
    """Return (x, z) of the two extreme highest points of the outline, in the order of x; None without geometry."""
    points = [(x, -z) for ring in body.outline for x, z in ring]
    if not points:
        return None
    low, high = _base(np.array(points), size=float(np.ptp(points, axis=0).max()))
    return (low[0], -low[1]), (high[0], -high[1])


def lowest_corners(solids: Sequence[Solid], *, within: float = 0.0) -> FloatArray:
    """Return the vertices of the lowest face of several solids together.

    Parameters
    ----------
    solids : at least one
    within : height above the lowest point up to which vertices count [m]

    Returns
    -------
    vertices [k, 3] [m]
    """
    points = np.concatenate([solid.vertices for solid in solids])
    reach = max(within, BASE_TOLERANCE * float(np.ptp(points, axis=0).max()))
    return np.asarray(points[points[:, 2] <= points[:, 2].min() + reach], dtype=np.float64)


def base_of_section(foot: FloatArray, *, direction: Sequence[float]) -> Base:
    """Return the extreme lines of a plane section; a line that rises along itself counts at its middle.

    Parameters
    ----------
    foot : corners of the section [k, 3] [m]
    direction : of motion, a horizontal vector [3]
    """
    along = _horizontal(direction)
    x, z = foot @ along, foot[:, 2]
    ends = (z[each] for each in _extremes(x))
    low, high = (float((end.min() + end.max()) / 2.0) for end in ends)
    return (float(x.min()), low), (float(x.max()), high)


def turns_about_a_corner(foot: FloatArray, *, direction: Sequence[float]) -> bool:
    """Return whether a face ends in a direction in a point rather than an edge (a tenth of its width).

    Parameters
    ----------
    foot : corners of the face [k, 3] [m]
    direction : of motion, a horizontal vector [3]
    """
    along = _horizontal(direction)
    across = np.array([-along[1], along[0], 0.0])
    x, y = foot @ along, foot @ across
    edge = y[x >= x.max() - 1e-3 * float(np.ptp(x))]
    return bool(np.ptp(edge) < 0.1 * np.ptp(y))


def slope_across(foot: FloatArray, *, direction: Sequence[float]) -> float:
    """Return the rise of the extreme lines of a section along themselves, the larger of the two [m].

    Parameters
    ----------
    foot : corners of the section [k, 3] [m]
    direction : of motion, a horizontal vector [3]
    """
    x, z = foot @ _horizontal(direction), foot[:, 2]
    return float(max(np.ptp(z[end]) for end in _extremes(x)))


FLAT = 1e-12  # of the body's size squared: triangles smaller than this in projection are seen edge-on
STRAIGHT = 1e-9  # of the body's size: corners flatter than this are no corners
FEW_EDGES = 1500  # edges of the contour that are made to cross one another however they lie
MANY_EDGES = 20_000  # edges that are so where they seldom meet:
MEETINGS = 4  # of one edge with others; its neighbours are two
BATCH = 1000  # triangles united at least, before others are looked up in their union
SQUARES = 64  # of the coarse grid, along the body
PER_CELL = 4  # triangles in a cell of the grid that finds the rim


def projected_outline(points: FloatArray, triangles: IntArray) -> Outline:
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


def distance_to_outline(rings: Outline, point: Point) -> float:
    """Return the distance of a point from the inside of closed rings, 0 on or inside one [m].

    Parameters
    ----------
    rings : closed rings of (x, z) [m]
    point : (x, z) [m]
    """
    whole = shapely.union_all([shapely.Polygon(ring) for ring in rings])
    return float(shapely.distance(whole, shapely.Point(point)))


MAX_EDGES = 180  # edges: the shortest of a finer hull change its support by less than one part in a thousand
SHORTEST_EDGE = 1e-9  # of the hull's size: edges shorter than this are rounding


def hull_edge_normals(points: FloatArray) -> FloatArray:
    """Return the outward directions of the edges of a convex hull in plan.

    Parameters
    ----------
    points : x, y and possibly more of each point [n, 2 or more] [m]

    Returns
    -------
    angles from +x towards +y, 0 to 360, ascending, of the longest MAX_EDGES edges at most [k] [deg]; empty where the
    points lie on a line
    """
    plan = np.asarray(points)[:, :2]
    ring = shapely.linestrings(np.concatenate([plan, plan[:1]]))  # a tenth of the time that its points take
    hull = shapely.convex_hull(ring)
    if not isinstance(hull, shapely.Polygon):
        return np.empty(0)
    corners = shapely.get_coordinates(shapely.orient_polygons(hull))
    edges = np.diff(corners, axis=0)
    length = np.hypot(*edges.T)
    longest = np.argsort(-length, kind="stable")[:MAX_EDGES]
    kept = edges[longest[length[longest] > SHORTEST_EDGE * length.sum()]]
    outward = np.degrees(np.arctan2(-kept[:, 0], kept[:, 1]))  # anticlockwise: the outside lies to the right
    return np.unique(np.round(outward, 12) % 360.0)  # rounded, for -1e-15 % 360 is 360


def _extremes(x: FloatArray) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which of the positions x [k] lie on the lower and which on the upper extreme line."""
    reach = BASE_TOLERANCE * float(np.ptp(x))
    return x <= x.min() + reach, x >= x.max() - reach


def _horizontal(direction: Sequence[float]) -> FloatArray:
    """Return the unit vector [3] of a horizontal direction, or raise."""
    vector = np.asarray(direction, dtype=np.float64)
    remedy = "give a horizontal vector such as [1, 0, 0]"
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise GeometryError(f"direction is {list(direction)}, not three finite numbers; {remedy}")
    vector = vector / (np.abs(vector).max() or 1.0)  # first, so that neither tiny nor huge numbers lose the norm
    length = float(np.linalg.norm(vector))
    if length == 0.0 or abs(vector[2]) > 1e-9 * length:
        raise GeometryError(f"direction is {list(direction)}, which is not horizontal; {remedy}")
    vector[2] = 0.0
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float64)


def _base(points: FloatArray, *, size: float) -> Base:
    """Return the two extreme points of the lowest ones among [n, 2] [m]."""
    lowest = float(points[:, 1].min())
    foot = points[points[:, 1] <= lowest + BASE_TOLERANCE * size, 0]
    return (float(foot.min()), lowest), (float(foot.max()), lowest)


def _lowest(bases: Sequence[Base], size: float) -> Base | None:
    """Return the base of the lowest bodies, None where no body has one."""
    if not bases:
        return None
    return _base(np.array(bases).reshape(-1, 2), size=size)


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
    key = key[differs_from_previous(key)]
    both = np.flatnonzero(key[1:] - key[:-1] == 1)
    both = both[key[both] % 2 == 0]  # one edge, either way
    border = np.ones(len(key), dtype=np.bool_)
    border[both] = border[both + 1] = False
    return np.column_stack(np.divmod(key[border] // 2, count))


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
