"""The directions that the edges of a plan face."""

import numpy as np
import pytest

from assess.geometry.planar import MAX_EDGES, hull_edge_normals


def polygon(sides: int, *, turned: float = 0.0) -> np.ndarray:
    at = 2.0 * np.pi * np.arange(sides) / sides + turned
    return np.column_stack([np.cos(at), np.sin(at), np.zeros(sides)])


def test_a_square_faces_four_ways() -> None:
    np.testing.assert_allclose(hull_edge_normals(polygon(4, turned=np.pi / 4)), [0, 90, 180, 270], rtol=0, atol=1e-12)


@pytest.mark.parametrize("sides", [3, 5, 64])
def test_normals_of_a_regular_polygon_lie_between_its_corners(sides: int) -> None:
    expected = np.sort((360.0 / sides * (np.arange(sides) + 0.5)) % 360.0)
    np.testing.assert_allclose(hull_edge_normals(polygon(sides)), expected, rtol=0, atol=1e-9)


def test_points_inside_the_hull_and_on_its_edges_change_nothing() -> None:
    corners = np.array([[0, 0], [4, 0], [4, 1], [0, 1.0]])
    more = np.concatenate([corners, [[2, 0.5], [2, 0], [0, 0.3]]])
    np.testing.assert_array_equal(hull_edge_normals(more), hull_edge_normals(corners))


def test_a_turned_body_turns_its_normals() -> None:
    turned = hull_edge_normals(polygon(5, turned=0.3))
    np.testing.assert_allclose(
        np.sort((turned - np.degrees(0.3)) % 360.0), hull_edge_normals(polygon(5)), rtol=0, atol=1e-9
    )


def test_a_line_has_no_edges_and_a_scan_no_more_than_can_matter() -> None:
    assert hull_edge_normals(np.array([[0, 0], [1, 1], [2, 2.0]])).size == 0
    assert hull_edge_normals(polygon(3000)).size == MAX_EDGES
