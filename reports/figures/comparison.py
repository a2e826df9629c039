"""All mechanisms on one axis: capacities, demands and curves (as thesis Figs. 8.6, 8.8, 8.12 and 8.13)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.codes.check import Check, Outcome
from assess.results import MechanismResult, Results
from reports import governing
from reports.figures.mechanism_pens import mechanism_pens
from reports.figures.pga_rotation import one_per_procedure
from reports.figures.style import FAIL, GRID, Pen, fold, label, legend_below, pen, report_style, sheet
from reports.figures.ticks import number_by_decades
from reports.language.locale import Locale
from reports.language.texts import quantity, say
from reports.titles import mechanism_number, numbered_title, short_title
from reports.variants import group_variants

BEYOND = 2.5  # larger ratios are drawn at the edge [-]
LINE, ROOM, TALLEST = 0.24, 0.85, 8.4  # a row, what is above and below all rows, the figure [in]
FAR = 30.0  # largest over smallest PGA from which on the axis is logarithmic [-]
PANELS = 4  # levels side by side
NAME, NAMED = 26, 38  # characters of a line beside a row, of a name in the legend


@dataclass(frozen=True)
class Dot:
    """One answer: row, value on the axis, and the procedure's pen; marker: another than the procedure's, or empty."""

    row: float
    at: float
    procedure: str
    marker: str = ""


def draw_capacities(results: Results, locale: Locale) -> Figure:
    """Draw the PGA at capacity [g] of every mechanism by every procedure, and the site's own PGA."""
    order = [mechanism for group in group_variants(results) for mechanism in group]
    found = {mechanism.name: governing.capacities(mechanism.checks) for mechanism in order}
    procedures = _procedures(order, {name for each in found.values() for name in each})
    dots = [
        Dot(_height(row, procedures.index(name), len(procedures)), pga, name)
        for row, mechanism in enumerate(order)
        for name, pga in found[mechanism.name].items()
    ]
    with report_style():
        figure = sheet(_tall(LINE * len(order), len(procedures)), locale)
        axes = figure.subplots()
        _rows(axes, results, order, locale)
        _draw_dots(axes, dots)
        own = governing.site_pga(results)
        if own is not None:
            axes.axvline(own, color=FAIL, linewidth=1.0, label=locale.text(say("site’s own action")))
        _span(axes, [dot.at for dot in dots if dot.at > 0.0] or [1.0], locale)
        axes.set_xlabel(locale.heading(say("peak ground acceleration at capacity"), "ground acceleration"))
        _legend(figure, procedures, locale)
        return figure


def _span(axes: Axes, values: Sequence[float], locale: Locale) -> None:
    """Set the axis from zero, or a logarithmic one where the values are too far apart to be told on it."""
    if max(values) <= FAR * min(values):
        axes.set_xlim(0.0, 1.05 * max(values))
        return
    axes.set(xscale="log", xlim=(0.8 * min(values), 1.25 * max(values)))
    number_by_decades(axes.xaxis, locale)


def draw_demands(results: Results, locale: Locale) -> Figure:
    """Draw demand / capacity [-] of every mechanism, a panel for each level; a cross where the body overturns."""
    order = [mechanism for group in group_variants(results) for mechanism in group]
    levels = sorted({row.level_pga_g for row in results.comparison})
    procedures = _procedures(order, {row.procedure for row in results.comparison})
    columns = min(PANELS, len(levels)) or 1
    lines = -(-len(levels) // columns) or 1
    with report_style():
        figure = sheet(_tall(lines * (LINE * len(order) + 0.2), len(procedures)), locale)
        panels = figure.subplots(lines, columns, squeeze=False, sharey=True, sharex=True)
        for axes, level in zip(panels.flat, levels, strict=False):
            _rows(axes, results, order, locale)
            axes.axvline(1.0, color=FAIL, linewidth=1.0)
            axes.set_xlim(0.0, BEYOND * 1.04)
            _draw_dots(axes, _demands(order, level, procedures))
            axes.set_title(locale.text(say("PGA {level}", level=quantity(level, "ground acceleration", 3))), loc="left")
        for axes in list(panels.flat)[len(levels) :]:
            axes.set_visible(False)
        for axes in panels[-1]:
            axes.set_xlabel(locale.heading(say("demand / capacity"), "ratio"))
        _legend(figure, procedures, locale)
        return figure


def draw_curves(results: Results, locale: Locale) -> Figure:
    """Draw rotation over PGA by one procedure, and moment over rotation, of all mechanisms; variants share a colour."""
    pens = mechanism_pens(results)
    with report_style():
        figure = sheet(2.35 + 0.14 * -(-len(pens) // 3), locale)
        left, right = figure.subplots(1, 2)
        procedure = curve_procedure(results)
        for mechanism in results.mechanisms:
            name = label(locale.text(numbered_title(results, mechanism.name)), NAMED)
            _rotation(left, mechanism, procedure, pens[mechanism.name], name)
            _moment(right, results, mechanism, pens[mechanism.name])
        own = governing.site_pga(results)
        if own is not None:
            left.axvline(own, color=FAIL, linewidth=0.9, linestyle=":")
        left.set(xlim=(0.0, None), ylim=(0.0, 1.05))
        left.set_title(label(locale.text(short_title(procedure)), 60), loc="left")
        left.set_xlabel(locale.heading(say("peak ground acceleration, PGA"), "ground acceleration"))
        left.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        right.set(xlim=(0.0, 1.0), ylim=(0.0, 1.05))
        right.set_xlabel(locale.heading(say("rotation φ / φₒᵥ of rigid joints"), "ratio"))
        right.set_ylabel(locale.heading(say("moment / largest of rigid joints"), "ratio"))
        legend_below(figure, columns=3, axes=left)
        return figure


def curve_procedure(results: Results) -> str:
    """Return the procedure whose curves are compared: that with most of them, of equals one that decides."""
    methods = () if results.verdict is None else results.verdict.methods
    shown = [check for mechanism in results.mechanisms for check in one_per_procedure(mechanism.checks)]
    letter = [check.procedure for check in shown if check.reading == "letter"]
    count = Counter(letter or [check.procedure for check in shown])
    return max(count, key=lambda name: (count[name], name in methods), default="")


def _rotation(axes: Axes, mechanism: MechanismResult, procedure: str, ink: Pen, name: str) -> None:
    check = next((each for each in one_per_procedure(mechanism.checks) if each.procedure == procedure), None)
    pga, ratio = ((), ()) if check is None else (check.pga_curve.pga_g, check.pga_curve.rotation_ratio)
    axes.plot(pga, ratio, linestyle=ink.dash, color=ink.colour, linewidth=ink.width, label=name)


def _moment(axes: Axes, results: Results, mechanism: MechanismResult, ink: Pen) -> None:
    """Draw the capacity curve over its rigid overturning rotation and the largest moment of its rigid variant."""
    group = next(each for each in group_variants(results) if mechanism in each)
    simpler, own = mechanism.interface_curves, mechanism.curve.positive
    rigid = group[0].curve.positive.restoring_n_m if simpler is None else simpler.rigid.restoring_n_m
    rotation = np.asarray(own.rotation_rad) / mechanism.oscillator.overturning_rad
    moment = np.asarray(own.restoring_n_m) / max(rigid)
    axes.plot(rotation, moment, linestyle=ink.dash, color=ink.colour, linewidth=ink.width)


def _procedures(order: Sequence[MechanismResult], wanted: set[str]) -> list[str]:
    """Return the procedures in the order in which the mechanisms have them."""
    every = dict.fromkeys(check.procedure for mechanism in order for check in mechanism.checks)
    return [name for name in every if name in wanted]


def _height(row: int, place: int, count: int) -> float:
    """Return the height of a procedure's mark within a row."""
    return row - 0.3 + 0.6 * place / max(count - 1, 1)


def _tall(rows: float, procedures: int) -> float:
    """Return the height [in] of a figure with so many rows and a legend of procedures."""
    return min(rows + 0.45 + 0.14 * (-(-procedures // 4) + 1), TALLEST)


def _rows(axes: Axes, results: Results, order: Sequence[MechanismResult], locale: Locale) -> None:
    """Give each mechanism a row with its name, short where there are many."""
    for line in range(len(order) - 1):
        axes.axhline(line + 0.5, color=GRID, linewidth=0.5)
    names = [locale.text(numbered_title(results, each.name)) for each in order]
    if LINE * len(order) > TALLEST - ROOM:
        names = [mechanism_number(results, each.name) for each in order]
    axes.set_yticks(range(len(order)), [fold(name, width=NAME) for name in names])
    axes.set_ylim(len(order) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.grid(visible=False, axis="y")


def _demands(order: Sequence[MechanismResult], level: float, procedures: Sequence[str]) -> list[Dot]:
    """Return the worst answer of each procedure at a level."""
    made = []
    for row, mechanism in enumerate(order):
        for check in governing.worst_per_procedure(governing.at_level(mechanism.checks, level)):
            kind = marker_kind(check)
            if kind:
                at = BEYOND if kind != "inside" else float(check.ratio or 0.0)
                height = _height(row, procedures.index(check.procedure), len(procedures))
                made.append(Dot(height, at, check.procedure, {"overturned": "x", "beyond": ">"}.get(kind, "")))
    return made


def marker_kind(check: Check) -> str:
    """Return how an answer is drawn: "overturned", "beyond" the scale or "inside" it; empty without an answer."""
    if governing.is_overturned(check):
        return "overturned"
    if check.verdict in (Outcome.NOT_ANSWERED, Outcome.NOT_APPLICABLE):
        return ""
    if check.ratio is None:
        return "beyond" if check.verdict == Outcome.FAIL else ""
    return "beyond" if check.ratio > BEYOND else "inside"


def _draw_dots(axes: Axes, dots: Sequence[Dot]) -> None:
    """Draw the answers that look alike as one line without ink between them."""
    alike: dict[tuple[str, str], list[Dot]] = {}
    for dot in dots:
        alike.setdefault((dot.procedure, dot.marker), []).append(dot)
    for (procedure, marker), group in alike.items():
        across, up = [dot.at for dot in group], [dot.row for dot in group]
        axes.plot(across, up, **_look(procedure, marker), clip_on=False)  # type: ignore[arg-type]


def _look(procedure: str, marker: str = "") -> Mapping[str, object]:
    """Return how a mark is drawn: hollow for readings of the thesis."""
    ink = pen(procedure)
    return {
        "marker": marker or ink.marker,
        "color": ink.colour,
        "markerfacecolor": "white" if ink.dash == "--" else ink.colour,
        "markersize": 4.5,
        "linestyle": "none",
    }


def _legend(figure: Figure, procedures: Sequence[str], locale: Locale) -> None:
    axes = figure.axes[0]
    lines = [each for each in axes.get_lines() if not str(each.get_label()).startswith("_")]
    for name in procedures:
        lines += axes.plot([], [], label=label(locale.text(short_title(name)), 32), **_look(name))  # type: ignore[arg-type]
    figure.legend(handles=lines, loc="outside lower center", ncols=4)
