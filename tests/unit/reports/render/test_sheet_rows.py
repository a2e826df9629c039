"""The steps of a calculation sheet in letters."""

from __future__ import annotations

import pytest

from assess.codes.calculation_sheet import Step, step
from reports.language.locale import Locale
from reports.render.table_text import SheetRow, sheet_rows

GIVEN = {"a_0": (1.25, "m/s2"), "e*": 0.875}
WITH_INPUTS = step("a", "acceleration", "C8.7.1", "1.35 a_0 / e*", 1.928571, "m/s2", given=GIVEN, bound="<=")


def row(made: Step, locale: Locale | None = None) -> SheetRow:
    (found,) = sheet_rows((made,), locale or Locale())
    return found


def test_numbers_are_put_into_the_formula_and_the_result_has_its_unit() -> None:
    made = row(WITH_INPUTS)
    assert (made.formula, made.numbers) == ("1.35 a_0 / e*", "= 1.35 · 1.25 / 0.875")
    assert (made.result, made.beside) == ("≤ 1.929\u00a0m/s²", "")


def test_the_locale_has_its_decimal_sign_and_its_unit_beside() -> None:
    made = row(WITH_INPUTS, Locale("it", "US"))
    assert (made.formula, made.numbers) == ("1,35 a_0 / e*", "= 1,35 · 1,25 / 0,875")
    assert (made.result, made.beside) == ("≤ 1,929\u00a0m/s²", "≤ 0,1967\u00a0g")


def test_a_value_that_was_read_says_where() -> None:
    made = row(step("S_e", "spectrum", "3.2.3.2", "S_e(T)", 0.607, "m/s2", at={"T": (0.5, "s")}, subject="Wall 6 m"))
    assert (made.description, made.numbers) == ("spectrum, Wall 6 m", "T = 0.5")


def test_values_without_a_place_in_the_formula_are_no_equation() -> None:
    assert row(step("x", "", "", "curve", 2.0, given={"M": 3.0})).numbers == "M = 3"


@pytest.mark.parametrize(
    ("value", "substituted", "numbers"), [(2.0, "2", ""), (2.0, "curve", "curve"), (None, "f", "")]
)
def test_a_step_of_an_older_result_says_what_it_said(value: float | None, substituted: str, numbers: str) -> None:
    made = row(Step("x", "a length", "", "f", substituted, value, "m"))
    assert made.numbers == numbers
    assert made.result == ("—" if value is None else "2\u00a0m")
