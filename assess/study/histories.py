"""The time histories of one mechanism: at the levels of the study, at further levels, and on a scan over rising PGA."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np
from scipy.constants import g

from assess.amplification.floor_motion import BaseMotion
from assess.dynamics.history import Peaks, trace
from assess.results import HistoryResult, Trace
from assess.study.history_levels import LevelPeaks, branch_of, level_solver, suites_of, with_restitution_factor
from assess.study.history_scan import scan_levels
from assess.study.motions import ScaledRecord
from assess.study.rocking_case import RockingCase, RockingHistories
from spectra.arrays import FloatArray, IntArray


def run_histories(
    case: RockingCase,
    motions: Sequence[ScaledRecord],
    *,
    levels: Sequence[float],
    besides: Sequence[float],
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
    levels, besides : sequence of float
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
    found = run_levels(case, motions, levels=levels, besides=besides, site_pga=site_pga, threads=threads)
    scan = scan_levels(case, motions, site_pga=site_pga, threads=threads) if with_scan else ()
    return replace(found, scan=scan)


def run_levels(
    case: RockingCase,
    motions: Sequence[ScaledRecord],
    *,
    levels: Sequence[float],
    besides: Sequence[float],
    site_pga: float,
    threads: int,
    with_twins: bool = True,
) -> RockingHistories:
    """Run one mechanism as `run_histories` does, without the scan, and if so asked each record alone."""
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)
    peaks = solve((*levels, *besides), "all" if with_twins else "none")
    histories = tuple(
        tuple(_history(peaks, jobs, carried, level) for jobs, carried in zip(peaks.worse[i], case.base, strict=True))
        for i, level in enumerate(levels)
    )
    suites = suites_of(peaks)
    return RockingHistories(histories, suites[: len(levels)], suites[len(levels) :])


def _history(peaks: LevelPeaks, runs: IntArray, carried: BaseMotion, level: float) -> HistoryResult:
    """Return the result of the runs of a record at a level [m/s2], of which the first is the record as it is."""
    job, found = int(runs[0]), peaks.found
    scale = float(peaks.scale[job])
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
        rebound=float(peaks.rebound[job]),
        twin_ratios=_standing(found.max_ratio, found, runs),
        twin_times_s=_standing(found.time_of_max, found, runs),
        twin_impacts=tuple(found.impacts[runs].tolist()) if runs.size > 1 else (),
    )


def _standing(values: FloatArray, found: Peaks, runs: IntArray) -> tuple[float | None, ...]:
    """Return values of the runs of a record, None where the body overturned; none where it was run alone."""
    if runs.size == 1:
        return ()
    pairs = zip(values[runs].tolist(), found.overturned[runs].tolist(), strict=True)
    return tuple(None if over else value for value, over in pairs)


def with_governing_trace(
    case: RockingCase, histories: Sequence[Sequence[HistoryResult]], motions: Sequence[ScaledRecord]
) -> tuple[tuple[HistoryResult, ...], ...]:
    """Return the histories, the worst record of the highest level with its trace."""
    *lower, highest = [tuple(level) for level in histories]
    worst = max(highest, key=lambda one: inf if one.max_rotation_ratio is None else one.max_rotation_ratio)
    drawn = _trace(case, worst, motions)
    return (*lower, tuple(replace(history, trace=drawn) if history is worst else history for history in highest))


def _trace(case: RockingCase, history: HistoryResult, motions: Sequence[ScaledRecord]) -> Trace:
    """Run one history again, sample by sample."""
    place = next(place for place, motion in enumerate(motions) if motion.record.id == history.record)
    ground, base = motions[place].record, case.base[place].record
    scale = history.polarity * history.scale_factor
    path = trace(with_restitution_factor(case.oscillator, history.rebound), base, scale=scale, equation=case.equation)
    below = np.interp(path.time, ground.time, ground.acceleration, right=0.0)
    same, above = base is ground, base.acceleration[: path.time.size]
    return Trace(
        time_s=tuple(path.time.tolist()),
        rotation_rad=tuple(path.rotation.tolist()),
        ground_acceleration_g=tuple((scale / g * below).tolist()),
        base_acceleration_g=None if same else tuple((scale / g * above).tolist()),
    )
