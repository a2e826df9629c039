"""Cells with units of their own are read back in the unit that engineers expect of the quantity."""

from __future__ import annotations

import pytest

from reports.chapters.cells import value_cell
from reports.document import Column
from reports.language.locale import Locale
from reports.language.texts import say
from reports.render.table_text import cell_text


@pytest.mark.parametrize(
    ("unit", "shown"),
    [("m", "0.25 m"), ("rad", "0.25 rad"), ("m/s2", "0.25 m/s²"), ("-", "0.25"), ("", "0.25"), ("g", "0.25 g")],
)
def test_a_number_of_the_results_is_shown_in_its_own_unit(unit: str, shown: str) -> None:
    """A length is no distance in kilometres and a rotation no angle in degrees, though their SI units are alike."""
    text = cell_text(value_cell(0.25, unit), Column(say("Demand")), Locale())
    assert text.replace("\u00a0", " ") == shown
