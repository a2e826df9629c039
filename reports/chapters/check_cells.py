"""The parts of a row on a check that a page of a mechanism and the comparison have: ratio, clause, role."""

from __future__ import annotations

from math import isclose

from assess.codes.check import Check
from reports.chapters.cells import NO_LASTING, NO_ROCKING, is_silent, rotation_cell, unbounded_text
from reports.document import Cell, Column
from reports.language.texts import Text, say

FIGURES = 3
DEMAND, ALLOWABLE = Column(say("Demand")), Column(say("Allowable"))
RATIO = Column(say("Demand over capacity"), "ratio", FIGURES)
CAPACITY_PGA = Column(say("PGA at capacity"), "ground acceleration", FIGURES)


def demand_or_rest(check: Check, demand: Cell) -> Cell:
    """Return the demand of a check, or words where the body does not rock or comes to rest again."""
    words = rotation_cell(check)
    at_rest = check.rotation_ratio is not None and words in (NO_LASTING, NO_ROCKING)
    return words if at_rest and not is_silent(check) else demand


def ratio_cell(check: Check) -> Cell:
    """Return demand over capacity, or why there is no finite one."""
    return unbounded_text(check) or check.ratio


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
