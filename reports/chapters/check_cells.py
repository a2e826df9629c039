"""The parts of a row on a check that a page of a mechanism and the comparison have: ratio, clause, role."""

from __future__ import annotations

from math import isclose

from assess.codes.check import Check
from reports.chapters.cells import NO_LASTING, NO_ROCKING, rotation_cell, unbounded_text
from reports.document import Cell, Column
from reports.language.texts import say

FIGURES = 3
DEMAND, ALLOWABLE = Column(say("Demand")), Column(say("Allowable"))
RATIO = Column(say("D/C"), "ratio", FIGURES)
CAPACITY_PGA = Column(say("PGA at capacity"), "ground acceleration", FIGURES)


def demand_or_rest(check: Check, demand: Cell) -> Cell:
    """Return the demand of a check, or words where the body does not rock or comes to rest again."""
    words = rotation_cell(check)
    return words if check.rotation_ratio is not None and words in (NO_LASTING, NO_ROCKING) else demand


def ratio_cell(check: Check) -> Cell:
    """Return demand over capacity, or why there is no finite one."""
    return unbounded_text(check) or check.ratio


def clause(check: Check) -> str:
    """Return the clause by which a check compares demand and capacity; empty without steps."""
    wanted = [value for value in (check.ratio, check.demand, check.capacity) if value is not None]
    steps = check.steps[::-1]
    found = (step for value in wanted for step in steps if step.value is not None and isclose(step.value, value))
    return next((step.clause for step in found), steps[0].clause if steps else "")
