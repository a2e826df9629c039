"""The table of the exact equation: y'' = -r(y) - b(y) s a(t) with cubics r and b on each segment of y."""

from __future__ import annotations

from assess.dynamics.kernel.columns import B0, B1, B2, B3, LEFT, R0, R1, R2, R3, RIGHT
from assess.dynamics.kernel.ground import Ground
from assess.kernel import compiled, inlined
from spectra.arrays import FloatArray

ForceValues = tuple[float, float, float, float, float, float, float]


@inlined
def segment_ahead(table: FloatArray, y: float, v: float, j: int, first: int, last: int) -> int:
    """Return the segment of `table` that a body at y with velocity v is about to cross, searching from segment j."""
    while j < last and (y > table[j, RIGHT] or (y == table[j, RIGHT] and v >= 0.0)):
        j += 1
    while j > first and (y < table[j, LEFT] or (y == table[j, LEFT] and v < 0.0)):
        j -= 1
    return j


@compiled
def segment_at(table: FloatArray, y: float, j: int, first: int, last: int) -> int:
    """Return the segment that holds y, searching from segment j; the first or last one beyond the ends."""
    while y > table[j, RIGHT] and j < last:
        j += 1
    while y < table[j, LEFT] and j > first:
        j -= 1
    return j


@compiled
def evaluate_force(table: FloatArray, j: int, y: float, sa: float) -> ForceValues:
    """Return y'' on segment j with three derivatives over y, then the factor of the ground, -b, with two.

    sa: ground acceleration in the sign of the branch.
    """
    d = y - table[j, LEFT]
    b3, b2, b1, b0 = table[j, B3], table[j, B2], table[j, B1], table[j, B0]
    c3, c2, c1 = table[j, R3] + b3 * sa, table[j, R2] + b2 * sa, table[j, R1] + b1 * sa
    return (
        -(((c3 * d + c2) * d + c1) * d + (table[j, R0] + b0 * sa)),
        -((3.0 * c3 * d + 2.0 * c2) * d + c1),
        -(6.0 * c3 * d + 2.0 * c2),
        -6.0 * c3,
        -(((b3 * d + b2) * d + b1) * d + b0),
        -((3.0 * b3 * d + 2.0 * b2) * d + b1),
        -(6.0 * b3 * d + 2.0 * b2),
    )


@compiled
def add_acceleration(of: ForceValues, by: float) -> ForceValues:
    """Add `by` to the acceleration term; the derivatives are unchanged."""
    return of[0] + by, of[1], of[2], of[3], of[4], of[5], of[6]


@compiled
def time_derivatives(of: ForceValues, v: float, s: float, a: Ground) -> tuple[float, float, float, float]:
    """Return the second to fifth derivative of y over time; s: sign of the branch, a: ground acceleration."""
    f, f1, f2, f3, g, g1, g2 = of
    rise = s * a[1]
    jerk = f1 * v + g * rise
    fourth = (f2 * v + 2.0 * g1 * rise) * v + f1 * f
    fifth = ((f3 * v + 3.0 * g2 * rise) * v + 3.0 * f2 * f) * v + f1 * jerk + 3.0 * g1 * rise * f
    if len(a) > 2:
        bow = 2.0 * s * a[2]
        fourth, fifth = fourth + g * bow, fifth + 3.0 * g1 * bow * v + g * (6.0 * s * a[3])
    return f, jerk, fourth, fifth


@compiled
def high_powers(of: ForceValues, s: float, a: Ground) -> tuple[float, float]:
    """Return what the fourth and fifth power of the ground add to y'' beyond `time_derivatives`; 0 for a record."""
    if len(a) == 2:
        return 0.0, 0.0
    return of[4] * (s * a[4]), of[4] * (s * a[5])
