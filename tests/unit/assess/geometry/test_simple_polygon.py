"""Where sides of polygons meet, against shapely's own judgement of polygons and places known by hand."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from assess.geometry.solid import find_crossing, remove_repeats


@pytest.mark.parametrize(
    ("corners", "place"),
    [
        ([[0, 0], [1, 1], [1, 0], [0, 1]], (0.5, 0.5)),
        ([[0, 0], [2, 0], [2, 2], [1, 0], [0, 2]], (1.0, 0.0)),  # a corner on a side
        ([[0, 0], [2, 0], [2, 2], [1, 1], [0, 2], [1, 1]], (1.0, 1.0)),  # two corners at one place
        ([[0, 0], [1, 0], [1, 1], [0, 1]], None),
        ([[0, 0], [2, 0], [1, 2]], None),
        ([[0, 0], [1, 0], [2, 0], [2, 1]], None),  # a corner on a straight line
    ],
)
def test_the_place_where_sides_meet(corners, place):
    found = find_crossing(np.array(corners, dtype=float))
    assert found is None if place is None else found == pytest.approx(place, rel=1e-12)


def test_sides_that_turn_back_meet_along_a_line():
    x, y = find_crossing(np.array([[0.0, 0.0], [3.0, 0.0], [2.0, 0.0], [2.0, 2.0]]))
    assert 2.0 <= x <= 3.0
    assert y == 0.0


def test_chance_polygons_are_simple_when_shapely_says_so():
    random = np.random.default_rng(5)
    verdicts = []
    for _ in range(400):
        corners = random.integers(0, 5, (random.integers(3, 8), 2)).astype(float)
        corners = remove_repeats(corners)
        if len(corners) < 3 or shapely.MultiPoint(corners).convex_hull.area == 0.0:
            continue
        verdicts.append(bool(shapely.Polygon(corners).is_valid))
        assert (find_crossing(corners) is None) == verdicts[-1]
    assert 30 < sum(verdicts) < len(verdicts) - 30


def test_corners_at_the_place_of_the_one_before_are_left_out():
    ring = np.array([[0, 0], [1, 0], [1, 0], [1, 1], [0, 0]], dtype=float)
    np.testing.assert_array_equal(remove_repeats(ring), [[1, 0], [1, 1], [0, 0]], strict=False)
