"""Area A, first moment S and their integrals over depth, for a disc."""

from __future__ import annotations

import math

import numpy as np

from assess.kernel import compiled

Four = tuple[float, float, float, float]

SHORT = 0.1
"""Arc of a disc [rad], about, below which the integrals of its width are taken by Gauss' rule, exact there to rounding:
the difference of closed forms would lose digits."""

SHALLOW = 0.5
"""Depth, as a fraction of the radius, up to which the moments of a disc are power series: closed forms lose digits."""

POWERS = np.arange(22.0)
# the width of a disc, 2 (2 x)^(1/2) (1 - x / 2)^(1/2), in powers of its depth x; then integrated term by term
BINOMIAL = np.cumprod(np.append(2.0 * math.sqrt(2.0), (POWERS[1:] - 1.5) / POWERS[1:] / 2.0))
SERIES = BINOMIAL[:, None] / np.column_stack([
    POWERS + 1.5, POWERS + 2.5, (POWERS + 1.5) * (POWERS + 2.5), (POWERS + 2.5) * (POWERS + 3.5),
])  # fmt: skip
NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)


@compiled
def disc_upto(x: float) -> Four:
    """Return A, S and their integrals over depth for a disc of radius 1 up to the depth x in [0, 2]."""
    if x > SHALLOW:
        sine, cosine = math.sqrt(x * (2.0 - x)), 1.0 - x
        angle, cube = math.acos(cosine), 2.0 / 3.0 * sine**3
        area = angle - sine * cosine
        first = area - cube
        second = area - 2.0 * cube + (angle + sine * cosine * (2.0 * sine**2 - 1.0)) / 4.0
        return area, first, x * area - first, x * first - second
    area, first, area_sum, first_sum = 0.0, 0.0, 0.0, 0.0
    for n in range(SERIES.shape[0] - 1, -1, -1):
        area, first = area * x + SERIES[n, 0], first * x + SERIES[n, 1]
        area_sum, first_sum = area_sum * x + SERIES[n, 2], first_sum * x + SERIES[n, 3]
    root = math.sqrt(x) * x
    return area * root, first * root * x, area_sum * root * x, first_sum * root * x * x


@compiled
def disc_between(x0: float, x1: float, length: float) -> Four:
    """Integrate width, depth times width, A and S of a disc of radius 1 from x0 to x1; length: x1 - x0, unrounded."""
    if x0 <= 0.0:
        return disc_upto(x1)
    a0, s0, f0, g0 = disc_upto(x0)
    if length > SHORT * math.sqrt(x1 * (2.0 - x0)):
        a1, s1, f1, g1 = disc_upto(x1)
        return a1 - a0, s1 - s0, f1 - f0, g1 - g0
    area, first, area_sum, first_sum = 0.0, 0.0, a0 * length, s0 * length
    start, end = 2.0 * math.asin(math.sqrt(0.5 * x0)), 2.0 * math.asin(math.sqrt(0.5 * x1))
    middle, half = 0.5 * (start + end), 0.5 * (end - start)
    for n in range(NODES.size):
        angle = middle + half * NODES[n]
        x, part = 2.0 * math.sin(0.5 * angle) ** 2, 2.0 * half * WEIGHTS[n] * math.sin(angle) ** 2
        area, first = area + part, first + x * part
        area_sum, first_sum = area_sum + (x1 - x) * part, first_sum + (x1 - x) * x * part
    return area, first, area_sum, first_sum


@compiled
def integrate_disc(radius: float, edge: float, z0: float, z1: float) -> Four:
    """Integrate width, depth times width, A and S of a disc from z0 to z1, depths from the edge of the section."""
    end = edge + 2.0 * radius
    low, high, beyond = max(z0, edge), min(z1, end), max(z1 - max(z0, end), 0.0)
    area, first, area_sum, first_sum = 0.0, 0.0, 0.0, 0.0
    if high > low:
        x0, x1 = max((low - edge) / radius, 0.0), min((high - edge) / radius, 2.0)
        area, first, area_sum, first_sum = disc_between(x0, x1, (high - low) / radius)
    square, whole = radius * radius, math.pi * radius * radius
    area, first, area_sum = square * area, square * radius * first, square * radius * area_sum + whole * beyond
    first_sum = square * square * first_sum + whole * radius * beyond
    return area, first + edge * area, area_sum, first_sum + edge * area_sum
