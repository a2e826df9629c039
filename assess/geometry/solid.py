"""A solid body of masonry: mass, centroid, inertia, and the closed triangle surface it is drawn with.

Axes are the project's: x, y horizontal, z up. The inertia tensor is the standard one about the centroid,

    [[ int (y2 + z2) dm,  -int x y dm,        -int x z dm       ],
     [-int x y dm,         int (x2 + z2) dm,  -int y z dm       ],
     [-int x z dm,        -int y z dm,         int (x2 + y2) dm ]]

products with their minus sign inside, so the inertia about an axis of unit vector a is a . I . a (thesis 3.20, whose
products are the positive integrals).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import combinations_with_replacement
from typing import Annotated, Any, Concatenate, ParamSpec, TypeVar

import numpy as np
import shapely
from numpy.typing import ArrayLike

from assess.declaration import Mark, PlanePoint, Several
from assess.errors import GeometryError
from assess.geometry.surface import Surface, simplify, tetrahedra, volume
from assess.messages.message import Message
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray, is_number

THINNEST = 1e-12  # volume / (size of the body)^3, area / size^2: below this a body is rounding, not masonry


SMALL = 5_000  # triangles
T = TypeVar("T")
P = ParamSpec("P")


@dataclass(frozen=True, repr=False, eq=False)
class Solid(ShortRepr):
    """A body with its mass properties and its surface; it equals itself alone.

    name : the body's name in the project
    mass : [kg]
    centroid : x, y, z [3] [m]
    inertia : tensor about the centroid, products with their minus sign [3, 3] [kg m2]
    vertices : of the surface [n, 3] [m]
    triangles : vertex indices, anticlockwise seen from outside [m, 3]
    history : what was done to the mesh it was read from
    drawn : the simpler surface that it is drawn with, of a part cut from a fine mesh; None otherwise
    """

    name: str
    mass: float
    centroid: FloatArray
    inertia: FloatArray
    vertices: FloatArray
    triangles: IntArray
    history: tuple[Message, ...] = ()
    drawn: Surface | None = None

    @cached_property
    def bounds(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """The lowest and the highest corner of the box around it, x, y, z each [m]."""
        return tuple(self.vertices.min(axis=0).tolist()), tuple(self.vertices.max(axis=0).tolist())


def keep_of_bodies(
    find: Callable[Concatenate[tuple[Solid, ...], P], T],
) -> Callable[Concatenate[tuple[Solid, ...], P], T]:
    """Return a function of bodies, known by identity, that keeps its last answers: 1024 of small ones, 4 of others.

    A project asks the same of the same bodies for each of its states, directions and variations. What else it is
    called with must be hashable; answers are shared, so their arrays must not be written to.
    """
    of_small, of_large = lru_cache(maxsize=1024)(find), lru_cache(maxsize=4)(find)

    def answer(solids: tuple[Solid, ...], /, *args: P.args, **kwargs: P.kwargs) -> T:
        small = sum(len(solid.triangles) for solid in solids) <= SMALL
        found: T = (of_small if small else of_large)(solids, *args, **kwargs)  # type: ignore[arg-type]
        return found

    return answer


DRAWN_TRIANGLES = 3_000  # of a body that is drawn
LEAST_VOLUME = 0.5  # of a simpler surface, of the body's own: a thin plate may close


def drawn_surface(solid: Solid) -> Surface:
    """Return the surface that a body is drawn with: its own where that has few triangles, else a simpler one."""
    if len(solid.triangles) <= DRAWN_TRIANGLES:
        return solid.vertices, solid.triangles
    return solid.drawn or _simplified((solid,))


@keep_of_bodies
def _simplified(solids: tuple[Solid, ...]) -> Surface:
    (solid,) = solids
    simpler = simplify(solid.vertices, solid.triangles, limit=DRAWN_TRIANGLES)
    whole = solid.vertices, solid.triangles
    return simpler if volume(*simpler) >= LEAST_VOLUME * volume(*whole) else whole


Solids = Mapping[str, Solid | None]
"""Bodies by name; None of those without geometry."""


def box(*, thickness: float, length: float, height: float, base: Sequence[float], density: float, name: str) -> Solid:
    """Make a rectangular box: thickness along x, length along y, height along z.

    Parameters
    ----------
    thickness, length, height : [m]
    base : centre of the base face, x, y, z [3] [m]
    density : [kg/m3]
    name : of the body

    Raises
    ------
    GeometryError : a size or the density is not a positive finite number, or base is not three finite numbers
    """
    sizes = {"thickness": thickness, "length": length, "height": height}
    for quantity, value in sizes.items():
        _check_positive(value, quantity=quantity, unit="m", name=name)
    _check_positive(density, quantity="density", unit="kg/m3", name=name)
    foot = _check_finite(base, shape=(3,), quantity="base", remedy="three finite numbers x, y, z", name=name)
    mass = density * thickness * length * height
    x2, y2, z2 = (mass * size**2 / 12.0 for size in sizes.values())
    half = thickness / 2.0
    footprint = np.array([[-half, 0.0], [half, 0.0], [half, height], [-half, height]])
    vertices, triangles = _extrude(footprint, np.array([[0, 1, 2], [0, 2, 3]]), length=length)
    return _solid(
        name,
        mass,
        foot + np.array([0.0, 0.0, height / 2.0]),
        np.diag([y2 + z2, x2 + z2, x2 + y2]),
        vertices + foot,
        triangles,
    )


def profile(points: ArrayLike, *, length: float, density: float, name: str) -> Solid:
    """Extrude a polygon in the x-z plane along y, centred on y = 0.

    Parameters
    ----------
    points : corners x, z of the polygon, either way round, the first repeated at the end or not [n, 2] [m]
    length : of the extrusion [m]
    density : [kg/m3]

    Raises
    ------
    GeometryError : the polygon crosses or touches itself, has no area, fewer than three corners, or a number is
        not finite; length or density is not positive
    """
    _check_positive(length, quantity="length", unit="m", name=name)
    _check_positive(density, quantity="density", unit="kg/m3", name=name)
    corners = _check_corners(points, name=name)
    area, centre, (xx, zz, xz) = _polygon_moments(corners)
    mass = density * length * area
    yy = mass * length**2 / 12.0
    xx, zz, xz = (density * length * moment for moment in (xx, zz, xz))
    inertia = np.array([[yy + zz, 0.0, -xz], [0.0, xx + zz, 0.0], [-xz, 0.0, xx + yy]])
    vertices, triangles = _extrude(corners, _triangulate(corners), length=length)
    return _solid(name, mass, np.array([centre[0], 0.0, centre[1]]), inertia, vertices, triangles)


def polyhedron(vertices: ArrayLike, triangles: ArrayLike, *, density: float, name: str) -> Solid:
    """The solid inside a closed surface of triangles, anticlockwise seen from outside.

    The volume integrals are sums over the tetrahedra from one point to each triangle, exact for polyhedra; the point
    is the middle of the body, so that coordinates far from the origin cost no digits. Over a tetrahedron of corners
    0, a, b, c, with s = a + b + c and D = a . (b x c): volume D/6, int x dV = D s / 24,
    int x x^T dV = D (a a^T + b b^T + c c^T + s s^T) / 120 (Tonon 2004, J. Math. Stat. 1(1)).

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : indices into vertices [m, 3]; that the surface is closed is the caller's business
    density : [kg/m3]

    Raises
    ------
    GeometryError : no volume, a negative one (the triangles face inwards), or density is not positive
    """
    _check_positive(density, quantity="density", unit="kg/m3", name=name)
    at, faces = np.asarray(vertices, dtype=np.float64), np.asarray(triangles, dtype=np.int64)
    low, high = at.min(axis=0), at.max(axis=0)
    middle = (low + high) / 2.0
    volume, first, second = _volume_moments(at, faces, origin=middle)
    size = float(np.linalg.norm(high - low))
    rounding = THINNEST * size**3 + 4.0 * np.finfo(np.float64).eps * float(np.abs(at).max()) * size**2
    _refuse_volume(volume, rounding=rounding, name=name)
    centre = first / volume
    second = second - volume * np.outer(centre, centre)
    inertia = density * (np.trace(second) * np.eye(3) - second)
    return _solid(name, density * volume, middle + centre, inertia, at, faces)


def join(solids: Sequence[Solid], *, name: str) -> Solid:
    """Join several bodies that move as one block: masses add, inertias by the parallel-axis theorem.

    Bodies that overlap are counted twice where they do.

    Raises
    ------
    GeometryError : there is nothing to join
    """
    if not solids:
        raise GeometryError(f'block "{name}": it joins no bodies; name at least one')
    mass = sum(solid.mass for solid in solids)
    origin = solids[0].centroid
    centroid = origin + sum((s.mass * (s.centroid - origin) for s in solids), start=np.zeros(3)) / mass
    inertia = sum((s.inertia + s.mass * _parallel_axis(s.centroid - centroid) for s in solids), start=np.zeros((3, 3)))
    starts = np.cumsum([0, *(len(solid.vertices) for solid in solids[:-1])])
    triangles = [solid.triangles + start for solid, start in zip(solids, starts, strict=True)]
    vertices = np.concatenate([solid.vertices for solid in solids])
    return _solid(name, mass, centroid, inertia, vertices, np.concatenate(triangles))


def scale_along(solid: Solid, *, direction: Sequence[float], middle: float, factor: float) -> Solid:
    """Scale a solid along a direction, measured from a plane square to it.

    The map is r -> A r + b with A = E + (factor - 1) u u^T, so volume and mass grow by det A = factor, and the second
    moment S = int r r^T dm about the centroid becomes factor A S A^T. S and the inertia tensor I determine each other:
    I = tr(S) E - S, S = tr(I) / 2 E - I.

    Parameters
    ----------
    direction : a vector of any length [3]
    middle : distance of the fixed plane along the direction from the origin [m]
    factor : ratio of new to old distances from that plane, positive [-]
    """
    u = np.asarray(direction, dtype=np.float64) / np.linalg.norm(direction)
    A = np.eye(3) + (factor - 1.0) * np.outer(u, u)
    shift = (1.0 - factor) * middle * u
    S = np.trace(solid.inertia) / 2.0 * np.eye(3) - solid.inertia
    S = factor * A @ S @ A.T
    centroid, vertices = A @ solid.centroid + shift, solid.vertices @ A.T + shift
    inertia = np.trace(S) * np.eye(3) - S
    for array in (centroid, vertices, inertia):
        array.setflags(write=False)
    return replace(solid, mass=factor * solid.mass, centroid=centroid, inertia=inertia, vertices=vertices, drawn=None)


def scale_density(solid: Solid, factor: float) -> Solid:
    """Return a solid of another density.

    Parameters
    ----------
    factor : ratio of new to old density, positive [-]
    """
    if factor == 1.0:
        return solid
    inertia = factor * solid.inertia
    inertia.setflags(write=False)
    return replace(solid, mass=factor * solid.mass, inertia=inertia)


@dataclass(frozen=True)
class IsOutline(Mark):
    """The corners of a polygon in order, which encloses an area and whose sides meet only at them."""

    def fault(self, value: Any) -> str:
        """Return what is wrong with corners [(x, y), …]; empty if they bound a region."""
        points = np.array(value)
        if shapely.MultiPoint(points).convex_hull.area <= THINNEST * float(np.ptp(points, axis=0).max()) ** 2:
            return "no area, its corners lie on a line; give corners that enclose one"
        meet = find_crossing(remove_repeats(points))
        if meet is None:
            return ""
        at = f"[{meet[0]:.4g}, {meet[1]:.4g}] m"
        return f"its sides cross or touch one another at {at}; list its corners in order around the outline"


Corners = Annotated[tuple[PlanePoint, ...], Several(least=3), IsOutline()]


def find_crossing(corners: FloatArray) -> tuple[float, float] | None:
    """Find the first place where two sides cross or touch other than at their common corner; None for a simple polygon.

    Parameters
    ----------
    corners : of a closed polygon, without consecutive repeats [n, 2] [m]
    """
    n = len(corners)
    ends = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
    sides = np.asarray(shapely.linestrings(ends), dtype=np.object_)
    one, other = shapely.STRtree(sides).query(sides, predicate="intersects")
    one, other = np.sort([one, other], axis=0)[:, one < other]
    meet = np.asarray(shapely.intersection(sides[one], sides[other]), dtype=np.object_)
    neighbours = (other - one == 1) | (other - one == n - 1)
    wrong = ~(neighbours & (shapely.get_dimensions(meet) == 0))
    if not wrong.any():
        return None
    first = int(np.lexsort((other[wrong], one[wrong]))[0])
    x, y = shapely.get_coordinates(meet[wrong][first])[0].tolist()
    return (x, y)


def remove_repeats(corners: FloatArray) -> FloatArray:
    """Remove the corners of a closed polygon [n, 2] that repeat the one before."""
    return corners[np.any(corners != np.roll(corners, 1, axis=0), axis=1)]


def _parallel_axis(shift: FloatArray) -> FloatArray:
    """Return the inertia tensor [3, 3] [m2] of a unit point mass at `shift` [3] [m]: |r|^2 E - r r^T."""
    return np.asarray(shift @ shift * np.eye(3) - np.outer(shift, shift), dtype=np.float64)


def _solid(
    name: str, mass: float, centroid: FloatArray, inertia: FloatArray, vertices: FloatArray, triangles: IntArray
) -> Solid:
    """Make a Solid of read-only copies."""
    copies = [np.array(array) for array in (centroid, inertia, vertices)]
    faces = np.array(triangles)
    for array in (*copies, faces):
        array.setflags(write=False)
    return Solid(name, float(mass), copies[0], copies[1], copies[2], faces)


def _extrude(corners: FloatArray, faces: IntArray, *, length: float) -> tuple[FloatArray, IntArray]:
    """Extrude an anticlockwise x-z polygon [n, 2] over y = -+ length / 2: vertices [2 n, 3], outward triangles."""
    n = len(corners)
    near = np.column_stack([corners[:, 0], np.full(n, -length / 2.0), corners[:, 1]])
    far = near + np.array([0.0, length, 0.0])
    here = np.arange(n)
    there = np.roll(here, -1)
    sides = np.concatenate([np.column_stack([here, here + n, there]), np.column_stack([there, here + n, there + n])])
    # x to z turns about -y: the anticlockwise polygon faces -y, the near end
    triangles = np.concatenate([faces, faces[:, ::-1] + n, sides])
    return np.concatenate([near, far]), triangles.astype(np.int64)


def _check_corners(points: ArrayLike, *, name: str) -> FloatArray:
    """Return the polygon's corners, anticlockwise, without repeated points [n, 2] [m]."""
    remedy = "corners [x, z] of finite numbers"
    given = _check_finite(points, shape=(-1, 2), quantity="profile", remedy=remedy, name=name)
    corners = remove_repeats(given)
    if len(corners) < 3:
        found = f"{len(corners)} distinct corners" if len(corners) else "no corners"
        raise GeometryError(f'body "{name}": the profile has {found}; give three or more')
    hull = shapely.MultiPoint(corners).convex_hull
    if hull.area <= THINNEST * float(np.ptp(corners, axis=0).max()) ** 2:
        raise GeometryError(
            f'body "{name}": the profile has no area, its {len(corners)} corners lie on a line; '
            "give corners that enclose one"
        )
    meet = find_crossing(corners)
    if meet is not None:
        raise GeometryError(
            f'body "{name}": the profile crosses or touches itself at x = {meet[0]:.4g} m, z = {meet[1]:.4g} m; '
            "list its corners in order around the outline"
        )
    return corners if _polygon_moments(corners)[0] > 0.0 else corners[::-1]


def _polygon_moments(corners: FloatArray) -> tuple[float, FloatArray, tuple[float, float, float]]:
    """Return area [m2], centroid [2] [m], and int x2, z2, xz dA about the centroid [m4], by Green's theorem.

    Corners clockwise give all of them but the centroid with a minus sign.
    """
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2.0
    x, z = (corners - middle).T
    u, w = np.roll(x, -1), np.roll(z, -1)
    D = x * w - u * z
    area = float(D.sum() / 2.0)
    cx, cz = float(D @ (x + u)) / (6.0 * area), float(D @ (z + w)) / (6.0 * area)
    xx = float(D @ (x * x + x * u + u * u)) / 12.0 - area * cx * cx
    zz = float(D @ (z * z + z * w + w * w)) / 12.0 - area * cz * cz
    xz = float(D @ (x * w + 2.0 * x * z + 2.0 * u * w + u * z)) / 24.0 - area * cx * cz
    return area, middle + np.array([cx, cz]), (xx, zz, xz)


def _triangulate(corners: FloatArray) -> IntArray:
    """Triangulate a simple polygon [n, 2] (constrained Delaunay): anticlockwise triangles [n - 2, 3]."""
    pieces = shapely.get_parts(shapely.constrained_delaunay_triangles(shapely.Polygon(corners)))
    index = {(x, z): i for i, (x, z) in enumerate(corners.tolist())}
    rings = (shapely.get_coordinates(shapely.orient_polygons(piece))[:3].tolist() for piece in pieces)
    return np.array([[index[x, z] for x, z in ring] for ring in rings], dtype=np.int64)


def _volume_moments(points: FloatArray, faces: IntArray, *, origin: FloatArray) -> tuple[float, FloatArray, FloatArray]:
    """Return volume [m3], first [3] [m4] and second moment [3, 3] [m5] inside a surface about a point [3]."""
    volume, first, second = 0.0, np.zeros(3), np.zeros((3, 3))
    for corners, D in tetrahedra(points, faces, origin):
        a, b, c = corners.swapaxes(0, 1)
        s = a + b + c
        volume += float(D.sum())
        first += s @ D
        for i, j in combinations_with_replacement(range(3), 2):
            second[i, j] += D @ (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j])
    second += np.triu(second, 1).T
    return volume / 6.0, first / 24.0, second / 120.0


def _refuse_volume(volume: float, *, rounding: float, name: str) -> None:
    """Raise unless the volume [m3] is positive beyond rounding [m3]."""
    if abs(volume) <= rounding:
        raise GeometryError(f'body "{name}": it encloses no volume ({volume:.3g} m3); give it a thickness')
    if volume < 0.0:
        raise GeometryError(
            f'body "{name}": it is inside out (volume {volume:.6g} m3); flip its normals so that they point outwards'
        )


def _check_positive(value: float, *, quantity: str, unit: str, name: str) -> None:
    """Raise unless the value is a positive finite number."""
    if not is_number(value):
        raise GeometryError(f'body "{name}": {quantity} is {value!r:.60}; give a number [{unit}]')
    if not (np.isfinite(value) and value > 0.0):
        raise GeometryError(f'body "{name}": {quantity} is {value:g} {unit}; give a positive finite number')


def _check_finite(values: ArrayLike, *, shape: tuple[int, ...], quantity: str, remedy: str, name: str) -> FloatArray:
    """Return the values as floats of `shape` (-1: any number), or raise."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.full(shape, np.nan) if -1 not in shape else np.empty(0)
    fits = array.ndim == len(shape) and all(n in (-1, m) for n, m in zip(shape, array.shape, strict=True))
    if not fits or not np.isfinite(array).all():
        raise GeometryError(f'body "{name}": {quantity} is {values!r:.100}; give {remedy}')
    return array
