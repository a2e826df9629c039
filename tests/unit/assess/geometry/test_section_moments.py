"""Level sections of solids against closed forms."""

import numpy as np
import pytest

from assess.geometry.cut import section_edges, section_moments
from assess.geometry.solid import box, polyhedron, profile


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.2, -2.0])
def test_sections_of_a_box_seen_from_any_direction(angle: float) -> None:
    """A = b l, S = A s_0, I = A (b^2 cos^2 + l^2 sin^2) / 12 + A s_0^2."""
    b, length, x, y = 2.0, 3.0, 1.0, -0.5
    solid = box(thickness=b, length=length, height=10.0, base=[x, y, 2.0], density=2000.0, name="box")
    c, s = np.cos(angle), np.sin(angle)
    area, at = b * length, x * c + y * s
    moment = area * ((b * c) ** 2 + (length * s) ** 2) / 12 + area * at**2
    found = section_moments(solid, [2.1, 7.0, 11.9], direction=[3 * c, 3 * s, 0.0])
    np.testing.assert_allclose(found, [[area, area * at, moment]] * 3, rtol=1e-12)
    np.testing.assert_array_equal(section_moments(solid, [1.0, 13.0], direction=[1, 0, 0]), np.zeros((2, 3)))


def test_a_section_with_a_hole_and_a_slope() -> None:
    """An arch-like profile: two legs at z = 1, one piece at z = 3.5."""
    corners = [[0, 0], [1, 0], [1, 2], [3, 2], [3, 0], [4, 0], [4, 4], [0, 4]]
    found = section_moments(profile(corners, length=2.0, density=1.0, name="arch"), [1.0, 3.5], direction=[1, 0, 0])
    np.testing.assert_allclose(found[:, 0], [4.0, 8.0], rtol=1e-12)
    np.testing.assert_allclose(found[:, 2], [2 * (1 / 3 + (64 - 27) / 3), 2 * 64 / 3], rtol=1e-12)


def test_the_volume_is_the_sum_of_slices() -> None:
    """A cone of many sides: area pi-like r^2 (1 - z/h)^2, exact by Simpson's rule."""
    n, h = 16, 6.0
    turn = 2 * np.pi * np.arange(n) / n
    ring = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(n)])
    points = np.vstack([ring, [0, 0, 0], [0, 0, h]])
    k = np.arange(n)
    sides = np.column_stack([k, (k + 1) % n, np.full(n, n + 1)])
    base = np.column_stack([(k + 1) % n, k, np.full(n, n)])
    cone = polyhedron(points, np.vstack([sides, base]), density=1.0, name="cone")
    z = np.array([1e-9, h / 2, h - 1e-9])
    area = section_moments(cone, z, direction=[0, 1, 0])[:, 0]
    assert h / 6 * (area @ [1, 4, 1]) == pytest.approx(cone.mass, rel=1e-8)


def test_the_edges_of_sections_follow_the_faces_of_a_battered_wall_however_it_stands() -> None:
    """Of a trapezium of 2 m at its foot and 1 m at 4 m, turned in plan: from 0 to 2 - z/4 along its direction."""
    wall = profile([(0.0, 0.0), (2.0, 0.0), (1.0, 4.0), (0.0, 4.0)], length=3.0, density=1.0, name="wall")
    found = section_edges(wall, [0.5, 2.0, 3.9], direction=[5.0, 0.0, 0.0])
    np.testing.assert_allclose(found, [[0.0, 1.875], [0.0, 1.5], [0.0, 1.025]], rtol=1e-12, atol=1e-12)
    across = section_edges(wall, [1.0], direction=[0.0, -1.0, 0.0])
    np.testing.assert_allclose(across, [[-1.5, 1.5]], rtol=1e-12)
    assert np.isinf(section_edges(wall, [5.0], direction=[1.0, 0.0, 0.0])).all()
