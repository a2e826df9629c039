"""Largest rotation over peak ground acceleration, by every procedure (thesis Figs. 8.6 and 8.7)."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.codes.check import Check
from assess.results import HistoryResult, MechanismResult
from reports.figures.style import FAIL, INK, MUTED, pen, report_style, sheet
from reports.governing import procedure_label

OVERTURNED = 1.06  # where a record that overturned is drawn [-]


def draw(mechanism: MechanismResult) -> Figure:
    """Draw phi / phi_ov [-] over PGA [g]: a curve for each procedure, allowables, levels, and maxima of records."""
    with report_style():
        figure = sheet(3.7)
        axes = figure.subplots()
        for check in one_per_procedure(mechanism.checks):
            _procedure(axes, check, procedure_label(check, mechanism.checks))
        _histories(axes, mechanism.histories)
        levels = sorted({check.level_pga_g for check in mechanism.checks})
        _levels(axes, levels)
        axes.set(xlabel="peak ground acceleration, PGA [g]", ylabel="rotation φ / φₒᵥ [-]")
        axes.set_ylim(0.0, 1.12)
        axes.set_xlim(0.0, _right(mechanism, levels))
        axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
        return figure


def one_per_procedure(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the first check of each procedure and limit state that has a PGA-rotation curve."""
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        if check.pga_curve.pga_g:
            first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def _procedure(axes: Axes, check: Check, name: str) -> None:
    ink, curve = pen(check.procedure), check.pga_curve
    axes.plot(curve.pga_g, curve.rotation_ratio, linestyle=ink.dash, color=ink.colour, label=name)
    if check.capacity_pga_g is not None and check.capacity_rotation_ratio is not None:
        at = ([check.capacity_pga_g], [check.capacity_rotation_ratio])
        face = ink.colour if check.reading == "letter" else "white"
        axes.plot(*at, marker=ink.marker, markersize=6, color=ink.colour, markerfacecolor=face, linestyle="none")


def _histories(axes: Axes, histories: tuple[HistoryResult, ...]) -> None:
    standing = [(h.level_pga_g, abs(h.max_rotation_ratio)) for h in histories if h.max_rotation_ratio is not None]
    fallen = [h.level_pga_g for h in histories if h.overturned]
    dots: dict[str, Any] = {"linestyle": "none", "markersize": 4, "color": INK}
    if standing:
        axes.plot(*zip(*standing, strict=True), marker=".", alpha=0.7, label="a record's largest rotation", **dots)
    if fallen:
        height = [OVERTURNED] * len(fallen)
        axes.plot(fallen, height, marker="x", clip_on=False, label="a record that overturned", **dots)


def _levels(axes: Axes, levels: list[float]) -> None:
    for level in levels:
        axes.axvline(level, color=MUTED, linewidth=0.7, linestyle=(0, (2, 2)), zorder=0.5)
    if levels:
        axes.plot([], [], color=MUTED, linewidth=0.7, linestyle=(0, (2, 2)), label="levels assessed")
    axes.axhline(1.0, color=FAIL, linewidth=0.8, label="overturning rotation, φₒᵥ")
    axes.plot([], [], marker="o", color=MUTED, linestyle="none", markersize=5, label="allowable (filled: code)")


def _right(mechanism: MechanismResult, levels: list[float]) -> float:
    capacities = [check.capacity_pga_g for check in mechanism.checks if check.capacity_pga_g is not None]
    uplifts = [check.uplift_pga_g for check in mechanism.checks if check.uplift_pga_g is not None]
    return 1.12 * max([*capacities, *uplifts, *levels], default=1.0)
