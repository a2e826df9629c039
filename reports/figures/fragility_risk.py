"""Which intensities make up the annual rate of a state: the hazard of the site, and the share of each interval."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from assess.results.fragility import HazardResult, RiskResult
from reports.figures.style import FAIL, INK, legend_below, report_style, sheet
from reports.figures.ticks import LogTicks, number_by_decades
from reports.language.locale import Locale
from reports.language.texts import say
from reports.measures import PERCENT, measure_text

BARS = "#56b4e9"
WIDE = 10.0  # last intensity over the first, from which on the axis is logarithmic
DECADES = 9  # of the axis of rates, at most


def draw(risk: RiskResult, hazard: HazardResult | None, locale: Locale) -> Figure:
    """Draw the annual rate of exceedance above, and below it the contributions [%] over the same intensities."""
    with report_style():
        figure = sheet(2.7, locale)
        above, below = figure.subplots(2, 1, sharex=True)
        if hazard is not None:
            rates = np.array(hazard.annual_rate)
            shown = rates > 0.0
            words = locale.text(say("hazard: ground motions that exceed the intensity"))
            above.plot(
                np.array(hazard.intensity)[shown], rates[shown], color=INK, marker="o", markersize=3.0, label=words
            )
        above.axhline(risk.annual_rate, color=FAIL, linewidth=1.0, label=locale.text(say("rate of the state")))
        if risk.with_epistemic is not None:
            words = locale.text(say("with epistemic dispersion"))
            above.axhline(risk.with_epistemic, color=FAIL, linewidth=1.0, linestyle=":", label=words)
        if risk.target_rate is not None:
            target = locale.text(say("target"))
            above.axhline(risk.target_rate, color=FAIL, linewidth=1.0, linestyle="--", label=target)
        above.set_yscale("log")
        above.yaxis.set_major_locator(LogLocator(numticks=DECADES))
        above.yaxis.set_minor_locator(NullLocator())
        above.yaxis.set_major_formatter(LogTicks(locale))
        above.set_ylabel(locale.heading(say("annual rate"), "annual rate"))
        edges = np.array(risk.intensity)
        below.bar(
            edges[:-1], PERCENT * np.array(risk.contribution), np.diff(edges), align="edge", color=BARS,
            edgecolor="white", linewidth=0.5,
        )  # fmt: skip
        below.set_ylabel(locale.heading(say("share of the rate"), "percent"))
        below.set_ylim(bottom=0.0)
        if edges[0] > 0.0 and edges[-1] / edges[0] > WIDE:
            below.set_xscale("log")
            number_by_decades(below.xaxis, locale)
        below.set_xlim(edges[0], edges[-1])
        below.set_xlabel(locale.heading(measure_text(risk.measure), risk.measure.dimension))
        legend_below(figure, columns=2)
        return figure
