"""Simplification of a surface for drawing: vertices in one cell of a grid become one (Lindstrom 2000, SIGGRAPH)."""

from __future__ import annotations

import numpy as np

from assess.geometry.surface import area_vectors
from spectra.arrays import FloatArray, IntArray

COARSER = 1.15  # each grid that still leaves too many triangles is followed by one this much coarser
SHARP = 0.05  # of a cell's largest curvature: flatter directions do not move its vertex


def simplify(vertices: FloatArray, triangles: IntArray, *, limit: int) -> tuple[FloatArray, IntArray]:
    """Reduce a surface to at most `limit` triangles; one that has no more is returned unchanged.

    Each cell's vertex lies where the squared distance to the planes of its triangles is least, so that faces stay
    flat and edges sharp. The result is for the eye: thin parts may close, and its volume differs.

    Parameters
    ----------
    vertices, triangles : of the surface [n, 3] [m], indices [m, 3]
    limit : four or more
    """
    size = float(np.ptp(vertices, axis=0).max())
    cell = size * np.sqrt(2.0 / limit)  # about as many cells on a cube's face as there may be triangles
    points, faces = vertices, triangles
    while len(faces) > limit:
        points, faces = _cluster_vertices(vertices, triangles, cell=cell)
        cell *= COARSER
    return points, faces


def _cluster_vertices(vertices: FloatArray, triangles: IntArray, *, cell: float) -> tuple[FloatArray, IntArray]:
    """Reduce the surface to one vertex for each occupied cell of a grid of a width [m]."""
    column = np.floor((vertices - vertices.min(axis=0)) / cell).astype(np.int64)
    across = column.max(axis=0) + 1
    _, group = np.unique((column[:, 0] * across[1] + column[:, 1]) * across[2] + column[:, 2], return_inverse=True)
    corners = group[triangles]
    a, b, c = corners.T
    faces = _drop_duplicates(corners[(a != b) & (b != c) & (c != a)])
    used, index = np.unique(faces, return_inverse=True)
    return _cluster_points(vertices, triangles, group, cell=cell)[used], index.reshape(-1, 3)


def _drop_duplicates(faces: IntArray) -> IntArray:
    """Keep each triangle [m, 3] once, without those back to back, as where a thin part has closed."""
    first = np.argmin(faces, axis=1)[:, None] if len(faces) else np.empty((0, 1), dtype=np.int64)
    turned = np.take_along_axis(faces, (first + np.arange(3)) % 3, axis=1)  # the least corner first
    alike, index = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True)
    weights = np.where(turned[:, 1] < turned[:, 2], 1.0, -1.0)
    sense = np.bincount(index.reshape(-1), weights=weights, minlength=len(alike))
    either = np.where(sense[:, None] > 0.0, alike, alike[:, ::-1])
    return np.asarray(either[sense != 0.0], dtype=np.int64)


def _cluster_points(vertices: FloatArray, triangles: IntArray, group: IntArray, *, cell: float) -> FloatArray:
    """Return the vertex of each group [k, 3]: nearest the planes of its triangles, within a cell of its mean."""
    count = np.bincount(group)
    mean = np.column_stack([np.bincount(group, weights=x) for x in vertices.T]) / count[:, None]
    corners = vertices[triangles]
    normal = area_vectors(corners)  # weighs by area squared
    A, b = np.zeros((len(count), 3, 3)), np.zeros((len(count), 3))
    for corner in range(3):
        owner = group[triangles[:, corner]]
        height = np.einsum("mi,mi->m", normal, corners[:, corner] - mean[owner])
        for i in range(3):
            b[:, i] += np.bincount(owner, weights=normal[:, i] * height, minlength=len(count))
            for j in range(3):
                A[:, i, j] += np.bincount(owner, weights=normal[:, i] * normal[:, j], minlength=len(count))
    shift = np.einsum("kij,kj->ki", np.linalg.pinv(A, rcond=SHARP, hermitian=True), b)
    length = np.linalg.norm(shift, axis=1, keepdims=True)
    return np.asarray(mean + shift * np.minimum(1.0, cell / np.maximum(length, cell)), dtype=np.float64)
