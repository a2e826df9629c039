"""The view in space."""

from __future__ import annotations

import numpy as np

from reports.figures.view import NAME, freed, sides


def test_a_name_is_lowered_until_both_can_be_read() -> None:
    first, second = np.array([50.0, 80.0]), np.array([53.0, 78.0])
    found = freed(second, [first])
    assert found[0] == 53.0
    assert NAME[1] <= first[1] - found[1] < NAME[1] + 1.0
    for clear in (np.array([50.0, 80.0 + 2 * NAME[1]]), np.array([50.0 + 2 * NAME[0], 80.0])):
        np.testing.assert_array_equal(freed(clear, [first]), clear)


def test_the_drawn_sides_of_a_triangle_go_from_corner_to_next() -> None:
    corners = np.array([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]])
    path = sides(corners, np.array([True, False, True]))
    assert [tuple(map(tuple, each)) for each in path.vertices.reshape(-1, 2, 2).tolist()] == [
        ((0.0, 0.0), (4.0, 0.0)),
        ((0.0, 3.0), (0.0, 0.0)),
    ]
