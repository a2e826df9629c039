"""The site's spectrum and the records scaled to it."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import RecordResult, SpectrumResult
from reports.figures.style import FAIL, INK, MUTED, record_label, report_style, sheet

LONGEST = 5.0  # end of the axis of periods [s]; results.json has more
NAMED = 7  # more records than this are drawn alike, without names
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#6b4c9a")


def draw(target: SpectrumResult, records: tuple[RecordResult, ...]) -> Figure:
    """Draw pseudo-acceleration [g] over period [s]: target, each record as scaled, and their geometric mean."""
    with report_style():
        figure = sheet(3.3)
        axes = figure.subplots()
        _records(axes, records)
        axes.plot(target.period_s, target.acceleration_g, color=INK, linewidth=2.2, label="target")
        axes.set(xlabel="period T [s]", ylabel="pseudo-acceleration Sₐ [g]")
        axes.set_xlim(0.0, min(max(target.period_s, default=1.0), LONGEST))
        axes.set_ylim(bottom=0.0)
        axes.legend(loc="upper right", ncols=2)
        return figure


def _records(axes: Axes, records: tuple[RecordResult, ...]) -> None:
    named = len(records) <= NAMED
    for place, record in enumerate(records):
        colour = COLOURS[place] if named else MUTED
        name = record_label(record.id, 32) if named else (f"{len(records)} records" if place == 0 else "_")
        spectrum = record.spectrum
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=colour, linewidth=0.7, alpha=0.8, label=name)
    _mean(axes, records)


def _mean(axes: Axes, records: tuple[RecordResult, ...]) -> None:
    grids = {record.spectrum.period_s for record in records}
    if len(records) < 2 or len(grids) != 1:
        return
    ordinates = np.array([record.spectrum.acceleration_g for record in records])
    mean = np.exp(np.mean(np.log(np.maximum(ordinates, 1e-12)), axis=0))
    axes.plot(records[0].spectrum.period_s, mean, color=FAIL, linewidth=1.8, linestyle="--", label="geometric mean")
