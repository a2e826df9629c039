"""A cell of a table in letters."""

from __future__ import annotations

from reports.document import Cell, Column, Graded
from reports.language.locale import Locale
from reports.language.texts import say

DASH = "—"
_TRUTH = {True: say("yes"), False: say("no")}


def cell_text(cell: Cell, column: Column, locale: Locale) -> str:
    """Return a cell as a reader sees it; its number in the unit of the column, a dash where there is nothing."""
    if cell is None:
        return DASH
    if isinstance(cell, bool):
        return locale.text(_TRUTH[cell])
    if isinstance(cell, int | float):
        return locale.number(in_unit(cell, column, locale), figures=column.figures, aligned=not isinstance(cell, int))
    return locale.text(cell.text if isinstance(cell, Graded) else cell) or DASH


def in_unit(number: float, column: Column, locale: Locale) -> float:
    """Return a number in the unit of its column; in SI where the column has no dimension, as whole numbers."""
    size = locale.table_unit(column.dimension).size if column.dimension else 1.0
    return number if size == 1.0 else number / size


def is_numeric(column: Column, cells: tuple[Cell, ...]) -> bool:
    """Return whether a column is one of numbers: it has a dimension, or nothing but numbers where there is anything."""
    given = [cell for cell in cells if cell is not None]
    numbers = [isinstance(cell, int | float) and not isinstance(cell, bool) for cell in given]
    return bool(column.dimension) or (bool(numbers) and all(numbers))
