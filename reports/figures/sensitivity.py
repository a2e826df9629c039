"""How results depend on their inputs: tornado diagrams, sweeps of a number or a direction, uncertain samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Literal, TypeGuard

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator

from assess.results import DirectionSweep, SweepResult
from assess.results.run import Influence, UncertainAnswer
from reports.figures.style import FAIL, HALF, INK, fold, label, legend_below, record_label, report_style, sheet
from reports.intensity_measures import PERCENT
from reports.language.locale import Locale
from reports.language.texts import Phrase, Text, Verbatim, say

LOW_COLOUR, HIGH_COLOUR = "#56b4e9", "#d55e00"  # the number at its low and at its high value
MARGIN = 0.12  # of what is shown, beside the ends of the bars
HALF_BAR = 0.34  # height of half a bar, of a row
TORNADO_ROW = 0.3  # height of a row [in]
WORD_ROOM = 0.3  # of the width of a panel: a longer bar has room for a word
LONGEST_BAR_LINE = 40  # characters of a line beside a bar


@dataclass(frozen=True)
class TornadoBar:
    """One number: the two lines of its label, and the answer at its low and its high value.

    low, high : infinite where the body overturns, None where not known
    verdicts : new verdict at the low and at the high value, in a word; None where it does not change
    """

    lines: tuple[Text, Text]
    low: float | None
    high: float | None
    verdicts: tuple[Text | None, Text | None] = (None, None)


@dataclass(frozen=True)
class TornadoPanel:
    """One answer: its name and the procedure; its dimension; its value as assessed; its bars.

    limit : between pass and fail, and its name; None where there is none
    """

    name: tuple[Text, Text]
    dimension: str
    base: float | None
    limit: tuple[float, Text] | None
    bars: tuple[TornadoBar, ...]


def draw_tornado(panels: Sequence[TornadoPanel], locale: Locale) -> Figure:
    """Draw a panel for each answer; all have the rows of the first."""
    rows = panels[0].bars
    with report_style():
        figure = sheet(0.85 + TORNADO_ROW * len(rows), locale)
        beside = figure.subplots(1, len(panels), squeeze=False, sharey=True)[0]
        for axes, panel in zip(beside, panels, strict=True):
            _draw_panel(axes, panel, locale)
        names = ["\n".join(label(locale.text(line), LONGEST_BAR_LINE) for line in bar.lines) for bar in rows]
        beside[0].set_yticks(range(len(rows)), names)
        beside[0].set_ylim(len(rows) - 0.5, -0.5)
        _tornado_legend(figure, beside[0], locale)
        return figure


SweptValues = Sequence[float | None]


def draw_sweep(sweep: SweepResult, locale: Locale) -> Figure:
    """Draw the results over the values, a panel for each quantity that is known of any case."""
    shown = _swept_quantities(sweep)
    with report_style():
        figure = sheet(2.0, locale)
        beside = figure.subplots(1, len(shown), squeeze=False)[0]
        for axes, (values, name, dimension) in zip(beside, shown, strict=True):
            _draw_sweep_curve(axes, sweep, values)
            axes.set_ylabel(locale.heading(name, dimension))
            axes.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
            if values is sweep.demand_capacity:
                axes.axhline(1.0, color=FAIL, linewidth=0.8)
        figure.supxlabel(label(f"{sweep.key} [{sweep.unit}]", 90), fontsize=7)
        return figure


def draw_directions(found: DirectionSweep, locale: Locale) -> Figure:
    """Draw the multiplier at uplift [-] around the circle, 0 degrees at +x and 90 at +y, and the weakest direction."""
    angle = np.radians([*found.angle_deg, found.angle_deg[0]])
    multiplier = [*found.uplift_multiplier, found.uplift_multiplier[0]]
    least = min(found.uplift_multiplier)
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.add_subplot(projection="polar")
        assert isinstance(axes, PolarAxes)
        axes.plot(angle, multiplier, color="#0072b2", label=locale.heading(say("load multiplier λ"), "ratio"))
        weakest = np.radians(found.weakest_deg)
        axes.plot([weakest, weakest], [0.0, least], color=FAIL, linewidth=1.0)
        axes.plot([weakest], [least], "o", markersize=4.5, color=FAIL, label=locale.text(say("weakest direction")))
        axes.set_ylim(0.0, 1.08 * max(found.uplift_multiplier))
        axes.set_rlabel_position((found.weakest_deg + 112.5) % 360.0)
        axes.set_xticks(np.radians([0, 45, 90, 135, 180, 225, 270, 315]))
        axes.set_xticklabels(["+x", "45°", "+y", "135°", "−x", "225°", "−y", "315°"])
        legend_below(figure, columns=2)
        return figure


RISING, FALLING = "#d55e00", "#56b4e9"
SAMPLES_HEIGHT = 1.95  # of a figure [in]
MOST_INFLUENCES = 6  # bars
LONGEST_INPUT_NAME = 26  # letters of the name of a bar
TAIL_PERCENTILE, PAST_TAIL = 98.0, 1.5  # percentile up to whose so many times the axis reaches


def draw_distribution(answer: UncertainAnswer, locale: Locale) -> Figure:
    """Draw the share of samples [%] whose demand over capacity is at most a value; the limit is at 1."""
    ratios = np.sort([ratio for ratio in answer.ratios if ratio is not None])
    with report_style():
        figure = sheet(SAMPLES_HEIGHT, locale, width=HALF)
        axes = figure.subplots()
        share = PERCENT * np.arange(1, ratios.size + 1) / max(answer.answered, ratios.size, 1)
        axes.step(ratios, share, where="post", color="#0072b2")
        axes.axvline(1.0, color=FAIL, linewidth=1.0)
        if answer.at_mean is not None:
            axes.axvline(answer.at_mean, color=INK, linewidth=0.8, linestyle=":")
        high = min(ratios[-1], PAST_TAIL * float(np.percentile(ratios, TAIL_PERCENTILE))) if ratios.size else 1.0
        axes.set_xlim(0.0, 1.08 * max(high, 1.0, answer.at_mean or 0.0))
        axes.set_ylim(0.0, 103.0)
        axes.set_xlabel(locale.heading(say("demand / capacity"), "ratio"))
        axes.set_ylabel(locale.heading(say("samples at or below"), "percent"))
        return figure


def draw_influences(answer: UncertainAnswer, locale: Locale) -> Figure:
    """Draw the rank correlation of the answer with each group of inputs, the strongest at the top."""
    found = rank_influences(answer)[:MOST_INFLUENCES]
    with report_style():
        figure = sheet(SAMPLES_HEIGHT, locale, width=HALF)
        axes = figure.subplots()
        values = [influence.rank_correlation or 0.0 for influence in found]
        colours = [RISING if value > 0.0 else FALLING for value in values]
        axes.barh(range(len(found)), values, 0.6, color=colours, linewidth=0)
        axes.set_yticks(
            range(len(found)), [record_label(locale.text(input_group_name(each)), LONGEST_INPUT_NAME) for each in found]
        )
        axes.set_ylim(max(len(found), 3) - 0.4, -0.6)
        axes.axvline(0.0, color=INK, linewidth=0.8)
        axes.set_xlim(-1.0, 1.0)
        axes.set_xlabel(locale.heading(say("rank correlation with demand / capacity"), "ratio"))
        axes.grid(visible=False, axis="y")
        axes.tick_params(axis="y", length=0)
        return figure


def rank_influences(answer: UncertainAnswer) -> list[Influence]:
    """Return the groups that change an answer, the strongest first."""
    known = [each for each in answer.influences if each.rank_correlation is not None]
    return sorted(known, key=lambda each: -abs(each.rank_correlation or 0.0))


def input_group_name(influence: Influence) -> Text:
    """Return the key of a single input, or the name of a group of several."""
    return Verbatim(influence.keys[0] if len(influence.keys) == 1 else influence.group)


def _draw_panel(axes: Axes, panel: TornadoPanel, locale: Locale) -> None:
    limit = None if panel.limit is None else panel.limit[0]
    ends = [value for bar in panel.bars for value in (bar.low, bar.high)]
    low, high = _axis_span([value for value in (*ends, panel.base, limit) if _is_drawn(value)])
    axes.set_xlim(low, high)
    for row, bar in enumerate(panel.bars):
        halves = zip((bar.low, bar.high), (LOW_COLOUR, HIGH_COLOUR), (-0.5, 0.5), bar.verdicts, strict=True)
        for value, colour, side, verdict in halves:
            if value is not None and panel.base is not None:
                word = "" if verdict is None else label(locale.text(verdict), 20)
                _draw_half_bar(axes, panel.base, value, height=row + side * HALF_BAR, colour=colour, verdict=word)
    if _is_drawn(panel.base):
        axes.axvline(panel.base, color=INK, linewidth=0.9)
    if panel.limit is not None:
        at, name = panel.limit
        axes.axvline(at, color=FAIL, linewidth=1.1, linestyle="--")
        top = axes.get_xaxis_transform()
        axes.text(at, 1.01, locale.text(name), transform=top, ha="center", fontsize=6.5, color=FAIL)
    words = (locale.heading(panel.name[0], panel.dimension), locale.text(panel.name[1]))
    axes.set_xlabel("\n".join(fold(line, width=34) for line in words))
    axes.xaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0)


def _draw_half_bar(axes: Axes, base: float, value: float, *, height: float, colour: str, verdict: str) -> None:
    """Draw half a bar, from the answer as assessed to that at one value; an arrow at the edge for overturning."""
    low, high = axes.get_xlim()
    start, end = min(base, high), min(value, high)
    axes.barh(height, end - start, HALF_BAR, left=start, color=colour, linewidth=0)
    if value == inf:
        axes.plot(high, height, marker=">", color=colour, markersize=5, clip_on=False)
    inside = abs(end - start) > WORD_ROOM * (
        high - low
    )  # beside the line of the answer as assessed, else beyond the end
    aside = 3 if end >= start else -3
    side: Literal["left", "right"] = "left" if aside > 0 else "right"
    at = (start if inside else end, height)
    axes.annotate(verdict, at, (aside, -0.3), textcoords="offset points", fontsize=6.3, ha=side, va="center", color=INK)


def _is_drawn(value: float | None) -> TypeGuard[float]:
    return value is not None and value < inf


def _axis_span(values: Sequence[float]) -> tuple[float, float]:
    """Return the ends of an axis: all of the values with a margin, and a width where they are one."""
    low, high = min(values, default=0.0), max(values, default=1.0)
    width = max(high - low, 0.02 * max(abs(low), abs(high)), 1e-6)
    return low - MARGIN * width, high + MARGIN * width


def _tornado_legend(figure: Figure, axes: Axes, locale: Locale) -> None:
    handles = [
        axes.barh([0], [0], color=LOW_COLOUR, label=locale.text(say("at the low value"))),
        axes.barh([0], [0], color=HIGH_COLOUR, label=locale.text(say("at the high value"))),
        *axes.plot([], [], color=INK, linewidth=0.9, label=locale.text(say("as assessed"))),
        *axes.plot([], [], color=FAIL, linewidth=1.1, linestyle="--", label=locale.text(say("limit"))),
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=4)


def _swept_quantities(sweep: SweepResult) -> list[tuple[SweptValues, Phrase, str]]:
    """Return the quantities of which any value is known, with their names and dimensions.

    On joints without a threshold of uplift the overturning rotation replaces the multiplier.
    """
    threshold = (sweep.uplift_multiplier, say("load multiplier at uplift λ"), "ratio")
    overturning = (sweep.overturning_flexible_rad, say("overturning on joints φₒᵥ"), "rotation")
    all_of_them: list[tuple[SweptValues, Phrase, str]] = [
        threshold if _any_known(sweep.uplift_multiplier) else overturning,
        (sweep.p_eq_per_s, say("frequency parameter p"), "angular frequency"),
        (sweep.demand_capacity, say("demand / capacity"), "ratio"),
    ]
    return [each for each in all_of_them if _any_known(each[0])]


def _any_known(values: SweptValues) -> bool:
    """Return whether any case has a value."""
    return any(value is not None for value in values)


def _draw_sweep_curve(axes: Axes, sweep: SweepResult, values: SweptValues) -> None:
    """Draw the known values in the order of the swept number, with the controlling case marked."""
    known = sorted((x, y) for x, y in zip(sweep.value, values, strict=True) if y is not None)
    axes.plot([x for x, _ in known], [y for _, y in known], marker="o", markersize=3, color="#0072b2", linewidth=1.0)
    highest = max((y for _, y in known), default=1.0)
    axes.set_ylim(0.0, 1.15 * highest or 1.0)  # from 0: noise must not look like a trend
    x, y = sweep.value[sweep.controlling], values[sweep.controlling]
    if y is not None:
        axes.plot([x], [y], "o", markersize=8, markerfacecolor="none", markeredgecolor=FAIL)
