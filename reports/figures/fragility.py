"""Fragility: shares of records that reach a state, the runs behind them, and what makes up its annual rate."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

from assess.results.fragility import (
    LARGE_SCALE,
    EmpiricalPoint,
    FragilityCurve,
    HazardResult,
    LognormalResult,
    MeasureResult,
    RecordRunsResult,
    RiskResult,
)
from reports.figures import style
from reports.intensity_measures import PERCENT, measure_text, state_text
from reports.language.locale import Locale
from reports.language.texts import Phrase, say
from spectra.arrays import FloatArray

LOGNORMAL_COLOUR, POINT_SIZE = "#0072b2", 3.5
BEYOND_LAST_POINT = 1.1  # of the highest intensity needed
NEARLY_ALL = 0.97

SHARE_HEADINGS: dict[str, Phrase] = {
    "rocking": say("records that rock"),
    "rotation": say("records that reach the rotation"),
    "overturning": say("records that overturn"),
}
MARKERS = ("o", "s", "^", "D", "v", "P")


def draw_fragility(curve: FragilityCurve, locale: Locale) -> Figure:
    """Draw the shares of one state [%] over the intensity: counted with intervals, lognormal with its band, bound."""
    with style.report_style():
        figure = style.sheet(2.7, locale)
        axes = figure.subplots()
        names = say("counted, with 95 % interval"), say("the same, most records scaled by more than 4")
        _draw_points(axes, curve.empirical, style.INK, "o", (locale.text(names[0]), locale.text(names[1])))
        if curve.lognormal is not None:
            _draw_lognormal(axes, curve, curve.lognormal, locale)
        if curve.first is not None:
            x = _intensities(curve)
            words = locale.text(say("bound: first intensity that reaches it"))
            axes.plot(x, PERCENT * _shares(curve.first, x), "--", color=style.FAIL, label=words)
        _frame_shares(axes, [curve], locale)
        axes.set_ylabel(locale.heading(SHARE_HEADINGS[curve.state.name], "percent"))
        style.legend_below(figure, columns=3)
        return figure


def draw_states(curves: Sequence[FragilityCurve], locale: Locale) -> Figure:
    """Draw the shares of every state [%] over one measure: points, and lognormals as lines."""
    with style.report_style():
        figure = style.sheet(2.6, locale, width=style.HALF)
        _draw_states(figure.subplots(), curves, locale)
        style.legend_below(figure, columns=1)
        return figure


def draw_states_of_each(mechanisms: Mapping[str, Sequence[FragilityCurve]], locale: Locale) -> Figure:
    """Draw what `draw_states` does for each mechanism, by name, one below the other."""
    with style.report_style():
        figure = style.sheet(0.5 + 2.1 * len(mechanisms), locale)
        panels = figure.subplots(len(mechanisms), 1, squeeze=False)[:, 0]
        for axes, (name, curves) in zip(panels, mechanisms.items(), strict=True):
            axes.set_title(style.label(name, 90))
            _draw_states(axes, curves, locale)
        style.legend_below(figure, columns=3)
        return figure


def _draw_states(axes: Axes, curves: Sequence[FragilityCurve], locale: Locale) -> None:
    for place, curve in enumerate(curves):
        colour, marker = style.MECHANISMS[place % len(style.MECHANISMS)], MARKERS[place % len(MARKERS)]
        _draw_points(axes, curve.empirical, colour, marker)
        x = _intensities(curve)
        fitted = np.full_like(x, np.nan) if curve.lognormal is None else _shares(curve.lognormal, x)
        named = style.label(locale.text(state_text(curve.state)), 48)
        axes.plot(x, PERCENT * fitted, color=colour, marker=marker, markevery=[], markersize=POINT_SIZE, label=named)
    _frame_shares(axes, curves, locale)
    axes.set_ylabel(locale.heading(say("records that reach the state"), "percent"))


def intensity_reach(curve: FragilityCurve) -> float:
    """Return the intensity up to which a curve is shown: where nearly all records reach the state, or the last run.

    The last of a cloud's points is no last run; it is shown up to twice the median at least.
    """
    points = [point.intensity for point in curve.empirical]
    needed = [point.intensity for point in curve.empirical if point.share < NEARLY_ALL]
    if curve.lognormal is not None:
        from scipy.special import ndtri

        needed.append(curve.lognormal.median * float(np.exp(ndtri(NEARLY_ALL) * curve.lognormal.dispersion)))
    if curve.method == "cloud" and curve.lognormal is not None:
        return BEYOND_LAST_POINT * max([*points, min(max(needed), 2.0 * curve.lognormal.median)])
    return BEYOND_LAST_POINT * min(max(needed, default=inf), max(points, default=inf)) if needed or points else 1.0


OVERTURNED_HEIGHT = 1.12  # of the largest rotation that did not overturn, where overturned runs are drawn
ISLAND_COLOUR = "#e69f00"
MANY_RECORDS = 30  # records, whose lines are fainter and whose islands are smaller


def draw_record_runs(
    runs: Sequence[RecordRunsResult],
    units: Sequence[float],
    measure: MeasureResult,
    locale: Locale,
    *,
    reach: float,
    width: float = style.WIDTH,
) -> Figure:
    """Draw rotation over that which overturns, over the intensity; overturned runs on a line at the top.

    Parameters
    ----------
    runs : of the records
    units : intensity of each record at scale 1 [unit of the measure]
    measure : of the intensity
    reach : end of the axis [unit of the measure]
    locale : of the labels
    width : of the figure [in]
    """
    with style.report_style():
        figure = style.sheet(2.6, locale, width=width)
        axes = figure.subplots()
        top = OVERTURNED_HEIGHT * max([1.0, *(ratio for run in runs for ratio in run.ratio if ratio is not None)])
        faint = 0.8 if len(runs) <= MANY_RECORDS else 0.45
        pairs = list(zip(runs, units, strict=True))
        for place, (run, unit) in enumerate(pairs):
            name = locale.text(say("a record")) if place == 0 else "_"
            if len(run.scale) > 1:
                axes.plot(*_record_curve(run, unit, top), color=style.MUTED, linewidth=0.4, alpha=faint, label=name)
            else:
                axes.plot(*_record_curve(run, unit, top), "o", color=style.MUTED, markersize=2.5, label=name)
        _mark_first_overturning(axes, pairs, top, locale)
        _draw_islands(axes, pairs, locale)
        axes.axhline(1.0, color=style.FAIL, linewidth=0.7)
        axes.set_ylim(0.0, 1.04 * top)
        axes.set_xlim(0.0, reach)
        axes.set_yticks([0.0, 0.25, 0.5, 0.75, 1.0, top])
        axes.set_yticklabels([*(locale.number(y) for y in (0.0, 0.25, 0.5, 0.75, 1.0)), locale.text(say("overturned"))])
        axes.set_xlabel(locale.heading(measure_text(measure), measure.dimension))
        axes.set_ylabel(locale.heading(say("largest rotation φ/φₒᵥ"), "ratio"))
        style.legend_below(figure, columns=1 if width < style.WIDTH else 2)
        return figure


CONTRIBUTION_COLOUR = "#56b4e9"
LOGARITHMIC_FROM = 10.0  # last intensity over the first, from which on the axis is logarithmic
DECADES = 9  # of the axis of rates, at most


def draw_risk(risk: RiskResult, hazard: HazardResult | None, locale: Locale) -> Figure:
    """Draw the annual rate of exceedance above, and below it the contributions [%] over the same intensities."""
    with style.report_style():
        figure = style.sheet(2.7, locale)
        above, below = figure.subplots(2, 1, sharex=True)
        if hazard is not None:
            rates = np.array(hazard.annual_rate)
            shown = rates > 0.0
            words = locale.text(say("hazard: ground motions that exceed the intensity"))
            above.plot(
                np.array(hazard.intensity)[shown],
                rates[shown],
                color=style.INK,
                marker="o",
                markersize=3.0,
                label=words,
            )
        above.axhline(risk.annual_rate, color=style.FAIL, linewidth=1.0, label=locale.text(say("rate of the state")))
        if risk.with_epistemic is not None:
            words = locale.text(say("with epistemic dispersion"))
            above.axhline(risk.with_epistemic, color=style.FAIL, linewidth=1.0, linestyle=":", label=words)
        if risk.target_rate is not None:
            target = locale.text(say("target"))
            above.axhline(risk.target_rate, color=style.FAIL, linewidth=1.0, linestyle="--", label=target)
        above.set_yscale("log")
        above.yaxis.set_major_locator(LogLocator(numticks=DECADES))
        above.yaxis.set_minor_locator(NullLocator())
        above.yaxis.set_major_formatter(style.LogTicks(locale))
        above.set_ylabel(locale.heading(say("annual rate"), "annual rate"))
        edges = np.array(risk.intensity)
        below.bar(
            edges[:-1], PERCENT * np.array(risk.contribution), np.diff(edges), align="edge", color=CONTRIBUTION_COLOUR,
            edgecolor="white", linewidth=0.5,
        )  # fmt: skip
        below.set_ylabel(locale.heading(say("share of the rate"), "percent"))
        below.set_ylim(bottom=0.0)
        if edges[0] > 0.0 and edges[-1] / edges[0] > LOGARITHMIC_FROM:
            below.set_xscale("log")
            style.number_by_decades(below.xaxis, locale)
        below.set_xlim(edges[0], edges[-1])
        below.set_xlabel(locale.heading(measure_text(risk.measure), risk.measure.dimension))
        style.legend_below(figure, columns=2)
        return figure


def _draw_points(
    axes: Axes, points: Sequence[EmpiricalPoint], colour: str, marker: str, names: tuple[str, str] = ("_", "_")
) -> None:
    """Draw the shares that were counted; hollow where most records are scaled by more than 4. names: with intervals."""
    name, hollow_name = names
    if name != "_":
        ends = [[point.intensity] * 2 for point in points], [[PERCENT * p.low, PERCENT * p.high] for p in points]
        for x, y in zip(*ends, strict=True):
            axes.plot(x, y, color=style.MUTED, linewidth=0.7)
    for hollow in (False, True):
        some = [point for point in points if _is_hollow(point) == hollow]
        axes.plot(
            [point.intensity for point in some],
            [PERCENT * point.share for point in some],
            marker,
            color=colour,
            markersize=POINT_SIZE,
            markerfacecolor="white" if hollow else colour,
            label=hollow_name if hollow and some else name if not hollow else "_",
        )


def _draw_lognormal(axes: Axes, curve: FragilityCurve, fitted: LognormalResult, locale: Locale) -> None:
    if fitted.band is not None:
        low, high = (PERCENT * np.array(side) for side in (fitted.band.low, fitted.band.high))
        words = locale.text(say("95 % band, by earthquake"))
        axes.fill_between(
            fitted.band.intensity, low, high, color=LOGNORMAL_COLOUR, alpha=0.18, linewidth=0.0, label=words
        )
    x = _intensities(curve)
    axes.plot(
        x, PERCENT * _shares(fitted, x), color=LOGNORMAL_COLOUR, linewidth=1.6, label=locale.text(say("lognormal"))
    )
    for share, at in ((5.0, fitted.five_percent), (50.0, fitted.median)):
        if at <= x[-1]:
            axes.plot([0.0, at, at], [share, share, 0.0], ":", color=LOGNORMAL_COLOUR, linewidth=0.8)


def _is_hollow(point: EmpiricalPoint) -> bool:
    """Return whether most records of a point are scaled by more than 4."""
    return 2 * point.hollow > point.records


def _frame_shares(axes: Axes, curves: Sequence[FragilityCurve], locale: Locale) -> None:
    axes.set_xlim(0.0, max(map(intensity_reach, curves)))
    axes.set_ylim(0.0, 103.0)
    measure = curves[0].measure
    axes.set_xlabel(locale.heading(measure_text(measure), measure.dimension))


def _intensities(curve: FragilityCurve) -> FloatArray:
    """Return intensities up to the end of the axis."""
    return np.linspace(0.0, intensity_reach(curve), 200)


def _shares(fitted: LognormalResult, x: FloatArray) -> FloatArray:
    """Return the share by a lognormal at each intensity, 0 at zero."""
    with np.errstate(divide="ignore"):
        from scipy.special import ndtr

        return np.asarray(ndtr(np.log(x / fitted.median) / fitted.dispersion), dtype=np.float64)


def _record_curve(run: RecordRunsResult, unit: float, top: float) -> tuple[FloatArray, FloatArray]:
    """Return intensities and rotations of a record, `top` where it overturned."""
    ratio = np.array([top if each is None else each for each in run.ratio])
    return unit * np.array(run.scale), ratio


def _first_overturning_scale(run: RecordRunsResult) -> float | None:
    """Return the least scale that overturns; None for a record that never does."""
    return next((scale for scale, ratio in zip(run.scale, run.ratio, strict=True) if ratio is None), None)


def _mark_first_overturning(
    axes: Axes, pairs: Sequence[tuple[RecordRunsResult, float]], top: float, locale: Locale
) -> None:
    """Mark the first run of each record that overturns; hollow where it is scaled by more than 4."""
    first = [(_first_overturning_scale(run), unit) for run, unit in pairs]
    for large, face, words in (
        (False, style.FAIL, say("overturns first")),
        (True, "white", say("overturns first, scaled by more than 4")),
    ):
        at = [scale * unit for scale, unit in first if scale is not None and (scale > LARGE_SCALE) == large]
        if at:
            name = locale.text(words)
            axes.plot(
                at, [top] * len(at), "o", color=style.FAIL, markersize=3.5, markerfacecolor=face, label=name, zorder=3
            )


def _draw_islands(axes: Axes, pairs: Sequence[tuple[RecordRunsResult, float]], locale: Locale) -> None:
    """Draw runs that stand although a lower scale overturns the mechanism."""
    found = [
        (scale * unit, ratio)
        for run, unit in pairs
        for scale, ratio in zip(run.scale, run.ratio, strict=True)
        if ratio is not None and any(low <= scale <= high for low, high in run.islands)
    ]
    if found:
        x, y = zip(*found, strict=True)
        size = 4 if len(pairs) <= MANY_RECORDS else 2
        axes.plot(
            x, y, "D", color=style.INK, markerfacecolor=ISLAND_COLOUR, markersize=size, markeredgewidth=0.4, zorder=4,
            label=locale.text(say("island: stands again")),
        )  # fmt: skip
