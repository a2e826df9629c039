"""Bodies made thicker, against bodies that were made so."""

import numpy as np
import pytest

from assess.geometry.solid import box, polyhedron, scale_along
from tests.support.solids import assert_same_mass, convex_hull


def test_a_box_is_the_thicker_box() -> None:
    sizes = {"length": 3.0, "height": 4.0, "density": 1800.0, "name": "wall"}
    thin = box(thickness=0.6, base=(5.0, 1.0, 2.0), **sizes)
    found = scale_along(thin, direction=(2.0, 0.0, 0.0), middle=5.0, factor=1.5)
    assert_same_mass(found, box(thickness=0.9, base=(5.0, 1.0, 2.0), **sizes), rtol=1e-12)
    beside = scale_along(thin, direction=(1.0, 0.0, 0.0), middle=4.7, factor=1.5)  # about its face
    assert_same_mass(beside, box(thickness=0.9, base=(5.15, 1.0, 2.0), **sizes), rtol=1e-12)
    assert not found.inertia.flags.writeable


@pytest.mark.parametrize("factor", [0.4, 1.0, 1.7])
def test_any_body_is_the_integral_over_its_moved_surface(factor: float) -> None:
    points = np.random.default_rng(2).normal(size=(30, 3)) * [1.0, 2.0, 4.0] + [3.0, -1.0, 5.0]
    body = convex_hull(points, density=2000.0, name="body")
    u, middle = np.array([0.6, 0.8, 0.0]), 1.3
    moved = points + (factor - 1.0) * np.outer(points @ u - middle, u)
    found = scale_along(body, direction=3.0 * u, middle=middle, factor=factor)
    assert_same_mass(found, polyhedron(moved, body.triangles, density=2000.0, name="body"), rtol=1e-12)
    np.testing.assert_allclose(found.vertices, moved, rtol=1e-12, atol=1e-12)
