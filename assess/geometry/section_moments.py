"""Level sections of solids at many elevations: area and second moment for bending in a horizontal direction.

A plane cuts each triangle it crosses in a segment. Segments that run anticlockwise around the masonry, seen from
above, give area, first and second moment by Green's theorem without being joined to rings, holes included:

    A = sum D / 2, int s dA = sum D (s + s') / 6, int s^2 dA = sum D (s^2 + s s' + s'^2) / 12, D = s t' - s' t
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from assess.geometry.solid import Solid
from spectra.arrays import FloatArray


def section_moments(solid: Solid, elevation: ArrayLike, *, direction: Sequence[float]) -> FloatArray:
    """Return area and moments of level sections at several elevations.

    Parameters
    ----------
    solid : the body
    elevation : [n] [m]
    direction : horizontal vector along which s is measured from the origin [3]

    Returns
    -------
    area A [m2], int s dA [m3] and int s^2 dA [m4] of each section [n, 3]; 0 where the solid does not reach
    """
    x, y = np.asarray(direction[:2], dtype=np.float64) / np.hypot(direction[0], direction[1])
    turned = np.column_stack([solid.vertices[:, :2] @ [[x, -y], [y, x]], solid.vertices[:, 2]])  # s, t square to it, z
    corners = turned[solid.triangles]
    low, high = corners[:, :, 2].min(axis=1), corners[:, :, 2].max(axis=1)
    levels = np.atleast_1d(np.asarray(elevation, dtype=np.float64))
    return np.array([_moments(corners[(low < z) & (high >= z)], z) for z in levels])


def _moments(crossed: FloatArray, z: float) -> tuple[float, float, float]:
    """Return the integrals at one elevation, from the triangles it crosses [m, 3, 3], outward orientation."""
    if not len(crossed):
        return 0.0, 0.0, 0.0
    upper = crossed[:, :, 2] >= z
    lone = np.where(upper.sum(axis=1) == 1, upper.argmax(axis=1), (~upper).argmax(axis=1))  # the corner on its own side
    at = np.arange(len(crossed))
    apex, following, preceding = (crossed[at, (lone + step) % 3] for step in (0, 1, 2))
    ends = [apex + (z - apex[:, 2:]) / (far[:, 2:] - apex[:, 2:]) * (far - apex) for far in (following, preceding)]
    flip = upper[at, lone]  # with the apex above, the outside lies right of the way from `following` to `preceding`
    s, t = np.where(flip[:, None], ends[0], ends[1])[:, :2].T
    u, w = np.where(flip[:, None], ends[1], ends[0])[:, :2].T
    D = s * w - u * t
    return float(D.sum() / 2.0), float(D @ (s + u) / 6.0), float(D @ (s * s + s * u + u * u) / 12.0)
