"""Solids of tests: irregular ones, boxes by two corners, meshes finer than they need be, and how two compare."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from assess.geometry.solid import Solid, box, join, polyhedron


def refine_mesh(solid: Solid, times: int) -> Solid:
    """Return the solid with each triangle in four, `times` over."""
    vertices, faces = solid.vertices, solid.triangles
    for _ in range(times):
        a, b, c = (vertices[faces[:, i]] for i in range(3))
        corners = np.stack([a, b, c, (a + b) / 2, (b + c) / 2, (c + a) / 2], axis=1)
        split = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]])
        vertices, index = np.unique(corners.reshape(-1, 3).round(12), axis=0, return_inverse=True)
        faces = index.reshape(-1, 6)[:, split].reshape(-1, 3)
    return polyhedron(vertices, faces, density=1000.0, name=solid.name)


def convex_hull(points: np.ndarray, *, density: float, name: str) -> Solid:
    """Return the convex hull of points [n, 3], its triangles turned outwards."""
    hull = ConvexHull(points)
    corners = points[hull.simplices]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outwards = np.einsum("mi,mi->m", normals, hull.equations[:, :3]) > 0.0
    triangles = np.where(outwards[:, None], hull.simplices, hull.simplices[:, ::-1])
    return polyhedron(points, triangles, density=density, name=name)


def irregular_tower(*, seed: int = 7, corners: int = 40, density: float) -> Solid:
    """Return a convex body without any symmetry, some 4 x 8 x 20 m, the hull of so many random points."""
    points = np.random.default_rng(seed).normal(size=(corners, 3)) * [1.0, 2.0, 5.0] + [3.0, -2.0, 6.0]
    return convex_hull(points, density=density, name="tower")


def cuboid(low: Sequence[float], high: Sequence[float], name: str = "body", density: float = 1000.0) -> Solid:
    """Return the box between two corners."""
    (x, y, z), (X, Y, Z) = low, high
    base = ((x + X) / 2, (y + Y) / 2, z)
    return box(thickness=X - x, length=Y - y, height=Z - z, base=base, density=density, name=name)


def solid_box(
    size: Sequence[float] = (1.0, 1.0, 1.0),
    base: Sequence[float] = (0.0, 0.0, 0.0),
    *,
    density: float = 1000.0,
    name: str = "body",
) -> Solid:
    """Return a box by thickness, length and height, and the middle of its foot; a cube of 1 m."""
    thickness, length, height = size
    return box(thickness=thickness, length=length, height=height, base=base, density=density, name=name)


def moved_solid(solid: Solid, turn: Rotation, shift: ArrayLike = 0.0, *, density: float = 1000.0) -> Solid:
    """Return a solid turned about the origin and then shifted [3]."""
    points = turn.apply(solid.vertices.copy()) + shift
    return polyhedron(points, solid.triangles, density=density, name=solid.name)


def surfaces_of(*solids: Solid) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices and triangles of several surfaces in one, as they are."""
    together = join(solids, name="together")
    return together.vertices, together.triangles


def inside_out(solid: Solid) -> Solid:
    """Return a solid whose triangles look inwards, as those of a cavity do; its mass is left."""
    return replace(solid, triangles=solid.triangles[:, ::-1])


def assert_same_mass(found: Solid, expected: Solid, *, rtol: float) -> None:
    """Compare mass, centroid and inertia, each with the body's own size as scale."""
    size = float(np.ptp(expected.vertices, axis=0).max())
    np.testing.assert_allclose(found.mass, expected.mass, rtol=rtol, atol=0.0)
    np.testing.assert_allclose(found.centroid, expected.centroid, rtol=0.0, atol=rtol * size)
    np.testing.assert_allclose(found.inertia, expected.inertia, rtol=0.0, atol=rtol * np.diag(expected.inertia).min())
