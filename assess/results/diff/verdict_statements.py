"""A verdict as statements, so that two verdicts can be compared one by one."""

from __future__ import annotations

from assess.codes.verdict import MechanismVerdict, Verdict
from assess.codes.verdict_text import outcome_text

Statements = dict[tuple[str, str], float | str | None]
"""Statements by mechanism ("" for the building) and by subject."""


def verdict_statements(found: Verdict | None) -> Statements:
    """Return the statements of a verdict on the building and on each mechanism; empty without a verdict."""
    if found is None:
        return {}
    statements: Statements = {
        ("", "verdict"): outcome_text(found.outcome, near=found.at_the_limit),
        ("", "basis"): found.basis or None,
        ("", "limit states"): ", ".join(found.limit_states) or None,
        ("", "methods"): ", ".join(found.methods) or None,
        ("", "action, PGA"): found.action.pga_g,
        ("", "target"): found.target,
        ("", "index"): None if found.index is None else found.index.value,
        ("", "conditions"): "; ".join(each.text for each in found.conditions) or None,
        ("", "missing"): ", ".join(each.key for each in found.missing) or None,
    }
    for one in found.mechanisms:
        statements |= mechanism_statements(one)
    return statements


def mechanism_statements(one: MechanismVerdict) -> Statements:
    """Return outcome and margin of one mechanism, and procedure, index and outcome of each limit state."""
    statements: Statements = {
        (one.mechanism, "verdict"): outcome_text(one.outcome, near=one.at_the_limit),
        (one.mechanism, "holds up to, over the site's PGA"): one.margin,
    }
    for answer in one.answers:
        state = f", {answer.limit_state}" if answer.limit_state else ""
        statements[one.mechanism, f"decided by{state}"] = answer.procedure or None
        statements[one.mechanism, f"index{state}"] = None if answer.index is None else answer.index.value
        statements[one.mechanism, f"answer{state}"] = outcome_text(answer.outcome, near=answer.at_the_limit)
    return statements
