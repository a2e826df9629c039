"""Response spectra of records."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from reports.figures.spectrum import draw_records
from reports.figures.style import legend_below, report_style, sheet
from reports.figures.suite import dress
from reports.language.locale import Locale


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
        draw_records(axes, [(name, period, each) for name, each in zip(names, ordinates, strict=True)], locale)
        dress(axes, float(period[-1]), locale)
        legend_below(figure, columns=3)
        return figure
