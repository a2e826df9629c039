"""The site's spectrum and the records scaled to it."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import RecordResult, SpectrumResult
from reports.figures.style import FAIL, HALF, INK, MUTED, legend_below, record_label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say

LONGEST = 5.0  # end of the axis of periods [s]; results.json has more
NAMED = 7  # more records than this, and artificial ones, are drawn alike, without names
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#6b4c9a")


def draw(target: SpectrumResult, records: tuple[RecordResult, ...], locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s]: target, each record as scaled, and their geometric mean."""
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.subplots()
        _records(axes, records, locale)
        axes.plot(target.period_s, target.acceleration_g, color=INK, linewidth=1.8, label=locale.text(say("target")))
        axes.set_xlabel(locale.heading(say("period T"), "time"))
        axes.set_ylabel(locale.heading(say("pseudo-acceleration Sₐ"), "ground acceleration"))
        axes.set_xlim(0.0, min(max(target.period_s, default=1.0), LONGEST))
        axes.set_ylim(bottom=0.0)
        legend_below(figure, columns=2)
        return figure


def _records(axes: Axes, records: tuple[RecordResult, ...], locale: Locale) -> None:
    named = len(records) <= NAMED and any(record.path for record in records)
    for place, record in enumerate(records):
        colour = COLOURS[place] if named else MUTED
        name = record_label(record.id, 24) if named else (locale.text(say("records")) if place == 0 else "_")
        spectrum = record.spectrum
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=colour, linewidth=0.7, alpha=0.8, label=name)
    _mean(axes, records, locale)


def _mean(axes: Axes, records: tuple[RecordResult, ...], locale: Locale) -> None:
    grids = {record.spectrum.period_s for record in records}
    if len(records) < 2 or len(grids) != 1:
        return
    ordinates = np.array([record.spectrum.acceleration_g for record in records])
    name = locale.text(say("geometric mean"))
    mean = np.exp(np.mean(np.log(np.maximum(ordinates, 1e-12)), axis=0))
    axes.plot(records[0].spectrum.period_s, mean, color=FAIL, linewidth=1.4, linestyle="--", label=name)
