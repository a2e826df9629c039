"""Legends that are measured once."""

from __future__ import annotations

from functools import cache

from matplotlib.legend import Legend
from matplotlib.offsetbox import OffsetBox


def cache_extents(legend: Legend) -> Legend:
    """Return the legend, with each of its boxes measured once by each renderer.

    matplotlib measures a box with all that is in it again for every box around it, in the layout and in drawing.
    """
    for box in legend.findobj(OffsetBox):
        assert isinstance(box, OffsetBox)
        box.get_bbox = cache(box.get_bbox)  # type: ignore[method-assign]
    return legend
