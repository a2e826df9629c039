"""The view in space."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from reports.figures.view import NAME, along, freed


def test_a_name_is_lowered_until_both_can_be_read() -> None:
    first, second = np.array([50.0, 80.0]), np.array([53.0, 78.0])
    found = freed(second, [first])
    assert found[0] == 53.0
    assert NAME[1] <= first[1] - found[1] < NAME[1] + 1.0
    for clear in (np.array([50.0, 80.0 + 2 * NAME[1]]), np.array([50.0 + 2 * NAME[0], 80.0])):
        np.testing.assert_array_equal(freed(clear, [first]), clear)


@pytest.mark.parametrize("drawn", [each for each in product((False, True), repeat=3) if any(each)])
def test_a_closed_line_runs_along_the_drawn_edges_of_a_triangle_and_no_other(drawn: tuple[bool, bool, bool]) -> None:
    corners = along(drawn)
    passed = {frozenset(pair) for pair in zip(corners, [*corners[1:], corners[0]], strict=True)}
    assert passed == {frozenset({k, (k + 1) % 3}) for k in range(3) if drawn[k]}
