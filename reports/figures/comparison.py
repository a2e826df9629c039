"""What the procedures find, of all mechanisms on one axis and of one over PGA (thesis Figs. 8.6 to 8.8, 8.12, 8.13)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.codes.check import Check, Outcome
from assess.results import HistoryResult, MechanismResult, Results
from reports import governing
from reports.figures import style
from reports.language.locale import Locale
from reports.language.texts import quantity, say
from reports.mechanisms import group_variants, mechanism_number, numbered_title, short_check_title, short_title

LARGEST_RATIO = 2.5  # larger ratios are drawn at the edge [-]
ROW_HEIGHT, ROOM, TALLEST = 0.24, 0.85, 8.4  # a row, what is above and below all rows, the figure [in]
LOGARITHMIC_FROM = 30.0  # largest over smallest PGA from which on the axis is logarithmic [-]
PANELS = 4  # levels side by side
NAME_LENGTH, LEGEND_NAME_LENGTH = 26, 38  # characters of a line beside a row, of a name in the legend


@dataclass(frozen=True)
class ResultMark:
    """One result: row, value on the axis, and the procedure; marker: in place of the procedure's own, or empty."""

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
        ResultMark(_height_in_row(row, procedures.index(name), len(procedures)), pga, name)
        for row, mechanism in enumerate(order)
        for name, pga in found[mechanism.name].items()
    ]
    with style.report_style():
        figure = style.sheet(_figure_height(ROW_HEIGHT * len(order), len(procedures)), locale)
        axes = figure.subplots()
        _label_rows(axes, results, order, locale)
        _draw_marks(axes, dots)
        own = governing.site_pga(results)
        if own is not None:
            axes.axvline(own, color=style.FAIL, linewidth=1.0, label=locale.text(say("site’s own action")))
        _set_pga_axis(axes, [dot.at for dot in dots if dot.at > 0.0] or [1.0], locale)
        axes.set_xlabel(locale.heading(say("peak ground acceleration at capacity"), "ground acceleration"))
        _legend(figure, procedures, locale)
        return figure


def draw_demands(results: Results, locale: Locale) -> Figure:
    """Draw demand / capacity [-] of every mechanism, a panel for each level; a cross where the body overturns."""
    order = [mechanism for group in group_variants(results) for mechanism in group]
    levels = sorted({row.level_pga_g for row in results.comparison})
    procedures = _procedures(order, {row.procedure for row in results.comparison})
    columns = min(PANELS, len(levels)) or 1
    lines = -(-len(levels) // columns) or 1
    with style.report_style():
        figure = style.sheet(_figure_height(lines * (ROW_HEIGHT * len(order) + 0.2), len(procedures)), locale)
        panels = figure.subplots(lines, columns, squeeze=False, sharey=True, sharex=True)
        for axes, level in zip(panels.flat, levels, strict=False):
            _label_rows(axes, results, order, locale)
            axes.axvline(1.0, color=style.FAIL, linewidth=1.0)
            axes.set_xlim(0.0, LARGEST_RATIO * 1.04)
            _draw_marks(axes, _demand_marks(order, level, procedures))
            axes.set_title(locale.text(say("PGA {level}", level=quantity(level, "ground acceleration", 3))), loc="left")
        for axes in list(panels.flat)[len(levels) :]:
            axes.set_visible(False)
        for axes in panels[-1]:
            axes.set_xlabel(locale.heading(say("demand / capacity"), "ratio"))
        _legend(figure, procedures, locale)
        return figure


def draw_curves(results: Results, locale: Locale) -> Figure:
    """Draw rotation over PGA by one procedure, and moment over rotation, of all mechanisms; variants share a colour."""
    pens = style.mechanism_pens(results)
    with style.report_style():
        figure = style.sheet(2.35 + 0.14 * -(-len(pens) // 3), locale)
        left, right = figure.subplots(1, 2)
        procedure = curve_procedure(results)
        for mechanism in results.mechanisms:
            name = style.label(locale.text(numbered_title(results, mechanism.name)), LEGEND_NAME_LENGTH)
            _draw_rotation(left, mechanism, procedure, pens[mechanism.name], name)
            _draw_moment(right, results, mechanism, pens[mechanism.name])
        own = governing.site_pga(results)
        if own is not None:
            left.axvline(own, color=style.FAIL, linewidth=0.9, linestyle=":")
        left.set(xlim=(0.0, None), ylim=(0.0, 1.05))
        left.set_title(style.label(locale.text(short_title(procedure)), 60), loc="left")
        left.set_xlabel(locale.heading(say("peak ground acceleration, PGA"), "ground acceleration"))
        left.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        right.set(xlim=(0.0, 1.0), ylim=(0.0, 1.05))
        right.set_xlabel(locale.heading(say("rotation φ / φₒᵥ of rigid joints"), "ratio"))
        right.set_ylabel(locale.heading(say("moment / largest of rigid joints"), "ratio"))
        style.legend_below(figure, columns=3, axes=left)
        return figure


def curve_procedure(results: Results) -> str:
    """Return the procedure whose curves are compared: that with most of them, of equals one that decides."""
    methods = () if results.verdict is None else results.verdict.methods
    shown = [check for mechanism in results.mechanisms for check in _one_per_procedure(mechanism.checks)]
    letter = [check.procedure for check in shown if check.reading == "letter"]
    count = Counter(letter or [check.procedure for check in shown])
    return max(count, key=lambda name: (count[name], name in methods), default="")


def marker_kind(check: Check) -> str:
    """Return how a result is drawn: "overturned", "beyond" the scale or "inside" it; empty without a result."""
    if governing.is_overturned(check):
        return "overturned"
    if check.verdict in (Outcome.NOT_ANSWERED, Outcome.NOT_APPLICABLE):
        return ""
    if check.ratio is None:
        return "beyond" if check.verdict == Outcome.FAIL else ""
    return "beyond" if check.ratio > LARGEST_RATIO else "inside"


OVERTURNED_HEIGHT = 1.06  # where a record that overturned is drawn [-]
AXES_HEIGHT, LEGEND_LINE = 1.85, 0.125  # of the axes, of a line of the legend [in]


def draw_pga_rotation(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw phi / phi_ov [-] over PGA [g]: a curve for each procedure, allowables, levels, and maxima of records."""
    shown = _one_per_procedure(mechanism.checks)
    with style.report_style():
        figure = style.sheet(AXES_HEIGHT + LEGEND_LINE * (len(shown) // 2 + 3), locale, width=style.HALF)
        axes = figure.subplots()
        for check in shown:
            _draw_procedure(axes, check, style.label(locale.text(short_check_title(check, mechanism.checks)), 30))
        levels = sorted({check.level_pga_g for check in mechanism.checks})
        _draw_levels(axes, levels, locale)
        _draw_histories(axes, mechanism.histories, locale)
        axes.set_xlabel(locale.heading(say("peak ground acceleration, PGA"), "ground acceleration"))
        axes.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        axes.set(xlim=(0.0, _pga_axis_end(mechanism, levels)), ylim=(0.0, 1.12))
        style.legend_below(figure, columns=2)
        return figure


def _set_pga_axis(axes: Axes, values: Sequence[float], locale: Locale) -> None:
    """Start the axis at zero, or make it logarithmic where the values are too far apart for a linear one."""
    if max(values) <= LOGARITHMIC_FROM * min(values):
        axes.set_xlim(0.0, 1.05 * max(values))
        return
    axes.set(xscale="log", xlim=(0.8 * min(values), 1.25 * max(values)))
    style.number_by_decades(axes.xaxis, locale)


def _draw_rotation(axes: Axes, mechanism: MechanismResult, procedure: str, ink: style.Pen, name: str) -> None:
    check = next((each for each in _one_per_procedure(mechanism.checks) if each.procedure == procedure), None)
    pga, ratio = ((), ()) if check is None else (check.pga_curve.pga_g, check.pga_curve.rotation_ratio)
    axes.plot(pga, ratio, linestyle=ink.dash, color=ink.colour, linewidth=ink.width, label=name)


def _draw_moment(axes: Axes, results: Results, mechanism: MechanismResult, ink: style.Pen) -> None:
    """Draw the capacity curve over its rigid overturning rotation and the largest moment of its rigid variant."""
    group = next(each for each in group_variants(results) if mechanism in each)
    simpler, own = mechanism.interface_curves, mechanism.curve.positive
    rigid = group[0].curve.positive.restoring_n_m if simpler is None else simpler.rigid.restoring_n_m
    rotation = np.asarray(own.rotation_rad) / mechanism.oscillator.overturning_rad
    moment = np.asarray(own.restoring_n_m) / max(rigid)
    axes.plot(rotation, moment, linestyle=ink.dash, color=ink.colour, linewidth=ink.width)


def _procedures(order: Sequence[MechanismResult], shown: set[str]) -> list[str]:
    """Return the procedures in the order in which the mechanisms have them."""
    every = dict.fromkeys(check.procedure for mechanism in order for check in mechanism.checks)
    return [name for name in every if name in shown]


def _height_in_row(row: int, place: int, count: int) -> float:
    """Return the height of a procedure's mark within a row."""
    return row - 0.3 + 0.6 * place / max(count - 1, 1)


def _figure_height(rows: float, procedures: int) -> float:
    """Return the height [in] of a figure with so many rows and a legend of procedures."""
    return min(rows + 0.45 + 0.14 * (-(-procedures // 4) + 1), TALLEST)


def _label_rows(axes: Axes, results: Results, order: Sequence[MechanismResult], locale: Locale) -> None:
    """Give each mechanism a row with its name, short where there are many."""
    for line in range(len(order) - 1):
        axes.axhline(line + 0.5, color=style.GRID, linewidth=0.5)
    names = [locale.text(numbered_title(results, each.name)) for each in order]
    if ROW_HEIGHT * len(order) > TALLEST - ROOM:
        names = [mechanism_number(results, each.name) for each in order]
    axes.set_yticks(range(len(order)), [style.fold(name, width=NAME_LENGTH) for name in names])
    axes.set_ylim(len(order) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.grid(visible=False, axis="y")


def _demand_marks(order: Sequence[MechanismResult], level: float, procedures: Sequence[str]) -> list[ResultMark]:
    """Return the worst result of each procedure at a level."""
    made = []
    for row, mechanism in enumerate(order):
        for check in governing.worst_per_procedure(governing.checks_at_level(mechanism.checks, level)):
            kind = marker_kind(check)
            if kind:
                at = LARGEST_RATIO if kind != "inside" else float(check.ratio or 0.0)
                height = _height_in_row(row, procedures.index(check.procedure), len(procedures))
                made.append(ResultMark(height, at, check.procedure, {"overturned": "x", "beyond": ">"}.get(kind, "")))
    return made


def _draw_marks(axes: Axes, dots: Sequence[ResultMark]) -> None:
    """Draw the results that share a marker as one line without ink between them."""
    alike: dict[tuple[str, str], list[ResultMark]] = {}
    for dot in dots:
        alike.setdefault((dot.procedure, dot.marker), []).append(dot)
    for (procedure, marker), group in alike.items():
        across, up = [dot.at for dot in group], [dot.row for dot in group]
        axes.plot(across, up, **_marker_style(procedure, marker), clip_on=False)  # type: ignore[arg-type]


def _marker_style(procedure: str, marker: str = "") -> Mapping[str, object]:
    """Return how a mark is drawn: hollow for readings of the thesis."""
    ink = style.pen(procedure)
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
        lines += axes.plot([], [], label=style.label(locale.text(short_title(name)), 32), **_marker_style(name))  # type: ignore[arg-type]
    figure.legend(handles=lines, loc="outside lower center", ncols=4)


def _one_per_procedure(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the first check of each procedure and limit state that applies and has a PGA-rotation curve."""
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        if check.pga_curve.pga_g and check.verdict != Outcome.NOT_APPLICABLE:
            first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def _draw_procedure(axes: Axes, check: Check, name: str) -> None:
    ink, curve = style.pen(check.procedure), check.pga_curve
    axes.plot(curve.pga_g, curve.rotation_ratio, linestyle=ink.dash, color=ink.colour, label=name)
    if check.capacity_pga_g is not None and check.capacity_rotation_ratio is not None:
        at = ([check.capacity_pga_g], [check.capacity_rotation_ratio])
        face = ink.colour if check.reading == "letter" else "white"
        axes.plot(*at, marker=ink.marker, markersize=5, color=ink.colour, markerfacecolor=face, linestyle="none")


def _draw_histories(axes: Axes, histories: tuple[HistoryResult, ...], locale: Locale) -> None:
    standing = [(h.level_pga_g, abs(h.max_rotation_ratio)) for h in histories if h.max_rotation_ratio is not None]
    fallen = [h.level_pga_g for h in histories if h.overturned]
    dots: dict[str, Any] = {"linestyle": "none", "markersize": 4, "color": style.INK}
    if standing:
        name = locale.text(say("a record"))
        axes.plot(*zip(*standing, strict=True), marker=".", alpha=0.7, label=name, **dots)
    if fallen:
        height, name = [OVERTURNED_HEIGHT] * len(fallen), locale.text(say("a record that overturned"))
        axes.plot(fallen, height, marker="x", clip_on=False, label=name, **dots)


def _draw_levels(axes: Axes, levels: list[float], locale: Locale) -> None:
    """Draw the levels assessed and the rotation that overturns, and explain the marks of capacity."""
    for level in levels:
        axes.axvline(level, color=style.MUTED, linewidth=0.7, linestyle=(0, (2, 2)), zorder=0.5)
    axes.axhline(1.0, color=style.FAIL, linewidth=0.8, label=locale.text(say("overturning rotation φₒᵥ")))
    name = locale.text(say("allowable rotation"))
    axes.plot([], [], marker="o", color=style.MUTED, linestyle="none", markersize=4, label=name)
    if levels:
        name = locale.text(say("levels assessed"))
        axes.plot([], [], color=style.MUTED, linewidth=0.7, linestyle=(0, (2, 2)), label=name)


def _pga_axis_end(mechanism: MechanismResult, levels: list[float]) -> float:
    """Return the end of the axis [g]: beyond every capacity, uplift and level."""
    capacities = [check.capacity_pga_g for check in mechanism.checks if check.capacity_pga_g is not None]
    uplifts = [check.uplift_pga_g for check in mechanism.checks if check.uplift_pga_g is not None]
    return 1.12 * max([*capacities, *uplifts, *levels], default=1.0)
