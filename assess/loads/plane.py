"""Points and directions of the project file in the vertical plane of a mechanism's direction."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assess.loads.load import Point


def point_in_plane(at: Sequence[float], direction: Sequence[float]) -> Point:
    """Return a place in the plane of motion: (distance along the direction from the origin, elevation) [m].

    Parameters
    ----------
    at : [x, y, z], or two numbers that are in the plane already [m]
    direction : of the motion, horizontal [3]
    """
    if len(at) == 2:
        return (at[0], at[1])
    along = np.asarray(direction) / np.linalg.norm(direction)
    return (float(np.asarray(at) @ along), at[2])


def unit_in_plane(vector: Sequence[float], direction: Sequence[float]) -> Point:
    """Return the part of a unit vector in the plane of motion.

    Parameters
    ----------
    vector : [x, y, z], or (along the direction, up); of any length
    direction : of the motion, horizontal [3]
    """
    x, z = point_in_plane(vector, direction)
    return (x / float(np.linalg.norm(vector)), z / float(np.linalg.norm(vector)))
