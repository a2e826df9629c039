"""The runs of each record at rising intensity: its largest rotation, up to where it overturns, and its islands."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results.fragility import LARGE_SCALE, MeasureResult, RecordRuns
from reports.figures.style import FAIL, INK, MUTED, WIDTH, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say
from reports.measures import measure_text
from spectra.arrays import FloatArray

TOP = 1.12  # of the largest rotation that did not overturn, where overturned runs are drawn
ISLAND = "#e69f00"
MANY = 30  # records, whose lines are fainter and whose islands are smaller


def draw(
    runs: Sequence[RecordRuns],
    units: Sequence[float],
    measure: MeasureResult,
    locale: Locale,
    *,
    reach: float,
    width: float = WIDTH,
) -> Figure:
    """Draw rotation over that which overturns, over the intensity; overturned runs on a line at the top.

    Parameters
    ----------
    runs : of the records
    units : intensity of each record at scale 1 [unit of the measure]
    measure : of the intensity
    reach : end of the axis [unit of the measure]
    locale : of the labels
    width : of the figure [in]
    """
    with report_style():
        figure = sheet(2.6, locale, width=width)
        axes = figure.subplots()
        top = TOP * max([1.0, *(ratio for run in runs for ratio in run.ratio if ratio is not None)])
        faint = 0.8 if len(runs) <= MANY else 0.45
        pairs = list(zip(runs, units, strict=True))
        for place, (run, unit) in enumerate(pairs):
            name = locale.text(say("a record")) if place == 0 else "_"
            if len(run.scale) > 1:
                axes.plot(*_line(run, unit, top), color=MUTED, linewidth=0.4, alpha=faint, label=name)
            else:
                axes.plot(*_line(run, unit, top), "o", color=MUTED, markersize=2.5, label=name)
        _falls(axes, pairs, top, locale)
        _islands(axes, pairs, locale)
        axes.axhline(1.0, color=FAIL, linewidth=0.7)
        axes.set_ylim(0.0, 1.04 * top)
        axes.set_xlim(0.0, reach)
        axes.set_yticks([0.0, 0.25, 0.5, 0.75, 1.0, top])
        axes.set_yticklabels([*(locale.number(y) for y in (0.0, 0.25, 0.5, 0.75, 1.0)), locale.text(say("overturned"))])
        axes.set_xlabel(locale.heading(measure_text(measure), measure.dimension))
        axes.set_ylabel(locale.heading(say("largest rotation φ/φₒᵥ"), "ratio"))
        legend_below(figure, columns=1 if width < WIDTH else 2)
        return figure


def _line(run: RecordRuns, unit: float, top: float) -> tuple[FloatArray, FloatArray]:
    """Return intensities and rotations of a record, `top` where it overturned."""
    ratio = np.array([top if each is None else each for each in run.ratio])
    return unit * np.array(run.scale), ratio


def _first_fall(run: RecordRuns) -> float | None:
    """Return the least scale that overturns; None for a record that never does."""
    return next((scale for scale, ratio in zip(run.scale, run.ratio, strict=True) if ratio is None), None)


def _falls(axes: Axes, pairs: Sequence[tuple[RecordRuns, float]], top: float, locale: Locale) -> None:
    """Mark the first run of each record that overturns; hollow where it is scaled by more than 4."""
    first = [(_first_fall(run), unit) for run, unit in pairs]
    for large, face, words in (
        (False, FAIL, say("overturns first")),
        (True, "white", say("overturns first, scaled by more than 4")),
    ):
        at = [scale * unit for scale, unit in first if scale is not None and (scale > LARGE_SCALE) == large]
        if at:
            name = locale.text(words)
            axes.plot(at, [top] * len(at), "o", color=FAIL, markersize=3.5, markerfacecolor=face, label=name, zorder=3)


def _islands(axes: Axes, pairs: Sequence[tuple[RecordRuns, float]], locale: Locale) -> None:
    """Draw runs that stand although a lower scale overturns the mechanism."""
    found = [
        (scale * unit, ratio)
        for run, unit in pairs
        for scale, ratio in zip(run.scale, run.ratio, strict=True)
        if ratio is not None and any(low <= scale <= high for low, high in run.islands)
    ]
    if found:
        x, y = zip(*found, strict=True)
        size = 4 if len(pairs) <= MANY else 2
        axes.plot(
            x, y, "D", color=INK, markerfacecolor=ISLAND, markersize=size, markeredgewidth=0.4, zorder=4,
            label=locale.text(say("island: stands again")),
        )  # fmt: skip
