"""Bodies made thicker, against bodies that were made so."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from assess.geometry.solid import Solid, box, polyhedron, scale_along


def same(found: Solid, wanted: Solid) -> None:
    np.testing.assert_allclose(found.mass, wanted.mass, rtol=1e-12, atol=0.0)
    np.testing.assert_allclose(found.centroid, wanted.centroid, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(found.inertia, wanted.inertia, rtol=1e-10, atol=1e-10 * np.trace(wanted.inertia))
    np.testing.assert_allclose(found.vertices, wanted.vertices, rtol=1e-12, atol=1e-12)


def test_a_box_is_the_thicker_box() -> None:
    sizes = {"length": 3.0, "height": 4.0, "density": 1800.0, "name": "wall"}
    thin = box(thickness=0.6, base=(5.0, 1.0, 2.0), **sizes)
    found = scale_along(thin, direction=(2.0, 0.0, 0.0), middle=5.0, factor=1.5)
    same(found, box(thickness=0.9, base=(5.0, 1.0, 2.0), **sizes))
    beside = scale_along(thin, direction=(1.0, 0.0, 0.0), middle=4.7, factor=1.5)  # about its face
    same(beside, box(thickness=0.9, base=(5.15, 1.0, 2.0), **sizes))
    assert not found.inertia.flags.writeable


@pytest.mark.parametrize("factor", [0.4, 1.0, 1.7])
def test_any_body_is_the_integral_over_its_moved_surface(factor: float) -> None:
    points = np.random.default_rng(2).normal(size=(30, 3)) * [1.0, 2.0, 4.0] + [3.0, -1.0, 5.0]
    hull = ConvexHull(points)
    corners = points[hull.simplices]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outwards = np.einsum("mi,mi->m", normal, hull.equations[:, :3])[:, None] > 0.0
    triangles = np.where(outwards, hull.simplices, hull.simplices[:, ::-1])
    body = polyhedron(points, triangles, density=2000.0, name="body")
    u, middle = np.array([0.6, 0.8, 0.0]), 1.3
    moved = points + (factor - 1.0) * np.outer(points @ u - middle, u)
    found = scale_along(body, direction=3.0 * u, middle=middle, factor=factor)
    same(found, polyhedron(moved, triangles, density=2000.0, name="body"))
