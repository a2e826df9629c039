"""Histories of one oscillator under every record of a suite, at any levels of PGA, in the worse polarity."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import inf

import numpy as np

from assess.codes.check import BranchName
from assess.codes.context import Suite
from assess.dynamics.history import Jobs, Peaks, make_solver
from assess.oscillator import Oscillator
from assess.short_repr import ShortRepr
from assess.study.motions import ScaledRecord
from assess.study.rocking_case import RockingCase
from spectra.arrays import FloatArray, IntArray


@dataclass(frozen=True, repr=False)
class LevelPeaks(ShortRepr):
    """Largest responses of one mechanism under every record, in both polarities and with every rebound of its range.

    levels : PGA of the target [levels] [m/s2]
    found : the largest response of every job
    scale, rebound : factors of each job on the motion and on the restitution [-]
    worse : the job that counts; of several that overturn or stay at rest, the first [levels, records]
    """

    levels: tuple[float, ...]
    found: Peaks
    scale: FloatArray
    rebound: FloatArray
    worse: IntArray


def level_solver(
    case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> Callable[[Sequence[float]], LevelPeaks]:
    """Return a solver for the histories of one mechanism; call it with levels of PGA [m/s2].

    A symmetric body is run in one polarity only: the other one mirrors it.
    """
    n, factors = len(motions), np.array([motion.scaling.factor for motion in motions])
    records = [carried.record for carried in case.base]
    oscillators = [with_restitution_factor(case.oscillator, rebound) for rebound in case.rebounds]
    run = make_solver(oscillators, records, equation=case.equation, threads=threads)
    signs = np.array([1.0] if case.oscillator.symmetric else [1.0, -1.0])
    ways = np.tile(signs, len(oscillators))  # of one record at one level: every polarity with every rebound
    which = np.repeat(np.arange(len(oscillators)), signs.size)

    def solve(levels: Sequence[float]) -> LevelPeaks:
        scale = np.asarray(levels)[:, None, None] / site_pga * factors[:, None] * ways
        motion = np.broadcast_to(np.arange(n)[:, None], scale.shape)
        oscillator = np.broadcast_to(which, scale.shape).ravel()
        found = run(Jobs(oscillator, motion.ravel(), scale.ravel()))
        worst = _severity(found).reshape(scale.shape).argmax(axis=2)
        first = np.arange(0, scale.size, ways.size).reshape(worst.shape)
        return LevelPeaks(tuple(levels), found, scale.ravel(), np.array(case.rebounds)[oscillator], first + worst)

    return solve


def with_restitution_factor(oscillator: Oscillator, factor: float) -> Oscillator:
    """Return the oscillator with its restitution multiplied by a factor, at most 1."""
    if factor == 1.0:
        return oscillator
    restitution = min(1.0, factor * oscillator.positive.restitution)
    return replace(oscillator, positive=replace(oscillator.positive, restitution=restitution))


def suites_of(peaks: LevelPeaks) -> tuple[Suite, ...]:
    """Return the maxima of all records at each level; the branch is that of the worst record."""
    worst = _severity(peaks.found)[peaks.worse].argmax(axis=1)
    suites = []
    for level, jobs, place in zip(peaks.levels, peaks.worse, worst.tolist(), strict=True):
        ratios, overturned = peaks.found.max_ratio[jobs].tolist(), peaks.found.overturned[jobs].tolist()
        branches = tuple(branch_of(rotation) for rotation in peaks.found.max_rotation[jobs].tolist())
        ratio = tuple(None if over else ratio for ratio, over in zip(ratios, overturned, strict=True))
        suites.append(Suite(level, ratio, branches[place], branches))
    return tuple(suites)


def branch_of(rotation: float) -> BranchName:
    """Return the branch of a signed rotation [rad]."""
    return "negative" if rotation < 0 else "positive"


def _severity(found: Peaks) -> FloatArray:
    """Return max|rotation| / overturning rotation of each job, inf where it overturned."""
    return np.where(found.overturned, inf, found.max_ratio)
