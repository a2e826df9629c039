"""Non-linear dynamic analysis beside Circolare 617/2009: no record beyond d0*, the mean within d_u* = 0.4 d0*.

What the circular says of it is from memory; the criterion is that of Circolare 7/2019 with the capacity of 2009.
"""

from __future__ import annotations

from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import EDITION
from assess.codes.dmi2008.clauses import RULE as LIMIT
from assess.codes.italian import history
from assess.codes.italian.edition import Options
from assess.codes.italian.limit_state import add_safety_index
from assess.oscillator import Oscillator

RULE = history.Rule(
    procedure="dmi2008-history",
    edition=EDITION,
    clause="C8A.4.2.3 (non-linear dynamic)",
    limits={"SLV": LIMIT},
)
STATES = tuple(RULE.limits)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Return the checks of the suites of time histories against 0.4 d0*."""
    checks = history.assess(oscillator, context, rule=RULE, options=options)
    return tuple(add_safety_index(check, context) for check in checks)
