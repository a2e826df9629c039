"""Tables and calculation sheets on the page: column widths, captions that repeat, rows that split over pages."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from reports.document import SHEET_HEADS, Cell, Column, Line, Sheet, Table
from reports.language.lettering import truncate
from reports.language.numerals import cell_text, step_result
from reports.language.outcome_words import outcome_colour, spell_out
from reports.render.cells import Cell as Set
from reports.render.cells import Piece, cell, formula_pieces, plain_cell, text_pieces
from reports.render.ruled_table import PADDING, Row, RuledTable, ruled_table
from reports.render.typeset import SMALL, paragraph, width_of

LONGEST = 400  # characters in a cell; the whole text is in the CSV file and the spreadsheet
_LONGEST_STEP = 700
_NARROW, _WIDE = 112.0, 240.0
_SHARES = (0.13, 0.35, 0.35, 0.17)


def table_grid(table: Table, *, title: str, width: float, translate: Callable[[str], str] = str) -> RuledTable:
    """Return a table under its caption, `width` [pt] wide or as narrow as its text; both repeat on each page.

    translate : gives verdicts, yes and no in the language of the document
    """
    texts = [
        [_text(cell, column, translate) for cell, column in zip(row, table.columns, strict=True)] for row in table.rows
    ]
    size = "" if sum(least_widths(table.columns, texts)) <= width else SMALL
    widths = column_widths(table.columns, texts, width, size=size)
    body = [
        [
            plain_cell(text, _style(raw, column, muted=place in table.muted) + size, width=wide - PADDING)
            for raw, text, column, wide in zip(row, line, table.columns, widths, strict=True)
        ]
        for place, (row, line) in enumerate(zip(table.rows, texts, strict=True))
    ]
    head = [
        plain_cell(c.heading, f"head-number{size}" if c.kind == "number" else f"head{size}", width=wide - PADDING)
        for c, wide in zip(table.columns, widths, strict=True)
    ]
    return _grid(f"{title}. {table.caption}", head, body, widths)


def sheet_grid(sheet: Sheet, *, title: str, width: float, translate: Callable[[str], str] = str) -> RuledTable:
    """Return a calculation sheet: symbol; meaning and clause; formula and numbers; value and unit."""
    widths = [share * width for share in _SHARES]
    rooms = [wide - PADDING for wide in widths]
    head = [plain_cell(translate(text), "head", width=room) for text, room in zip(SHEET_HEADS, rooms, strict=True)]
    return _grid(f"{title}. {sheet.caption}", head, [_step(line, rooms) for line in sheet.lines], widths)


def column_widths(columns: tuple[Column, ...], texts: list[list[str]], width: float, *, size: str = "") -> list[float]:
    """Return widths [pt] that keep words whole where there is room, and add up to no more than `width`."""
    least, natural = least_widths(columns, texts, size=size), []
    for place, column in enumerate(columns):
        lines = [1.02 * width_of(line, f"cell{size}") for line in {line[place] for line in texts}]
        head = 0.6 * width_of(column.heading, f"head{size}")
        natural.append(max(least[place], PADDING + 1 + min(_WIDE, max([head, *lines]))))
    return _shared(least, natural, width)


def least_widths(columns: tuple[Column, ...], texts: list[list[str]], *, size: str = "") -> list[float]:
    """Return widths [pt] below which words break; size: "" or `SMALL`, the ending of the styles."""
    least = []
    for place, column in enumerate(columns):
        words = [width_of(word, f"head{size}") for word in column.heading.split()]
        style = f"head{size}" if column.kind == "verdict" else f"cell{size}"
        inside = [1.02 * width_of(word, style) for line in {line[place] for line in texts} for word in line.split()]
        least.append(PADDING + 1 + max([*words, min(_NARROW, max(inside, default=0.0))]))
    return least


def _shared(least: list[float], natural: list[float], width: float) -> list[float]:
    if sum(natural) <= width:
        return [value * min(1.25, width / sum(natural)) for value in natural]
    if sum(least) >= width:
        cap = _cap(least, width)
        return [min(value, cap) for value in least]
    spare = (width - sum(least)) / (sum(natural) - sum(least))
    return [low + spare * (high - low) for low, high in zip(least, natural, strict=True)]


def _cap(widths: list[float], total: float) -> float:
    """Return what the widest may have so that all together have `total`."""
    rest = total
    for place, narrow in enumerate(sorted(widths)):
        share = rest / (len(widths) - place)
        if narrow > share:
            return share
        rest -= narrow
    return max(widths)


def _grid(caption: str, head: Row, rows: Sequence[Row], widths: list[float]) -> RuledTable:
    return ruled_table(paragraph(truncate(caption, LONGEST), "caption"), head, rows, widths=widths)


def _text(cell: Cell, column: Column, translate: Callable[[str], str]) -> str:
    return truncate(cell_text(spell_out(cell, column, translate), column.kind), LONGEST)


def _style(raw: Cell, column: Column, *, muted: bool) -> str:
    """Return which of STYLES a cell has."""
    right = column.kind == "number"
    if muted:
        return "muted-number" if right else "muted"
    return outcome_colour(raw, column) or ("number" if right else "cell")


def _step(line: Line, rooms: list[float]) -> list[Set]:
    """Return the cells of one step, as wide as `rooms`."""
    what, how = [_formula(line.description)], [_formula(line.formula)]
    what += [_written(line.clause, "muted")] if line.clause else []
    how += [_formula(f"= {line.substituted}")] if line.substituted else []
    columns = ([_formula(line.symbol)], what, how, [_written(step_result(line.value, line.unit, line.beside), "cell")])
    return [cell(column, "cell", width=room) for column, room in zip(columns, rooms, strict=True)]


def _formula(text: str) -> list[Piece]:
    return formula_pieces(truncate(text, _LONGEST_STEP))


def _written(text: str, style: str) -> list[Piece]:
    return text_pieces(truncate(text, _LONGEST_STEP), style)
