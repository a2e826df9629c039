"""Every cell of every table and sheet of a document stands in the page, the workbook and the CSV files."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from lxml import html
from openpyxl import load_workbook

from reports.document import Table
from reports.language.locale import Locale, visible
from reports.render.spreadsheet import write_xlsx
from reports.render.table_text import PlainCell, column_texts, csv_field, sheet_as_table, sheet_rows, write_csv
from tests.support.letters import without_spaces
from tests.support.sample_document import plain_rows, sample_document, write_page

LOCALES = pytest.mark.parametrize("locale", [Locale(), Locale("it"), Locale("en", "US")], ids=str)


@LOCALES
def test_csv(tmp_path: Path, locale: Locale) -> None:
    document = sample_document(locale)
    write_csv(document, tmp_path)
    for table in (*document.tables, *(sheet_as_table(sheet, document.writer) for sheet in document.sheets)):
        with (tmp_path / f"{table.name}.csv").open(encoding="utf-8", newline="") as stream:
            _, *rows = csv.reader(stream)
        assert [row[:-1] for row in rows] == [
            [csv_field(cell) for cell in row] for row in plain_rows(table, document.writer)
        ]


@LOCALES
def test_workbook(tmp_path: Path, locale: Locale) -> None:
    document = sample_document(locale)
    book = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))
    for table in document.tables:
        rows = list(book[table.name].iter_rows(min_row=3, values_only=True))
        assert [list(map(read_as, row)) for row in plain_rows(table, document.writer)] == list(map(list, rows))
    (sheet,) = document.sheets
    rows = list(book[book.sheetnames[-1]].iter_rows(min_row=3, values_only=True))
    assert [list(map(read_as, row)) for row in plain_rows(sheet_as_table(sheet, document.writer), document.writer)] == [
        list(row) for row in rows
    ]


def read_as(cell: PlainCell) -> object:
    """A cell as a spreadsheet holds it: to 16 digits."""
    if isinstance(cell, str):
        return visible(cell) or None
    return pytest.approx(cell, rel=1e-15) if isinstance(cell, float) else cell


@LOCALES
def test_page(tmp_path: Path, locale: Locale) -> None:
    document = sample_document(locale)
    tree = html.parse(write_page(document, tmp_path / "page.html")).getroot()
    printed = [block for block in document.blocks if isinstance(block, Table)]
    for number, table in enumerate(printed, start=1):
        rows = tree.xpath(f"//table[@id='table-{number}']/tbody/tr")
        columns = [
            column_texts(tuple(row[place] for row in table.rows), column, document.writer)
            for place, column in enumerate(table.columns)
        ]
        written = [[visible(text) for text in row] for row in zip(*columns, strict=True)]
        assert [[cell.text_content() for cell in row] for row in rows] == written
    (sheet,) = document.sheets
    text = without_spaces(tree.xpath("//table[@id='sheet-1']/tbody")[0].text_content())
    for row in sheet_rows(sheet.steps, document.writer):
        assert without_spaces(visible(row.description)) in text
        assert without_spaces(row.result) in text
        assert without_spaces(row.beside) in text
