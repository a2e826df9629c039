"""Winding numbers: how often closed shells enclose a point."""

from __future__ import annotations

import numpy as np
import shapely

from spectra.arrays import FloatArray, IntArray

SHEAR = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.21372, -0.13187, 1.0]])
"""Sets upright a direction in which masonry has no edges: rays along it meet faces, not their borders."""


def winding_numbers(points: FloatArray, parts: list[FloatArray], boxes: FloatArray) -> IntArray:
    """Return how often all shells together enclose each point.

    Parameters
    ----------
    points : [k, 3] [m]
    parts : corners of the triangles of each shell [m, 3, 3] [m]
    boxes : bounding box of each shell [n, 2, 3] [m]

    Returns
    -------
    1 in material, 0 elsewhere [k]
    """
    found = np.zeros(len(points), dtype=np.int64)
    for part, (low, high) in zip(parts, boxes, strict=True):
        near = np.flatnonzero(np.all((low <= points) & (points <= high), axis=1))
        if len(near):
            found[near] += _winding_of_shell(points[near], part)
    return found


def _winding_of_shell(points: FloatArray, triangles: FloatArray) -> IntArray:
    """Return the winding number [k] of a closed shell [m, 3, 3] around points [k, 3], by casting rays."""
    flat, at = triangles @ SHEAR, points @ SHEAR
    low, high = flat.min(axis=1), flat.max(axis=1)
    tree = shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
    point, face = tree.query(shapely.points(at[:, :2]))
    a, b, c = (flat[face, i] - at[point] for i in range(3))
    sides = np.stack([u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0] for u, v in ((b, c), (c, a), (a, b))])
    doubled_area = sides.sum(axis=0)
    height = sides[0] * a[:, 2] + sides[1] * b[:, 2] + sides[2] * c[:, 2]  # of the face over the point, times its area
    meets = (np.abs(np.sign(sides).sum(axis=0)) == 3.0) & (height * doubled_area > 0.0)
    crossings = np.bincount(point[meets], weights=np.sign(doubled_area[meets]), minlength=len(points))
    return np.asarray(crossings.astype(np.int64))
