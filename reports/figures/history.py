"""Motions over time: one rocking history, and a ground motion beside the motion at the base of a mechanism up the
building.
"""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import CarriedMotion, HistoryResult, HistoryTrace, MechanismResult
from reports.figures.spectrum import frame_logarithmic_spectra
from reports.figures.style import FAIL, INK, MUTED, legend_above, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import quantity, say

ALLOWABLE_COLOUR = "#e69f00"
_MOST_ROTATION = 1.3  # of the rotation axis [-]


def draw_history(
    mechanism: MechanismResult, history: HistoryResult, trace: HistoryTrace, allowable: float | None, locale: Locale
) -> Figure:
    """Draw acceleration [g], also at the base where amplified, and rotation / phi_ov [-] over time [s]."""
    with report_style():
        figure = sheet(2.8, locale)
        ground, rotation = figure.subplots(2, 1, sharex=True, height_ratios=(1, 1.5))
        _motion(ground, trace, locale)
        _rotation(rotation, mechanism, trace)
        _limits(rotation, allowable, locale, two_sided=mechanism.oscillator_negative is not None)
        _peak(rotation, history, locale)
        rotation.set_xlabel(locale.heading(say("time t"), "time"))
        rotation.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        rotation.set_xlim(trace.time_s[0], trace.time_s[-1])
        figure.align_ylabels()
        legend_above(rotation, columns=3)
        return figure


def _motion(axes: Axes, trace: HistoryTrace, locale: Locale) -> None:
    axes.set_ylabel(locale.heading(say("acceleration"), "ground acceleration"))
    if trace.base_acceleration_g is None:
        axes.plot(trace.time_s, trace.ground_acceleration_g, color=MUTED, linewidth=0.6)
        return
    base, ground = locale.text(say("at its base")), locale.text(say("at the ground"))
    axes.plot(trace.time_s, trace.base_acceleration_g, color="#d55e00", linewidth=0.6, label=base)
    axes.plot(trace.time_s, trace.ground_acceleration_g, color=INK, linewidth=0.5, label=ground)
    legend_above(axes, columns=2)


def rotation_ratio(mechanism: MechanismResult, trace: HistoryTrace) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return the rotation over the rigid overturning rotation of the deciding branch [-], signed."""
    turned = np.asarray(trace.rotation_rad, dtype=np.float64)
    negative = mechanism.oscillator_negative or mechanism.oscillator
    both = (mechanism.oscillator.overturning_rad, negative.overturning_rad)
    ahead, behind = mechanism.deciding_overturning_rad or both
    return turned / np.where(turned < 0, behind or ahead, ahead)


def _rotation(axes: Axes, mechanism: MechanismResult, trace: HistoryTrace) -> None:
    values = rotation_ratio(mechanism, trace)
    top = min(_MOST_ROTATION, 1.5 * float(np.max(np.abs(values), initial=0.0)))
    axes.plot(trace.time_s, values, color="#0072b2", linewidth=0.9)
    low = -1.0 if mechanism.oscillator_negative is not None else -0.12
    axes.set_ylim(low * max(top, 0.05), max(top, 0.05) * 1.25)


def _limits(axes: Axes, allowable: float | None, locale: Locale, *, two_sided: bool) -> None:
    sides = (1, -1) if two_sided else (1,)
    lines = [(1.0, FAIL, "-", say("overturning, φₒᵥ"))]
    if allowable is not None:
        name = say("allowable, {ratio} φₒᵥ", ratio=quantity(allowable, "ratio", 3))
        lines.append((allowable, ALLOWABLE_COLOUR, "--", name))
    for height, colour, dash, name in lines:
        for side in sides if height <= max(np.abs(axes.get_ylim())) else ():
            named = locale.text(name) if side > 0 else "_"
            axes.axhline(side * height, color=colour, linestyle=dash, linewidth=1.0, label=named)


def _peak(axes: Axes, history: HistoryResult, locale: Locale) -> None:
    if history.overturning_time_s is not None:
        name = locale.text(say("overturns"))
        axes.axvline(history.overturning_time_s, color=FAIL, linewidth=0.8, linestyle=":", label=name)
    elif history.max_rotation_ratio is not None and history.time_of_max_s is not None:
        signed = np.copysign(abs(history.max_rotation_ratio), history.max_rotation_rad or 0.0)
        axes.plot(history.time_of_max_s, signed, "o", color=INK, markersize=4, label=locale.text(say("largest")))


_BASE_COLOUR = "#d55e00"
_NUMBERED_PERIODS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0)
Series = tuple[float, ...]


def draw_amplification(motion: CarriedMotion, locale: Locale) -> Figure:
    """Draw acceleration [g] over time [s] and response spectra [g] over period [s], at the ground and at the base."""
    with report_style():
        figure = sheet(3.4, locale)
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
        legend_below(figure, columns=2)
        return figure


def _draw_pair(axes: Axes, across: Series, ground: Series, base: Series, linewidth: float, locale: Locale) -> None:
    axes.plot(
        across, base, color=_BASE_COLOUR, linewidth=linewidth, label=locale.text(say("at the base of the mechanism"))
    )
    axes.plot(across, ground, color=INK, linewidth=linewidth, label=locale.text(say("at the ground")))
