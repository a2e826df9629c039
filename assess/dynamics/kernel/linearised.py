"""The linearised equation: its closed solution over one interval, its arcs, and its entry points."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from assess.dynamics.kernel.columns import FOUND, LIMIT, OVERTURNED, RATE, THRESHOLD
from assess.dynamics.kernel.events import State, no_event
from assess.dynamics.kernel.ground import Ground, ground_at, stretch_pulse
from assess.dynamics.kernel.march import make_march
from assess.dynamics.kernel.polynomial import Arc, derivative, evaluate
from assess.dynamics.kernel.search import make_search
from assess.kernel import compiled, entry, reachable
from spectra.arrays import BoolArray, FloatArray, IntArray

SHORT = 0.02
"""The longest arc, as a fraction of 1 / p: the next power of the series of its velocity is below 1e-18."""
# columns of `sides` [2, 8]
P2, INVERSE, Y_K, Y_V, Y_A, V_K, V_V, V_A = range(8)


@compiled
def series_remainder(n: int, x: float) -> float:
    """Return x^n / n! + x^(n + 2) / (n + 2)! + …: sinh or cosh without their first powers, so without cancellation."""
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
def fill_sides(sides: FloatArray, branch: FloatArray, dt: float) -> None:
    """Fill `sides` [2, 8] with the coefficients of the closed solution over one interval; zeros for a missing side."""
    for side in range(2):
        for c in range(8):
            sides[side, c] = 0.0
        p = branch[side, RATE]
        if p > 0.0:
            sinh, cosh_1 = series_remainder(1, p * dt), series_remainder(2, p * dt)
            sinh_x = series_remainder(3, p * dt)
            inverse = (1.0 - 2.0 * side) / branch[side, THRESHOLD]
            sides[side, P2], sides[side, INVERSE] = p * p, inverse
            sides[side, Y_K], sides[side, Y_V], sides[side, Y_A] = cosh_1 / p**2, sinh / p, -inverse * sinh_x / (p * dt)
            sides[side, V_K], sides[side, V_V], sides[side, V_A] = sinh / p, cosh_1, -inverse * cosh_1 / dt


@reachable
def fill_pushes(pushes: FloatArray, sides: FloatArray, ground: FloatArray, dt: float) -> None:
    """Fill `pushes` [2, n, 2] with what each interval of a unit pulse `ground` [n, 6] adds to y and y' on each side.

    Its m-th power a_m gives -a_m m! / threshold times series_remainder(m + 2, p dt) / p^m, and one less for y'.
    """
    for side in range(2):
        p, factor = math.sqrt(sides[side, P2]), -sides[side, INVERSE]
        for i in range(len(ground)):
            pushes[side, i, 0], pushes[side, i, 1] = 0.0, 0.0
        for m in range(1, 6 if p > 0.0 else 0):
            factor *= m / p
            of_y, of_v = factor * series_remainder(m + 2, p * dt), factor * p * series_remainder(m + 1, p * dt)
            for i in range(len(ground)):
                pushes[side, i, 0] += of_y * ground[i, m]
                pushes[side, i, 1] += of_v * ground[i, m]


@compiled
def linearised_advance(flow: Any, side: int, y: float, v: float, ground: FloatArray, scale: float, dt: float,
                     i: int, x: float, until: int, top: float, limit: float
                     ) -> tuple[int, float, float, float]:  # fmt: skip
    """Advance whole intervals by the closed solution while no event can occur.

    y1 = y + y'' (cosh - 1) / p^2 + y' sinh / p - s (a1 - a0) / threshold (sinh - p dt) / (p dt)
    """
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
            if not no_event((y, v, k), (y1, v1, k1), dt, top, limit):
                break
            i, y, v, k, a = i + 1, y1, v1, k1, a1
        return i, x, y, v
    k = p2 * (y - 1.0 - inverse * scale * ground[i, 0])
    while i + 1 < until:  # the acceleration at its end is that at the start of the next one
        y1 = y + (k * y_k + v * y_v + scale * pushes[side, i, 0])
        v1 = v + (k * v_k + v * v_v + scale * pushes[side, i, 1])
        k1 = p2 * (y1 - 1.0 - inverse * scale * ground[i + 1, 0])
        if not no_event((y, v, k), (y1, v1, k1), 1.5 * dt, top, limit):
            break
        i, y, v, k = i + 1, y1, v1, k1
    return i, x, y, v


@compiled
def linearised_step(flow: Any, side: int, y: float, v: float, a: Ground,
                    h: float) -> tuple[Arc, float, State]:  # fmt: skip
    """Return an arc over h, at most SHORT / p, its length and its end, from y'''' = p^2 y'' and so on.

    a: ground acceleration from the start on.
    """
    sides, _ = flow
    p2, inverse = sides[side, P2], sides[side, INVERSE]
    k, jerk = p2 * (y - 1.0 - inverse * a[0]), p2 * (v - inverse * a[1])
    if y == 0.0 and v == 0.0:
        k = max(k, 0.0)  # just lifted: rounding must not make it fall
    fourth, fifth, sixth, seventh = p2 * k, p2 * jerk, p2 * p2 * k, p2 * p2 * jerk
    if len(a) > 2:
        fourth, fifth = p2 * (k - inverse * 2.0 * a[2]), p2 * (jerk - inverse * 6.0 * a[3])
        sixth, seventh = p2 * (fourth - inverse * 24.0 * a[4]), p2 * (fifth - inverse * 120.0 * a[5])
    arc = (y, v, k * (1 / 2), jerk * (1 / 6), fourth * (1 / 24), fifth * (1 / 120), sixth * (1 / 720),
           seventh * (1 / 5040), p2 * sixth * (1 / 40320))  # fmt: skip
    h = h if p2 * h * h <= SHORT * SHORT else SHORT / math.sqrt(p2)
    y1 = evaluate(arc, h)
    return arc, h, (y1, evaluate(derivative(arc), h), p2 * (y1 - 1.0 - inverse * ground_at(a, h)))


@compiled
def linearised_potential(flow: Any, side: int, y: float) -> float:
    """Return the energy stored at y under y'' = p^2 (y - 1)."""
    sides, _ = flow
    return float(sides[side, P2] * y * (1.0 - 0.5 * y))


march_linearised = make_march(linearised_advance, linearised_step, linearised_potential)


@entry
def rock_linearised(branches: FloatArray, ground: FloatArray, offset: IntArray, blocks: FloatArray,
                    block_offset: IntArray, dt: FloatArray, peak: FloatArray, oscillator: IntArray, motion: IntArray,
                    scale: FloatArray, release: float, found: FloatArray, path: FloatArray,
                    events: FloatArray) -> int:  # fmt: skip
    """Run all jobs by the linearised equation and fill `found` [jobs, 8]; return the samples passed by the last job.

    branches [oscillators, 2, 6]; ground: all motions end to end, motion m from offset[m] to offset[m + 1]; blocks: the
    same of their extremes, as for `skip_idle`, by block_offset; dt, peak (largest |a|) of each motion; oscillator,
    motion, scale of each job. A body beyond y = 1 + peak / threshold (1 in free motion) with y' >= 0 has overturned,
    because its acceleration stays positive.
    """
    samples = 0
    branch, sides, pushes = np.empty((2, 6)), np.empty((2, 8)), np.empty((2, 0, 2))
    for j in range(oscillator.shape[0]):
        m = motion[j]
        for side in range(2):
            for c in range(6):
                branch[side, c] = branches[oscillator[j], side, c]
            branch[side, LIMIT] = 1.0 + abs(scale[j]) * peak[m] / branch[side, THRESHOLD]
        fill_sides(sides, branch, dt[m])
        samples = march_linearised(
            (sides, pushes), branch, ground[offset[m] : offset[m + 1]], blocks[block_offset[m] : block_offset[m + 1]],
            dt[m], scale[j], release, found[j], path, events, False,
        )  # fmt: skip
    return samples


@reachable
def overturns_linearised(job: Any, scale: float) -> bool:
    """Return whether a pulse of peak acceleration `scale`, with its sign, overturns."""
    flow, branch, ground, dt, found, path, events = job
    for side in range(2):
        branch[side, LIMIT] = 1.0 + abs(scale) / branch[side, THRESHOLD]
    march_linearised(flow, branch, ground, path, dt, scale, 0.0, found, path, events, True)
    return bool(found[OVERTURNED] > 0.0)


@entry
def pulse_linearised(branches: FloatArray, pulse: FloatArray, phase: float, frequency: FloatArray,
                     oscillator: IntArray, motion: IntArray, scale: FloatArray, found: FloatArray) -> None:  # fmt: skip
    """Run all jobs under a pulse by the linearised equation and fill `found` [jobs, 8].

    pulse [n, 6]: unit acceleration as polynomials of phase, each over `phase` [rad]; frequency [Hz] of each motion;
    scale: acceleration [m/s2] of each job. Jobs of one oscillator and one motion are fastest side by side.
    """
    branch, sides, pushes = np.empty((2, 6)), np.empty((2, 8)), np.empty((2, len(pulse), 2))
    ground, path, events = np.empty((len(pulse), 6)), np.empty((0, 3)), np.zeros((1, 4))
    for j in range(oscillator.shape[0]):
        m = motion[j]
        dt = phase / (2.0 * math.pi * frequency[m])
        if j == 0 or motion[j - 1] != m or oscillator[j - 1] != oscillator[j]:
            branch[:] = branches[oscillator[j]]
            stretch_pulse(ground, pulse, frequency[m])
            fill_sides(sides, branch, dt)
            fill_pushes(pushes, sides, ground, dt)
        overturns_linearised(((sides, pushes), branch, ground, dt, found[j], path, events), scale[j])


search_linearised = make_search(overturns_linearised)


@entry
def envelope_linearised(branch: FloatArray, pulse: FloatArray, phase: float, frequency: FloatArray, factor: FloatArray,
                        safe: FloatArray, scan: FloatArray, signs: FloatArray, amplitude: FloatArray, bisections: int,
                        overturned: BoolArray, least: FloatArray) -> None:  # fmt: skip
    """Fill the map and lower bound of one oscillator by the linearised equation at n frequencies.

    branch [2, 6]; pulse, phase: as for `pulse_linearised`; frequency [n] [Hz]; factor, safe [n], scan [n, k], signs,
    amplitude [m], bisections: as for `search`, which fills overturned [n, polarities, m] and least [n, 2].
    """
    sides, pushes = np.empty((2, 8)), np.empty((2, len(pulse), 2))
    own, ground, found = branch.copy(), np.empty((len(pulse), 6)), np.empty(FOUND)
    path, events = np.empty((0, 3)), np.zeros((1, 4))
    for i in range(len(frequency)):
        dt = phase / (2.0 * math.pi * frequency[i])
        stretch_pulse(ground, pulse, frequency[i])
        fill_sides(sides, own, dt)
        fill_pushes(pushes, sides, ground, dt)
        job = ((sides, pushes), own, ground, dt, found, path, events)
        search_linearised(job, factor[i], safe[i], scan[i], signs, amplitude, bisections, overturned[i], least[i])
