"""Calculation sheets of anchorages: those that are alike are printed once."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from assess.codes.calculation_sheet import Step, step
from reports.chapters.annex_sheets import anchorage_sheets
from reports.language.texts import Listing, Verbatim


def steps_of(newtons: float, surface: float) -> tuple[Step, ...]:
    return (
        step("S", "surface", "", "from the drawing", surface, "m2"),
        step("N_y", "yield", "", "A · f_y", newtons, "N", given={"A": (newtons / 235e6, "m2"), "f_y": (235e6, "Pa")}),
    )


def test_ties_that_are_alike_have_one_sheet_which_names_them() -> None:
    """Equal but for rounding they are one; a cone of another surface, which no formula shows, is another sheet."""
    of: dict[str, tuple[Step, ...]] = {
        "tie 1": steps_of(70e3, 1.8),
        "tie 2": steps_of(70e3, 2.1),
        "tie 3": steps_of(70e3, 1.8 + 1e-9),
    }
    loads = [SimpleNamespace(name=name, tie=SimpleNamespace(steps=steps)) for name, steps in of.items()]
    mechanism: Any = SimpleNamespace(loads=[*loads, SimpleNamespace(name="roof", tie=None)])
    sheets = list(anchorage_sheets(mechanism, "01-wall"))
    assert [each.name for each in sheets] == ["01-wall-anchorage-01", "01-wall-anchorage-02"]
    named: list[Any] = [each.caption for each in sheets]
    assert dict(named[0].values)["tie"] == Listing((Verbatim("tie 1"), Verbatim("tie 3")))
    assert dict(named[1].values)["tie"] == Listing((Verbatim("tie 2"),))
