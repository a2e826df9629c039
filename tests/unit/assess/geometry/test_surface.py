"""Merging of corners, and edges of closed and open surfaces."""

import numpy as np
import pytest

from assess.geometry.solid import box
from assess.geometry.surface import (
    HASH_WEIGHTS,
    adjacent_triangles,
    area,
    find_edges,
    merge_vertices,
    open_edges,
    parallel_sections,
    volume,
)

CUBE = box(thickness=1.0, length=1.0, height=1.0, base=[0.0, 0.0, -0.5], density=1.0, name="cube")


def test_merging_finds_the_corners_of_loose_triangles() -> None:
    loose = CUBE.vertices[CUBE.triangles].reshape(-1, 3)
    vertices, triangles = merge_vertices(loose, np.arange(36).reshape(-1, 3))
    assert vertices.shape == (8, 3)
    np.testing.assert_array_equal(vertices[triangles].reshape(-1, 3), loose)
    assert find_edges(triangles).plain


def test_merging_takes_both_zeros_for_one() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.0, -0.0, 0.0], [0.0, -0.0, 1.0]])
    vertices, triangles = merge_vertices(corners, np.array([[0, 1, 2], [3, 1, 4]]))
    assert (len(vertices), len(set(triangles.ravel().tolist()))) == (4, 4)


def test_merging_moves_nothing() -> None:
    near = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1e-12, 0.0, 0.0]])
    assert len(merge_vertices(near, np.array([[0, 1, 2], [3, 2, 1]]))[0]) == 4


def test_closed_and_plain_surfaces() -> None:
    assert find_edges(CUBE.triangles).plain
    assert not find_edges(CUBE.triangles[1:]).closed
    assert len(open_edges(find_edges(CUBE.triangles[1:]))) == 3
    touching = np.vstack([CUBE.triangles, CUBE.triangles + 8])
    _, triangles = merge_vertices(np.vstack([CUBE.vertices, np.add(CUBE.vertices, [1.0, 1.0, 0.0])]), touching)
    edges = find_edges(triangles)
    assert (edges.closed, edges.plain, int(edges.count.max())) == (True, False, 4)


def test_points_that_mix_to_one_number_stay_apart() -> None:
    """Of two points whose mixed numbers are the same: the merger looks at the coordinates."""
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [HASH_WEIGHTS[0], 0.0, 0.0]])
    vertices, triangles = merge_vertices(np.vstack([corners, corners]), np.array([[0, 1, 2], [4, 5, 7]]))
    assert len(vertices) == 4
    assert len(np.unique(triangles)) == 4


def test_volume_and_area_of_a_moved_box() -> None:
    wall = box(thickness=1.25, length=3.0, height=8.5, base=[40.0, -7.0, 2.0], density=1.0, name="wall")
    assert volume(wall.vertices, wall.triangles) == pytest.approx(31.875, rel=1e-13)
    assert volume(wall.vertices, wall.triangles[:, ::-1]) == pytest.approx(-31.875, rel=1e-13)
    wanted = 2.0 * (1.25 * 3.0 + 3.0 * 8.5 + 8.5 * 1.25)
    assert area(wall.vertices, wall.triangles) == pytest.approx(wanted, rel=1e-13)


def test_corners_are_numbered_by_z_then_y_then_x_as_lexsort_does() -> None:
    """Thousands of points on few levels, many of them at one place."""
    points = np.random.default_rng(5).integers(-4, 5, size=(3000, 3)) / 3.0
    vertices, triangles = merge_vertices(points, np.arange(3000).reshape(-1, 3))
    wanted = np.unique(points[:, ::-1], axis=0)[:, ::-1]
    np.testing.assert_array_equal(vertices, wanted)
    a, b, c = points.reshape(-1, 3, 3).transpose(1, 0, 2)
    real = (a != b).any(axis=1) & (b != c).any(axis=1) & (c != a).any(axis=1)
    np.testing.assert_array_equal(vertices[triangles], points.reshape(-1, 3, 3)[real])


def test_neighbours_across_edges_are_those_that_share_them() -> None:
    """Triangle i, its edge k, and the one found there have the edge's two corners in common; none of a surface that is
    open, turned in part, or has edges of four."""
    across = adjacent_triangles(CUBE.triangles)
    assert across is not None
    for i, others in enumerate(across.tolist()):
        for k, other in enumerate(others):
            edge = {int(CUBE.triangles[i, k]), int(CUBE.triangles[i, (k + 1) % 3])}
            assert other != i
            assert edge <= set(CUBE.triangles[other].tolist())
    turned = CUBE.triangles.copy()
    turned[0] = turned[0, ::-1]
    for wrong in (CUBE.triangles[1:], CUBE.triangles[2:], turned, np.vstack([CUBE.triangles, CUBE.triangles])):
        assert adjacent_triangles(wrong) is None


def test_parallel_sections_of_a_cube_are_those_of_its_faces():
    """Planes one quarter apart across the diagonal of a unit cube cut hexagons and triangles of known lengths.

    The plane x + y + z = c cuts a triangle of side c sqrt 2 for c <= 1, and a hexagon of perimeter 3 sqrt 2 between.
    """
    spacing, corners = 0.25, CUBE.vertices[CUBE.triangles] + 0.5
    found = parallel_sections(corners, normal=np.ones(3), spacing=spacing)
    heights = found.sum(axis=2) / np.sqrt(3.0) / spacing
    assert heights[:, 0] == pytest.approx(heights[:, 1])
    assert heights == pytest.approx(np.round(heights), abs=1e-9)
    lengths = np.linalg.norm(found[:, 1] - found[:, 0], axis=1)
    for number in range(1, 7):
        c = number * spacing * np.sqrt(3.0)
        perimeter = 3.0 * np.sqrt(2.0) * min(c, 1.0, 3.0 - c)
        assert lengths[np.round(heights[:, 0]) == number].sum() == pytest.approx(perimeter)


def test_planes_that_miss_a_triangle_or_touch_a_corner_cut_nothing():
    triangle = np.array([[[0.1, -0.5, 0.0], [0.2, -0.5, 0.0], [0.1, 0.0, 0.0]]])
    for normal in np.eye(3)[:2]:
        assert parallel_sections(triangle, normal=normal, spacing=1.0).shape in ((0, 2, 3), (1, 2, 3))
    assert parallel_sections(triangle, normal=np.eye(3)[0], spacing=1.0).shape == (0, 2, 3)
    touched = parallel_sections(triangle, normal=np.eye(3)[1], spacing=1.0)
    assert np.ptp(touched, axis=1) == pytest.approx(0.0)
