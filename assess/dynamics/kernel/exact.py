"""The exact equation: its steps with an estimate of their error, and its entry points.

An arc is the Taylor series to the fifth power, which a cubic gives from one look at the table, and one power more by
the acceleration found at the end. The defect of the series there is the estimate of the error as well (the predictor
and corrector of Hermite's scheme).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from assess.dynamics.kernel.columns import FOUND, LEFT, OVERTURNED, R0, R1, R2, R3, RATE, RIGHT, STORED, THRESHOLD
from assess.dynamics.kernel.cubics import (
    add_acceleration,
    evaluate_force,
    high_powers,
    segment_ahead,
    segment_at,
    time_derivatives,
)
from assess.dynamics.kernel.events import State, no_event
from assess.dynamics.kernel.ground import Ground, ground_at, ground_over, stretch_pulse
from assess.dynamics.kernel.joints import advance_on_joints
from assess.dynamics.kernel.march import SMALLEST_STEP, make_march
from assess.dynamics.kernel.polynomial import Arc, evaluate, find_root
from assess.dynamics.kernel.search import make_search
from assess.kernel import compiled, entry, inlined, reachable
from spectra.arrays import BoolArray, FloatArray, IntArray


@inlined
def exact_advance(flow: Any, side: int, y: float, v: float, ground: FloatArray, scale: float, dt: float, i: int,
                x: float, until: int, top: float, limit: float) -> tuple[int, float, float, float]:  # fmt: skip
    """Advance one step for each interval while the error is small enough and no event or jump of the table is met.

    On joints also by parts of an interval, from x [s] after its start; return the interval, x, y and y' reached.
    """
    table, smooth, span, hint, accuracy, slow, pace = flow
    if pace[1] > 0.0:
        return advance_on_joints(flow, side, y, v, ground, scale, dt, i, x, until, top, limit)
    if pace[0] < dt:
        return i, x, y, v
    bottom, end = span[side, 0], span[side, 1]
    j = segment_ahead(table, y, v, hint[side], bottom, end)
    first, last = smooth[j, 0], smooth[j, 1]
    low = table[first, LEFT] if first > bottom else -math.inf
    high = table[last, RIGHT] if last < end else math.inf
    s = 1.0 - 2.0 * side
    allowed = 1.0 / (accuracy * dt * max(dt * (1 / 30), slow[side]))
    correct_y, correct_v = dt * dt * (1 / 30), dt * (1 / 5)
    a = ground_over(ground, scale, dt, i)
    here = evaluate_force(table, j, y, s * a[0])
    while i < until:
        k, jerk, fourth, fifth = time_derivatives(here, v, s, a)
        y1 = y + dt * (
            v + dt * (k * (1 / 2) + dt * (jerk * (1 / 6) + dt * (fourth * (1 / 24) + dt * fifth * (1 / 120))))
        )
        v1 = v + dt * (k + dt * (jerk * (1 / 2) + dt * (fourth * (1 / 6) + dt * fifth * (1 / 24))))
        known = 0.0
        if len(a) > 2:
            q4, q5 = high_powers(here, s, a)
            known = dt**4 * (q4 + dt * q5)
            y1, v1 = y1 + dt**6 * (q4 * (1 / 30) + dt * q5 * (1 / 42)), v1 + dt**5 * (q4 * (1 / 5) + dt * q5 * (1 / 6))
        if not low <= y1 <= high:
            break
        j = segment_at(table, y1, j, first, last)
        there = evaluate_force(table, j, y1, s * ground_at(a, dt))
        defect = there[0] - (k + dt * (jerk + dt * (fourth * (1 / 2) + dt * fifth * (1 / 6)))) - known
        if not abs(defect) <= allowed:
            break
        y1, v1 = y1 + correct_y * defect, v1 + correct_v * defect
        if not no_event(
            (y, v, k), (y1, v1, there[0]), 1.5 * dt, top, limit
        ):  # y'' may exceed its values at the ends somewhat
            break
        here = add_acceleration(there, there[1] * (correct_y * defect))
        i, y, v = i + 1, y1, v1
        if i < until:
            a = ground_over(ground, scale, dt, i)
    hint[side] = j
    return i, x, y, v


@inlined
def exact_step(flow: Any, side: int, y: float, v: float, a: Ground, h: float) -> tuple[Arc, float, State]:
    """Return an arc over at most h, its length and its end.

    It reaches as far as the error allows, and at most to rest, a jump of the table, or its end.
    a: ground acceleration from the start of the arc.
    """
    table, smooth, span, hint, accuracy, slow, pace = flow
    s, smallest, left = 1.0 - 2.0 * side, SMALLEST_STEP * h, h
    h = min(h, max(pace[0], smallest))
    j = segment_ahead(table, y, v, hint[side], span[side, 0], span[side, 1])
    hint[side] = j
    first, last = smooth[j, 0], smooth[j, 1]
    low, high = table[first, LEFT], table[last, RIGHT]
    here = evaluate_force(table, j, y, s * a[0])
    if y == 0.0 and v == 0.0 and here[0] < 0.0:
        here = add_acceleration(here, -here[0])  # just lifted: rounding must not make it fall
    k, jerk, fourth, fifth = time_derivatives(here, v, s, a)
    q4, q5 = high_powers(here, s, a)
    arc = (y, v, k * (1 / 2), jerk * (1 / 6), fourth * (1 / 24), fifth * (1 / 120), q4 * (1 / 30), q5 * (1 / 42), 0.0)
    while True:
        y1, cut = evaluate(arc, h), False
        while not low <= y1 <= high and h > smallest:
            edge, cut = low if y1 < low else high, True
            if y != edge:
                h = max(find_root(arc, edge, h), smallest)
                break
            h *= 0.5  # out and back again
            y1 = evaluate(arc, h)
        y1 = evaluate(arc, h)
        j = segment_at(table, y1, j, first, last)
        there = evaluate_force(table, j, y1, s * ground_at(a, h))
        defect = there[0] - (k + h * (jerk + h * (fourth * (1 / 2) + h * fifth * (1 / 6)))) - h**4 * (q4 + h * q5)
        error = abs(defect) * h * max(h * (1 / 30), slow[side]) * accuracy
        if error <= 1.0 or h <= smallest:
            break
        h = max(h * max(0.2, 0.9 / math.sqrt(math.sqrt(error))), smallest)
    if not cut and (h < left or error > 0.5):
        pace[0] = h * min(2.0, 0.9 / math.sqrt(math.sqrt(max(error, 0.01))))
    v1 = v + h * (k + h * (jerk * (1 / 2) + h * (fourth * (1 / 6) + h * fifth * (1 / 24)))) + defect * h * (1 / 5)
    v1, more = v1 + h**5 * (q4 * (1 / 5) + h * q5 * (1 / 6)), defect * h * h * (1 / 30)
    arc = (y, v, arc[2], arc[3], arc[4], arc[5], arc[6] + more / h**6, arc[7], 0.0)
    return arc, h, (y1 + more, v1, there[0] + there[1] * more)


@compiled
def first_step(branch: FloatArray) -> float:
    """Return the second entry of `pace`, the step on joints: no limit yet, and 0 for a body with a threshold of uplift.

    The first entry is the step of `exact_step`.
    """
    return math.inf if branch[0, THRESHOLD] == 0.0 else 0.0


@compiled
def exact_potential(flow: Any, side: int, y: float) -> float:
    """Return the integral of r from rest to y."""
    table, _, span, _, _, _, _ = flow
    j = segment_at(table, y, span[side, 0], span[side, 0], span[side, 1])
    d = y - table[j, LEFT]
    return float(
        table[j, STORED]
        + d * (table[j, R0] + d * (table[j, R1] * (1 / 2) + d * (table[j, R2] * (1 / 3) + d * table[j, R3] * (1 / 4))))
    )


march_exact = make_march(exact_advance, exact_step, exact_potential)


@entry
def rock_exact(branches: FloatArray, table: FloatArray, smooth: IntArray, spans: IntArray, tolerance: float,
               ground: FloatArray, offset: IntArray, blocks: FloatArray, block_offset: IntArray, dt: FloatArray,
               oscillator: IntArray, motion: IntArray, scale: FloatArray, release: float, found: FloatArray,
               path: FloatArray, events: FloatArray) -> int:  # fmt: skip
    """Run all jobs by the exact equation and fill `found` [jobs, 8]; return the samples passed by the last job.

    table [segments, 11]: the cubics of all branches; smooth [segments, 2]: first and last segment without a jump
    between; spans [oscillators, 2, 2]: first and last segment of each branch; tolerance: error allowed in a step, of
    y [-] and y' / rate. Other arguments as for `rock_linearised`. A body at the end of its table has overturned.
    """
    samples = 0
    hint = np.empty(2, dtype=np.int64)
    slow, pace = np.empty(2), np.empty(2)
    for j in range(oscillator.shape[0]):
        m, o = motion[j], oscillator[j]
        branch, span = branches[o], spans[o]
        for side in range(2):
            hint[side], slow[side] = span[side, 0], 0.2 / branch[side, RATE]
        flow = (table, smooth, span, hint, 1.0 / tolerance, slow, pace)
        pace[0], pace[1] = math.inf, first_step(branch)
        samples = march_exact(
            flow, branch, ground[offset[m] : offset[m + 1]], blocks[block_offset[m] : block_offset[m + 1]], dt[m],
            scale[j], release, found[j], path, events, False,
        )  # fmt: skip
    return samples


@reachable
def overturns_exact(job: Any, scale: float) -> bool:
    """Return whether a pulse of peak acceleration `scale`, with its sign, overturns."""
    flow, branch, ground, dt, found, path, events = job
    _, _, span, hint, _, _, pace = flow
    hint[0], hint[1], pace[0], pace[1] = span[0, 0], span[1, 0], math.inf, first_step(branch)
    march_exact(flow, branch, ground, path, dt, scale, 0.0, found, path, events, True)
    return bool(found[OVERTURNED] > 0.0)


@entry
def pulse_exact(branches: FloatArray, table: FloatArray, smooth: IntArray, spans: IntArray, tolerance: float,
                pulse: FloatArray, phase: float, frequency: FloatArray, oscillator: IntArray, motion: IntArray,
                scale: FloatArray, found: FloatArray) -> None:  # fmt: skip
    """Run all jobs under a pulse by the exact equation and fill `found` [jobs, 8]; arguments as above."""
    hint = np.empty(2, dtype=np.int64)
    slow, pace = np.empty(2), np.empty(2)
    ground, path, events = np.empty((len(pulse), 6)), np.empty((0, 3)), np.zeros((1, 4))
    for j in range(oscillator.shape[0]):
        m, o = motion[j], oscillator[j]
        if j == 0 or motion[j - 1] != m:
            stretch_pulse(ground, pulse, frequency[m])
        slow[0], slow[1] = 0.2 / branches[o, 0, RATE], 0.2 / branches[o, 1, RATE]
        flow, dt = (table, smooth, spans[o], hint, 1.0 / tolerance, slow, pace), phase / (2.0 * math.pi * frequency[m])
        overturns_exact((flow, branches[o], ground, dt, found[j], path, events), scale[j])


search_exact = make_search(overturns_exact)


@entry
def envelope_exact(branch: FloatArray, table: FloatArray, smooth: IntArray, span: IntArray, tolerance: float,
                   pulse: FloatArray, phase: float, frequency: FloatArray, factor: FloatArray, safe: FloatArray,
                   scan: FloatArray, signs: FloatArray, amplitude: FloatArray, bisections: int, overturned: BoolArray,
                   least: FloatArray) -> None:  # fmt: skip
    """Fill the map and lower bound of one oscillator by the exact equation, as `envelope_linearised` does."""
    hint = np.empty(2, dtype=np.int64)
    slow, pace = 0.2 / branch[:, RATE], np.empty(2)
    flow = (table, smooth, span, hint, 1.0 / tolerance, slow, pace)
    ground, found = np.empty((len(pulse), 6)), np.empty(FOUND)
    path, events = np.empty((0, 3)), np.zeros((1, 4))
    for i in range(len(frequency)):
        stretch_pulse(ground, pulse, frequency[i])
        job = (flow, branch, ground, phase / (2.0 * math.pi * frequency[i]), found, path, events)
        search_exact(job, factor[i], safe[i], scan[i], signs, amplitude, bisections, overturned[i], least[i])
