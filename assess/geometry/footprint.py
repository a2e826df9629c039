"""The plan of a body's base: its convex hull and the outward directions of its edges."""

from __future__ import annotations

import numpy as np
import shapely

from spectra.arrays import FloatArray

MAX_EDGES = 180  # edges: the shortest of a finer hull change its support by less than one part in a thousand
SHORT = 1e-9  # of the hull's size: edges shorter than this are rounding


def edge_normals(points: FloatArray) -> FloatArray:
    """Return the outward directions of the edges of a convex hull in plan.

    Parameters
    ----------
    points : x, y and possibly more of each point [n, 2 or more] [m]

    Returns
    -------
    angles from +x towards +y, 0 to 360, ascending, of the longest MAX_EDGES edges at most [k] [deg]; empty where the
    points lie on a line
    """
    hull = shapely.MultiPoint(np.asarray(points)[:, :2]).convex_hull
    if not isinstance(hull, shapely.Polygon):
        return np.empty(0)
    corners = shapely.get_coordinates(shapely.orient_polygons(hull))
    edges = np.diff(corners, axis=0)
    length = np.hypot(*edges.T)
    longest = np.argsort(-length, kind="stable")[:MAX_EDGES]
    kept = edges[longest[length[longest] > SHORT * length.sum()]]
    outward = np.degrees(np.arctan2(-kept[:, 0], kept[:, 1]))  # anticlockwise: the outside lies to the right
    return np.unique(np.round(outward, 12) % 360.0)  # rounded, for -1e-15 % 360 is 360
