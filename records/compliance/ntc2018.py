"""NTC 2018 3.2.3.6 and 7.3.5: time histories of the ground's motion, natural and artificial."""

from __future__ import annotations

from records.compliance.suite import (
    Requirement,
    RequirementKind,
    Suite,
    check_limit,
    mean_at_least,
    mean_at_most,
    usable_to,
)

CODE = "NTC 2018"
CLAUSE = "3.2.3.6"
LEAST_RECORDS, LEAST_ARTIFICIAL = 3, 7
BELOW, ABOVE = 0.90, 1.30
FITTED_FROM, FITTED_TO = 0.15, 2.0  # s, of artificial records
SHORTEST, STATIONARY = 25.0, 10.0  # s, of artificial records
OF_INTEREST = (0.2, 1.2)  # of the shortest and the longest period
SEVEN = "from seven on the mean of the effects may be taken, else the worst"
ARTIFICIAL = "seven with artificial records among them is this program's own rule; the clause asks for three"


def periods_of_interest(*, shortest: float, longest: float) -> tuple[float, float]:
    """Return the range of periods over which the mean of recorded motions is compared with the target [s]."""
    return OF_INTEREST[0] * shortest, OF_INTEREST[1] * longest


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Check the number and the mean of the records; of artificial ones also their duration.

    A suite of recorded and artificial motions has to meet the requirements on both.

    Parameters
    ----------
    suite : scaled records beside their target
    shortest, longest : periods of the mechanisms at the limit state [s]
    """
    made = suite.artificial
    artificial = _artificial(suite, longest=longest) if made.any() else ()
    natural = () if made.all() else _natural(suite, shortest=shortest, longest=longest)
    return (_number(suite), *artificial, *natural)


def fit_periods(*, longest: float) -> tuple[float, float]:
    """Return the range of periods over which artificial records have to fit the target at ultimate limit states [s]."""
    return FITTED_FROM, max(FITTED_TO, 2.0 * longest)


def _natural(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Require the mean from 10 % below to 30 % above over the range of interest, which the clause leaves open."""
    periods = periods_of_interest(shortest=shortest, longest=longest)
    return (
        mean_at_least(suite, CODE, CLAUSE, share=BELOW, periods=periods),
        mean_at_most(suite, CODE, CLAUSE, share=ABOVE, periods=periods),
        *usable_to(suite, CODE, CLAUSE, longest=longest),
    )


def _artificial(suite: Suite, *, longest: float) -> tuple[Requirement, ...]:
    """Require 25 s, 10 s of them stationary, and a mean at most 10 % below up to 2 s or twice the longest period."""
    made, level = suite.artificial, "shortest stationary part"
    return (
        check_limit(
            CODE,
            CLAUSE,
            RequirementKind.DURATION,
            "shortest duration",
            suite.duration[made].min(),
            ">=",
            SHORTEST,
            unit="s",
        ),
        check_limit(
            CODE, CLAUSE, RequirementKind.STATIONARY, level, suite.stationary[made].min(), ">=", STATIONARY, unit="s"
        ),
        mean_at_least(suite, CODE, CLAUSE, share=BELOW, periods=fit_periods(longest=longest)),
    )


def _number(suite: Suite) -> Requirement:
    least, remark = (LEAST_ARTIFICIAL, ARTIFICIAL) if suite.artificial.any() else (LEAST_RECORDS, SEVEN)
    return check_limit(
        CODE, "7.3.5", RequirementKind.COUNT, "number of time histories", suite.count, ">=", least, remark=remark
    )
