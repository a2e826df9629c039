"""The workbook as openpyxl reads it again."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from openpyxl import load_workbook

from reports.document import NOTHING, Cell, Column, Document, OutcomeCell, Section, Table
from reports.language.locale import Locale
from reports.language.texts import Verbatim, quantity, say
from reports.render.spreadsheet import worksheet_names, write_xlsx
from tests.support.sample_document import HOSTILE, plain_rows, sample_document


def with_table(table: Table, *more: Table, title: str = "t") -> Document:
    section = Section(Verbatim("s"), 0, (table, *more))
    return Document(Verbatim(title), NOTHING, "", "p", "A4", (), (section,))


def one_column(name: str, *cells: Cell, label: str = "h", dimension: str = "") -> Table:
    return Table(name, NOTHING, (Column(Verbatim(label), dimension),), tuple((cell,) for cell in cells))


@pytest.mark.parametrize("locale", [Locale(), Locale("it", "US")])
def test_a_sheet_for_each_table_with_its_numbers(tmp_path: Path, locale: Locale) -> None:
    document = sample_document(locale)
    book = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))
    assert len(book.sheetnames) == len(document.tables) + 2
    for table in document.tables:
        rows = list(book[table.name].values)
        assert len(rows) == len(table.rows) + 2
        for read, plain in zip(rows[2:], plain_rows(table, document.writer), strict=True):  # the file holds 16 digits
            numbers = [(a, b) for a, b in zip(read, plain, strict=True) if isinstance(b, float)]
            assert all(a == pytest.approx(b, rel=1e-15) for a, b in numbers)
            assert len(numbers) == sum(column.dimension != "" for column in table.columns)


def test_tables_of_several_mechanisms_are_one_on_the_sheet_of_their_subject(tmp_path: Path) -> None:
    tables = one_column("01-a-loads", 1.5), one_column("02-b-loads", 2.5, 3.5), one_column("site", 0.1)
    whole = one_column("all", *map(float, range(4)))
    document = replace(
        with_table(*tables, whole, one_column("alone", 9.0)),
        worksheets=((say("Mechanisms"), ("loads", "site", "all")), (say("Curves"), ("curves",))),
        parts=(("01-a", Verbatim("M1 A")), ("02-b", Verbatim("M2 B"))),
    )
    book = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))
    assert book.sheetnames == ["contents", "Mechanisms", "alone", "calculation sheets"]
    rows = [row for row in book["Mechanisms"].values if any(cell is not None for cell in row)]
    assert rows[:2] == [("h", None), (0.1, None)]
    assert rows[2:6] == [("Mechanism", "h"), ("M1 A", 1.5), ("M2 B", 2.5), ("M2 B", 3.5)]
    assert book["Mechanisms"].auto_filter.ref == "A12:A16"  # the longest table is the last
    listed = [row for row in book["contents"].values if row[0] == "Mechanisms"]
    assert [row[1] for row in listed] == ["Table\xa03", "Table\xa01, Table\xa02", "Table\xa04"]


def test_outcomes_are_text_in_their_colours_and_numbers_have_the_figures_of_their_column(tmp_path: Path) -> None:
    cells: tuple[Cell, ...] = (OutcomeCell("pass", say("holds")), OutcomeCell("fail", quantity(1.31)), 12.3456)
    book = load_workbook(write_xlsx(with_table(one_column("t", *cells)), tmp_path / "t.xlsx"))
    holds, fails, number = (book["t"][f"A{row}"] for row in (3, 4, 5))
    assert [cell.value for cell in (holds, fails, number)] == ["holds", 1.31, 12.3456]
    assert holds.fill.fgColor.rgb != fails.fill.fgColor.rgb
    assert number.number_format == "0.00"


def test_the_sample_is_inert(tmp_path: Path) -> None:
    book = load_workbook(write_xlsx(sample_document(), tmp_path / "t.xlsx"))
    cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row if cell.value is not None]
    assert {cell.data_type for cell in cells} == {"s", "n", "b"}  # "f" would be a formula
    assert any(str(cell.value).startswith(HOSTILE[:20]) and cell.quotePrefix for cell in cells)


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
    document = with_table(one_column("=t", *map(Verbatim, texts), label="=h"), title="=title")
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
    names = worksheet_names(["a" * 50, "a" * 60, "A" * 31, "x/y:z[1]", "contents", "", "'"])
    assert len({name.lower() for name in names}) == len(names)
    assert all(1 <= len(name) <= 31 and not set(name) & set("[]:*?/\\'") for name in names)
    assert "contents" not in names


@pytest.mark.parametrize("name", ["\U0001f3db" * 40, "x" + "\U0001f3db" * 40, "History"])
def test_names_of_sheets_are_those_that_excel_takes(tmp_path: Path, name: str) -> None:
    document = with_table(one_column(name, Verbatim("a")), one_column(f"{name}2", Verbatim("b")))
    names = load_workbook(write_xlsx(document, tmp_path / "t.xlsx")).sheetnames
    assert all(len(each.encode("utf-16-le")) <= 2 * 31 and each.lower() != "history" for each in names)
    assert len({each.lower() for each in names}) == 4


@pytest.mark.parametrize("value", [float("inf"), float("-inf"), float("nan")])
def test_numbers_that_are_not_finite_are_text(tmp_path: Path, value: float) -> None:
    document = with_table(one_column("t", value))
    cell = load_workbook(write_xlsx(document, tmp_path / "t.xlsx"))["t"]["A3"]
    assert cell.data_type == "s"
