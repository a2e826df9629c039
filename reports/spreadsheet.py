"""Tables as an Excel workbook: a contents sheet, one sheet per table, and all calculation sheets on one."""

from __future__ import annotations

import datetime
import re
from io import BytesIO
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from openpyxl import Workbook
from openpyxl.cell import Cell as XlsxCell
from openpyxl.styles import Font, PatternFill
from openpyxl.utils import get_column_letter
from openpyxl.worksheet.worksheet import Worksheet

from reports.document import Cell, Document, Table
from reports.lettering import shortened, visible
from reports.sheets import as_table

_LONGEST_TEXT, _LONGEST_NAME = 32_000, 31
_CREATED = datetime.datetime(2000, 1, 1)  # fixed: the same results give the same workbook
_HEAD = PatternFill("solid", start_color="E3E8ED")


def write_xlsx(document: Document, path: Path) -> Path:
    """Write every table of the document to a workbook at `path`; text is never taken for a formula."""
    book = Workbook()
    book.properties.created = book.properties.modified = _CREATED
    book.properties.creator = document.program
    contents = book.active
    assert isinstance(contents, Worksheet)  # a new workbook has one
    contents.title = "contents"
    names = unique([table.name for table in document.tables])
    _contents(contents, document, names)
    for table, name in zip(document.tables, names, strict=True):
        _table(book.create_sheet(name), table)
    _sheets(book.create_sheet("calculation sheets"), document)
    whole = BytesIO()
    book.save(whole)
    _undated(whole, path)
    return path


def unique(names: list[str]) -> list[str]:
    """Valid worksheet names, no two alike without regard to case: at most 31 characters, none of []:*?/\\."""
    taken, made = {"contents", "calculation sheets"}, []
    for wanted in names:
        plain = re.sub(r"[\[\]:*?/\\']", "-", visible(wanted))[:_LONGEST_NAME] or "table"
        name, number = plain, 2
        while name.lower() in taken:
            name, number = f"{plain[: _LONGEST_NAME - 1 - len(str(number))]}~{number}", number + 1
        taken.add(name.lower())
        made.append(name)
    return made


def _undated(whole: BytesIO, path: Path) -> None:
    """The workbook again, without the time at which it was saved."""
    fixed = f"{_CREATED.isoformat()}Z".encode()
    with ZipFile(whole) as dated, ZipFile(path, "w", ZIP_DEFLATED) as undated:
        for entry in dated.infolist():
            content = dated.read(entry)
            if entry.filename == "docProps/core.xml":
                content = re.sub(rb"(<dcterms:modified[^>]*>)[^<]*", rb"\g<1>" + fixed, content)
            undated.writestr(ZipInfo(entry.filename, _CREATED.timetuple()[:6]), content, ZIP_DEFLATED)


def _contents(sheet: Worksheet, document: Document, names: list[str]) -> None:
    _row(sheet, 1, (document.title,), bold=True)
    _row(sheet, 2, (f"{document.subject}; {document.program}",))
    _row(sheet, 4, ("Sheet", "Table"), bold=True)
    for place, (name, table) in enumerate(zip(names, document.tables, strict=True), start=5):
        _row(sheet, place, (name, table.caption))
        link = sheet.cell(place, 1)
        link.hyperlink = f"#'{name}'!A1"
        link.font = Font(color="0072B2", underline="single")
    sheet.column_dimensions["A"].width, sheet.column_dimensions["B"].width = 34, 100


def _table(sheet: Worksheet, table: Table) -> None:
    _row(sheet, 1, (table.caption,))
    _row(sheet, 2, tuple(column.heading for column in table.columns), bold=True)
    for place, row in enumerate(table.rows, start=3):
        _row(sheet, place, row)
    sheet.freeze_panes = "A3"
    for place, column in enumerate(table.columns, start=1):
        longest = max([len(column.heading), *(len(str(row[place - 1])) for row in table.rows[:200])])
        sheet.column_dimensions[get_column_letter(place)].width = min(max(9, longest + 2), 60)


def _sheets(sheet: Worksheet, document: Document) -> None:
    place = 1
    for each in map(as_table, document.sheets):
        _row(sheet, place, (each.caption,), bold=True)
        _row(sheet, place + 1, tuple(column.heading for column in each.columns), bold=True)
        for offset, row in enumerate(each.rows, start=2):
            _row(sheet, place + offset, row)
        place += len(each.rows) + 3
    for letter, width in zip("ABCDEFG", (14, 50, 34, 40, 50, 14, 12), strict=True):
        sheet.column_dimensions[letter].width = width


def _row(sheet: Worksheet, place: int, cells: tuple[Cell, ...], *, bold: bool = False) -> None:
    for column, value in enumerate(cells, start=1):
        cell = sheet.cell(place, column)
        assert isinstance(cell, XlsxCell)  # no merged cells here
        _fill(cell, value)
        if bold:
            cell.font = Font(bold=True)
            cell.fill = _HEAD


def _fill(cell: XlsxCell, value: Cell) -> None:
    if not isinstance(value, str):
        cell.value = value
        return
    cell.value = shortened(visible(value), _LONGEST_TEXT)
    cell.data_type = "s"  # also where it begins with "="
