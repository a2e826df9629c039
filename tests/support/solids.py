"""Solids of tests, meshed more finely than they need be."""

from __future__ import annotations

import numpy as np

from assess.geometry.solid import Solid, polyhedron


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
