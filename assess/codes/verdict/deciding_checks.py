"""The checks of a mechanism that decide, marked as such."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from assess.codes.basis import Basis
from assess.codes.check import Check, Outcome
from assess.codes.verdict.answer import Answer, at_action
from assess.codes.verdict.decision import MechanismVerdict
from assess.codes.verdict.question import Action


def mark_deciding(
    checks: Sequence[Check], found: MechanismVerdict, basis: Basis | None, action: Action
) -> tuple[Check, ...]:
    """Return the checks with the role of those that decide; all others are for comparison.

    Parameters
    ----------
    checks : of one mechanism
    found : its verdict
    basis : the rules of the code; None where none is named
    action : of the site

    Returns
    -------
    tuple of Check
    """
    return tuple(
        replace(check, role="deciding")
        if any(_is_behind(check, each, basis, action) for each in found.answers)
        else check
        for check in checks
    )


def find_deciding_check(checks: Sequence[Check], answer: Answer, basis: Basis | None, action: Action) -> Check | None:
    """Return the check behind an answer; None where nothing decided.

    Parameters
    ----------
    checks : of one mechanism
    answer : of one limit state
    basis : the rules of the code; None where none is named
    action : of the site

    Returns
    -------
    Check or None
    """
    return next((check for check in checks if _is_behind(check, answer, basis, action)), None)


def _is_behind(check: Check, answer: Answer, basis: Basis | None, action: Action) -> bool:
    if basis is None or check.procedure != answer.procedure or check.informs or check.reading != "letter":
        return False
    states = {state.checked_as for state in basis.states if state.name == answer.limit_state}
    decides = check.verdict in (Outcome.PASS, Outcome.FAIL)
    return decides and bool(states & {check.limit_state, "*"}) and at_action(check, action)
