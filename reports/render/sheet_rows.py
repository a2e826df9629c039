"""The lines of a calculation sheet in letters, the same on a page of the PDF and on the screen.

A sheet is worked in SI; where the reader wants other units, each result has its value in them beside.
"""

from __future__ import annotations

from typing import NamedTuple

from assess.codes.calculation_step import Step
from reports.document import Sheet
from reports.language.locale import Locale
from reports.language.texts import quantity, say
from reports.language.units import UNITS, WORDS, Unit

SHEET_HEADS = (say("Symbol"), say("Meaning; clause"), say("Formula; numbers"), say("Value"))
BOUNDS = {"": "", "<=": "≤ ", ">=": "≥ "}
_POWERS = str.maketrans("23", "²³")
_FIGURES = 4
_NONE = "—"


class SheetRow(NamedTuple):
    """A line of a sheet; `reports.language.formula` reads the indices of its symbol, formula and numbers."""

    symbol: str
    description: str
    clause: str
    formula: str
    numbers: str
    value: str


def sheet_rows(sheet: Sheet, locale: Locale) -> tuple[SheetRow, ...]:
    """Return the lines of a sheet."""
    return tuple(_row(step, locale) for step in sheet.steps)


def _row(step: Step, locale: Locale) -> SheetRow:
    description, clause = (locale.word(text) if text else "" for text in (step.description, step.clause))
    return SheetRow(step.symbol, description, clause, step.formula, step.substituted, step_value(step, locale))


def step_value(step: Step, locale: Locale) -> str:
    """Return the result of a step in its unit, with that of the locale's system beside: 1.234 m (4.049 ft)."""
    if step.value is None:
        return _NONE
    number = BOUNDS[step.bound] + locale.number(step.value, figures=_FIGURES)
    written = locale.with_unit(number, step_unit(step, locale))
    if locale.system == "SI" or UNITS["SI"].get(step.dimension) == UNITS[locale.system].get(step.dimension):
        return written
    return f"{written} ({locale.text(quantity(step.value, step.dimension, _FIGURES))})"


def step_unit(step: Step, locale: Locale) -> Unit:
    """Return the unit in which a step is worked, as it is printed."""
    if step.unit in ("-", *WORDS):
        return Unit("" if step.unit == "-" else locale.word(step.unit))
    return Unit(step.unit.translate(_POWERS))
