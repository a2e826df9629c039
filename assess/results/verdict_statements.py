"""A verdict statement by statement, so that two of them can be set beside each other."""

from __future__ import annotations

from assess.codes.verdict import MechanismVerdict, Verdict
from assess.codes.verdict_text import outcome_text

Stated = dict[tuple[str, str], float | str | None]
"""What is said, by the mechanism it is said of, "" for the building, and by what it is."""


def stated_verdict(found: Verdict | None) -> Stated:
    """What a verdict says of the building and of each mechanism; nothing where there is none."""
    if found is None:
        return {}
    said: Stated = {
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
        said |= stated_of_mechanism(one)
    return said


def stated_of_mechanism(one: MechanismVerdict) -> Stated:
    """The verdict of one mechanism: outcome, margin, and of each limit state procedure, index and outcome."""
    said: Stated = {
        (one.mechanism, "verdict"): outcome_text(one.outcome, near=one.at_the_limit),
        (one.mechanism, "holds up to, over the site's PGA"): one.margin,
    }
    for answer in one.answers:
        state = f", {answer.limit_state}" if answer.limit_state else ""
        said[one.mechanism, f"decided by{state}"] = answer.procedure or None
        said[one.mechanism, f"index{state}"] = None if answer.index is None else answer.index.value
        said[one.mechanism, f"answer{state}"] = outcome_text(answer.outcome, near=answer.at_the_limit)
    return said
