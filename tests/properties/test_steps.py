"""Every line of every calculation sheet comes to its value by its own formula, from the inputs printed with it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from assess.codes.calculation_sheet import SymbolValue, substitute
from assess.codes.procedures import PROCEDURES
from assess.examples import copy_example
from assess.project.build import build
from assess.project.project_file import load
from assess.study.run import run_study
from tests.support.formula import NoFormulaError, evaluate
from tests.support.sheet_faults import comes_to
from tests.support.subjects import subjects

CLOSE = 6e-6  # relative: by Simpson's rule or between two points of a table at most


@pytest.mark.parametrize("name", PROCEDURES)
def test_every_line_comes_to_its_value_by_its_formula(name: str) -> None:
    worked = [
        step for subject in subjects(name) for step in subject.check.steps if step.inputs and step.value is not None
    ]
    assert worked
    for step in worked:
        assert evaluate(step.formula, {each.symbol: each.value for each in step.inputs}) == pytest.approx(
            step.value, rel=CLOSE, abs=1e-12
        ), (step.symbol, step.formula)


@pytest.mark.parametrize("name", PROCEDURES)
def test_the_numbers_printed_come_to_the_value_too(name: str) -> None:
    """Seven figures of each number stand in the line, and come to the four of the value, within half of the last."""
    for step in (step for subject in subjects(name) for step in subject.check.steps):
        if step.inputs and step.value is not None:
            found = evaluate(substitute(step.formula, step.inputs), {})
            assert comes_to(found, step.value), (step.symbol, step.substituted)


@pytest.mark.parametrize("name", PROCEDURES)
def test_fewer_figures_would_not_do_everywhere(name: str) -> None:
    """The measure can fail: with three figures of each number some line of every long sheet comes to another value."""
    worked = [step for subject in subjects(name) for step in subject.check.steps if len(step.inputs) > 1 and step.value]
    coarse = [evaluate(substitute(step.formula, step.inputs, write=lambda x: f"{x:.3g}"), {}) for step in worked]
    assert not all(comes_to(found, step.value) for found, step in zip(coarse, worked, strict=True))


def test_a_negative_number_stands_in_brackets() -> None:
    inputs = (SymbolValue("H", -5.0, "force"), SymbolValue("n", -0.25, "ratio"))
    assert substitute("H n + H²", inputs) == "-5 · (-0.25) + (-5)²"
    assert evaluate(substitute("H n + H²", inputs), {}) == pytest.approx(26.25)


def test_numbers_are_written_as_asked() -> None:
    inputs = (SymbolValue("a", 0.5, "ratio"), SymbolValue("b", 2.0, "ratio"))
    assert substitute("a / g", inputs, write=lambda x: f"{x:.2f}".replace(".", ",")) == "0,50 / 9,81, b = 2,00"


@pytest.mark.parametrize(
    ("formula", "value"),
    [
        ("a / b c", 2.0 / 3.0 * 5.0),
        ("2π √(a / b)", 2 * np.pi * np.sqrt(2.0 / 3.0)),
        ("√(4π² + a²) / 2π", np.sqrt(4 * np.pi**2 + 4.0) / (2 * np.pi)),
        ("max(0, a (1 − 0.4 b / g))", 2.0 * (1 - 1.2 / 9.80665)),
        ("−2 ln(min(a, 1))", 0.0),
        ("|−a| + b^2", 11.0),
        ("a k α / sin(2α)", 2.0 * 1.4 * 0.2 / np.sin(0.4)),
        ("−a · (b − c)", 4.0),
        ("a/b c", 7.0 * 5.0),
    ],
)
def test_the_notation(formula: str, value: float) -> None:
    symbols = {"a": 2.0, "b": 3.0, "c": 5.0, "k": 1.4, "α": 0.2}
    if formula.startswith("a/b"):
        symbols["a/b"] = 7.0  # a symbol with a stroke of its own
    assert evaluate(formula, symbols) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize("words", ["restoring moment = 0", "a b c d", "largest of all", "a +", "(a"])
def test_words_are_no_formula(words: str) -> None:
    with pytest.raises(NoFormulaError):
        evaluate(words, {"a": 1.0})


@pytest.mark.parametrize("name", ["single_wall", "casa_grande_table"])
def test_the_sheets_of_an_example_can_be_redone(name: str, tmp_path: Path) -> None:
    results = run_study(build(load(copy_example(name, tmp_path / name))), jobs=1)
    worked = [step for each in results.mechanisms for check in each.checks for step in check.steps if step.inputs]
    assert len(worked) > 20
    for step in worked:
        assert step.value is not None
        assert comes_to(evaluate(substitute(step.formula, step.inputs), {}), step.value), (step.symbol, step.formula)
