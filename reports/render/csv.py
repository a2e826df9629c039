"""Tables as CSV: full precision, units in the header, and no cell that a spreadsheet would run."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from pathlib import Path

from reports.document import Document, Table
from reports.language.lettering import visible
from reports.language.locale import Locale
from reports.render.table_text import STAMP, PlainCell, plain_cell, sheet_as_table
from spectra.formulas import harmless_cell


def write_csv(document: Document, folder: Path) -> tuple[Path, ...]:
    """Write every table and calculation sheet into `folder` as name.csv (UTF-8); the paths written.

    The last column is the stamp of the results: a row that is copied elsewhere takes it along. Numbers have a decimal
    point in every language.
    """
    locale = document.writer
    everything = (*document.tables, *(sheet_as_table(sheet, locale) for sheet in document.sheets))
    return tuple(_write(table, folder, locale, stamp=document.stamp) for table in everything)


def csv_field(cell: PlainCell) -> str:
    """Return a cell as CSV text: numbers to full precision, text that looks like a formula behind an apostrophe."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "true" if cell else "false"
    if isinstance(cell, int | float):
        return repr(float(cell)) if isinstance(cell, float) else repr(cell)
    return harmless_cell(cell, shown=visible(cell))


def csv_lines(rows: Iterable[Iterable[PlainCell]]) -> str:
    """Return rows, the header first, as the text of a CSV file; every cell goes through `csv_field`."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([csv_field(cell) for cell in row] for row in rows)
    return stream.getvalue()


def _write(table: Table, folder: Path, locale: Locale, *, stamp: str) -> Path:
    path = folder / f"{table.name}.csv"
    last = [stamp] if stamp else []
    head = [locale.heading(column.label, column.dimension) for column in table.columns]
    rows = ([plain_cell(*each, locale) for each in zip(row, table.columns, strict=True)] for row in table.rows)
    named = [*head, *([locale.text(STAMP)] if stamp else [])]
    path.write_text(csv_lines([named, *([*row, *last] for row in rows)]), encoding="utf-8", newline="")
    return path
