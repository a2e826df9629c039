"""Demand over capacity of all mechanisms by all procedures."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from assess.results import ComparisonRow
from reports.figures.style import FAIL, GRID, fold, label, pen, report_style, sheet

BEYOND = 2.5  # larger ratios are drawn at the edge [-]


def draw(rows: tuple[ComparisonRow, ...], names: dict[str, str], overturned: frozenset[ComparisonRow]) -> Figure:
    """Draw demand / capacity [-] by mechanism, a panel for each level; a cross at the edge where records overturn.

    names: mechanism -> what to write beside its line; overturned: rows whose demand is beyond overturning.
    """
    levels = sorted({row.level_pga_g for row in rows})
    columns = min(3, len(levels)) or 1
    lines = -(-len(levels) // columns) or 1
    with report_style():
        figure = sheet(min(8.6, lines * (0.75 + 0.3 * len(names)) + 0.65))
        panels = figure.subplots(lines, columns, squeeze=False, sharey=True, sharex=True)
        for axes, level in zip(panels.flat, levels, strict=False):
            _panel(axes, [row for row in rows if row.level_pga_g == level], list(names), overturned)
            axes.set_title(f"PGA {level:.3g} g", loc="left")
        for axes in list(panels.flat)[len(levels) :]:
            axes.set_visible(False)
        panels[0, 0].set_yticks(range(len(names)), line_labels(names))
        panels[0, 0].set_ylim(len(names) - 0.5, -0.5)
        figure.supxlabel("demand / capacity [-]", fontsize=7.5)
        _legend(figure, rows)
        return figure


def line_labels(names: dict[str, str]) -> list[str]:
    """Return the label beside each line, on two lines; the name where two labels would be the same."""
    short = {name: fold(text, width=24) for name, text in names.items()}
    times = Counter(short.values())
    return [text if times[text] == 1 else label(name, 24) for name, text in short.items()]


def _panel(axes: Axes, rows: list[ComparisonRow], order: list[str], overturned: frozenset[ComparisonRow]) -> None:
    axes.axvline(1.0, color=FAIL, linewidth=1.0)
    axes.set_xlim(0.0, BEYOND * 1.06)
    for line in range(len(order) - 1):
        axes.axhline(line + 0.5, color=GRID, linewidth=0.5)
    procedures = sorted({row.procedure for row in rows})
    spread = 0.62 / max(len(procedures) - 1, 1)
    places: dict[tuple[str, str], list[tuple[float, float]]] = {}
    for row in rows:
        height = order.index(row.mechanism) - 0.31 + spread * procedures.index(row.procedure)
        if row in overturned or row.demand_capacity is not None:
            at = BEYOND if row in overturned else min(row.demand_capacity or 0.0, BEYOND)
            places.setdefault((row.procedure, marker_kind(row, overturned)), []).append((at, height))
    for (procedure, seen), dots in places.items():
        _dots(axes, procedure, seen, dots)
    axes.grid(visible=False, axis="y")


def marker_kind(row: ComparisonRow, overturned: frozenset[ComparisonRow]) -> str:
    """Return how a row is drawn: "overturned", "beyond" the scale or "inside" it."""
    if row in overturned:
        return "overturned"
    return "beyond" if (row.demand_capacity or 0.0) > BEYOND else "inside"


def _dots(axes: Axes, procedure: str, seen: str, at: list[tuple[float, float]]) -> None:
    """Draw the rows of a procedure that look alike as one line without ink between them."""
    ink = pen(procedure)
    face = "white" if ink.dash == "--" else ink.colour
    marker = {"overturned": "x", "beyond": ">", "inside": ink.marker}[seen]
    size: dict[str, Any] = {"markersize": 6, "markeredgewidth": 1.6} if seen == "overturned" else {"markersize": 4.5}
    line = Line2D(*np.transpose(at), marker=marker, color=ink.colour, markerfacecolor=face, linestyle="none", **size)
    line.set_clip_on(False)
    axes.add_artist(line)


def _legend(figure: Figure, rows: tuple[ComparisonRow, ...]) -> None:
    axes = figure.axes[0]
    handles = []
    for procedure in sorted({row.procedure for row in rows}):
        ink = pen(procedure)
        face = "white" if ink.dash == "--" else ink.colour
        handles += axes.plot(
            [], [], marker=ink.marker, color=ink.colour, markerfacecolor=face, linestyle="none", label=procedure
        )
    figure.legend(handles=handles, loc="outside upper center", ncols=3)
