"""The shape of a roof or vault as it affects its thrust: slope, span and rise."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.geometry.cut import split_upright
from assess.geometry.solid import Solid
from assess.geometry.surface import areas_and_normals
from spectra.arrays import FloatArray

UPRIGHT = 0.05  # vertical part of a unit normal: steeper faces are gables and ends, not the covering
LEVEL = 0.02  # root mean square slope: below this a covering is flat
SAME = 0.5  # ratio of the slopes across and along: above it a covering slopes both ways, like a hipped roof
UNDERSIDE = -1e-3  # vertical part of a unit normal: faces below this look down
SPRINGING = 1e-3  # of the body's size: faces this near its lowest level are what it stands on


@dataclass(frozen=True)
class Slope:
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


def slope(solid: Solid) -> Slope:
    """Find how a roof or vault slopes, from its faces weighted by area.

    The horizontal parts n of their unit normals have a largest and a least mean square, over directions square to
    each other: a gable roof and a barrel vault have none along the ridge, a square groined vault has two alike.
    """
    area, normals = areas_and_normals(solid.vertices[solid.triangles])
    facing = np.abs(normals[:, 2]) > UPRIGHT
    A, n = area[facing], normals[facing, :2] * np.sign(normals[facing, 2:])
    least, most = np.linalg.eigh((A * n.T) @ n / (A.sum() or 1.0))[0]
    if least + most < LEVEL**2:
        return Slope(None, False, 0.0)
    axis = np.linalg.eigh((A * n.T) @ n)[1][:, 1]
    falls = n @ axis
    one_sided = float(abs(A @ falls) / (A @ np.abs(falls)))
    return Slope(np.array([*axis, 0.0]), bool(least > SAME * most), one_sided)


def extent(solid: Solid, *, axis: FloatArray) -> tuple[float, float]:
    """Return where a body begins and ends along a horizontal axis, from the origin [m].

    Parameters
    ----------
    solid : the body
    axis : horizontal unit vector [3]
    """
    x = solid.vertices @ axis
    return float(x.min()), float(x.max())


def height(solid: Solid) -> float:
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
    low, high = extent(solid, axis=axis)
    middle = (low + high) / 2.0
    parts = split_upright(solid, point=middle * axis, normal=axis)
    off = sum(part.mass * abs(float(part.centroid @ axis) - middle) for part in parts)
    return (high - low) / 2.0 - off / sum(part.mass for part in parts)


def underside(solid: Solid) -> tuple[float, float]:
    """Return the area of a vault's intrados and its area in plan [m2]: faces that look down, without its bearings."""
    area, normals = areas_and_normals(solid.vertices[solid.triangles])
    z = solid.vertices[solid.triangles][:, :, 2]
    size = float(np.ptp(solid.vertices, axis=0).max())
    standing = np.all(z <= z.min() + SPRINGING * size, axis=1)
    down = (normals[:, 2] < UNDERSIDE) & ~standing
    return float(area[down].sum()), float(-area[down] @ normals[down, 2])
