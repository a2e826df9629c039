"""The cells of a table: in letters, and as a spreadsheet keeps them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeGuard

from assess.messages.message import Quantity
from reports.document import Cell, Column, Graded, Link
from reports.language.locale import Locale
from reports.render.frame_words import NO, YES

PlainCell = str | float | int | bool | None
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
        return _number(cell, column, locale)
    return locale.text(cell.text if isinstance(cell, Graded | Link) else cell) or NOTHING


def column_texts(cells: Sequence[Cell], column: Column, locale: Locale) -> list[str]:
    """Return the cells of a column in letters; zeros follow a number as far as others have decimals, and it figures.

    Parameters
    ----------
    cells : of the column, from above
    column : whose unit numbers have
    locale : language and units
    """
    texts = [cell_text(cell, column, locale) for cell in cells]
    kept = [_decimals(text, locale) if _is_measure(cell, text) else 0 for cell, text in zip(cells, texts, strict=True)]
    pairs = zip(cells, texts, strict=True)
    return [_padded(cell, column, locale, max(kept)) if _is_measure(cell, text) else text for cell, text in pairs]


def _is_measure(cell: Cell, text: str) -> TypeGuard[float]:
    return isinstance(cell, float) and cell != 0.0 and "×" not in text


def _padded(cell: float, column: Column, locale: Locale, most: int) -> str:
    """Return a number with zeros up to `most` decimals, as far as its figures go."""
    whole, point, decimals = _number(cell, column, locale, aligned=True).partition(locale.point)
    return f"{whole}{point}{decimals[:most]}" if most else whole


def _number(cell: float, column: Column, locale: Locale, *, aligned: bool = False) -> str:
    value = cell / locale.table_unit(column.dimension).size if column.dimension else cell
    return locale.number(value, figures=column.figures if isinstance(cell, float) else _WHOLE, aligned=aligned)


def _decimals(text: str, locale: Locale) -> int:
    return len(text.partition(locale.point)[2])


def is_number(cell: Cell) -> bool:
    """Return whether a cell is set as a number: to the right."""
    return isinstance(cell, int | float) and not isinstance(cell, bool)


def is_numeric(cells: tuple[Cell, ...]) -> bool:
    """Return whether a column has numbers alone."""
    return any(map(is_number, cells)) and all(cell is None or is_number(cell) for cell in cells)


def plain_cell(cell: Cell, column: Column, locale: Locale) -> PlainCell:
    """Return a number in the unit of its column; a quantity with a unit of its own as the report shows it.

    A quantity of the dimension of its column, or without a unit, is a number as well; a link is its path.
    """
    if isinstance(cell, Link):
        return cell.path
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
