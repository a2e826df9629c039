"""Response spectra of records."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from reports.figures.spectrum import COLOURS, NAMED
from reports.figures.style import MUTED, legend_below, record_label, report_style, sheet
from reports.figures.suite import dress
from reports.language.locale import Locale
from reports.language.texts import say


def draw(names: Sequence[str], period: NDArray[np.float64], ordinates: NDArray[np.float64], locale: Locale) -> Figure:
    """Draw response spectra over a logarithmic axis of periods; more than seven records alike, without names.

    Parameters
    ----------
    names : of the records [n]
    period : [k] [s]
    ordinates : pseudo-accelerations [n, k] [g]
    """
    with report_style():
        figure = sheet(3.0, locale)
        axes = figure.subplots()
        _lines(axes, names, period, ordinates, locale)
        dress(axes, float(period[-1]), locale)
        legend_below(figure, columns=3)
        return figure


def _lines(
    axes: Axes, names: Sequence[str], period: NDArray[np.float64], ordinates: NDArray[np.float64], locale: Locale
) -> None:
    named = len(names) <= NAMED
    for place, (name, of) in enumerate(zip(names, ordinates, strict=True)):
        name_shown = record_label(name, 24) if named else (locale.text(say("records")) if place == 0 else "_")
        axes.plot(period, of, color=COLOURS[place] if named else MUTED, linewidth=0.8, alpha=0.8, label=name_shown)
