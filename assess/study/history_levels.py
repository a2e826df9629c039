"""Histories of one oscillator under every record of a suite, at any levels of PGA, in the worse polarity."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from math import inf, isinf
from typing import Literal, TypeVar

import numpy as np

from assess.codes.check import BranchName
from assess.codes.suite import Runs, Suite
from assess.dynamics.history import Jobs, Peaks, make_solver
from assess.oscillator import Oscillator
from assess.short_repr import ShortRepr
from assess.study.motions import ScaledRecord
from assess.study.numerical_spread import CALM, FACTORS, INNER, OUTER, TWINS
from assess.study.rocking_case import RockingCase
from spectra.arrays import BoolArray, FloatArray, IntArray

Columns = TypeVar("Columns", Jobs, Peaks)
Twins = Literal["none", "all", "where they matter"]


@dataclass(frozen=True, repr=False)
class LevelPeaks(ShortRepr):
    """Largest responses of one mechanism under every record and its twins, in both polarities and with every rebound.

    levels : PGA of the target [levels] [m/s2]
    found : the largest response of every job
    scale, rebound : factors of each job on the motion and on the restitution [-]
    worse : the job that counts, of a record as it is and of its twins; of several that overturn or stay at rest, the
        first [levels, records, runs]
    """

    levels: tuple[float, ...]
    found: Peaks
    scale: FloatArray
    rebound: FloatArray
    worse: IntArray


def level_solver(
    case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> Callable[[Sequence[float], Twins], LevelPeaks]:
    """Return a solver for the histories of one mechanism; call it with levels of PGA [m/s2] and which twins to run.

    "where they matter" is of histories that rock, and the inner twins of those only which the outer ones do not follow
    to CALM; a history stands for its twins that are not run. A symmetric body is run in one polarity only: the other
    one mirrors it.
    """
    factors = np.array([motion.scaling.factor for motion in motions])
    records = [carried.record for carried in case.base]
    oscillators = [with_restitution_factor(case.oscillator, rebound) for rebound in case.rebounds]
    run = make_solver(oscillators, records, equation=case.equation, threads=threads)
    signs = np.array([1.0] if case.oscillator.symmetric else [1.0, -1.0])
    ways = np.tile(signs, len(oscillators))  # of one record at one level: every polarity with every rebound
    which = np.repeat(np.arange(len(oscillators)), signs.size)

    def jobs(levels: FloatArray, records: IntArray, way: IntArray, runs: FloatArray) -> Jobs:
        """Return the jobs of records at levels in one way each [n], in every run [n, runs]."""
        scale = (levels / site_pga * factors[records] * ways[way])[:, None] * runs
        motion, oscillator = (np.repeat(each, runs.size) for each in (records, which[way]))
        return Jobs(oscillator, motion, scale.ravel())

    def solve(levels: Sequence[float], twins: Twins) -> LevelPeaks:
        shape = (len(levels), len(motions), ways.size)
        level, record, way = (each.ravel() for each in np.indices(shape))
        pga = np.asarray(levels)[level]
        own = jobs(pga, record, way, FACTORS[:1])
        found = run(own)
        job = np.repeat(np.arange(way.size), 1 if twins == "none" else FACTORS.size).reshape(way.size, -1)

        def add(here: IntArray, runs: slice) -> None:
            nonlocal own, found
            more = jobs(pga[here], record[here], way[here], FACTORS[runs])
            job[here, runs] = own.scale.size + np.arange(more.scale.size).reshape(here.size, FACTORS[runs].size)
            own, found = _joined(own, more), _joined(found, run(more))

        if twins == "all":
            add(np.arange(way.size), TWINS)
        elif twins == "where they matter":
            rocking = np.flatnonzero(_severity(found) > 0.0)
            add(rocking, OUTER)
            add(rocking[~_calm(_severity(found)[job[rocking, : OUTER.stop]])], INNER)
        each = np.moveaxis(job.reshape(*shape, -1), 2, 3)  # [levels, records, runs, ways]
        worst = _severity(found)[each].argmax(axis=3)
        worse = np.take_along_axis(each, worst[..., None], axis=3)[..., 0]
        return LevelPeaks(tuple(levels), found, own.scale, np.array(case.rebounds)[own.oscillator], worse)

    return solve


def _calm(ratio: FloatArray) -> BoolArray:
    """Return which histories have outer twins that follow them [n], of the ratios of all three [n, 3]."""
    own = np.where(np.isinf(ratio[:, :1]), np.nan, ratio[:, :1])  # one that overturns is never calm
    calm: BoolArray = np.all(np.abs(ratio[:, 1:] - own) <= CALM * own, axis=1)
    return calm


def _joined(first: Columns, second: Columns) -> Columns:
    """Return the columns of two sets of jobs, or of their peaks, end to end."""
    each = ((getattr(first, name), getattr(second, name)) for name in (field.name for field in fields(first)))
    return type(first)(*map(np.concatenate, each))


def with_restitution_factor(oscillator: Oscillator, factor: float) -> Oscillator:
    """Return the oscillator with its restitution multiplied by a factor, at most 1."""
    if factor == 1.0:
        return oscillator
    restitution = min(1.0, factor * oscillator.positive.restitution)
    return replace(oscillator, positive=replace(oscillator.positive, restitution=restitution))


def suites_of(peaks: LevelPeaks) -> tuple[Suite, ...]:
    """Return the maxima of all records at each level; the branch is that of the worst record as it is."""
    ratio, negative = _severity(peaks.found)[peaks.worse], peaks.found.max_rotation[peaks.worse] < 0.0
    worst, with_twins = ratio[:, :, 0].argmax(axis=1).tolist(), peaks.worse.shape[2] > 1
    suites = []
    for level, own, below, place in zip(peaks.levels, ratio, negative, worst, strict=True):
        standing = tuple(None if isinf(each) else each for each in own[:, 0].tolist())
        branches = tuple(branch_of(-1.0 if each else 1.0) for each in below[:, 0].tolist())
        twins = Runs(own.T.copy(), below.T.copy()) if with_twins else None
        suites.append(Suite(level, standing, branches[place], branches, twins))
    return tuple(suites)


def branch_of(rotation: float) -> BranchName:
    """Return the branch of a signed rotation [rad]."""
    return "negative" if rotation < 0 else "positive"


def _severity(found: Peaks) -> FloatArray:
    """Return max|rotation| / overturning rotation of each job, inf where it overturned."""
    return np.where(found.overturned, inf, found.max_ratio)
