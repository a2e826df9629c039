"""Time histories: of one oscillator under one record, and of a mechanism under every record of a study.

Those of a mechanism are run in the worse polarity at the levels of the study, at further levels that procedures need,
and on a scan over rising PGA.

The scan: the PGA of the target rises in steps of SCAN_STEP until records overturn the mechanism in more than 84 % of
the draws among their runs. It gives the curve of the response-history method and its PGA at collapse. On joints that
vibrate about rest a history takes ten times as many steps of integration, so there the scan has half as many levels.

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
from math import inf, isclose, isfinite, isinf, log, nan
from typing import Literal, TypeVar

import numpy as np

from assess.amplification import BaseMotion, base_motion
from assess.codes.histories import LOW_SHARE, RecordRuns, SuiteResponse, SuiteRule, share_upright
from assess.codes.procedures import pga_rules, uses_histories
from assess.dynamics import pulses
from assess.dynamics.history import Jobs, Peaks, make_solver, peaks, trace
from assess.dynamics.packing import Equation
from assess.dynamics.pulses import Envelope
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Branch, BranchName, Oscillator, elastic_frequency, linear_multiplier
from assess.results import (
    HistoryResult,
    HistoryTrace,
)
from assess.short_repr import ShortRepr, html_table
from assess.study.study import ScaledRecord, Study
from records.errors import RecordError
from records.pulses import PulseShape, pulse_shape
from records.record import STRONGEST, Record
from spectra.arrays import BoolArray, FloatArray, IntArray, is_number
from spectra.gravity import g
from spectra.spectrum import Spectrum


def mechanism_histories(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanism: Mechanism,
    case: RockingCase,
    *,
    threads: int,
) -> RockingHistories:
    """Run the time histories of a mechanism at all levels of the study, with the scan where a procedure uses it."""
    return run_histories(
        case,
        motions,
        levels=study.levels,
        further=further_levels(study, spectrum, mechanism),
        site_pga=spectrum.pga,
        with_scan=study.scan and any(map(uses_histories, study.procedures)),
        threads=threads,
    )


def rocking_case(study: Study, mechanism: Mechanism, motions: tuple[ScaledRecord, ...]) -> RockingCase:
    """Return what the histories of a mechanism are run for."""
    name, amplification = mechanism.name, study.amplified[mechanism.name].amplification
    base = tuple(base_motion(amplification, motion.record) for motion in motions)
    first, *others = mechanism.variants.of_histories
    return RockingCase(name, first, study.equations[name], base, mechanism.rebounds, tuple(others))


def further_levels(study: Study, spectrum: Spectrum, mechanism: Mechanism) -> tuple[float, ...]:
    """Return the PGA [m/s2] of suites needed besides the levels of the study: limit states of their own, FC."""
    required = rule_levels(study, spectrum, mechanism)
    return tuple(pga for pga in required if not any(isclose(pga, level, rel_tol=1e-9) for level in study.levels))


def rule_levels(study: Study, spectrum: Spectrum, mechanism: Mechanism) -> tuple[float, ...]:
    """Return the PGA [m/s2] at which procedures with a rule of their own need suites, each once."""
    levels: list[float] = []
    knowledge = study.knowledge.get(mechanism.name, {})
    for name, required_pga in pga_rules(study.options).items():
        if name in study.procedures:
            levels += required_pga(
                study.levels, study.hazard, spectrum, crushing=mechanism.crushing, knowledge=knowledge
            )
    return tuple(dict.fromkeys(levels))


def run_histories(
    case: RockingCase,
    motions: Sequence[ScaledRecord],
    *,
    levels: Sequence[float],
    further: Sequence[float],
    site_pga: float,
    with_scan: bool,
    threads: int,
) -> RockingHistories:
    """Run one mechanism at the levels of the study and at further ones, and on a scan over rising PGA.

    Parameters
    ----------
    case : RockingCase
        The oscillator and the motions at its base.
    motions : sequence of ScaledRecord
        The records with their factors, in the order of `case.base`.
    levels, further : sequence of float
        PGA of the levels of the study, and of further suites [m/s2].
    site_pga : float
        PGA of the target that the factors refer to [m/s2].
    with_scan : bool
        Whether to run the scan.
    threads : int
        Number of threads; 0 for all cores.

    Returns
    -------
    RockingHistories
        Histories at `levels`, and suites at all levels.
    """
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)
    histories = _histories_at(solve, case, levels=levels, further=further, twins="all")
    return replace(histories, scan=_whole_scan(solve, case, motions, site_pga) if with_scan else ())


def run_to_decide(
    case: RockingCase,
    motions: Sequence[ScaledRecord],
    rules: Sequence[SuiteRule],
    *,
    levels: Sequence[float],
    further: Sequence[float],
    site_pga: float,
    with_scan: bool,
    threads: int,
    with_twins: bool = True,
) -> RockingHistories:
    """Run what outcomes and PGA at capacity depend on: the suites of `run_histories`, as far as they do.

    A rule that a suite fails as it is needs no twins there, and once each rule has failed the scan is at its end: the
    PGA at capacity is the last before the first failure. How near to its limit an answer is cannot be told from these.

    Parameters
    ----------
    rules : of the procedures that decide
    with_twins : whether those of the records are run at all
    case, motions, levels, further, site_pga, with_scan, threads : as for `run_histories`

    Returns
    -------
    RockingHistories
        Suites alone.
    """
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)

    def suites_at(levels: Sequence[float], twins: Twins) -> tuple[SuiteResponse, ...]:
        """Run suites, with twins where the records as they are pass a rule."""
        alone = suites_of(solve(levels, "none"))
        passing = [suite.pga for suite in alone if with_twins and any(rule.passes(suite) for rule in rules)]
        twinned = {suite.pga: suite for suite in suites_of(solve(passing, twins))} if passing else {}
        return tuple(twinned.get(suite.pga, suite) for suite in alone)

    scan = _scan(suites_at, case, motions, site_pga, [rule.holds for rule in rules]) if with_scan else ()
    suites = suites_at((*levels, *further), "all")
    return RockingHistories((), suites[: len(levels)], suites[len(levels) :], scan)


def run_levels(
    case: RockingCase,
    motions: Sequence[ScaledRecord],
    *,
    levels: Sequence[float],
    further: Sequence[float],
    site_pga: float,
    threads: int,
    with_twins: bool = True,
) -> RockingHistories:
    """Run one mechanism as `run_histories` does, without the scan, and where requested without twins."""
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)
    return _histories_at(solve, case, levels=levels, further=further, twins="all" if with_twins else "none")


def _histories_at(
    solve: LevelSolver, case: RockingCase, *, levels: Sequence[float], further: Sequence[float], twins: Twins
) -> RockingHistories:
    """Return the histories at levels [m/s2], and the suites at these and at further ones."""
    level_peaks = solve((*levels, *further), twins)
    histories = tuple(
        tuple(
            _history(level_peaks, jobs, at_base, level)
            for jobs, at_base in zip(level_peaks.worse[i], case.base, strict=True)
        )
        for i, level in enumerate(levels)
    )
    suites = suites_of(level_peaks)
    return RockingHistories(histories, suites[: len(levels)], suites[len(levels) :])


def with_governing_trace(
    case: RockingCase, histories: Sequence[Sequence[HistoryResult]], motions: Sequence[ScaledRecord]
) -> tuple[tuple[HistoryResult, ...], ...]:
    """Return the histories, the worst record of the highest level with its trace."""
    *lower, highest = [tuple(level) for level in histories]
    worst = max(highest, key=history_severity)
    traced = replace(worst, trace=_trace(case, worst, motions))
    return (*lower, tuple(traced if history is worst else history for history in highest))


def history_severity(history: HistoryResult) -> float:
    """Return max|rotation| / overturning rotation of a history, inf where it overturned."""
    return inf if history.max_rotation_ratio is None else history.max_rotation_ratio


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


@dataclass(frozen=True, repr=False)
class RockingHistories(ShortRepr):
    """The histories of one mechanism.

    histories : in the worse polarity [level][record]; suites : their maxima, by level
    further_suites : at further levels; scan : suites at rising PGA, up to overturning
    """

    histories: tuple[tuple[HistoryResult, ...], ...]
    suites: tuple[SuiteResponse, ...]
    further_suites: tuple[SuiteResponse, ...] = ()
    scan: tuple[SuiteResponse, ...] = ()


def without_runs(study: Study, spectrum: Spectrum, mechanism: Mechanism) -> RockingHistories:
    """Return suites of no records at every PGA that the procedures of a study ask for."""
    levels, further = study.levels, further_levels(study, spectrum, mechanism)
    empty = [SuiteResponse(level, (), "positive") for level in (*levels, *further)]
    return RockingHistories((), tuple(empty[: len(levels)]), tuple(empty[len(levels) :]))


def vibrates(oscillator: Oscillator) -> bool:
    """Return whether the oscillator vibrates about rest, on joints without a threshold of uplift."""
    return any(elastic_frequency(branch) is not None for branch in oscillator.branches)


def fastest_vibration(oscillator: Oscillator) -> float:
    """Return the largest frequency of the oscillator about rest [Hz], 0 where it does not vibrate there."""
    return max((elastic_frequency(branch) or 0.0) for branch in oscillator.branches)


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
    ends = [[_overturning(branch, case.equation) for branch in (each.branches[0], each.branches[-1])] for each in every]
    factor = np.repeat(np.array(ends) / np.array(ends[0]), len(case.rebounds), axis=0)

    def solve(jobs: Jobs) -> Peaks:
        found = run(jobs)
        side = (found.max_rotation < 0.0).astype(np.int64)
        return replace(found, max_ratio=found.max_ratio * factor[jobs.oscillator, side])

    return solve


def _overturning(branch: Branch, equation: Equation) -> float:
    """Return the rotation to which an equation refers its ratios [rad]."""
    return branch.linearised.overturning if equation == "linearised" else branch.overturning


def with_restitution_factor(oscillator: Oscillator, factor: float) -> Oscillator:
    """Return the oscillator with its restitution multiplied by a factor, at most 1."""
    if factor == 1.0:
        return oscillator
    restitution = min(1.0, factor * oscillator.positive.restitution)
    return replace(oscillator, positive=replace(oscillator.positive, restitution=restitution))


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


SCAN_STEP, SCAN_STEP_ON_JOINTS = 1.025, 1.05  # ratio of two PGAs of the scan, and where joints vibrate about rest
SCAN_START = 0.4  # of the smaller uplift acceleration, or of what a flexible joint resists at most
MOST_LEVELS, MOST_LEVELS_ON_JOINTS = 204, 102


def scan_levels(
    case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> tuple[SuiteResponse, ...]:
    """Run suites at rising PGA, up to the first one in which so many draws overturn that no rule can hold in 16 %.

    Parameters
    ----------
    case : RockingCase
        The oscillator and the motions at its base.
    motions : sequence of ScaledRecord
        The records with their factors, in the order of `case.base`.
    site_pga : float
        PGA of the target that the factors refer to [m/s2].
    threads : int
        Number of threads; 0 for all cores.

    Returns
    -------
    tuple of SuiteResponse
        At rising PGA, the last one that which ends the scan.
    """
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)
    return _whole_scan(solve, case, motions, site_pga)


def _whole_scan(
    solve: LevelSolver, case: RockingCase, motions: Sequence[ScaledRecord], site_pga: float
) -> tuple[SuiteResponse, ...]:
    """Run the scan of `scan_levels`."""

    def mostly_upright(suite: SuiteResponse) -> bool:
        return share_upright(suite) >= LOW_SHARE

    return _scan(lambda levels, twins: suites_of(solve(levels, twins)), case, motions, site_pga, (mostly_upright,))


def overturning_scan(
    case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> tuple[SuiteResponse, ...]:
    """Run the records as they are at rising PGA until they overturn the mechanism in half of the runs.

    Parameters
    ----------
    case, motions, site_pga, threads : as for `run_histories`
    """
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)

    def mostly_stands(suite: SuiteResponse) -> bool:
        return 2 * suite.overturned < len(suite.ratio)

    return _scan(lambda levels, _: suites_of(solve(levels, "none")), case, motions, site_pga, (mostly_stands,))


def _scan(
    suites_at: Callable[[Sequence[float], Twins], tuple[SuiteResponse, ...]],
    case: RockingCase,
    motions: Sequence[ScaledRecord],
    site_pga: float,
    rules: Sequence[Callable[[SuiteResponse], bool]],
) -> tuple[SuiteResponse, ...]:
    """Run suites at rising PGA until each of some rules has failed."""
    pairs = zip(motions, case.base, strict=True)
    strongest = max(motion.scaling.factor * at_base.record.pga for motion, at_base in pairs) / site_pga
    uplift = g * min(linear_multiplier(branch) for branch in case.oscillator.branches)
    start = SCAN_START * uplift / max(1.0, strongest)
    step, most = (SCAN_STEP_ON_JOINTS, MOST_LEVELS_ON_JOINTS) if vibrates(case.oscillator) else (SCAN_STEP, MOST_LEVELS)
    below = round(log(1.0 / SCAN_START) / log(step))  # levels short of uplift, which do not overturn
    suites = list(suites_at([start * step**k for k in range(below)], "where they matter"))
    for k in range(below, most):
        suites += suites_at([start * step**k], "where they matter")
        rules = [rule for rule in rules if rule(suites[-1])]
        if not rules:
            break
    return tuple(suites)


TWIN_EXPONENTS = (3, 4, 5, 6)

TWIN_FACTORS = np.array([1.0, *(1.0 + sign * 10.0**-u for u in TWIN_EXPONENTS for sign in (1.0, -1.0))])
"""On the PGA: of the record as it is, then of its eight twins [9]."""

ALL_TWINS, OUTER_TWINS, INNER_TWINS = slice(1, 9), slice(1, 3), slice(3, 9)  # outer: u = 3, inner: the others
AGREEMENT = 0.01  # of the ratio: where outer twins differ by no more, the inner ones are not run in a scan


@dataclass(frozen=True, repr=False)
class RockingResponse(ShortRepr):
    """The rocking motion of one oscillator under one record.

    Attributes
    ----------
    overturned : whether the body can no longer return
    max_ratio : largest |rotation| / overturning rotation of its branch, with rigid interfaces [-]; nan if it overturned
    max_rotation : rotation of that ratio, signed [rad]; None if it overturned
    time_of_max : when it was reached [s]; None if it overturned, 0 if the body never moved
    impacts : number of impacts, until overturning or until the free motion after the record has peaked on each side
    overturning_time : last upward passage of the overturning rotation [s]; None if it did not overturn
    record, scale, equation : what was run
    rebound : factor on the restitution of one-sided rocking, of which the worst counts [-]; 1 for all other rocking
    time : instants of the record's samples, up to overturning [n] [s]
    rotation, velocity : at these instants, signed [n] [rad], [n] [rad/s]
    acceleration : of the ground at these instants, scaled [n] [m/s2]
    limits : rotations of ratio 1 of the positive and of the negative side [rad]; one where it rocks to one side
    """

    overturned: bool
    max_ratio: float
    max_rotation: float | None
    time_of_max: float | None
    impacts: int
    overturning_time: float | None
    record: str
    scale: float
    equation: Equation
    time: FloatArray
    rotation: FloatArray
    velocity: FloatArray
    acceleration: FloatArray
    limits: tuple[float, ...]
    rebound: float = 1.0

    def _repr_html_(self) -> str:
        return html_table(
            ("record", self.record),
            ("scale", self.scale),
            ("overturned", f"at {self.overturning_time:.4g} s" if self.overturning_time is not None else "no"),
            ("largest rotation / overturning", self.max_ratio),
            ("impacts", self.impacts),
        )


def respond(
    oscillator: Oscillator, record: Record, *, scale: float = 1.0, equation: Equation = "exact"
) -> RockingResponse:
    """Solve the rocking motion of an oscillator from rest under a scaled record.

    Parameters
    ----------
    oscillator : Oscillator
        The branches of the mechanism, or of a rigid block.
    record : Record
        Acceleration of the ground at the base of the mechanism [m/s2].
    scale : float
        Factor on the record [-]; a negative one reverses its polarity.
    equation : {"exact", "linearised"}
        The equation of motion: of the branch tables, or linearised at small rotations.

    Returns
    -------
    Motion
        The largest response and the history at the record's samples.

    Raises
    ------
    MechanismError
        If a branch cannot rock.
    RecordError
        If it is not one record of finite samples, or the scale is not finite.
    """
    check_record(record)
    if not (is_number(scale) and isfinite(scale)):
        raise RecordError(f'record "{record.id}": scale = {scale}: give a finite number')
    if abs(scale) * record.pga > STRONGEST:
        raise RecordError(f'record "{record.id}": scale = {scale:g}: its peak is over {STRONGEST:g} m/s2; check it')
    first = np.zeros(1, dtype=np.int64)
    found = peaks([oscillator], [record], Jobs(first, first, np.array([scale])), equation=equation, threads=1)
    path = trace(oscillator, record, scale=scale, equation=equation)
    overturned = bool(found.overturned[0])
    acceleration = scale * record.acceleration[: path.time.size]
    acceleration.flags.writeable = False
    return RockingResponse(
        overturned=overturned,
        max_ratio=nan if overturned else float(found.max_ratio[0]),
        max_rotation=None if overturned else float(found.max_rotation[0]),
        time_of_max=None if overturned else float(found.time_of_max[0]),
        impacts=int(found.impacts[0]),
        overturning_time=float(found.overturning_time[0]) if overturned else None,
        record=record.id,
        scale=scale,
        equation=equation,
        time=path.time,
        rotation=path.rotation,
        velocity=path.velocity,
        acceleration=acceleration,
        limits=tuple(_overturning(branch, equation) for branch in oscillator.branches),
    )


def respond_at_worst_rebound(
    oscillator: Oscillator, record: Record, *, rebounds: Sequence[float], scale: float, equation: Equation
) -> RockingResponse:
    """Solve the rocking motion with every rebound of a range, and return the worst.

    Parameters
    ----------
    oscillator, record, scale, equation : as for `respond`
    rebounds : factors on the restitution [-]; of several that overturn, the first counts
    """
    motions = [
        replace(
            respond(with_restitution_factor(oscillator, factor), record, scale=scale, equation=equation), rebound=factor
        )
        for factor in rebounds
    ]
    return max(motions, key=lambda motion: inf if motion.overturned else motion.max_ratio)


def check_record(record: Record) -> None:
    """Raise RecordError for what is no record of finite samples at a time step."""
    if not isinstance(record, Record):
        raise RecordError(f"record: {type(record).__name__} given; give one record, such as read_records(path)[0]")
    samples = record.acceleration
    if not isinstance(samples, np.ndarray) or samples.ndim != 1 or samples.dtype.kind not in "iuf":
        raise RecordError(f'record "{record.id}": give its accelerations [m/s2] as an array of numbers [n]')
    if record.npts < 2 or not np.isfinite(samples).all():
        raise RecordError(f'record "{record.id}": {record.npts} samples; give two or more finite accelerations [m/s2]')
    if not (is_number(record.dt) and isfinite(record.dt) and record.dt > 0.0):
        raise RecordError(f'record "{record.id}": time step {record.dt} s; give one greater than 0')


LEAST_ABOVE_ZERO = 5e-324  # the least number above 0


def find_envelope(
    oscillator: Oscillator,
    pulse: str | PulseShape,
    *,
    frequency: Sequence[float] | FloatArray,
    amplitude: Sequence[float] | FloatArray,
    equation: Equation = "exact",
    threads: int = 0,
) -> Envelope:
    """Find which pulses of a grid overturn an oscillator, in the worse polarity, and the least that does.

    Parameters
    ----------
    oscillator : Oscillator
        The branches of the mechanism, or of a rigid block.
    pulse : str or Shape
        Name of a pulse of `records.pulses.PULSE_SHAPES`, or a shape made by `records.pulses.pulse_shape`.
    frequency : array
        Rising frequencies of the pulse [n] [Hz].
    amplitude : array
        Rising peak accelerations [m] [m/s2].
    equation : {"exact", "linearised"}
        The equation of motion.
    threads : int
        Number of threads; 0 for all cores. The results do not depend on it.

    Returns
    -------
    Envelope
        Outcome of each pulse [n, m], and at each frequency the least amplitude that overturns [n] [m/s2].

    Raises
    ------
    RecordError
        If no pulse has that name, or frequencies or amplitudes are not finite, positive and rising.
    MechanismError
        If a branch cannot rock.
        If frequencies or amplitudes are not finite, positive and rising.
    """
    chosen = pulse_shape(pulse) if isinstance(pulse, str) else pulse
    if not isinstance(chosen, PulseShape):
        raise RecordError(f'pulse = {pulse!r:.60}: give the name of a pulse, such as "sine"')
    return pulses.envelope(
        oscillator,
        chosen,
        _rising_axis("frequency", frequency, least=LEAST_ABOVE_ZERO),
        _rising_axis("amplitude", amplitude, least=0.0),
        equation=equation,
        threads=threads,
    )


def _history(level_peaks: LevelPeaks, runs: IntArray, at_base: BaseMotion, level: float) -> HistoryResult:
    """Return the result of the runs of a record at a level [m/s2], of which the first is the record as it is."""
    job, peaks = int(runs[0]), level_peaks.peaks
    scale = float(level_peaks.scale[job])
    overturned = bool(peaks.overturned[job])
    return HistoryResult(
        record=at_base.record.id,
        polarity=1 if scale >= 0 else -1,
        level_pga_g=level / g,
        scale_factor=abs(scale),
        amplification=at_base.factor,
        max_rotation_rad=None if overturned else float(peaks.max_rotation[job]),
        max_rotation_ratio=None if overturned else float(peaks.max_ratio[job]),
        time_of_max_s=None if overturned else float(peaks.time_of_max[job]),
        impacts=int(peaks.impacts[job]),
        overturned=overturned,
        overturning_time_s=float(peaks.overturning_time[job]) if overturned else None,
        trace=None,
        branch=branch_of(float(peaks.max_rotation[job])),
        rebound=float(level_peaks.rebound[job]),
        variant=int(level_peaks.variant[job]),
        twin_ratios=_values_of_runs(peaks.max_ratio, peaks, runs),
        twin_times_s=_values_of_runs(peaks.time_of_max, peaks, runs),
        twin_impacts=tuple(peaks.impacts[runs].tolist()) if runs.size > 1 else (),
    )


def _values_of_runs(values: FloatArray, peaks: Peaks, runs: IntArray) -> tuple[float | None, ...]:
    """Return values of the runs of a record, None where the body overturned; none where it was run alone."""
    if runs.size == 1:
        return ()
    pairs = zip(values[runs].tolist(), peaks.overturned[runs].tolist(), strict=True)
    return tuple(None if over else value for value, over in pairs)


def _trace(case: RockingCase, history: HistoryResult, motions: Sequence[ScaledRecord]) -> HistoryTrace:
    """Run one history again, sample by sample."""
    place = next(place for place, motion in enumerate(motions) if motion.record.id == history.record)
    ground, base = motions[place].record, case.base[place].record
    scale = history.polarity * history.scale_factor
    oscillator = with_restitution_factor((case.oscillator, *case.others)[history.variant], history.rebound)
    path = trace(oscillator, base, scale=scale, equation=case.equation)
    below = np.interp(path.time, ground.time, ground.acceleration, right=0.0)
    same, above = base is ground, base.acceleration[: path.time.size]
    return HistoryTrace(
        time_s=tuple(path.time.tolist()),
        rotation_rad=tuple(path.rotation.tolist()),
        ground_acceleration_g=tuple((scale / g * below).tolist()),
        base_acceleration_g=None if same else tuple((scale / g * above).tolist()),
    )


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


def _rising_axis(name: str, numbers: Sequence[float] | FloatArray, *, least: float) -> FloatArray:
    """Return an axis of the grid; raise RecordError where it is not finite, rising, or within its bounds."""
    try:
        values = np.atleast_1d(np.array(numbers, dtype=np.float64))
    except (TypeError, ValueError):
        raise RecordError(f"{name} = {numbers!r:.60}: give rising numbers above 0") from None
    if values.ndim != 1 or not values.size or not np.isfinite(values).all():
        raise RecordError(f"{name}: give one finite number or more")
    if values[0] < least or values[-1] <= 0.0 or (np.diff(values) <= 0.0).any():
        raise RecordError(f"{name}: {values[0]:g} to {values[-1]:g}: give rising numbers above 0")
    return values
