"""A calculation sheet as a plain table."""

from __future__ import annotations

from collections.abc import Callable

from reports.document import Column, Sheet, Table

_COLUMNS = ("Symbol", "Description", "Clause", "Formula", "Substituted", "Value", "Unit")


def as_table(sheet: Sheet, *, translate: Callable[[str], str] = str) -> Table:
    """Return a calculation sheet as a plain table, for the spreadsheet and the CSV files.

    translate : gives the headings of columns in the language of the document
    """
    columns = tuple(Column(translate(label), kind="number" if label == "Value" else "text") for label in _COLUMNS)
    rows = tuple((s.symbol, s.description, s.clause, s.formula, s.substituted, s.value, s.unit) for s in sheet.lines)
    if any(line.beside for line in sheet.lines):
        columns += (Column(translate("Value, US"), kind="number"), Column(translate("Unit, US")))
        rows = tuple((*row, *(line.beside or (None, ""))) for row, line in zip(rows, sheet.lines, strict=True))
    return Table(sheet.name, sheet.caption, columns, rows)
