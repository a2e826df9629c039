"""The calculation sheets: every step of a procedure, as it computed it."""

from __future__ import annotations

from collections.abc import Callable

from assess.codes.check import Check
from reports.document import Column, Line, Sheet, Table
from reports.numerals import bounded

_COLUMNS = ("Symbol", "Description", "Clause", "Formula", "Substituted", "Value", "Unit")


def sheet(check: Check, *, name: str, mechanism: str) -> Sheet:
    """The steps of one check, at its level."""
    lines = tuple(
        Line(s.symbol, s.description, s.clause, s.formula, s.substituted, bounded(s.value, s.bound), s.unit)
        for s in check.steps
    )
    state = f", limit state {check.limit_state}" if check.limit_state else ""
    role = ", deciding" * (check.role == "deciding") + ", reading of the thesis" * (check.reading == "thesis")
    what = f"{check.procedure} ({check.edition}){state}, {check.branch} branch"
    return Sheet(name, f"{mechanism}: {what}, at PGA {check.level_pga_g:.3g} g: {check.verdict}{role}.", lines)


def as_table(sheet: Sheet, *, said: Callable[[str], str] = str) -> Table:
    """A calculation sheet as a plain table, for the spreadsheet and the CSV files.

    said : how the heads of the columns are said in the language of the document
    """
    columns = tuple(Column(said(label), kind="number" if label == "Value" else "text") for label in _COLUMNS)
    rows = tuple((s.symbol, s.description, s.clause, s.formula, s.substituted, s.value, s.unit) for s in sheet.lines)
    if any(line.beside for line in sheet.lines):
        columns += (Column(said("Value, US"), kind="number"), Column(said("Unit, US")))
        rows = tuple((*row, *(line.beside or (None, ""))) for row, line in zip(rows, sheet.lines, strict=True))
    return Table(sheet.name, sheet.caption, columns, rows)
