"""Non-linear dynamic check of Circolare 7/2019, C8.7.1.2.1.9: no record beyond d0*, the mean within d_SLV or d_SLC."""

from __future__ import annotations

from assess.codes.check import Check
from assess.codes.context import Context
from assess.codes.italian import history
from assess.codes.italian.edition import Options
from assess.codes.italian.limit_state import add_safety_index
from assess.codes.ntc2018.clauses import EDITION, ULTIMATE
from assess.oscillator import Oscillator

RULE = history.Rule(
    procedure="ntc2018-history",
    edition=EDITION,
    clause="C8.7.1.2.1.9",
    limits={state: ultimate.rule for state, ultimate in ULTIMATE.items()},
)
STATES = tuple(RULE.limits)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Return the checks of the suites of time histories against d0* and d_SLV or d_SLC."""
    checks = history.assess(oscillator, context, rule=RULE, options=options)
    return tuple(add_safety_index(check, context) for check in checks)
