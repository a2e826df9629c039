"""Cells that several chapters share: outcomes, rotations, numbers that may be words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from assess.codes.check import Check, Reason
from assess.codes.histories import interval_figures, ratio_figures
from assess.codes.verdict import Answer
from assess.messages.message import DIMENSIONS, Quantity
from reports import document
from reports.document import Cell, Column, OutcomeCell
from reports.language.texts import Phrase, Text, Verbatim, quantity, say

OVERTURNED, BEYOND = say("overturns"), say("beyond the spectrum")
NO_ROCKING, NO_LASTING, NONE = say("does not rock"), say("no lasting rotation"), say("none")

OUTCOMES: Mapping[str, Phrase] = {
    "pass": say("pass"),
    "fail": say("fail"),
    "incomplete": say("incomplete"),
    "not-answered": say("not answered"),
    "not-applicable": say("not applicable"),
}
ROLES: Mapping[str, Phrase] = {"deciding": say("decides"), "comparison": say("for comparison")}
READINGS: Mapping[str, Phrase] = {"letter": say("clause"), "thesis": say("thesis reading")}

INPUTS: Mapping[str, Phrase] = {
    "ground": say("ground"),
    "mechanism base": say("base of the mechanism"),
    "missing": say("missing"),
}
BRANCHES: Mapping[str, Phrase] = {"positive": say("positive"), "negative": say("negative")}
_COLOURS: Mapping[str, document.Outcome] = {"pass": "pass", "fail": "fail", "incomplete": "incomplete"}
_NO_LASTING_ROTATION = (Reason.NO_LASTING, Reason.ON_JOINTS)
MECHANISM, LEVEL = Column(say("Mechanism")), Column(say("PGA"), "ground acceleration")
METHOD, LIMIT_STATE, OUTCOME = Column(say("Method")), Column(say("Limit state")), Column(say("Outcome"))
FIGURES = 3


PROCEDURE = Column(say("Procedure"))


RATIO = Column(say("D/C"), "ratio", FIGURES)
CAPACITY_PGA = Column(say("PGA at capacity"), "ground acceleration", FIGURES)


def outcome_cell(check: Check, answers: Sequence[Answer] = ()) -> OutcomeCell:
    """Return the outcome of a check, coloured where it decides. answers : of the mechanism, where they count."""
    outcome = decided_outcome(check, answers)
    colour = _COLOURS.get(outcome, "incomplete") if check.role == "deciding" else "comparison"
    return OutcomeCell(colour, OUTCOMES[outcome])


def decided_outcome(check: Check, answers: Sequence[Answer]) -> str:
    """Return the outcome of the answer that a check decides, as the target may be less than full safety; else its own.

    Parameters
    ----------
    check : of a mechanism
    answers : of the verdict of this mechanism
    """
    own = [each for each in answers if each.procedure == check.procedure]
    outcomes = {each.outcome for each in own if each.limit_state == check.limit_state} or {each.outcome for each in own}
    return outcomes.pop().value if check.role == "deciding" and len(outcomes) == 1 else check.verdict.value


def unbounded_text(check: Check) -> Phrase | None:
    """Return why a check fails without a finite demand; None where it has one."""
    return {"overturned": OVERTURNED, "beyond the spectrum": BEYOND}.get(check.unbounded)


def value_cell(value: float | None, unit: str, *, figures: int = 4) -> Cell:
    """Return a number of the results with its unit; `unit` is a value of `assess.messages.message.UNITS`."""
    return None if value is None else Quantity(value, DIMENSIONS.get(unit, "ratio"), figures)


def rocking_cell(rotation: float | None) -> Cell:
    """Return a rotation; words for a body that does not move."""
    return NO_ROCKING if rotation == 0 else rotation


def rotation_cell(check: Check) -> Cell:
    """Return the rotation of a check; a body that lifts off without a lasting rotation is not at rest."""
    if check.unbounded:
        return unbounded_text(check)
    return NO_LASTING if check.reason.key in _NO_LASTING_ROTATION else rocking_cell(check.rotation_ratio)


def uplift_cell(at: float | None) -> Cell:
    """Return the multiplier or PGA at uplift; "none" where joints have no threshold of uplift."""
    return NONE if at is None else at


def ratio_cell(check: Check) -> Cell:
    """Return demand over capacity, to the figures that stand, or why there is no finite one."""
    return unbounded_text(check) or standing_cell(check.ratio, ratio_figures(check, most=FIGURES), FIGURES)


def standing_cell(value: float | None, figures: int, most: int) -> Cell:
    """Return a number of a column of `most` figures, written with fewer where fewer stand."""
    return value if value is None or figures == most else Quantity(value, "ratio", figures)


def capacity_pga_cell(check: Check) -> Cell:
    """Return the PGA at capacity [g]; where numerical spread leaves a range, from 84 to 16 % of the draws."""
    low = None if check.numerical is None else check.numerical.capacity_low_pga_g
    if check.capacity_pga_g is None or low is None or low <= check.capacity_pga_g:
        return check.capacity_pga_g
    return pga_interval(check.capacity_pga_g, low, limit=check.level_pga_g)


def pga_interval(low: float, high: float, *, limit: float) -> Text:
    """Return two PGA [g] as "0.12 g to 0.14 g", to as many figures as tell them apart, and from the site's own."""
    figures = interval_figures(low, high, limit=limit)
    ends = (Quantity(each, "ground acceleration", figures) for each in (low, high))
    return say("{low} to {high}", **dict(zip(("low", "high"), ends, strict=True)))


def swept_value(value: float, unit: str) -> Text:
    """Return a value of a study in the unit in which the user wrote it."""
    shown = quantity(value, figures=10)
    return shown if unit == "-" else say("{value} {unit}", value=shown, unit=Verbatim(unit))
