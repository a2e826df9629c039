"""ASCE 7-16 16.2: ground motions for response-history analysis, scaled by amplitude."""

from __future__ import annotations

from records.compliance.suite import Requirement, RequirementKind, Suite, check_limit, mean_at_least

CODE = "ASCE 7-16"
LEAST_RECORDS = 11
BELOW = 0.90
REMARK = (
    "the clause takes the mean of maximum-direction spectra of pairs beside MCE_R, here single components beside the "
    "target given"
)


def periods_of_interest(*, shortest: float, longest: float) -> tuple[float, float]:
    """Return the range of periods over which the mean is compared with the target [s]."""
    return 0.2 * shortest, 2.0 * longest


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Check the number of motions (16.2.2), and the mean over 0.2 to 2.0 times the period (16.2.3.1-2).

    shortest, longest : equivalent periods in place of those of the first modes [s].
    """
    periods = periods_of_interest(shortest=shortest, longest=longest)
    return (
        check_limit(
            CODE, "16.2.2", RequirementKind.COUNT, "number of ground motions", suite.count, ">=", LEAST_RECORDS
        ),
        mean_at_least(suite, CODE, "16.2.3.2", share=BELOW, periods=periods, remark=REMARK),
    )
