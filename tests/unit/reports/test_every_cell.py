"""Every cell of every table of the document stands in the PDF, the page, the workbook and the CSV files."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest
from lxml import html
from openpyxl import load_workbook
from pypdf import PdfReader
from reports.render.sheet_table import as_table

from reports.document import Cell, Document, Sheet, Table
from reports.figures.font import printable
from reports.language.lettering import truncate, visible
from reports.language.numerals import cell_text, step_result
from reports.render.csv import field, write_csv
from reports.render.pdf import write_pdf
from reports.render.spreadsheet import SHEETS, unique, write_xlsx
from reports.render.vector import FigureMarks


def printed(document: Document) -> list[Table]:
    return [block for block in document.blocks if isinstance(block, Table)]


def read_as(cell: Cell) -> object:
    """A cell of the document as a spreadsheet holds it: to 16 digits."""
    if isinstance(cell, str):
        return visible(cell) or None
    return pytest.approx(cell, rel=1e-15) if isinstance(cell, float) else cell


def squeezed(text: str) -> str:
    return "".join(text.split())


def test_csv(document: Document, tmp_path: Path) -> None:
    write_csv(document, tmp_path)
    for table in (*document.tables, *map(as_table, document.sheets)):
        with (tmp_path / f"{table.name}.csv").open(encoding="utf-8", newline="") as stream:
            head, *rows = csv.reader(stream)
        assert head == [column.heading for column in table.columns]
        assert rows == [[field(cell) for cell in row] for row in table.rows]
        numbers = [
            (read, cell)
            for line, row in zip(rows, table.rows, strict=True)
            for read, cell in zip(line, row, strict=True)
        ]
        assert all(float(read) == cell for read, cell in numbers if isinstance(cell, float))


def test_workbook(document: Document, tmp_path: Path) -> None:
    book = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))
    for name, table in zip(unique([table.name for table in document.tables]), document.tables, strict=True):
        assert list(cells_of(book[name].values, table, start=0)) == [[*map(read_as, row)] for row in table.rows]
    start = 0
    for table in map(as_table, document.sheets):
        rows = cells_of(list(book[SHEETS].values)[: start + 2 + len(table.rows)], table, start=start)
        assert list(rows) == [[*map(read_as, row)] for row in table.rows]
        start += len(table.rows) + 3


def cells_of(values: object, table: Table, *, start: int) -> Iterator[list[object]]:
    """The rows below the caption and the head, which are held against the table too."""
    caption, head, *rows = list(values)[start:]  # type: ignore[call-overload]
    wide = len(table.columns)
    assert caption[0] == visible(table.caption)
    assert list(head[:wide]) == [column.heading for column in table.columns]
    assert not any(cell is not None for row in rows for cell in row[wide:])
    yield from (list(row[:wide]) for row in rows)


def test_page(document: Document, page: Path) -> None:
    tree = html.document_fromstring(page.read_text(encoding="utf-8"))
    found = tree.xpath("//table[contains(@class, 'sortable')]")
    for number, (element, table) in enumerate(zip(found, printed(document), strict=True), start=1):
        assert element.findtext("caption/span/b") == f"Table {number}."
        assert element.find("caption").text_content() == f"Table {number}. {visible(table.caption)}"
        assert [head.text_content() for head in element.findall("thead/tr/th")] == [c.heading for c in table.columns]
        for line, row in zip(element.findall("tbody/tr"), table.rows, strict=True):
            texts = [visible(cell_text(cell, column.kind)) for cell, column in zip(row, table.columns, strict=True)]
            assert [cell.text_content() for cell in line] == texts
            values = [cell.get("data-value") for cell in line]
            assert values == [repr(cell) if type(cell) in (int, float) else None for cell in row]


def test_sheets_of_the_page(document: Document, page: Path) -> None:
    tree = html.document_fromstring(page.read_text(encoding="utf-8"))
    found = tree.xpath("//table[contains(@class, 'sheet')]")
    for element, sheet in zip(found, document.sheets, strict=True):
        for row, line in zip(element.findall("tbody/tr"), sheet.lines, strict=True):
            text = row.text_content()
            assert text.endswith(step_result(line.value, line.unit))
            for part in (line.clause, line.substituted, line.description):
                assert plain(part) in plain(text)


def plain(formula: str) -> str:
    """A formula without the marks of its indices and powers."""
    return squeezed(formula.translate(str.maketrans("", "", "_^{}")))


def test_pdf(document: Document, drawings: Mapping[str, FigureMarks], tmp_path: Path) -> None:
    """Row by row, in the order of the document; a row is whole on its page."""
    path = write_pdf(document, tmp_path / "report.pdf", drawings=drawings)
    text = squeezed("".join(page.extract_text() for page in PdfReader(path).pages))
    place = 0
    for block in document.blocks:
        for line in lines_of(block):
            assert line in text[place:], f"{block.name}: {line}"  # type: ignore[union-attr]
            place = text.index(line, place) + len(line)


def lines_of(block: object) -> Iterator[str]:
    """The rows of a table or a sheet as they are printed, without blanks."""
    if isinstance(block, Table):
        for row in block.rows:
            texts = (cell_text(cell, column.kind) for cell, column in zip(row, block.columns, strict=True))
            yield squeezed("".join(printable(truncate(text, 400)) for text in texts))
    if isinstance(block, Sheet):
        yield from (squeezed(step_result(line.value, line.unit)) for line in block.lines)
