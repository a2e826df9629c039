"""Numbers are rounded once, to significant figures, within half a unit of the last digit that is shown."""

from __future__ import annotations

from math import inf

import pytest
from hypothesis import given
from hypothesis import strategies as st

from reports.language.locale import numeral
from tests.support.document_numbers import read_number


@pytest.mark.parametrize(
    ("value", "figures", "text"),
    [
        (0.1, 4, "0.1"),
        (12.3449, 4, "12.34"),
        (45674.0, 4, "45670"),
        (45674.0, 5, "45674"),
        (1.2344e6, 4, "1.234×10⁶"),
        (-0.00001234, 3, "−1.23×10⁻⁵"),
        (0.0, 3, "0"),
        (2240.0, 4, "2240"),
        (7.0, 12, "7"),
        (inf, 3, "∞"),
    ],
)
def test_numbers_are_written_as_engineers_write_them(value: float, figures: int, text: str) -> None:
    assert numeral(value, figures=figures) == text


def test_columns_keep_zeros_and_languages_their_decimal_sign() -> None:
    assert numeral(0.1, figures=3, aligned=True) == "0.100"
    assert numeral(0.25, point=",") == "0,25"


@given(st.floats(-1e12, 1e12, allow_subnormal=False), st.integers(2, 8), st.booleans(), st.sampled_from(",."))
def test_what_is_shown_is_within_half_a_unit_of_its_last_digit(
    value: float, figures: int, aligned: bool, point: str
) -> None:
    shown = read_number(numeral(value, figures=figures, aligned=aligned, point=point), point=point)
    assert abs(shown.value - value) <= 0.5 * shown.last_digit * (1 + 1e-9)
