"""Every line of every calculation sheet, worked out again: from the numbers printed, or from where it is read.

No line is passed over: one without inputs is in LINES, one with inputs has a formula, and every input is the value of a
line before it or in a closed list of what the oscillator, the site and the options give. Faults planted into each line
show that the property would see them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from assess.codes.calculation_sheet import Step, SymbolValue, substitute
from assess.codes.procedures import PROCEDURES
from tests.support.formula import NoFormulaError, evaluate
from tests.support.printed_sheet import Sheet
from tests.support.readings import LINES
from tests.support.sheet_faults import comes_to, faults, faults_of
from tests.support.subjects import LEVELS, subjects

EVERY = pytest.mark.parametrize("name", PROCEDURES)
OTHER = {"+": "−", "−": "+", "/": "·", "·": "/"}


@EVERY
def test_every_line_of_every_sheet_comes_out_again(name: str) -> None:
    wrong = [fault for subject in subjects(name) for fault in faults_of(subject)]
    assert not wrong, wrong[:5]


def test_the_list_of_lines_that_are_read_is_closed() -> None:
    found = {step.formula for name in PROCEDURES for each in subjects(name) for step in each.check.steps
             if not step.inputs}  # fmt: skip
    assert found == set(LINES)


@EVERY
def test_what_is_answered_stands_on_the_sheet(name: str) -> None:
    """Demand and capacity are values of lines, and their quotient is the ratio."""
    for subject in subjects(name):
        check, values = subject.check, [step.value for step in subject.check.steps if step.value is not None]
        values += [each.value for step in subject.check.steps for each in step.inputs if each.symbol in ("demand", "D")]
        if check.ratio is not None and check.demand is not None and check.capacity:
            assert check.ratio == pytest.approx(check.demand / check.capacity, rel=1e-9)
        over = [1.0, subject.branch.unstable, subject.branch.overturning]  # some lines have the share of these
        for what in (check.demand, check.capacity):
            shares = [] if what is None else [what / each for each in over]
            limits = [0.4, 0.5] if name in ("dmi2008-nonlinear-thesis", "asce43-05-history") else []
            assert what is None or any(share == pytest.approx(v) for share in shares for v in (*values, *limits))


# ------------------------------------------------------------------------------------------------------ planted faults


def lines(name: str) -> Iterator[tuple[Step, Sheet]]:
    """The lines of one sheet of each mechanism, on the ground and above, as they are read in order."""
    for subject in subjects(name):
        if abs(subject.check.level_pga_g * 9.80665 - LEVELS[1]) < 1e-9:
            sheet = Sheet(subject)
            for step in subject.check.steps:
                sheet.step = step
                yield step, sheet
                sheet.known[step.symbol] = step.value


def seen(step: Step, sheet: Sheet) -> bool:
    """Whether a fault shows in a line, which may break what reads it, too."""
    sheet.step = step
    return any(True for _ in faults(step, sheet))


def rewritten(step: Step, inputs: tuple[SymbolValue, ...], formula: str = "") -> Step:
    """The line with other inputs, or another formula, as it would be printed; its value follows from them."""
    formula = formula or step.formula
    changed = replace(step, formula=formula, inputs=inputs, substituted=substitute(formula, inputs))
    return replace(changed, value=evaluate(formula, {each.symbol: each.value for each in inputs}))


@EVERY
def test_a_value_that_is_off_is_seen(name: str) -> None:
    """By 2 %, by its sign, or by a thousand, as m printed for mm."""
    for step, sheet in lines(name):
        for value in (1.02, -1.0, 1000.0) if step.value else ():
            assert seen(replace(step, value=step.value * value), sheet), (step, value)


@EVERY
def test_a_value_that_is_missing_or_made_up_is_seen(name: str) -> None:
    for step, sheet in lines(name):
        assert seen(replace(step, value=0.37 if step.value is None else None), sheet), step


@EVERY
def test_a_stale_input_is_seen_though_the_line_agrees_with_it(name: str) -> None:
    for step, sheet in lines(name):
        for place, each in enumerate(step.inputs):
            stale = (*step.inputs[:place], replace(each, value=each.value * 1.01 + 1e-3), *step.inputs[place + 1 :])
            try:
                assert seen(rewritten(step, stale), sheet), (step, each.symbol)
            except (ValueError, TypeError):  # a root of what has become negative
                continue


@EVERY
def test_swapped_inputs_are_seen(name: str) -> None:
    for step, sheet in lines(name):
        values = [each.value for each in step.inputs]
        if len(values) < 2 or values[0] == pytest.approx(values[1], rel=1e-3):
            continue
        first, second, *rest = step.inputs
        swapped = (replace(first, value=second.value), replace(second, value=first.value), *rest)
        assert seen(replace(step, inputs=swapped, substituted=substitute(step.formula, swapped)), sheet), step


@EVERY
def test_a_formula_that_is_not_the_one_worked_is_seen(name: str) -> None:
    """One sign of operation turned into its opposite, in the text alone; the value stays."""
    tried = 0
    for step, sheet in lines(name):
        for at, sign in enumerate(step.formula if step.inputs else ""):
            if sign not in OTHER or step.formula[at - 1 : at] != " ":
                continue
            formula = step.formula[:at] + OTHER[sign] + step.formula[at + 1 :]
            try:
                value = rewritten(step, step.inputs, formula).value
            except (NoFormulaError, ValueError, TypeError, ZeroDivisionError):
                continue
            if value != pytest.approx(step.value, rel=5e-3):
                tried += 1
                assert seen(replace(step, formula=formula), sheet), (step, formula)
    assert tried or name in ("asce41-13-ht",)


@EVERY
def test_numbers_printed_that_are_not_those_worked_are_seen(name: str) -> None:
    for step, sheet in lines(name):
        if step.inputs and step.value and abs(step.value) > 1e-4:
            other = tuple(replace(each, value=each.value * 1.7 + 0.1) for each in step.inputs)
            changed = replace(step, substituted=substitute(step.formula, other))
            try:
                same = comes_to(evaluate(changed.substituted, {}), step.value)
            except (NoFormulaError, ValueError, TypeError, ZeroDivisionError):
                continue
            assert same or seen(changed, sheet), changed


@EVERY
def test_a_unit_of_another_dimension_is_seen(name: str) -> None:
    for step, sheet in lines(name):
        assert seen(replace(step, unit="s" if step.unit != "s" else "m", dimension=step.dimension), sheet), step
