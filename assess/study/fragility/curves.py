"""Fragility curves of one mechanism: shares of records, the lognormal through them, and that of first exceedance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from assess.messages.message import Message, message, note, whole_number
from assess.results.fragility import (
    LARGE_SCALE,
    EmpiricalPoint,
    FragilityCurve,
    LognormalResult,
    MeasureResult,
    StateResult,
)
from assess.risk.bootstrap import LEAST
from assess.risk.censored import fit_firsts
from assess.risk.lognormal import Unbounded, fit_lognormals, unbounded_reason
from assess.risk.regression import equivalent_lognormals
from assess.risk.wilson import wilson
from assess.short_repr import ShortRepr
from assess.study.fragility.intervals import Fits, lognormal_result
from assess.study.fragility.question import FragilityQuestion
from assess.study.fragility.runs import Runs
from assess.study.fragility.states import Outcomes, first_bounds, outcomes, reaches
from spectra.arrays import BoolArray, FloatArray

PER_POINT = 10
"""Records of a cloud that share a point of the empirical curve, at least."""
MOST_POINTS = 10
LEAST_DISPERSION = 1e-3
"""Of a cloud; smaller ones are those of a step."""


@dataclass(frozen=True, repr=False)
class Intensities(ShortRepr):
    """A measure with the intensity of each record at scale 1 [records].

    primary : whether records are scaled by it, or by a measure that is proportional to it
    """

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
    make = cloud_curve if question.method == "cloud" else level_curve
    return make(runs, by, state, events, question)


def level_curve(
    runs: Runs, by: Intensities, state: StateResult, events: Sequence[str], question: FragilityQuestion
) -> FragilityCurve:
    """Return the curve of records at many scales; arguments are those of `fragility_curve`."""
    reached = reaches(runs, state)
    found = outcomes(runs, by.unit, reached, primary=by.primary)
    stands, falls = first_bounds(runs, by.unit, reached)

    reaching, known = found.reached.astype(np.float64), found.known.astype(np.float64)

    def counts_at_levels(counts: FloatArray) -> tuple[FloatArray, FloatArray]:
        return fit_lognormals(found.intensity, counts @ reaching, counts @ known)

    yes, n = found.reached.sum(axis=0), found.known.sum(axis=0)
    return _curve(
        runs,
        by,
        state,
        events,
        question,
        points=points(found),
        lognormal=counts_at_levels,
        first=lambda counts: fit_firsts(stands, falls, counts),
        why=unbounded_reason(found.intensity, yes, n),
    )


def cloud_curve(
    runs: Runs, by: Intensities, state: StateResult, events: Sequence[str], question: FragilityQuestion
) -> FragilityCurve:
    """Return the curve of records that are run once; arguments are those of `fragility_curve`.

    The lognormal is the one equivalent to the regression of the cloud (see `assess.risk.regression`); there is none
    where a single intensity parts the records that reach the state from the others.
    """
    at, ratio, reached = runs.scale[:, 0] * by.unit, runs.ratio[:, 0], reaches(runs, state)
    threshold = {"rocking": 0.0, "overturning": np.inf}.get(state.name, state.share or 0.0)

    def equivalent(counts: FloatArray) -> tuple[FloatArray, FloatArray]:
        median, dispersion = equivalent_lognormals(at, ratio, counts, threshold)
        return median, np.where(dispersion > LEAST_DISPERSION, dispersion, np.nan)

    why = unbounded_reason(at, reached[:, 0], np.ones(at.size))
    found = _curve(
        runs,
        by,
        state,
        events,
        question,
        points=points(in_groups(at, reached[:, 0], runs.scale[:, 0])),
        lognormal=equivalent,
        first=None,
        why="cloud-separated" if why is Unbounded.SEPARATED else why or "no-cloud",
    )
    return replace(found, least_run=float(at.min()), largest_run=float(at.max()))


def _curve(
    runs: Runs,
    by: Intensities,
    state: StateResult,
    events: Sequence[str],
    question: FragilityQuestion,
    *,
    points: tuple[EmpiricalPoint, ...],
    lognormal: Fits,
    first: Fits | None,
    why: str | None,
) -> FragilityCurve:
    fitted = _fitted(lognormal, events, question)
    return FragilityCurve(
        measure=by.measure,
        state=state,
        method=question.method,
        records=len(events),
        events=len(set(events)),
        censored=int(np.count_nonzero(~reaches(runs, state)[np.arange(len(events)), runs.last])),
        hollow=int(np.count_nonzero(runs.scale > LARGE_SCALE)),
        empirical=points,
        lognormal=fitted,
        first=None if first is None else _fitted(first, events, question),
        notes=tuple(_notes(fitted, why, events)),
    )


def _fitted(fits: Fits, events: Sequence[str], question: FragilityQuestion) -> LognormalResult | None:
    return lognormal_result(fits, events, seed=question.seed, draws=question.draws)


def points(found: Outcomes) -> tuple[EmpiricalPoint, ...]:
    """Return the share of records that reach a state at each intensity at which any is known."""
    some = found.known.any(axis=0)
    yes, n, hollow = (each.sum(axis=0)[some] for each in (found.reached, found.known, found.hollow & found.known))
    low, high = wilson(yes, n)
    rows = zip(found.intensity[some], n, yes, low, high, hollow, strict=True)
    return tuple(
        EmpiricalPoint(float(at), int(all_), int(some_), float(some_ / all_), float(below), float(above), int(far))
        for at, all_, some_, below, above, far in rows
    )


def in_groups(at: FloatArray, reached: BoolArray, scale: FloatArray) -> Outcomes:
    """Return the outcomes of records in groups of similar intensity, each at the geometric mean of its group.

    Parameters
    ----------
    at : intensity of each record [records]
    reached : whether each reaches the state [records]
    scale : factor on each [records]
    """
    count = int(np.clip(at.size // PER_POINT, 1, MOST_POINTS))
    groups = np.array_split(np.argsort(at, kind="stable"), count)
    known = np.zeros((at.size, count), dtype=bool)
    for place, group in enumerate(groups):
        known[group, place] = True
    middle = np.array([np.exp(np.mean(np.log(at[group]))) for group in groups])
    return Outcomes(middle, known & reached[:, None], known, known & (scale > LARGE_SCALE)[:, None])


def _notes(fitted: LognormalResult | None, why: str | None, events: Sequence[str]) -> Iterator[Message]:
    """Yield why there is no lognormal, or no interval of it."""
    if fitted is None:
        if why is not None:
            yield message(f"fragility-{why}")
    elif fitted.median_interval is None:
        number = len(set(events))
        if number < LEAST:
            yield note("fragility-interval-events", events=whole_number(number), least=whole_number(LEAST))
        else:
            yield note("fragility-interval-draws")
