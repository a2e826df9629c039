"""The spire of San Leonardo Limosino, a hollow cone.

Mehrotra, Table 5.1, gives p and slenderness of what a crack leaves of the spire, for cracks that start at a depth h_c
below the tip and rise at an angle beta; the elevation of the start is h. All h + h_c are 22.25 m and h_c = H is at
18.25 m, so the spire is H = 4.0 m high. Its width stands in a figure only. Radius and wall are those of the cone that
fits the table best: 0.76 m and 0.23 m, two numbers found from twelve by least squares of their relative distances.
"""

from __future__ import annotations

import numpy as np

from assess.examples.surface import Surface, revolve

FOOT, HEIGHT = 18.25, 4.0  # m: Table 5.1
RADIUS, WALL = 0.76, 0.23  # m: radius of the foot, and level thickness of the wall
FACES = 24
ROWS = 13


def spire(*, radius: float = RADIUS, wall: float = WALL) -> Surface:
    """Return a cone of `radius` at its foot, hollow but for a wall of horizontal thickness `wall` [m]."""
    outer, inner = np.linspace(radius, 0.0, ROWS), np.linspace(0.0, radius - wall, ROWS)
    hollow = HEIGHT * (1.0 - wall / radius)
    up, down = np.linspace(0.0, HEIGHT, ROWS), np.linspace(hollow, 0.0, ROWS)
    return revolve([*zip(outer, FOOT + up, strict=True), *zip(inner, FOOT + down, strict=True)], faces=FACES)


def meshes() -> dict[str, Surface]:
    """Return the spire's surface, by the file that the project names."""
    return {"spire.ply": spire()}
