"""The steps of a calculation sheet in letters: the formula, the numbers in it, and the result."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from assess.codes.calculation_step import INPUT_FIGURES, RESULT_FIGURES, Step, substitute, values_text, write_plain
from assess.messages.message import Quantity
from reports.document import Sheet
from reports.language.locale import Locale
from reports.language.units import UNITS
from reports.render.cell_text import NOTHING

SIGNS: Mapping[str, str] = {"": "", "<=": "≤ ", ">=": "≥ "}
_DECIMAL = re.compile(r"(?<=\d)\.(?=\d)")  # in a formula, which has no other points between digits
_POWERS = str.maketrans("23", "²³")


@dataclass(frozen=True)
class SheetRow:
    """One step.

    numbers : the formula with them after "=", or where the value was read; empty where neither is known
    beside : the result in US units, empty in SI
    """

    symbol: str
    description: str
    clause: str
    formula: str
    numbers: str
    result: str
    beside: str


def sheet_rows(sheet: Sheet, locale: Locale) -> Iterator[SheetRow]:
    """Yield the steps of a sheet in the letters of a locale; worked in SI, results beside in US units where asked."""
    for step in sheet.steps:
        yield SheetRow(
            step.symbol,
            ", ".join(part for part in (_word(step.description, locale), step.subject) if part),
            _word(step.clause, locale),
            _formula(step, locale),
            _numbers(step, locale),
            _result(step, locale),
            _beside(step, locale),
        )


def _word(english: str, locale: Locale) -> str:
    return locale.word(english) if english else ""


def _formula(step: Step, locale: Locale) -> str:
    """Return the formula with the decimal sign of the locale; where nothing is put in it may be words."""
    if not step.inputs:
        return _word(step.formula, locale)
    return _DECIMAL.sub(locale.point, step.formula)


def _numbers(step: Step, locale: Locale) -> str:
    """Return the formula with its numbers, where a value was read, and a remark; empty where these say nothing new."""
    if not (step.inputs or step.at or step.remark):
        plain = step.value is not None and step.substituted == write_plain(step.value)
        return "" if plain or step.substituted == step.formula else _word(step.substituted, locale)

    def write(value: float) -> str:
        return locale.number(value, figures=INPUT_FIGURES)

    said = substitute(_formula(step, locale), step.inputs, write) if step.inputs else ""
    if said and said != values_text(step.inputs, write):  # its symbols stand in the formula
        said = f"= {said}"
    return ", ".join(part for part in (said, values_text(step.at, write), _word(step.remark, locale)) if part)


def _result(step: Step, locale: Locale) -> str:
    """Return the result in the SI unit in which the formula is worked."""
    if step.value is None:
        return NOTHING
    unit = "" if step.unit == "-" else step.unit.translate(_POWERS)
    number = locale.number(step.value, figures=RESULT_FIGURES)
    return f"{SIGNS[step.bound]}{number}" + (f"\N{NO-BREAK SPACE}{locale.word(unit)}" if unit else "")


def _beside(step: Step, locale: Locale) -> str:
    """Return the result in the units of the locale where they are others; empty where not."""
    here, in_si = (UNITS[system].get(step.dimension) for system in (locale.system, "SI"))
    if step.value is None or here is None or here == in_si:
        return ""
    return SIGNS[step.bound] + locale.text(Quantity(step.value, step.dimension))
