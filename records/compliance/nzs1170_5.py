"""NZS 1170.5:2004 5.5: records for the numerical-integration time-history method."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from records.compliance.suite import (
    Requirement,
    RequirementKind,
    Sense,
    Suite,
    check_limit,
    unanswered_requirement,
    with_least_factor,
)
from spectra.arrays import BoolArray, FloatArray

CODE = "NZS 1170.5:2004"
LEAST_RECORDS = 3
LEAST_PERIOD = 0.4  # s, of T_1
LOG_FIT = float(np.log10(1.5))  # D_1 of a record that fits
LEAST_FACTOR, LARGEST_FACTOR = 0.33, 3.0
FAMILY = 1.3


IN_USE = "least scale factor in use over k_1 k_2"


def periods_of_interest(*, shortest: float, longest: float) -> tuple[float, float]:
    """Return the range of periods over which records are fitted to the target, 0.4 to 1.3 T_1 [s]."""
    return 0.4 * max(shortest, LEAST_PERIOD), 1.3 * max(longest, LEAST_PERIOD)


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Check number (5.5.1), scale factors k_1, fits D_1, family factor k_2, and the factors in use (5.5.2).

    k_1 of a record makes the mean square of log10(k_1 SA / SA_target) over the period least, D_1 is the root of that.
    k_2 is what then brings the largest of the records up to the target at every period, at least 1.
    """
    periods = periods_of_interest(shortest=shortest, longest=longest)
    number = check_limit(CODE, "5.5.1", RequirementKind.COUNT, "number of records", suite.count, ">=", LEAST_RECORDS)
    least, most = "least record scale factor k_1", "largest record scale factor k_1"
    fit, family = "largest misfit D_1 of a record", "family scale factor k_2"
    fits = _fits(suite, periods)
    if fits is None:
        rows: tuple[tuple[RequirementKind, str, Sense, float], ...] = (
            (RequirementKind.FACTOR, least, ">=", LEAST_FACTOR),
            (RequirementKind.FACTOR, most, "<=", LARGEST_FACTOR),
            (RequirementKind.FIT, fit, "<=", LOG_FIT),
            (RequirementKind.FIT, family, "<=", FAMILY),
            (RequirementKind.IN_USE, IN_USE, ">=", 1.0),
        )
        silent = (
            unanswered_requirement(CODE, "5.5.2", kind, what, sense, limit, periods, suite)
            for kind, what, sense, limit in rows
        )
        return (number, *silent)
    k_1, k_2, used = fits.k_1, fits.k_2, float((suite.factor / (fits.k_1 * fits.k_2)).min())
    return (
        number,
        check_limit(CODE, "5.5.2", RequirementKind.FACTOR, least, k_1.min(), ">=", LEAST_FACTOR, periods=periods),
        check_limit(CODE, "5.5.2", RequirementKind.FACTOR, most, k_1.max(), "<=", LARGEST_FACTOR, periods=periods),
        check_limit(CODE, "5.5.2", RequirementKind.FIT, fit, fits.D_1.max(), "<=", LOG_FIT, periods=periods),
        check_limit(CODE, "5.5.2", RequirementKind.FIT, family, k_2, "<=", FAMILY, periods=periods),
        with_least_factor(
            check_limit(CODE, "5.5.2", RequirementKind.IN_USE, IN_USE, used, ">=", 1.0, periods=periods), 1.0 / used
        ),
    )


def scale_factors(suite: Suite, *, shortest: float, longest: float) -> FloatArray | None:
    """Return k_1 k_2 of each record [n]; None where the target does not cover the range of periods."""
    fits = _fits(suite, periods_of_interest(shortest=shortest, longest=longest))
    return None if fits is None else fits.k_1 * fits.k_2


def unfit_records(suite: Suite, *, shortest: float, longest: float) -> BoolArray:
    """Return which records have a k_1 or D_1 beyond its limit [n]."""
    fits = _fits(suite, periods_of_interest(shortest=shortest, longest=longest))
    if fits is None:
        return np.zeros(suite.count, dtype=np.bool_)
    return np.asarray((fits.k_1 < LEAST_FACTOR) | (fits.k_1 > LARGEST_FACTOR) | (fits.D_1 > LOG_FIT))


@dataclass(frozen=True)
class _Fits:
    """k_1 and D_1 of each record [n], and k_2."""

    k_1: FloatArray
    D_1: FloatArray
    k_2: float


def _fits(suite: Suite, periods: tuple[float, float]) -> _Fits | None:
    """Fit the records as they are before scaling; None where the target does not cover the range of periods."""
    inside = (suite.period >= periods[0]) & (suite.period <= periods[1])
    if periods[0] < suite.period_range[0] or periods[1] > suite.period_range[1] or inside.sum() < 2:
        return None
    period = suite.period[inside]
    log_ratio = np.log10(suite.spectra[:, inside] / suite.factor[:, np.newaxis] / suite.target[inside])
    log_k_1 = -_mean(log_ratio, period)
    left = log_ratio + log_k_1[:, np.newaxis]
    return _Fits(10.0**log_k_1, np.sqrt(_mean(left**2, period)), max(1.0, float(10.0 ** -left.max(axis=0).min())))


def _mean(values: FloatArray, period: FloatArray) -> FloatArray:
    """Return the mean over the period [n] of values [n, k]."""
    return np.asarray(np.trapezoid(values, period, axis=1) / (period[-1] - period[0]))
