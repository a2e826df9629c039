"""Overturning under one cycle, or half a cycle, of a sine by the linearised equation, in closed form between events.

With s = +1 or -1 the sign of the side, w the circular frequency of the pulse a(t) = A sin(w t), and y = 1 at
overturning, the motion between two events is

    y = 1 + C1 e^(p x) + C2 e^(-p x) + Q sin(w t),     Q = s A / threshold p^2 / (p^2 + w^2),     x = t - t_0

so that a pulse costs a few dozen points of a recurrence, which search for the landing, and no steps of integration.
"""

from __future__ import annotations

import math

from assess.dynamics.kernel.columns import BOUNCE, IMPACTS, OVERTURNED, PARTNER, RATE, THRESHOLD, UPLIFTED
from assess.dynamics.kernel.events import NO_BOUNCE, REST
from assess.dynamics.kernel.search import make_search
from assess.kernel import compiled, entry, reachable
from spectra.arrays import BoolArray, FloatArray, IntArray

POINTS = 32
"""Points from uplift to the end of the pulse. After landing the closed form keeps falling, so that no landing can hide
between two points."""
MOST_IMPACTS = 10_000


@compiled
def find_lift(branch: FloatArray, A: float, phase: float, end: float) -> tuple[int, float]:
    """Return the side that lifts next after `phase`, and at which phase; side -1 if none does before `end`."""
    side = 1 if A > 0.0 else 0  # in the first half of the pulse; the other in the second
    for half in range(2):
        if abs(A) > branch[side, THRESHOLD]:
            start = math.asin(branch[side, THRESHOLD] / abs(A))
            begin, over = math.pi * half + start, math.pi * (half + 1) - start
            if phase < over and begin < end:
                return side, max(phase, begin)
        side = 1 - side
    return -1, end


@compiled
def follow_leg(branch: FloatArray, side: int, A: float, w: float, phase: float, v: float,
        end: float) -> tuple[bool, float, float, float]:  # fmt: skip
    """Follow the motion from y = 0 with y' = v at `phase` to its landing, at most to `end`.

    Return whether it lands, and phase, y, y' where the leg ends. It also ends where the body can no longer return
    while the pulse lasts, beyond y = 1 + |A| / threshold.
    """
    p, threshold = branch[side, RATE], branch[side, THRESHOLD]
    Q = (1.0 - 2.0 * side) * A / threshold * p * p / (p * p + w * w)
    sine, cosine = math.sin(phase), math.cos(phase)
    first, second = -1.0 - Q * sine, (v - Q * w * cosine) / p
    C1, C2 = 0.5 * (first + second), 0.5 * (first - second)
    step, limit = (end - phase) / POINTS, 1.0 + abs(A) / threshold
    grow = math.exp(p * step / w)
    shrink, turn_c, turn_s = 1.0 / grow, math.cos(step), math.sin(step)
    at, before = phase, phase
    for k in range(1, POINTS + 1):
        C1, C2 = C1 * grow, C2 * shrink
        sine, cosine = sine * turn_c + cosine * turn_s, cosine * turn_c - sine * turn_s
        before, at = at, (end if k == POINTS else phase + k * step)
        y = 1.0 + C1 + C2 + Q * sine
        if y < 0.0:
            return find_landing(p, w, Q, C1, C2, before, at)
        if y >= limit and p * (C1 - C2) + Q * w * cosine >= 0.0:
            break
    return False, at, 1.0 + C1 + C2 + Q * sine, p * (C1 - C2) + Q * w * cosine


@compiled
def find_landing(p: float, w: float, Q: float, C1: float, C2: float, low: float,
            high: float) -> tuple[bool, float, float, float]:  # fmt: skip
    """Return what `follow_leg` does for a landing between the phases low and high; C1, C2 at high."""
    end, at, v = high, high, 0.0
    for _ in range(60):
        grown = math.exp(p * (at - end) / w)
        one, two = C1 * grown, C2 / grown
        y, v = 1.0 + one + two + Q * math.sin(at), p * (one - two) + Q * w * math.cos(at)
        if y < 0.0:
            high = at
        else:
            low = at
        new = at - y * w / v if v != 0.0 else low
        if not low <= new <= high or v >= 0.0:
            new = 0.5 * (low + high)
        close = abs(new - at) <= 1e-15 * end
        at = new
        if close:
            break
    return True, at, 0.0, min(v, 0.0)


@compiled
def rock(branch: FloatArray, A: float, w: float, end: float) -> tuple[bool, bool, int]:
    """Rock a body from rest under A sin(w t) up to the phase `end`, pi or 2 pi.

    Return whether it overturns, whether it rocks, and the number of impacts.
    """
    side, phase = find_lift(branch, A, 0.0, end)
    if side < 0:
        return False, False, 0
    y, v, impacts = 0.0, 0.0, 0
    while phase < end and impacts < MOST_IMPACTS:
        if side < 0:
            side, phase = find_lift(branch, A, phase, end)
            if side < 0:
                return False, True, impacts
            v = 0.0
        down, phase, y, v = follow_leg(branch, side, A, w, phase, v, end)
        if not down:
            break
        impacts += 1
        v, side, y = -v * branch[side, BOUNCE], int(branch[side, PARTNER]), 0.0
        slow, a = REST * branch[side, RATE], A * math.sin(phase)
        pushed = -a > branch[0, THRESHOLD] or a > branch[1, THRESHOLD]
        if v < slow and (v < slow * (NO_BOUNCE / REST) or not pushed):
            side, v = -1, 0.0
    return (
        (phase < end and impacts < MOST_IMPACTS) or (side >= 0 and overturns_freely(branch, side, y, v)),
        True,
        impacts,
    )


@compiled
def overturns_freely(branch: FloatArray, side: int, y: float, v: float) -> bool:
    """Return whether a free body overturns: y + y' / p > 1, or by the energy that the next impacts leave."""
    p = branch[side, RATE]
    if y + v / p > 1.0:
        return True
    energy = v * v + p * p * y * (2.0 - y)  # y'^2 at the next impact
    for _ in range(4):
        energy *= branch[side, BOUNCE] ** 2
        side = int(branch[side, PARTNER])
        if energy > branch[side, RATE] ** 2:
            return True
    return False


@entry
def sine_outcomes(branches: FloatArray, end: float, frequency: FloatArray, oscillator: IntArray, motion: IntArray,
                  scale: FloatArray, found: FloatArray) -> None:  # fmt: skip
    """Run all jobs under a sine up to the phase `end`, pi or 2 pi.

    Fills the columns OVERTURNED, UPLIFTED and IMPACTS of `found` [jobs, 8].

    branches [oscillators, 2, 6]; frequency [Hz] of each motion; scale: signed peak acceleration [m/s2] of each job.
    """
    for j in range(oscillator.shape[0]):
        w = 2.0 * math.pi * frequency[motion[j]]
        down, rocked, impacts = rock(branches[oscillator[j]], scale[j], w, end)
        found[j, OVERTURNED] = 1.0 if down else 0.0
        found[j, UPLIFTED] = 1.0 if rocked else 0.0
        found[j, IMPACTS] = impacts


@reachable
def overturns(job: tuple[FloatArray, float, float], scale: float) -> bool:
    """Return whether a sine of peak acceleration `scale`, with its sign, overturns; job: branch, w, end of `rock`."""
    branch, w, end = job
    return rock(branch, scale, w, end)[0]


search_sine = make_search(overturns)


@entry
def envelope_sine(branch: FloatArray, end: float, frequency: FloatArray, factor: FloatArray, safe: FloatArray,
                  scan: FloatArray, signs: FloatArray, amplitude: FloatArray, bisections: int, overturned: BoolArray,
                  least: FloatArray) -> None:  # fmt: skip
    """Fill the map and lower bound of one oscillator under a sine up to the phase `end`, as `envelope_linearised`."""
    for i in range(len(frequency)):
        job = (branch, 2.0 * math.pi * frequency[i], end)
        search_sine(job, factor[i], safe[i], scan[i], signs, amplitude, bisections, overturned[i], least[i])
