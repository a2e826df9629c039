"""Overturning envelopes: the map of one mechanism, and the lower bounds of all with the critical one (thesis 3.11)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from assess.results import EnvelopeResult, RecordResult, Results
from assess.results.mechanism import CriticalBand
from reports.figures.style import (
    FAIL,
    INK,
    MUTED,
    Pen,
    label,
    legend_below,
    mechanism_pens,
    number_by_decades,
    report_style,
    sheet,
)
from reports.language.locale import Locale
from reports.language.texts import say
from reports.titles import mechanism_number, numbered_title
from spectra.arrays import FloatArray

PULSE = say("frequency of the pulse")
ROCKS, OVERTURNS = "#e7edf3", "#f2c1ad"
BEYOND = 1.25  # of the highest frequency with a bound, the end of the axis
WIDE = 0.05  # of the axis: a band that can hold its name


def draw_envelope(one: EnvelopeResult, records: Sequence[RecordResult], locale: Locale) -> Figure:
    """Draw the outcome of pulses [g] over frequency [Hz]: white at rest, grey rocking, red overturned."""
    frequency, amplitude = np.array(one.frequency_hz), np.array(one.amplitude_g)
    with report_style():
        figure = sheet(2.7, locale)
        axes = figure.subplots()
        top = float(amplitude[-1])
        axes.fill_between(frequency, np.minimum(one.uplift_g, top), top, color=ROCKS, linewidth=0.0)
        fallen = cast("Any", _overturning_rectangles(one, frequency, amplitude))
        axes.add_collection(
            PolyCollection(fallen, facecolor=OVERTURNS, edgecolor=OVERTURNS, linewidth=0.2), autolim=False
        )
        axes.plot(frequency, one.uplift_g, "--", color=MUTED, linewidth=0.9, label=locale.text(say("rocking starts")))
        least = locale.text(say("least pulse that overturns"))
        axes.plot(frequency, _numbers(one.lower_bound_g), color=FAIL, label=least)
        _dots(axes, records, frequency, amplitude, locale)
        _frame(axes, frequency, _reach([one]), top, locale)
        axes.set_xlabel(locale.heading(PULSE, "frequency"))
        axes.set_ylabel(locale.heading(say("peak acceleration of the pulse"), "ground acceleration"))
        legend_below(figure, columns=3)
        return figure


def _overturning_rectangles(one: EnvelopeResult, frequency: FloatArray, amplitude: FloatArray) -> FloatArray:
    """Return rectangles [k, 4, 2] of the pulses that overturn: at each frequency, one for each run of amplitudes."""
    f, a = _between(frequency), _between(amplitude)
    found = []
    for column, row in enumerate(np.array(one.overturned, dtype=np.int64)):
        steps = np.flatnonzero(np.diff(np.r_[0, row, 0]))
        for first, last in steps.reshape(-1, 2):
            left, right, low, high = f[column], f[column + 1], a[first], a[last]
            found.append([(left, low), (right, low), (right, high), (left, high)])
    return np.array(found, dtype=np.float64).reshape(-1, 4, 2)


def _between(values: FloatArray) -> FloatArray:
    """Return where the cell of each value [n] ends and the next begins [n + 1]."""
    return np.concatenate([values[:1], 0.5 * (values[1:] + values[:-1]), values[-1:]])


def _dots(
    axes: Axes, records: Sequence[RecordResult], frequency: FloatArray, amplitude: FloatArray, locale: Locale
) -> None:
    """Draw the best pulse within each record, as the record is scaled, where the map shows its place."""
    found = [record.primary_pulses[0] for record in records if record.primary_pulses]
    inside = [
        pulse for pulse in found
        if frequency[0] <= pulse.frequency_hz <= frequency[-1] and pulse.amplitude_g <= amplitude[-1]
    ]  # fmt: skip
    if inside:
        at = [pulse.frequency_hz for pulse in inside], [pulse.amplitude_g for pulse in inside]
        axes.plot(*at, "o", color=INK, markersize=3, label=locale.text(say("primary pulses of the records")))


def draw_envelope_bounds(results: Results, locale: Locale) -> Figure:
    """Draw the least pulse [g] that overturns each mechanism over frequency [Hz], and below it the critical one.

    Mechanisms that differ by their joints alone share a colour. Raises ValueError where none were compared.
    """
    critical = results.critical
    if critical is None:
        raise ValueError("these results compare no envelopes")
    mapped = [(each.name, each.envelope) for each in results.mechanisms if each.envelope is not None]
    pens = mechanism_pens(results)
    frequency = np.array(critical.frequency_hz)
    with report_style():
        figure = sheet(3.0 + 0.14 * -(-len(mapped) // 3), locale)
        axes, band = figure.subplots(2, 1, sharex=True, height_ratios=(14, 1))
        for name, one in mapped:
            ink, named = pens[name], label(locale.text(numbered_title(results, name)), 38)
            lowest = _numbers(one.lower_bound_g)
            axes.plot(frequency, lowest, ink.dash, color=ink.colour, linewidth=ink.width, label=named)
        least = _numbers(critical.lower_bound_g)
        axes.plot(frequency, least, color=INK, linewidth=3.0, alpha=0.25, label=locale.text(say("least of all")))
        every = [one for _, one in mapped]
        _frame(axes, frequency, _reach(every), min(one.amplitude_g[-1] for one in every), locale)
        axes.set_ylabel(locale.heading(say("least pulse that overturns"), "ground acceleration"))
        for part in critical.bands:
            if part.mechanism is not None:
                _band(band, part, pens[part.mechanism], mechanism_number(results, part.mechanism), axes.get_xlim())
        band.set_yticks([])
        band.set_ylabel(locale.text(say("critical")), rotation=0, ha="right", va="center")
        band.set_xlabel(locale.heading(PULSE, "frequency"))
        band.grid(visible=False)
        legend_below(figure, columns=3, axes=axes)
        return figure


def _band(axes: Axes, part: CriticalBand, ink: Pen, number: str, span: tuple[float, float]) -> None:
    """Draw the range of frequencies over which a mechanism is critical, numbered where there is room."""
    axes.axvspan(part.from_hz, part.to_hz, facecolor=ink.colour, edgecolor="white", linewidth=0.4)
    if part.to_hz - part.from_hz > WIDE * (span[1] - span[0]):
        box = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
        axes.text(0.5 * (part.from_hz + part.to_hz), 0.5, number, ha="center", va="center", fontsize=6, bbox=box)


def _reach(mapped: Sequence[EnvelopeResult]) -> float:
    """Return the highest frequency to show: a little beyond the last bound, or the end of the range."""
    bounds = (pair for one in mapped for pair in zip(one.frequency_hz, one.lower_bound_g, strict=True))
    known = [frequency for frequency, bound in bounds if bound is not None]
    whole = mapped[0].frequency_hz
    return min(BEYOND * max(known), whole[-1]) if known and max(known) > whole[0] else whole[-1]


def _frame(axes: Axes, frequency: FloatArray, reach: float, top: float, locale: Locale) -> None:
    axes.set_xlim(frequency[0], reach)
    axes.set_ylim(0.0, top)
    if frequency[-1] / frequency[0] > 2.0 and np.ptp(np.diff(frequency)) > 1e-6 * frequency[-1]:
        axes.set_xscale("log")
        number_by_decades(axes.xaxis, locale)


def _numbers(values: Sequence[float | None]) -> FloatArray:
    return np.array(values, dtype=np.float64)
