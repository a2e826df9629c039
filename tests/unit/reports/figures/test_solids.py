"""Surfaces of triangles: cut, welded, divided."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from reports.figures.key_plan import CrackPlane, body_numbers, cut_triangles, plane_of, weld
from reports.figures.projection import TriangleSurface


def box(
    size: tuple[float, float, float] = (1.0, 2.0, 3.0), at: tuple[float, float, float] = (0, 0, 0)
) -> TriangleSurface:
    mesh = trimesh.creation.box(size)
    return TriangleSurface(np.array(mesh.vertices) + at, np.array(mesh.faces))


def area(corners: np.ndarray) -> float:
    return float(
        0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
    )


@pytest.mark.parametrize("normal", [(0.0, 0.0, 1.0), (0.6, 0.0, 0.8), (0.48, 0.6, 0.64)])
def test_a_cut_keeps_the_surface_and_leaves_no_triangle_on_both_sides(normal: tuple[float, float, float]) -> None:
    plane = CrackPlane(np.array([0.1, -0.2, 0.3]), np.array(normal))
    whole = box().corners
    parts = cut_triangles(whole, plane)
    assert len(parts) > len(whole)
    assert area(parts) == pytest.approx(area(whole), rel=1e-12)
    heights = plane.heights(parts)
    assert not ((heights.min(axis=1) < -1e-9) & (heights.max(axis=1) > 1e-9)).any()
    before, after = (np.cross(each[:, 1] - each[:, 0], each[:, 2] - each[:, 0]).sum(axis=0) for each in (whole, parts))
    np.testing.assert_allclose(after, before, rtol=0, atol=1e-12)  # closed, all faces still outwards


def test_a_cut_beside_the_surface_changes_nothing() -> None:
    whole = box().corners
    np.testing.assert_array_equal(
        cut_triangles(whole, CrackPlane(np.array([0.0, 0.0, 1.5]), np.array([0.0, 0.0, 1.0]))), whole
    )


def test_loose_triangles_are_one_body_again() -> None:
    corners = np.concatenate([box().corners, box(at=(5.0, 0.0, 0.0)).corners])
    surface = weld(corners)
    assert len(surface.vertices) == 16
    assert len(set(body_numbers(surface).tolist())) == 2


def test_the_plane_of_a_ring_looks_upwards() -> None:
    ring = np.array([[0.0, 0.0, 2.0], [0.0, 1.0, 2.0], [1.0, 1.0, 2.5], [1.0, 0.0, 2.5]])
    plane = plane_of(ring)
    np.testing.assert_allclose(plane.heights(ring), 0.0, rtol=0, atol=1e-12)
    assert plane.normal[2] > 0.8
