"""The ground acceleration over one interval of a record or one piece of a pulse."""

from __future__ import annotations

import math

from assess.dynamics.kernel.columns import BLOCK, HIGHEST, LOWEST
from assess.kernel import compiled
from spectra.arrays import FloatArray

Ground = tuple[float, ...]  # acceleration as a polynomial of time, lowest power first: 2 of a record, 6 of a pulse


@compiled
def count_intervals(ground: FloatArray) -> int:
    """Return the number of intervals of a record (samples [n]) or of a pulse (polynomials [n, 6])."""
    return len(ground) - 1 if ground.ndim == 1 else len(ground)


@compiled
def ground_over(ground: FloatArray, scale: float, dt: float, i: int) -> Ground:
    """Return the ground acceleration over interval i."""
    if ground.ndim == 1:
        a = scale * ground[i]
        return a, (scale * ground[i + 1] - a) / dt
    c = scale * ground[i, 0], scale * ground[i, 1], scale * ground[i, 2]
    return c[0], c[1], c[2], scale * ground[i, 3], scale * ground[i, 4], scale * ground[i, 5]


@compiled
def still_ground(ground: FloatArray) -> Ground:
    """Return zero acceleration, with as many powers of time as `ground` has."""
    if ground.ndim == 1:
        return 0.0, 0.0
    return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


@compiled
def shift(a: Ground, x: float) -> Ground:
    """Return the acceleration as a polynomial of the time after x."""
    if len(a) == 2:
        return a[0] + a[1] * x, a[1]
    c4 = a[4] + 5.0 * a[5] * x
    c3 = a[3] + (4.0 * a[4] + 10.0 * a[5] * x) * x
    c2 = a[2] + (3.0 * a[3] + (6.0 * a[4] + 10.0 * a[5] * x) * x) * x
    c1 = a[1] + (2.0 * a[2] + (3.0 * a[3] + (4.0 * a[4] + 5.0 * a[5] * x) * x) * x) * x
    return ground_at(a, x), c1, c2, c3, c4, a[5]


@compiled
def ground_at(a: Ground, x: float) -> float:
    """Return the acceleration at time x."""
    if len(a) == 2:
        return a[0] + a[1] * x
    return a[0] + (a[1] + (a[2] + (a[3] + (a[4] + a[5] * x) * x) * x) * x) * x


@compiled
def skip_idle(
    ground: FloatArray, blocks: FloatArray, scale: float, lowest: float, highest: float, i: int, until: int
) -> int:
    """Return the first interval from i to `until` in which the ground acceleration leaves [lowest, highest].

    blocks [n, 2]: least and largest sample of every BLOCK intervals, which are passed by one look at these.
    """
    if ground.ndim == 1:
        while i < until and lowest <= scale * ground[i] <= highest and lowest <= scale * ground[i + 1] <= highest:
            i += 1
            if i % BLOCK == 0:
                n = i // BLOCK
                while (
                    i + BLOCK <= until
                    and lowest <= scale * blocks[n, LOWEST] <= highest
                    and lowest <= scale * blocks[n, HIGHEST] <= highest
                ):
                    i, n = i + BLOCK, n + 1
    return i


@compiled
def stretch_pulse(ground: FloatArray, pulse: FloatArray, frequency: float) -> None:
    """Fill `ground` [n, 6] with the polynomials of time of a pulse given as polynomials of its phase [n, 6]."""
    for i in range(len(pulse)):
        factor = 1.0
        for m in range(6):
            ground[i, m] = factor * pulse[i, m]
            factor *= 2.0 * math.pi * frequency
