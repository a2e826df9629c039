"""What is wrong with a calculation sheet: each line worked out again, from the numbers printed or from their source."""

from __future__ import annotations

from collections.abc import Iterator
from math import floor, isclose, log10

from assess.codes.calculation_sheet import RESULT_FIGURES, Step, substitute
from assess.messages.message import DIMENSIONS
from tests.support.formula import NoFormulaError, evaluate
from tests.support.givens import given_value
from tests.support.printed_sheet import Sheet
from tests.support.readings import LINES
from tests.support.subjects import Subject

CLOSE, ALIKE = 1e-3, 1e-6  # relative: of what a curve comes to, and of an input to what it repeats
EXACT = 6e-6  # relative: of a formula with its numbers, by Simpson's rule or between two points of a table at most
BEYOND_HALF = 0.05  # of the last printed digit: what the rounding of inputs may add to half a unit of it


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
    for each in (*step.inputs, *step.at):
        known = each.symbol in sheet.known
        stands = (sheet.known[each.symbol] or 0.0) if known else given_value(sheet, each.symbol, each.dimension)
        if stands is None or not isclose(each.value, stands, rel_tol=ALIKE, abs_tol=1e-7):
            yield f"its input {each.symbol} is {each.value}, and should be {stands}"
    yield from of_formula(step) if step.inputs else of_reading(step, sheet)


def of_formula(step: Step) -> Iterator[str]:
    """Whether formula and printed numbers come to the value."""
    try:
        exact = evaluate(step.formula, {each.symbol: each.value for each in step.inputs})
        printed = evaluate(substitute(step.formula, step.inputs), {})
    except (NoFormulaError, ValueError, TypeError, ZeroDivisionError) as error:
        yield f"no formula, or no number: {error}"
        return
    if step.value is None or not isclose(exact, step.value, rel_tol=EXACT, abs_tol=1e-12):
        yield f"{step.formula} is {exact}, not {step.value}"
    elif not step.substituted.startswith(substitute(step.formula, step.inputs)):
        yield f"{step.substituted} is not {step.formula} with its numbers"
    elif not comes_to(printed, step.value):
        yield f"{step.substituted} is {printed}, not {step.value}"


def comes_to(printed: float, value: float) -> bool:
    """Whether what printed numbers come to is a value as printed, within half a unit of its last digit."""
    if abs(value) < 1e-12:
        return abs(printed) < 1e-9
    unit = 10.0 ** (floor(log10(abs(value))) - RESULT_FIGURES + 1)
    return abs(printed - float(f"{value:.{RESULT_FIGURES}g}")) <= (0.5 + BEYOND_HALF) * unit


def of_reading(step: Step, sheet: Sheet) -> Iterator[str]:
    """Whether a line without inputs holds what its source says."""
    if step.formula not in LINES:
        yield f'"{step.formula}" is no formula, and nobody says where it is read'
        return
    expected = LINES[step.formula](sheet)
    known = expected is not None and step.value is not None
    if not (isclose(step.value, expected, rel_tol=2 * CLOSE, abs_tol=1e-9) if known else expected is step.value):
        yield f"it is {step.value}, and should be {expected}"
