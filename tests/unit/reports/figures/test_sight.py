"""What is seen of points, lines and parts behind faces."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from reports.figures.projection import occluding_faces, split_line, visible_middle

SQUARE = np.array(
    [[[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [4.0, 4.0, 5.0]], [[0.0, 0.0, 5.0], [4.0, 4.0, 5.0], [0.0, 4.0, 5.0]]]
)
FAR = SQUARE - [2.0, 0.0, 5.0]
BOTH = np.concatenate([SQUARE, FAR])


def test_a_point_is_hidden_behind_a_face_and_not_on_or_before_it() -> None:
    points = np.array([[1.0, 1.0, 0.0], [1.0, 1.0, 5.0], [1.0, 1.0, 9.0], [-3.0, 1.0, 0.0]])
    assert occluding_faces(BOTH).hides(points).tolist() == [True, False, False, False]


def test_a_line_is_split_where_it_goes_behind_a_face() -> None:
    pieces = list(split_line(np.array([[-4.0, 2.0, 1.0], [8.0, 2.0, 1.0]]), occluding_faces(BOTH)))
    assert [hidden for _, hidden in pieces] == [False, True, False]
    turns = [pieces[0][0][-1, 0], pieces[1][0][-1, 0]]
    np.testing.assert_allclose(turns, [0.0, 4.0], rtol=0, atol=12.0 / 59)
    for (one, _), (other, _) in pairwise(pieces):
        np.testing.assert_array_equal(one[-1], other[0])


def test_the_middle_of_a_part_is_that_of_what_is_seen_of_it() -> None:
    x, y, _ = visible_middle(FAR, occluding_faces(BOTH))  # type: ignore[misc]
    assert -2.0 < x < 0.0
    assert y == pytest.approx(2.0, abs=0.5)
    front = visible_middle(SQUARE, occluding_faces(BOTH))
    assert front is not None
    assert front[:2] == pytest.approx([2.0, 2.0], abs=0.5)
    assert visible_middle(FAR[:, :, :] * [0.2, 0.2, 1.0] + [2.0, 1.0, 0.0], occluding_faces(BOTH)) is None
