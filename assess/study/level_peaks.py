"""Largest responses of a mechanism at levels of PGA: under each record and its twins, in both polarities.

The twins of a record: the same motion with the PGA times 1 + 10^-u and 1 - 10^-u, u = 3, 4, 5, 6, at every level. They
differ by less than any accelerograph resolves. Where a history is not chaotic they give the same digits; where it is,
they say how far its maximum can be trusted. That a record hardly rocks does not keep its twins small: of one that
reached 0.05 of the rotation that overturns, twins have reached 0.01 and 0.33. Wall 0a of `casa_grande` reaches 0.16
under artificial-2 at 0.39 g, its twins 0.13 to 0.66 but for one, which overturns; of a record that reaches 0.19 with
outer twins of 0.20 an inner one reaches 0.64. A wall of 0.53 x 3.06 m reaches 0.009 under the record HOS180 of Big Bear
(1992) at 0.237 g, its outer twins less, and inner ones 0.18 and 0.56: whether it still chatters when the strong pulse
comes. So no fraction of the limit says where twins can be left out.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, fields, replace
from hashlib import sha256
from math import inf, isinf
from typing import Literal, TypeVar

import numpy as np

from assess.amplification import BaseMotion
from assess.codes.histories import RecordRuns, SuiteResponse
from assess.dynamics.history import Jobs, Peaks, make_solver
from assess.dynamics.packing import Equation
from assess.oscillator import Branch, BranchName, Oscillator
from assess.short_repr import ShortRepr
from assess.study.study import ScaledRecord
from records.record import Record
from spectra.arrays import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, repr=False)
class RockingCase(ShortRepr):
    """One oscillator, the equation its histories solve, and every ground motion as it acts at its base.

    rebounds : factors on its restitution, its own value (1) first; the worst of them counts
    others : the oscillator with actions that are not shown to last; the worst counts, as a share of the rotation that
        overturns the first
    solved : where its solver keeps what it finds, which cases of one run share
    """

    name: str
    oscillator: Oscillator
    equation: Equation
    base: tuple[BaseMotion, ...]
    rebounds: tuple[float, ...] = (1.0,)
    others: tuple[Oscillator, ...] = ()
    solved: Solved | None = None


ColumnsT = TypeVar("ColumnsT", Jobs, Peaks)
Twins = Literal["none", "all", "where they matter"]


@dataclass(frozen=True, repr=False)
class LevelPeaks(ShortRepr):
    """Largest responses of one mechanism under every record and its twins, in both polarities and with every rebound.

    levels : PGA of the target [levels] [m/s2]
    peaks : the largest response of every job
    scale, rebound : factors of each job on the motion and on the restitution [-]
    variant : which of the oscillators each job rocks, from 0
    worse : the job that counts, of a record as it is and of its twins; of several that overturn or stay at rest, the
        first [levels, records, runs]
    """

    levels: tuple[float, ...]
    peaks: Peaks
    scale: FloatArray
    rebound: FloatArray
    variant: IntArray
    worse: IntArray


LevelSolver = Callable[[Sequence[float], Twins], LevelPeaks]
Solved = dict[tuple[Hashable, ...], tuple[tuple[Oscillator, ...], LevelPeaks]]
"""What solvers of one run have found, by all that it follows from; with its oscillators, known by identity."""


def level_solver(case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int) -> LevelSolver:
    """Return a solver for the histories of one mechanism; call it with levels of PGA [m/s2] and which twins to run.

    "where they matter" is of histories that rock, and the inner twins of those only which the outer ones do not follow
    to AGREEMENT; a history stands for its twins that are not run.
    """
    factors = np.array([motion.scaling.factor for motion in motions])
    records = [at_base.record for at_base in case.base]
    polarity, oscillator_number = run_variants(case)
    run = variant_solver(case, records, threads=threads)
    oscillators, solved = (case.oscillator, *case.others), {} if case.solved is None else case.solved
    digest = sha256(factors.tobytes() + TWIN_FACTORS.tobytes())
    for record in records:
        digest.update(np.float64(record.dt).tobytes() + record.acceleration.tobytes())
    same = (*map(id, oscillators), case.equation, case.rebounds, site_pga, digest.digest())

    def jobs(levels: FloatArray, records: IntArray, variant: IntArray, runs: FloatArray) -> Jobs:
        """Return the jobs of records at levels in one variant each [n], in every run [n, runs]."""
        scale = (levels / site_pga * factors[records] * polarity[variant])[:, None] * runs
        motion, oscillator = (np.repeat(each, runs.size) for each in (records, oscillator_number[variant]))
        return Jobs(oscillator, motion, scale.ravel())

    def solve(levels: Sequence[float], twins: Twins) -> LevelPeaks:
        for each in dict.fromkeys(("none", twins)):  # twins are run beside the records as they are
            asked = (*same, tuple(levels), each)
            if asked not in solved:
                alone = None if each == "none" else solved[*same, tuple(levels), "none"][1].peaks
                solved[asked] = oscillators, find(levels, twins=each, alone=alone)
        return solved[asked][1]

    def find(levels: Sequence[float], *, twins: str, alone: Peaks | None) -> LevelPeaks:
        shape = (len(levels), len(motions), polarity.size)
        level, record, variant = (each.ravel() for each in np.indices(shape))
        pga = np.asarray(levels)[level]
        jobs_run = jobs(pga, record, variant, TWIN_FACTORS[:1])
        peaks = run(jobs_run) if alone is None else alone
        job = np.repeat(np.arange(variant.size), 1 if twins == "none" else TWIN_FACTORS.size).reshape(variant.size, -1)

        def add(here: IntArray, runs: slice) -> None:
            nonlocal jobs_run, peaks
            more = jobs(pga[here], record[here], variant[here], TWIN_FACTORS[runs])
            job[here, runs] = jobs_run.scale.size + np.arange(more.scale.size).reshape(
                here.size, TWIN_FACTORS[runs].size
            )
            jobs_run, peaks = _join_columns(jobs_run, more), _join_columns(peaks, run(more))

        if twins == "all":
            add(np.arange(variant.size), ALL_TWINS)
        elif twins == "where they matter":
            rocking = np.flatnonzero(_severity(peaks) > 0.0)
            add(rocking, OUTER_TWINS)
            add(rocking[~_twins_agree(_severity(peaks)[job[rocking, : OUTER_TWINS.stop]])], INNER_TWINS)
        each = np.moveaxis(job.reshape(*shape, -1), 2, 3)  # [levels, records, runs, variants]
        worst = _severity(peaks)[each].argmax(axis=3)
        worse = np.take_along_axis(each, worst[..., None], axis=3)[..., 0]
        variant, rebound = np.divmod(jobs_run.oscillator, len(case.rebounds))
        return LevelPeaks(tuple(levels), peaks, jobs_run.scale, np.array(case.rebounds)[rebound], variant, worse)

    return solve


def run_variants(case: RockingCase) -> tuple[FloatArray, IntArray]:
    """Return how one record is run at one level: in every polarity with every rebound and every oscillator.

    A symmetric body is run in one polarity only: the other one mirrors it.

    Returns
    -------
    polarity : sign of the motion [variants]
    oscillator_number : place of the oscillator among those of `variant_solver` [variants]
    """
    every = (case.oscillator, *case.others)
    number = len(every) * len(case.rebounds)
    signs = np.array([1.0] if all(each.symmetric for each in every) else [1.0, -1.0])
    return np.tile(signs, number), np.repeat(np.arange(number), signs.size)


def variant_solver(case: RockingCase, records: Sequence[Record], *, threads: int) -> Callable[[Jobs], Peaks]:
    """Return a solver of each oscillator of a case with each rebound, whose ratios are those of the first oscillator.

    So a body that a force holds beyond the rotation that overturns it without has a ratio above 1 there.
    """
    every = (case.oscillator, *case.others)
    oscillators = [with_restitution_factor(each, rebound) for each in every for rebound in case.rebounds]
    run = make_solver(oscillators, records, equation=case.equation, threads=threads)
    if not case.others:
        return run
    ends = [
        [rotation_of_ratio_one(branch, case.equation) for branch in (each.branches[0], each.branches[-1])]
        for each in every
    ]
    factor = np.repeat(np.array(ends) / np.array(ends[0]), len(case.rebounds), axis=0)

    def solve(jobs: Jobs) -> Peaks:
        found = run(jobs)
        side = (found.max_rotation < 0.0).astype(np.int64)
        return replace(found, max_ratio=found.max_ratio * factor[jobs.oscillator, side])

    return solve


def rotation_of_ratio_one(branch: Branch, equation: Equation) -> float:
    """Return the rotation to which an equation refers its ratios [rad]."""
    return branch.linearised.overturning if equation == "linearised" else branch.overturning


def with_restitution_factor(oscillator: Oscillator, factor: float) -> Oscillator:
    """Return the oscillator with its restitution multiplied by a factor, at most 1."""
    if factor == 1.0:
        return oscillator
    restitution, memory = min(1.0, factor * oscillator.positive.restitution), oscillator.memory
    if memory is not None:
        memory = replace(memory, bare=with_restitution_factor(memory.bare, factor))
    return replace(oscillator, positive=replace(oscillator.positive, restitution=restitution), memory=memory)


def suites_of(level_peaks: LevelPeaks) -> tuple[SuiteResponse, ...]:
    """Return the maxima of all records at each level; the branch is that of the worst record as it is."""
    peaks, worse = level_peaks.peaks, level_peaks.worse
    ratio, negative = _severity(peaks)[worse], peaks.max_rotation[worse] < 0.0
    worst, with_twins = ratio[:, :, 0].argmax(axis=1).tolist(), worse.shape[2] > 1
    suites = []
    for level, own, below, place in zip(level_peaks.levels, ratio, negative, worst, strict=True):
        standing = tuple(None if isinf(each) else each for each in own[:, 0].tolist())
        branches = tuple(branch_of(-1.0 if each else 1.0) for each in below[:, 0].tolist())
        twins = RecordRuns(own.T.copy(), below.T.copy()) if with_twins else None
        suites.append(SuiteResponse(level, standing, branches[place], branches, twins))
    return tuple(suites)


def branch_of(rotation: float) -> BranchName:
    """Return the branch of a signed rotation [rad]."""
    return "negative" if rotation < 0 else "positive"


TWIN_EXPONENTS = (3, 4, 5, 6)


TWIN_FACTORS = np.array([1.0, *(1.0 + sign * 10.0**-u for u in TWIN_EXPONENTS for sign in (1.0, -1.0))])
"""On the PGA: of the record as it is, then of its eight twins [9]."""


ALL_TWINS, OUTER_TWINS, INNER_TWINS = slice(1, 9), slice(1, 3), slice(3, 9)  # outer: u = 3, inner: the others
AGREEMENT = 0.01  # of the ratio: where outer twins differ by no more, the inner ones are not run in a scan


def _twins_agree(ratio: FloatArray) -> BoolArray:
    """Return which histories have outer twins that follow them [n], of the ratios of all three [n, 3]."""
    own = np.where(np.isinf(ratio[:, :1]), np.nan, ratio[:, :1])  # of one that overturns they never agree
    agree: BoolArray = np.all(np.abs(ratio[:, 1:] - own) <= AGREEMENT * own, axis=1)
    return agree


def _join_columns(first: ColumnsT, second: ColumnsT) -> ColumnsT:
    """Return the columns of two sets of jobs, or of their peaks, end to end."""
    each = ((getattr(first, name), getattr(second, name)) for name in (field.name for field in fields(first)))
    return type(first)(*map(np.concatenate, each))


def _severity(peaks: Peaks) -> FloatArray:
    """Return max|rotation| / overturning rotation of each job, inf where it overturned."""
    return np.where(peaks.overturned, inf, peaks.max_ratio)
