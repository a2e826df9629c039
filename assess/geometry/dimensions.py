"""Dimensions of bodies: of a wall its thin direction and extents, of a roof or vault its slope, span and rise.

Sizes and coordinates that no masonry has are refused or get a warning, with the unit that was probably meant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from assess.errors import GeometryError
from assess.geometry.cut import split_upright
from assess.geometry.solid import Solid
from assess.geometry.surface import area, area_vectors, areas_and_normals, volume
from assess.messages.message import Message, Quantity, Value, warning
from spectra.arrays import FloatArray, IntArray

ROUNDING = 1e-6  # of single precision, in a direction
SQUARE_PLAN = 0.05  # by how much the two sides of a plan must differ for one to be the thin one


def thin_direction(vertices: FloatArray, triangles: IntArray) -> FloatArray | None:
    """Return the horizontal unit vector [2] along the thickness of a wall: where most of its surface faces, either way.

    The principal axis of the sum of a a^T / |a| over the horizontal parts a of the triangles' area vectors: of a box
    its shorter side in plan, whatever projects from its faces at right angles. None where no direction is preferred,
    as in a square or round tower. Its first component that is not zero is positive.
    """
    vectors = area_vectors(vertices[triangles])[:, :2]
    size = np.hypot(*vectors.T)
    tensor = (vectors / np.where(size > 0.0, size, 1.0)[:, None]).T @ vectors
    (low, high), axes = np.linalg.eigh(tensor)
    if not high > 0.0 or high - low < SQUARE_PLAN * high:
        return None
    return _normalise_sign(axes[:, 1])


def extents(vertices: FloatArray, thin: FloatArray | None) -> tuple[float, float, float]:
    """Return the extents [m] along `thin` [2], across it and upright; without it by the smallest rectangle in plan."""
    along = _shorter_side(vertices) if thin is None else thin
    across = np.array([-along[1], along[0]])
    sides = [float(np.ptp(vertices[:, :2] @ axis)) for axis in (along, across)]
    return sides[0], sides[1], float(np.ptp(vertices[:, 2]))


def _shorter_side(vertices: FloatArray) -> FloatArray:
    """Return the direction [2] of the shorter side of the smallest rectangle in plan; x where there is none."""
    around = shapely.MultiPoint(vertices[:, :2]).minimum_rotated_rectangle
    if not isinstance(around, shapely.Polygon):
        return np.array([1.0, 0.0])
    sides = np.diff(shapely.get_coordinates(around)[:3], axis=0)
    lengths = np.hypot(*sides.T)
    shorter = int(np.argmin(lengths))
    return _normalise_sign(sides[shorter] / lengths[shorter]) if lengths[shorter] > 0.0 else np.array([1.0, 0.0])


def _normalise_sign(axis: FloatArray) -> FloatArray:
    """Return the axis without rounding, towards +x, or +y where it lies along y."""
    clean = np.where(np.abs(axis) < ROUNDING, 0.0, axis)
    clean = clean / np.hypot(*clean)
    return np.asarray(clean if tuple(clean) > (0.0, 0.0) else -clean + 0.0, dtype=np.float64)


UPRIGHT = 0.05  # vertical part of a unit normal: steeper faces are gables and ends, not the covering
LEVEL_SLOPE = 0.02  # root mean square slope: below this a covering is flat
BOTH_WAYS = 0.5  # ratio of the slopes across and along: above it a covering slopes both ways, like a hipped roof
UNDERSIDE = -1e-3  # vertical part of a unit normal: faces below this look down
SPRINGING = 1e-3  # of the body's size: faces this near its lowest level are what it stands on


@dataclass(frozen=True)
class RoofSlope:
    """The slope of a roof or vault.

    Attributes
    ----------
    axis : horizontal unit vector along which it falls most [3], either way; None where it is flat
    both_ways : whether it falls across that as well, as a hipped roof or a groined vault does
    one_sided : 0 for a gable, whose slopes face both ways, 1 for a roof of a single slope [-]
    """

    axis: FloatArray | None
    both_ways: bool
    one_sided: float


def roof_slope(solid: Solid) -> RoofSlope:
    """Find how a roof or vault slopes, from its faces weighted by area.

    The horizontal parts n of their unit normals have a largest and a least mean square, over directions square to
    each other: a gable roof and a barrel vault have none along the ridge, a square groined vault has two alike.
    """
    area, normals = areas_and_normals(solid.vertices[solid.triangles])
    facing = np.abs(normals[:, 2]) > UPRIGHT
    A, n = area[facing], normals[facing, :2] * np.sign(normals[facing, 2:])
    least, most = np.linalg.eigh((A * n.T) @ n / (A.sum() or 1.0))[0]
    if least + most < LEVEL_SLOPE**2:
        return RoofSlope(None, False, 0.0)
    axis = np.linalg.eigh((A * n.T) @ n)[1][:, 1]
    falls = n @ axis
    one_sided = float(abs(A @ falls) / (A @ np.abs(falls)))
    return RoofSlope(np.array([*axis, 0.0]), bool(least > BOTH_WAYS * most), one_sided)


def extent_along(solid: Solid, *, axis: FloatArray) -> tuple[float, float]:
    """Return where a body begins and ends along a horizontal axis, from the origin [m].

    Parameters
    ----------
    solid : the body
    axis : horizontal unit vector [3]
    """
    x = solid.vertices @ axis
    return float(x.min()), float(x.max())


def overall_height(solid: Solid) -> float:
    """Return the height from the lowest to the highest point [m]."""
    return float(np.ptp(solid.vertices[:, 2]))


def mean_lever_arm(solid: Solid, *, axis: FloatArray) -> float:
    """Return the mean distance of the mass of a roof or vault from the nearer end of its span [m].

    A quarter of the span where the mass is spread evenly over the plan; less where it is steeper towards its feet.

    Parameters
    ----------
    solid : the roof or vault
    axis : of the span, a horizontal unit vector [3]
    """
    low, high = extent_along(solid, axis=axis)
    middle = (low + high) / 2.0
    parts = split_upright(solid, point=middle * axis, normal=axis)
    off = sum(part.mass * abs(float(part.centroid @ axis) - middle) for part in parts)
    return (high - low) / 2.0 - off / sum(part.mass for part in parts)


def intrados_area(solid: Solid) -> tuple[float, float]:
    """Return the area of a vault's intrados and its area in plan [m2]: faces that look down, without its bearings."""
    area, normals = areas_and_normals(solid.vertices[solid.triangles])
    z = solid.vertices[solid.triangles][:, :, 2]
    size = float(np.ptp(solid.vertices, axis=0).max())
    standing = np.all(z <= z.min() + SPRINGING * size, axis=1)
    down = (normals[:, 2] < UNDERSIDE) & ~standing
    return float(area[down].sum()), float(-area[down] @ normals[down, 2])


LONGEST_BODY = 300.0  # m: no masonry body is longer
SHORTEST_BODY = 0.03  # m: none is shorter
USUAL_LENGTH = 5.0  # m: a body's usual length
UNITS = {"mm": 1e-3, "cm": 1e-2, "in": 0.0254, "ft": 0.3048, "m": 1.0, "km": 1e3}  # m
WALL_LENGTH = (1.0, 100.0)  # m: of the longest side of a usual wall
WALL_THICKNESS = (0.1, 3.0)  # m
VERY_LONG = 50.0  # m: a body that is longer and thicker than a usual wall suggests another unit
COARSE = 1e-4  # of the body's size: rounding of coordinates that moves results
TOO_COARSE = 0.01  # of its thickness: rounding that spoils them
UNIT_ROUNDING = 1e-12  # of the farthest coordinate: rounding of a change of units


def refuse_implausible(solid: Solid, *, unit: float, given: bool, single: bool, where: str) -> None:
    """Raise where a mesh cannot be a masonry body, by its size or by the precision of its coordinates.

    A small specimen is accepted where the project gives its unit.

    Parameters
    ----------
    solid : the body
    unit : length that the mesh was read in [m]
    given : whether the project gives that unit
    single : whether the file holds single precision; another with such numbers may have been drawn so
    where : named in errors

    Raises
    ------
    GeometryError : the body is longer than 300 m, or shorter than 3 cm without a given unit; its coordinates are in
        single precision that resolves no better than a hundredth of its thickness
    """
    size = _longest_side(solid)
    if size > LONGEST_BODY or (size < SHORTEST_BODY and not given):
        limit = f"more than {LONGEST_BODY:g}" if size > LONGEST_BODY else f"less than {SHORTEST_BODY:g}"
        remedy = "give another mesh_unit" if given else "give mesh_unit, the unit of its coordinates"
        likely = _likely_unit(solid, unit=unit)
        hint = "No usual unit makes it a wall; check the model"
        if likely is not None:
            hint = f'With mesh_unit = "{likely.name}" it would measure {likely.size:.4g} m'
        raise GeometryError(
            f"{where}: it measures {size:.4g} m at its longest, {limit} m, which no masonry body does; {remedy}. {hint}"
        )
    resolution = _single_precision_spacing(solid, unit=unit) if single else 0.0
    if resolution > 0.0 and resolution > TOO_COARSE * (thickness := _thickness(solid)):
        raise GeometryError(
            f"{where}: its coordinates are in single precision, which {np.abs(solid.vertices).max():.4g} m from the "
            f"origin resolves {resolution:.2g} m, more than 1 % of its thickness of {thickness:.3g} m; move the model "
            "near the origin before exporting it, or export it in double precision or as text"
        )


def size_warning(solid: Solid, *, unit: float | None = None) -> Message | None:
    """Return a warning where size or coordinates of a body suggest a slip, None otherwise.

    Parameters
    ----------
    solid : the body
    unit : length that the mesh was read in [m]; None for a body that is not a mesh
    """
    size = _longest_side(solid)
    values: dict[str, Value] = {"body": solid.name, "size": Quantity(size, "length")}
    likely = None if unit is None else _likely_unit(solid, unit=unit)
    if likely is not None:
        values |= {"unit": likely.name, "other": Quantity(likely.size, "length")}
    behind = "" if likely is None else "-in-unit"
    if not SHORTEST_BODY <= size <= LONGEST_BODY:
        return warning(f"size{behind}", **values)
    if size > VERY_LONG and (thickness := _thickness(solid)) > WALL_THICKNESS[1]:
        return warning(f"size-thick{behind}", thickness=Quantity(thickness, "length", 3), **values)
    resolution = _single_precision_spacing(solid, unit=unit or 1.0)
    if resolution > COARSE * size:
        distance, finest = float(np.abs(solid.vertices).max()), Quantity(resolution, "length", 2)
        return warning("far-from-origin", body=solid.name, distance=Quantity(distance, "length"), resolution=finest)
    return None


def _longest_side(solid: Solid) -> float:
    """Return the longest side of the box around a body [m]."""
    return float(np.ptp(solid.vertices, axis=0).max())


def _thickness(solid: Solid) -> float:
    """Return the thickness of a body [m]: its least extent, or 1.5 times that of a plate of its volume and surface.

    The latter is less for walls that bend, and for several walls in one.
    """
    sides = extents(solid.vertices, thin_direction(solid.vertices, solid.triangles))
    plate = 2.0 * volume(solid.vertices, solid.triangles) / area(solid.vertices, solid.triangles)
    return min(*sides, 1.5 * plate)


def _single_precision_spacing(solid: Solid, *, unit: float) -> float:
    """Return the spacing of single-precision numbers at a body's farthest coordinate [m].

    0 where coordinates hold more digits, and where they are so fine that they never matter.
    """
    farthest = float(np.abs(solid.vertices).max()) / unit
    spacing = float(np.spacing(np.float32(farthest)))
    if spacing * unit <= COARSE * _longest_side(solid):
        return 0.0
    read = solid.vertices / unit
    single = np.abs(read - read.astype(np.float32)).max() <= UNIT_ROUNDING * farthest
    return spacing * unit if single else 0.0


@dataclass(frozen=True)
class _LikelyUnit:
    """The unit that was probably meant, and the longest side of the body in it [m]."""

    name: str
    size: float


def _likely_unit(solid: Solid, *, unit: float) -> _LikelyUnit | None:
    """Return the unit that makes a body a usual wall, or else gives it the size of one; None where none does."""
    length, thickness = _longest_side(solid) / unit, _thickness(solid) / unit
    walls = [
        name
        for name, one in UNITS.items()
        if WALL_LENGTH[0] <= length * one <= WALL_LENGTH[1]
        and WALL_THICKNESS[0] <= thickness * one <= WALL_THICKNESS[1]
    ]
    likely = min(walls or UNITS, key=lambda name: abs(np.log(length * UNITS[name] / USUAL_LENGTH)))
    size = length * UNITS[likely]
    same = abs(UNITS[likely] / unit - 1.0) < UNIT_ROUNDING
    return None if same or not SHORTEST_BODY <= size <= LONGEST_BODY else _LikelyUnit(likely, size)
