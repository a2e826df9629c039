"""The cells of a table in which a check is a row: demand, allowable, ratio, outcome."""

from __future__ import annotations

from collections.abc import Mapping
from math import isclose

from assess.codes.check import Check, Outcome, Reason
from assess.codes.verdict import Decision
from assess.messages.message import DIMENSIONS, Quantity
from reports.document import Cell, Column, Graded
from reports.document import Outcome as Colour
from reports.language.texts import Phrase, Text, quantity, say

FIGURES = 3
NO_LASTING = (Reason.NO_LASTING, Reason.ON_JOINTS)
OVERTURNED, NO_ROCKING, NONE_LASTING = say("overturned"), say("no rocking"), say("none lasting")
UNBOUNDED: Mapping[str, Phrase] = {"overturned": OVERTURNED, "beyond the spectrum": say("beyond the spectrum")}
VERDICTS: Mapping[Outcome, Phrase] = {
    Outcome.PASS: say("pass"),
    Outcome.FAIL: say("fail"),
    Outcome.NOT_ANSWERED: say("not answered"),
    Outcome.NOT_APPLICABLE: say("not applicable"),
}
DECISIONS: Mapping[Decision, Phrase] = {
    Decision.PASS: say("pass"),
    Decision.FAIL: say("fail"),
    Decision.INCOMPLETE: say("incomplete"),
}
_COLOURS: Mapping[Outcome, Colour] = {Outcome.PASS: "pass", Outcome.FAIL: "fail"}

MECHANISM, METHOD, RATIO = Column(say("Mechanism")), Column(say("Method")), Column(say("D/C"), "ratio", FIGURES)
DEMAND, ALLOWABLE, OUTCOME = Column(say("Demand")), Column(say("Allowable")), Column(say("Outcome"))
CAPACITY_PGA = Column(say("PGA at capacity"), "ground acceleration", FIGURES)


def demand_cell(check: Check) -> Cell:
    """Return the demand with its unit, or why there is no finite one."""
    if check.unbounded:
        return UNBOUNDED[check.unbounded]
    if check.reason.key in NO_LASTING:
        return NONE_LASTING
    if check.demand == 0.0 and check.rotation_ratio == 0.0:
        return NO_ROCKING
    return measured(check.demand, check.unit)


def allowable_cell(check: Check) -> Cell:
    """Return the allowable value with its unit."""
    return measured(check.capacity, check.unit)


def ratio_cell(check: Check) -> Cell:
    """Return demand over capacity, or why there is no finite one."""
    return UNBOUNDED[check.unbounded] if check.unbounded else check.ratio


def outcome_cell(check: Check) -> Graded:
    """Return the outcome of a check, in the colour of an answer where it decides."""
    decides = check.role == "deciding"
    return Graded(_COLOURS.get(check.verdict, "incomplete") if decides else "comparison", VERDICTS[check.verdict])


def decision_cell(outcome: Decision, *, near: bool = False) -> Graded:
    """Return the outcome of a mechanism or of the building. near: whether it is at the limit."""
    word = DECISIONS[outcome]
    return Graded(outcome.value, say("{outcome}, at the limit", outcome=word) if near else word)


def measured(value: float | None, unit: str) -> Quantity | None:
    """Return a number of a check or a step with its dimension. unit: as results write it."""
    return None if value is None else quantity(value, DIMENSIONS.get(unit, "ratio"), FIGURES)


def clause(check: Check) -> str:
    """Return the clause by which a check compares demand and capacity; empty without steps."""
    wanted = [value for value in (check.ratio, check.demand, check.capacity) if value is not None]
    steps = check.steps[::-1]
    found = (step for value in wanted for step in steps if step.value is not None and isclose(step.value, value))
    return next((step.clause for step in found), steps[0].clause if steps else "")


def role_text(check: Check) -> Text:
    """Return what a check is for: whether it decides, compares, or is a reading of the thesis."""
    if check.reading == "thesis":
        return say("thesis reading")
    return say("decides") if check.role == "deciding" else say("compares")
