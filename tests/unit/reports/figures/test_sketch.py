"""The sketch: rotation and scale bar."""

from __future__ import annotations

import math

import pytest

from reports.figures.sketch import scale_length, turned


def test_positive_rotation_topples_towards_positive_x() -> None:
    x, z = turned((0.0, 2.0), about=(0.5, 0.0), angle=math.pi / 2)
    assert (x, z) == pytest.approx((2.5, 0.5))


@pytest.mark.parametrize(("size", "length"), [(4.0, 1.0), (8.7, 2.0), (0.3, 0.05), (50.0, 10.0)])
def test_scale_bars_are_round(size: float, length: float) -> None:
    assert scale_length(size) == pytest.approx(length)
