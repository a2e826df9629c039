"""Solved cases at a glance: differences over tolerances by source, and values of the program over those expected."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from assess.results.verification import Standing
from reports.figures.style import FAIL, INK, MUTED, LogTicks, label, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Phrase, say

COLOURS: Mapping[Standing, str] = {
    "published": "#0072b2",
    "derived": "#009e73",
    "own arithmetic": "#e69f00",
    "indicative": "#7f7f7f",
}
STANDINGS: Mapping[Standing, Phrase] = {
    "published": say("published"),
    "derived": say("derived"),
    "own arithmetic": say("own arithmetic"),
    "indicative": say("indicative"),
}
LEAST, MOST = 1e-4, 10.0  # of the axis of differences over tolerances
TICKS = 9  # at most, of an axis of values
ROW = 0.17  # height of a row [in]
LONGEST = 40  # letters of the name of a source


def draw_differences(values: Sequence[tuple[str, Standing, float]], locale: Locale) -> Figure:
    """Draw every difference over its tolerance, a row for each source.

    Parameters
    ----------
    values : name of the source, standing, difference over tolerance [-]
    locale : language of the labels
    """
    rows = {name: place for place, name in enumerate(dict.fromkeys(name for name, _, _ in values))}
    with report_style():
        figure = sheet(0.9 + ROW * len(rows), locale)
        axes = figure.subplots()
        for standing, colour in COLOURS.items():
            own = [(rows[name], share) for name, each, share in values if each == standing]
            if own:
                places, shares = zip(*own, strict=True)
                axes.plot(
                    np.clip(shares, LEAST, MOST), places, linestyle="none", marker="o", markersize=3.0, color=colour,
                    alpha=0.6, markeredgewidth=0.0, label=locale.text(STANDINGS[standing]),
                )  # fmt: skip
        axes.axvline(1.0, color=FAIL, linewidth=1.0, label=locale.text(say("tolerance")))
        axes.set_xscale("log")
        axes.set_xlim(0.8 * LEAST, MOST)
        axes.xaxis.set_major_locator(LogLocator())
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(LogTicks(locale))
        axes.set_yticks(range(len(rows)), [label(name, LONGEST) for name in rows])
        axes.set_ylim(len(rows) - 0.5, -0.5)
        axes.set_xlabel(locale.heading(say("difference over tolerance"), "ratio"))
        legend_below(figure, columns=5)
        return figure


def draw_agreement(pairs: Sequence[tuple[float, float]], locale: Locale) -> Figure:
    """Draw our values over those expected on two logarithmic axes, with the line on which they agree.

    Parameters
    ----------
    pairs : expected and found, each in its own unit
    locale : language of the labels
    """
    shown = np.abs([pair for pair in pairs if 0.0 not in pair]).reshape(-1, 2)
    with report_style():
        figure = sheet(3.4, locale)
        axes = figure.subplots()
        if len(shown):
            ends = np.array([shown.min() / 2.0, shown.max() * 2.0])
            axes.plot(ends, ends, color=MUTED, linewidth=0.8)
            axes.plot(*shown.T, linestyle="none", marker="o", markersize=2.6, color=INK, alpha=0.5, markeredgewidth=0.0)
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_xlim(*ends)
            axes.set_ylim(*ends)
            for axis in (axes.xaxis, axes.yaxis):
                axis.set_major_locator(LogLocator(numticks=TICKS))
                axis.set_minor_locator(NullLocator())
                axis.set_major_formatter(LogTicks(locale))
        axes.set_xlabel(locale.text(say("expected value, each in its unit")))
        axes.set_ylabel(locale.text(say("value of the program")))
        return figure
