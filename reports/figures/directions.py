"""The multiplier that starts rocking towards each horizontal direction."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes

from assess.results import DirectionSweep
from reports.figures.style import FAIL, HALF, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say


def draw(found: DirectionSweep, locale: Locale) -> Figure:
    """Draw the multiplier at uplift [-] around the circle, 0 degrees at +x and 90 at +y, and the weakest direction."""
    angle = np.radians([*found.angle_deg, found.angle_deg[0]])
    multiplier = [*found.uplift_multiplier, found.uplift_multiplier[0]]
    least = min(found.uplift_multiplier)
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.add_subplot(projection="polar")
        assert isinstance(axes, PolarAxes)
        axes.plot(angle, multiplier, color="#0072b2", label=locale.heading(say("load multiplier λ"), "ratio"))
        weakest = np.radians(found.weakest_deg)
        axes.plot([weakest, weakest], [0.0, least], color=FAIL, linewidth=1.0)
        axes.plot([weakest], [least], "o", markersize=4.5, color=FAIL, label=locale.text(say("weakest direction")))
        axes.set_ylim(0.0, 1.08 * max(found.uplift_multiplier))
        axes.set_rlabel_position((found.weakest_deg + 112.5) % 360.0)
        axes.set_xticks(np.radians([0, 45, 90, 135, 180, 225, 270, 315]))
        axes.set_xticklabels(["+x", "45°", "+y", "135°", "−x", "225°", "−y", "315°"])
        legend_below(figure, columns=2)
        return figure
