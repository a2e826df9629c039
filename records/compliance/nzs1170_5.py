"""NZS 1170.5:2004 5.5: records for the numerical-integration time-history method."""

from __future__ import annotations

import numpy as np

from records.compliance.requirement import Requirement, Rule, check_limit, no_answer
from records.compliance.suite import Suite
from spectra.arrays import FloatArray

CODE = "NZS 1170.5:2004"
LEAST_RECORDS = 3
LEAST_PERIOD = 0.4  # s, of T_1
LOG_FIT = float(np.log10(1.5))  # D_1 of a record that fits
LEAST_FACTOR, LARGEST_FACTOR = 0.33, 3.0
FAMILY = 1.3


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Check number (5.5.1), scale factors k_1, fits D_1 and family factor k_2 (5.5.2), over 0.4 to 1.3 T_1.

    D_1 is the root of the mean square, over the period, of log10(k_1 SA / SA_target). k_2 is what brings the largest of
    the records up to the target at every period, at least 1.
    """
    periods = (0.4 * max(shortest, LEAST_PERIOD), 1.3 * max(longest, LEAST_PERIOD))
    least, most = suite.factor.min(), suite.factor.max()
    few = "k_1 is the factor in use, by least squares over the logarithm of the period"
    number = check_limit(CODE, "5.5.1", Rule.COUNT, "number of records", suite.count, ">=", LEAST_RECORDS)
    factors = (
        check_limit(CODE, "5.5.2", Rule.FACTOR, "least record scale factor k_1", least, ">=", LEAST_FACTOR, remark=few),
        check_limit(
            CODE, "5.5.2", Rule.FACTOR, "largest record scale factor k_1", most, "<=", LARGEST_FACTOR, remark=few
        ),
    )
    what = ("largest misfit D_1 of a record", "family scale factor k_2")
    inside = (suite.period >= periods[0]) & (suite.period <= periods[1])
    if periods[0] < suite.period_range[0] or periods[1] > suite.period_range[1] or inside.sum() < 2:
        missing = (
            no_answer(CODE, "5.5.2", Rule.FIT, w, "<=", limit, periods, suite)
            for w, limit in zip(what, (LOG_FIT, FAMILY), strict=True)
        )
        return (number, *factors, *missing)
    ratio = suite.spectra[:, inside] / suite.target[inside]
    worst, family = float(_fits(ratio, suite.period[inside]).max()), max(1.0, float(1.0 / ratio.max(axis=0).min()))
    return (
        number,
        *factors,
        check_limit(CODE, "5.5.2", Rule.FIT, what[0], worst, "<=", LOG_FIT, periods=periods),
        check_limit(
            CODE, "5.5.2", Rule.FIT, what[1], family, "<=", FAMILY, periods=periods, remark="k_2 is not applied"
        ),
    )


def _fits(ratio: FloatArray, period: FloatArray) -> FloatArray:
    """Return D_1 of each record [n] from its spectrum over the target [n, k]."""
    square = np.trapezoid(np.log10(ratio) ** 2, period, axis=1)
    return np.asarray(np.sqrt(square / (period[-1] - period[0])))
