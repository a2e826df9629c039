"""ASCE/SEI 43-05: five records or more, and 2.4 on time histories that fit the design spectrum.

2.4 is written for synthetic and modified motions: recorded ones that are only scaled rarely meet it.
"""

from __future__ import annotations

from records.compliance.requirement import Requirement, mean_at_least, mean_at_most, mean_ratio, not_answered, required
from records.compliance.suite import Suite

CODE = "ASCE 43-05"
LEAST_RECORDS = 5
BELOW, ABOVE = 0.90, 1.30
PERIODS = (0.04, 5.0)  # s, 25 Hz to 0.2 Hz
ADJACENT = 9  # points below the target side by side, of a hundred to the decade
LONGEST_STEP, SHORTEST = 0.010, 20.0  # s
REMARK = "written for synthetic or modified motions; recorded ones that are only scaled rarely meet it"


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Number, step, duration; the mean spectrum within 10 % below and 30 % above, no ten points running below.

    The range does not follow the periods of the structure: shortest, longest [s] are not used.
    """
    clause = "2.4"
    return (
        required(CODE, "response-history method", "number of records", suite.count, ">=", LEAST_RECORDS),
        required(CODE, clause, "largest time step", suite.dt.max(), "<=", LONGEST_STEP, unit="s"),
        required(CODE, clause, "shortest duration", suite.duration.min(), ">=", SHORTEST, unit="s"),
        mean_at_least(suite, CODE, clause, share=BELOW, periods=PERIODS, remark=REMARK),
        mean_at_most(suite, CODE, clause, share=ABOVE, periods=PERIODS, remark=REMARK),
        _running_below(suite),
    )


def _running_below(suite: Suite) -> Requirement:
    what, ratio = "points side by side below the target", mean_ratio(suite, PERIODS)
    if ratio is None:
        return not_answered(CODE, "2.4", what, "<=", ADJACENT, PERIODS, suite=suite)
    longest, run = 0, 0
    for below in (ratio < 1.0).tolist():
        run = run + 1 if below else 0
        longest = max(longest, run)
    return required(CODE, "2.4", what, longest, "<=", ADJACENT, periods=PERIODS, remark=REMARK)
