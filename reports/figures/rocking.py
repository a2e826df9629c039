"""Rocking: a history, the ground motion carried up the building, and overturning envelopes of pulses (thesis 3.11)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure

from assess.results import (
    CarriedMotion,
    EnvelopeResult,
    HistoryResult,
    HistoryTrace,
    MechanismResult,
    RecordResult,
    Results,
)
from assess.results.mechanism import CriticalBand
from reports.figures import style
from reports.figures.spectrum import frame_logarithmic_spectra
from reports.language.locale import Locale
from reports.language.texts import quantity, say
from reports.mechanisms import mechanism_number, numbered_title
from spectra.arrays import FloatArray

ALLOWABLE_COLOUR = "#e69f00"
_MOST_ROTATION = 1.3  # of the rotation axis [-]


def draw_history(
    mechanism: MechanismResult, history: HistoryResult, trace: HistoryTrace, allowable: float | None, locale: Locale
) -> Figure:
    """Draw acceleration [g], also at the base where amplified, and rotation / phi_ov [-] over time [s]."""
    if history.max_rotation_ratio is None or history.time_of_max_s is None:
        largest = None
    else:
        signed = float(np.copysign(abs(history.max_rotation_ratio), history.max_rotation_rad or 0.0))
        largest = history.time_of_max_s, signed
    course = RotationCourse(
        rotation_ratio(mechanism, trace),
        largest,
        history.overturning_time_s,
        two_sided=mechanism.oscillator_negative is not None,
    )
    return draw_course(trace, course, allowable, locale)


@dataclass(frozen=True)
class RotationCourse:
    """The rotation of a history over that which overturns.

    ratio : at the instants of its trace [n] [-]; two_sided : whether the mechanism rocks to both sides
    largest : when, and what [s], [-]; None where it overturned; overturns : when [s]; None where it did not
    """

    ratio: FloatArray
    largest: tuple[float, float] | None
    overturns: float | None
    two_sided: bool


def draw_course(trace: HistoryTrace, course: RotationCourse, allowable: float | None, locale: Locale) -> Figure:
    """Draw the acceleration of a trace [g] and the course of its rotation [-] over time [s]."""
    with style.report_style():
        figure = style.sheet(2.8, locale)
        ground, rotation = figure.subplots(2, 1, sharex=True, height_ratios=(1, 1.5))
        _draw_motion(ground, trace, locale)
        _draw_rotation(rotation, course, trace)
        _draw_limits(rotation, allowable, locale, two_sided=course.two_sided)
        _draw_peak(rotation, course, locale)
        rotation.set_xlabel(locale.heading(say("time t"), "time"))
        rotation.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        rotation.set_xlim(trace.time_s[0], trace.time_s[-1])
        figure.align_ylabels()
        style.legend_above(rotation, columns=3)
        return figure


def rotation_ratio(mechanism: MechanismResult, trace: HistoryTrace) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return the rotation over the rigid overturning rotation of the deciding branch [-], signed."""
    turned = np.asarray(trace.rotation_rad, dtype=np.float64)
    negative = mechanism.oscillator_negative or mechanism.oscillator
    both = (mechanism.oscillator.overturning_rad, negative.overturning_rad)
    ahead, behind = mechanism.deciding_overturning_rad or both
    return turned / np.where(turned < 0, behind or ahead, ahead)


_BASE_COLOUR = "#d55e00"
_NUMBERED_PERIODS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0)
Series = tuple[float, ...]


def draw_amplification(motion: CarriedMotion, locale: Locale) -> Figure:
    """Draw acceleration [g] over time [s] and response spectra [g] over period [s], at the ground and at the base."""
    with style.report_style():
        figure = style.sheet(3.4, locale)
        time, spectrum = figure.subplots(2, 1, height_ratios=(1.2, 1))
        _draw_pair(time, motion.time_s, motion.ground_acceleration_g, motion.base_acceleration_g, 0.6, locale)
        time.set_xlabel(locale.heading(say("time t"), "time"))
        time.set_ylabel(locale.heading(say("acceleration"), "ground acceleration"))
        time.set_xlim(motion.time_s[0], motion.time_s[-1])
        _draw_pair(spectrum, motion.period_s, motion.ground_spectrum_g, motion.base_spectrum_g, 1.2, locale)
        frame_logarithmic_spectra(spectrum, motion.period_s[-1], locale)
        spectrum.set_ylabel(locale.heading(say("Sₐ, damping 5 %"), "ground acceleration"))
        spectrum.set_xticks(_NUMBERED_PERIODS, labels=[locale.number(period) for period in _NUMBERED_PERIODS])
        spectrum.set_xlim(motion.period_s[0], motion.period_s[-1])
        style.legend_below(figure, columns=2)
        return figure


PULSE = say("frequency of the pulse")
ROCKS, OVERTURNS = "#e7edf3", "#f2c1ad"
BEYOND_LAST_BOUND = 1.25  # of the highest frequency with a bound, the end of the axis
WIDE_BAND = 0.05  # of the axis: a band that can hold its name


def draw_envelope(one: EnvelopeResult, records: Sequence[RecordResult], locale: Locale) -> Figure:
    """Draw the outcome of pulses [g] over frequency [Hz]: white at rest, grey rocking, red overturned."""
    frequency, amplitude = np.array(one.frequency_hz), np.array(one.amplitude_g)
    with style.report_style():
        figure = style.sheet(2.7, locale)
        axes = figure.subplots()
        top = float(amplitude[-1])
        axes.fill_between(frequency, np.minimum(one.uplift_g, top), top, color=ROCKS, linewidth=0.0)
        fallen = cast("Any", _overturning_rectangles(one, frequency, amplitude))
        axes.add_collection(
            PolyCollection(fallen, facecolor=OVERTURNS, edgecolor=OVERTURNS, linewidth=0.2), autolim=False
        )
        axes.plot(
            frequency, one.uplift_g, "--", color=style.MUTED, linewidth=0.9, label=locale.text(say("rocking starts"))
        )
        least = locale.text(say("least pulse that overturns"))
        axes.plot(frequency, _numbers(one.lower_bound_g), color=style.FAIL, label=least)
        _draw_primary_pulses(axes, records, frequency, amplitude, locale)
        _frame_envelope(axes, frequency, _highest_frequency([one]), top, locale)
        axes.set_xlabel(locale.heading(PULSE, "frequency"))
        axes.set_ylabel(locale.heading(say("peak acceleration of the pulse"), "ground acceleration"))
        style.legend_below(figure, columns=3)
        return figure


def draw_envelope_bounds(results: Results, locale: Locale) -> Figure:
    """Draw the least pulse [g] that overturns each mechanism over frequency [Hz], and below it the critical one.

    Mechanisms that differ by their joints alone share a colour. Raises ValueError where none were compared.
    """
    critical = results.critical
    if critical is None:
        raise ValueError("these results compare no envelopes")
    mapped = [(each.name, each.envelope) for each in results.mechanisms if each.envelope is not None]
    pens = style.mechanism_pens(results)
    frequency = np.array(critical.frequency_hz)
    with style.report_style():
        figure = style.sheet(3.0 + 0.14 * -(-len(mapped) // 3), locale)
        axes, band = figure.subplots(2, 1, sharex=True, height_ratios=(14, 1))
        for name, one in mapped:
            ink, named = pens[name], style.label(locale.text(numbered_title(results, name)), 38)
            lowest = _numbers(one.lower_bound_g)
            axes.plot(frequency, lowest, ink.dash, color=ink.colour, linewidth=ink.width, label=named)
        least = _numbers(critical.lower_bound_g)
        axes.plot(frequency, least, color=style.INK, linewidth=3.0, alpha=0.25, label=locale.text(say("least of all")))
        every = [one for _, one in mapped]
        _frame_envelope(axes, frequency, _highest_frequency(every), min(one.amplitude_g[-1] for one in every), locale)
        axes.set_ylabel(locale.heading(say("least pulse that overturns"), "ground acceleration"))
        for part in critical.bands:
            if part.mechanism is not None:
                _draw_critical_band(
                    band, part, pens[part.mechanism], mechanism_number(results, part.mechanism), axes.get_xlim()
                )
        band.set_yticks([])
        band.set_ylabel(locale.text(say("critical")), rotation=0, ha="right", va="center")
        band.set_xlabel(locale.heading(PULSE, "frequency"))
        band.grid(visible=False)
        style.legend_below(figure, columns=3, axes=axes)
        return figure


def _draw_motion(axes: Axes, trace: HistoryTrace, locale: Locale) -> None:
    axes.set_ylabel(locale.heading(say("acceleration"), "ground acceleration"))
    if trace.base_acceleration_g is None:
        axes.plot(trace.time_s, trace.ground_acceleration_g, color=style.MUTED, linewidth=0.6)
        return
    base, ground = locale.text(say("at its base")), locale.text(say("at the ground"))
    axes.plot(trace.time_s, trace.base_acceleration_g, color="#d55e00", linewidth=0.6, label=base)
    axes.plot(trace.time_s, trace.ground_acceleration_g, color=style.INK, linewidth=0.5, label=ground)
    style.legend_above(axes, columns=2)


def _draw_rotation(axes: Axes, course: RotationCourse, trace: HistoryTrace) -> None:
    top = min(_MOST_ROTATION, 1.5 * float(np.max(np.abs(course.ratio), initial=0.0)))
    axes.plot(trace.time_s, course.ratio, color="#0072b2", linewidth=0.9)
    low = -1.0 if course.two_sided else -0.12
    axes.set_ylim(low * max(top, 0.05), max(top, 0.05) * 1.25)


def _draw_limits(axes: Axes, allowable: float | None, locale: Locale, *, two_sided: bool) -> None:
    sides = (1, -1) if two_sided else (1,)
    lines = [(1.0, style.FAIL, "-", say("overturning, φₒᵥ"))]
    if allowable is not None:
        name = say("allowable, {ratio} φₒᵥ", ratio=quantity(allowable, "ratio", 3))
        lines.append((allowable, ALLOWABLE_COLOUR, "--", name))
    for height, colour, dash, name in lines:
        for side in sides if height <= max(np.abs(axes.get_ylim())) else ():
            named = locale.text(name) if side > 0 else "_"
            axes.axhline(side * height, color=colour, linestyle=dash, linewidth=1.0, label=named)


def _draw_peak(axes: Axes, course: RotationCourse, locale: Locale) -> None:
    if course.overturns is not None:
        name = locale.text(say("overturns"))
        axes.axvline(course.overturns, color=style.FAIL, linewidth=0.8, linestyle=":", label=name)
    elif course.largest is not None:
        axes.plot(*course.largest, "o", color=style.INK, markersize=4, label=locale.text(say("largest")))


def _draw_pair(axes: Axes, across: Series, ground: Series, base: Series, linewidth: float, locale: Locale) -> None:
    axes.plot(
        across, base, color=_BASE_COLOUR, linewidth=linewidth, label=locale.text(say("at the base of the mechanism"))
    )
    axes.plot(across, ground, color=style.INK, linewidth=linewidth, label=locale.text(say("at the ground")))


def _overturning_rectangles(one: EnvelopeResult, frequency: FloatArray, amplitude: FloatArray) -> FloatArray:
    """Return rectangles [k, 4, 2] of the pulses that overturn: at each frequency, one for each run of amplitudes."""
    f, a = _cell_borders(frequency), _cell_borders(amplitude)
    found = []
    for column, row in enumerate(np.array(one.overturned, dtype=np.int64)):
        steps = np.flatnonzero(np.diff(np.r_[0, row, 0]))
        for first, last in steps.reshape(-1, 2):
            left, right, low, high = f[column], f[column + 1], a[first], a[last]
            found.append([(left, low), (right, low), (right, high), (left, high)])
    return np.array(found, dtype=np.float64).reshape(-1, 4, 2)


def _cell_borders(values: FloatArray) -> FloatArray:
    """Return where the cell of each value [n] ends and the next begins [n + 1]."""
    return np.concatenate([values[:1], 0.5 * (values[1:] + values[:-1]), values[-1:]])


def _draw_primary_pulses(
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
        axes.plot(*at, "o", color=style.INK, markersize=3, label=locale.text(say("primary pulses of the records")))


def _draw_critical_band(axes: Axes, part: CriticalBand, ink: style.Pen, number: str, span: tuple[float, float]) -> None:
    """Draw the range of frequencies over which a mechanism is critical, numbered where there is room."""
    axes.axvspan(part.from_hz, part.to_hz, facecolor=ink.colour, edgecolor="white", linewidth=0.4)
    if part.to_hz - part.from_hz > WIDE_BAND * (span[1] - span[0]):
        box = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
        axes.text(0.5 * (part.from_hz + part.to_hz), 0.5, number, ha="center", va="center", fontsize=6, bbox=box)


def _highest_frequency(mapped: Sequence[EnvelopeResult]) -> float:
    """Return the highest frequency to show: a little beyond the last bound, or the end of the range."""
    bounds = (pair for one in mapped for pair in zip(one.frequency_hz, one.lower_bound_g, strict=True))
    known = [frequency for frequency, bound in bounds if bound is not None]
    whole = mapped[0].frequency_hz
    return min(BEYOND_LAST_BOUND * max(known), whole[-1]) if known and max(known) > whole[0] else whole[-1]


def _frame_envelope(axes: Axes, frequency: FloatArray, reach: float, top: float, locale: Locale) -> None:
    axes.set_xlim(frequency[0], reach)
    axes.set_ylim(0.0, top)
    if frequency[-1] / frequency[0] > 2.0 and np.ptp(np.diff(frequency)) > 1e-6 * frequency[-1]:
        axes.set_xscale("log")
        style.number_by_decades(axes.xaxis, locale)


def _numbers(values: Sequence[float | None]) -> FloatArray:
    return np.array(values, dtype=np.float64)
