"""A calculation sheet as a plain table."""

from __future__ import annotations

from assess.codes.calculation_step import Step
from reports.document import Cell, Column, Sheet, Table
from reports.language.locale import Locale
from reports.language.texts import Verbatim, say
from reports.language.units import UNITS
from reports.render.sheet_rows import SIGNS, SheetRow, sheet_rows

_COLUMNS = (
    say("Symbol"),
    say("Description"),
    say("Clause"),
    say("Formula"),
    say("Substituted"),
    say("Value"),
    say("Unit"),
)
_BESIDE = (say("Value, US"), say("Unit, US"))


def as_table(sheet: Sheet, locale: Locale) -> Table:
    """Return a calculation sheet as a plain table, worked in SI, with results in US units beside where asked."""
    besides = locale.system == "US"
    columns = tuple(map(Column, (*_COLUMNS, *(_BESIDE if besides else ()))))
    rows = tuple(
        (*_worked(step, row, locale), *(_beside(step, locale) if besides else ()))
        for step, row in zip(sheet.steps, sheet_rows(sheet, locale), strict=True)
    )
    return Table(sheet.name, sheet.caption, columns, rows)


def _worked(step: Step, row: SheetRow, locale: Locale) -> tuple[Cell, ...]:
    texts = map(Verbatim, (row.symbol, row.description, row.clause, row.formula, row.numbers.removeprefix("= ")))
    return (*texts, _bounded(step, step.value, locale), Verbatim(step.unit))


def _beside(step: Step, locale: Locale) -> tuple[Cell, ...]:
    """Return a result in the unit of tables of the locale; nothing where that is no other unit."""
    here, in_si = (UNITS[system].get(step.dimension) for system in (locale.system, "SI"))
    if step.value is None or here is None or here == in_si:
        return None, None
    return _bounded(step, step.value / here.table.size, locale), Verbatim(here.table.name)


def _bounded(step: Step, value: float | None, locale: Locale) -> Cell:
    """Return a result as a number; as text where it is known only to be no more, or no less."""
    return value if value is None or not step.bound else Verbatim(SIGNS[step.bound] + locale.number(value))
