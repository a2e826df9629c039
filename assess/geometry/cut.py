"""Bodies cut by a plane: the parts above and below it, the section between them, and what a mechanism takes of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import ArrayLike

from assess.errors import GeometryError
from assess.geometry.halves import Half, halve
from assess.geometry.planar import BASE_TOLERANCE, PlanarBody
from assess.geometry.solid import DRAWN_TRIANGLES, THINNEST, Solid, drawn_surface, keep_of_bodies, polyhedron
from assess.geometry.surface import Surface, find_edges
from spectra.arrays import FloatArray

FLATTEST = 1e-6  # vertical part of a unit normal: below this a plane is upright and has no side above
ON_PLANE = 1e-9  # of the bodies' size: faces this near the plane lie in it
DEGENERATE = 1e-15  # of the bodies' size squared: triangles smaller than this are lines
_NOTHING = Half((np.empty((0, 3)), np.empty((0, 3), dtype=np.int64)), shapely.MultiPolygon())


@dataclass(frozen=True)
class Plane:
    """A cutting plane: the mechanism is what lies on the side to which the normal points.

    point : a point of the plane [3] [m]
    normal : unit vector [3]
    """

    point: FloatArray
    normal: FloatArray

    def __str__(self) -> str:
        if self.normal[2] == 1.0:
            return f"the cut at z = {self.point[2]:.6g} m"
        at, to = (", ".join(f"{value + 0.0:.6g}" for value in v) for v in (self.point, self.normal))
        return f"the cut through ({at}) m with normal ({to})"


@dataclass(frozen=True)
class Division:
    """The parts of bodies above and below a cut.

    above, below : the bodies on each side, each as cut
    foot : corners of the section between them [k, 3] [m]
    section : outer borders of the section, closed rings [k, 3] [m]
    region : the section with its holes, in coordinates of the plane from its point [m], see `heading`
    """

    above: tuple[Solid, ...]
    below: tuple[Solid, ...]
    foot: FloatArray
    section: tuple[FloatArray, ...]
    region: shapely.MultiPolygon


@dataclass(frozen=True)
class Piece:
    """One block of a mechanism, as cut.

    body : in the plane of motion; solids : what it is made of, none for direct values; foot : corners of the face it
    stands on [k, 3] [m], None without geometry; cut : whether that face is a cut; section : its rings [k, 3] [m];
    fixed : what lies beyond the cut and stays
    """

    body: PlanarBody
    solids: tuple[Solid, ...]
    foot: FloatArray | None
    cut: bool = False
    section: tuple[FloatArray, ...] = ()
    fixed: tuple[Solid, ...] = ()


@dataclass(frozen=True)
class Scene:
    """The bodies of a mechanism in space.

    members : the solids of each of the mechanism's outlines, in their order
    fixed : solids that do not move, such as those under a cut
    sections : where cuts pass through the masonry: closed rings [k, 3] [m]
    direction : of motion, a horizontal unit vector [3]
    """

    members: tuple[tuple[Solid, ...], ...]
    fixed: tuple[Solid, ...]
    sections: tuple[FloatArray, ...]
    direction: FloatArray


def level_plane(elevation: float) -> Plane:
    """Return the horizontal plane at an elevation [m]."""
    return Plane(np.array([0.0, 0.0, float(elevation)]), np.array([0.0, 0.0, 1.0]))


def inclined_plane(point: ArrayLike, normal: ArrayLike, *, where: str) -> Plane:
    """Return the plane through a point and square to a normal.

    Parameters
    ----------
    point : [3] [m]
    normal : of any length, pointing to the mechanism [3]
    where : named in errors

    Raises
    ------
    GeometryError : the normal has no length or does not point upwards, or a number is not finite
    """
    at, to = (np.array(each, dtype=np.float64) for each in (point, normal))
    if at.shape != (3,) or to.shape != (3,) or not (np.isfinite(at).all() and np.isfinite(to).all()):
        raise GeometryError(f"{where}: the cut needs three finite numbers for point and for normal")
    unit = to / (np.abs(to).max() or 1.0)  # first, so that neither tiny nor huge numbers lose the norm
    length = float(np.linalg.norm(unit))
    if unit[2] <= FLATTEST * length:
        given = ", ".join(f"{value:g}" for value in to)
        raise GeometryError(
            f"{where}: the normal of the cut is ({given}); give one that points up, into what moves, like [0.3, 0, 1]"
        )
    return Plane(at, unit / length)


def divide(solids: Sequence[Solid], plane: Plane, *, where: str) -> Division:
    """Divide the bodies of one block at a plane.

    The foot is where masonry above the plane rests on masonry below it, so an overhang whose underside lies in the
    plane does not widen it; where nothing lies below, the foot is what the plane touches.

    Parameters
    ----------
    solids : bodies that move as one, at least one
    plane : the cut
    where : named in errors

    Raises
    ------
    GeometryError : the plane misses the bodies, leaves nothing of them or passes through no masonry, or a body
        cannot be cut because its surface is not that of a solid
    """
    return _divide(tuple(solids), tuple(plane.point.tolist()), tuple(plane.normal.tolist()), where)


@keep_of_bodies
def _divide(solids: tuple[Solid, ...], point: tuple[float, ...], normal: tuple[float, ...], where: str) -> Division:
    plane = Plane(np.array(point), np.array(normal))
    corners = np.concatenate([solid.vertices for solid in solids])
    low, high = corners.min(axis=0), corners.max(axis=0)
    size = float((high - low).max())
    middle = (low + high) / 2.0 - plane.point
    origin = plane.point + (middle - (middle @ plane.normal) * plane.normal)  # in the plane, near the bodies
    axes = _axes(plane.normal)
    heights = [_heights(solid, origin, axes, size=size) for solid in solids]
    _refuse_miss(heights, plane, (float(low[2]), float(high[2])), where=where)
    over: list[Solid] = []
    under: list[Solid] = []
    feet, heads = [], []
    for solid, height in zip(solids, heights, strict=True):
        upper, lower = _split(solid, height, origin=origin, axes=axes, size=size, where=f'{where}: body "{solid.name}"')
        feet.append(upper.face)
        heads.append(lower.face)
        parts = _parts(solid, upper, lower, origin=origin, axes=axes)
        for side, part in zip((over, under), parts, strict=True):
            side += [] if part is None else [part]
    touching = all(height.min() >= 0.0 for height in heights)
    contact = shapely.union_all(feet) if touching else shapely.union_all(feet).intersection(shapely.union_all(heads))
    areas = [part for part in shapely.get_parts(contact) if part.area > THINNEST * size**2]
    if not areas:
        lowest = min((float(solid.vertices[:, 2].min()) for solid in over), default=float(high[2]))
        raise GeometryError(f"{where}: {plane} passes through no masonry; what lies above begins at z = {lowest:.6g} m")
    corners = np.unique(shapely.get_coordinates(areas), axis=0)
    rings = [shapely.get_coordinates(shapely.get_exterior_ring(part)) for part in areas]
    foot, *section = (np.column_stack([each, np.zeros(len(each))]) @ axes + origin for each in (corners, *rings))
    shift = (axes @ (origin - plane.point))[:2]
    region = shapely.transform(shapely.MultiPolygon(areas), lambda points: points + shift)
    for shared in (foot, *section):
        shared.flags.writeable = False
    return Division(tuple(over), tuple(under), foot, tuple(section), region)


def split_upright(solid: Solid, *, point: ArrayLike, normal: ArrayLike) -> tuple[Solid, ...]:
    """Split a body at an upright plane into the parts behind and in front of it.

    Parameters
    ----------
    point : of the plane [3] [m]
    normal : horizontal unit vector [3]

    Raises
    ------
    GeometryError : the surface is not that of a solid
    """
    axes = _axes(np.asarray(normal, dtype=np.float64))
    origin = np.asarray(point, dtype=np.float64)
    height = (solid.vertices - origin) @ axes[2]
    halves = _split(solid, height, origin=origin, axes=axes, size=0.0, where=f'body "{solid.name}"')
    before, behind = _parts(solid, *halves, origin=origin, axes=axes)
    return tuple(part for part in (behind, before) if part is not None)


def project_on_plane(plane: Plane, vector: ArrayLike) -> FloatArray:
    """Return the components of a vector in the coordinates of a cut's region.

    Parameters
    ----------
    plane : the cut
    vector : [3]

    Returns
    -------
    components in the plane [2]
    """
    return np.asarray((_axes(plane.normal) @ np.asarray(vector, dtype=np.float64))[:2], dtype=np.float64)


def heading(plane: Plane, vector: ArrayLike, *, axis: ArrayLike | None = None) -> FloatArray:
    """Return the direction square to the axis of rotation, in the coordinates of a cut's region.

    Where the cut is not level across the direction of motion, it is square to the projection of that axis.

    Parameters
    ----------
    plane : the cut
    vector : direction of motion, to whose side the result points [3]
    axis : of rotation [3]; default the horizontal axis square to the vector

    Returns
    -------
    unit vector [2]
    """
    motion = np.asarray(vector, dtype=np.float64)
    along, up = project_on_plane(plane, np.cross([0.0, 0.0, 1.0], motion) if axis is None else axis)
    unit = np.array([up, -along]) / np.hypot(along, up)
    return np.asarray(np.copysign(1.0, unit @ project_on_plane(plane, motion)) * unit, dtype=np.float64)


def section_moments(solid: Solid, elevation: ArrayLike, *, direction: Sequence[float]) -> FloatArray:
    """Return area and second moment of level sections at many elevations, for bending in a horizontal direction.

    A plane cuts each triangle it crosses in a segment. Segments that run anticlockwise around the masonry, seen from
    above, give area, first and second moment by Green's theorem without being joined to rings, holes included:

        A = sum D / 2, int s dA = sum D (s + s') / 6, int s^2 dA = sum D (s^2 + s s' + s'^2) / 12, D = s t' - s' t

    Parameters
    ----------
    solid : the body
    elevation : [n] [m]
    direction : horizontal vector along which s is measured from the origin [3]

    Returns
    -------
    area A [m2], int s dA [m3] and int s^2 dA [m4] of each section [n, 3]; 0 where the solid does not reach
    """
    return np.array([_moments(*each) for each in _segments(solid, elevation, direction)])


def section_edges(solid: Solid, elevation: ArrayLike, *, direction: Sequence[float]) -> FloatArray:
    """Return the first and the last place of level sections along a horizontal direction, at many elevations.

    Parameters
    ----------
    solid : the body
    elevation : [n] [m]
    direction : horizontal vector along which places are measured from the origin [3]

    Returns
    -------
    least and largest s of each section [n, 2] [m]; infinite and minus infinite where the solid does not reach
    """
    found = [np.concatenate(each)[:, 0] for each in _segments(solid, elevation, direction)]
    return np.array([(each.min(initial=np.inf), each.max(initial=-np.inf)) for each in found])


def _axes(normal: FloatArray) -> FloatArray:
    """Return the axes of the plane's own frame as rows, its normal last [3, 3]; global axes if level."""
    n1, n2, n3 = normal
    sense = np.copysign(1.0, n3)  # the shortest turn from z to the normal, or from -z to one that points down
    turn = 1.0 / (1.0 + abs(n3))
    first = np.array([1.0 - n1 * n1 * turn, -n1 * n2 * turn, -sense * n1])
    return np.array([first, np.cross(normal, first), normal])


def _heights(solid: Solid, origin: FloatArray, axes: FloatArray, *, size: float) -> FloatArray:
    """Return the heights of a body's vertices above a plane, 0 where only rounding keeps them off it [n] [m].

    Files in single precision hold a level of 4.77 m as 4.7699999809 m; the sliver between would be cut as a section.
    """
    height = (solid.vertices - origin) @ axes[2]
    return np.where(np.abs(height) <= BASE_TOLERANCE * size, 0.0, height)


def _refuse_miss(heights: Sequence[FloatArray], plane: Plane, reach: tuple[float, float], *, where: str) -> None:
    """Raise where no body reaches above the plane, or none down to it; reach: their lowest and highest z [m]."""
    lowest, highest = min(float(z.min()) for z in heights), max(float(z.max()) for z in heights)
    if highest <= 0.0:
        outcome = "misses the body" if highest < 0.0 else "leaves nothing of the body"
        raise GeometryError(f"{where}: {plane} {outcome}, which ends at z = {reach[1]:.6g} m")
    if lowest > 0.0:
        raise GeometryError(f"{where}: {plane} misses the body, which begins at z = {reach[0]:.6g} m")


def _split(
    solid: Solid, height: FloatArray, *, origin: FloatArray, axes: FloatArray, size: float, where: str
) -> tuple[Half, Half]:
    """Split a body, whose vertices have these heights above a plane [n], into halves above and below."""
    whole = solid.vertices, solid.triangles
    if height.min() >= 0.0:
        return Half(whole, _area_in_plane(solid, height, origin=origin, axes=axes, size=size)), _NOTHING
    if height.max() <= 0.0:
        return _NOTHING, Half(whole, _area_in_plane(solid, height, origin=origin, axes=axes, size=size))
    if not _is_closed((solid,)):
        raise GeometryError(f"{where} cannot be cut; is its surface closed?")
    return halve(whole, height, origin=origin, axes=axes)


@keep_of_bodies
def _is_closed(solids: tuple[Solid, ...]) -> bool:
    (solid,) = solids
    return find_edges(solid.triangles).closed


def _parts(
    whole: Solid, upper: Half, lower: Half, *, origin: FloatArray, axes: FloatArray
) -> tuple[Solid | None, Solid | None]:
    """Return the halves of a body, with the body's density; itself where there is but one."""
    if not (len(upper.surface[1]) and len(lower.surface[1])):
        return (whole, None) if len(upper.surface[1]) else (None, whole)
    density = whole.mass / _volume_of((whole,))
    solids = (polyhedron(*half.surface, density=density, name=whole.name) for half in (upper, lower))
    above, below = (
        replace(solid, drawn=drawn)
        for solid, drawn in zip(solids, _drawn_halves(whole, origin=origin, axes=axes), strict=True)
    )
    return above, below


def _drawn_halves(whole: Solid, *, origin: FloatArray, axes: FloatArray) -> tuple[Surface, Surface] | tuple[None, None]:
    """Divide the simpler surface that a fine body is drawn with; none where it is open or beside the plane."""
    vertices, triangles = drawn_surface(whole)
    height = (vertices - origin) @ axes[2]
    crossed = height.min() < 0.0 < height.max()
    if len(whole.triangles) <= DRAWN_TRIANGLES or not crossed or not find_edges(triangles).closed:
        return None, None
    upper, lower = halve((vertices, triangles), height, origin=origin, axes=axes)
    return upper.surface, lower.surface


@keep_of_bodies
def _volume_of(solids: tuple[Solid, ...]) -> float:
    (solid,) = solids
    return polyhedron(solid.vertices, solid.triangles, density=1.0, name=solid.name).mass


def _area_in_plane(
    solid: Solid, height: FloatArray, *, origin: FloatArray, axes: FloatArray, size: float
) -> shapely.Geometry:
    """Return the union of the triangles that lie in a plane, by the heights of vertices above it [n]."""
    lies = np.abs(height) <= ON_PLANE * size
    if not lies.any():
        return shapely.MultiPolygon()
    flat = (solid.vertices[solid.triangles[lies[solid.triangles].all(axis=1)]] - origin) @ axes[:2].T
    (ax, ay), (bx, by) = (flat[:, 1] - flat[:, 0]).T, (flat[:, 2] - flat[:, 0]).T
    return shapely.union_all(shapely.polygons(flat[np.abs(ax * by - ay * bx) > DEGENERATE * size**2]))


def _segments(
    solid: Solid, elevation: ArrayLike, direction: Sequence[float]
) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Yield the segments in which each level cuts triangles: their ends s, t [m, 2], anticlockwise around the masonry.

    s is measured along the direction, t square to it.
    """
    x, y = np.asarray(direction[:2], dtype=np.float64) / np.hypot(direction[0], direction[1])
    turned = np.column_stack([solid.vertices[:, :2] @ [[x, -y], [y, x]], solid.vertices[:, 2]])
    corners = turned[solid.triangles]  # outward orientation
    low, high = corners[:, :, 2].min(axis=1), corners[:, :, 2].max(axis=1)
    for z in np.atleast_1d(np.asarray(elevation, dtype=np.float64)):
        crossed = corners[(low < z) & (high >= z)]
        upper = crossed[:, :, 2] >= z
        lone = np.where(upper.sum(axis=1) == 1, upper.argmax(axis=1), (~upper).argmax(axis=1))  # alone on its side
        at = np.arange(len(crossed))
        apex, following, preceding = (crossed[at, (lone + step) % 3] for step in (0, 1, 2))
        ends = [apex + (z - apex[:, 2:]) / (far[:, 2:] - apex[:, 2:]) * (far - apex) for far in (following, preceding)]
        flip = upper[at, lone][:, None]  # the outside lies right of the way from `following` to `preceding`
        yield np.where(flip, ends[0], ends[1])[:, :2], np.where(flip, ends[1], ends[0])[:, :2]


def _moments(start: FloatArray, end: FloatArray) -> tuple[float, float, float]:
    """Return the integrals over one section, from its segments [m, 2], [m, 2]."""
    (s, t), (u, w) = start.T, end.T
    D = s * w - u * t
    return float(D.sum() / 2.0), float(D @ (s + u) / 6.0), float(D @ (s * s + s * u + u * u) / 12.0)
