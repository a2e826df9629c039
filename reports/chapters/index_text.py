"""Outcome, index, margin and target of a verdict as texts."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.bases import BASES
from assess.codes.standing_figures import margin_figures
from assess.codes.verdict import Action, Decision, Index, MechanismVerdict, Verdict
from reports.chapters.cells import interval
from reports.document import Cell
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
    margin = quantity(one.margin, figures=margin_figures(one.margin, one.margin_most))
    return say("{pga}, {margin} × the site’s", pga=held_text(one, one.margin, action), margin=margin)


def held_text(one: MechanismVerdict, margin: float, action: Action) -> Text:
    """Return the PGA up to which a mechanism holds; both ends of what the numerical spread of histories leaves.

    Parameters
    ----------
    one : verdict of the mechanism
    margin : its own, which is known
    action : of the site
    """
    if one.margin_most is not None:
        return interval(margin * action.pga_g, one.margin_most * action.pga_g, limit=action.pga_g)
    return quantity(margin * action.pga_g, "ground acceleration", margin_figures(margin, None))


def margin_cell(one: MechanismVerdict) -> Cell:
    """Return the factor on the site's own action up to which a mechanism holds, to the figures that stand."""
    return None if one.margin is None else quantity(one.margin, figures=margin_figures(one.margin, one.margin_most))
