"""Tables as an Excel workbook: a contents sheet, one sheet per table, and all calculation sheets on one."""

from __future__ import annotations

import datetime
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path

from xlsxwriter import Workbook
from xlsxwriter.format import Format
from xlsxwriter.worksheet import Worksheet

from reports.document import STAMP, Cell, Column, Document, Table
from reports.figures.style import FAIL, INK, MUTED, PASS
from reports.language.lettering import truncate, visible
from reports.language.numerals import FIGURES, decimals, numeral
from reports.language.outcome_words import outcome_colour, spell_out
from reports.render.sheet_table import as_table
from spectra.formulas import is_formula

CONTENTS, SHEETS = "contents", "calculation sheets"
_LONGEST_TEXT, _LONGEST_NAME, _LONGEST_PROPERTY = 32_000, 31, 255
_RESERVED = "history"  # a name that Excel keeps for itself
_NARROWEST, _WIDEST = 9, 60  # columns [characters]
_LONG = 500  # rows; numbers of longer tables have no format
_CREATED = datetime.datetime(2000, 1, 1)  # fixed: the same results give the same workbook


Look = dict[str, str | int]
"""How a cell looks, in xlsxwriter's words."""
_BOLD: Look = {"font_color": INK, "bold": 1}
_GREY: Look = {"font_color": MUTED}
_LINK: Look = {"font_color": "#00588a", "underline": 1}
_TITLE: Look = {"bold": 1, "font_size": 14}
_VERDICTS: dict[object, Look] = {
    "pass": {"font_color": PASS, "bold": 1},
    "fail": {"font_color": FAIL, "bold": 1},
}
_HEAD: Look = {**_BOLD, "bg_color": "#E3E8ED", "bottom": 1, "bottom_color": "#6B7680", "text_wrap": 1}
_WRAPPED: Look = {"text_wrap": 1, "valign": "top"}


@dataclass(frozen=True)
class _Book:
    """A workbook that makes each look once."""

    book: Workbook
    made: dict[tuple[tuple[str, str | int], ...], Format] = field(default_factory=dict)

    def format(self, look: Look) -> Format | None:
        """Return the format of a look; None for that of every cell."""
        if not look:
            return None
        key = tuple(look.items())
        if key not in self.made:
            self.made[key] = self.book.add_format(look)
        return self.made[key]


def write_xlsx(document: Document, path: Path) -> Path:
    """Write every table of the document to a workbook at `path`; text is never taken for a formula."""
    own = (document.translate(CONTENTS), document.translate(SHEETS))
    names = unique([table.name for table in document.tables], taken=own)
    starts = _starts(document)
    with Workbook(str(path), {"in_memory": True}) as made:
        book = _Book(made)
        _describe(made, document)
        _contents(made.add_worksheet(own[0]), document, names, starts, book=book)
        for table, name in zip(document.tables, names, strict=True):
            _alone(made.add_worksheet(name), table, translate=document.translate, book=book)
        _sheets(made.add_worksheet(own[1]), document, starts, book=book)
    return path


def unique(names: list[str], *, taken: Iterable[str] = (CONTENTS, SHEETS)) -> list[str]:
    """Return valid worksheet names, no two alike nor `taken` in any case: at most 31 characters, no []:*?/\\."""
    used, made = {_RESERVED, *(name.lower() for name in taken)}, []
    for wanted in names:
        plain = _cut(re.sub(r"[\[\]:*?/\\']", "-", visible(wanted)), _LONGEST_NAME) or "table"
        name, number = plain, 2
        while name.lower() in used:
            name, number = f"{_cut(plain, _LONGEST_NAME - 1 - len(str(number)))}~{number}", number + 1
        used.add(name.lower())
        made.append(name)
    return made


def _cut(name: str, length: int) -> str:
    """Return the first `length` characters as Excel counts them, in units of UTF-16: an emoji has two."""
    return name.encode("utf-16-le")[: 2 * length].decode("utf-16-le", "ignore")


def number_format(value: float) -> str:
    """Return the format in which a spreadsheet shows a number as the report does: to four figures."""
    places = decimals(value, figures=FIGURES)
    if places is None:
        return f"0.{'0' * (FIGURES - 1)}E+00"
    return "0" if places == 0 else f"0.{'0' * places}"


def _describe(book: Workbook, document: Document) -> None:
    texts = {"title": document.title, "subject": document.subject, "author": document.program}
    texts["keywords"] = f"{STAMP} {document.stamp}" if document.stamp else ""
    described = {key: truncate(visible(text), _LONGEST_PROPERTY) for key, text in texts.items()}
    book.set_properties({**described, "created": _CREATED})


def _contents(sheet: Worksheet, document: Document, names: list[str], starts: list[int], *, book: _Book) -> None:
    titles = document.titles
    _write(sheet, 0, 0, document.title, book.format(_TITLE))
    _write(sheet, 1, 0, f"{document.subject}; {document.origin}", book.format(_GREY))
    _head(
        sheet, 3, [Column(document.translate(text)) for text in ("Sheet", "In the report", "What it holds")], book=book
    )
    lines = [
        (name, f"'{name}'!A1", titles.get(("Table", table.name), "—"), table.caption)
        for name, table in zip(names, document.tables, strict=True)
    ]
    lines += [
        (
            document.translate(SHEETS),
            f"'{document.translate(SHEETS)}'!A{start + 1}",
            titles["Sheet", each.name],
            each.caption,
        )
        for start, each in zip(starts, document.sheets, strict=True)
    ]
    for place, (name, target, title, caption) in enumerate(lines, start=4):
        sheet.write_url(place, 0, f"internal:{target}", book.format(_LINK), name)
        _write(sheet, place, 1, title, None)
        _write(sheet, place, 2, caption, None)
    sheet.freeze_panes(4, 0)
    _widths(sheet, (34, 14, 100))
    _paper(sheet, head=3)


def _alone(sheet: Worksheet, table: Table, *, translate: Callable[[str], str], book: _Book) -> None:
    """Write a table on its own sheet, its head in sight and ready to be filtered."""
    _table(sheet, table, start=0, translate=translate, book=book)
    sheet.freeze_panes(2, 1 if len(table.columns) > 2 else 0)
    if table.rows:
        sheet.autofilter(1, 0, len(table.rows) + 1, len(table.columns) - 1)
    _widths(sheet, [_width(column, [row[at] for row in table.rows[:200]]) for at, column in enumerate(table.columns)])
    _paper(sheet, head=1)


def _sheets(sheet: Worksheet, document: Document, starts: list[int], *, book: _Book) -> None:
    for start, each in zip(starts, document.sheets, strict=True):
        _table(
            sheet, as_table(each, translate=document.translate), start=start, translate=document.translate, book=book
        )
    _widths(sheet, (14, 50, 34, 40, 50, 14, 12, 14, 12))
    _paper(sheet, head=None)


def _starts(document: Document) -> list[int]:
    """Return the row of each calculation sheet's caption, from 0; one row stays empty between them."""
    starts = [0]
    for each in document.sheets:
        starts.append(starts[-1] + len(each.lines) + 3)
    return starts[:-1]


def _table(sheet: Worksheet, table: Table, *, start: int, translate: Callable[[str], str], book: _Book) -> None:
    """Write caption, head and rows from the row `start` on."""
    _write(sheet, start, 0, table.caption, book.format(_BOLD))
    _head(sheet, start + 1, table.columns, book=book)
    look = _look if len(table.rows) <= _LONG else _look_of_verdicts
    for place, row in enumerate(table.rows):
        muted = place in table.muted
        for at, (cell, column) in enumerate(zip(row, table.columns, strict=True)):
            shape = book.format(look(cell, column, muted=muted))
            _write(sheet, start + 2 + place, at, spell_out(cell, column, translate), shape)


def _head(sheet: Worksheet, place: int, columns: Iterable[Column], *, book: _Book) -> None:
    for at, column in enumerate(columns):
        side: Look = {"align": "right"} if column.kind == "number" else {"valign": "top"}
        _write(sheet, place, at, column.heading, book.format({**_HEAD, **side}))


def _look(cell: Cell, column: Column, *, muted: bool) -> Look:
    """Return how a cell looks: as the report shows it."""
    look: Look = {**_GREY, **_quoted(cell)} if muted else _look_of_verdicts(cell, column, muted=muted)
    if isinstance(cell, float) and isfinite(cell) and column.kind != "given":
        return {**look, "num_format": number_format(cell)}
    return {**look, **_WRAPPED} if isinstance(cell, str) and len(cell) > _WIDEST else look


def _look_of_verdicts(cell: Cell, column: Column, *, muted: bool) -> Look:
    """Return verdicts in their colours, anything else plain."""
    return _quoted(cell) if muted else {**_VERDICTS.get(outcome_colour(cell, column), {}), **_quoted(cell)}


def _quoted(cell: Cell) -> Look:
    """Return text that stays text also where somebody edits its cell."""
    return {"quote_prefix": 1} if isinstance(cell, str) and is_formula(cell) else {}


def _write(sheet: Worksheet, place: int, at: int, cell: Cell, look: Format | None) -> None:
    """Write a value at full precision, or text that is never taken for anything else."""
    if isinstance(cell, bool):
        sheet.write_boolean(place, at, cell, look)
    elif isinstance(cell, int | float) and isfinite(cell):
        sheet.write_number(place, at, cell, look)
    elif cell is not None and cell != "":
        _write_text(sheet, place, at, cell if isinstance(cell, str) else numeral(cell), look)


def _write_text(sheet: Worksheet, place: int, at: int, text: str, look: Format | None) -> None:
    shown = truncate(visible(text), _LONGEST_TEXT)
    if shown.startswith("<r>"):  # which xlsxwriter takes for markup of its own; in pieces it is text
        sheet.write_rich_string(place, at, *"<r", shown[2:], *([look] if look else []))
    else:
        sheet.write_string(place, at, shown, look)


def _width(column: Column, cells: Sequence[Cell]) -> int:
    """Return characters that a column needs: whole words of its head, texts, and numbers as they are shown."""
    words = [len(word) + 4 for word in column.heading.split()]
    texts = [len(cell) + 2 for cell in cells if isinstance(cell, str)]
    numbers = [len(str(cell)) + 2 for cell in cells if column.kind == "given" and not isinstance(cell, str)]
    return min(max([_NARROWEST + 2, *words, *texts, *numbers]), _WIDEST)


def _widths(sheet: Worksheet, widths: Iterable[int]) -> None:
    for place, width in enumerate(widths):
        sheet.set_column(place, place, width)


def _paper(sheet: Worksheet, *, head: int | None) -> None:
    """Set the sheet to print across the page, as wide as it, with the head on every page."""
    sheet.set_landscape()
    sheet.fit_to_pages(1, 0)
    if head is not None:
        sheet.repeat_rows(head)
