"""Tables as an Excel workbook: a contents sheet, one sheet per table, and all calculation sheets on one."""

from __future__ import annotations

import datetime
import re
from collections.abc import Callable, Iterable, Sequence
from io import BytesIO
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from openpyxl import Workbook
from openpyxl.cell import Cell as XlsxCell
from openpyxl.styles import Alignment, Border, Font, PatternFill, Side
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.properties import PageSetupProperties
from openpyxl.worksheet.worksheet import Worksheet

from reports.document import Cell, Column, Document, Table
from reports.lettering import shortened, visible
from reports.numerals import FIGURES, decimals
from reports.sheets import as_table
from reports.style import FAIL, INK, MUTED, PASS
from reports.worded import in_words

CONTENTS, SHEETS = "contents", "calculation sheets"
_LONGEST_TEXT, _LONGEST_NAME, _LONGEST_PROPERTY = 32_000, 31, 255
_NARROWEST, _WIDEST = 9, 60  # columns [characters]
_LONG = 500  # rows; numbers of longer tables stand as they are, to be computed with
_CREATED = datetime.datetime(2000, 1, 1)  # fixed: the same results give the same workbook


def _font(colour: str = INK, *, bold: bool = False, underline: bool = False) -> Font:
    return Font(color=colour.removeprefix("#"), bold=bold, underline="single" if underline else None)


_BOLD, _GREY, _LINK = _font(bold=True), _font(MUTED), _font("#00588a", underline=True)
_VERDICTS = {"pass": _font(PASS, bold=True), "fail": _font(FAIL, bold=True)}
_HEAD = PatternFill("solid", start_color="E3E8ED")
_RULE = Border(bottom=Side("thin", color="6B7680"))
_WRAPPED, _RIGHT = Alignment(wrap_text=True, vertical="top"), Alignment(wrap_text=True, horizontal="right")


def write_xlsx(document: Document, path: Path) -> Path:
    """Write every table of the document to a workbook at `path`; text is never taken for a formula."""
    book = Workbook()
    _describe(book, document)
    contents = book.active
    assert isinstance(contents, Worksheet)  # a new workbook has one
    own = (document.said(CONTENTS), document.said(SHEETS))
    contents.title = own[0]
    names = unique([table.name for table in document.tables], taken=own)
    starts = _starts(document)
    _contents(contents, document, names, starts)
    for table, name in zip(document.tables, names, strict=True):
        _alone(book.create_sheet(name), table, said=document.said)
    _sheets(book.create_sheet(own[1]), document, starts)
    whole = BytesIO()
    book.save(whole)
    _undated(whole, path)
    return path


def unique(names: list[str], *, taken: Iterable[str] = (CONTENTS, SHEETS)) -> list[str]:
    """Valid worksheet names, no two alike nor `taken` without regard to case: at most 31 characters, no []:*?/\\."""
    used, made = set(taken), []
    for wanted in names:
        plain = re.sub(r"[\[\]:*?/\\']", "-", visible(wanted))[:_LONGEST_NAME] or "table"
        name, number = plain, 2
        while name.lower() in used:
            name, number = f"{plain[: _LONGEST_NAME - 1 - len(str(number))]}~{number}", number + 1
        used.add(name.lower())
        made.append(name)
    return made


def number_format(value: float) -> str:
    """The format in which a spreadsheet shows a number as the report does: to four figures."""
    places = decimals(value, figures=FIGURES)
    if places is None:
        return f"0.{'0' * (FIGURES - 1)}E+00"
    return "0" if places == 0 else f"0.{'0' * places}"


def _describe(book: Workbook, document: Document) -> None:
    about = book.properties
    about.created = about.modified = _CREATED
    about.creator = shortened(visible(document.program), _LONGEST_PROPERTY)
    about.title = shortened(visible(document.title), _LONGEST_PROPERTY)
    about.subject = shortened(visible(document.subject), _LONGEST_PROPERTY)


def _undated(whole: BytesIO, path: Path) -> None:
    """The workbook again, without the time at which it was saved."""
    fixed = f"{_CREATED.isoformat()}Z".encode()
    with ZipFile(whole) as dated, ZipFile(path, "w", ZIP_DEFLATED) as undated:
        for entry in dated.infolist():
            content = dated.read(entry)
            if entry.filename == "docProps/core.xml":
                content = re.sub(rb"(<dcterms:modified[^>]*>)[^<]*", rb"\g<1>" + fixed, content)
            undated.writestr(ZipInfo(entry.filename, _CREATED.timetuple()[:6]), content, ZIP_DEFLATED)


def _contents(sheet: Worksheet, document: Document, names: list[str], starts: list[int]) -> None:
    titles = document.titles
    _text(sheet, 1, (document.title,), font=Font(bold=True, size=14))
    _text(sheet, 2, (f"{document.subject}; {document.program}",), font=_GREY)
    _head(sheet, 4, [Column(document.said(text)) for text in ("Sheet", "In the report", "What it holds")])
    lines = [
        (name, f"'{name}'!A1", titles.get(("Table", table.name), "—"), table.caption)
        for name, table in zip(names, document.tables, strict=True)
    ]
    lines += [
        (document.said(SHEETS), f"'{document.said(SHEETS)}'!A{start}", titles["Sheet", each.name], each.caption)
        for start, each in zip(starts, document.sheets, strict=True)
    ]
    for place, (name, target, title, caption) in enumerate(lines, start=5):
        _text(sheet, place, (name, title, caption))
        sheet.cell(place, 1).hyperlink = f"#{target}"
        sheet.cell(place, 1).font = _LINK
    sheet.freeze_panes = "A5"
    _widths(sheet, (34, 14, 100))
    _paper(sheet, rows="4:4")


def _alone(sheet: Worksheet, table: Table, *, said: Callable[[str], str]) -> None:
    """A table on its own sheet, its head in sight and ready to be filtered."""
    _table(sheet, table, start=1, said=said)
    sheet.freeze_panes = "B3" if len(table.columns) > 2 else "A3"
    if table.rows:
        sheet.auto_filter.ref = f"A2:{get_column_letter(len(table.columns))}{len(table.rows) + 2}"
    _widths(sheet, [_width(column, [row[at] for row in table.rows[:200]]) for at, column in enumerate(table.columns)])
    _paper(sheet, rows="2:2")


def _sheets(sheet: Worksheet, document: Document, starts: list[int]) -> None:
    for start, each in zip(starts, document.sheets, strict=True):
        _table(sheet, as_table(each, said=document.said), start=start, said=document.said)
    _widths(sheet, (14, 50, 34, 40, 50, 14, 12))
    _paper(sheet, rows=None)


def _starts(document: Document) -> list[int]:
    """The row of each calculation sheet's caption; one row stays empty between them."""
    starts = [1]
    for each in document.sheets:
        starts.append(starts[-1] + len(each.lines) + 3)
    return starts[:-1]


def _table(sheet: Worksheet, table: Table, *, start: int, said: Callable[[str], str]) -> None:
    """Caption, head and rows from the row `start` on."""
    fill = _fill if len(table.rows) <= _LONG else _fill_plainly
    _text(sheet, start, (table.caption,), font=_BOLD)
    _head(sheet, start + 1, table.columns)
    for place, row in enumerate(table.rows):
        for at, (value, column) in enumerate(zip(row, table.columns, strict=True), start=1):
            fill(sheet, start + 2 + place, at, in_words(value, column, said), column, muted=place in table.muted)
            if column.kind == "verdict" and value in _VERDICTS and place not in table.muted:
                _cell(sheet, start + 2 + place, at).font = _VERDICTS[str(value)]


def _head(sheet: Worksheet, place: int, columns: Iterable[Column]) -> None:
    for at, column in enumerate(columns, start=1):
        cell = _cell(sheet, place, at)
        _write(cell, column.heading)
        cell.font, cell.fill, cell.border = _BOLD, _HEAD, _RULE
        cell.alignment = _RIGHT if column.kind == "number" else _WRAPPED


def _text(sheet: Worksheet, place: int, texts: Iterable[str], *, font: Font | None = None) -> None:
    for at, text in enumerate(texts, start=1):
        cell = _cell(sheet, place, at)
        _write(cell, text)
        if font is not None:
            cell.font = font


def _fill(sheet: Worksheet, place: int, at: int, value: Cell, column: Column, *, muted: bool) -> None:
    """A value as the report shows it, at full precision."""
    _fill_plainly(sheet, place, at, value, column, muted=muted)
    cell = _cell(sheet, place, at)
    if isinstance(value, float) and column.kind != "given":
        cell.number_format = number_format(value)
    if isinstance(value, str) and len(value) > _WIDEST:
        cell.alignment = _WRAPPED
    if muted:
        cell.font = _GREY


def _fill_plainly(sheet: Worksheet, place: int, at: int, value: Cell, _: Column, *, muted: bool) -> None:
    """A value alone."""
    if isinstance(value, str):
        _write(_cell(sheet, place, at), value)
    elif value is not None:
        sheet.cell(place, at, value)


def _write(cell: XlsxCell, text: str) -> None:
    cell.value = shortened(visible(text), _LONGEST_TEXT)
    cell.data_type = "s"  # also where it begins with "="


def _cell(sheet: Worksheet, place: int, at: int) -> XlsxCell:
    cell = sheet.cell(place, at)
    assert isinstance(cell, XlsxCell)  # no merged cells here
    return cell


def _width(column: Column, cells: Sequence[Cell]) -> int:
    """Characters that a column needs: whole words of its head, texts, and numbers as they are shown."""
    words = [len(word) + 4 for word in column.heading.split()]
    texts = [len(cell) + 2 for cell in cells if isinstance(cell, str)]
    numbers = [len(str(cell)) + 2 for cell in cells if column.kind == "given" and not isinstance(cell, str)]
    return min(max([_NARROWEST + 2, *words, *texts, *numbers]), _WIDEST)


def _widths(sheet: Worksheet, widths: Iterable[int]) -> None:
    for place, width in enumerate(widths, start=1):
        sheet.column_dimensions[get_column_letter(place)].width = width


def _paper(sheet: Worksheet, *, rows: str | None) -> None:
    """Printed across the page, as wide as it, with the head on every page."""
    sheet.page_setup.orientation = "landscape"
    sheet.sheet_properties.pageSetUpPr = PageSetupProperties(fitToPage=True)
    sheet.page_setup.fitToHeight = 0
    sheet.print_title_rows = rows
