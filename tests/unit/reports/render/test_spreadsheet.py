"""The workbook as openpyxl reads it again."""

from __future__ import annotations

from pathlib import Path

import pytest
from openpyxl import load_workbook

from assess.results import Results
from reports.assessment import assessment
from reports.document import Column, Document, Section, Table
from reports.render.spreadsheet import unique, write_xlsx


def test_a_sheet_for_each_table_with_its_numbers(results: Results, tmp_path: Path) -> None:
    document = assessment(results)
    book = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))
    assert len(book.sheetnames) == len(document.tables) + 2
    rows = list(book["verdicts"].values)
    table = next(table for table in document.tables if table.name == "verdicts")
    assert rows[1] == tuple(column.heading for column in table.columns)
    assert len(rows) == len(table.rows) + 2
    for read, row in zip(rows[2:], table.rows, strict=True):  # the file holds 16 digits
        assert read == tuple(
            pytest.approx(cell, rel=1e-15) if isinstance(cell, float) else cell if cell != "" else None for cell in row
        )


def test_hostile_text_is_text(tmp_path: Path) -> None:
    texts = (
        "=cmd()",
        "@x",
        "<b>&",
        "a\x07b",
        "😀",
        "x" * 40_000,
        "#REF!",
        "$x$",
        "<r>&<b></r>",
        "_x0041_",
        "http://x.y",
    )
    table = Table("=t", "=c", (Column("=h"),), tuple((text,) for text in texts))
    document = Document("=title", "", "", "", "A4", (), (Section("s", 0, (table,)),), ())
    book = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))
    cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row if cell.value is not None]
    assert {cell.data_type for cell in cells} == {"s"}
    found = {str(cell.value) for cell in cells}
    assert {
        "=cmd()",
        "@x",
        "<b>&",
        "a⟨U+0007⟩b",
        "😀",
        "#REF!",
        "$x$",
        "<r>&<b></r>",
        "_x0041_",
        "http://x.y",
        "=title",
        "=h",
    } <= found


def test_sheet_names_are_valid_and_unique() -> None:
    names = unique(["a" * 50, "a" * 60, "A" * 31, "x/y:z[1]", "contents", "", "'"])
    assert len({name.lower() for name in names}) == len(names)
    assert all(1 <= len(name) <= 31 and not set(name) & set("[]:*?/\\'") for name in names)
    assert "contents" not in names


@pytest.mark.parametrize("name", ["\U0001f3db" * 40, "x" + "\U0001f3db" * 40, "History"])
def test_names_of_sheets_are_those_that_excel_takes(tmp_path: Path, name: str) -> None:
    table = Table(name, "c", (Column("h"),), (("a",),))
    document = Document("t", "", "", "", "A4", (), (Section("s", 0, (table, table)),), ())
    names = load_workbook(write_xlsx(document, tmp_path / "t.xlsx")).sheetnames
    assert all(len(each.encode("utf-16-le")) <= 2 * 31 and each.lower() != "history" for each in names)
    assert len({each.lower() for each in names}) == 4


@pytest.mark.parametrize("value", [float("inf"), float("-inf"), float("nan")])
def test_numbers_that_are_not_finite_are_text(tmp_path: Path, value: float) -> None:
    table = Table("t", "c", (Column("h", "", "number"),), ((value,),))
    document = Document("t", "", "", "", "A4", (), (Section("s", 0, (table,)),), ())
    cell = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))["t"]["A3"]
    assert cell.data_type == "s"
