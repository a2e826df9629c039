"""Sizes of a body along and across the thin direction."""

from __future__ import annotations

import numpy as np
import pytest

from assess.geometry.mesh import extents


def test_the_shorter_side_is_found_where_none_is_thin() -> None:
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    corners = np.array([[x, y] for x in (0.0, 2.0) for y in (0.0, 2.5)]) @ turn.T
    body = np.vstack([np.column_stack([corners, np.full(4, z)]) for z in (0.0, 6.0)])
    assert extents(body, None) == pytest.approx((2.0, 2.5, 6.0), rel=1e-12)


def test_points_upon_one_line_have_the_sizes_along_x_and_y() -> None:
    line = np.array([[0.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 1.0, 4.0]])
    assert extents(line, None) == (0.0, 3.0, 4.0)
