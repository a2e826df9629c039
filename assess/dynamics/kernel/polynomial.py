"""Polynomials of time: the motion y over one step, and its roots."""

from __future__ import annotations

from assess.kernel import compiled

Arc = tuple[float, float, float, float, float, float, float, float, float]  # of y [-], lowest power of time first


@compiled
def evaluate(c: Arc, x: float) -> float:
    """Return the polynomial at time x, summed in pairs (Estrin 1960), which a processor evaluates in parallel."""
    x2 = x * x
    low, high = (c[0] + c[1] * x) + (c[2] + c[3] * x) * x2, (c[4] + c[5] * x) + (c[6] + c[7] * x) * x2
    x4 = x2 * x2
    return low + (high + c[8] * x4) * x4


@compiled
def derivative(c: Arc) -> Arc:
    """Return the derivative over time."""
    return c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4], 5.0 * c[5], 6.0 * c[6], 7.0 * c[7], 8.0 * c[8], 0.0


@compiled
def find_root(c: Arc, level: float, end: float) -> float:
    """Return the time in (0, end] at which the polynomial, monotone there, passes `level`.

    Newton's method within a bracket that only shrinks.
    """
    rate, low, high = derivative(c), 0.0, end
    start, stop = c[0] - level, evaluate(c, end) - level
    x = end * (start / (start - stop)) if start != 0.0 else end
    for _ in range(60):
        f, slope = evaluate(c, x) - level, evaluate(rate, x)
        if f == 0.0:
            return x
        if (f > 0.0) == (stop > 0.0):
            high = x
        else:
            low = x
        new = x - f / slope if slope != 0.0 else -1.0
        if not low <= new <= high:
            new = 0.5 * (low + high)
        if abs(new - x) <= 1e-9 * end:  # the error of the next one goes with the square of this
            return new
        x = new
    return x


@compiled
def divide_by_time(c: Arc) -> Arc:
    """Divide a polynomial that is zero at x = 0 by x, to find its other root."""
    return c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], 0.0


@compiled
def find_peak(c: Arc, rate: Arc, end: float) -> float:
    """Return the time in (0, end] of the only peak of a polynomial that rises at the start and falls at the end."""
    return find_root(rate, 0.0, end) if rate[0] > 0.0 else find_root(divide_by_time(rate), 0.0, end)
