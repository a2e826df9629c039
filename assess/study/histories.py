"""Time histories of a mechanism under every record of a study.

They are run in the worse polarity at the levels of the study, at further levels that procedures need,
and on a scan over rising PGA.

The scan: the PGA of the target rises in steps of SCAN_STEP until records overturn the mechanism in more than 84 % of
the draws among their runs. It gives the curve of the response-history method and its PGA at collapse. On joints that
vibrate about rest a history takes ten times as many steps of integration, so there the scan has half as many levels.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import inf, isclose, log

import numpy as np

from assess.amplification import Amplification, BaseMotion, base_motion
from assess.codes.histories import LOW_SHARE, SuiteResponse, SuiteRule, share_upright
from assess.codes.procedures import pga_rules, uses_histories
from assess.codes.toothing import counted_moment, friction_left
from assess.dynamics.history import Peaks, trace
from assess.dynamics.packing import Equation
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Memory, Oscillator, Toothing, elastic_frequency, linear_multiplier
from assess.results import HistoryResult, HistoryTrace
from assess.short_repr import ShortRepr
from assess.study.level_peaks import (
    LevelPeaks,
    LevelSolver,
    RockingCase,
    Twins,
    branch_of,
    level_solver,
    suites_of,
    with_restitution_factor,
)
from assess.study.study import ScaledRecord, Study
from records.record import Record
from spectra.arrays import FloatArray, IntArray
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
    if not motions:
        return RockingHistories((), ())
    return run_histories(
        case,
        motions,
        levels=study.levels,
        further=further_levels(study, spectrum, mechanism),
        site_pga=spectrum.pga,
        with_scan=study.scan and any(map(uses_histories, study.procedures)),
        threads=threads,
    )


def rocking_oscillators(mechanism: Mechanism, equation: Equation) -> tuple[Oscillator, ...]:
    """Return the oscillators that histories follow, the deciding one first, with the friction of its side walls.

    Friction resists where the wall opens farther than ever before, so it is memory, which the exact equation has. The
    linearised one, and a wall on joints that deform, leave it out.
    """
    found, toothing = mechanism.variants.of_histories, mechanism.toothing
    moment = 0.0 if toothing is None else counted_moment(toothing)
    if toothing is None or moment <= 0.0 or equation == "linearised" or mechanism.flexible:
        return found
    return tuple(_with_friction(each, moment, toothing) for each in found)


def _with_friction(oscillator: Oscillator, moment: float, toothing: Toothing) -> Oscillator:
    """Return an oscillator with friction outwards, of a moment at rest [N m]."""
    memory = oscillator.memory or Memory(replace(oscillator, memory=None))
    first, *others = memory.bare.branches
    outwards = moment * friction_left(toothing, first.rotation)
    inwards = tuple(np.zeros_like(branch.rotation) for branch in others)
    return replace(oscillator, memory=replace(memory, friction=(outwards, *inwards)))


def rocking_case(
    study: Study,
    mechanism: Mechanism,
    motions: tuple[ScaledRecord, ...],
    *,
    at_base: Callable[[Amplification, Record], BaseMotion] = base_motion,
) -> RockingCase:
    """Return what the histories of a mechanism are run for; at_base: finds a ground motion at its base."""
    name, amplification = mechanism.name, study.amplified[mechanism.name].amplification
    base = tuple(at_base(amplification, motion.record) for motion in motions)
    first, *others = rocking_oscillators(mechanism, study.equations[name])
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
    case : the oscillator and the motions at its base
    motions : the records with their factors, in the order of `case.base`
    levels, further : PGA of the levels of the study, and of further suites [m/s2]
    site_pga : PGA of the target that the factors refer to [m/s2]
    with_scan : whether to run the scan
    threads : number of threads; 0 for all cores

    Returns
    -------
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


SCAN_STEP, SCAN_STEP_ON_JOINTS = 1.025, 1.05  # ratio of two PGAs of the scan, and where joints vibrate about rest
SCAN_START = 0.4  # of the smaller uplift acceleration, or of what a flexible joint resists at most
MOST_LEVELS, MOST_LEVELS_ON_JOINTS = 204, 102


def scan_levels(
    case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> tuple[SuiteResponse, ...]:
    """Run suites at rising PGA, up to the first one in which so many draws overturn that no rule can hold in 16 %.

    Parameters
    ----------
    case : the oscillator and the motions at its base
    motions : the records with their factors, in the order of `case.base`
    site_pga : PGA of the target that the factors refer to [m/s2]
    threads : number of threads; 0 for all cores

    Returns
    -------
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
