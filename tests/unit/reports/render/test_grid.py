"""Column widths and long tables."""

from __future__ import annotations

from pathlib import Path

import pytest
from pypdf import PdfReader
from reports.render.grid import LONGEST, column_widths, table_grid
from reports.render.ruled_table import RuledTable

from reports.document import Cell, Column, Document, Section, Table
from reports.render.pdf import write_pdf
from reports.render.typeset import register_fonts, width_of

COLUMNS = (Column("Record"), Column("PGA", "g", "number"), Column("Verdict", kind="verdict"))


@pytest.mark.parametrize("word", ["a", "word " * 200, "x" * 5000])
def test_widths_never_exceed_the_page(word: str) -> None:
    register_fonts()
    widths = column_widths(COLUMNS, [[word, "0.100", "not-applicable"]] * 3, 300.0)
    assert sum(widths) <= 300.0 + 1e-9
    assert min(widths) > 0
    assert widths[2] >= width_of("not-applicable", "cell")


def test_a_long_table_splits_and_repeats_caption_and_head() -> None:
    register_fonts()
    row: tuple[Cell, ...] = ("artificial-1", 0.1, "pass")
    grid = table_grid(Table("t", "Many.", COLUMNS, (row,) * 100), title="Table 1", width=300.0)
    grid.wrap(300, 400)
    first, second = grid.split(300, 400)
    assert isinstance(first, RuledTable)
    assert isinstance(second, RuledTable)
    assert first.wrap(300, 400)[1] <= 400
    assert len(first.body.rows) + len(second.body.rows) == 100
    for part in (first, second):
        assert part.caption.getPlainText() == "Table 1. Many."
        assert part.body.head == grid.body.head


@pytest.mark.parametrize("count", [1, 4, 5, 9])
def test_few_rows_are_not_left_alone(count: int) -> None:
    register_fonts()
    row: tuple[Cell, ...] = ("artificial-1", 0.1, "pass")
    grid = table_grid(Table("t", "Some.", COLUMNS, (row,) * count), title="Table 1", width=300.0)
    whole = grid.wrap(300, 1000)[1]
    assert grid.split(300, whole) == [grid]
    for lack in range(1, int(whole)):
        parts = [part.body.rows for part in grid.split(300, whole - lack)]
        assert parts == [] or (len(parts[0]) >= 2 and len(parts[1]) >= 3)


def test_a_cell_of_ten_thousand_letters_fits_a_page() -> None:
    register_fonts()
    grid = table_grid(
        Table("t", "x" * 10_000, COLUMNS, (("y" * 10_000, 0.1, "z" * 10_000),)), title="Table 1", width=300.0
    )
    assert grid.wrap(300, 700)[1] < 700


@pytest.mark.parametrize("count", [3, 4, 5])
def test_rows_that_fill_half_a_page_each_have_room(count: int, tmp_path: Path) -> None:
    columns = tuple(Column(f"c{place}") for place in range(12))
    table = Table("t", "Long.", columns, (("y" * LONGEST,) * 12,) * count)
    document = Document("t", "s", "a", "p", "A4", (), (Section("S", 0, (table,)),), ())
    pages = PdfReader(write_pdf(document, tmp_path / "tall.pdf")).pages
    assert "".join(page.extract_text() for page in pages).count("y") == 12 * count * LONGEST
