"""The checks of one mechanism: the answers of every procedure of a study."""

from __future__ import annotations

from assess.codes.applicability import apply_procedure
from assess.codes.check import Check, Outcome
from assess.codes.context import Context
from assess.codes.registry import procedure
from assess.oscillator import Oscillator
from assess.study.study import Study


def checks_of(study: Study, oscillator: Oscillator, context: Context) -> tuple[Check, ...]:
    """Return the checks of every procedure of the study, in its order.

    Checks of procedures that were only offered, not requested, are left out where they do not apply.
    """
    found: list[Check] = []
    for name in study.procedures:
        checks = apply_procedure(name, procedure(name, study.options), oscillator, context)
        found += (c for c in checks if name not in study.offered or c.verdict != Outcome.NOT_APPLICABLE)
    return tuple(found)
