"""Regions of contact as joints see them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely


def in_joint_frame(region: shapely.Geometry, direction: Sequence[float]) -> shapely.Geometry:
    """Return the region with the depth from its foremost point as x, the offset to the left of its centroid as y."""
    along = np.asarray(direction) / np.hypot(*direction)
    across = np.array([-along[1], along[0]])
    middle = shapely.get_coordinates(region.centroid)[0]
    ahead = (shapely.get_coordinates(region) @ along).max()
    return shapely.transform(region, lambda p: np.column_stack([ahead - p @ along, (p - middle) @ across]))
