"""The mesh of Wall 0a of the Great House, made to the rocking parameters of a published table.

Mehrotra (2019) gives p, slenderness and radius of the wall, not its mesh. A wall that is thinner at its top than at
its base has one shape with just these three numbers; its length does not matter to them.

            t
          _____
         /     \\            z_c = R cos(alpha)    half the base  b / 2 = R sin(alpha)
      H /   +   \\           z_c = H (b + 2 t) / (3 (b + t))
       /_________\\          J / M = H^2 (b^2 + 4 b t + t^2) / (18 (b + t)^2) + (b^2 + t^2) / 24
            b               p^2 = M g R / (J + M R^2)
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from math import cos, sin

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g
from scipy.optimize import brentq

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class TaperedWall:
    """A wall of symmetric trapezoidal section: thickness at base and top, height, length [m]."""

    base: float
    top: float
    height: float
    length: float


def tapered_wall(*, p: float, slenderness: float, radius: float, length: float) -> TaperedWall:
    """The wall of uniform density with frequency parameter `p` [1/s], `slenderness` [rad] and `radius` [m].

    Raises ValueError (from the root finder) where no taper between a triangle and a rectangle gives p.
    """
    b, z_c = 2 * radius * sin(slenderness), radius * cos(slenderness)
    wanted = g * radius / p**2 - radius**2

    def excess(t: float) -> float:
        H = _height(b, t, z_c)
        return float(H**2 * (b**2 + 4 * b * t + t**2) / (18 * (b + t) ** 2) + (b**2 + t**2) / 24 - wanted)

    t = float(brentq(excess, 0.0, b, xtol=1e-15))
    return TaperedWall(b, t, _height(b, t, z_c), length)


def _height(b: float, t: float, z_c: float) -> float:
    return 3 * z_c * (b + t) / (b + 2 * t)


def corners(wall: TaperedWall) -> FloatArray:
    """The eight corners [8, 3] [m], x across the wall, base centred on the origin: by z, then y, then x."""
    half = {0.0: wall.base / 2, wall.height: wall.top / 2}
    signs, lengths = (-1.0, 1.0), (-wall.length / 2, wall.length / 2)
    return np.array([(sign * half[z], y, z) for z, y, sign in product(half, lengths, signs)])


_SIDES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))  # seen from outside


def ascii_stl(wall: TaperedWall, *, name: str) -> str:
    """The wall as a closed triangle mesh in ASCII STL, at full precision."""
    points = corners(wall)
    triangles = [points[list(t)] for a, b, c, d in _SIDES for t in ((a, b, c), (a, c, d))]
    return f"solid {name}\n" + "".join(map(_facet, triangles)) + f"endsolid {name}\n"


def _facet(triangle: FloatArray) -> str:
    normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
    rows = "".join(f"      vertex {_numbers(vertex)}\n" for vertex in triangle)
    unit = _numbers(normal / np.linalg.norm(normal))
    return f"  facet normal {unit}\n    outer loop\n{rows}    endloop\n  endfacet\n"


def _numbers(vector: FloatArray) -> str:
    return " ".join(repr(float(x) + 0.0) for x in vector)


WALL_0A = tapered_wall(p=1.60, slenderness=0.14, radius=2.84, length=3.0)
