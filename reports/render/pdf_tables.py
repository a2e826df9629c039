"""Tables and calculation sheets on the page: reportlab's own tables, whose rows and heads go on over pages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from reportlab.lib.colors import HexColor
from reportlab.platypus import LongTable, Paragraph

from reports.document import Cell, Column, Graded, Sheet, Table
from reports.figures.font import printable
from reports.figures.style import BANNER, GRID, MUTED
from reports.language.lettering import truncate
from reports.language.locale import Locale
from reports.language.texts import Verbatim
from reports.render.cell_text import column_texts, is_numeric
from reports.render.frame_words import SHEET_HEADS
from reports.render.sheet_rows import SheetRow, sheet_rows
from reports.render.typeset import STYLES, formula, markup, paragraph, width_of

TINT: Mapping[str, str] = {"pass": "#dcefe6", "fail": "#f8dfd6", "incomplete": "#faeccb", "comparison": "#e9ecef"}
INK_OF: Mapping[str, str] = {**BANNER, "comparison": MUTED}
_PADDING = 3.0  # left and right of a cell [pt]
_WIDEST, _LEAST = 0.5, 62.0  # share of the table that a text may ask for; width up to which words are not broken [pt]
_LOOSEST = 1.7  # a table is stretched so many times at most to fill its line
_DIVIDED = 260.0  # a row that has so much room and needs more is divided [pt]
_NARROWEST = 0.04  # share of the table that is left for a column without one
_LONGEST_HEAD = 120  # letters
_LONG = 120  # letters: a longer text is not measured
_SHEET_SHARES = (0.11, 0.33, 0.39, 0.17)
_LOOK: tuple[Any, ...] = (
    ("VALIGN", (0, 0), (-1, 0), "BOTTOM"),
    ("VALIGN", (0, 1), (-1, -1), "TOP"),
    ("LINEBELOW", (0, 0), (-1, 0), 0.7, HexColor(MUTED)),
    ("LINEBELOW", (0, 1), (-1, -1), 0.3, HexColor(GRID)),
    ("LEFTPADDING", (0, 0), (-1, -1), _PADDING),
    ("RIGHTPADDING", (0, 0), (-1, -1), _PADDING),
    ("TOPPADDING", (0, 0), (-1, -1), 1.4),
    ("BOTTOMPADDING", (0, 0), (-1, -1), 1.9),
)


class Rows(LongTable):
    """A table that goes on over pages; a row is divided only where it is higher than a good part of a page.

    start : height of the head and the first row, of which a higher one may be divided [pt]
    """

    start = 0.0

    def split(self, aW: float, aH: float) -> list[Any]:
        self.splitInRow = int(aH > _DIVIDED)
        return list(super().split(aW, aH))


def table_grid(table: Table, locale: Locale, width: float) -> Rows:
    """Return a table as wide as its cells need, at most `width` [pt]; with the head again on each page."""
    prefix = "small-" if table.small else ""
    columns = [tuple(row[place] for row in table.rows) for place in range(len(table.columns))]
    texts = (column_texts(*each, locale) for each in zip(columns, table.columns, strict=True))
    rows = [list(map(printable, row)) for row in zip(*texts, strict=True)]
    right = list(map(is_numeric, columns))
    heads = [printable(_head(column, locale)) for column in table.columns]
    widths = column_widths([heads, *rows], [column.share for column in table.columns], width, f"{prefix}head")
    styles = [f"{prefix}{'number' if each else 'cell'}" for each in right]
    shown = [f"{prefix}head{'-number' if each else ''}" for each in right]
    made: list[list[Any]] = [[paragraph(*each) for each in zip(heads, shown, strict=True)]]
    for place, cells in enumerate(table.rows):
        colour = MUTED if place in table.muted else ""
        made.append([_cell(*each, colour) for each in zip(cells, rows[place], styles, widths, strict=True)])
    of = STYLES[f"{prefix}cell"]
    letters = [
        ("FONT", (0, 0), (-1, -1), of.fontName, of.fontSize, of.leading),
        ("TEXTCOLOR", (0, 0), (-1, -1), of.textColor),
    ]
    sides = [("ALIGN", (place, 0), (place, -1), "RIGHT") for place, each in enumerate(right) if each]
    return _grid(made, widths, [*letters, *sides, *_tints(table)])


def sheet_grid(sheet: Sheet, locale: Locale, width: float) -> Rows:
    """Return a calculation sheet, `width` [pt] wide."""
    heads = [paragraph(locale.text(head), "head") for head in SHEET_HEADS]
    rows = [_step(row) for row in sheet_rows(sheet, locale)]
    return _grid([list(heads), *rows], [share * width for share in _SHEET_SHARES], [])


def _head(column: Column, locale: Locale) -> str:
    """Return the head of a column, whose unit is kept where the label is cut."""
    label = truncate(locale.text(column.label), _LONGEST_HEAD)
    return locale.heading(Verbatim(label), column.dimension)


def column_widths(rows: Sequence[Sequence[str]], shares: Sequence[float], width: float, style: str) -> list[float]:
    """Return the widths of columns [pt]: those with a share of `width` have it, the others what their cells need.

    rows : texts, the heads first, which may be folded
    shares : of the width, 0 for a column that shares what is left
    """
    free = [place for place, share in enumerate(shares) if not share]
    whole = max(1.0, sum(shares) + _NARROWEST * len(free))
    given = [share * width / whole for share in shares]
    columns = [[row[place] for row in rows] for place in free]
    least = [_padded(max(_word_width(text, style) for text in column)) for column in columns]
    lines = [[min(_WIDEST * width, _padded(_line_width(text, style))) for text in column] for column in columns]
    wanted = [max(low, *each[1:], 0.0) for low, each in zip(least, lines, strict=True)]
    easy = [max(want, each[0]) for want, each in zip(wanted, lines, strict=True)]
    found = _shared(least, wanted, easy, width - sum(given), fills=len(free) < len(shares))
    for place, own in zip(free, found, strict=True):
        given[place] = own
    return given


def _shared(
    least: Sequence[float], wanted: Sequence[float], easy: Sequence[float], left: float, *, fills: bool
) -> list[float]:
    """Return what each column gets of the width that is `left`, all of it where it `fills` a line.

    Needs are: `least`, of the longest words; `wanted`, of the longest lines; `easy`, with the head on one line too.
    """
    if sum(easy) <= left:
        return [each * min(left / sum(easy), left if fills else _LOOSEST) for each in easy]
    floors = (wanted, least, [0.0] * len(least))
    floor, enough = next(pair for pair in zip(floors, (easy, wanted, least), strict=True) if sum(pair[0]) <= left)
    return _filled(floor, enough, left)


def _padded(width: float) -> float:
    return width + 2 * _PADDING + 1


def _filled(floor: Sequence[float], wanted: Sequence[float], left: float) -> list[float]:
    """Return widths from `floor` up to what is `wanted`, the same more for each until nothing is left."""
    widths, spare = list(floor), left - sum(floor)
    order = sorted(range(len(floor)), key=lambda place: wanted[place] - floor[place])
    for waiting, place in zip(range(len(order), 0, -1), order, strict=True):
        more = min(wanted[place] - floor[place], spare / waiting)
        widths[place], spare = floor[place] + more, spare - more
    return widths


def _line_width(text: str, style: str) -> float:
    return width_of(text, style) if len(text) <= _LONG else 0.6 * float(STYLES[style].fontSize) * len(text)


def _word_width(text: str, style: str) -> float:
    return min(_LEAST, max((width_of(word, style) for word in text[:_LONG].split(" ")), default=0.0))


def _cell(cell: Cell, text: str, style: str, width: float, colour: str) -> str | Paragraph:
    """Return the text itself where one line has room for it, which reportlab draws at once, else a paragraph."""
    if isinstance(cell, Graded):
        ink = HexColor(INK_OF[cell.outcome])
        return Paragraph(f"<b>{markup(text)}</b>", STYLES[style].clone(f"{style}-{cell.outcome}", textColor=ink))
    if not colour and len(text) <= _LONG and width_of(text, style) <= width - 2 * _PADDING:
        return text
    return paragraph(text, style, colour=colour)


def _step(row: SheetRow) -> list[Any]:
    style = STYLES["formula"]
    clause = f'<br/><font color="{MUTED}">{markup(row.clause)}</font>' if row.clause else ""
    numbers = f"<br/>{formula(row.numbers)}" if row.numbers else ""
    beside = f"<br/>({markup(row.beside)})" if row.beside else ""
    texts = (
        formula(row.symbol),
        formula(row.description) + clause,
        formula(row.formula) + numbers,
        markup(row.result) + beside,
    )
    return [Paragraph(text, style) for text in texts]


def _tints(table: Table) -> Iterator[tuple[Any, ...]]:
    for row, cells in enumerate(table.rows, start=1):
        for column, cell in enumerate(cells):
            if isinstance(cell, Graded):
                yield ("BACKGROUND", (column, row), (column, row), HexColor(TINT[cell.outcome]))


def _grid(rows: Sequence[list[Any]], widths: Sequence[float], look: Sequence[Any]) -> Rows:
    made = Rows(rows, colWidths=widths, repeatRows=1, hAlign="LEFT", spaceAfter=8, style=[*_LOOK, *look])
    made.start = min(_DIVIDED, sum(_height(row, widths) for row in rows[:2]))
    return made


def _height(row: Sequence[Any], widths: Sequence[float]) -> float:
    """Return the height of a row [pt]; one of single lines alone is lower than what is anyway left for it."""
    cells = zip(row, widths, strict=True)
    return max((cell.wrap(wide - 2 * _PADDING, 0)[1] for cell, wide in cells if isinstance(cell, Paragraph)), default=0)
