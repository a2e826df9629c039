"""Rocking with memory: ties that yield, go slack and break, and friction that only opening joints have.

Between two peaks the body rocks on a plain table. What a tie or a toothed side wall resists with depends on the
largest rotation reached so far, and that grows on the way out only: on virgin ground a tie follows its whole law,
elastic, yielding, broken, and behind the largest rotation it is elastic to its plastic elongation, then slack. So the
laws are cut into the table where they change, and the table is made anew after each peak that left a trace. Steps end
at its kinks and jumps, as they do at those of any table, and what follows an event is the march of all other bodies.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from assess.dynamics.kernel.columns import (
    B0,
    B3,
    LEFT,
    LIMIT,
    OVERTURNED,
    PARTNER,
    PASSED,
    R0,
    R1,
    R2,
    R3,
    RATE,
    RIGHT,
    THRESHOLD,
)
from assess.dynamics.kernel.events import State, keep_largest
from assess.dynamics.kernel.exact import exact_advance, exact_step
from assess.dynamics.kernel.ground import Ground, ground_at, ground_over, shift, skip_idle, still_ground
from assess.dynamics.kernel.march import TAIL_PIECE, TAIL_PIECES, make_interval
from assess.dynamics.kernel.polynomial import Arc
from assess.kernel import compiled, entry, inlined
from spectra.arrays import FloatArray, IntArray

# columns of `law` [ties, LAW]: stiffness over I(0) L^2 [1/(m2 s2)]; elongations at yield and at which it is gone [m]
SPRING, YIELD, GONE, LAW = 0, 1, 2, 3
SLACK, ELASTIC, YIELDING, BROKEN = range(4)
CUTS = 3
"""Elongations of a tie at which its law changes."""
NUDGE = 1e-12
"""Velocity, over that which would carry it to y = 1, that tells a body which has stopped which way it goes."""
NARROW = 1e-6
"""Width of a segment in y below which a line stands for a cubic, whose bend would be rounding."""


@inlined
def step_to_edge(flow: Any, side: int, y: float, v: float, a: Ground, h: float) -> tuple[Arc, float, State]:
    """Return the arc of `exact_step`; where it ends at a jump or kink but for the error of a step, at that itself.

    So a body goes on behind it, and does not need the shortest step to pass it, which would carry the old force on.
    """
    table, smooth, _, hint, strictness, _, _ = flow
    arc, piece, (y1, v1, k1) = exact_step(flow, side, y, v, a, h)
    j = hint[side]
    low, high = table[smooth[j, 0], LEFT], table[smooth[j, 1], RIGHT]
    if v1 > 0.0 and y < high and abs(y1 - high) * strictness <= 1.0:
        y1 = high
    elif v1 < 0.0 and y > low > 0.0 and abs(y1 - low) * strictness <= 1.0:
        y1 = low
    return arc, piece, (y1, v1, k1)


integrate_interval = make_interval(step_to_edge)


@compiled
def cubic(of: FloatArray, d: float) -> float:
    """Return a cubic [4], highest power first, at a distance from the start of its segment."""
    return float(((of[0] * d + of[1]) * d + of[2]) * d + of[3])


@compiled
def phase_of(law: FloatArray, plastic: float, e: float) -> int:
    """Return the phase of a tie at an elongation that is the largest so far, or lies behind it."""
    if e >= law[GONE] or plastic == math.inf:
        return BROKEN
    if e <= plastic:
        return SLACK
    return ELASTIC if e < plastic + law[YIELD] else YIELDING


@compiled
def add_tie(row: FloatArray, law: FloatArray, plastic: float, phase: int, of: FloatArray, u: float, w: float) -> None:
    """Add what a tie resists with, between distances u and w into a segment, to the cubic of the row.

    Its force times de/dy is the cubic with the values and slopes at both ends.

    of : cubic of its elongation over the segment [4]
    """
    h = w - u
    v0, v1, s0, s1 = 0.0, 0.0, 0.0, 0.0
    for end in range(2):
        d = u if end == 0 else w
        slope, bend = (3.0 * of[0] * d + 2.0 * of[1]) * d + of[2], 6.0 * of[0] * d + 2.0 * of[1]
        pull = law[YIELD] if phase == YIELDING else cubic(of, d) - plastic
        rise = bend * pull if phase == YIELDING else slope * slope + bend * pull
        if end == 0:
            v0, s0 = law[SPRING] * pull * slope, law[SPRING] * rise
        else:
            v1, s1 = law[SPRING] * pull * slope, law[SPRING] * rise
    if h > NARROW:
        mean = (v1 - v0) / h
        row[R3] += (s0 + s1 - 2.0 * mean) / (h * h)
        row[R2] += (3.0 * mean - 2.0 * s0 - s1) / h
    row[R1] += s0
    row[R0] += v0


@compiled
def crossing(of: FloatArray, level: float, h: float) -> float:
    """Return the distance, between 0 and h, at which a cubic [4] that passes a level reaches it."""
    below = of[3] - level
    low, high = 0.0, h
    d = 0.5 * h
    for _ in range(60):
        off = cubic(of, d) - level
        if off * below > 0.0:
            low = d
        else:
            high = d
        slope = (3.0 * of[0] * d + 2.0 * of[1]) * d + of[2]
        d1 = d - off / slope if slope != 0.0 else 0.5 * (low + high)
        if not low < d1 < high:
            d1 = 0.5 * (low + high)
        if abs(d1 - d) <= 1e-16 * h:
            break
        d = d1
    return d


@compiled
def write_side(out: FloatArray, pieces: IntArray, start: int, table: FloatArray, smooth: IntArray, first: int,
               last: int, law: FloatArray, plastic: FloatArray, elongation: FloatArray, friction: FloatArray,
               reached: float, cuts: FloatArray, phases: IntArray) -> int:  # fmt: skip
    """Write the table of one side as the ties are now, and as far as it has rocked; return the row after the last.

    out, pieces : rows of `table` and `smooth`, filled from `start`; elongation [ties, segments, 4], friction
    [segments, 4] : cubics; reached : largest y of this side; cuts [CUTS ties + 3], phases [ties] : to work in
    """
    n, piece = start, start
    ties = law.shape[0]
    for k in range(ties):
        phases[k] = -1
    opening = -1
    for j in range(first, last + 1):
        left, width = table[j, LEFT], table[j, RIGHT] - table[j, LEFT]
        cuts[0], count = 0.0, 1
        if 0.0 < reached - left < width:
            cuts[1], count = reached - left, 2
        for k in range(ties):
            e, e1 = elongation[k, j, 3], elongation[k, j + 1, 3] if j < last else cubic(elongation[k, j], width)
            for level in (plastic[k], plastic[k] + law[k, YIELD], law[k, GONE]):
                if (e - level) * (e1 - level) < 0.0 and level < math.inf:
                    d, m = crossing(elongation[k, j], level, width), count
                    while m > 1 and cuts[m - 1] > d:
                        cuts[m] = cuts[m - 1]
                        m -= 1
                    cuts[m] = d
                    count += 1
        cuts[count] = width
        for c in range(count):
            u, w = cuts[c], cuts[c + 1]
            if not w > u:
                continue
            row, middle = out[n], 0.5 * (u + w)
            row[LEFT], row[RIGHT] = left + u, left + w if c + 1 < count else table[j, RIGHT]
            for high in (R3, B3):
                c3, c2, c1, c0 = table[j, high], table[j, high + 1], table[j, high + 2], table[j, high + 3]
                if u > 0.0:
                    c2, c1, c0 = (
                        c2 + 3.0 * c3 * u,
                        (3.0 * c3 * u + 2.0 * c2) * u + c1,
                        ((c3 * u + c2) * u + c1) * u + c0,
                    )
                row[high], row[high + 1], row[high + 2], row[high + 3] = c3, c2, c1, c0
            changed = j > first and c == 0 and smooth[j, 0] == j
            for k in range(ties):
                phase = phase_of(law[k], plastic[k], cubic(elongation[k, j], middle))
                changed = changed or (phases[k] >= 0 and phases[k] != phase)
                phases[k] = phase
                if phase in (ELASTIC, YIELDING):
                    add_tie(row, law[k], plastic[k], phase, elongation[k, j], u, w)
            now = 1 if left + middle > reached else 0
            changed, opening = changed or (opening >= 0 and now != opening), now
            if now == 1:
                c3, c2, c1, c0 = friction[j, 0], friction[j, 1], friction[j, 2], friction[j, 3]
                row[R3] += c3
                row[R2] += c2 + 3.0 * c3 * u
                row[R1] += (3.0 * c3 * u + 2.0 * c2) * u + c1
                row[R0] += ((c3 * u + c2) * u + c1) * u + c0
            if changed:
                for m in range(piece, n):
                    pieces[m, 0], pieces[m, 1] = piece, n - 1
                piece = n
            n += 1
    for m in range(piece, n):
        pieces[m, 0], pieces[m, 1] = piece, n - 1
    return n


@compiled
def leave_trace(law: FloatArray, plastic: FloatArray, of: FloatArray, d: float) -> bool:
    """Give each tie the plastic elongation of a peak, at a distance into its segment; return whether any has changed.

    of : cubics of the elongations over the segment [ties, 4]. A tie that is gone has an infinite one.
    """
    changed = False
    for k in range(law.shape[0]):
        e = cubic(of[k], d)
        left = math.inf if e >= law[k, GONE] else e - law[k, YIELD]
        if left > plastic[k]:
            plastic[k], changed = left, True
    return changed


@compiled
def segment_of(table: FloatArray, first: int, last: int, y: float) -> int:
    """Return the segment of a side that holds y."""
    while first < last:
        middle = (first + last) // 2
        if y > table[middle, RIGHT]:
            first = middle + 1
        else:
            last = middle
    return first


@compiled
def held_for(table: FloatArray, j: int, friction: float, y: float, side: int, a: Ground, h: float) -> tuple[float, int]:
    """Return for how long, at most h [s], friction holds a body that stopped as it opened, and where it goes then.

    friction : with which it would resist opening beyond y; j : the segment behind y
    The second number is 1 outwards, -1 inwards, 0 while it is held.
    """
    d, s = y - table[j, LEFT], 1.0 - 2.0 * side
    restoring = ((table[j, R3] * d + table[j, R2]) * d + table[j, R1]) * d + table[j, R0]
    excitation = ((table[j, B3] * d + table[j, B3 + 1]) * d + table[j, B3 + 2]) * d + table[j, B3 + 3]
    low, high = restoring / excitation, (restoring + friction) / excitation
    now, then = -s * a[0], -s * ground_at(a, h)
    if not low <= now <= high:
        return 0.0, 1 if now > high else -1
    if low <= then <= high:
        return h, 0
    edge = high if then > high else low
    return min(max((edge - now) / (then - now), 0.0) * h, h), 1 if then > high else -1


@compiled
def keep_sample(
    path: FloatArray, i: int, y: float, v: float, side: int, reached: FloatArray, plastic: FloatArray
) -> None:
    """Keep the state at a sample in the path of `march_with_memory`."""
    path[i, 0], path[i, 1], path[i, 2] = y, v, side
    path[i, 3], path[i, 4] = reached[0], reached[1]
    for k in range(plastic.shape[0]):
        path[i, 5 + k] = plastic[k]


@compiled
def march_with_memory(flow: Any, origin: Any, memory: Any, branch: FloatArray, ground: FloatArray, blocks: FloatArray,
                      dt: float, scale: float, found: FloatArray, path: FloatArray, events: FloatArray
                      ) -> int:  # fmt: skip
    """Run one job from rest and fill `found` [8]; return the number of samples passed. As `march` of `make_march`.

    flow : of the table as it is now, rewritten here; origin : (table, smooth, span) without ties; memory : (law
    [2, ties, LAW], plastic [ties], elongation, friction, reached [2], work arrays). path [n or 0, 5 + ties]: y, y',
    side, the largest y so far of each side and plastic elongations at the samples.

    After the record the motion is followed until each side has peaked once more without leaving a trace: no later peak
    is larger, as neither impacts nor ties give energy back. A body that then leans beyond y = 1, held by its ties
    alone, counts as overturned, and so does one at the end of its table.
    """
    table, smooth, span, hint, _, _, pace = flow
    base, base_smooth, base_span = origin
    law, plastic, elongation, friction, reached, cuts, phases = memory
    for c in range(found.shape[0]):
        found[c] = math.nan if c == PASSED else 0.0
    for k in range(plastic.shape[0]):
        plastic[k] = 0.0
    reached[0], reached[1] = 0.0, 0.0
    side, y, v, rewrite = -1, 0.0, 0.0, True
    lowest, highest = -math.inf, math.inf
    last, tail = len(ground) - 1, TAIL_PIECE / max(branch[0, RATE], branch[1, RATE])
    both = 1 | (1 << int(branch[0, PARTNER]))
    samples, peaked, h, time, i, x, traced = last + 1, 0, dt, 0.0, 0, 0.0, path.shape[0] > 0
    rubs = 0.0  # of a body that has stopped where it opens: the friction that holds it
    a = still_ground(ground)
    while i < last + TAIL_PIECES:
        if rewrite:
            row = 0
            for one in range(1 + int(branch[0, PARTNER])):
                begun = row
                row = write_side(
                    table, smooth, row, base, base_smooth, base_span[one, 0], base_span[one, 1], law[one], plastic,
                    elongation, friction, reached[one], cuts, phases,
                )  # fmt: skip
                span[one, 0], span[one, 1] = begun, row - 1
                hint[one] = segment_of(table, begun, row - 1, y) if one == side else begun
                branch[one, THRESHOLD] = table[begun, R0] / table[begun, B0]
            lowest, highest = -branch[0, THRESHOLD], branch[1, THRESHOLD]
            pace[0], rewrite = math.inf, False
        if i < last:
            until = i + 1 if traced else last
            if x == 0.0:
                if side < 0:
                    i = skip_idle(ground, blocks, scale, lowest, highest, i, until)
                elif rubs == 0.0:
                    i, x, y, v = exact_advance(
                        flow, side, y, v, ground, scale, dt, i, x, until, -1.0, branch[side, LIMIT]
                    )
            if traced and i == until:
                keep_sample(path, i, y, v, side, reached, plastic)
            if i == until:
                continue
            a, time = ground_over(ground, scale, dt, i), i * dt
        else:
            if side < 0 or peaked == both:
                break
            a, h, time = still_ground(ground), tail, last * dt + (i - last) * tail
        if rubs > 0.0:
            waits, way = held_for(table, segment_of(table, span[side, 0], span[side, 1], y), rubs, y, side,
                                  shift(a, x), h - x)  # fmt: skip
            if way == 0 and i >= last:
                break
            x, rubs, v = x + waits, (rubs if way == 0 else 0.0), way * NUDGE * branch[side, RATE]
            if x >= h:
                i, x = i + 1, 0.0
                if traced and i <= last:
                    keep_sample(path, i, y, v, side, reached, plastic)
            continue
        x, side, y, v, peaked = integrate_interval(
            flow, branch, found, events, LIMIT, peaked, both, side, y, v, time, a, x, h, True
        )
        if side >= 0 and v == 0.0 and y > reached[side]:
            begun = segment_of(base, base_span[side, 0], base_span[side, 1], y)
            rewrite = leave_trace(law[side], plastic, elongation[:, begun], y - base[begun, LEFT])
            rubs = cubic(friction[begun], y - base[begun, LEFT])
            rewrite = rewrite or rubs != 0.0
            reached[side] = y
        if rewrite or i < last:
            peaked = 0
        if found[OVERTURNED] > 0.0:
            samples = min(samples, i + 1)
            break
        if i >= last and peaked == both and not rewrite:
            break
        if x >= h:
            i, x = i + 1, 0.0
            if traced and i <= last:
                keep_sample(path, i, y, v, side, reached, plastic)
    if side >= 0 and y >= 1.0 and peaked != both:
        found[OVERTURNED] = 1.0
    if found[OVERTURNED] > 0.0:
        keep_largest(found, y, side, time + h)
        if side >= 0:
            begun = segment_of(base, base_span[side, 0], base_span[side, 1], y)
            leave_trace(law[side], plastic, elongation[:, begun], y - base[begun, LEFT])
        if math.isnan(found[PASSED]):
            found[PASSED] = time + h
    return int(samples)


@entry
def rock_with_memory(branches: FloatArray, table: FloatArray, smooth: IntArray, spans: IntArray, laws: FloatArray,
                     elongation: FloatArray, friction: FloatArray, tolerance: float, ground: FloatArray,
                     offset: IntArray, blocks: FloatArray, block_offset: IntArray, dt: FloatArray,
                     oscillator: IntArray, motion: IntArray, scale: FloatArray, found: FloatArray, plastic: FloatArray,
                     path: FloatArray, events: FloatArray) -> int:  # fmt: skip
    """Run all jobs and fill `found` [jobs, 8] and `plastic` [jobs, ties] [m]; return the samples passed by the last.

    laws [oscillators, 2, ties, LAW]; elongation [ties, segments, 4] [m] and friction [segments, 4] [1/s2]: cubics over
    the segments of `table`; a plastic elongation is infinite once the tie is gone. Other arguments as for `rock_exact`.
    """
    samples, ties = 0, laws.shape[2]
    longest = 0
    for o in range(spans.shape[0]):
        rows = spans[o, 0, 1] - spans[o, 0, 0] + 1 + spans[o, 1, 1] - spans[o, 1, 0] + 1
        longest = max(longest, rows + 4 * (CUTS * ties + 1))
    now, pieces = np.empty((longest, table.shape[1])), np.empty((longest, 2), dtype=np.int64)
    span, hint = np.zeros((2, 2), dtype=np.int64), np.zeros(2, dtype=np.int64)
    slow, pace, reached = np.empty(2), np.empty(2), np.zeros(2)
    cuts, phases = np.empty(CUTS * ties + 3), np.empty(ties, dtype=np.int64)
    branch = np.empty((2, branches.shape[2]))
    for j in range(oscillator.shape[0]):
        m, o = motion[j], oscillator[j]
        branch[:] = branches[o]
        for side in range(2):
            slow[side] = 0.2 / branch[side, RATE] if branch[side, RATE] > 0.0 else math.inf
        pace[0], pace[1] = math.inf, 0.0
        flow = (now, pieces, span, hint, 1.0 / tolerance, slow, pace)
        memory = (laws[o], plastic[j], elongation, friction, reached, cuts, phases)
        samples = march_with_memory(
            flow, (table, smooth, spans[o]), memory, branch, ground[offset[m] : offset[m + 1]],
            blocks[block_offset[m] : block_offset[m + 1]], dt[m], scale[j], found[j], path, events,
        )  # fmt: skip
    return samples
