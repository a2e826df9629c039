"""Response spectra: of the site, of records, and of a suite beside its target with the limits of the deciding code."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from assess.codes.bases import BASES
from assess.results import GroundMotionResult, RecordResult, RequirementResult, Results, SpectrumResult
from reports.figures.style import FAIL, GRID, HALF, INK, MUTED, label, legend_below, record_label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Verbatim, quantity, say
from reports.language.value_names import corners
from spectra.arrays import FloatArray

LONGEST_PERIOD = 5.0  # end of the axis of periods [s]; results.json has more
MOST_NAMED = 7  # more records than this are drawn alike, without names
RECORD_COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#6b4c9a")


def draw_scaled_spectra(target: SpectrumResult, records: tuple[RecordResult, ...], locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s]: target, each record as scaled, and their geometric mean."""
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.subplots()
        spectra = [(record.id, record.spectrum) for record in records]
        curves = [(name, each.period_s, each.acceleration_g) for name, each in spectra]
        _draw_records(axes, curves, locale, named=any(record.path for record in records))
        _draw_geometric_mean(axes, records, locale)
        axes.plot(target.period_s, target.acceleration_g, color=INK, linewidth=1.8, label=locale.text(say("target")))
        _frame_spectra(axes, (0.0, min(max(target.period_s, default=1.0), LONGEST_PERIOD)), locale)
        legend_below(figure, columns=2)
        return figure


LONGEST_DESIGN_PERIOD = 4.0  # s: of the period axis, as far as most codes give their spectra


def draw_design_spectrum(spectrum: SpectrumResult, locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s], with the corner periods marked.

    Parameters
    ----------
    spectrum : of the site
    locale : of the labels
    """
    end = min(LONGEST_DESIGN_PERIOD, max(spectrum.period_s))
    with report_style():
        figure = sheet(2.8, locale)
        axes = figure.subplots()
        for corner in corners(spectrum.parameters):
            if corner <= end:
                axes.axvline(corner, color=MUTED, linewidth=0.6, linestyle=":")
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=INK, linewidth=1.8)
        damping = quantity(100.0 * spectrum.damping, "percent", 3)
        title = say("{clause}, damping {damping}", clause=Verbatim(spectrum.clause), damping=damping)
        axes.set_title(label(locale.text(title), 90))
        _frame_spectra(axes, (0.0, end), locale)
        return figure


SHORTEST_PERIOD = 0.02  # s
NUMBERED_PERIODS = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
RATIO = "ratio of mean spectrum to target"


def draw_suite(results: Results, locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s]: records, their mean, the target and the limits of the code.

    Raises ValueError for results without a suite.
    """
    if results.ground_motion is None:
        raise ValueError("these results have no suite of records")
    return draw_beside_target(results.ground_motion, results.records, mean_limits(results), locale)


def draw_beside_target(
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
        _draw_suite_records(axes, records, locale)
        for rule in rules:
            _draw_limit(axes, motion, rule, locale)
        _draw_suite_curve(axes, motion, motion.target_g, INK, 1.8, locale.text(say("target")))
        _draw_suite_curve(axes, motion, motion.mean_g, FAIL, 1.3, locale.text(say("mean")))
        frame_logarithmic_spectra(axes, max(motion.period_s), locale)
        legend_below(figure, columns=2)
        return figure


def suite_code(results: Results) -> str:
    """Return the code whose rules the suite is held to, that of the basis of the verdict; empty without one."""
    basis = None if results.verdict is None else BASES.get(results.verdict.basis)
    return "" if basis is None else basis.suite_code


def mean_limits(results: Results) -> tuple[RequirementResult, ...]:
    """Return the limits to the ratio of the mean to the target, of the code that decides; none without one."""
    code = suite_code(results)
    every = () if results.ground_motion is None else results.ground_motion.requirements
    return tuple(each for each in every if each.code == code and each.what.endswith(RATIO) and each.from_s is not None)


def frame_logarithmic_spectra(axes: Axes, longest: float, locale: Locale) -> None:
    """Label the axes of response spectra over a logarithmic axis of periods [s]."""
    axes.set_xscale("log")
    _frame_spectra(axes, (SHORTEST_PERIOD, longest), locale)
    shown = [period for period in NUMBERED_PERIODS if period <= longest]
    axes.set_xticks(shown, [locale.number(period) for period in shown])
    axes.set_xticks((), minor=True)


def draw_record_spectra(
    names: Sequence[str], period: NDArray[np.float64], ordinates: NDArray[np.float64], locale: Locale
) -> Figure:
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
        _draw_records(axes, [(name, period, each) for name, each in zip(names, ordinates, strict=True)], locale)
        frame_logarithmic_spectra(axes, float(period[-1]), locale)
        legend_below(figure, columns=3)
        return figure


def _draw_records(
    axes: Axes, records: Sequence[tuple[str, ArrayLike, ArrayLike]], locale: Locale, *, named: bool = True
) -> None:
    """Draw the spectra of records, each by its name, periods [s] and ordinates [g].

    named : whether each has a colour and its name; many are drawn alike in any case
    """
    named = named and len(records) <= MOST_NAMED
    for place, (record, period, ordinates) in enumerate(records):
        name = record_label(record, 24) if named else (locale.text(say("records")) if place == 0 else "_")
        colour = RECORD_COLOURS[place] if named else MUTED
        axes.plot(period, ordinates, color=colour, linewidth=0.8, alpha=0.8, label=name)


def _frame_spectra(axes: Axes, periods: tuple[float, float], locale: Locale) -> None:
    """Name the axes of response spectra over a range of periods [s]."""
    axes.set(xlabel=locale.heading(say("period T"), "time"), xlim=periods, ylim=(0.0, None))
    axes.set_ylabel(locale.heading(say("pseudo-acceleration Sₐ"), "ground acceleration"))


def _draw_geometric_mean(axes: Axes, records: tuple[RecordResult, ...], locale: Locale) -> None:
    grids = {record.spectrum.period_s for record in records}
    if len(records) < 2 or len(grids) != 1:
        return
    ordinates = np.array([record.spectrum.acceleration_g for record in records])
    name = locale.text(say("geometric mean"))
    mean = np.exp(np.mean(np.log(np.maximum(ordinates, 1e-12)), axis=0))
    axes.plot(records[0].spectrum.period_s, mean, color=FAIL, linewidth=1.4, linestyle="--", label=name)


def _draw_suite_records(axes: Axes, records: Sequence[RecordResult], locale: Locale) -> None:
    for place, record in enumerate(records):
        name = locale.text(say("records")) if place == 0 else "_"
        spectrum = record.spectrum
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=MUTED, linewidth=0.4, alpha=0.7, label=name)


def _draw_limit(axes: Axes, motion: GroundMotionResult, rule: RequirementResult, locale: Locale) -> None:
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


def _draw_suite_curve(
    axes: Axes, motion: GroundMotionResult, values: Sequence[float] | FloatArray, colour: str, width: float, name: str
) -> None:
    period = np.array(motion.period_s)
    shown = period >= SHORTEST_PERIOD
    axes.plot(period[shown], np.array(values)[shown], color=colour, linewidth=width, label=name)
