"""The steps of a calculation sheet in letters: the formula, the numbers in it, and the result."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from assess.codes.calculation_step import Step
from assess.messages.message import Quantity
from reports.document import Sheet
from reports.language.formula import mark_up
from reports.language.locale import Locale
from reports.language.units import UNITS
from reports.render.cell_text import NOTHING

SIGNS: Mapping[str, str] = {"": "", "<=": "≤ ", ">=": "≥ "}
_POWERS = str.maketrans("23", "²³")


@dataclass(frozen=True)
class SheetRow:
    """One step. numbers: the formula with them, empty where there are none; beside: the result in US units."""

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
            locale.word(step.description) if step.description else "",
            locale.word(step.clause) if step.clause else "",
            locale.word(step.formula) if step.formula else "",
            locale.word(step.substituted) if step.substituted else "",
            _result(step, locale),
            _beside(step, locale),
        )


def marked_formula(escaped: str, *, power: str) -> str:
    """Return an escaped formula with tags for its indices and powers. power: the tag of a power, "sup" or "super"."""
    return mark_up(escaped, index=("<sub>", "</sub>"), power=(f"<{power}>", f"</{power}>"))


def _result(step: Step, locale: Locale) -> str:
    """Return the result in the SI unit in which the formula is worked."""
    if step.value is None:
        return NOTHING
    unit = "" if step.unit == "-" else step.unit.translate(_POWERS)
    number = locale.number(step.value)
    return f"{SIGNS[step.bound]}{number}" + (f"\N{NO-BREAK SPACE}{locale.word(unit)}" if unit else "")


def _beside(step: Step, locale: Locale) -> str:
    """Return the result in the units of the locale where they are others; empty where not."""
    here, in_si = (UNITS[system].get(step.dimension) for system in (locale.system, "SI"))
    if step.value is None or here is None or here == in_si:
        return ""
    return SIGNS[step.bound] + locale.text(Quantity(step.value, step.dimension))
