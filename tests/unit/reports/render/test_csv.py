"""CSV files as Python's own reader sees them."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from assess.results import Results
from reports.assessment import assessment
from reports.document import Column, Document, Section, Table
from reports.render.csv import field, write_csv


def test_full_precision_and_units_survive(results: Results, tmp_path: Path) -> None:
    write_csv(assessment(results), tmp_path)
    with (tmp_path / "spectra.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert results.spectrum is not None
    target = [float(row["Acceleration [g]"]) for row in rows if row["Series"] == "target"]
    assert tuple(target) == results.spectrum.acceleration_g


@pytest.mark.parametrize("text", ["=cmd()", "+1", "-1", "@x", "\t=1", "\r=1", "\n=1", " =1"])
def test_no_text_is_a_formula(text: str) -> None:
    assert field(text)[0] not in "=+-@\t\r\n "


def test_numbers_stay_numbers() -> None:
    assert float(field(-0.1)) == -0.1
    assert field(None) == ""
    assert field(True) == "true"


def test_awkward_text_is_one_cell(tmp_path: Path) -> None:
    awkward = 'a,"b"\nc\x00d😀<b>&'
    table = Table("t", "", (Column("x"), Column("y", "m")), ((awkward, 1.5),))
    document = Document("", "", "", "", "A4", (), (Section("s", 0, (table,)),), ())
    write_csv(document, tmp_path)
    with (tmp_path / "t.csv").open(encoding="utf-8", newline="") as stream:
        assert list(csv.reader(stream)) == [["x", "y [m]"], ['a,"b" c⟨U+0000⟩d😀<b>&', "1.5"]]
