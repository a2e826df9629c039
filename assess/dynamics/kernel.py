"""The rocking equation marched through jobs (oscillator, motion, scale), compiled.

One branch at a time, in its own mirrored sign s = +1 or -1, with y = phi / phi_ov and the ground acceleration a(t)
linear between samples:

    exact        I(y) y'' + 1/2 I'(y) y'^2 + R(y) = -s B(y) a(t)      I, R, B: the cubics of the branch's table
    linearised   y'' = p^2 (y - 1 - s a(t) / threshold)               threshold = g lambda

Both equations share one march and one treatment of events; what differs is handed over as three functions:

    glide         over whole record intervals, fast, as far as `calm` and the error allow
    advance       over any part of an interval
    acceleration  y'' of a state

The linearised ones are the closed solution. The exact ones are Dormand and Prince's pair 5(4), whose steps end at
samples, where a(t) has its kinks, and at jumps of the table. Whether something can happen in an interval (impact,
passage of phi_ov, a new largest rotation) is decided by `calm`; only where it can, `through` divides the interval
into pieces over which the velocity, then the rotation, is monotone, so that no event can hide between two samples,
and locates each event by stepping again from the start of the piece.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assess.kernel import compiled, entry, reachable

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
State = tuple[float, float, float]  # y [-], y' [1/s], y'' [1/s2]
Ground = tuple[float, float]  # acceleration [m/s2] and its rate [m/s3]
Glide = Callable[..., tuple[int, float, float, float]]
Advance = Callable[..., State]
Acceleration = Callable[..., float]
March = Callable[..., int]

REST = 1e-4
"""After an impact slower than REST times the velocity that reaches phi_ov (p phi_ov, linearised), with the ground
below uplift, the body is at rest. Without such a rule a bouncing body has infinitely many impacts in finite time."""
NO_BOUNCE = 1e-12
"""Below this fraction of the same velocity there is no flight at all, whatever the ground does."""
TAIL_PIECE = 0.5
TAIL_PIECES = 120
"""Free motion after the record goes in at most TAIL_PIECES pieces of TAIL_PIECE / p, p of the quicker branch."""

SMALLEST_STEP = 1e-6
"""Of an interval: the least step of the exact equation, so that a body rattling about a jump of its table still moves
on, and the least distance of an inflection from where it is looked for. What is neglected goes with its square."""

ON_A_JUMP = 1e-15
"""Of phi_ov: so near to a jump of the table the body is on it."""

# columns of `branch` [2, 7], one row for each side
OVERTURNING, THRESHOLD, BOUNCE, PARTNER, RATE, LIMIT, TAIL_LIMIT = range(7)
# columns of `found` [jobs, 7]
RATIO, SIDE, TIME, IMPACTS, OVERTURNED, PASSED, UPLIFTED = range(7)
# columns of `events` [capacity + 1, 3], whose first entry counts: time [s], kind, rotation of a peak [rad] or velocity
# before an impact [rad/s], signed
PEAK, IMPACT, UPLIFT = range(3)
# what may divide an interval, named by the component of the state that vanishes; a passage is y = 1
LANDING, TURNING, INFLECTION, PASSAGE = range(4)
# columns of `table` [segments, 14]: ends of the segment, then the cubics of R, B and I, highest power first
LEFT, RIGHT, R3, R2, R1, R0, B3, B2, B1, B0, I3, I2, I1, I0 = range(14)
# columns of `flow` of the linearised equation [2, 8]
P2, INVERSE, Y_K, Y_V, Y_A, V_K, V_V, V_A = range(8)


# ---------------------------------------------------------------------------------------------------- events, shared


@compiled
def calm(start: State, end: State, h: float, top: float, limit: float) -> bool:
    """Whether nothing happens between two states h [s] apart.

    No impact, no passage of y = 1, no peak above `top`, no end at or beyond `limit`.

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
def uplift(branch: FloatArray, a: float, slope: float, h: float) -> tuple[int, float]:
    """Side that lifts within h, and when; side -1 where none does. a, slope: ground acceleration now and its rate."""
    for side in range(2):
        s = 1.0 - 2.0 * side
        excess, rise = -s * a - branch[side, THRESHOLD], -s * slope
        if excess > 0.0:
            return side, 0.0
        if rise * h > -excess:
            return side, min(-excess / rise, h)
    return -1, h


@compiled
def lifted(branch: FloatArray, a: float) -> bool:
    """Whether a body at rest would start under ground acceleration a."""
    return bool(-a > branch[0, THRESHOLD] or a > branch[1, THRESHOLD])


@compiled
def idle(ground: FloatArray, scale: float, lowest: float, highest: float, i: int, until: int) -> int:
    """The first interval from i on, or `until`, in which the ground acceleration leaves [lowest, highest]."""
    while i < until and lowest <= scale * ground[i] <= highest and lowest <= scale * ground[i + 1] <= highest:
        i += 1
    return i


@compiled
def note(events: FloatArray, time: float, kind: int, value: float) -> None:
    """Append an event where there is room for it."""
    n = int(events[0, 0]) + 1
    if n < events.shape[0]:
        events[n, 0], events[n, 1], events[n, 2] = time, kind, value
        events[0, 0] = n


@compiled
def largest(found: FloatArray, y: float, side: int, time: float) -> None:
    """Keep the largest ratio."""
    if y > found[RATIO]:
        found[RATIO], found[SIDE], found[TIME] = y, side, time


def marching(glide: Glide, advance: Advance, acceleration: Acceleration) -> March:
    """The march of one job by the equation that the three functions stand for."""

    @compiled
    def locate(flow: Any, side: int, start: State, ground: Ground, end: float, last: State, component: int,
               level: float) -> tuple[float, State]:  # fmt: skip
        """Time in (0, end) at which a component of the state passes `level`, and the state there.

        Newton's method (secant for y'', whose derivative is not at hand) within a bracket that only shrinks; each state
        is reached from the bracket's beginning.
        """
        f_start, before, f_before = start[component] - level, end, last[component] - level
        low, high, x, state, close = 0.0, end, end * f_start / (f_start - f_before), last, False
        for _ in range(60):
            state = advance(flow, side, start, (ground[0] + ground[1] * low, ground[1]), x - low)
            if close:
                break
            f = state[component] - level
            if (f > 0.0) == (f_start > 0.0):
                low, start = x, state
            else:
                high = x
            slope = state[component + 1] if component < 2 else (f - f_before) / (x - before)
            new = x - f / slope if slope != 0.0 else -1.0
            close = abs(new - x) <= 1e-8 * end  # the error of the next one is the square of this
            if not low <= new <= high:
                new, close = 0.5 * (low + high), high - low <= 1e-15 * end
            before, f_before, x = x, f, new
        return x, state

    @compiled
    def through(flow: Any, branch: FloatArray, found: FloatArray, events: FloatArray, column: int, peaked: int,
                wanted: int, side: int, y: float, v: float, time: float, a0: float, slope: float,
                h: float) -> tuple[int, float, float, int]:  # fmt: skip
        """Through h [s] from `time` with all events: side (-1 at rest), y, y' at the end, and the sides that peaked.

        a0, slope: ground acceleration at `time` and its rate. column: of `branch`, the limit that means overturned.
        It ends early once all the `wanted` sides have peaked (bits; 0: goes on).

        Each turn of the loop moves on in time, or stops the velocity, or puts the body to rest.
        """
        x = 0.0
        while x < h:
            a, left = a0 + slope * x, h - x
            if side < 0:
                side, wait = uplift(branch, a, slope, left)
                if side < 0:
                    break
                x, y, v = x + wait, 0.0, 0.0
                found[UPLIFTED] = 1.0
                note(events, time + x, UPLIFT, 0.0)
                continue
            k = acceleration(flow, side, y, v, a)
            if y == 0.0 and v == 0.0:
                k = max(k, 0.0)  # just lifted: not falling by a rounding error
            start, piece, peak, landed = (y, v, k), left, False, False
            end = advance(flow, side, start, (a, slope), left)
            # An inflection ends the piece: up to it the velocity is monotone. So does a turning point: up to it the
            # rotation is monotone. So does landing; a passage of phi_ov does not.
            for kind in (INFLECTION, TURNING, LANDING, PASSAGE):
                component, level = (LANDING, 1.0) if kind == PASSAGE else (kind, 0.0)
                before, after = start[component] - level, end[component] - level
                if kind == LANDING:
                    landed = after < 0.0
                crosses = before < 0.0 <= after if kind == PASSAGE else before * after < 0.0
                if not crosses:
                    continue
                root, state = locate(flow, side, start, (a, slope), piece, end, component, level)
                if kind == PASSAGE:
                    found[PASSED] = time + x + root
                elif kind != INFLECTION or root > SMALLEST_STEP * h:
                    piece, end = root, state
                if kind == TURNING:
                    peak = v > 0.0
                    end = (max(end[0], y) if peak else end[0], 0.0, end[2])
            if landed:
                if y > 0.0:
                    x, v = x + piece, min(end[1], 0.0)
                elif v == 0.0:
                    return -1, 0.0, 0.0, peaked  # neither flight nor speed: rest, for what is left of the interval
                found[IMPACTS] += 1.0
                sign, slow = 1.0 - 2.0 * side, REST * branch[side, RATE]
                note(events, time + x, IMPACT, sign * v * branch[side, OVERTURNING])
                v, y, side = -v * branch[side, BOUNCE], 0.0, int(branch[side, PARTNER])
                if v < slow and (v < slow * (NO_BOUNCE / REST) or not lifted(branch, a0 + slope * x)):
                    side, v = -1, 0.0
                continue
            x, y, v = (h if piece == left else x + piece), end[0], end[1]
            if peak:
                peaked |= 1 << side
                largest(found, y, side, time + x)
                note(events, time + x, PEAK, (1.0 - 2.0 * side) * y * branch[side, OVERTURNING])
            if y >= branch[side, column] and v >= 0.0:
                found[OVERTURNED] = 1.0
                largest(found, y, side, time + x)
                break
            if wanted > 0 and peaked == wanted:
                break
        return side, y, v, peaked

    @reachable
    def march(flow: Any, branch: FloatArray, ground: FloatArray, dt: float, scale: float, release: float,
              found: FloatArray, path: FloatArray, events: FloatArray) -> int:  # fmt: skip
        """One job: the motion `ground` [n] at step dt, times `scale`. Returns the number of samples passed.

        release: initial phi / phi_ov of the positive branch, 0 for rest. found [7]: filled. path [n or 0, 2]: rotation
        [rad] and velocity [rad/s] at samples, signed, where wanted; events [capacity + 1, 3]: likewise.

        After the record the motion is free, and is followed until no later peak can be larger: until each side has
        peaked, or rest, or overturning. Who still balances after the last piece, which takes a distance from the
        threshold below the rounding error, has overturned if beyond phi_ov.
        """
        for c in range(found.shape[0]):
            found[c] = math.nan if c == PASSED else 0.0
        side, y, v, k, a = -1, 0.0, 0.0, 0.0, scale * ground[0]
        if release > 0.0:
            side, y = 0, release
            k = acceleration(flow, side, y, v, a)
            largest(found, y, side, 0.0)
        traced, top = path.shape[0] > 0, -1.0 if events.shape[0] > 1 else found[RATIO]
        if traced:
            path[0, 0], path[0, 1] = y * branch[0, OVERTURNING], 0.0
        lowest, highest = -branch[0, THRESHOLD], branch[1, THRESHOLD]
        last, tail = ground.shape[0] - 1, TAIL_PIECE / max(branch[0, RATE], branch[1, RATE])
        both = 1 | (1 << int(branch[0, PARTNER]))
        samples, peaked, wanted, column, h, time, i = last + 1, 0, 0, LIMIT, dt, 0.0, 0
        while i < last + TAIL_PIECES:
            a0, a, begun, until = 0.0, 0.0, i, i + 1 if traced else last
            if i < last:
                if side < 0:
                    i = idle(ground, scale, lowest, highest, i, until)
                else:
                    i, y, v, k = glide(flow, side, y, v, k, ground, scale, dt, i, until, top, branch[side, LIMIT])
                if i < until:
                    a0, a, time = scale * ground[i], scale * ground[i + 1], i * dt
            elif side < 0 or (wanted > 0 and peaked == wanted):
                break
            else:
                if wanted == 0:
                    peaked, wanted, column, h = 0, both, TAIL_LIMIT, tail
                time = last * dt + (i - last) * tail
            if begun >= last or i < until:
                side, y, v, peaked = through(
                    flow, branch, found, events, column, peaked, wanted, side, y, v, time, a0, (a - a0) / h, h
                )  # fmt: skip
                i += 1
                if side >= 0:
                    k = acceleration(flow, side, y, v, a)
                if top >= 0.0:
                    top = found[RATIO]
            if traced and begun < last:
                turn = (1.0 - 2.0 * side) * branch[side, OVERTURNING] if side >= 0 else 0.0
                path[i, 0], path[i, 1] = turn * y, turn * v
            if found[OVERTURNED] > 0.0:
                samples = min(samples, i + 1)
                break
        if side >= 0 and y >= 1.0 and peaked != wanted:
            found[OVERTURNED] = 1.0  # or balances beyond phi_ov for ever
        if found[OVERTURNED] > 0.0:
            largest(found, y, side, time + h)
            if math.isnan(found[PASSED]):
                found[PASSED] = time + h  # never below phi_ov, or a table that ends before it
        return int(samples)

    return march


# --------------------------------------------------------------------------------------------------- the linearised


@compiled
def growth(x: float) -> tuple[float, float, float]:
    """sinh x, cosh x - 1 and sinh x - x, each without cancellation."""
    q = x * x
    if q < 0.25:
        sinh_x = 1 + q * (1 / 20) * (1 + q * (1 / 42) * (1 + q * (1 / 72) * (1 + q * (1 / 110) * (1 + q * (1 / 156)))))
        cosh_1 = 1 + q * (1 / 12) * (1 + q * (1 / 30) * (1 + q * (1 / 56) * (1 + q * (1 / 90) * (1 + q * (1 / 132)))))
        sinh_x, cosh_1 = x * q * (1 / 6) * sinh_x, 0.5 * q * cosh_1
        return x + sinh_x, cosh_1, sinh_x
    sinh, half = math.sinh(x), math.sinh(0.5 * x)
    return sinh, 2.0 * half * half, sinh - x


@reachable
def linearised_flow(branch: FloatArray, dt: float) -> FloatArray:
    """What the closed solution over one interval is made of, for each side [2, 8]; zeros for a side not there."""
    flow = np.empty((2, 8))
    for side in range(2):
        for c in range(8):
            flow[side, c] = 0.0
        p = branch[side, RATE]
        if p > 0.0:
            sinh, cosh_1, sinh_x = growth(p * dt)
            inverse = (1.0 - 2.0 * side) / branch[side, THRESHOLD]
            flow[side, P2], flow[side, INVERSE] = p * p, inverse
            flow[side, Y_K], flow[side, Y_V], flow[side, Y_A] = cosh_1 / p**2, sinh / p, -inverse * sinh_x / (p * dt)
            flow[side, V_K], flow[side, V_V], flow[side, V_A] = sinh / p, cosh_1, -inverse * cosh_1 / dt
    return flow


@compiled
def linearised_acceleration(flow: FloatArray, side: int, y: float, v: float, a: float) -> float:
    """y'' = p^2 (y - 1 - s a / threshold)."""
    return float(flow[side, P2] * (y - 1.0 - flow[side, INVERSE] * a))


@compiled
def linearised_glide(flow: FloatArray, side: int, y: float, v: float, k: float, ground: FloatArray, scale: float,
                     dt: float, i: int, until: int, top: float,
                     limit: float) -> tuple[int, float, float, float]:  # fmt: skip
    """y1 = y + y'' (cosh - 1) / p^2 + y' sinh / p - s (a1 - a0) / threshold (sinh - p dt) / (p dt), in increments."""
    p2, inverse = flow[side, P2], flow[side, INVERSE]
    y_k, y_v, y_a = flow[side, Y_K], flow[side, Y_V], flow[side, Y_A]
    v_k, v_v, v_a = flow[side, V_K], flow[side, V_V], flow[side, V_A]
    a = scale * ground[i]
    while i < until:
        a1 = scale * ground[i + 1]
        y1 = y + (k * y_k + v * y_v + (a1 - a) * y_a)
        v1 = v + (k * v_k + v * v_v + (a1 - a) * v_a)
        k1 = p2 * (y1 - 1.0 - inverse * a1)
        if not calm((y, v, k), (y1, v1, k1), dt, top, limit):
            break
        i, y, v, k, a = i + 1, y1, v1, k1, a1
    return i, y, v, k


@compiled
def linearised_advance(flow: FloatArray, side: int, start: State, ground: Ground, x: float) -> State:
    """The same over any time x [s]; ground: acceleration at the start and its rate."""
    y, v, k = start
    p2, inverse = flow[side, P2], flow[side, INVERSE]
    p = math.sqrt(p2)
    sinh, cosh_1, sinh_x = growth(p * x)
    rate = inverse * ground[1]
    y1 = y + (k * cosh_1 / p2 + (v * sinh - rate * sinh_x) / p)
    v1 = v + (k * sinh / p + (v - rate) * cosh_1)
    return y1, v1, p2 * (y1 - 1.0 - inverse * (ground[0] + ground[1] * x))


march_linearised = marching(linearised_glide, linearised_advance, linearised_acceleration)


@entry
def rock_linearised(branches: FloatArray, ground: FloatArray, offset: IntArray, dt: FloatArray, peak: FloatArray,
                    oscillator: IntArray, motion: IntArray, scale: FloatArray, release: float, found: FloatArray,
                    path: FloatArray, events: FloatArray) -> int:  # fmt: skip
    """All jobs by the linearised equation; fills found [jobs, 7], returns the samples passed by the last job.

    branches [oscillators, 2, 7]; ground: all motions end to end, motion m from offset[m] to offset[m + 1]; dt, peak
    (largest |a|) of each motion; oscillator, motion, scale of each job. Beyond y = 1 + peak / threshold with y' >= 0
    the acceleration stays positive while the motion lasts, beyond 1 in free motion: overturned.
    """
    samples = 0
    branch = np.empty((2, 7))
    for j in range(oscillator.shape[0]):
        m = motion[j]
        for side in range(2):
            for c in range(7):
                branch[side, c] = branches[oscillator[j], side, c]
            branch[side, LIMIT] = 1.0 + abs(scale[j]) * peak[m] / branch[side, THRESHOLD]
        flow = linearised_flow(branch, dt[m])
        samples = march_linearised(
            flow, branch, ground[offset[m] : offset[m + 1]], dt[m], scale[j], release, found[j], path, events,
        )  # fmt: skip
    return samples


# --------------------------------------------------------------------------------------------------------- the exact


@compiled
def segment(table: FloatArray, y: float, v: float, j: int, first: int, last: int) -> int:
    """The segment of `table` in which a body at y moving with v is about to move, looked for from segment j on."""
    while j < last and (y > table[j, RIGHT] or (y == table[j, RIGHT] and v >= 0.0)):
        j += 1
    while j > first and (y < table[j, LEFT] or (y == table[j, LEFT] and v < 0.0)):
        j -= 1
    return j


@compiled
def nearby(table: FloatArray, y: float, j: int, first: int, last: int) -> int:
    """The segment that holds y, looked for from segment j on; the first or last one beyond the ends."""
    while y > table[j, RIGHT] and j < last:
        j += 1
    while y < table[j, LEFT] and j > first:
        j -= 1
    return j


@compiled
def table_acceleration(table: FloatArray, j: int, y: float, v: float, sa: float) -> float:
    """y'' by segment j; sa: ground acceleration in the branch's sign."""
    d = y - table[j, LEFT]
    restoring = ((table[j, R3] * d + table[j, R2]) * d + table[j, R1]) * d + table[j, R0]
    excitation = ((table[j, B3] * d + table[j, B2]) * d + table[j, B1]) * d + table[j, B0]
    inertia = ((table[j, I3] * d + table[j, I2]) * d + table[j, I1]) * d + table[j, I0]
    half_slope = (1.5 * table[j, I3] * d + table[j, I2]) * d + 0.5 * table[j, I1]
    return float(-(restoring + excitation * sa + half_slope * v * v) / inertia)


@compiled
def dormand_prince(table: FloatArray, j: int, first: int, last: int, y: float, v: float, k1: float, sa: float,
                   slope: float, h: float) -> tuple[float, float, float, float, float, int]:  # fmt: skip
    """One step of the pair 5(4) (Dormand and Prince 1980, Table 2): y, y', y'' at its end, the errors of y, y', and
    the segment there.

    All stages stay on segments first to last, which hold no jump. sa, slope: ground acceleration at the start and its
    rate, in the branch's sign.
    """
    w1 = v
    w2 = v + h * (k1 * (1 / 5))
    z = y + h * (w1 * (1 / 5))
    j = nearby(table, z, j, first, last)
    k2 = table_acceleration(table, j, z, w2, sa + slope * (h * (1 / 5)))
    w3 = v + h * (k1 * (3 / 40) + k2 * (9 / 40))
    z = y + h * (w1 * (3 / 40) + w2 * (9 / 40))
    j = nearby(table, z, j, first, last)
    k3 = table_acceleration(table, j, z, w3, sa + slope * (h * (3 / 10)))
    w4 = v + h * (k1 * (44 / 45) - k2 * (56 / 15) + k3 * (32 / 9))
    z = y + h * (w1 * (44 / 45) - w2 * (56 / 15) + w3 * (32 / 9))
    j = nearby(table, z, j, first, last)
    k4 = table_acceleration(table, j, z, w4, sa + slope * (h * (4 / 5)))
    w5 = v + h * (k1 * (19372 / 6561) - k2 * (25360 / 2187) + k3 * (64448 / 6561) - k4 * (212 / 729))
    z = y + h * (w1 * (19372 / 6561) - w2 * (25360 / 2187) + w3 * (64448 / 6561) - w4 * (212 / 729))
    j = nearby(table, z, j, first, last)
    k5 = table_acceleration(table, j, z, w5, sa + slope * (h * (8 / 9)))
    w6 = v + h * (k1 * (9017 / 3168) - k2 * (355 / 33) + k3 * (46732 / 5247) + k4 * (49 / 176) - k5 * (5103 / 18656))
    z = y + h * (w1 * (9017 / 3168) - w2 * (355 / 33) + w3 * (46732 / 5247) + w4 * (49 / 176) - w5 * (5103 / 18656))
    j = nearby(table, z, j, first, last)
    k6 = table_acceleration(table, j, z, w6, sa + slope * h)
    v1 = v + h * (k1 * (35 / 384) + k3 * (500 / 1113) + k4 * (125 / 192) - k5 * (2187 / 6784) + k6 * (11 / 84))
    y1 = y + h * (w1 * (35 / 384) + w3 * (500 / 1113) + w4 * (125 / 192) - w5 * (2187 / 6784) + w6 * (11 / 84))
    j = nearby(table, y1, j, first, last)
    k7 = table_acceleration(table, j, y1, v1, sa + slope * h)
    error_v = (
        k1 * (71 / 57600) - k3 * (71 / 16695) + k4 * (71 / 1920) - k5 * (17253 / 339200) + k6 * (22 / 525) - k7 / 40
    )
    error_y = (
        w1 * (71 / 57600) - w3 * (71 / 16695) + w4 * (71 / 1920) - w5 * (17253 / 339200) + w6 * (22 / 525) - v1 / 40
    )
    return y1, v1, k7, abs(h * error_y), abs(h * error_v), j


@compiled
def exact_acceleration(flow: Any, side: int, y: float, v: float, a: float) -> float:
    """y'' of a state on its branch."""
    table, _, span, hint, _, _ = flow
    j = segment(table, y, v, hint[side], span[side, 0], span[side, 1])
    hint[side] = j
    return table_acceleration(table, j, y, v, (1.0 - 2.0 * side) * a)


@compiled
def exact_glide(flow: Any, side: int, y: float, v: float, k: float, ground: FloatArray, scale: float, dt: float,
                i: int, until: int, top: float, limit: float) -> tuple[int, float, float, float]:  # fmt: skip
    """One step for an interval, while its error is small enough and it passes no jump of the table."""
    table, smooth, span, hint, tolerance, rate = flow
    bottom, end, tolerance_v = span[side, 0], span[side, 1], tolerance * rate[side]
    j = segment(table, y, v, hint[side], bottom, end)
    first, last = smooth[j, 0], smooth[j, 1]
    low = table[first, LEFT] if first > bottom else -math.inf
    high = table[last, RIGHT] if last < end else math.inf
    sign = (1.0 - 2.0 * side) * scale
    a = sign * ground[i]
    while i < until:
        a1 = sign * ground[i + 1]
        y1, v1, k1, error_y, error_v, j = dormand_prince(table, j, first, last, y, v, k, a, (a1 - a) / dt, dt)
        if error_y > tolerance or error_v > tolerance_v or not low <= y1 <= high:
            break
        if not calm((y, v, k), (y1, v1, k1), 1.5 * dt, top, limit):  # y'' may bow somewhat beyond its ends
            break
        i, y, v, k, a = i + 1, y1, v1, k1, a1
    hint[side] = j
    return i, y, v, k


@compiled
def exact_advance(flow: Any, side: int, start: State, ground: Ground, x: float) -> State:
    """Over any time x [s] in steps of controlled error, landing on jumps of the table and leaving them on the far side.

    From the end of the step that leaves the table, below rest or beyond its end, the velocity is kept: it tells which
    event there was, and leads Newton's method back to it, without asking cubics far from where they hold.
    """
    table, smooth, span, hint, tolerance, rate = flow
    s = 1.0 - 2.0 * side
    y, v, k = start
    slope, bottom, end = s * ground[1], span[side, 0], span[side, 1]
    time, h, smallest = 0.0, x, SMALLEST_STEP * x
    while time < x and 0.0 <= y <= table[end, RIGHT]:
        j = segment(table, y, v, hint[side], bottom, end)
        hint[side] = j
        first, last = smooth[j, 0], smooth[j, 1]
        low = table[first, LEFT] if first > bottom else -math.inf
        high = table[last, RIGHT] if last < end else math.inf
        h = min(h, x - time)
        y1, v1, k1, error_y, error_v, _ = dormand_prince(
            table, j, first, last, y, v, k, s * ground[0] + slope * time, slope, h
        )
        error = max(error_y, error_v / rate[side]) / tolerance
        beyond, speed = (y1 - high, v1) if y1 - high > low - y1 else (low - y1, -v1)
        if error > 1.0 and h > smallest:
            h = max(h * max(0.2, 0.9 * error**-0.2), smallest)
        elif beyond > ON_A_JUMP and h > smallest:  # back to the jump by Newton's method, or short of it and on again
            h = max(min(h - beyond / speed, 0.999999999 * h) if speed * h > beyond else 0.5 * h, smallest)
        else:
            time = x if h >= x - time else time + h
            y, v, k = y1, v1, k1
            if beyond >= -ON_A_JUMP:
                y = y1 if beyond > ON_A_JUMP else high if y1 - high > low - y1 else low
                k, h = exact_acceleration(flow, side, y, v, ground[0] + ground[1] * time), x
            else:
                h *= min(5.0, 0.9 * max(error, 1e-8) ** -0.2)
    return y + v * (x - time), v, k


march_exact = marching(exact_glide, exact_advance, exact_acceleration)


@entry
def rock_exact(branches: FloatArray, table: FloatArray, smooth: IntArray, spans: IntArray, tolerance: float,
               ground: FloatArray, offset: IntArray, dt: FloatArray, oscillator: IntArray, motion: IntArray,
               scale: FloatArray, release: float, found: FloatArray, path: FloatArray,
               events: FloatArray) -> int:  # fmt: skip
    """All jobs by the exact equation; fills found [jobs, 7], returns the samples passed by the last job.

    table [segments, 14]: the cubics of all branches; smooth [segments, 2]: first and last segment without a jump
    between; spans [oscillators, 2, 2]: first and last segment of each branch; tolerance: error allowed to a step, of
    y [-] and y' / rate. Other arguments as for `rock_linearised`. The end of the table is overturned.
    """
    samples = 0
    hint = np.empty(2, dtype=np.int64)
    rate = np.empty(2)
    for j in range(oscillator.shape[0]):
        m, o = motion[j], oscillator[j]
        branch, span = branches[o], spans[o]
        for side in range(2):
            hint[side], rate[side] = span[side, 0], branch[side, RATE]
        flow = (table, smooth, span, hint, tolerance, rate)
        samples = march_exact(
            flow, branch, ground[offset[m] : offset[m + 1]], dt[m], scale[j], release, found[j], path, events,
        )  # fmt: skip
    return samples
