"""How the answers of a mechanism depend on uncertain numbers: a bar for each, the widest at the top."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Literal, TypeGuard

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from reports.figures.style import FAIL, INK, fold, label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Text, say

LOW, HIGH = "#56b4e9", "#d55e00"  # the number at its low and at its high value
MARGIN = 0.12  # of what is shown, beside the ends of the bars
HALF = 0.34  # height of half a bar, of a row
LINE = 0.3  # height of a row [in]
ROOM = 0.3  # of the width of a panel: a longer bar has room for a word
LONGEST = 40  # characters of a line beside a bar


@dataclass(frozen=True)
class Bar:
    """One number: the two lines of its label, and the answer at its low and its high value.

    low, high : infinite where the body overturns, None where not known
    verdicts : new verdict at the low and at the high value, in a word; None where it does not change
    """

    lines: tuple[Text, Text]
    low: float | None
    high: float | None
    verdicts: tuple[Text | None, Text | None] = (None, None)


@dataclass(frozen=True)
class Panel:
    """One answer: its name and the procedure; its dimension; its value as assessed; its bars.

    limit : between pass and fail, and its name; None where there is none
    """

    name: tuple[Text, Text]
    dimension: str
    base: float | None
    limit: tuple[float, Text] | None
    bars: tuple[Bar, ...]


def draw(panels: Sequence[Panel], locale: Locale) -> Figure:
    """Draw a panel for each answer; all have the rows of the first."""
    rows = panels[0].bars
    with report_style():
        figure = sheet(0.85 + LINE * len(rows), locale)
        beside = figure.subplots(1, len(panels), squeeze=False, sharey=True)[0]
        for axes, panel in zip(beside, panels, strict=True):
            _panel(axes, panel, locale)
        names = ["\n".join(label(locale.text(line), LONGEST) for line in bar.lines) for bar in rows]
        beside[0].set_yticks(range(len(rows)), names)
        beside[0].set_ylim(len(rows) - 0.5, -0.5)
        _legend(figure, beside[0], locale)
        return figure


def _panel(axes: Axes, panel: Panel, locale: Locale) -> None:
    limit = None if panel.limit is None else panel.limit[0]
    ends = [value for bar in panel.bars for value in (bar.low, bar.high)]
    low, high = span([value for value in (*ends, panel.base, limit) if _is_drawn(value)])
    axes.set_xlim(low, high)
    for row, bar in enumerate(panel.bars):
        halves = zip((bar.low, bar.high), (LOW, HIGH), (-0.5, 0.5), bar.verdicts, strict=True)
        for value, colour, side, verdict in halves:
            if value is not None and panel.base is not None:
                word = "" if verdict is None else label(locale.text(verdict), 20)
                _half(axes, panel.base, value, height=row + side * HALF, colour=colour, verdict=word)
    if _is_drawn(panel.base):
        axes.axvline(panel.base, color=INK, linewidth=0.9)
    if panel.limit is not None:
        at, name = panel.limit
        axes.axvline(at, color=FAIL, linewidth=1.1, linestyle="--")
        top = axes.get_xaxis_transform()
        axes.text(at, 1.01, locale.text(name), transform=top, ha="center", fontsize=6.5, color=FAIL)
    words = (locale.heading(panel.name[0], panel.dimension), locale.text(panel.name[1]))
    axes.set_xlabel("\n".join(fold(line, width=34) for line in words))
    axes.xaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0)


def _half(axes: Axes, base: float, value: float, *, height: float, colour: str, verdict: str) -> None:
    """Draw half a bar, from the answer as assessed to that at one value; an arrow at the edge for overturning."""
    low, high = axes.get_xlim()
    start, end = min(base, high), min(value, high)
    axes.barh(height, end - start, HALF, left=start, color=colour, linewidth=0)
    if value == inf:
        axes.plot(high, height, marker=">", color=colour, markersize=5, clip_on=False)
    inside = abs(end - start) > ROOM * (high - low)  # beside the line of the answer as assessed, else beyond the end
    aside = 3 if end >= start else -3
    side: Literal["left", "right"] = "left" if aside > 0 else "right"
    at = (start if inside else end, height)
    axes.annotate(verdict, at, (aside, -0.3), textcoords="offset points", fontsize=6.3, ha=side, va="center", color=INK)


def _is_drawn(value: float | None) -> TypeGuard[float]:
    return value is not None and value < inf


def span(values: Sequence[float]) -> tuple[float, float]:
    """Return the ends of an axis: all of the values with a margin, and a width where they are one."""
    low, high = min(values, default=0.0), max(values, default=1.0)
    width = max(high - low, 0.02 * max(abs(low), abs(high)), 1e-6)
    return low - MARGIN * width, high + MARGIN * width


def _legend(figure: Figure, axes: Axes, locale: Locale) -> None:
    handles = [
        axes.barh([0], [0], color=LOW, label=locale.text(say("at the low value"))),
        axes.barh([0], [0], color=HIGH, label=locale.text(say("at the high value"))),
        *axes.plot([], [], color=INK, linewidth=0.9, label=locale.text(say("as assessed"))),
        *axes.plot([], [], color=FAIL, linewidth=1.1, linestyle="--", label=locale.text(say("limit"))),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=4)
