"""Tables as CSV: full precision, units in the header, and no cell that a spreadsheet would run."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from pathlib import Path

from reports.document import STAMP, Cell, Document, Table
from reports.language.lettering import visible
from reports.language.outcome_words import spell_out_table
from reports.render.sheet_table import as_table
from spectra.formulas import harmless_cell


def write_csv(document: Document, folder: Path) -> tuple[Path, ...]:
    """Write every table and calculation sheet into `folder` as name.csv (UTF-8); the paths written.

    The last column is the stamp of the results: a row that is copied elsewhere takes it along.
    """
    everything = (*document.tables, *(as_table(sheet, translate=document.translate) for sheet in document.sheets))
    return tuple(
        _write(spell_out_table(table, document.translate), folder, stamp=document.stamp) for table in everything
    )


def field(cell: Cell) -> str:
    """Return a cell as CSV text: numbers to full precision, text that looks like a formula behind an apostrophe."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "true" if cell else "false"
    if isinstance(cell, int | float):
        return repr(float(cell)) if isinstance(cell, float) else repr(cell)
    return harmless_cell(cell, shown=visible(cell))


def csv_lines(rows: Iterable[Iterable[Cell]]) -> str:
    """Return rows, the header first, as the text of a CSV file; every cell goes through `field`."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([field(cell) for cell in row] for row in rows)
    return stream.getvalue()


def _write(table: Table, folder: Path, *, stamp: str) -> Path:
    path = folder / f"{table.name}.csv"
    head, rows = [column.heading for column in table.columns], table.rows
    if stamp:
        head, rows = [*head, STAMP], tuple((*row, stamp) for row in rows)
    path.write_text(csv_lines([head, *rows]), encoding="utf-8", newline="")
    return path
