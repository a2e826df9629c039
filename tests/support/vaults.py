"""Vaults of tests: the section of a barrel, two barrels that cross, and what thickens a surface."""

from __future__ import annotations

import numpy as np


def barrel_section(
    *, radius: float = 3.0, thickness: float = 0.15, springing: float = 0.0, half_angle: float = np.pi / 2, parts: int
) -> np.ndarray:
    """Return the corners [2 (parts + 1), 2] of a circular barrel about (0, springing), by its mean radius [m]."""
    angle = np.linspace(-half_angle, half_angle, parts + 1)
    inner, outer = (
        np.column_stack([r * np.sin(angle), springing + r * np.cos(angle)])
        for r in (radius - thickness / 2, radius + thickness / 2)
    )
    return np.concatenate([inner, outer[::-1]])


def groined_vault(
    *, span: float = 6.0, rise: float = 2.0, springing: float = 0.0, thickness: float = 0.125, cells: int = 24
) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices and triangles of two parabolic barrels that cross over a square bay; thickness upright."""
    edge = np.linspace(-span / 2, span / 2, cells + 1)
    x, y = np.meshgrid(edge, edge, indexing="ij")
    return thicken(x, y, springing + rise * (1 - (np.minimum(np.abs(x), np.abs(y)) * 2 / span) ** 2), thickness)


def thicken(x: np.ndarray, y: np.ndarray, z: np.ndarray, thickness: float) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices and triangles of a closed shell over a grid of points x, y, z [n, n], rows along x."""
    n = len(x)
    below = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    i = np.arange(n * n).reshape(n, n)
    a, b, c, d = (each.ravel() for each in (i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]))
    top = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    rim = np.concatenate([i[:-1, 0], i[-1, :-1], i[:0:-1, -1], i[0, :0:-1]])
    after = np.roll(rim, -1)
    sides = np.concatenate(
        [np.column_stack([rim, after, after + n * n]), np.column_stack([rim, after + n * n, rim + n * n])]
    )
    triangles = np.concatenate([top[:, ::-1], top + n * n, sides])
    return np.concatenate([below, below + np.array([0.0, 0.0, thickness])]), triangles
