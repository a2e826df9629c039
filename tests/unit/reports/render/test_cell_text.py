"""Numbers of a column have as many decimals as their figures and their neighbours give them."""

from __future__ import annotations

import pytest

from reports.document import Cell, Column
from reports.language.locale import Locale
from reports.language.texts import say
from reports.render.table_text import column_texts


@pytest.mark.parametrize(
    ("cells", "texts"),
    [
        ((0.33, 0.331, 0.3, 0.0), ["0.330", "0.331", "0.300", "0"]),
        ((12.34, 0.1234, 2.0), ["12.34", "0.1234", "2.000"]),
        ((0.06, 0.077, 1.5e7), ["0.060", "0.077", "1.5×10⁷"]),
        ((24000.0, 144000.0), ["24000", "144000"]),
        ((2.0, 3, None, say("rigid")), ["2", "3", "—", "rigid"]),
    ],
)
def test_decimals_of_a_column(cells: tuple[Cell, ...], texts: list[str]) -> None:
    assert column_texts(cells, Column(say("Value"), "ratio"), Locale()) == texts


def test_decimals_have_the_sign_of_the_language() -> None:
    assert column_texts((0.3, 0.331), Column(say("Value"), "ratio"), Locale("it")) == ["0,300", "0,331"]
