"""The view in space."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from reports.figures.projection import paint_faces
from reports.figures.view import NAME, avoid_names


def test_a_name_is_lowered_until_both_can_be_read() -> None:
    first, second = np.array([50.0, 80.0]), np.array([53.0, 78.0])
    found = avoid_names(second, [first])
    assert found[0] == 53.0
    assert NAME[1] <= first[1] - found[1] < NAME[1] + 1.0
    for clear in (np.array([50.0, 80.0 + 2 * NAME[1]]), np.array([50.0 + 2 * NAME[0], 80.0])):
        np.testing.assert_array_equal(avoid_names(clear, [first]), clear)


@pytest.mark.parametrize("drawn", list(product((False, True), repeat=3)))
def test_a_face_is_followed_by_its_drawn_edges_and_no_other(drawn: tuple[bool, bool, bool]) -> None:
    corners = np.array([[0.0, 0.0], [3.0, 0.0], [1.0, 2.0]])
    shapes, inks = paint_faces(corners[None], np.array([drawn]), np.array([[0.5, 0.6, 0.7]]))
    np.testing.assert_array_equal(shapes[0], corners)
    np.testing.assert_array_equal(inks[0], [0.5, 0.6, 0.7])
    passed = {frozenset(map(tuple, shape.tolist())) for shape in shapes[1:]}
    ends = [tuple(corner) for corner in corners.tolist()]
    assert passed == {frozenset({ends[k], ends[(k + 1) % 3]}) for k in range(3) if drawn[k]}
    assert len(inks) == len(shapes) == 1 + sum(drawn)
