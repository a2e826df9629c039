"""Names beside points do not cover one another."""

from __future__ import annotations

from itertools import combinations

import pytest
from matplotlib.figure import Figure

from reports.figures.style import LABEL_MARK, Label, box_overlap, text_extent, write_labels

WINDOW = (300.0, 300.0)


def boxes(labels: list[Label]) -> list[tuple[float, float, float, float]]:
    axes = Figure(figsize=(6.0, 6.0), dpi=72).add_axes((0.1, 0.1, WINDOW[0] / 432.0, WINDOW[1] / 432.0))
    axes.set(xlim=(0.0, WINDOW[0]), ylim=(0.0, WINDOW[1]))
    write_labels(axes, labels)
    found = []
    for label, text in zip(labels, axes.texts, strict=True):
        (wide, high), (x, y) = text_extent(label.text), text.xyann
        left, low = label.at[0] + x, label.at[1] + y
        found.append((left, low, left + wide, low + high))
    return found


def test_eight_names_at_one_point_keep_apart() -> None:
    labels = [Label(f"mass {number}", (150.0, 150.0)) for number in range(8)]
    found = boxes(labels)
    assert all(box_overlap(one, other) == 0.0 for one, other in combinations(found, 2))
    point = (150.0 - LABEL_MARK, 150.0 - LABEL_MARK, 150.0 + LABEL_MARK, 150.0 + LABEL_MARK)
    assert all(box_overlap(box, point) == 0.0 for box in found)


@pytest.mark.parametrize("at", [(2.0, 2.0), (298.0, 2.0), (2.0, 298.0), (298.0, 298.0)])
def test_names_in_corners_stay_inside(at: tuple[float, float]) -> None:
    ((left, low, right, high),) = boxes([Label("a long name", at)])
    assert left >= 0.0
    assert low >= 0.0
    assert right <= WINDOW[0]
    assert high <= WINDOW[1]


def test_a_lone_name_stands_at_its_first_place() -> None:
    ((left, low, _, _),) = boxes([Label("A", (150.0, 150.0))])
    assert 0.0 < left - 150.0 < 7.0
    assert 0.0 < low - 150.0 < 7.0
