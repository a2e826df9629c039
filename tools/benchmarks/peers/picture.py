"""Time of every program with its error, in a panel for each question: docs/images/speed.svg."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.benchmarks.peers.measure import Row, Table
from tools.benchmarks.peers.page import duration, percent

PICTURE = Path(__file__).parents[3] / "docs/images/speed.svg"
LOOK = {"font.size": 8, "axes.titlesize": 9, "axes.spines.top": False, "axes.spines.right": False,
        "svg.hashsalt": "assess", "svg.fonttype": "path"}  # fmt: skip
OURS, OTHERS, GRID = "#c1121f", "#6b7680", "#d7dce1"
SPAN = (1e-5, 1e3)
"""Seconds drawn; the last decade and a half are for the words beside the longest bar."""


def draw(tables: list[Table], path: Path = PICTURE) -> None:
    """Draw a panel for each table, all over the same seconds."""
    with mpl.rc_context(LOOK):
        counts = [len(table.rows) for table in tables]
        figure = Figure(figsize=(8.6, 0.17 * sum(counts) + 0.55 * len(counts)), layout="constrained")
        axes = figure.subplots(len(tables), 1, squeeze=False, sharex=True, height_ratios=counts).ravel()
        for each, table in zip(axes, tables, strict=True):
            panel(each, table)
        axes[-1].set(xscale="log", xlim=SPAN, xlabel="seconds, least")
        figure.savefig(path, metadata={"Date": None, "Creator": "assess"})
    path.write_text("\n".join(line.rstrip() for line in path.read_text().splitlines()) + "\n")


def panel(axes: Axes, table: Table) -> None:
    """Draw a bar for each line of a table, and its time and errors at the end of it."""
    names = [f"{row.program.name}, {row.program.setting}" for row in table.rows]
    colors = [OURS if row.program.name.startswith("this program") else OTHERS for row in table.rows]
    bars = axes.barh(range(len(names)), [row.least for row in table.rows], color=colors, height=0.7)
    axes.bar_label(bars, [words(row) for row in table.rows], padding=3, fontsize=6.5)
    axes.set_yticks(range(len(names)), names, fontsize=6.5)
    axes.invert_yaxis()
    axes.set_title(f"{table.title}: time; {'; '.join(table.error_titles)}", loc="left", fontsize=8)
    axes.grid(color=GRID, linewidth=0.5, axis="x")
    axes.set_axisbelow(True)


def words(row: Row) -> str:
    """Return the time of a program and its errors."""
    return "; ".join([duration(row.least), *map(percent, row.errors)])
