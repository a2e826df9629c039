"""Numbers as text, against numbers written by hand."""

from __future__ import annotations

import math

import pytest
from hypothesis import given as drawn
from hypothesis import strategies

from reports.document import Cell, Kind
from reports.language.numerals import as_cell, cell_text, numeral


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.1, "0.100"),
        (0.0, "0"),
        (12.34, "12.3"),
        (999.6, "1000"),
        (99996.0, "1.00×10⁵"),
        (45678.0, "45700"),
        (-0.0123, "−0.0123"),
        (1.234e6, "1.23×10⁶"),
        (-4.56e-5, "−4.56×10⁻⁵"),
        (0.0009996, "0.00100"),
        (math.inf, "∞"),
    ],
)
def test_three_figures(value: float, text: str) -> None:
    assert numeral(value, digits=3) == text


@drawn(strategies.floats(allow_nan=False, allow_infinity=False, min_value=-1e12, max_value=1e12))
def test_a_numeral_reads_back_within_half_a_unit_of_its_last_figure(value: float) -> None:
    text = numeral(value).replace("−", "-").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")).replace("×10", "e")
    assert float(text) == pytest.approx(value, rel=5.01e-3, abs=1e-300)


@pytest.mark.parametrize(
    ("cell", "kind", "text"),
    [
        (None, "number", "—"),
        ("", "text", "—"),
        (True, "text", "yes"),
        (7, "number", "7"),
        (2240.125, "given", "2240.125"),
        ("pass", "verdict", "pass"),
    ],
)
def test_cells(cell: Cell, kind: Kind, text: str) -> None:
    assert cell_text(cell, kind) == text


def test_lists_become_one_line() -> None:
    assert as_cell([1, 0, {"é": 2.5}]) == '[1, 0, {"é": 2.5}]'


def test_four_figures_unless_told() -> None:
    assert numeral(12345.678) == "12350"
    assert numeral(1 / 3) == "0.3333"
