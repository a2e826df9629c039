"""Time histories of a study: every mechanism under every record, in both polarities, at its levels and on a scan.

The scan raises the target's PGA in steps of SCAN_STEP until a record overturns the mechanism; it gives the curve of
the response-history method and its PGA at collapse. On joints that vibrate about rest a history takes ten times as many
steps of integration, so there the scan has half as many levels.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf, log

import numpy as np
from scipy.constants import g

from assess.amplification.floor_motion import BaseMotion
from assess.codes.check import BranchName
from assess.codes.context import Suite
from assess.dynamics.history import Jobs, Peaks, make_solver, trace
from assess.oscillator import Oscillator, elastic_frequency, resisted
from assess.results import HistoryResult, Trace
from assess.study.motions import ScaledRecord
from assess.study.study import Equation
from spectra.arrays import FloatArray, IntArray

SCAN_STEP, JOINTS_STEP = 1.025, 1.05  # ratio of two PGAs of the scan, and where joints vibrate about rest
SCAN_START = 0.4  # of the smaller uplift acceleration, or of what a flexible joint resists at most
MOST_LEVELS, MOST_ON_JOINTS = 204, 102
AT_ONCE = 3  # levels, for the threads to share; those above the first that overturns are run in vain


@dataclass(frozen=True)
class RockingCase:
    """One oscillator with the equation its histories solve, and every ground motion as it acts at its base.

    rebounds : what its restitution is multiplied by, its own value first; the worst counts
    """

    name: str
    oscillator: Oscillator
    equation: Equation
    base: tuple[BaseMotion, ...]
    rebounds: tuple[float, ...] = (1.0,)


@dataclass(frozen=True)
class RockingHistories:
    """Histories of one mechanism: [level][record] in the worse polarity, their suites, those besides, and the scan."""

    histories: tuple[tuple[HistoryResult, ...], ...]
    suites: tuple[Suite, ...]
    besides: tuple[Suite, ...] = ()
    scan: tuple[Suite, ...] = ()


def run_histories(
    shaken: RockingCase,
    motions: Sequence[ScaledRecord],
    *,
    levels: Sequence[float],
    besides: Sequence[float],
    site_pga: float,
    scanned: bool,
    threads: int,
) -> RockingHistories:
    """Histories of one mechanism at `levels` [m/s2], suites at other PGA `besides`, and its scan where `scanned`."""
    found = run_levels(shaken, motions, levels=levels, besides=besides, site_pga=site_pga, threads=threads)
    scan = scan_levels(shaken, motions, site_pga=site_pga, threads=threads) if scanned else ()
    return replace(found, scan=scan)


def run_levels(
    shaken: RockingCase,
    motions: Sequence[ScaledRecord],
    *,
    levels: Sequence[float],
    besides: Sequence[float],
    site_pga: float,
    threads: int,
) -> RockingHistories:
    """Histories of one mechanism at `levels` and suites at other PGA `besides` [m/s2], without a scan."""
    ran = level_solver(shaken, motions, site_pga=site_pga, threads=threads)((*levels, *besides))
    histories = tuple(
        tuple(
            _history(ran.found, int(job), carried, level, float(ran.scale[job]), rebound=float(ran.rebound[job]))
            for job, carried in zip(ran.worse[i], shaken.base, strict=True)
        )
        for i, level in enumerate(levels)
    )
    suites = suites_of(ran)
    return RockingHistories(histories, suites[: len(levels)], suites[len(levels) :])


@dataclass(frozen=True)
class LevelPeaks:
    """Histories of one mechanism under every record, in both polarities and with every rebound of its range.

    levels : PGA of the target [levels] [m/s2]; found : what every job found
    scale, rebound : of each job, on the motion and on the restitution [-]
    worse : the worst job; of several that overturn, or that rest, the first stands [levels, records]
    """

    levels: tuple[float, ...]
    found: Peaks
    scale: FloatArray
    rebound: FloatArray
    worse: IntArray


def level_solver(
    shaken: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> Callable[[Sequence[float]], LevelPeaks]:
    """What runs the histories at any levels [m/s2]. A symmetric body needs but one polarity: the other mirrors it."""
    n, factors = len(motions), np.array([motion.scaling.factor for motion in motions])
    records = [carried.record for carried in shaken.base]
    oscillators = [with_restitution_factor(shaken.oscillator, rebound) for rebound in shaken.rebounds]
    run = make_solver(oscillators, records, equation=shaken.equation, threads=threads)
    signs = np.array([1.0] if shaken.oscillator.symmetric else [1.0, -1.0])
    ways = np.tile(signs, len(oscillators))  # of one record at one level: every polarity with every rebound
    which = np.repeat(np.arange(len(oscillators)), signs.size)

    def ran(levels: Sequence[float]) -> LevelPeaks:
        scale = np.asarray(levels)[:, None, None] / site_pga * factors[:, None] * ways
        motion = np.broadcast_to(np.arange(n)[:, None], scale.shape)
        oscillator = np.broadcast_to(which, scale.shape).ravel()
        found = run(Jobs(oscillator, motion.ravel(), scale.ravel()))
        worst = _severity(found).reshape(scale.shape).argmax(axis=2)
        first = np.arange(0, scale.size, ways.size).reshape(worst.shape)
        return LevelPeaks(tuple(levels), found, scale.ravel(), np.array(shaken.rebounds)[oscillator], first + worst)

    return ran


def with_restitution_factor(oscillator: Oscillator, factor: float) -> Oscillator:
    """The oscillator with its restitution times a factor, at most 1; as it is at 1."""
    if factor == 1.0:
        return oscillator
    kept = min(1.0, factor * oscillator.positive.restitution)
    return replace(oscillator, positive=replace(oscillator.positive, restitution=kept))


def _severity(found: Peaks) -> FloatArray:
    """The larger the worse, for each job."""
    return np.where(found.overturned, inf, found.max_ratio)


def _history(
    found: Peaks, job: int, carried: BaseMotion, level: float, scale: float, *, rebound: float
) -> HistoryResult:
    overturned = bool(found.overturned[job])
    return HistoryResult(
        record=carried.record.id,
        polarity=1 if scale >= 0 else -1,
        level_pga_g=level / g,
        scale_factor=abs(scale),
        amplification=carried.factor,
        max_rotation_rad=None if overturned else float(found.max_rotation[job]),
        max_rotation_ratio=None if overturned else float(found.max_ratio[job]),
        time_of_max_s=None if overturned else float(found.time_of_max[job]),
        impacts=int(found.impacts[job]),
        overturned=overturned,
        overturning_time_s=float(found.overturning_time[job]) if overturned else None,
        trace=None,
        branch=branch_of(float(found.max_rotation[job])),
        rebound=rebound,
    )


def suites_of(ran: LevelPeaks) -> tuple[Suite, ...]:
    """The maxima of all records at each level; the branch is that of the worst record."""
    worst = _severity(ran.found)[ran.worse].argmax(axis=1)
    suites = []
    for level, jobs, place in zip(ran.levels, ran.worse, worst.tolist(), strict=True):
        ratios, fallen = ran.found.max_ratio[jobs].tolist(), ran.found.overturned[jobs].tolist()
        branches = tuple(branch_of(rotation) for rotation in ran.found.max_rotation[jobs].tolist())
        ratio = tuple(None if over else ratio for ratio, over in zip(ratios, fallen, strict=True))
        suites.append(Suite(level, ratio, branches[place], branches))
    return tuple(suites)


def branch_of(rotation: float) -> BranchName:
    """The branch of a signed rotation [rad]."""
    return "negative" if rotation < 0 else "positive"


def vibrates(oscillator: Oscillator) -> bool:
    """Whether it moves about rest, on joints that answer to any motion."""
    return any(elastic_frequency(branch) is not None for branch in oscillator.branches)


def scan_levels(
    shaken: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> tuple[Suite, ...]:
    """Suites at rising PGA, up to and with the first in which a record overturns the mechanism."""
    strongest = max(m.scaling.factor * at.record.pga for m, at in zip(motions, shaken.base, strict=True)) / site_pga
    uplift = g * min(resisted(branch) for branch in shaken.oscillator.branches)
    start = SCAN_START * uplift / max(1.0, strongest)
    step, most = (JOINTS_STEP, MOST_ON_JOINTS) if vibrates(shaken.oscillator) else (SCAN_STEP, MOST_LEVELS)
    run = level_solver(shaken, motions, site_pga=site_pga, threads=threads)
    below = round(log(1.0 / SCAN_START) / log(step))  # levels short of uplift, which none overturns
    suites: list[Suite] = []
    for first, beyond in pairwise([0, *range(below, most, AT_ONCE), most]):
        for suite in suites_of(run([start * step**k for k in range(first, beyond)])):
            suites.append(suite)
            if suite.overturned:
                return tuple(suites)
    return tuple(suites)


def with_governing_trace(
    shaken: RockingCase, histories: Sequence[Sequence[HistoryResult]], motions: Sequence[ScaledRecord]
) -> tuple[tuple[HistoryResult, ...], ...]:
    """The histories with the trace of the worst record of the highest level filled in."""
    *lower, highest = [tuple(level) for level in histories]
    worst = max(highest, key=lambda one: inf if one.max_rotation_ratio is None else one.max_rotation_ratio)
    place = next(place for place, motion in enumerate(motions) if motion.record.id == worst.record)
    ground, base = motions[place].record, shaken.base[place].record
    scale = worst.polarity * worst.scale_factor
    path = trace(with_restitution_factor(shaken.oscillator, worst.rebound), base, scale=scale, equation=shaken.equation)
    below = np.interp(path.time, ground.time, ground.acceleration, right=0.0)
    drawn = Trace(
        time_s=tuple(path.time.tolist()),
        rotation_rad=tuple(path.rotation.tolist()),
        ground_acceleration_g=tuple((scale / g * below).tolist()),
        base_acceleration_g=None
        if base is ground
        else tuple((scale / g * base.acceleration[: path.time.size]).tolist()),
    )
    return (*lower, tuple(replace(history, trace=drawn) if history is worst else history for history in highest))
