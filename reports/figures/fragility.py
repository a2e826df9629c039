"""Fragility: shares of records that reach a state, counted and by the lognormal, over the intensity."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from scipy.stats import norm

from assess.results.fragility import EmpiricalPoint, FragilityCurve, LognormalResult
from reports.figures.style import FAIL, HALF, INK, MECHANISMS, MUTED, label, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Phrase, say
from reports.measures import PERCENT, measure_text, state_text
from spectra.arrays import FloatArray

CURVE, POINT = "#0072b2", 3.5
BEYOND = 1.1  # of the highest intensity needed
NEARLY_ALL = 0.97
SHARE: dict[str, Phrase] = {
    "rocking": say("records that rock"),
    "rotation": say("records that reach the rotation"),
    "overturning": say("records that overturn"),
}
MARKERS = ("o", "s", "^", "D", "v", "P")


def draw(curve: FragilityCurve, locale: Locale) -> Figure:
    """Draw the shares of one state [%] over the intensity: counted with intervals, lognormal with its band, bound."""
    with report_style():
        figure = sheet(2.7, locale)
        axes = figure.subplots()
        names = say("counted, with 95 % interval"), say("the same, most records scaled by more than 4")
        _points(axes, curve.empirical, INK, "o", (locale.text(names[0]), locale.text(names[1])))
        if curve.lognormal is not None:
            _lognormal(axes, curve, curve.lognormal, locale)
        if curve.first is not None:
            x = _intensities(curve)
            words = locale.text(say("bound: first intensity that reaches it"))
            axes.plot(x, PERCENT * _shares(curve.first, x), "--", color=FAIL, label=words)
        _frame(axes, [curve], locale)
        axes.set_ylabel(locale.heading(SHARE[curve.state.name], "percent"))
        legend_below(figure, columns=3)
        return figure


def draw_states(curves: Sequence[FragilityCurve], locale: Locale) -> Figure:
    """Draw the shares of every state [%] over one measure: points, and lognormals as lines."""
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.subplots()
        for place, curve in enumerate(curves):
            colour, marker = MECHANISMS[place % len(MECHANISMS)], MARKERS[place % len(MARKERS)]
            _points(axes, curve.empirical, colour, marker)
            x = _intensities(curve)
            fitted = np.full_like(x, np.nan) if curve.lognormal is None else _shares(curve.lognormal, x)
            named = label(locale.text(state_text(curve.state)), 48)
            axes.plot(x, PERCENT * fitted, color=colour, marker=marker, markevery=[], markersize=POINT, label=named)
        _frame(axes, curves, locale)
        axes.set_ylabel(locale.heading(say("records that reach the state"), "percent"))
        legend_below(figure, columns=1)
        return figure


def _points(
    axes: Axes, points: Sequence[EmpiricalPoint], colour: str, marker: str, names: tuple[str, str] = ("_", "_")
) -> None:
    """Draw the shares that were counted; hollow where most records are scaled by more than 4. names: with intervals."""
    name, hollow_name = names
    if name != "_":
        ends = [[point.intensity] * 2 for point in points], [[PERCENT * p.low, PERCENT * p.high] for p in points]
        for x, y in zip(*ends, strict=True):
            axes.plot(x, y, color=MUTED, linewidth=0.7)
    for hollow in (False, True):
        some = [point for point in points if is_hollow(point) == hollow]
        axes.plot(
            [point.intensity for point in some],
            [PERCENT * point.share for point in some],
            marker,
            color=colour,
            markersize=POINT,
            markerfacecolor="white" if hollow else colour,
            label=hollow_name if hollow and some else name if not hollow else "_",
        )


def _lognormal(axes: Axes, curve: FragilityCurve, fitted: LognormalResult, locale: Locale) -> None:
    if fitted.band is not None:
        low, high = (PERCENT * np.array(side) for side in (fitted.band.low, fitted.band.high))
        words = locale.text(say("95 % band, by earthquake"))
        axes.fill_between(fitted.band.intensity, low, high, color=CURVE, alpha=0.18, linewidth=0.0, label=words)
    x = _intensities(curve)
    axes.plot(x, PERCENT * _shares(fitted, x), color=CURVE, linewidth=1.6, label=locale.text(say("lognormal")))
    for share, at in ((5.0, fitted.five_percent), (50.0, fitted.median)):
        if at <= x[-1]:
            axes.plot([0.0, at, at], [share, share, 0.0], ":", color=CURVE, linewidth=0.8)


def is_hollow(point: EmpiricalPoint) -> bool:
    """Return whether most records of a point are scaled by more than 4."""
    return 2 * point.hollow > point.records


def _frame(axes: Axes, curves: Sequence[FragilityCurve], locale: Locale) -> None:
    axes.set_xlim(0.0, max(map(reach, curves)))
    axes.set_ylim(0.0, 103.0)
    measure = curves[0].measure
    axes.set_xlabel(locale.heading(measure_text(measure), measure.dimension))


def reach(curve: FragilityCurve) -> float:
    """Return the intensity up to which a curve is shown: where nearly all records reach the state, or the last run.

    The last of a cloud's points is no last run; it is shown up to twice the median at least.
    """
    points = [point.intensity for point in curve.empirical]
    needed = [point.intensity for point in curve.empirical if point.share < NEARLY_ALL]
    if curve.lognormal is not None:
        needed.append(curve.lognormal.median * float(np.exp(norm.ppf(NEARLY_ALL) * curve.lognormal.dispersion)))
    if curve.method == "cloud" and curve.lognormal is not None:
        return BEYOND * max([*points, min(max(needed), 2.0 * curve.lognormal.median)])
    return BEYOND * min(max(needed, default=inf), max(points, default=inf)) if needed or points else 1.0


def _intensities(curve: FragilityCurve) -> FloatArray:
    """Return intensities up to the end of the axis."""
    return np.linspace(0.0, reach(curve), 200)


def _shares(fitted: LognormalResult, x: FloatArray) -> FloatArray:
    """Return the share by a lognormal at each intensity, 0 at zero."""
    with np.errstate(divide="ignore"):
        return np.asarray(norm.cdf(np.log(x / fitted.median) / fitted.dispersion), dtype=np.float64)
