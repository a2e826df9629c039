"""Rows of cells as the text of a CSV file: numbers to full precision, and no cell that a spreadsheet would run."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable

from spectra.formulas import harmless_cell

Cell = str | float | int | None


def table_text(rows: Iterable[Iterable[Cell]]) -> str:
    """Return rows, the header first, as the text of a CSV file; None is an empty cell."""
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([_field(cell) for cell in row] for row in rows)
    return stream.getvalue()


def _field(cell: Cell) -> str:
    if cell is None:
        return ""
    return harmless_cell(cell, shown=cell) if isinstance(cell, str) else repr(cell)
