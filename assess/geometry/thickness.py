"""The thin direction of a wall, and the size of a body along it, across it and in height."""

from __future__ import annotations

import numpy as np
import shapely

from assess.geometry.surface import area_vectors
from spectra.arrays import FloatArray, IntArray

ROUNDING = 1e-6  # of single precision, in a direction
ALIKE = 0.05  # by how much the two sides of a plan must differ for one to be the thin one


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
    if not high > 0.0 or high - low < ALIKE * high:
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
