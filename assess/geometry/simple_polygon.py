"""Simple polygons: where the sides of one that is not simple intersect."""

from __future__ import annotations

import numpy as np
import shapely

from spectra.arrays import FloatArray

Point = tuple[float, float]


def find_crossing(corners: FloatArray) -> Point | None:
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
