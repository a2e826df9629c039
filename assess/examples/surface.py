"""Closed triangle surfaces of the examples' bodies, and the file they are written to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray, IntArray


@dataclass(frozen=True)
class Surface:
    """A closed surface: points [n, 3] [m]; triangles of them, anticlockwise seen from outside [m, 3]."""

    points: FloatArray
    triangles: IntArray


def slab(front: ArrayLike, back: ArrayLike) -> Surface:
    """Return the body between two faces, each a grid of rows from bottom to top and columns along y.

    front, back : [rows, columns, 3] [m]; front is the face at larger x, the bottom and the top row close the body.
    """
    faces = np.concatenate([np.asarray(front), np.asarray(back)[:, ::-1]], axis=1)
    rows, around, _ = faces.shape
    ring = np.arange(around)
    rings = ring + around * np.arange(rows)[:, None]
    j = np.arange(around // 2 - 1)
    bottom = _split(around - 1 - j, around - 2 - j, j + 1, j)
    top = _split(j, j + 1, around - 2 - j, around - 1 - j) + around * (rows - 1)
    sides = _split(rings[:-1], np.roll(rings, -1, axis=1)[:-1], np.roll(rings, -1, axis=1)[1:], rings[1:])
    return Surface(faces.reshape(-1, 3), np.concatenate([sides, bottom, top]))


def revolve(profile: ArrayLike, *, faces: int) -> Surface:
    """Revolve a polygon of (radius, elevation) about the vertical axis, as a prism of so many `faces`.

    Faces touch the circles, an even number of them: the middles of two are at x = -r and x = r, and a section has the
    area n tan(pi / n) r^2.

    profile : corners anticlockwise, the first not repeated [k, 2] [m]; those of radius 0 lie on the axis
    """
    radius, elevation = np.asarray(profile, dtype=np.float64).T
    step = 2.0 * np.pi / faces
    angle = (np.arange(faces) + 0.5) * step
    x, y = radius[:, None] / np.cos(step / 2.0) * np.stack([np.cos(angle), np.sin(angle)])[:, None]
    points = np.stack([x, y, np.broadcast_to(elevation[:, None], x.shape)], -1)
    number = np.arange(len(radius) * faces).reshape(len(radius), faces)
    number[radius == 0.0] = number[radius == 0.0, :1]
    turned, raised = np.roll(number, -1, axis=1), np.roll(number, -1, axis=0)
    return _without_lines(points.reshape(-1, 3), _split(number, turned, np.roll(raised, -1, axis=1), raised))


def ply(surface: Surface) -> bytes:
    """Write the surface as a PLY file (binary, double precision), the same bytes on every machine."""
    header = (
        "ply\nformat binary_little_endian 1.0\ncomment metres\n"
        f"element vertex {len(surface.points)}\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face {len(surface.triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(len(surface.triangles), dtype=[("corners", "u1"), ("index", "<i4", 3)])
    faces["corners"], faces["index"] = 3, surface.triangles
    return header.encode("ascii") + surface.points.astype("<f8").tobytes() + faces.tobytes()


def _split(a: IntArray, b: IntArray, c: IntArray, d: IntArray) -> IntArray:
    """Split each quadrangle a, b, c, d into two triangles."""
    return np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], -2).reshape(-1, 3)


def _without_lines(points: FloatArray, triangles: IntArray) -> Surface:
    """Drop degenerate triangles and unused points."""
    a, b, c = triangles.T
    whole = triangles[(a != b) & (b != c) & (c != a)]
    used, numbers = np.unique(whole, return_inverse=True)
    return Surface(points[used], numbers.reshape(whole.shape))
