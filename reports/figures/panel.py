"""Panels whose scales are drawn whole: what is seen is what matplotlib draws, in a fraction of its time.

matplotlib makes five artists of every tick and measures its number four times. Here a scale is one stroke for its grid,
one for its ticks, and letters. Figures of the report have 72 pixels to the inch, so that a pixel is a point; drawn at
another resolution, all lengths are multiplied by the pixels to a point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal, cast

import numpy as np
from matplotlib import rcParams
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.axis import Axis, XAxis, YAxis
from matplotlib.backend_bases import RendererBase
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.legend import Legend
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.ticker import NullLocator
from matplotlib.transforms import Bbox, IdentityTransform
from numpy.typing import NDArray

from reports.figures.legend import cache_extents
from reports.figures.ruler import RULER, Ruler
from spectra.arrays import FloatArray

Point = tuple[float, float]
_CLOSE = 1e-10  # of the range: a tick as near to its end is on it
_STYLE = cast("Mapping[str, Any]", rcParams)
_PAPER = Figure(dpi=72)  # on which single numbers are measured


@dataclass(frozen=True)
class _Ticks:
    """The larger or the smaller ticks that are seen, and their look; lengths in pixels, line widths in points.

    at : along the scale [n]
    numbers : at them, empty where none is written [n]
    """

    at: FloatArray
    numbers: tuple[str, ...]
    has_grid: bool
    is_drawn: bool
    is_numbered: bool
    length: float
    width: float
    pad: float
    size: Any
    colour: Any


@dataclass(frozen=True)
class _Numbered:
    """Values of the visible ticks [n], their numbers [n], and the power of ten of these."""

    values: FloatArray
    numbers: tuple[str, ...]
    power: str


@dataclass(frozen=True)
class _Line:
    """A line of text and where it begins, from the point that the text is set at [pt]."""

    text: str
    x: float
    y: float
    font: FontProperties


@dataclass(frozen=True)
class _Lettered:
    """A text as its lines, and its lower left and upper right corners [2, 2] [pt]."""

    box: FloatArray
    lines: tuple[_Line, ...]


class _Scale(Axis):
    """A scale at the lower or the left edge of its panel, ticks outwards.

    Attributes
    ----------
    along : place of its coordinate in a point: 0 for x, 1 for y
    side : the edge at which it is drawn
    setting : of a number at its tick: across, up
    """

    axis_name: str
    along: int
    side: str
    setting: tuple[str, str]

    def reset_ticks(self) -> None:
        """Forget ticks; an artist is made of one only when asked for."""
        self.majorTicks: Any = []
        self.minorTicks: Any = []
        self._found: dict[tuple[object, ...], _Numbered] = {}

    def get_children(self) -> list[Artist]:
        """Return its label, and the power of ten of its numbers."""
        return [self.label, self.offsetText]

    def get_tightbbox(self, renderer: Any = None, *, for_layout_only: bool = False) -> Bbox | None:
        """Return the box of its letters [px]; in the layout only the distance of the label from the panel counts."""
        if not self.get_visible():
            return None
        ruler = RULER if renderer is None or self._pixels == 1.0 else renderer
        numbers = self._set_letters(self._ticks())
        power, label = _extent(self.offsetText, ruler), _extent(self.label, ruler)
        if label is not None and for_layout_only:
            label = self._narrowed(label)
        return Bbox.union([box for box in (numbers, power, label) if box is not None])

    def draw(self, renderer: RendererBase) -> None:
        """Draw grid, ticks, numbers, label and power of ten."""
        if not self.get_visible():
            return
        ticks = self._ticks()
        for each in ticks:
            self._draw_lines(renderer, each)
            self._draw_numbers(renderer, each)
        self._set_letters(ticks)
        self.label.draw(renderer)
        self.offsetText.draw(renderer)
        self.stale = False

    def _ticks(self) -> list[_Ticks]:
        """Return the larger ticks, and the smaller ones of a scale that has any."""
        has_minor = not isinstance(self.get_minor_locator(), NullLocator)
        return [self._kind("major")] + ([self._kind("minor")] if has_minor else [])

    def _kind(self, which: Literal["major", "minor"]) -> _Ticks:
        found, given, name = self._numbered(which), self.get_tick_params(which), f"{self.axis_name}tick"
        return _Ticks(
            at=self._points(found.values),
            numbers=found.numbers,
            has_grid=given["gridOn"],
            is_drawn=given.get(self.side, True),
            is_numbered=given.get(f"label{self.side}", True),
            length=self._pixels * given.get("length", _STYLE[f"{name}.{which}.size"]),
            width=given.get("width", _STYLE[f"{name}.{which}.width"]),
            pad=self._pixels * given.get("pad", _STYLE[f"{name}.{which}.pad"]),
            size=given.get("labelsize", _STYLE[f"{name}.labelsize"]),
            colour=given.get("color", _STYLE[f"{name}.color"]),
        )

    def _numbered(self, which: Literal["major", "minor"]) -> _Numbered:
        """Return the ticks that are seen: a scale is laid out twice and then drawn, most often with the same ones."""
        major = which == "major"
        locator = self.get_major_locator() if major else self.get_minor_locator()
        formatter = self.get_major_formatter() if major else self.get_minor_formatter()
        known = (locator, formatter, *self.get_view_interval(), self.get_tick_space())
        if known not in self._found:
            values = np.asarray(self.get_majorticklocs() if major else self.get_minorticklocs(), dtype=np.float64)
            seen = self._is_seen(values)
            numbers = formatter.format_ticks(values.tolist()) if values.size else []
            kept = tuple(number for number, is_seen in zip(numbers, seen.tolist(), strict=True) if is_seen)
            self._found[known] = _Numbered(values[seen], kept, formatter.get_offset())
        return self._found[known]

    def _is_seen(self, values: FloatArray) -> NDArray[np.bool_]:
        """Return whether each value is within the panel [n]."""
        transform = self.get_transform()
        first, last = sorted(transform.transform(np.asarray(self.get_view_interval(), dtype=np.float64)))
        at, room = transform.transform(values), _CLOSE * (last - first)
        return np.asarray((at >= first - room) & (at <= last + room))

    def _points(self, values: FloatArray) -> FloatArray:
        """Return positions of values along the scale [px]."""
        points = np.tile(np.asarray(self.axes.viewLim.min, dtype=np.float64), (values.size, 1))
        points[:, self.along] = values
        return np.asarray(self.axes.transData.transform(points))[:, self.along]

    @property
    def _pixels(self) -> float:
        """How many pixels a point has."""
        return float(self.axes.figure.dpi) / 72.0

    @property
    def _edge(self) -> float:
        """Position of the scale across its direction [px]."""
        return float(self.axes.bbox.min[1 - self.along])

    def _point(self, along: float, away: float) -> Point:
        return (along, away) if self.along == 0 else (away, along)

    def _draw_lines(self, renderer: RendererBase, ticks: _Ticks) -> None:
        if not ticks.at.size:
            return
        if ticks.has_grid:
            end, colour, width = self.axes.bbox.max[1 - self.along], _STYLE["grid.color"], _STYLE["grid.linewidth"]
            self._stroke(renderer, ticks.at, end, colour=colour, width=width)
        if ticks.is_drawn and ticks.length:
            self._stroke(renderer, ticks.at, self._edge - ticks.length, colour=ticks.colour, width=ticks.width)

    def _stroke(self, renderer: RendererBase, at: FloatArray, end: float, *, colour: Any, width: float) -> None:
        """Draw lines square to the scale, from its edge to `end` [px]."""
        ends = [self._point(along, away) for along in at.tolist() for away in (self._edge, end)]
        pen = renderer.new_gc()
        pen.set_foreground(colour)
        pen.set_linewidth(width)
        pen.set_capstyle("butt")
        renderer.draw_path(pen, Path(ends, [Path.MOVETO, Path.LINETO] * at.size), IdentityTransform())
        pen.restore()

    def _draw_numbers(self, renderer: RendererBase, ticks: _Ticks) -> None:
        pen = renderer.new_gc()
        pen.set_foreground(ticks.colour)
        top = renderer.get_canvas_width_height()[1] if renderer.flipy() else None
        for (x, y), number in self._places(ticks):
            for line in _lettered(number, ticks.size, self.setting).lines:
                height = y + self._pixels * line.y
                at = (x + self._pixels * line.x, height if top is None else top - height)
                renderer.draw_text(pen, *at, line.text, line.font, 0.0)
        pen.restore()

    def _places(self, ticks: _Ticks) -> list[tuple[Point, str]]:
        """Return positions of the numbers [px], each with its number."""
        if not ticks.is_numbered:
            return []
        away = self._edge - ticks.length - ticks.pad
        return [(self._point(at, away), number) for at, number in zip(ticks.at.tolist(), ticks.numbers, strict=True)]

    def _set_letters(self, ticks: Sequence[_Ticks]) -> Bbox:
        """Put the label and the power of ten beside ticks and numbers; what ticks and numbers cover [px]."""
        boxes = [
            place + self._pixels * _lettered(number, each.size, self.setting).box
            for each in ticks
            for place, number in self._places(each)
        ]
        numbers = np.array(boxes).reshape(-1, 2)
        longest = max((each.length for each in ticks if each.at.size and each.is_drawn), default=0.0)
        first, last = self.axes.bbox.min[self.along], self.axes.bbox.max[self.along]
        corners = np.array([*numbers, self._point(first, self._edge - longest), self._point(last, self._edge)])
        lowest, highest = corners.min(axis=0), corners.max(axis=0)
        middle = self.label.get_position()[self.along]
        self.label.set_position(self._point(middle, lowest[1 - self.along] - self._pixels * self.labelpad))
        self.offsetText.set_text(self._numbered("major").power)
        self.offsetText.set_y(self._power(numbers[:, 1].min() if boxes else self._edge))
        return Bbox([lowest, highest])

    def _power(self, outside: float) -> float:
        """Return the height of the power of ten [px], where the numbers end at `outside`."""
        raise NotImplementedError

    def _narrowed(self, box: Bbox) -> Bbox:
        """Return a box as it counts in the layout: one point along the scale."""
        corners, middle = np.array(box.get_points()), box.get_points().mean(axis=0)
        corners[:, self.along] = middle[self.along] - 0.5, middle[self.along] + 0.5
        return Bbox(corners)


class _Across(_Scale, XAxis):
    """The scale of x, at the bottom."""

    along, side, setting = 0, "bottom", ("center", "top")

    def _power(self, outside: float) -> float:
        return outside - self._pixels * self.OFFSETTEXTPAD


class _Up(_Scale, YAxis):
    """The scale of y, at the left."""

    along, side, setting = 1, "left", ("right", "center_baseline")

    def _power(self, outside: float) -> float:
        return float(self.axes.bbox.ymax) + self._pixels * self.OFFSETTEXTPAD


class Panel(Axes):
    """Axes with scales at the bottom and at the left."""

    name = "panel"

    def _init_axis(self) -> None:
        """Make the scales, as matplotlib's projections make their axes."""
        self.xaxis: Any = _Across(self, clear=False)
        self.yaxis: Any = _Up(self, clear=False)
        for side, axis in (("bottom", self.xaxis), ("top", self.xaxis), ("left", self.yaxis), ("right", self.yaxis)):
            self.spines[side].register_axis(axis)

    def legend(self, *given: Any, **named: Any) -> Legend:
        """Return a legend whose boxes are measured once."""
        return cache_extents(super().legend(*given, **named))

    def clear(self) -> None:
        """Put frames at the edges of the panel, which take no place beside their scales."""
        super().clear()
        for spine in self.spines.values():
            spine.set_position(("outward", 0.0))
            spine.set_in_layout(False)


@lru_cache(maxsize=4096)
def _lettered(text: str, size: Any, setting: tuple[str, str]) -> _Lettered:
    """Return a text as matplotlib sets it at the origin."""
    across, up = setting
    letters, catcher = Text(0.0, 0.0, text, fontsize=size, ha=across, va=up, figure=_PAPER), _Catcher()
    letters.draw(catcher)
    return _Lettered(np.asarray(letters.get_window_extent(RULER).get_points()), tuple(catcher.lines))


class _Catcher(Ruler):
    """A renderer that keeps the lines of text it is to draw."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[_Line] = []

    def draw_text(self, gc: Any, x: float, y: float, s: str, prop: FontProperties, *_: Any, **__: Any) -> None:
        self.lines.append(_Line(s, float(x), float(y), prop.copy()))


def _extent(text: Text, ruler: RendererBase) -> Bbox | None:
    """Return what a text covers [px], where it is seen."""
    return Bbox(text.get_window_extent(ruler)) if text.get_visible() and text.get_text() else None
