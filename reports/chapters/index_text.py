"""Outcome, index, margin and target of a verdict as texts."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.bases import BASES
from assess.codes.verdict import Action, Decision, Index, MechanismVerdict, Verdict
from reports.language.texts import Phrase, Text, Verbatim, quantity, say

SYMBOLS: Mapping[str, str] = {"zeta_E": "ζ_E"}
OWN = "own"  # basis that the engineer states, and its limit state
SHARE = "%NBS"
RATIO = "D/C"
OUTCOMES: Mapping[Decision, tuple[Phrase, Phrase]] = {
    Decision.PASS: (say("pass"), say("pass at the limit")),
    Decision.FAIL: (say("fail"), say("fail at the limit")),
    Decision.INCOMPLETE: (say("incomplete"), say("incomplete")),
}
"""Each outcome in words, and where it is at the limit."""


def outcome_text(outcome: Decision, *, near: bool = False) -> Text:
    """Return an outcome in words. near: whether it is at the limit."""
    return OUTCOMES[outcome][near]


def index_text(index: Index) -> Text:
    """Return an index with its name and its grade: "ζ_E = 0.83", "45 %NBS, grade C"."""
    value = quantity(index.value, figures=index.figures)
    if index.name != SHARE:
        return say("{index} = {value}", index=symbol(index.name), value=value)
    if not index.grade:
        return say("{value} %NBS", value=value)
    return say("{value} %NBS, grade {grade}", value=value, grade=Verbatim(index.grade))


def state_text(limit_state: str) -> Text:
    """Return a limit state; a basis that the engineer states has one without a name."""
    return say("the stated limit state") if limit_state == OWN else Verbatim(limit_state)


def symbol(name: str) -> Verbatim:
    """Return the symbol of an index."""
    return Verbatim(SYMBOLS.get(name, name))


def building_index_text(found: Verdict) -> Text | None:
    """Return the index of the building, which local mechanisms can only bound; None where it is not known."""
    if found.index is None:
        return None
    if found.index.name == RATIO:
        return say("at least {index}", index=index_text(found.index))
    return say("at most {index}", index=index_text(found.index))


def target_text(found: Verdict) -> Text | None:
    """Return what the index is compared with; None where that is not known."""
    if found.target is None:
        return None
    value, name = quantity(found.target, figures=3), index_name(found)
    if name == SHARE:
        return say("at least {value} %NBS", value=value)
    if name == RATIO:
        return say("{index} of at most {value}", index=symbol(name), value=value)
    return say("{index} of at least {value}", index=symbol(name), value=value) if name else value


def is_lowered(found: Verdict) -> bool:
    """Return whether the target is less than what is asked of a new building."""
    return found.target is not None and found.target < (100.0 if index_name(found) == SHARE else 1.0)


def index_name(found: Verdict) -> str:
    """Return the name of the index of a verdict, known from its code where no mechanism has a value; else empty."""
    if found.index is not None:
        return found.index.name
    return BASES[found.basis].index.value if found.basis in BASES else ""


def least_margin(found: Verdict) -> MechanismVerdict | None:
    """Return the mechanism that holds up to the lowest action; None where no margin is known."""
    known = [one for one in found.mechanisms if one.margin is not None]
    return min(known, key=lambda one: one.margin or 0.0, default=None)


def margin_text(one: MechanismVerdict, action: Action) -> Text | None:
    """Return up to which PGA a mechanism passes: "0.18 g, 2.7 × the site’s"; None where it is not known."""
    if one.margin is None:
        return None
    pga = quantity(one.margin * action.pga_g, "ground acceleration", 3)
    return say("{pga}, {margin} × the site’s", pga=pga, margin=quantity(one.margin, figures=3))
