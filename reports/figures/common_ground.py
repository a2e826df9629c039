"""Whether bodies can stand where a project puts them."""

from __future__ import annotations

import numpy as np
import shapely

from reports.figures.solids import Surface, box_of
from spectra.arrays import BoolArray

SHARED = 0.3  # of the smaller: bodies that share more of their ground and height cannot both stand there
SAMPLES = 15  # points along the ground of a body, in either direction


def are_one_in_the_other(one: Surface, other: Surface) -> bool:
    """Return whether two surfaces share so much ground and height that they cannot both stand there."""
    boxes = box_of(one.vertices), box_of(other.vertices)
    low, high = np.maximum(boxes[0][0], boxes[1][0]), np.minimum(boxes[0][1], boxes[1][1])
    if (high <= low).any():
        return False
    tall = min(float(box[1, 2] - box[0, 2]) for box in boxes)
    if high[2] - low[2] <= SHARED * tall:
        return False
    pairs = ((one, other), (other, one))
    return any(_shared_ground(mine, its) > SHARED for mine, its in pairs)


def _shared_ground(one: Surface, other: Surface) -> float:
    """Return the part of the ground under a surface that is under another too [-], by points on a grid."""
    low, high = box_of(one.vertices)[:, :2]
    x, y = (np.linspace(start, end, SAMPLES + 2)[1:-1] for start, end in zip(low, high, strict=True))
    points = shapely.points(np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2))
    mine, its = (_are_above(surface, np.asarray(points)) for surface in (one, other))
    return float((mine & its).sum() / max(int(mine.sum()), 1))


def _are_above(surface: Surface, points: np.ndarray) -> BoolArray:
    """Return whether each point of the ground [k] lies under a surface."""
    corners = surface.corners[:, :, :2]
    (x, y), (u, v) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
    upwards = x * v - y * u > 0.0
    tree = shapely.STRtree(np.asarray(shapely.polygons(corners[upwards])))
    found = np.zeros(len(points), dtype=np.bool_)
    found[tree.query(points, predicate="intersects")[0]] = True
    return found
