"""Tables and calculation sheets in US units, beside those in SI and the results."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pint
import pytest
from reports.language.us_units import WORKED_IN_SI, in_us_units, table
from reports.render.sheet_table import as_table

from assess.results import Resolved, Results
from reports.assessment import assessment
from reports.chapters import check_tables
from reports.document import Cell, Column, Document, Line, Section, Sheet, Table, Text
from reports.language.numerals import step_result

REGISTRY = pint.UnitRegistry()
SHARED = ("", "-", "g", "s", "rad", "Hz", "1/s", "years")


def times(unit: str, other: str) -> float:
    """How many of `other` one `unit` is, by pint."""
    one, into = (each.replace("²", "**2").replace("³", "**3").replace(" ", "*") for each in (unit, other))
    factor: float = REGISTRY.Quantity(1.0, one).to(into).magnitude
    return factor


def in_us(results: Results) -> Results:
    return replace(results, project={**results.project, "report.units": Resolved("US", True)})


@pytest.fixture(scope="module")
def both(results: Results) -> tuple[Document, Document]:
    made = assessment(in_us(results))
    return made, in_us_units(made)


def test_a_project_asks_for_its_units(results: Results) -> None:
    assert assessment(results).units == "SI"
    assert assessment(in_us(results)).units == "US"


def test_every_column_of_numbers_is_in_us_units_to_full_precision(both: tuple[Document, Document]) -> None:
    converted = 0
    for si, us in zip(both[0].tables, both[1].tables, strict=True):
        for place, (column, other) in enumerate(zip(si.columns, us.columns, strict=True)):
            if column.unit in SHARED:
                assert other.unit == column.unit
                continue
            factor = times(column.unit, other.unit)
            for row, changed in zip(si.rows, us.rows, strict=True):
                cell = row[place]
                expected = pytest.approx(cell * factor, rel=1e-12) if isinstance(cell, float) else cell
                assert changed[place] == expected
                converted += 1
    assert converted > 300


def test_parameters_are_those_of_the_results(results: Results, both: tuple[Document, Document]) -> None:
    found = next(each for each in both[1].tables if each.name == "01-wall-6-parameters")
    rows = {row[0]: row[1:] for row in found.rows}
    of = results.mechanisms[0].oscillator
    for label, unit, value, si in (
        ("Moved mass, M", "lb", of.mass_kg, "kg"),
        ("Moment of inertia about the hinge, I", "lb ft²", of.inertia_kg_m2, "kg m²"),
        ("Radius of the equivalent block, R", "ft", of.radius_m, "m"),
        ("Slenderness of the equivalent block, α", "rad", of.slenderness_rad, "rad"),
    ):
        assert rows[label][0] == unit
        assert rows[label][1] == pytest.approx(value * times(si, unit), rel=1e-12)


def test_demand_and_allowable_follow_the_unit_of_their_row(results: Results) -> None:
    mechanism = results.mechanisms[0]
    checks = tuple(
        replace(check, quantity="d*", unit="m") if check.procedure.startswith("dmi2008") else check
        for check in mechanism.checks
    )
    found = table(check_tables.verdicts(replace(results, mechanisms=(replace(mechanism, checks=checks),))))
    seen = set()
    for row, check in zip(found.rows, checks, strict=True):
        unit = str(row[3]).rpartition(", ")[2]
        factor = {"m": 1 / 0.3048}.get(check.unit, 1.0)
        seen.add(unit)
        assert row[5] == (None if check.capacity is None else pytest.approx(check.capacity * factor, rel=1e-12))
        assert row[6] == check.ratio
    assert {"rad", "ft"} <= seen
    assert "m" not in seen


def test_only_the_columns_of_the_rows_unit_follow_it() -> None:
    """As in the table of the sensitivity: the answers are ratios, whatever the number that is varied."""
    columns = tuple(map(Column, ("Number", "Unit", "Low", "High", "At low", "At high")))
    row: tuple[Cell, ...] = ("thickness", "m", 0.3048, 0.6096, 0.5, 0.7)
    assert table(Table("one", "One.", columns, (row,))).rows[0] == (
        "thickness", "ft", pytest.approx(1.0, rel=1e-12), pytest.approx(2.0, rel=1e-12), 0.5, 0.7,
    )  # fmt: skip


def test_a_cell_named_like_a_unit_is_no_unit() -> None:
    columns = (Column("Body"), Column("Material"), Column("Demand", kind="number"))
    one = Table("one", "One.", columns, (("m", "wall, m", 2.0),))
    assert table(one) == one


def test_numbers_as_given_are_rounded_once_they_are_converted() -> None:
    one = Table("one", "One.", (Column("Density", "kg/m³", "given"),), ((2240.0,), (None,), ("none",)))
    assert table(one).columns == (Column("Density", "lb/ft³", "number"),)
    assert table(one).rows[0][0] == pytest.approx(2240.0 * 0.028316846592 / 0.45359237, rel=1e-12)
    assert table(one).rows[1:] == ((None,), ("none",))


def test_sheets_stay_in_si_with_the_result_in_both(both: tuple[Document, Document]) -> None:
    seen = 0
    for si, us in zip(both[0].sheets, both[1].sheets, strict=True):
        for line, other in zip(si.lines, us.lines, strict=True):
            assert replace(other, beside=None) == line
            if line.unit in ("m", "m/s2") and isinstance(line.value, float):
                one, name = {"m": (0.3048, "ft"), "m/s2": (9.80665, "g")}[line.unit]
                assert other.beside == (pytest.approx(line.value / one, rel=1e-15), name)
                seen += 1
    assert seen > 0


def test_an_acceleration_of_a_sheet_stands_in_g_beside_it(both: tuple[Document, Document]) -> None:
    made = Sheet("s", "S.", (Line("a*", "", "", "", "", 0.2 * 9.80665, "m/s2"),))
    *_, shown = in_us_units(replace(both[0], sections=(Section("s", 0, (made,)),))).blocks
    assert isinstance(shown, Sheet)
    line = shown.lines[0]
    assert step_result(line.value, line.unit, line.beside) == "1.961 m/s2 (0.2000 g)"
    in_full = as_table(shown)
    assert [column.heading for column in in_full.columns[-4:]] == ["Value", "Unit", "Value, US", "Unit, US"]
    assert in_full.rows[0][-4:] == (line.value, "m/s2", pytest.approx(0.2, rel=1e-15), "g")
    assert len(as_table(made).columns) == 7


def test_the_sheets_are_explained_once_before_the_first(both: tuple[Document, Document]) -> None:
    note = Text((WORKED_IN_SI,))
    blocks = both[1].blocks
    assert blocks.count(note) == 1
    first = next(place for place, block in enumerate(blocks) if isinstance(block, Sheet))
    assert (note, blocks[first]) in set(pairwise(blocks[first - 1 : first + 1]))
