"""EN 1998-1:2004 3.2.3.1.2(4): artificial, and by 3.2.3.1.3 also recorded, accelerograms."""

from __future__ import annotations

import numpy as np

from records.compliance.suite import Requirement, RequirementKind, Suite, check_limit, mean_at_least, with_least_factor

CODE = "EN 1998-1:2004"
LEAST_RECORDS = 3
BELOW = 0.90


def periods_of_interest(*, shortest: float, longest: float) -> tuple[float, float]:
    """Return the range of periods over which the mean is compared with the target [s]."""
    return 0.2 * shortest, 2.0 * longest


def requirements(suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
    """Check the number (a), mean peak at least a_g S (b), mean spectrum over 0.2 T_1 to 2 T_1 (c)."""
    clause, periods = "3.2.3.1.2(4)", periods_of_interest(shortest=shortest, longest=longest)
    seven = "from seven on the mean of the responses may be taken, else the largest (4.3.3.4.3(3))"
    peaks = float(np.mean(suite.pga)) / suite.target_pga
    return (
        check_limit(
            CODE,
            f"{clause}a",
            RequirementKind.COUNT,
            "number of accelerograms",
            suite.count,
            ">=",
            LEAST_RECORDS,
            remark=seven,
        ),
        with_least_factor(
            check_limit(
                CODE, f"{clause}b", RequirementKind.PEAK, "mean zero-period ordinate over a_g S", peaks, ">=", 1.0
            ),
            1.0 / peaks,
        ),
        mean_at_least(suite, CODE, f"{clause}c", share=BELOW, periods=periods),
    )
