"""Letters measured as they are drawn, unrounded, and each text once for all figures."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from matplotlib.backend_bases import FigureCanvasBase, RendererBase
from matplotlib.font_manager import FontProperties, findfont, get_font


class Ruler(RendererBase):
    """A renderer that measures and draws nothing."""

    def flipy(self) -> bool:
        """Return False: heights grow upwards."""
        return False

    def get_text_width_height_descent(self, s: str, prop: FontProperties, ismath: Any) -> tuple[float, float, float]:
        """Return width, height and depth below the line [pt]."""
        return _measured(s, prop.copy())

    def _get_font_height_metrics(self, prop: FontProperties) -> tuple[float, float, float]:
        """Return height above the line, depth below it and gap between lines [pt] of a font.

        Asked by matplotlib 3.11, which else reads the tables of the font anew for every text.
        """
        return _leading(prop.copy())


class Canvas(FigureCanvasBase):
    """What a figure is laid out on; it is drawn as marks, not by what matplotlib saves."""

    def get_renderer(self) -> Ruler:
        """Return the renderer that measures its letters."""
        return RULER


RULER = Ruler()
_BARE = RendererBase()


@lru_cache(maxsize=1024)
def _leading(font: FontProperties) -> tuple[float, float, float]:
    face = get_font(findfont(font))
    scale = font.get_size_in_points() / face.units_per_EM
    table: Any = face.get_sfnt_table("OS/2")
    return table["sTypoAscender"] * scale, -table["sTypoDescender"] * scale, table["sTypoLineGap"] * scale


@lru_cache(maxsize=16384)
def _measured(text: str, font: FontProperties) -> tuple[float, float, float]:
    width, height, depth = _BARE.get_text_width_height_descent(text, font, ismath=False)
    return float(width), float(height), float(depth)
