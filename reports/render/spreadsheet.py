"""Tables as an Excel workbook: a contents sheet, one sheet a subject, and all calculation sheets on one."""

from __future__ import annotations

import datetime
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate
from math import isfinite
from pathlib import Path

from xlsxwriter import Workbook
from xlsxwriter.format import Format
from xlsxwriter.worksheet import Worksheet

from reports.document import Column, Document, Link, OutcomeCell, Table
from reports.figures.style import BANNER, FAIL, INK, MUTED, PASS
from reports.language.locale import Locale, decimals, numeral, truncate, visible
from reports.language.texts import Kind, Text, Verbatim, say
from reports.render.table_text import (
    NOTHING,
    PlainCell,
    PlainRows,
    PlainTables,
    is_numeric,
    plain_tables,
    program_and_stamp,
)
from spectra.formulas import is_formula

CONTENTS, SHEETS = say("contents"), say("calculation sheets")
MECHANISM, NONE = Column(say("Mechanism")), Verbatim("")
_HEADS = (Column(say("Sheet")), Column(say("In the report")), Column(say("What it holds")))
_LONGEST_TEXT, _LONGEST_NAME, _LONGEST_PROPERTY = 32_000, 31, 255
_RESERVED = "history"  # a name that Excel keeps for itself
_NARROWEST, _WIDEST = 9, 60  # columns [characters]
_LONG = 500  # rows; numbers of longer tables have no format, but where people look for a row
_MOST_TITLES = 4  # of tables in one that the contents list one by one
_MOST_LINKS, _LONGEST_LINK = 60_000, 2_000  # of a sheet, of which Excel opens no more; characters
_CREATED = datetime.datetime(2000, 1, 1)  # fixed: the same results give the same workbook

CellFormat = dict[str, str | int]
"""How a cell looks, in xlsxwriter's words."""
_BOLD: CellFormat = {"font_color": INK, "bold": 1}
_GREY: CellFormat = {"font_color": MUTED}
_LINK: CellFormat = {"font_color": "#00588a", "underline": 1}
_TITLE: CellFormat = {"bold": 1, "font_size": 14}
_OUTCOMES: dict[str, CellFormat] = {
    "pass": {"font_color": PASS, "bg_color": "#E3F1EC", "bold": 1},
    "fail": {"font_color": FAIL, "bg_color": "#FBE9E2", "bold": 1},
    "incomplete": {"font_color": BANNER["incomplete"], "bg_color": "#F8F0DD"},
    "comparison": {**_GREY, "italic": 1},
}
_HEAD: CellFormat = {**_BOLD, "bg_color": "#E3E8ED", "bottom": 1, "bottom_color": "#6B7680", "text_wrap": 1}
_WRAPPED: CellFormat = {"text_wrap": 1, "valign": "top"}


@dataclass(frozen=True)
class _Block:
    """What stands on a worksheet: tables in one, or a calculation sheet.

    table, rows : with its cells as plain values
    of : the blocks of the report that it shows
    """

    table: Table
    rows: PlainRows
    of: tuple[tuple[Kind, str], ...]


_Part = tuple[Text | None, Table, PlainRows]
"""A table of one of several parts, and what that is called; None for a table of the whole."""
_Worksheet = tuple[str, tuple[_Block, ...]]
"""The name of a worksheet and what stands on it, one below the other."""


@dataclass(frozen=True)
class _Book:
    """A workbook in the letters of a locale, that makes each look once."""

    book: Workbook
    locale: Locale
    made: dict[tuple[tuple[str, str | int], ...], Format] = field(default_factory=dict)

    def format(self, look: CellFormat) -> Format | None:
        """Return the format of a look; None for that of every cell."""
        key = tuple(look.items())
        if key and key not in self.made:
            self.made[key] = self.book.add_format(look)
        return self.made.get(key)

    def write(self, sheet: Worksheet, place: int, at: int, cell: PlainCell, look: CellFormat) -> None:
        """Write a value at full precision, or text that is never taken for anything else."""
        made = self.format(look)
        if isinstance(cell, bool):
            sheet.write_boolean(place, at, cell, made)
        elif isinstance(cell, int | float) and isfinite(cell):
            sheet.write_number(place, at, cell, made)
        elif cell is not None and cell != "":
            shown = truncate(visible(cell if isinstance(cell, str) else numeral(cell)), _LONGEST_TEXT)
            if shown.startswith("<r>"):  # which xlsxwriter takes for markup of its own; in pieces it is text
                sheet.write_rich_string(place, at, *"<r", shown[2:], *([made] if made else []))
            else:
                sheet.write_string(place, at, shown, made)


def write_xlsx(document: Document, path: Path, plain: PlainTables | None = None) -> Path:
    """Write every table of the document to a workbook at `path`; text is never taken for a formula.

    Parameters
    ----------
    document : of any tables
    path : of the workbook
    plain : of the document, where they are known
    """
    locale, found = document.writer, plain or plain_tables(document)
    contents, last = locale.text(CONTENTS), locale.text(SHEETS)
    listed = _worksheets(document, found, taken=(contents, last))
    sheets = tuple(_Block(table, rows, (("Sheet", table.name),)) for table, rows in found.sheets)
    with Workbook(str(path), {"in_memory": True}) as made:
        book = _Book(made, locale)
        made.set_properties(_properties(document))
        _contents(made.add_worksheet(contents), document, [*listed, (last, sheets)], book)
        for name, blocks in listed:
            sheet = made.add_worksheet(name)
            _write_blocks(sheet, blocks, book)
            if blocks[0].table.sifted:
                sheet.activate()  # what people look for a row in
        sheet = made.add_worksheet(last)
        for start, block in zip(_starts(sheets), sheets, strict=True):
            _table(sheet, block.table, block.rows, start, book)
        _finish(sheet, (14, 50, 34, 40, 50, 14, 12, 14, 12), head=None)
    return path


def _worksheets(document: Document, plain: PlainTables, *, taken: Iterable[str]) -> list[_Worksheet]:
    """Return the worksheets with their tables, those of several parts joined, the longest table last."""
    locale = document.writer
    subjects = {table: locale.text(subject) for subject, tables in document.worksheets for table in tables}
    found: dict[str, dict[tuple[str, ...], list[_Part]]] = {each: {} for each in subjects.values()}
    for table, rows in plain.tables:
        stem, part = next((each for each in document.parts if table.name.startswith(f"{each[0]}-")), ("", None))
        kind = table.name.removeprefix(f"{stem}-") if stem else table.name
        heads = (locale.heading(column.label, column.dimension) for column in table.columns)
        of_subject = found.setdefault(subjects.get(kind, table.name), {})
        of_subject.setdefault((f"*-{kind}" if stem else table.name, *heads), []).append((part, table, rows))
    joined = [
        (subject, sorted((_join(parts, locale) for parts in alike.values()), key=_length))
        for subject, alike in found.items()
        if alike
    ]
    names = worksheet_names([name for name, _ in joined], taken=taken)
    return [(name, tuple(blocks)) for name, (_, blocks) in zip(names, joined, strict=True)]


def _join(tables: Sequence[_Part], locale: Locale) -> _Block:
    """Return tables of the same columns as one, the part that each is of in the first column."""
    shown: tuple[tuple[Kind, str], ...] = tuple(("Table", table.name) for _, table, _ in tables)
    part, first, rows = tables[0]
    if part is None:  # two tables of the whole have two names
        return _Block(first, rows, shown)
    parts = [each or NONE for each, table, _ in tables for _ in table.rows]
    cells = [row for _, table, _ in tables for row in table.rows]
    before = accumulate((len(table.rows) for _, table, _ in tables), initial=0)
    muted = frozenset(
        start + place for start, (_, table, _) in zip(before, tables, strict=False) for place in table.muted
    )
    joined = replace(
        first,
        columns=(MECHANISM, *first.columns),
        rows=tuple((part, *row) for part, row in zip(parts, cells, strict=True)),
        muted=muted,
    )
    plain = [row for _, _, rows in tables for row in rows]
    return _Block(joined, tuple((locale.text(part), *row) for part, row in zip(parts, plain, strict=True)), shown)


def _length(block: _Block) -> int:
    return len(block.table.rows)


def _starts(blocks: Sequence[_Block]) -> list[int]:
    """Return the row in which each block begins; one row stays empty between them."""
    return list(accumulate((len(each.table.rows) + 3 for each in blocks), initial=0))[:-1]


def worksheet_names(names: list[str], *, taken: Iterable[str] = ("contents", "calculation sheets")) -> list[str]:
    """Return valid worksheet names, no two alike nor `taken` in any case: at most 31 characters, no []:*?/\\."""
    used, made = {_RESERVED, *(name.lower() for name in taken)}, []
    for given in names:
        plain = _cut(re.sub(r"[\[\]:*?/\\']", "-", visible(given)), _LONGEST_NAME) or "table"
        name, number = plain, 2
        while name.lower() in used:
            name, number = f"{_cut(plain, _LONGEST_NAME - 1 - len(str(number)))}~{number}", number + 1
        used.add(name.lower())
        made.append(name)
    return made


def number_format(value: float, figures: int) -> str:
    """Return the format in which a spreadsheet shows a number as the report does: to so many figures."""
    places = decimals(value, figures=figures) if value else 0
    if places is None:
        return f"0.{'0' * (figures - 1)}E+00"
    return f"0.{'0' * places}" if places else "0"


def _cut(name: str, length: int) -> str:
    """Return the first `length` characters as Excel counts them, in units of UTF-16: an emoji has two."""
    return name.encode("utf-16-le")[: 2 * length].decode("utf-16-le", "ignore")


def _properties(document: Document) -> dict[str, object]:
    locale = document.writer
    texts = {"title": locale.text(document.title), "subject": locale.text(document.subject)}
    texts |= {"author": document.program, "keywords": document.stamp}
    return {"created": _CREATED, **{key: truncate(visible(text), _LONGEST_PROPERTY) for key, text in texts.items()}}


def _contents(sheet: Worksheet, document: Document, listed: Iterable[_Worksheet], book: _Book) -> None:
    locale = book.locale
    book.write(sheet, 0, 0, locale.text(document.title), _TITLE)
    book.write(sheet, 1, 0, f"{locale.text(document.subject)}; {locale.text(program_and_stamp(document))}", _GREY)
    _head(sheet, 3, _HEADS, [False] * 3, book)
    lines = [
        (name, start, block) for name, blocks in listed for start, block in zip(_starts(blocks), blocks, strict=True)
    ]
    for place, (name, start, block) in enumerate(lines, start=4):
        sheet.write_url(place, 0, f"internal:'{name}'!A{start + 1}", book.format(_LINK), name)
        numbered = [locale.title(kind, each) for kind, each in block.of if (kind, each) in locale.titles]
        shown = ", ".join(numbered) if len(numbered) < _MOST_TITLES else f"{numbered[0]} … {numbered[-1]}"
        book.write(sheet, place, 1, shown or NOTHING, {})
        book.write(sheet, place, 2, locale.text(block.table.caption), {})
    sheet.freeze_panes(4, 0)
    _finish(sheet, (34, 14, 100), head=3)


def _write_blocks(sheet: Worksheet, blocks: Sequence[_Block], book: _Book) -> None:
    """Write tables on a sheet, ready to be filtered where there is one, and then with its head in sight."""
    widths = dict[int, int]()
    for start, block in zip(_starts(blocks), blocks, strict=True):
        table, few = block.table, block.rows[:200]
        _table(sheet, table, block.rows, start, book)
        for at, column in enumerate(table.columns):
            widths[at] = max(widths.get(at, 0), _width(column, [row[at] for row in few], book))
    if table.rows:  # an Excel sheet has one filter: of the longest table, which is the last
        sheet.autofilter(start + 1, 0, start + len(table.rows) + 1, len(table.columns) - 1)
    if len(blocks) == 1:
        sheet.freeze_panes(2, 1 if len(table.columns) > 2 else 0)
    _finish(sheet, [widths[at] for at in sorted(widths)], head=1 if len(blocks) == 1 else None)


def _table(sheet: Worksheet, table: Table, rows: PlainRows, start: int, book: _Book) -> None:
    """Write caption, head and rows from the row `start` on; rows: the cells as plain values."""
    numeric = [is_numeric(cells) for cells in zip(*table.rows, strict=True)] or [False] * len(table.columns)
    book.write(sheet, start, 0, book.locale.text(table.caption), _BOLD)
    _head(sheet, start + 1, table.columns, numeric, book)
    links = sum(any(isinstance(cell, Link) for cell in cells) for cells in zip(*table.rows, strict=True))
    for place, (row, plain_row) in enumerate(zip(table.rows, rows, strict=True)):
        for at, (cell, plain, column) in enumerate(zip(row, plain_row, table.columns, strict=True)):
            if isinstance(cell, Link):
                _link(sheet, start + 2 + place, at, cell, book, few=place * links < _MOST_LINKS)
                continue
            colours = (
                _GREY if place in table.muted else _OUTCOMES[cell.outcome] if isinstance(cell, OutcomeCell) else {}
            )
            shape = _shape(plain, column) if table.sifted or len(table.rows) <= _LONG else {}
            book.write(sheet, start + 2 + place, at, plain, {**colours, **_quoted(plain), **shape})


def _link(sheet: Worksheet, place: int, at: int, link: Link, book: _Book, *, few: bool) -> None:
    """Write a link; its text alone where there are more than Excel opens."""
    text = visible(book.locale.text(link.text))
    if few and len(link.address) < _LONGEST_LINK:
        sheet.write_url(place, at, f"external:{link.address}", book.format(_LINK), text)
    else:
        book.write(sheet, place, at, text, {})


def _head(sheet: Worksheet, place: int, columns: Iterable[Column], numeric: Iterable[bool], book: _Book) -> None:
    for at, (column, number) in enumerate(zip(columns, numeric, strict=True)):
        side: CellFormat = {"align": "right"} if number else {"valign": "top"}
        book.write(sheet, place, at, book.locale.heading(column.label, column.dimension), {**_HEAD, **side})


def _shape(cell: PlainCell, column: Column) -> CellFormat:
    """Return a number to the figures of its column, and a long text in several lines."""
    if isinstance(cell, float) and isfinite(cell):
        return {"num_format": number_format(cell, column.figures)}
    return _WRAPPED if isinstance(cell, str) and len(cell) > _WIDEST else {}


def _quoted(cell: PlainCell) -> CellFormat:
    """Return text that stays text also where somebody edits its cell."""
    return {"quote_prefix": 1} if isinstance(cell, str) and is_formula(cell) else {}


def _width(column: Column, cells: Sequence[PlainCell], book: _Book) -> int:
    """Return characters that a column needs: whole words of its head, and texts; numbers have room in the narrowest."""
    words = [len(word) + 4 for word in book.locale.heading(column.label, column.dimension).split()]
    return min(max([_NARROWEST + 2, *words, *(len(text) + 2 for text in cells if isinstance(text, str))]), _WIDEST)


def _finish(sheet: Worksheet, widths: Iterable[int], *, head: int | None) -> None:
    """Set the widths, and the sheet to print across the page, as wide as it, with the head on every page."""
    for place, width in enumerate(widths):
        sheet.set_column(place, place, width)
    sheet.set_landscape()
    sheet.fit_to_pages(1, 0)
    if head is not None:
        sheet.repeat_rows(head)
