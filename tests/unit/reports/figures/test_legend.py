"""Legends measured once against matplotlib's own."""

from __future__ import annotations

from matplotlib.axes import Axes

from reports.figures.style import report_style, sheet
from reports.render.vector import FigureMarks, trace_figure


def drawn(*, measured_once: bool) -> FigureMarks:
    with report_style():
        figure = sheet(2.0)
        axes = figure.subplots()
        for name in ("allowable", "a record\nthat overturned", "φₒᵥ"):
            axes.plot([0.0, 1.0], [0.0, len(name)], marker="o", label=name)
        (axes.legend if measured_once else lambda **how: Axes.legend(axes, **how))(loc="upper left", ncols=2)
    return trace_figure(figure)


def test_a_legend_stands_where_matplotlib_puts_it() -> None:
    assert drawn(measured_once=True).marks == drawn(measured_once=False).marks
