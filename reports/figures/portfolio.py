"""How the margins of a portfolio are spread."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from reports.figures.style import FAIL, INK, PASS, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say

BIN, LAST = 0.1, 2.0  # margins: width of a bar, and from where all stand in one
HEIGHT = 2.2  # in


def draw_margins(margins: Sequence[float], locale: Locale) -> Figure:
    """Draw the number of projects over their margins [-]; those of 2 and more stand in the last bar."""
    edges = np.linspace(0.0, LAST + BIN, round(LAST / BIN) + 2)
    numbers, _ = np.histogram(np.clip(np.asarray(margins) + 1e-9, 0.0, LAST + BIN / 2), bins=edges)
    with report_style():
        figure = sheet(HEIGHT, locale)
        axes = figure.subplots()
        colours = [FAIL if right <= 1.0 + BIN / 2 else PASS for right in edges[1:]]
        axes.bar(edges[:-1], numbers, width=0.92 * BIN, align="edge", color=colours)
        axes.axvline(1.0, color=INK, linewidth=0.8)
        axes.set_xlim(0.0, LAST + BIN)
        axes.yaxis.set_major_locator(MaxNLocator(integer=True))
        axes.set_xlabel(locale.heading(say("Margin"), "ratio"))
        axes.set_ylabel(locale.text(say("Projects")))
        return figure
