"""The rocking equation marched through jobs (oscillator, motion, scale), compiled.

One branch at a time, in its own mirrored sign s = +1 or -1, with y = 0 at rest and 1 at overturning, and the ground
acceleration a(t) linear between samples:

    exact        y'' = -r(y) - b(y) s a(t)                r, b: the cubics of the branch (`canonical`)
    linearised   y'' = p^2 (y - 1 - s a(t) / threshold)   threshold = g lambda

Both equations share one march and one treatment of events, because a step of either is an `Arc`: y as a polynomial of
time. What differs is handed over as three functions:

    glide       over whole record intervals, fast, as far as `calm` and the error allow
    step        an arc from a state, over any part of an interval
    potential   what is stored in a rotation, whose sum with y'^2 / 2 stays in free motion

The linearised arcs are the Taylor series of the closed solution. The exact ones are the Taylor series to the fifth
power, which a cubic gives from one look at the table, and one power more by the acceleration found at the end: what
the series lacks there is the error as well (the predictor and corrector of Hermite's scheme). Whether something can
happen in an interval (impact, passage of 1, a new largest rotation) is decided by `calm`; only where it can,
`through` divides the interval into pieces over which the velocity, then the rotation, is monotone, so that no event
can hide between two samples, and locates each event on the arc.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from assess.kernel import compiled, entry, inlined, reachable
from spectra.arrays import BoolArray, FloatArray, IntArray

Arc = tuple[float, float, float, float, float, float, float, float, float]  # of y [-], lowest power of time first
State = tuple[float, float, float]  # y [-], y' [1/s], y'' [1/s2]
Ground = tuple[float, ...]  # acceleration as a polynomial of time, lowest power first: 2 of a record, 6 of a pulse
Force = tuple[float, float, float, float, float, float, float]
Glide = Callable[..., tuple[int, float, float]]
Step = Callable[..., tuple[Arc, float, State]]
Potential = Callable[..., float]
March = Callable[..., int]
Overturns = Callable[[Any, float], bool]
Seek = Callable[..., None]

REST = 1e-4
"""After an impact slower than REST times the velocity that reaches 1 (p, linearised) on the side that it comes to, with
the ground below uplift, the body is at rest. Without such a rule a bouncing body has infinitely many impacts in finite
time."""
NO_BOUNCE = 1e-12
"""Below this fraction of the same velocity there is no flight at all, whatever the ground does."""
TAIL_PIECE = 0.5
TAIL_PIECES = 120
"""Free motion after the record goes in at most TAIL_PIECES pieces of TAIL_PIECE / p, p of the quicker branch."""

SMALLEST_STEP = 1e-6
"""Of an interval: the least step of the exact equation, so that a body rattling about a jump of its table still moves
on, and the least distance of an inflection from where it is looked for. What is neglected goes with its square."""
SHORT = 0.02
"""Of 1 / p: the longest arc of the linearised equation; the next power of the series of its velocity is below 1e-18."""

# columns of `branch` [2, 6], one row for each side
THRESHOLD, BOUNCE, PARTNER, RATE, LIMIT, TAIL_LIMIT = range(6)
# columns of `found` [jobs, FOUND]; LARGEST (y) and WHEN have two, one for each side
LARGEST, WHEN, IMPACTS, OVERTURNED, PASSED, UPLIFTED, FOUND = 0, 2, 4, 5, 6, 7, 8
# columns of `events` [capacity + 1, 3], whose first entry counts: time [s], kind, y of a peak or y' before an impact,
# and the side in the last column
HAPPENED, KIND, VALUE, ON = range(4)
PEAK, IMPACT, UPLIFT = range(3)
# columns of `table` [segments, 11]: ends of the segment, the cubics of r and b, highest power first, and the potential
# at its beginning
LEFT, RIGHT, R3, R2, R1, R0, B3, B2, B1, B0, STORED = range(11)
# columns of what the linearised equation needs of each side [2, 8]
P2, INVERSE, Y_K, Y_V, Y_A, V_K, V_V, V_A = range(8)


# --------------------------------------------------------------------------------------------------------------- arcs


@compiled
def at(c: Arc, x: float) -> float:
    """The polynomial at time x, in pairs (Estrin 1960), which a processor works out side by side."""
    x2 = x * x
    low, high = (c[0] + c[1] * x) + (c[2] + c[3] * x) * x2, (c[4] + c[5] * x) + (c[6] + c[7] * x) * x2
    x4 = x2 * x2
    return low + (high + c[8] * x4) * x4


@compiled
def derivative(c: Arc) -> Arc:
    """Of the polynomial."""
    return c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4], 5.0 * c[5], 6.0 * c[6], 7.0 * c[7], 8.0 * c[8], 0.0


@compiled
def root(c: Arc, level: float, end: float) -> float:
    """Time in (0, end] at which the polynomial, monotone there, passes `level`.

    Newton's method within a bracket that only shrinks.
    """
    rate, low, high = derivative(c), 0.0, end
    start, stop = c[0] - level, at(c, end) - level
    x = end * (start / (start - stop)) if start != 0.0 else end
    for _ in range(60):
        f, slope = at(c, x) - level, at(rate, x)
        if f == 0.0:
            return x
        if (f > 0.0) == (stop > 0.0):
            high = x
        else:
            low = x
        new = x - f / slope if slope != 0.0 else -1.0
        if not low <= new <= high:
            new = 0.5 * (low + high)
        if abs(new - x) <= 1e-9 * end:  # the error of the next one is the square of this
            return new
        x = new
    return x


@compiled
def over_time(c: Arc) -> Arc:
    """The polynomial over x, for one that is zero at x = 0: its other root."""
    return c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], 0.0


@compiled
def turning(c: Arc, rate: Arc, end: float) -> float:
    """Time in (0, end] of the one peak of a polynomial that rises first and falls at the end."""
    return root(rate, 0.0, end) if rate[0] > 0.0 else root(over_time(rate), 0.0, end)


# ------------------------------------------------------------------------------------------------------------- ground


@compiled
def intervals(ground: FloatArray) -> int:
    """Of a record, given by its samples [n], or of a pulse, given by its polynomials [n, 6]."""
    return len(ground) - 1 if ground.ndim == 1 else len(ground)


@compiled
def interval(ground: FloatArray, scale: float, dt: float, i: int) -> Ground:
    """The ground acceleration over interval i."""
    if ground.ndim == 1:
        a = scale * ground[i]
        return a, (scale * ground[i + 1] - a) / dt
    c = scale * ground[i, 0], scale * ground[i, 1], scale * ground[i, 2]
    return c[0], c[1], c[2], scale * ground[i, 3], scale * ground[i, 4], scale * ground[i, 5]


@compiled
def still(ground: FloatArray) -> Ground:
    """No motion, of the same kind."""
    if ground.ndim == 1:
        return 0.0, 0.0
    return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


@compiled
def moved(a: Ground, x: float) -> Ground:
    """The same polynomial from time x on."""
    if len(a) == 2:
        return a[0] + a[1] * x, a[1]
    c4 = a[4] + 5.0 * a[5] * x
    c3 = a[3] + (4.0 * a[4] + 10.0 * a[5] * x) * x
    c2 = a[2] + (3.0 * a[3] + (6.0 * a[4] + 10.0 * a[5] * x) * x) * x
    c1 = a[1] + (2.0 * a[2] + (3.0 * a[3] + (4.0 * a[4] + 5.0 * a[5] * x) * x) * x) * x
    return after(a, x), c1, c2, c3, c4, a[5]


@compiled
def after(a: Ground, x: float) -> float:
    """The acceleration at time x."""
    if len(a) == 2:
        return a[0] + a[1] * x
    return a[0] + (a[1] + (a[2] + (a[3] + (a[4] + a[5] * x) * x) * x) * x) * x


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
def uplift(branch: FloatArray, a: Ground, h: float) -> tuple[int, float]:
    """Side that lifts within h under the ground acceleration a from now on, and when; side -1 where none does."""
    for side in range(2):  # before one that lifts later
        if -(1.0 - 2.0 * side) * a[0] > branch[side, THRESHOLD]:
            return side, 0.0
    for side in range(2):
        s = 1.0 - 2.0 * side
        if -s * after(a, h) > branch[side, THRESHOLD]:
            excess = -s * a[0] - branch[side, THRESHOLD]
            if len(a) == 2:
                return side, min(-excess / (-s * a[1]), h)
            over = (excess, -s * a[1], -s * a[2], -s * a[3], -s * a[4], -s * a[5], 0.0, 0.0, 0.0)
            return side, root(over, 0.0, h)
    return -1, h


@compiled
def lifted(branch: FloatArray, a: float) -> bool:
    """Whether a body at rest would start under ground acceleration a."""
    return bool(-a > branch[0, THRESHOLD] or a > branch[1, THRESHOLD])


@compiled
def idle(ground: FloatArray, scale: float, lowest: float, highest: float, i: int, until: int) -> int:
    """The first interval from i on, or `until`, in which the ground acceleration leaves [lowest, highest]."""
    if ground.ndim == 1:
        while i < until and lowest <= scale * ground[i] <= highest and lowest <= scale * ground[i + 1] <= highest:
            i += 1
    return i


@compiled
def note(events: FloatArray, time: float, kind: int, value: float, side: int) -> None:
    """Append an event where there is room for it."""
    n = int(events[0, 0]) + 1
    if n < events.shape[0]:
        events[n, HAPPENED], events[n, KIND], events[n, VALUE], events[n, ON] = time, kind, value, side
        events[0, 0] = n


@compiled
def largest(found: FloatArray, y: float, side: int, time: float) -> None:
    """Keep the largest y of a side."""
    if y > found[LARGEST + side]:
        found[LARGEST + side], found[WHEN + side] = y, time


def marching(glide: Glide, step: Step, potential: Potential) -> March:
    """The march of one job by the equation that the three functions stand for."""

    @inlined
    def through(flow: Any, branch: FloatArray, found: FloatArray, events: FloatArray, column: int, peaked: int,
                wanted: int, side: int, y: float, v: float, time: float, ground: Ground,
                h: float) -> tuple[int, float, float, int]:  # fmt: skip
        """Through h [s] from `time` with all events: side (-1 at rest), y, y' at the end, and the sides that peaked.

        ground: its acceleration from `time` on. column: of `branch`, the limit that means overturned.
        It ends early once all the `wanted` sides have peaked (bits; 0: goes on).

        Each turn of the loop moves on in time, or stops the velocity, or puts the body to rest.
        """
        x, every_peak = 0.0, wanted > 0 or events.shape[0] > 1
        while x < h:
            a, left = moved(ground, x), h - x
            if side < 0:
                side, wait = uplift(branch, a, left)
                if side < 0:
                    break
                x, y, v = x + wait, 0.0, 0.0
                found[UPLIFTED] = 1.0
                note(events, time + x, UPLIFT, 0.0, side)
                continue
            top = -1.0 if every_peak else found[LARGEST + side]
            arc, piece, (y1, v1, k1) = step(flow, side, y, v, a, left)
            k = 2.0 * arc[2]
            if calm((y, v, k), (y1, v1, k1), 1.5 * piece, top, branch[side, column]):
                x, y, v = (h if piece == left else x + piece), y1, v1
                continue
            rate, peak = derivative(arc), False
            if v * v1 > 0.0 and k * k1 < 0.0:  # the velocity has an extreme: does it change sign before and after?
                bent = root(derivative(rate), 0.0, piece)
                if v * at(rate, bent) < 0.0 and bent > SMALLEST_STEP * h:
                    piece, y1, v1 = bent, at(arc, bent), at(rate, bent)
            if v1 < 0.0 and (v > 0.0 or (v == 0.0 and k > 0.0)):
                if y + (v + max(k, 0.0) * piece) * piece >= min(top, 1.0):
                    piece, peak = turning(arc, rate, piece), True
                    y1, v1 = max(at(arc, piece), y), 0.0
            elif v < 0.0 < v1 and y + v * piece <= 0.0:
                lowest = root(rate, 0.0, piece)
                if at(arc, lowest) < 0.0:
                    piece, y1, v1 = lowest, at(arc, lowest), 0.0
            if y1 < 0.0:
                if y > 0.0 or v > 0.0 or k > 0.0:
                    piece = root(arc, 0.0, piece) if y > 0.0 else root(over_time(arc), 0.0, piece)
                    x, v = x + piece, min(at(rate, piece), 0.0)
                elif v == 0.0:
                    return -1, 0.0, 0.0, peaked  # neither flight nor speed: rest, for what is left of the interval
                found[IMPACTS] += 1.0
                note(events, time + x, IMPACT, v, side)
                v, y, side = -v * branch[side, BOUNCE], 0.0, int(branch[side, PARTNER])
                slow = REST * branch[side, RATE]
                if v < slow and (v < slow * (NO_BOUNCE / REST) or not lifted(branch, after(ground, x))):
                    side, v = -1, 0.0
                continue
            if y < 1.0 <= y1:
                found[PASSED] = time + x + root(arc, 1.0, piece)
            x, y, v = (h if piece == left else x + piece), y1, v1
            if peak:
                peaked |= 1 << side
                largest(found, y, side, time + x)
                note(events, time + x, PEAK, y, side)
            if y >= branch[side, column] and v >= 0.0:
                found[OVERTURNED] = 1.0
                largest(found, y, side, time + x)
                break
            if wanted > 0 and peaked == wanted:
                break
        return side, y, v, peaked

    @compiled
    def settled(flow: Any, branch: FloatArray, found: FloatArray, both: int, side: int, y: float, v: float) -> int:
        """Impacts until a body in free motion has peaked on each side or rests; -1 where a peak may be the largest yet.

        From its energy, and what each impact leaves of it.
        """
        if y >= 1.0:
            return -1
        E, peaked, impacts = 0.5 * v * v + potential(flow, side, y), 0, 0
        if v > 0.0:
            peaked = 1 << side
        while True:
            if potential(flow, side, min(found[LARGEST + side], 1.0)) < E:
                return -1
            if peaked == both:
                return impacts
            v, impacts = math.sqrt(2.0 * E) * branch[side, BOUNCE], impacts + 1
            side = int(branch[side, PARTNER])
            if v < REST * branch[side, RATE]:
                return impacts
            E, peaked = 0.5 * v * v, peaked | (1 << side)

    @compiled
    def falls(flow: Any, branch: FloatArray, side: int, y: float, v: float) -> bool:
        """Whether a body in free motion overturns: now, by its energy, or by what the impacts to come leave of that."""
        E, top = 0.5 * v * v + potential(flow, side, y), potential(flow, side, 1.0)
        if (v > 0.0 and top < E) or (y >= 1.0 and (v >= 0.0 or top > E)):
            return True
        for _ in range(4):  # after both sides have had their turn an impact leaves no more than the last one there
            E *= branch[side, BOUNCE] ** 2
            side = int(branch[side, PARTNER])
            if potential(flow, side, 1.0) < E:
                return True
        return False

    @reachable
    def march(flow: Any, branch: FloatArray, ground: FloatArray, dt: float, scale: float, release: float,
              found: FloatArray, path: FloatArray, events: FloatArray, ends: bool) -> int:  # fmt: skip
        """One job: the motion `ground` [n], or [n, 6] of a pulse, at step dt, times `scale`. Returns the number of
        samples passed.

        release: initial y of the positive branch, 0 for rest. found [8]: filled. path [n or 0, 3]: y, y' and the side
        (-1 at rest) at samples, where wanted; events [capacity + 1, 4]: likewise.

        After the record the motion is free, and is followed until no later peak can be larger: until its energy shows
        that, or each side has peaked, or rest, or overturning. Who still balances after the last piece, which takes a
        distance from the threshold below the rounding error, has overturned if beyond 1.
        """
        for c in range(found.shape[0]):
            found[c] = math.nan if c == PASSED else 0.0
        side, y, v = -1, 0.0, 0.0
        if release > 0.0:
            side, y = 0, release
            largest(found, y, side, 0.0)
        traced, every_peak = path.shape[0] > 0, events.shape[0] > 1
        if traced:
            path[0, 0], path[0, 1], path[0, 2] = y, v, side
        lowest, highest = -branch[0, THRESHOLD], branch[1, THRESHOLD]
        last, tail = intervals(ground), TAIL_PIECE / max(branch[0, RATE], branch[1, RATE])
        both = 1 | (1 << int(branch[0, PARTNER]))
        samples, peaked, wanted, column, h, time, i = last + 1, 0, 0, LIMIT, dt, 0.0, 0
        while i < last + TAIL_PIECES:
            a, begun, until = still(ground), i, i + 1 if traced else last
            if i < last:
                if side < 0:
                    i = idle(ground, scale, lowest, highest, i, until)
                else:
                    top = -1.0 if every_peak else found[LARGEST + side]
                    i, y, v = glide(flow, side, y, v, ground, scale, dt, i, until, top, branch[side, LIMIT])
                if i < until:
                    a, time = interval(ground, scale, dt, i), i * dt
            elif side < 0 or (wanted > 0 and peaked == wanted):
                break
            else:
                if ends:
                    found[OVERTURNED] = 1.0 if falls(flow, branch, side, y, v) else 0.0
                    return last + 1
                if wanted == 0:
                    impacts = -1 if every_peak else settled(flow, branch, found, both, side, y, v)
                    if impacts >= 0:
                        found[IMPACTS] += impacts
                        break
                    peaked, wanted, column, h = 0, both, TAIL_LIMIT, tail
                time = last * dt + (i - last) * tail
            if begun >= last or i < until:
                side, y, v, peaked = through(
                    flow, branch, found, events, column, peaked, wanted, side, y, v, time, a, h
                )  # fmt: skip
                i += 1
            if traced and begun < last:
                path[i, 0], path[i, 1], path[i, 2] = y, v, side
            if found[OVERTURNED] > 0.0:
                samples = min(samples, i + 1)
                break
        if side >= 0 and y >= 1.0 and peaked != wanted:
            found[OVERTURNED] = 1.0  # or balances beyond 1 for ever
        if found[OVERTURNED] > 0.0:
            largest(found, y, side, time + h)
            if math.isnan(found[PASSED]):
                found[PASSED] = time + h  # never below 1, or a table that ends before it
        return int(samples)

    return march


# ------------------------------------------------------------------------------------ pulses of one frequency, shared


def seeking(overturns: Overturns) -> Seek:
    """What maps the pulses of one frequency and seeks the least that overturns, by the equation of `overturns`."""

    @compiled
    def between(job: Any, low: float, high: float, factor: float, bisections: int) -> float:
        """By bisection, from an amplitude of the ground that the body stands to one that overturns it.

        factor: of it at the base, with the sign of the polarity.
        """
        for _ in range(bisections):
            middle = 0.5 * (low + high)
            if overturns(job, middle * factor):
                high = middle
            else:
                low = middle
        return high

    @compiled
    def seek(job: Any, factor: float, safe: float, scan: FloatArray, signs: FloatArray, amplitude: FloatArray,
             bisections: int, overturned: BoolArray, least: FloatArray) -> None:  # fmt: skip
        """Fills overturned [polarities, m]; least: the least amplitude that overturns, inf where none, and its sign.

        factor: of the ground's amplitude at the base; safe: at the base, what overturns nothing [m/s2]; scan [k],
        amplitude [m]: of the ground, rising [m/s2]; signs [polarities].

        The scan ends at the first step that overturns in any polarity, for the others need more.
        """
        bound, sign = math.inf, 0.0
        for q in range(len(signs)):
            for m in range(len(amplitude)):
                base = amplitude[m] * factor
                overturned[q, m] = base > safe and overturns(job, signs[q] * base)
        for k in range(len(scan)):
            if scan[k] * factor > safe:
                for q in range(len(signs)):
                    if overturns(job, signs[q] * (scan[k] * factor)):
                        edge = between(job, scan[k - 1] if k > 0 else 0.0, scan[k], signs[q] * factor, bisections)
                        if edge < bound:
                            bound, sign = edge, signs[q]
            if sign != 0.0 or scan[k] == scan[-1]:
                break
        for q in range(len(signs)):  # the map may meet a band that the scan has stepped over
            for m in range(len(amplitude)):
                if overturned[q, m]:
                    if amplitude[m] < bound:
                        low = amplitude[m - 1] if m > 0 else 0.0
                        bound, sign = between(job, low, amplitude[m], signs[q] * factor, bisections), signs[q]
                    break
        least[0], least[1] = bound, sign

    return seek


# --------------------------------------------------------------------------------------------------- the linearised


@compiled
def rest_of_series(n: int, x: float) -> float:
    """x^n / n! + x^(n + 2) / (n + 2)! + ...: sinh or cosh without their first powers, and so without cancellation."""
    term = 1.0
    for m in range(1, n + 1):
        term *= x / m
    total, m = term, n
    while term > 1e-17 * total:
        m += 2
        term *= x * x / (m * (m - 1))
        total += term
    return total


@reachable
def linearised_sides(sides: FloatArray, branch: FloatArray, dt: float) -> None:
    """Fills what the closed solution over one interval is made of, for each side [2, 8]; zeros for one not there."""
    for side in range(2):
        for c in range(8):
            sides[side, c] = 0.0
        p = branch[side, RATE]
        if p > 0.0:
            sinh, cosh_1 = rest_of_series(1, p * dt), rest_of_series(2, p * dt)
            sinh_x = rest_of_series(3, p * dt)
            inverse = (1.0 - 2.0 * side) / branch[side, THRESHOLD]
            sides[side, P2], sides[side, INVERSE] = p * p, inverse
            sides[side, Y_K], sides[side, Y_V], sides[side, Y_A] = cosh_1 / p**2, sinh / p, -inverse * sinh_x / (p * dt)
            sides[side, V_K], sides[side, V_V], sides[side, V_A] = sinh / p, cosh_1, -inverse * cosh_1 / dt


@reachable
def linearised_pushes(pushes: FloatArray, sides: FloatArray, ground: FloatArray, dt: float) -> None:
    """Fills what each interval of a unit pulse `ground` [n, 6] adds to y and y' on each side [2, n, 2].

    Its m-th power a_m gives -a_m m! / threshold times rest_of_series(m + 2, p dt) / p^m, and one less for y'.
    """
    for side in range(2):
        p, factor = math.sqrt(sides[side, P2]), -sides[side, INVERSE]
        for i in range(len(ground)):
            pushes[side, i, 0], pushes[side, i, 1] = 0.0, 0.0
        for m in range(1, 6 if p > 0.0 else 0):
            factor *= m / p
            of_y, of_v = factor * rest_of_series(m + 2, p * dt), factor * p * rest_of_series(m + 1, p * dt)
            for i in range(len(ground)):
                pushes[side, i, 0] += of_y * ground[i, m]
                pushes[side, i, 1] += of_v * ground[i, m]


@compiled
def linearised_glide(flow: Any, side: int, y: float, v: float, ground: FloatArray, scale: float, dt: float,
                     i: int, until: int, top: float, limit: float) -> tuple[int, float, float]:  # fmt: skip
    """y1 = y + y'' (cosh - 1) / p^2 + y' sinh / p - s (a1 - a0) / threshold (sinh - p dt) / (p dt), in increments."""
    sides, pushes = flow
    p2, inverse = sides[side, P2], sides[side, INVERSE]
    y_k, y_v, y_a = sides[side, Y_K], sides[side, Y_V], sides[side, Y_A]
    v_k, v_v, v_a = sides[side, V_K], sides[side, V_V], sides[side, V_A]
    if ground.ndim == 1:
        a = scale * ground[i]
        k = p2 * (y - 1.0 - inverse * a)
        while i < until:
            a1 = scale * ground[i + 1]
            y1 = y + (k * y_k + v * y_v + (a1 - a) * y_a)
            v1 = v + (k * v_k + v * v_v + (a1 - a) * v_a)
            k1 = p2 * (y1 - 1.0 - inverse * a1)
            if not calm((y, v, k), (y1, v1, k1), dt, top, limit):
                break
            i, y, v, k, a = i + 1, y1, v1, k1, a1
        return i, y, v
    k = p2 * (y - 1.0 - inverse * scale * ground[i, 0])
    while i + 1 < until:  # the last interval has no next one to tell its end
        y1 = y + (k * y_k + v * y_v + scale * pushes[side, i, 0])
        v1 = v + (k * v_k + v * v_v + scale * pushes[side, i, 1])
        k1 = p2 * (y1 - 1.0 - inverse * scale * ground[i + 1, 0])
        if not calm((y, v, k), (y1, v1, k1), 1.5 * dt, top, limit):
            break
        i, y, v, k = i + 1, y1, v1, k1
    return i, y, v


@compiled
def linearised_step(flow: Any, side: int, y: float, v: float, a: Ground,
                    h: float) -> tuple[Arc, float, State]:  # fmt: skip
    """An arc over h, or SHORT / p, and its end: y'''' = p^2 y'', y''''' = p^2 y''' and so on.

    a: ground acceleration from the start on.
    """
    sides, _ = flow
    p2, inverse = sides[side, P2], sides[side, INVERSE]
    k, jerk = p2 * (y - 1.0 - inverse * a[0]), p2 * (v - inverse * a[1])
    if y == 0.0 and v == 0.0:
        k = max(k, 0.0)  # just lifted: not falling by a rounding error
    fourth, fifth, sixth, seventh = p2 * k, p2 * jerk, p2 * p2 * k, p2 * p2 * jerk
    if len(a) > 2:
        fourth, fifth = p2 * (k - inverse * 2.0 * a[2]), p2 * (jerk - inverse * 6.0 * a[3])
        sixth, seventh = p2 * (fourth - inverse * 24.0 * a[4]), p2 * (fifth - inverse * 120.0 * a[5])
    arc = (y, v, k * (1 / 2), jerk * (1 / 6), fourth * (1 / 24), fifth * (1 / 120), sixth * (1 / 720),
           seventh * (1 / 5040), p2 * sixth * (1 / 40320))  # fmt: skip
    h = h if p2 * h * h <= SHORT * SHORT else SHORT / math.sqrt(p2)
    y1 = at(arc, h)
    return arc, h, (y1, at(derivative(arc), h), p2 * (y1 - 1.0 - inverse * after(a, h)))


@compiled
def linearised_potential(flow: Any, side: int, y: float) -> float:
    """Of y'' = p^2 (y - 1)."""
    sides, _ = flow
    return float(sides[side, P2] * y * (1.0 - 0.5 * y))


march_linearised = marching(linearised_glide, linearised_step, linearised_potential)


@entry
def rock_linearised(branches: FloatArray, ground: FloatArray, offset: IntArray, dt: FloatArray, peak: FloatArray,
                    oscillator: IntArray, motion: IntArray, scale: FloatArray, release: float, found: FloatArray,
                    path: FloatArray, events: FloatArray) -> int:  # fmt: skip
    """All jobs by the linearised equation; fills found [jobs, 8], returns the samples passed by the last job.

    branches [oscillators, 2, 6]; ground: all motions end to end, motion m from offset[m] to offset[m + 1]; dt, peak
    (largest |a|) of each motion; oscillator, motion, scale of each job. Beyond y = 1 + peak / threshold with y' >= 0
    the acceleration stays positive while the motion lasts, beyond 1 in free motion: overturned.
    """
    samples = 0
    branch, sides, pushes = np.empty((2, 6)), np.empty((2, 8)), np.empty((2, 0, 2))
    for j in range(oscillator.shape[0]):
        m = motion[j]
        for side in range(2):
            for c in range(6):
                branch[side, c] = branches[oscillator[j], side, c]
            branch[side, LIMIT] = 1.0 + abs(scale[j]) * peak[m] / branch[side, THRESHOLD]
        linearised_sides(sides, branch, dt[m])
        samples = march_linearised(
            (sides, pushes), branch, ground[offset[m] : offset[m + 1]], dt[m], scale[j], release, found[j], path,
            events, False,
        )  # fmt: skip
    return samples


@compiled
def of_frequency(ground: FloatArray, pulse: FloatArray, frequency: float) -> None:
    """Fills the polynomials of time [n, 6] of a pulse given over its phase [n, 6]."""
    for i in range(len(pulse)):
        factor = 1.0
        for m in range(6):
            ground[i, m] = factor * pulse[i, m]
            factor *= 2.0 * math.pi * frequency


@reachable
def overturns_linearised(job: Any, scale: float) -> bool:
    """Whether a pulse of peak acceleration `scale`, with its sign, overturns."""
    flow, branch, ground, dt, found, path, events = job
    for side in range(2):
        branch[side, LIMIT] = 1.0 + abs(scale) / branch[side, THRESHOLD]
    march_linearised(flow, branch, ground, dt, scale, 0.0, found, path, events, True)
    return bool(found[OVERTURNED] > 0.0)


@entry
def pulse_linearised(branches: FloatArray, pulse: FloatArray, phase: float, frequency: FloatArray,
                     oscillator: IntArray, motion: IntArray, scale: FloatArray, found: FloatArray) -> None:  # fmt: skip
    """All jobs under a pulse by the linearised equation; fills found [jobs, 8].

    pulse [n, 6]: unit acceleration as polynomials of phase, each over `phase` [rad]; frequency [Hz] of each motion;
    scale: acceleration [m/s2] of each job. Jobs of one oscillator and one motion are cheapest together.
    """
    branch, sides, pushes = np.empty((2, 6)), np.empty((2, 8)), np.empty((2, len(pulse), 2))
    ground, path, events = np.empty((len(pulse), 6)), np.empty((0, 3)), np.zeros((1, 4))
    for j in range(oscillator.shape[0]):
        m = motion[j]
        dt = phase / (2.0 * math.pi * frequency[m])
        if j == 0 or motion[j - 1] != m or oscillator[j - 1] != oscillator[j]:
            branch[:] = branches[oscillator[j]]
            of_frequency(ground, pulse, frequency[m])
            linearised_sides(sides, branch, dt)
            linearised_pushes(pushes, sides, ground, dt)
        overturns_linearised(((sides, pushes), branch, ground, dt, found[j], path, events), scale[j])


seek_linearised = seeking(overturns_linearised)


@entry
def envelope_linearised(branch: FloatArray, pulse: FloatArray, phase: float, frequency: FloatArray, factor: FloatArray,
                        safe: FloatArray, scan: FloatArray, signs: FloatArray, amplitude: FloatArray, bisections: int,
                        overturned: BoolArray, least: FloatArray) -> None:  # fmt: skip
    """Map and lower bound of one oscillator by the linearised equation at n frequencies.

    branch [2, 6]; pulse, phase: as of `pulse_linearised`; frequency [n] [Hz]; factor, safe [n], scan [n, k], signs,
    amplitude [m], bisections: as of `seek`, which fills overturned [n, polarities, m] and least [n, 2].
    """
    sides, pushes = np.empty((2, 8)), np.empty((2, len(pulse), 2))
    own, ground, found = branch.copy(), np.empty((len(pulse), 6)), np.empty(FOUND)
    path, events = np.empty((0, 3)), np.zeros((1, 4))
    for i in range(len(frequency)):
        dt = phase / (2.0 * math.pi * frequency[i])
        of_frequency(ground, pulse, frequency[i])
        linearised_sides(sides, own, dt)
        linearised_pushes(pushes, sides, ground, dt)
        job = ((sides, pushes), own, ground, dt, found, path, events)
        seek_linearised(job, factor[i], safe[i], scan[i], signs, amplitude, bisections, overturned[i], least[i])


# --------------------------------------------------------------------------------------------------------- the exact


@inlined
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
def force(table: FloatArray, j: int, y: float, sa: float) -> Force:
    """y'' by segment j and its three derivatives over y, then what goes with the ground, -b, and two derivatives.

    sa: ground acceleration in the branch's sign.
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
def pushed(of: Force, by: float) -> Force:
    """The same with another y''."""
    return of[0] + by, of[1], of[2], of[3], of[4], of[5], of[6]


@compiled
def series(of: Force, v: float, s: float, a: Ground) -> tuple[float, float, float, float]:
    """Second to fifth derivative of y over time; s: sign of the branch, a: ground acceleration from now on."""
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
def quick(of: Force, s: float, a: Ground) -> tuple[float, float]:
    """What the fourth and fifth power of the ground add to y'', which `series` leaves out; none of a record."""
    if len(a) == 2:
        return 0.0, 0.0
    return of[4] * (s * a[4]), of[4] * (s * a[5])


@inlined
def exact_glide(flow: Any, side: int, y: float, v: float, ground: FloatArray, scale: float, dt: float, i: int,
                until: int, top: float, limit: float) -> tuple[int, float, float]:  # fmt: skip
    """One step for an interval, while its error is small enough and it passes no jump of the table."""
    table, smooth, span, hint, accuracy, slow, pace = flow
    if pace[0] < dt:
        return i, y, v
    bottom, end = span[side, 0], span[side, 1]
    j = segment(table, y, v, hint[side], bottom, end)
    first, last = smooth[j, 0], smooth[j, 1]
    low = table[first, LEFT] if first > bottom else -math.inf
    high = table[last, RIGHT] if last < end else math.inf
    s = 1.0 - 2.0 * side
    allowed = 1.0 / (accuracy * dt * max(dt * (1 / 30), slow[side]))
    correct_y, correct_v = dt * dt * (1 / 30), dt * (1 / 5)
    a = interval(ground, scale, dt, i)
    here = force(table, j, y, s * a[0])
    while i < until:
        k, jerk, fourth, fifth = series(here, v, s, a)
        y1 = y + dt * (
            v + dt * (k * (1 / 2) + dt * (jerk * (1 / 6) + dt * (fourth * (1 / 24) + dt * fifth * (1 / 120))))
        )
        v1 = v + dt * (k + dt * (jerk * (1 / 2) + dt * (fourth * (1 / 6) + dt * fifth * (1 / 24))))
        known = 0.0
        if len(a) > 2:
            q4, q5 = quick(here, s, a)
            known = dt**4 * (q4 + dt * q5)
            y1, v1 = y1 + dt**6 * (q4 * (1 / 30) + dt * q5 * (1 / 42)), v1 + dt**5 * (q4 * (1 / 5) + dt * q5 * (1 / 6))
        if not low <= y1 <= high:
            break
        j = nearby(table, y1, j, first, last)
        there = force(table, j, y1, s * after(a, dt))
        lack = there[0] - (k + dt * (jerk + dt * (fourth * (1 / 2) + dt * fifth * (1 / 6)))) - known
        if not abs(lack) <= allowed:
            break
        y1, v1 = y1 + correct_y * lack, v1 + correct_v * lack
        if not calm((y, v, k), (y1, v1, there[0]), 1.5 * dt, top, limit):  # y'' may bow somewhat beyond its ends
            break
        here = pushed(there, there[1] * (correct_y * lack))
        i, y, v = i + 1, y1, v1
        if i < until:
            a = interval(ground, scale, dt, i)
    hint[side] = j
    return i, y, v


@inlined
def exact_step(flow: Any, side: int, y: float, v: float, a: Ground, h: float) -> tuple[Arc, float, State]:
    """An arc over h, or less, and its end: as far as the error allows, and up to rest, a jump of the table, or its end.

    a: ground acceleration from the start on.
    """
    table, smooth, span, hint, accuracy, slow, pace = flow
    s, smallest, left = 1.0 - 2.0 * side, SMALLEST_STEP * h, h
    h = min(h, max(pace[0], smallest))
    j = segment(table, y, v, hint[side], span[side, 0], span[side, 1])
    hint[side] = j
    first, last = smooth[j, 0], smooth[j, 1]
    low, high = table[first, LEFT], table[last, RIGHT]
    here = force(table, j, y, s * a[0])
    if y == 0.0 and v == 0.0 and here[0] < 0.0:
        here = pushed(here, -here[0])  # just lifted: not falling by a rounding error
    k, jerk, fourth, fifth = series(here, v, s, a)
    q4, q5 = quick(here, s, a)
    arc = (y, v, k * (1 / 2), jerk * (1 / 6), fourth * (1 / 24), fifth * (1 / 120), q4 * (1 / 30), q5 * (1 / 42), 0.0)
    while True:
        y1, cut = at(arc, h), False
        while not low <= y1 <= high and h > smallest:
            edge, cut = low if y1 < low else high, True
            if y != edge:
                h = max(root(arc, edge, h), smallest)
                break
            h *= 0.5  # out and back again
            y1 = at(arc, h)
        y1 = at(arc, h)
        j = nearby(table, y1, j, first, last)
        there = force(table, j, y1, s * after(a, h))
        lack = there[0] - (k + h * (jerk + h * (fourth * (1 / 2) + h * fifth * (1 / 6)))) - h**4 * (q4 + h * q5)
        error = abs(lack) * h * max(h * (1 / 30), slow[side]) * accuracy
        if error <= 1.0 or h <= smallest:
            break
        h = max(h * max(0.2, 0.9 / math.sqrt(math.sqrt(error))), smallest)
    if not cut and (h < left or error > 0.5):
        pace[0] = h * min(2.0, 0.9 / math.sqrt(math.sqrt(max(error, 0.01))))
    v1 = v + h * (k + h * (jerk * (1 / 2) + h * (fourth * (1 / 6) + h * fifth * (1 / 24)))) + lack * h * (1 / 5)
    v1, more = v1 + h**5 * (q4 * (1 / 5) + h * q5 * (1 / 6)), lack * h * h * (1 / 30)
    arc = (y, v, arc[2], arc[3], arc[4], arc[5], arc[6] + more / h**6, arc[7], 0.0)
    return arc, h, (y1 + more, v1, there[0] + there[1] * more)


@compiled
def exact_potential(flow: Any, side: int, y: float) -> float:
    """The integral of r from rest to y."""
    table, _, span, _, _, _, _ = flow
    j = nearby(table, y, span[side, 0], span[side, 0], span[side, 1])
    d = y - table[j, LEFT]
    return float(
        table[j, STORED]
        + d * (table[j, R0] + d * (table[j, R1] * (1 / 2) + d * (table[j, R2] * (1 / 3) + d * table[j, R3] * (1 / 4))))
    )


march_exact = marching(exact_glide, exact_step, exact_potential)


@entry
def rock_exact(branches: FloatArray, table: FloatArray, smooth: IntArray, spans: IntArray, tolerance: float,
               ground: FloatArray, offset: IntArray, dt: FloatArray, oscillator: IntArray, motion: IntArray,
               scale: FloatArray, release: float, found: FloatArray, path: FloatArray,
               events: FloatArray) -> int:  # fmt: skip
    """All jobs by the exact equation; fills found [jobs, 8], returns the samples passed by the last job.

    table [segments, 11]: the cubics of all branches; smooth [segments, 2]: first and last segment without a jump
    between; spans [oscillators, 2, 2]: first and last segment of each branch; tolerance: error allowed to a step, of
    y [-] and y' / rate. Other arguments as for `rock_linearised`. The end of the table is overturned.
    """
    samples = 0
    hint = np.empty(2, dtype=np.int64)
    slow, pace = np.empty(2), np.empty(1)
    for j in range(oscillator.shape[0]):
        m, o = motion[j], oscillator[j]
        branch, span = branches[o], spans[o]
        for side in range(2):
            hint[side], slow[side] = span[side, 0], 0.2 / branch[side, RATE]
        flow = (table, smooth, span, hint, 1.0 / tolerance, slow, pace)
        pace[0] = math.inf
        samples = march_exact(
            flow, branch, ground[offset[m] : offset[m + 1]], dt[m], scale[j], release, found[j], path, events,
            False,
        )  # fmt: skip
    return samples


@reachable
def overturns_exact(job: Any, scale: float) -> bool:
    """Whether a pulse of peak acceleration `scale`, with its sign, overturns."""
    flow, branch, ground, dt, found, path, events = job
    _, _, span, hint, _, _, pace = flow
    hint[0], hint[1], pace[0] = span[0, 0], span[1, 0], math.inf
    march_exact(flow, branch, ground, dt, scale, 0.0, found, path, events, True)
    return bool(found[OVERTURNED] > 0.0)


@entry
def pulse_exact(branches: FloatArray, table: FloatArray, smooth: IntArray, spans: IntArray, tolerance: float,
                pulse: FloatArray, phase: float, frequency: FloatArray, oscillator: IntArray, motion: IntArray,
                scale: FloatArray, found: FloatArray) -> None:  # fmt: skip
    """All jobs under a pulse by the exact equation; fills found [jobs, 8]. Arguments as of the other entry points."""
    hint = np.empty(2, dtype=np.int64)
    slow, pace = np.empty(2), np.empty(1)
    ground, path, events = np.empty((len(pulse), 6)), np.empty((0, 3)), np.zeros((1, 4))
    for j in range(oscillator.shape[0]):
        m, o = motion[j], oscillator[j]
        if j == 0 or motion[j - 1] != m:
            of_frequency(ground, pulse, frequency[m])
        slow[0], slow[1] = 0.2 / branches[o, 0, RATE], 0.2 / branches[o, 1, RATE]
        flow, dt = (table, smooth, spans[o], hint, 1.0 / tolerance, slow, pace), phase / (2.0 * math.pi * frequency[m])
        overturns_exact((flow, branches[o], ground, dt, found[j], path, events), scale[j])


seek_exact = seeking(overturns_exact)


@entry
def envelope_exact(branch: FloatArray, table: FloatArray, smooth: IntArray, span: IntArray, tolerance: float,
                   pulse: FloatArray, phase: float, frequency: FloatArray, factor: FloatArray, safe: FloatArray,
                   scan: FloatArray, signs: FloatArray, amplitude: FloatArray, bisections: int, overturned: BoolArray,
                   least: FloatArray) -> None:  # fmt: skip
    """Map and lower bound of one oscillator by the exact equation at each frequency, as `envelope_linearised`."""
    hint = np.empty(2, dtype=np.int64)
    slow, pace = 0.2 / branch[:, RATE], np.empty(1)
    flow = (table, smooth, span, hint, 1.0 / tolerance, slow, pace)
    ground, found = np.empty((len(pulse), 6)), np.empty(FOUND)
    path, events = np.empty((0, 3)), np.zeros((1, 4))
    for i in range(len(frequency)):
        of_frequency(ground, pulse, frequency[i])
        job = (flow, branch, ground, phase / (2.0 * math.pi * frequency[i]), found, path, events)
        seek_exact(job, factor[i], safe[i], scan[i], signs, amplitude, bisections, overturned[i], least[i])
