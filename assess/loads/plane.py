"""Points and directions of the project file in the vertical plane of a mechanism's direction."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assess.loads.load import Point


def point_in_plane(at: Sequence[float], direction: Sequence[float]) -> Point:
    """Return (x, y, z) as (distance along the direction from the origin, elevation); two numbers are that already."""
    if len(at) == 2:
        return (at[0], at[1])
    along = np.asarray(direction) / np.linalg.norm(direction)
    return (float(np.asarray(at) @ along), at[2])


def unit_in_plane(vector: Sequence[float], direction: Sequence[float]) -> Point:
    """Return the part in the plane of motion of the unit vector of (x, y, z) or (along, up)."""
    x, z = point_in_plane(vector, direction)
    return (x / float(np.linalg.norm(vector)), z / float(np.linalg.norm(vector)))
