"""The cells of a table in letters."""

from __future__ import annotations

from reports.document import Cell, Column, Graded
from reports.language.locale import Locale
from reports.render.frame_words import NO, YES

NOTHING = "—"
_WHOLE = 12  # figures of a whole number


def cell_text(cell: Cell, column: Column, locale: Locale) -> str:
    """Return a cell in the letters of a locale.

    Parameters
    ----------
    cell : of a table
    column : whose unit a number has
    locale : language and units

    Returns
    -------
    str
        A dash where there is nothing.
    """
    if cell is None:
        return NOTHING
    if isinstance(cell, bool):
        return locale.text(YES if cell else NO)
    if isinstance(cell, int | float):
        value = cell / locale.table_unit(column.dimension).size if column.dimension else cell
        return locale.number(value, figures=column.figures if isinstance(cell, float) else _WHOLE)
    return locale.text(cell.text if isinstance(cell, Graded) else cell) or NOTHING


def is_number(cell: Cell) -> bool:
    """Return whether a cell is set as a number: to the right."""
    return isinstance(cell, int | float) and not isinstance(cell, bool)


def is_numeric(cells: tuple[Cell, ...]) -> bool:
    """Return whether a column has numbers alone."""
    return any(map(is_number, cells)) and all(cell is None or is_number(cell) for cell in cells)
