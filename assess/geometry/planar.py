"""A body in the vertical plane of its motion, as a mechanism uses it.

The plane's coordinates are x, the distance along the direction of motion from the origin, and z, the elevation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from assess.errors import GeometryError
from assess.geometry.outline import Outline, Point, outline
from assess.geometry.solid import Solid
from spectra.arrays import FloatArray

Base = tuple[Point, Point]

BASE_TOLERANCE = 1e-6  # of the body's size: vertices this near the lowest belong to the base


@dataclass(frozen=True)
class PlanarBody:
    """Mass, centroid, inertia and shape of a body in the plane of motion.

    Attributes
    ----------
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
    along = _horizontal(direction)
    points = np.column_stack([solid.vertices @ along, solid.vertices[:, 2]])
    rings = outline(points, solid.triangles[:, ::-1])  # x to z turns away from a viewer who looks across `along`
    return replace(planar_body_without_outline(solid, direction=direction), outline=rings)


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


def _extremes(x: FloatArray) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return which of the positions x [k] lie on the lower and which on the upper extreme line."""
    reach = BASE_TOLERANCE * float(np.ptp(x))
    return x <= x.min() + reach, x >= x.max() - reach


def _horizontal(direction: Sequence[float]) -> FloatArray:
    """Return the unit vector [3] of a horizontal direction, or raise."""
    vector = np.asarray(direction, dtype=np.float64)
    wanted = "give a horizontal vector such as [1, 0, 0]"
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise GeometryError(f"direction is {list(direction)}, not three finite numbers; {wanted}")
    vector = vector / (np.abs(vector).max() or 1.0)  # first, so that neither tiny nor huge numbers lose the norm
    length = float(np.linalg.norm(vector))
    if length == 0.0 or abs(vector[2]) > 1e-9 * length:
        raise GeometryError(f"direction is {list(direction)}, which is not horizontal; {wanted}")
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
