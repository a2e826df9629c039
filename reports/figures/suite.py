"""The suite of records beside its target, with the limits that the deciding code sets to the mean."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import GroundMotionResult, RecordResult, RequirementResult, Results
from reports.figures.spectrum import frame_spectra
from reports.figures.style import FAIL, GRID, HALF, INK, MUTED, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Verbatim, quantity, say
from spectra.arrays import FloatArray

SHORTEST = 0.02  # s
PERIODS = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
CODES: Mapping[str, str] = {
    "asce43-05": "ASCE 43-05",
    "asce41-13": "ASCE 7-16",
    "ntc2018": "NTC 2018",
    "dmi2008": "NTC 2018",
    "ec8": "EN 1998-1:2004",
    "nzsee2017": "NZS 1170.5:2004",
}
"""The code whose rules a suite is held to, by the basis of the verdict."""
RATIO = "ratio of mean spectrum to target"


def draw(results: Results, locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s]: records, their mean, the target and the limits of the code.

    Raises ValueError for results without a suite.
    """
    if results.ground_motion is None:
        raise ValueError("these results have no suite of records")
    return beside_target(results.ground_motion, results.records, limits(results), locale)


def beside_target(
    motion: GroundMotionResult,
    records: Sequence[RecordResult],
    rules: Sequence[RequirementResult],
    locale: Locale,
    *,
    width: float = HALF,
) -> Figure:
    """Draw the spectra of a suite of records beside their target.

    Parameters
    ----------
    motion : mean and target of the suite
    records : as scaled
    rules : limits of the ratio of the mean to the target; without any the range that was fitted is shown
    locale : of the labels
    width : of the figure [in]
    """
    with report_style():
        figure = sheet(2.6, locale, width=width)
        axes = figure.subplots()
        if not rules:
            fitted = locale.text(say("range fitted"))
            axes.axvspan(motion.from_s, motion.to_s, color=GRID, alpha=0.45, linewidth=0, label=fitted)
        _records(axes, records, locale)
        for rule in rules:
            _limit(axes, motion, rule, locale)
        _line(axes, motion, motion.target_g, INK, 1.8, locale.text(say("target")))
        _line(axes, motion, motion.mean_g, FAIL, 1.3, locale.text(say("mean")))
        dress(axes, max(motion.period_s), locale)
        legend_below(figure, columns=2)
        return figure


def limits(results: Results) -> tuple[RequirementResult, ...]:
    """Return the limits to the ratio of the mean to the target, of the code that decides; none without one."""
    code = None if results.verdict is None else CODES.get(results.verdict.basis)
    every = () if results.ground_motion is None else results.ground_motion.requirements
    return tuple(each for each in every if each.code == code and each.what.endswith(RATIO) and each.from_s is not None)


def dress(axes: Axes, longest: float, locale: Locale) -> None:
    """Label the axes of response spectra over a logarithmic axis of periods [s]."""
    axes.set_xscale("log")
    frame_spectra(axes, (SHORTEST, longest), locale)
    shown = [period for period in PERIODS if period <= longest]
    axes.set_xticks(shown, [locale.number(period) for period in shown])
    axes.set_xticks((), minor=True)


def _records(axes: Axes, records: Sequence[RecordResult], locale: Locale) -> None:
    for place, record in enumerate(records):
        name = locale.text(say("records")) if place == 0 else "_"
        spectrum = record.spectrum
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=MUTED, linewidth=0.4, alpha=0.7, label=name)


def _limit(axes: Axes, motion: GroundMotionResult, rule: RequirementResult, locale: Locale) -> None:
    """Draw a limit over the range of periods to which it applies."""
    period, target = np.array(motion.period_s), np.array(motion.target_g)
    inside = (period >= (rule.from_s or 0.0)) & (period <= (rule.to_s or np.inf))
    share, code = quantity(100.0 * rule.limit, "percent", 3), Verbatim(f"{rule.code}, {rule.clause}")
    words = say("least, {share} ({code})", share=share, code=code)
    if rule.sense == "<=":
        words = say("most, {share} ({code})", share=share, code=code)
    dash = ":" if rule.sense == ">=" else "-."
    limit = rule.limit * target[inside]
    axes.plot(period[inside], limit, dash, color="#0072b2", linewidth=1.0, label=locale.text(words))


def _line(
    axes: Axes, motion: GroundMotionResult, values: Sequence[float] | FloatArray, colour: str, width: float, name: str
) -> None:
    period = np.array(motion.period_s)
    shown = period >= SHORTEST
    axes.plot(period[shown], np.array(values)[shown], color=colour, linewidth=width, label=name)
