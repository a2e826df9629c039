"""Fragility curves of one mechanism: shares of records, the lognormal through them, and that of first exceedance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assess.messages.message import Message, message
from assess.results.fragility import (
    EmpiricalPoint,
    FragilityCurve,
    LognormalResult,
    MeasureResult,
    StateResult,
)
from assess.risk.bootstrap import LognormalIntervals, bootstrap_first, bootstrap_lognormal
from assess.risk.censored import fit_first
from assess.risk.lognormal import Lognormal, fit_lognormal, why_unbounded
from assess.risk.wilson import wilson
from assess.short_repr import ShortRepr
from assess.study.fragility.question import FragilityQuestion
from assess.study.fragility.runs import Runs
from assess.study.fragility.states import Outcomes, first_bounds, outcomes, reaches
from spectra.arrays import BoolArray, FloatArray

PER_POINT = 10
"""Records of a cloud that share a point of the empirical curve, at least."""
MOST_POINTS = 10


@dataclass(frozen=True, repr=False)
class Intensities(ShortRepr):
    """A measure with the intensity of each record at scale 1 [records]; primary: records are scaled by it."""

    measure: MeasureResult
    unit: FloatArray
    primary: bool


def fragility_curve(
    runs: Runs, by: Intensities, state: StateResult, events: Sequence[str], question: FragilityQuestion
) -> FragilityCurve:
    """Return the fragility curve of a mechanism in one state by one measure.

    Parameters
    ----------
    runs : of all records
    by : the measure
    state : to be reached
    events : earthquake of each record [records]
    question : method, seed and draws
    """
    reached = reaches(runs, state)
    last = runs.run.sum(axis=1) - 1
    if question.method == "cloud":
        alone = runs.scale[:, 0] * by.unit
        at, found = alone[:, None], Outcomes(alone, reached, runs.run)
        points = cloud_points(alone, reached[:, 0])
        fitted = fit_lognormal(alone, reached[:, 0], np.ones(alone.size))
        why = why_unbounded(alone, reached[:, 0], np.ones(alone.size))
        first = None
    else:
        found = outcomes(runs, by.unit, reached, primary=by.primary)
        at, counts, yes = found.intensity, found.known.sum(axis=0), found.reached.sum(axis=0)
        points = level_points(found.intensity, yes, counts)
        fitted, why = fit_lognormal(at, yes, counts), why_unbounded(at, yes, counts)
        first = first_lognormal(runs, by, reached, events, question)
    return FragilityCurve(
        measure=by.measure,
        state=state,
        method=question.method,
        records=len(events),
        events=len(set(events)),
        censored=int(np.count_nonzero(~reached[np.arange(len(events)), last])),
        hollow=runs.hollow,
        empirical=points,
        lognormal=None if fitted is None else with_intervals(fitted, at, found, events, question),
        first=first,
        notes=() if why is None else (_unbounded(why.value),),
    )


def level_points(intensity: FloatArray, reached: FloatArray, records: FloatArray) -> tuple[EmpiricalPoint, ...]:
    """Return the share of records that reach a state at each intensity at which any is known [n]."""
    some = records > 0
    low, high = wilson(reached[some], records[some])
    rows = zip(intensity[some], records[some], reached[some], low, high, strict=True)
    return tuple(
        EmpiricalPoint(float(at), int(n), int(yes), float(yes / n), float(below), float(above))
        for at, n, yes, below, above in rows
    )


def cloud_points(intensity: FloatArray, reached: BoolArray) -> tuple[EmpiricalPoint, ...]:
    """Return the share of records that reach a state, in groups of as many records of similar intensity.

    Each point stands at the geometric mean of its group.

    Parameters
    ----------
    intensity : of each record [records]
    reached : whether each reaches the state [records]
    """
    count = int(np.clip(intensity.size // PER_POINT, 1, MOST_POINTS))
    groups = np.array_split(np.argsort(intensity, kind="stable"), count)
    at = np.array([np.exp(np.mean(np.log(intensity[group]))) for group in groups])
    yes, n = (np.array([each.sum() for each in parts]) for parts in
              ([reached[group] for group in groups], [np.ones(group.size) for group in groups]))  # fmt: skip
    return level_points(at, yes, n)


def with_intervals(
    fitted: Lognormal, at: FloatArray, found: Outcomes, events: Sequence[str], question: FragilityQuestion
) -> LognormalResult:
    """Return a fitted curve with its bootstrap intervals; `at` as the bootstrap takes it."""
    intervals = bootstrap_lognormal(
        at, found.reached, events, seed=question.seed, draws=question.draws, run=found.known
    )
    return _result(fitted, intervals)


def first_lognormal(
    runs: Runs, by: Intensities, reached: BoolArray, events: Sequence[str], question: FragilityQuestion
) -> LognormalResult | None:
    """Return the lognormal of the intensity at which records first reach a state; None if they do not bound one."""
    stands, reaches_at = first_bounds(runs, by.unit, reached)
    fitted = fit_first(stands, reaches_at)
    if fitted is None:
        return None
    return _result(
        fitted, bootstrap_first(stands, reaches_at, events, seed=question.seed, draws=question.draws)
    )


def _result(fitted: Lognormal, intervals: LognormalIntervals) -> LognormalResult:
    return LognormalResult(fitted.median, fitted.dispersion, intervals.median, intervals.dispersion)


def _unbounded(why: str) -> Message:
    return message(f"fragility-{why}")
