"""One job from beginning to end: the march that both equations share."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from assess.dynamics.kernel.columns import (
    BOUNCE,
    IMPACT,
    IMPACTS,
    LARGEST,
    LIMIT,
    OVERTURNED,
    PARTNER,
    PASSED,
    PEAK,
    RATE,
    TAIL_LIMIT,
    THRESHOLD,
    UPLIFT,
    UPLIFTED,
)
from assess.dynamics.kernel.events import (
    NO_BOUNCE,
    REST,
    State,
    find_uplift,
    keep_largest,
    lifts,
    no_event,
    record_event,
)
from assess.dynamics.kernel.ground import (
    Ground,
    count_intervals,
    ground_at,
    ground_over,
    shift,
    skip_idle,
    still_ground,
)
from assess.dynamics.kernel.polynomial import Arc, derivative, divide_by_time, evaluate, find_peak, find_root
from assess.kernel import compiled, inlined, reachable
from spectra.arrays import FloatArray

Advance = Callable[..., tuple[int, float, float, float]]
StepMarch = Callable[..., tuple[Arc, float, State]]
Potential = Callable[..., float]
March = Callable[..., int]
Interval = Callable[..., tuple[float, int, float, float, int]]
SMALLEST_STEP = 1e-6
"""The shortest step of the exact equation, as a fraction of an interval, so that a body rattling about a jump of its
table still makes progress; also the least distance at which an inflection counts. The error goes with its square."""
TAIL_PIECE = 0.5
TAIL_PIECES = 120
"""Free motion after the record is followed in at most TAIL_PIECES pieces of TAIL_PIECE / p, p of the faster branch."""


def make_interval(step: StepMarch) -> Interval:
    """Return what integrates an interval with all its events, for the equation of this step."""

    @inlined
    def integrate_interval(flow: Any, branch: FloatArray, found: FloatArray, events: FloatArray, column: int,
                           peaked: int, sides_awaited: int, side: int, y: float, v: float, time: float, ground: Ground,
                           x: float, h: float, resumes: bool) -> tuple[float, int, float, float, int]:  # fmt: skip
        """Integrate with all events from x to h [s] after `time`, or up to the first event if the march `resumes`.

        Return the time reached, h if done, side (-1 at rest), y, y' there, sides that peaked.

        ground: its acceleration from `time` on. column: the column of `branch` with the limit of overturning.
        The integration ends early once all `sides_awaited` sides have peaked (a bit for each side; 0: never).

        Each turn of the loop advances the time, or stops the velocity, or brings the body to rest.
        """
        every_peak = sides_awaited > 0 or events.shape[0] > 1
        while x < h:
            a, left = shift(ground, x), h - x
            if side < 0:
                side, wait = find_uplift(branch, a, left)
                if side < 0:
                    return h, side, y, v, peaked
                x, y, v = x + wait, 0.0, 0.0
                found[UPLIFTED] = 1.0
                record_event(events, time + x, UPLIFT, 0.0, side)
                continue
            top = -1.0 if every_peak else found[LARGEST + side]
            arc, piece, (y1, v1, k1) = step(flow, side, y, v, a, left)
            k = 2.0 * arc[2]
            if no_event((y, v, k), (y1, v1, k1), 1.5 * piece, top, branch[side, column]):
                x, y, v = (h if piece == left else x + piece), y1, v1
                continue
            rate, peak = derivative(arc), False
            if v * v1 > 0.0 and k * k1 < 0.0:  # the velocity has an extreme: does it change sign before and after?
                bent = find_root(derivative(rate), 0.0, piece)
                if v * evaluate(rate, bent) < 0.0 and bent > SMALLEST_STEP * h:
                    piece, y1, v1 = bent, evaluate(arc, bent), evaluate(rate, bent)
            if v1 < 0.0 and (v > 0.0 or (v == 0.0 and k > 0.0)):
                if y + (v + max(k, 0.0) * piece) * piece >= min(top, 1.0):
                    piece, peak = find_peak(arc, rate, piece), True
                    y1, v1 = max(evaluate(arc, piece), y), 0.0
            elif v < 0.0 < v1 and y + v * piece <= 0.0:
                lowest = find_root(rate, 0.0, piece)
                if evaluate(arc, lowest) < 0.0:
                    piece, y1, v1 = lowest, evaluate(arc, lowest), 0.0
            if y1 < 0.0:
                if y > 0.0 or v > 0.0 or k > 0.0:
                    piece = find_root(arc, 0.0, piece) if y > 0.0 else find_root(divide_by_time(arc), 0.0, piece)
                    x, v = x + piece, min(evaluate(rate, piece), 0.0)
                elif v == 0.0:
                    return h, -1, 0.0, 0.0, peaked  # at rest, without acceleration, to the end of the interval
                found[IMPACTS] += 1.0
                record_event(events, time + x, IMPACT, v, side)
                v, y, side = -v * branch[side, BOUNCE], 0.0, int(branch[side, PARTNER])
                slow = REST * branch[side, RATE]
                if v < slow and (v < slow * (NO_BOUNCE / REST) or not lifts(branch, ground_at(ground, x))):
                    side, v = -1, 0.0
                elif resumes:
                    break
                continue
            if y < 1.0 <= y1:
                found[PASSED] = time + x + find_root(arc, 1.0, piece)
            x, y, v = (h if piece == left else x + piece), y1, v1
            if peak:
                peaked |= 1 << side
                keep_largest(found, y, side, time + x)
                record_event(events, time + x, PEAK, y, side)
            if y >= branch[side, column] and v >= 0.0:
                found[OVERTURNED] = 1.0
                keep_largest(found, y, side, time + x)
                return h, side, y, v, peaked
            if resumes or (sides_awaited > 0 and peaked == sides_awaited):
                break
        return x, side, y, v, peaked

    return integrate_interval


def make_march(advance_quiet: Advance, step: StepMarch, potential: Potential) -> March:
    """Return the march of one job for the equation that these three functions define."""

    integrate_interval = make_interval(step)

    @compiled
    def count_last_impacts(flow: Any, branch: FloatArray, found: FloatArray, both: int, side: int, y: float,
                           v: float) -> int:  # fmt: skip
        """Count the impacts until a body in free motion has peaked on each side or is at rest.

        Found from its energy and what each impact leaves of it. Return -1 if a coming peak may be the largest yet.
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
    def overturns_freely(flow: Any, branch: FloatArray, side: int, y: float, v: float) -> bool:
        """Return whether a body in free motion overturns, by its energy now or by what the next impacts leave of it."""
        E, top = 0.5 * v * v + potential(flow, side, y), potential(flow, side, 1.0)
        if (v > 0.0 and top < E) or (y >= 1.0 and (v >= 0.0 or top > E)):
            return True
        for _ in range(4):  # later impacts on a side leave no more energy than the one before
            E *= branch[side, BOUNCE] ** 2
            side = int(branch[side, PARTNER])
            if potential(flow, side, 1.0) < E:
                return True
        return False

    @reachable
    def march(flow: Any, branch: FloatArray, ground: FloatArray, blocks: FloatArray, dt: float, scale: float,
              release: float, found: FloatArray, path: FloatArray, events: FloatArray, ends: bool) -> int:  # fmt: skip
        """Run one job and fill `found` [8]; return the number of samples passed.

        ground: the motion [n], or [n, 6] of a pulse, at step dt, times `scale`. blocks: extremes of a record, as for
        `skip_idle`; of a pulse they are not read. release: initial y of the positive branch, 0 for rest. path [n or 0,
        3]: filled with y, y' and the side (-1 at rest) at the samples if not empty; events [capacity + 1, 4]: filled if
        there is room. ends: overturning alone is asked, at the end of the motion.

        After the record the motion is free, and is followed until no later peak can be larger: until the energy shows
        so, or each side has peaked, or the body is at rest or overturned. A body still balanced after the last piece,
        possible only within rounding of the threshold, counts as overturned if y > 1.
        """
        for c in range(found.shape[0]):
            found[c] = math.nan if c == PASSED else 0.0
        side, y, v = -1, 0.0, 0.0
        if release > 0.0:
            side, y = 0, release
            keep_largest(found, y, side, 0.0)
        traced, every_peak = path.shape[0] > 0, events.shape[0] > 1
        if traced:
            path[0, 0], path[0, 1], path[0, 2] = y, v, side
        lowest, highest = -branch[0, THRESHOLD], branch[1, THRESHOLD]
        last, tail = count_intervals(ground), TAIL_PIECE / max(branch[0, RATE], branch[1, RATE])
        both = 1 | (1 << int(branch[0, PARTNER]))
        samples, peaked, sides_awaited, column, h, time, i, x = last + 1, 0, 0, LIMIT, dt, 0.0, 0, 0.0
        resumes = branch[0, THRESHOLD] == 0.0
        while i < last + TAIL_PIECES:
            a, begun, until = still_ground(ground), i, i + 1 if traced else last
            if i < last:
                if side < 0:
                    i = skip_idle(ground, blocks, scale, lowest, highest, i, until)
                else:
                    top = -1.0 if every_peak else found[LARGEST + side]
                    limit = branch[side, LIMIT]
                    i, x, y, v = advance_quiet(flow, side, y, v, ground, scale, dt, i, x, until, top, limit)
                if i < until:
                    a, time = ground_over(ground, scale, dt, i), i * dt
            elif side < 0 or (sides_awaited > 0 and peaked == sides_awaited):
                break
            else:
                if ends:
                    found[OVERTURNED] = 1.0 if overturns_freely(flow, branch, side, y, v) else 0.0
                    return last + 1
                if sides_awaited == 0:
                    impacts = -1 if every_peak else count_last_impacts(flow, branch, found, both, side, y, v)
                    if impacts >= 0:
                        found[IMPACTS] += impacts
                        break
                    peaked, sides_awaited, column, h = 0, both, TAIL_LIMIT, tail
                time = last * dt + (i - last) * tail
            if begun >= last or i < until:
                x, side, y, v, peaked = integrate_interval(
                    flow, branch, found, events, column, peaked, sides_awaited, side, y, v, time, a, x, h,
                    resumes and i < last,
                )  # fmt: skip
                if x < h and i < last:
                    continue
                i, x = i + 1, 0.0
            if traced and begun < last:
                path[i, 0], path[i, 1], path[i, 2] = y, v, side
            if found[OVERTURNED] > 0.0:
                samples = min(samples, i + 1)
                break
        if side >= 0 and y >= 1.0 and peaked != sides_awaited:
            found[OVERTURNED] = 1.0  # falling, or balanced beyond 1
        if found[OVERTURNED] > 0.0:
            keep_largest(found, y, side, time + h)
            if math.isnan(found[PASSED]):
                found[PASSED] = time + h  # it never passed 1, or the table ends before 1
        return int(samples)

    return march
