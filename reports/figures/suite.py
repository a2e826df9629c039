"""The mean of a suite of records, its target and the limits of codes."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import GroundMotionResult
from reports.figures.style import FAIL, GRID, INK, MUTED, legend_above, report_style, sheet

BELOW, ABOVE = 0.9, 1.3  # of the target
SHORTEST = 0.02  # s
MEAN = "#0072b2"


def draw(motion: GroundMotionResult) -> Figure:
    """Draw pseudo-acceleration [g] over period [s], logarithmic: target, means, and limits over the range fitted."""
    with report_style():
        figure = sheet(3.0)
        means(figure.subplots(), motion)
        return figure


def means(axes: Axes, motion: GroundMotionResult) -> None:
    """Draw target, means and limits into a panel."""
    period, target = np.array(motion.period_s), np.array(motion.target_g)
    shown = period >= SHORTEST
    fitted = (period >= motion.from_s) & (period <= motion.to_s)
    axes.axvspan(motion.from_s, motion.to_s, color=GRID, alpha=0.45, linewidth=0, label="range fitted")
    axes.plot(period[shown], target[shown], color=INK, linewidth=2.0, label="target")
    axes.plot(period[shown], np.array(motion.mean_g)[shown], color=FAIL, linewidth=1.6, label="mean")
    geometric = np.array(motion.geometric_mean_g)[shown]
    axes.plot(period[shown], geometric, color=MEAN, linewidth=1.3, linestyle="--", label="geometric mean")
    for share, dash in ((BELOW, ":"), (ABOVE, "-.")):
        limit = share * target[fitted]
        axes.plot(period[fitted], limit, color=MUTED, linewidth=1.0, linestyle=dash, label=f"{share:.0%} of target")
    axes.set(xscale="log", xlabel="period T [s]", ylabel="pseudo-acceleration Sₐ [g]")
    axes.set_xlim(SHORTEST, period.max())
    axes.set_ylim(bottom=0.0)
    axes.xaxis.set_major_formatter("{x:g}")
    legend_above(axes, columns=3)
