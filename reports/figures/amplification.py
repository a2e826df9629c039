"""A ground motion and the motion at the base of a mechanism up the building."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import CarriedMotion
from reports.figures.style import INK, legend_below, report_style, sheet
from reports.figures.suite import dress
from reports.language.locale import Locale
from reports.language.texts import say

_BASE = "#d55e00"
_PERIODS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0)
Values = tuple[float, ...]


def draw(motion: CarriedMotion, locale: Locale) -> Figure:
    """Draw acceleration [g] over time [s] and response spectra [g] over period [s], at the ground and at the base."""
    with report_style():
        figure = sheet(3.4, locale)
        time, spectrum = figure.subplots(2, 1, height_ratios=(1.2, 1))
        _pair(time, motion.time_s, motion.ground_acceleration_g, motion.base_acceleration_g, 0.6, locale)
        time.set_xlabel(locale.heading(say("time t"), "time"))
        time.set_ylabel(locale.heading(say("acceleration"), "ground acceleration"))
        time.set_xlim(motion.time_s[0], motion.time_s[-1])
        _pair(spectrum, motion.period_s, motion.ground_spectrum_g, motion.base_spectrum_g, 1.2, locale)
        dress(spectrum, motion.period_s[-1], locale)
        spectrum.set_ylabel(locale.heading(say("Sₐ, damping 5 %"), "ground acceleration"))
        spectrum.set_xticks(_PERIODS, labels=[locale.number(period) for period in _PERIODS])
        spectrum.set_xlim(motion.period_s[0], motion.period_s[-1])
        legend_below(figure, columns=2)
        return figure


def _pair(axes: Axes, across: Values, ground: Values, base: Values, linewidth: float, locale: Locale) -> None:
    axes.plot(across, base, color=_BASE, linewidth=linewidth, label=locale.text(say("at the base of the mechanism")))
    axes.plot(across, ground, color=INK, linewidth=linewidth, label=locale.text(say("at the ground")))
