"""Largest rotation over peak ground acceleration, by every procedure (thesis Figs. 8.6 and 8.7)."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.codes.check import Check, Outcome
from assess.results import HistoryResult, MechanismResult
from reports.figures.style import FAIL, HALF, INK, MUTED, label, legend_below, pen, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say
from reports.titles import short_check_title

OVERTURNED = 1.06  # where a record that overturned is drawn [-]
HEIGHT, LINE = 1.85, 0.125  # of the axes, of a line of the legend [in]


def draw(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw phi / phi_ov [-] over PGA [g]: a curve for each procedure, allowables, levels, and maxima of records."""
    shown = one_per_procedure(mechanism.checks)
    with report_style():
        figure = sheet(HEIGHT + LINE * (len(shown) // 2 + 3), locale, width=HALF)
        axes = figure.subplots()
        for check in shown:
            _procedure(axes, check, label(locale.text(short_check_title(check, mechanism.checks)), 30))
        levels = sorted({check.level_pga_g for check in mechanism.checks})
        _levels(axes, levels, locale)
        _histories(axes, mechanism.histories, locale)
        axes.set_xlabel(locale.heading(say("peak ground acceleration, PGA"), "ground acceleration"))
        axes.set_ylabel(locale.heading(say("rotation φ / φₒᵥ"), "ratio"))
        axes.set(xlim=(0.0, longest(mechanism, levels)), ylim=(0.0, 1.12))
        legend_below(figure, columns=2)
        return figure


def one_per_procedure(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the first check of each procedure and limit state that applies and has a PGA-rotation curve."""
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        if check.pga_curve.pga_g and check.verdict != Outcome.NOT_APPLICABLE:
            first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def _procedure(axes: Axes, check: Check, name: str) -> None:
    ink, curve = pen(check.procedure), check.pga_curve
    axes.plot(curve.pga_g, curve.rotation_ratio, linestyle=ink.dash, color=ink.colour, label=name)
    if check.capacity_pga_g is not None and check.capacity_rotation_ratio is not None:
        at = ([check.capacity_pga_g], [check.capacity_rotation_ratio])
        face = ink.colour if check.reading == "letter" else "white"
        axes.plot(*at, marker=ink.marker, markersize=5, color=ink.colour, markerfacecolor=face, linestyle="none")


def _histories(axes: Axes, histories: tuple[HistoryResult, ...], locale: Locale) -> None:
    standing = [(h.level_pga_g, abs(h.max_rotation_ratio)) for h in histories if h.max_rotation_ratio is not None]
    fallen = [h.level_pga_g for h in histories if h.overturned]
    dots: dict[str, Any] = {"linestyle": "none", "markersize": 4, "color": INK}
    if standing:
        name = locale.text(say("a record"))
        axes.plot(*zip(*standing, strict=True), marker=".", alpha=0.7, label=name, **dots)
    if fallen:
        height, name = [OVERTURNED] * len(fallen), locale.text(say("a record that overturned"))
        axes.plot(fallen, height, marker="x", clip_on=False, label=name, **dots)


def _levels(axes: Axes, levels: list[float], locale: Locale) -> None:
    """Draw the levels assessed and the rotation that overturns, and explain the marks of capacity."""
    for level in levels:
        axes.axvline(level, color=MUTED, linewidth=0.7, linestyle=(0, (2, 2)), zorder=0.5)
    axes.axhline(1.0, color=FAIL, linewidth=0.8, label=locale.text(say("overturning rotation φₒᵥ")))
    name = locale.text(say("allowable rotation"))
    axes.plot([], [], marker="o", color=MUTED, linestyle="none", markersize=4, label=name)
    if levels:
        name = locale.text(say("levels assessed"))
        axes.plot([], [], color=MUTED, linewidth=0.7, linestyle=(0, (2, 2)), label=name)


def longest(mechanism: MechanismResult, levels: list[float]) -> float:
    """Return the end of the axis [g]: beyond every capacity, uplift and level."""
    capacities = [check.capacity_pga_g for check in mechanism.checks if check.capacity_pga_g is not None]
    uplifts = [check.uplift_pga_g for check in mechanism.checks if check.uplift_pga_g is not None]
    return 1.12 * max([*capacities, *uplifts, *levels], default=1.0)
