"""Events of a rocking body: uplift, impact, peak, rest and overturning."""

from __future__ import annotations

from assess.dynamics.kernel.columns import HAPPENED, KIND, LARGEST, ON, THRESHOLD, VALUE, WHEN
from assess.dynamics.kernel.ground import Ground, ground_at
from assess.dynamics.kernel.polynomial import find_root
from assess.kernel import compiled
from spectra.arrays import FloatArray

State = tuple[float, float, float]  # y [-], y' [1/s], y'' [1/s2]

REST = 1e-4
"""A body is at rest after an impact that leaves it slower than REST times the velocity that would carry it to y = 1 on
the new side (p, linearised), if the ground acceleration is below uplift. Without such a rule a bouncing body would have
infinitely many impacts in finite time."""
NO_BOUNCE = 1e-12
"""Below this fraction of that velocity the body is at rest whatever the ground acceleration is."""


@compiled
def no_event(start: State, end: State, h: float, top: float, limit: float) -> bool:
    """Return True if two states h [s] apart have no event between them.

    Events are an impact, a passage of y = 1, a peak above `top`, and an end at or beyond `limit`.

    Between samples |y''| is largest at an end (where y'' > 0 it is convex, where y'' < 0 concave), so a velocity
    beyond h max|y''| keeps its sign; without inflection the velocity is monotone and turns once at most.
    """
    y, v, k = start
    y1, v1, k1 = end
    if y1 <= 0.0 or y1 >= limit or (y < 1.0) != (y1 < 1.0):
        return False
    if abs(v) > h * max(abs(k), abs(k1)):
        return True
    if k * k1 <= 0.0:
        return False
    if v * v1 > 0.0:
        return True
    return y + v * h > 0.0 if v < 0.0 else y + v * h < min(top, 1.0)


@compiled
def find_uplift(branch: FloatArray, a: Ground, h: float) -> tuple[int, float]:
    """Return the side that lifts within h [s] under the ground acceleration a, and when; side -1 if none does."""
    for side in range(2):  # before one that lifts later
        if -(1.0 - 2.0 * side) * a[0] > branch[side, THRESHOLD]:
            return side, 0.0
    for side in range(2):
        s = 1.0 - 2.0 * side
        if -s * ground_at(a, h) > branch[side, THRESHOLD]:
            excess = -s * a[0] - branch[side, THRESHOLD]
            if len(a) == 2:
                return side, min(-excess / (-s * a[1]), h)
            over = (excess, -s * a[1], -s * a[2], -s * a[3], -s * a[4], -s * a[5], 0.0, 0.0, 0.0)
            return side, find_root(over, 0.0, h)
    return -1, h


@compiled
def lifts(branch: FloatArray, a: float) -> bool:
    """Return whether a ground acceleration a would start a body at rest."""
    return bool(-a > branch[0, THRESHOLD] or a > branch[1, THRESHOLD])


@compiled
def record_event(events: FloatArray, time: float, kind: int, value: float, side: int) -> None:
    """Append an event if there is room for it."""
    n = int(events[0, 0]) + 1
    if n < events.shape[0]:
        events[n, HAPPENED], events[n, KIND], events[n, VALUE], events[n, ON] = time, kind, value, side
        events[0, 0] = n


@compiled
def keep_largest(found: FloatArray, y: float, side: int, time: float) -> None:
    """Keep the largest y of a side, and its time."""
    if y > found[LARGEST + side]:
        found[LARGEST + side], found[WHEN + side] = y, time
