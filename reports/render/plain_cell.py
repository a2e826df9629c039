"""A cell of a table as a spreadsheet keeps it: numbers at full precision, everything else as text."""

from __future__ import annotations

from assess.messages.message import Quantity
from reports.document import Cell, Column, Graded
from reports.language.locale import Locale

PlainCell = str | float | int | bool | None


def plain_cell(cell: Cell, column: Column, locale: Locale) -> PlainCell:
    """Return a number in the unit of its column; a quantity with a unit of its own as the report shows it.

    A quantity of the dimension of its column, or without a unit, is a number as well.
    """
    content = cell.text if isinstance(cell, Graded) else cell
    if isinstance(content, Quantity) and content.dimension in ("ratio", column.dimension):
        return _in_unit(content.value, content.dimension, locale)
    if content is None or isinstance(content, bool):
        return content
    if isinstance(content, int | float):
        return _in_unit(content, column.dimension, locale)
    return locale.text(content)


def _in_unit(number: float, dimension: str, locale: Locale) -> float:
    """Return a number in SI in the unit of tables of its dimension."""
    size = locale.table_unit(dimension).size if dimension else 1.0
    return number if size == 1.0 else number / size
