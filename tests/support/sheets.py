"""What is wrong with a calculation sheet: each line worked out again, from the numbers printed or from their source."""

from __future__ import annotations

from collections.abc import Iterator
from math import isclose

from assess.codes.check import Step
from assess.messages.message import DIMENSIONS
from tests.support.formula import NoFormulaError, evaluate
from tests.support.givens import given_value
from tests.support.readings import LINES
from tests.support.sheet import Sheet
from tests.support.subjects import Subject

CLOSE, ALIKE = 1e-3, 1e-6  # relative: of what a curve or a formula comes to, and of an input to what it repeats


def faults_of(subject: Subject) -> list[str]:
    """Sentences on the lines of an answer."""
    sheet, found = Sheet(subject), list[str]()
    for step in subject.check.steps:
        sheet.step = step
        found += (f"{subject.check.procedure}, {step.symbol}: {fault}" for fault in faults(step, sheet))
        sheet.known[step.symbol] = step.value
    return found


def faults(step: Step, sheet: Sheet) -> Iterator[str]:
    """Sentences on one line."""
    if step.dimension != DIMENSIONS.get(step.unit, step.unit):
        yield f"{step.unit} is no {step.dimension}"
    if not step.inputs:
        yield from of_reading(step, sheet)
        return
    for each in step.inputs:
        known = each.symbol in sheet.known
        stands = (sheet.known[each.symbol] or 0.0) if known else given_value(sheet, each.symbol, each.dimension)
        if stands is None or not isclose(each.value, stands, rel_tol=ALIKE, abs_tol=1e-7):
            yield f"its input {each.symbol} is {each.value}, and should be {stands}"
    yield from of_formula(step)


def of_formula(step: Step) -> Iterator[str]:
    """Whether formula and printed numbers come to the value."""
    try:
        exact = evaluate(step.formula, {each.symbol: each.value for each in step.inputs})
        printed = evaluate(step.substituted, {})
    except (NoFormulaError, ValueError, TypeError, ZeroDivisionError) as error:
        yield f"no formula, or no number: {error}"
        return
    if step.value is None or not isclose(exact, step.value, rel_tol=CLOSE, abs_tol=1e-12):
        yield f"{step.formula} is {exact}, not {step.value}"
    if step.value is not None and not isclose(printed, step.value, rel_tol=2e-2, abs_tol=1e-6):
        yield f"{step.substituted} is {printed}, not {step.value}"


def of_reading(step: Step, sheet: Sheet) -> Iterator[str]:
    """Whether a line without inputs holds what its source says."""
    if step.formula not in LINES:
        yield f'"{step.formula}" is no formula, and nobody says where it is read'
        return
    expected = LINES[step.formula](sheet)
    known = expected is not None and step.value is not None
    if not (isclose(step.value, expected, rel_tol=2 * CLOSE, abs_tol=1e-9) if known else expected is step.value):
        yield f"it is {step.value}, and should be {expected}"
