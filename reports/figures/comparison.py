"""Demand over capacity of all mechanisms by all procedures."""

from __future__ import annotations

from collections import Counter

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import ComparisonRow
from reports.style import FAIL, GRID, folded, label, pen, sheet, styled

BEYOND = 2.5  # larger ratios are drawn at the edge [-]


def draw(rows: tuple[ComparisonRow, ...], names: dict[str, str], overturned: frozenset[ComparisonRow]) -> Figure:
    """Demand / capacity [-] per mechanism, one panel for each level; a cross at the edge where records overturn.

    names: mechanism -> what to write beside its line; overturned: rows whose demand is beyond overturning.
    """
    levels = sorted({row.level_pga_g for row in rows})
    columns = min(3, len(levels)) or 1
    lines = -(-len(levels) // columns) or 1
    with styled():
        figure = sheet(min(8.6, lines * (0.75 + 0.3 * len(names)) + 0.65))
        panels = figure.subplots(lines, columns, squeeze=False, sharey=True, sharex=True)
        for axes, level in zip(panels.flat, levels, strict=False):
            _panel(axes, [row for row in rows if row.level_pga_g == level], list(names), overturned)
            axes.set_title(f"PGA {level:.3g} g", loc="left")
        for axes in list(panels.flat)[len(levels) :]:
            axes.set_visible(False)
        panels[0, 0].set_yticks(range(len(names)), captions(names))
        panels[0, 0].set_ylim(len(names) - 0.5, -0.5)
        figure.supxlabel("demand / capacity [-]", fontsize=7.5)
        _legend(figure, rows)
        return figure


def captions(names: dict[str, str]) -> list[str]:
    """What stands beside each line: the label on two lines, or where that tells two apart no more, the name."""
    short = {name: folded(text, width=24) for name, text in names.items()}
    times = Counter(short.values())
    return [text if times[text] == 1 else label(name, 24) for name, text in short.items()]


def _panel(axes: Axes, rows: list[ComparisonRow], order: list[str], overturned: frozenset[ComparisonRow]) -> None:
    axes.axvline(1.0, color=FAIL, linewidth=1.0)
    axes.set_xlim(0.0, BEYOND * 1.06)
    for line in range(len(order) - 1):
        axes.axhline(line + 0.5, color=GRID, linewidth=0.5)
    procedures = sorted({row.procedure for row in rows})
    for row in rows:
        spread = 0.62 / max(len(procedures) - 1, 1)
        height = order.index(row.mechanism) - 0.31 + spread * procedures.index(row.procedure)
        _dot(axes, row, height, row in overturned)
    axes.grid(visible=False, axis="y")


def _dot(axes: Axes, row: ComparisonRow, height: float, fell: bool) -> None:
    ink = pen(row.procedure)
    face = "white" if ink.dash == "--" else ink.colour
    if fell:
        axes.plot(BEYOND, height, marker="x", color=ink.colour, markersize=6, markeredgewidth=1.6, clip_on=False)
    elif row.demand_capacity is not None:
        marker = ">" if row.demand_capacity > BEYOND else ink.marker
        at = min(row.demand_capacity, BEYOND)
        axes.plot(at, height, marker=marker, color=ink.colour, markerfacecolor=face, markersize=4.5, clip_on=False)


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
