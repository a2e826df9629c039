"""Response spectra of records, alone or with a target."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from assess.results import GroundMotionResult, RecordResult
from reports.figures.spectrum import COLOURS, NAMED
from reports.figures.style import INK, MUTED, legend_above, record_label, report_style, sheet
from reports.figures.suite import SHORTEST, means


def draw(names: Sequence[str], period: NDArray[np.float64], ordinates: NDArray[np.float64]) -> Figure:
    """Draw response spectra over a logarithmic axis of periods; more than seven records alike, without names.

    Parameters
    ----------
    names : of the records [n]
    period : [k] [s]
    ordinates : pseudo-accelerations [n, k] [g]
    """
    with report_style():
        figure = sheet(3.3)
        axes = figure.subplots()
        _lines(axes, names, period, ordinates)
        _dress(axes, float(period[-1]))
        return figure


def beside_target(motion: GroundMotionResult, records: Sequence[RecordResult]) -> Figure:
    """Draw target and scaled records above, their means and limits below (as thesis Fig. 8.14).

    Parameters
    ----------
    motion : target, means and the range of periods fitted
    records : with their spectra
    """
    period = np.array(motion.period_s)
    shown = period >= SHORTEST
    ordinates = np.array([record.spectrum.acceleration_g for record in records])
    with report_style():
        figure = sheet(6.0)
        above, below = figure.subplots(2, 1, sharex=True)
        _lines(above, [record.id for record in records], period[shown], ordinates[:, shown])
        above.plot(period[shown], np.array(motion.target_g)[shown], color=INK, linewidth=2.0, label="target")
        _dress(above, float(period[-1]))
        means(below, motion)
        return figure


def _lines(axes: Axes, names: Sequence[str], period: NDArray[np.float64], ordinates: NDArray[np.float64]) -> None:
    named = len(names) <= NAMED
    for place, (name, of) in enumerate(zip(names, ordinates, strict=True)):
        name_shown = record_label(name, 24) if named else (f"{len(names)} records" if place == 0 else "_")
        axes.plot(period, of, color=COLOURS[place] if named else MUTED, linewidth=0.8, alpha=0.8, label=name_shown)


def _dress(axes: Axes, longest: float) -> None:
    axes.set(xscale="log", xlabel="period T [s]", ylabel="pseudo-acceleration Sₐ [g]")
    axes.set_xlim(SHORTEST, longest)
    axes.set_ylim(bottom=0.0)
    axes.xaxis.set_major_formatter("{x:g}")
    legend_above(axes, columns=3)
