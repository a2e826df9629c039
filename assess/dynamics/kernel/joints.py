"""Motion on flexible joints between events: steps shorter than the interval of a record where the table asks for them.

A passage through rest takes the moment from its elastic line to its plateau over decades of rotation, so a body there
needs steps in proportion to y / y', whatever the record's is. They follow Hermite's quintic through y'' and its first
two derivatives over time at both ends, whose integral errs by h^7 / 100,800 times the sixth derivative of y'' (Nitadori
and Makino 2008).
The derivatives at the end come from one look at the table, which also begins the next step.
"""

from __future__ import annotations

import math
from typing import Any

from assess.dynamics.kernel.columns import LEFT, RIGHT
from assess.dynamics.kernel.cubics import (
    add_acceleration,
    evaluate_force,
    high_powers,
    segment_ahead,
    segment_at,
    time_derivatives,
)
from assess.dynamics.kernel.events import no_event
from assess.dynamics.kernel.ground import ground_over, shift
from assess.dynamics.kernel.march import SMALLEST_STEP
from assess.kernel import inlined
from spectra.arrays import FloatArray

GROW = 0.01
"""Share of the error allowed below which a step twice as long is tried, as the error goes with its sixth power."""


@inlined
def advance_on_joints(flow: Any, side: int, y: float, v: float, ground: FloatArray, scale: float, dt: float, i: int,
                      x: float, until: int, top: float, limit: float
                      ) -> tuple[int, float, float, float]:  # fmt: skip
    """Advance from x [s] after the start of interval i until an event or jump of the table is near, or the end.

    Return the interval reached, the time since its start, y and y' there.

    The error of a step is the difference of y' between the quintic and the Taylor series that the rigid tables use,
    which is of lower order; half of tolerance x rate is allowed. Steps are halved and doubled, because processors
    predict branches but wait for roots. For the same reason sums are in pairs, with what is known last at their end.
    """
    table, smooth, span, hint, accuracy, slow, pace = flow
    bottom, end = span[side, 0], span[side, 1]
    j = segment_ahead(table, y, v, hint[side], bottom, end)
    first, last = smooth[j, 0], smooth[j, 1]
    low = table[first, LEFT] if first > bottom else -math.inf
    high = table[last, RIGHT] if last < end else math.inf
    s, strictness, step, left = 1.0 - 2.0 * side, 10.0 * slow[side] * accuracy, min(pace[1], dt), dt - x
    a = shift(ground_over(ground, scale, dt, i), x)
    here = evaluate_force(table, j, y, s * a[0])
    while i < until:
        h = step if 1.01 * step < left else left
        h2 = h * h * (1 / 2)
        h3 = h * h2 * (1 / 3)
        h4 = h * h3 * (1 / 4)
        h5 = h * h4 * (1 / 5)
        k, jerk, fourth, fifth = time_derivatives(here, v, s, a)
        y1 = (y + h * v + h2 * k) + (h3 * jerk + h4 * fourth) + h5 * fifth
        v1 = (v + h * k + h2 * jerk) + h3 * fourth + h4 * fifth
        k1 = (k + h * jerk) + h2 * fourth + h3 * fifth
        if len(a) > 2:
            q4, q5 = high_powers(here, s, a)
            y1, v1 = y1 + h**6 * (q4 * (1 / 30) + h * q5 * (1 / 42)), v1 + h**5 * (q4 * (1 / 5) + h * q5 * (1 / 6))
            k1 += h**4 * (q4 + h * q5)
        if not low <= y1 <= high:
            break
        ahead, b = segment_at(table, y1, j, first, last), shift(a, h)
        there = evaluate_force(table, ahead, y1, s * b[0])
        defect = there[0] - k1
        more, v1 = h2 * (1 / 15) * defect, v1 + h * (1 / 5) * defect
        k1, jerk1, fourth1, _ = time_derivatives(add_acceleration(there, there[1] * more), v1, s, b)
        w1, w2, w3 = h * (1 / 2), h2 * (1 / 5), h3 * (1 / 20)
        v2 = (v + w1 * (k + k1)) + w2 * (jerk - jerk1) + w3 * (fourth + fourth1)
        y2 = (y + w2 * (k - k1)) + w3 * (jerk + jerk1) + w1 * (v + v2)
        error = abs(v2 - v1) * strictness
        if not error <= 1.0:
            if h < 2.0 * SMALLEST_STEP * dt:
                break
            step = 0.5 * h
            continue
        if not no_event((y, v, k), (y2, v2, k1), 1.5 * h, top, limit):  # 1.5: as of rigid tables
            break
        if error < GROW and h == step:
            step = min(2.0 * step, dt)
        here, j, y, v, left, a = add_acceleration(there, there[1] * (y2 - y1)), ahead, y2, v2, left - h, b
        if left <= 0.0:
            i, left = i + 1, dt
            if i < until:
                a = ground_over(ground, scale, dt, i)
    hint[side], pace[1] = j, step
    return i, dt - left, y, v
