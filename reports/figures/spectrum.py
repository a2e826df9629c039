"""The site's spectrum and the records scaled to it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from assess.results import RecordResult, SpectrumResult
from reports.figures.style import FAIL, HALF, INK, MUTED, legend_below, record_label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say

LONGEST = 5.0  # end of the axis of periods [s]; results.json has more
NAMED = 7  # more records than this are drawn alike, without names
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#6b4c9a")


def draw(target: SpectrumResult, records: tuple[RecordResult, ...], locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s]: target, each record as scaled, and their geometric mean."""
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.subplots()
        spectra = [(record.id, record.spectrum) for record in records]
        curves = [(name, each.period_s, each.acceleration_g) for name, each in spectra]
        draw_records(axes, curves, locale, named=any(record.path for record in records))
        _mean(axes, records, locale)
        axes.plot(target.period_s, target.acceleration_g, color=INK, linewidth=1.8, label=locale.text(say("target")))
        frame_spectra(axes, (0.0, min(max(target.period_s, default=1.0), LONGEST)), locale)
        legend_below(figure, columns=2)
        return figure


def draw_records(
    axes: Axes, records: Sequence[tuple[str, ArrayLike, ArrayLike]], locale: Locale, *, named: bool = True
) -> None:
    """Draw the spectra of records, each by its name, periods [s] and ordinates [g].

    named : whether each has a colour and its name; many are drawn alike in any case
    """
    named = named and len(records) <= NAMED
    for place, (record, period, ordinates) in enumerate(records):
        name = record_label(record, 24) if named else (locale.text(say("records")) if place == 0 else "_")
        colour = COLOURS[place] if named else MUTED
        axes.plot(period, ordinates, color=colour, linewidth=0.8, alpha=0.8, label=name)


def frame_spectra(axes: Axes, periods: tuple[float, float], locale: Locale) -> None:
    """Name the axes of response spectra over a range of periods [s]."""
    axes.set(xlabel=locale.heading(say("period T"), "time"), xlim=periods, ylim=(0.0, None))
    axes.set_ylabel(locale.heading(say("pseudo-acceleration Sₐ"), "ground acceleration"))


def _mean(axes: Axes, records: tuple[RecordResult, ...], locale: Locale) -> None:
    grids = {record.spectrum.period_s for record in records}
    if len(records) < 2 or len(grids) != 1:
        return
    ordinates = np.array([record.spectrum.acceleration_g for record in records])
    name = locale.text(say("geometric mean"))
    mean = np.exp(np.mean(np.log(np.maximum(ordinates, 1e-12)), axis=0))
    axes.plot(records[0].spectrum.period_s, mean, color=FAIL, linewidth=1.4, linestyle="--", label=name)
