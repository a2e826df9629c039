"""The figure that sets mechanisms side by side."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from assess.results import Results
from reports.figures.comparison import draw
from reports.style import on_two_lines


def test_names_that_end_differently_can_be_told_apart() -> None:
    names = [f"Spire, crack at H/2 and {angle} deg" for angle in (45, 60, 75)]
    wrapped = [on_two_lines(name, 24) for name in names]
    assert [text.replace("\n", " ") for text in wrapped] == names
    assert max(len(line) for text in wrapped for line in text.split("\n")) <= 24
    assert on_two_lines("W" * 200, 24).endswith("…")


def test_labels_of_two_lines_do_not_meet(results: Results) -> None:
    shown = {f"m{i}": f"Belfry, portal frame of three blocks {i}" for i in range(12)}
    rows = tuple(replace(row, mechanism="m1") for row in results.comparison)
    figure = draw(rows, shown, frozenset())
    figure.canvas.draw()
    boxes = [tick.get_window_extent() for tick in figure.axes[0].get_yticklabels()]
    assert all(text.get_text().count("\n") == 1 for text in figure.axes[0].get_yticklabels())
    edges = sorted((box.y0, box.y1) for box in boxes)
    assert all(low[1] <= high[0] + 1.0 for low, high in pairwise(edges))  # to a pixel
