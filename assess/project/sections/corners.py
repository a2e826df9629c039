"""A polygon as the keys `profile` and `polygon` write it."""

from __future__ import annotations

from typing import Annotated

import numpy as np
import shapely
from pydantic import AfterValidator, Field

from assess.geometry.simple_polygon import find_crossing, remove_repeats
from assess.interfaces.shapes import THINNEST
from assess.project.quantities import PlanePoint
from assess.project.section import wrong


def _simple(corners: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    """Check that corners enclose an area and that the sides meet only at them."""
    points = np.array(corners)
    if shapely.MultiPoint(points).convex_hull.area <= THINNEST * float(np.ptp(points, axis=0).max()) ** 2:
        raise wrong((), "no area, its corners lie on a line; give corners that enclose one")
    meet = find_crossing(remove_repeats(points))
    if meet is not None:
        at = f"[{meet[0]:.4g}, {meet[1]:.4g}] m"
        raise wrong((), f"its sides cross or touch one another at {at}; list its corners in order around the outline")
    return corners


Corners = Annotated[tuple[PlanePoint, ...], Field(min_length=3), AfterValidator(_simple)]
