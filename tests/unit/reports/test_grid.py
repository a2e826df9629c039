"""Column widths and long tables."""

from __future__ import annotations

import pytest
from reportlab.platypus import Table as Grid

from reports.document import Cell, Column, Table
from reports.grid import column_widths, table_grid
from reports.typeset import register_fonts, width_of

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
    assert isinstance(first, Grid)
    assert isinstance(second, Grid)
    assert first.repeatRows == second.repeatRows == 2
    assert vars(second)["_cellvalues"][0][0][0].getPlainText() == "Table 1. Many."


def test_a_cell_of_ten_thousand_letters_fits_a_page() -> None:
    register_fonts()
    grid = table_grid(
        Table("t", "x" * 10_000, COLUMNS, (("y" * 10_000, 0.1, "z" * 10_000),)), title="Table 1", width=300.0
    )
    assert grid.wrap(300, 700)[1] < 700
