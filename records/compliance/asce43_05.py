"""ASCE/SEI 43-05: five records or more, and 2.4 on time histories that fit the design spectrum.

2.4 is written for synthetic and modified motions. Of recorded ones that are only scaled its bound below is asked over
the periods of the mechanisms, and nothing else: more than the target is no fault of theirs.
"""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from records.compliance.suite import (
    Requirement,
    RequirementKind,
    Suite,
    check_limit,
    mean_at_least,
    mean_at_most,
    mean_ratio,
    unanswered_requirement,
    usable_to,
    with_least_factor,
)
from spectra.arrays import FloatArray

CODE = "ASCE 43-05"
METHOD, CLAUSE = "response-history method", "2.4"
LEAST_RECORDS, LEAST_ARTIFICIAL = 5, 7
BELOW, ABOVE = 0.90, 1.30
PERIODS = (0.04, 5.0)  # s, 25 Hz to 0.2 Hz
ADJACENT = 9  # points below the target side by side, of a hundred to the decade
LONGEST_STEP, SHORTEST = 0.010, 20.0  # s
OF_INTEREST = (0.2, 1.2)  # of the shortest and the longest period
RECORDED = "2.4 is of synthetic or modified motions; of recorded ones this bound is asked over the mechanisms' periods"
ARTIFICIAL = "seven with artificial records among them is this program's own rule"


def periods_of_interest(*, shortest: float, longest: float) -> tuple[float, float]:
    """Return the range of periods over which the mean of recorded motions is compared with the target [s]."""
    return OF_INTEREST[0] * shortest, OF_INTEREST[1] * longest


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Check the number and the mean of the records; of artificial ones also step, duration and fit.

    Parameters
    ----------
    suite : scaled records beside their target
    shortest, longest : periods of the mechanisms at the allowable rotation [s]
    """
    if suite.artificial.any():
        return (_number(suite, LEAST_ARTIFICIAL, ARTIFICIAL), *_fitted(suite, longest=longest))
    periods = periods_of_interest(shortest=shortest, longest=longest)
    return (
        _number(suite, LEAST_RECORDS, ""),
        mean_at_least(suite, CODE, CLAUSE, share=BELOW, periods=periods, remark=RECORDED),
        *usable_to(suite, CODE, METHOD, longest=longest),
    )


def fit_periods(*, longest: float) -> tuple[float, float]:
    """Return the range of periods over which artificial records have to fit the target [s]."""
    return PERIODS[0], max(PERIODS[1], longest)


def fit_of_mean(suite: Suite, periods: tuple[float, float]) -> tuple[Requirement, ...]:
    """Require the mean within 10 % below and 30 % above the target, with no ten points running below it.

    Parameters
    ----------
    suite : scaled records beside their target
    periods : shortest and longest period of the range [s]
    """
    return (
        mean_at_least(suite, CODE, CLAUSE, share=BELOW, periods=periods),
        mean_at_most(suite, CODE, CLAUSE, share=ABOVE, periods=periods),
        _running_below(suite, periods),
    )


def _fitted(suite: Suite, *, longest: float) -> tuple[Requirement, ...]:
    made = suite.artificial
    step, duration = suite.dt[made].max(), suite.duration[made].min()
    return (
        check_limit(CODE, CLAUSE, RequirementKind.STEP, "largest time step", step, "<=", LONGEST_STEP, unit="s"),
        check_limit(CODE, CLAUSE, RequirementKind.DURATION, "shortest duration", duration, ">=", SHORTEST, unit="s"),
        *fit_of_mean(suite, fit_periods(longest=longest)),
        *usable_to(suite, CODE, METHOD, longest=longest),
    )


def _number(suite: Suite, least: int, remark: str) -> Requirement:
    return check_limit(
        CODE, METHOD, RequirementKind.COUNT, "number of records", suite.count, ">=", least, remark=remark
    )


def _running_below(suite: Suite, periods: tuple[float, float]) -> Requirement:
    what, ratio = "points side by side below the target", mean_ratio(suite, periods)
    if ratio is None:
        return unanswered_requirement(CODE, CLAUSE, RequirementKind.RUN_BELOW, what, "<=", ADJACENT, periods, suite)
    found = check_limit(
        CODE, CLAUSE, RequirementKind.RUN_BELOW, what, _longest_run(ratio < 1.0), "<=", ADJACENT, periods=periods
    )
    return with_least_factor(found, _factor_against_runs(ratio))


def _longest_run(below: np.ndarray) -> int:
    """Return the largest number of adjacent points that are true, of [k]."""
    longest, run = 0, 0
    for each in below.tolist():
        run = run + 1 if each else 0
        longest = max(longest, run)
    return longest


def _factor_against_runs(ratio: FloatArray) -> float:
    """Find the least factor on the mean with which one at least of any ten adjacent points reaches the target [-].

    ratio [k] : mean over target.
    """
    if ratio.size <= ADJACENT:
        return 0.0
    return float(1.0 / sliding_window_view(ratio, ADJACENT + 1).max(axis=1).min())
