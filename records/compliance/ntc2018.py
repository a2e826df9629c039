"""NTC 2018 3.2.3.6: time histories of the ground's motion, natural and artificial."""

from __future__ import annotations

from records.compliance.requirement import Requirement, mean_at_least, mean_at_most, required
from records.compliance.suite import Suite

CODE = "NTC 2018"
CLAUSE = "3.2.3.6"
LEAST_RECORDS = 3
BELOW, ABOVE = 0.90, 1.30
ARTIFICIAL_FROM, ARTIFICIAL_TO = 0.15, 2.0  # s


def natural(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Number, and the mean from 10 % below to 30 % above over the range of interest.

    The clause leaves the range to the engineer: 0.2 times the shortest to 1.2 times the longest equivalent period [s].
    """
    periods = (0.2 * shortest, 1.2 * longest)
    return (
        _number(suite),
        mean_at_least(suite, CODE, CLAUSE, share=BELOW, periods=periods),
        mean_at_most(suite, CODE, CLAUSE, share=ABOVE, periods=periods),
    )


def artificial(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Number, and the mean no more than 10 % below from 0.15 s to the larger of 2 s and twice the period (ULS)."""
    periods = (ARTIFICIAL_FROM, max(ARTIFICIAL_TO, 2.0 * longest))
    return (_number(suite), mean_at_least(suite, CODE, CLAUSE, share=BELOW, periods=periods))


def _number(suite: Suite) -> Requirement:
    seven = "from seven on the mean of the effects may be taken, else the worst"
    return required(CODE, "7.3.5", "number of time histories", suite.count, ">=", LEAST_RECORDS, remark=seven)
