"""Tables as CSV: full precision, units in the header, and no cell that a spreadsheet would run."""

from __future__ import annotations

import csv
from pathlib import Path

from reports.document import Cell, Document, Table
from reports.lettering import visible
from reports.sheets import as_table
from reports.worded import worded

_FORMULA = ("=", "+", "-", "@", "\t", "\r")


def write_csv(document: Document, folder: Path) -> tuple[Path, ...]:
    """Write every table and calculation sheet into `folder` as name.csv (UTF-8); the paths written."""
    everything = (*document.tables, *(as_table(sheet, said=document.said) for sheet in document.sheets))
    return tuple(_write(worded(table, document.said), folder) for table in everything)


def field(cell: Cell) -> str:
    """A cell as CSV text: numbers to full precision, text that looks like a formula behind an apostrophe."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "true" if cell else "false"
    if isinstance(cell, int | float):
        return repr(cell)
    text = visible(cell)
    return f"'{text}" if cell.lstrip(" \n\v\f").startswith(_FORMULA) and cell != "-" else text


def _write(table: Table, folder: Path) -> Path:
    path = folder / f"{table.name}.csv"
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([column.heading for column in table.columns])
        writer.writerows([field(cell) for cell in row] for row in table.rows)
    return path
