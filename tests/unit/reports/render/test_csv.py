"""CSV files as Python's own reader sees them."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from scipy.constants import kilo

from reports.document import NOTHING, Cell, Column, Document, OutcomeCell, Section, Table
from reports.language.locale import Locale
from reports.language.texts import Text, Verbatim, quantity, say
from reports.render.table_text import csv_field, write_csv
from spectra.formulas import is_formula
from tests.support.sample_document import HOSTILE, sample_document

FOOT = 0.3048  # m, exact


def written(folder: Path, columns: tuple[Column, ...], row: tuple[Cell, ...], locale: Locale) -> list[list[str]]:
    """The lines of a file of one row."""
    section = Section(NOTHING, 0, (Table("t", NOTHING, columns, (row,)),))
    write_csv(Document(NOTHING, NOTHING, "", "", "A4", (), (section,), locale=locale), folder)
    with (folder / "t.csv").open(encoding="utf-8", newline="") as stream:
        return list(csv.reader(stream))


@pytest.mark.parametrize(("locale", "unit", "size"), [(Locale("it"), "m", 1.0), (Locale("en", "US"), "ft", FOOT)])
def test_numbers_are_whole_in_the_unit_of_their_head_with_a_point(
    tmp_path: Path, locale: Locale, unit: str, size: float
) -> None:
    value = 1.0 / 3.0
    height = Column(Verbatim("h"), "length")
    head, row = written(tmp_path, (height, height), (value, quantity(value, "length")), locale)
    assert head == [f"h [{unit}]"] * 2
    assert [float(cell) for cell in row] == [value / size] * 2


@pytest.mark.parametrize(
    ("cell", "text"),
    [
        (quantity(1234.5, "force"), "1.234\u00a0kN"),
        (quantity(2.0 / 3.0), repr(2.0 / 3.0)),
        (OutcomeCell("fail", quantity(1.31)), "1.31"),
        (OutcomeCell("pass", say("holds")), "holds"),
        (None, ""),
        (True, "true"),
        (7, "7"),
    ],
)
def test_every_kind_of_cell(tmp_path: Path, cell: Cell, text: str) -> None:
    assert written(tmp_path, (Column(Verbatim("x")),), (cell,), Locale()) == [["x"], [text]]


def test_forces_are_in_kilonewtons(tmp_path: Path) -> None:
    head, row = written(tmp_path, (Column(Verbatim("F"), "force"),), (98765.4321,), Locale())
    assert head == ["F [kN]"]
    assert float(row[0]) == 98765.4321 / kilo


@pytest.mark.parametrize("text", ["=cmd()", "+1", "-1", "@x", "\t=1", "\r=1", "\n=1", " =1"])
def test_no_text_is_a_formula(text: str) -> None:
    assert csv_field(text)[0] not in "=+-@\t\r\n "


def test_hostile_text_is_inert_and_every_row_has_the_stamp(tmp_path: Path) -> None:
    document = sample_document(Locale("en", "US"))
    paths = write_csv(document, tmp_path)
    assert {path.name for path in paths} == {"wide.csv", "narrow.csv", "long.csv", "sheet.csv"}
    for path in paths:
        with path.open(encoding="utf-8", newline="") as stream:
            head, *rows = csv.reader(stream)
        assert head[-1] == "stamp"
        assert {row[-1] for row in rows} == {document.stamp}
        assert not any(is_formula(cell) for row in (head, *rows) for cell in row if not is_number(cell))
    assert HOSTILE[:20] in (tmp_path / "wide.csv").read_text(encoding="utf-8")


def is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def test_a_sheet_has_its_results_as_numbers_in_both_systems(tmp_path: Path) -> None:
    write_csv(sample_document(Locale("en", "US")), tmp_path)
    with (tmp_path / "sheet.csv").open(encoding="utf-8", newline="") as stream:
        first, second, third = csv.DictReader(stream)
    assert (float(first["Value"]), first["Unit"]) == (22.0725, "m")
    assert (float(first["Value, US"]), first["Unit, US"]) == (22.0725 / FOOT, "ft")
    assert (second["Value"], second["Value, US"]) == ("≤ 0.5", "")
    assert third["Value"] == ""


def test_awkward_text_is_one_cell(tmp_path: Path) -> None:
    awkward: Text = Verbatim('a,"b"\nc\x00d😀<b>&')
    columns = (Column(Verbatim("x")), Column(Verbatim("y"), "length"))
    found = written(tmp_path, columns, (awkward, 1.5), Locale())
    assert found == [["x", "y [m]"], ['a,"b" c⟨U+0000⟩d😀<b>&', "1.5"]]
