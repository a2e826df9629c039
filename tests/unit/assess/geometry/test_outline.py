"""The outline against shapely's union of every triangle, and its order."""

import numpy as np
import pytest
import shapely

from assess.geometry.planar import _covered_by_grid, distance_to_outline, projected_outline

SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
FACES = np.array([[0, 1, 2], [0, 2, 3]])


@pytest.mark.parametrize(("n", "m"), [(8, 12), (16, 30), (60, 90)])
def test_outline_of_a_rough_body_coarse_or_fine_is_the_union_of_its_triangles(n: int, m: int) -> None:
    rng = np.random.default_rng(2)
    turn, rise = 2.0 * np.pi * np.arange(n) / n, np.linspace(0.0, 8.0, m)
    radius = 1.5 + 0.06 * rng.normal(size=(m, n))
    skin = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.broadcast_to(rise[:, None], (m, n))], axis=2)
    points = np.concatenate([skin.reshape(-1, 3), [[0.0, 0.0, 0.0], [0.0, 0.0, 8.0]]])
    i, k = np.meshgrid(np.arange(n), np.arange(m - 1))
    a, b = (k * n + i).ravel(), (k * n + (i + 1) % n).ravel()
    ring = np.arange(n)
    foot = np.column_stack([np.full(n, n * m), (ring + 1) % n, ring])
    head = np.column_stack([np.full(n, n * m + 1), ring + (m - 1) * n, (ring + 1) % n + (m - 1) * n])
    triangles = np.concatenate([np.column_stack([a, b, a + n]), np.column_stack([b, b + n, a + n]), foot, head])
    rings = projected_outline(points[:, [0, 2]], triangles)
    every = shapely.polygons(points[:, [0, 2]][triangles])
    wanted = shapely.union_all(every[shapely.area(every) > 1e-12])
    found = shapely.union_all([shapely.Polygon(each) for each in rings])
    filled = shapely.union_all(shapely.polygons(shapely.get_exterior_ring(shapely.get_parts(wanted))))
    assert found.symmetric_difference(filled).area < 1e-9 * filled.area


@pytest.mark.parametrize("roll", [0, 1, 2, 3])
def test_rings_begin_leftmost_and_run_anticlockwise_left_to_right(roll: int) -> None:
    square, faces = np.roll(SQUARE, roll, axis=0), np.concatenate([FACES + 4, FACES])
    rings = projected_outline(np.concatenate([square, np.add(square, [3.0, -5.0])]), faces)
    left = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0))
    right = ((3.0, -5.0), (4.0, -5.0), (4.0, -4.0), (3.0, -4.0), (3.0, -5.0))
    assert rings == (left, right)


def test_triangles_that_face_away_or_are_seen_edge_on_do_not_count() -> None:
    behind = np.concatenate([FACES, (FACES + 4)[:, ::-1], [[0, 1, 8]]])
    points = np.concatenate([SQUARE, np.add(SQUARE, [3.0, 0.0]), [[7.0, 1e-15]]])
    assert len(projected_outline(points, behind)) == 1


def test_points_on_straight_sides_go_and_flat_corners_stay() -> None:
    bend = 1e-6
    points = np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0 + bend], [0.0, 1.0]])
    fan = np.array([[0, 1, 5], [1, 4, 5], [1, 2, 4], [2, 3, 4]])
    assert projected_outline(points, fan) == (
        ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0 + bend), (0.0, 1.0), (0.0, 0.0)),
    )


def test_distance_to_an_outline():
    rings = (
        ((0.0, 0.0), (1.0, 0.0), (1.0, 4.0), (0.0, 4.0), (0.0, 0.0)),
        ((3.0, 0.0), (4.0, 0.0), (4.0, 1.0), (3.0, 0.0)),
    )
    assert distance_to_outline(rings, (0.5, 2.0)) == 0.0
    assert distance_to_outline(rings, (-3.0, 8.0)) == 5.0
    assert distance_to_outline(rings, (2.5, 0.0)) == 0.5


def test_triangles_that_the_fast_test_takes_for_covered_are_covered() -> None:
    """Under a body without its own mirror image about the diagonal: a wall with its windows on one side."""
    body = shapely.box(-4.0, -4.0, 4.0, 4.0) - shapely.box(-3.0, 1.0, -1.0, 3.0) - shapely.box(2.0, -3.5, 3.5, -1.0)
    rng = np.random.default_rng(3)
    corners = rng.uniform(-3.8, 3.8, (2000, 1, 2)) + rng.uniform(-0.05, 0.05, (2000, 3, 2))
    fast = _covered_by_grid(body, corners, size=8.0)
    truly = shapely.covers(body, shapely.polygons(corners))
    assert 0.3 < fast.mean() <= truly.mean()
    assert truly[fast].all()
