"""No table that the program writes holds text that a spreadsheet would run, whoever typed it."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from openpyxl import load_workbook

from records.formats.csv import parse_comments
from records.processing import csv_text
from records.reading import read_records
from records.record import Earthquake, StationSite, make_record
from reports.document import NOTHING, Column, Document, Section, Table
from reports.language.texts import Verbatim
from reports.render.spreadsheet import write_xlsx
from reports.render.table_text import csv_lines
from spectra.formulas import SIGNS, is_formula, mark_formulas, unmark_formulas
from tests.support.command import ended
from tests.support.places import SOURCES
from tests.support.projects import ASCE7, published, tables_toml

WRITERS = {  # `csv_lines` and `table_text` escape every cell, `write_xlsx` writes text as text, quoted
    r"csv\.(writer|DictWriter)|to_csv|savetxt": {"reports/render/table_text.py", "assess/risk/exports.py"},
    r"xlsxwriter|openpyxl.*Workbook|to_excel": {"reports/render/spreadsheet.py"},
}
HOSTILE = "=cmd|'/c calc'!A1"
LETTERS = st.text(alphabet="ab=+-@,;\"' \t:#1", max_size=30)


@pytest.mark.parametrize("pattern", WRITERS)
def test_one_module_writes_each_kind_of_table(pattern: str) -> None:
    sources = (path for each in ("assess", "records", "reports", "spectra") for path in (SOURCES / each).rglob("*.py"))
    found = {str(path.relative_to(SOURCES)) for path in sources if re.search(pattern, path.read_text(encoding="utf-8"))}
    assert found == WRITERS[pattern]


def run_cells(text: str) -> list[str]:
    """Cells that a spreadsheet would run, whichever separator its language has; numbers are none."""
    cells = (cell.strip() for mark in ",;\t" for row in csv.reader(io.StringIO(text), delimiter=mark) for cell in row)
    return [cell for cell in cells if cell.startswith(SIGNS) and not re.fullmatch(r"-|[-+][\d.]+(e[-+]?\d+)?", cell)]


def printed(capsys: pytest.CaptureFixture[str], *arguments: str | Path) -> str:
    assert ended(*arguments) in (0, 1, 3)
    return capsys.readouterr().out


def test_names_of_mechanisms_in_every_table_of_a_project(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    runs = []
    for p in (1.6, 1.7):
        project = tmp_path / f"{p}.toml"
        text = tables_toml(
            site={"spectrum": ASCE7 | {"s_ds": 0.5, "s_d1": 0.2, "t_l": 6}},
            mechanisms={HOSTILE: {"label": HOSTILE} | published(p)},
            records={"synthetic": {"count": 1, "duration": 8}},
            analysis={
                "levels": ["0.1 g"],
                "procedures": ["asce43-05-spectrum"],
                "pulses": {
                    "frequency": {"from": "1 Hz", "to": "2 Hz", "count": 2},
                    "amplitude": {"from": "0 g", "to": "4 g", "count": 2},
                },
            },
        )
        project.write_text(text)
        for command in ("parameters", "envelope"):
            out = printed(capsys, command, project, "--csv")
            assert f"'{HOSTILE}" in out
            assert run_cells(out) == []
        printed(capsys, "run", project, "-o", tmp_path / f"{p}", "--no-report", "--jobs", "1")
        runs.append(tmp_path / f"{p}")
    out = printed(capsys, "diff", *runs, "--csv")
    assert f"'{HOSTILE}" in out
    assert run_cells(out) == []


def test_names_of_records_in_every_table_of_records(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    name = tmp_path / f"{HOSTILE.replace('/', '')}.csv"
    (tmp_path / "target.csv").write_text("period [s],acceleration [g]\n0,0.1\n0.1,0.25\n4,0.02\n")
    time = 0.01 * np.arange(500)
    texts = {"event": HOSTILE, "station": "@sum, =1+1", "component": "-x"}
    place = {"site": StationSite(place=f'a;"{HOSTILE}'), "earthquake": Earthquake(time="+1, @x")}
    record = make_record("x", np.sin(time) * np.sin(30 * time), 0.01, **texts, **place)  # type: ignore[arg-type]
    name.write_text(csv_text(record), encoding="utf-8")
    assert run_cells(name.read_text(encoding="utf-8")) == []
    (again,) = read_records(name)
    assert [getattr(again, key) for key in texts] == list(texts.values())
    assert (again.site, again.earthquake) == (place["site"], place["earthquake"])
    scaled = ("scale", name, "--target", tmp_path / "target.csv")
    for command in (("list", name), ("spectra", name), (*scaled, "-o", tmp_path / "out")):
        assert run_cells(printed(capsys, "records", *command, "--csv")) == []
    assert all(run_cells(path.read_text(encoding="utf-8")) == [] for path in (tmp_path / "out").iterdir())


@given(st.lists(LETTERS, min_size=1, max_size=4), st.floats(allow_nan=False))
@example(["-"], -0.0)
def test_any_text_is_a_cell_of_text_and_numbers_stand_as_they_are(texts: list[str], number: float) -> None:
    ((*cells, last),) = csv.reader(io.StringIO(csv_lines([[*texts, number]])))
    assert not any(is_formula(cell) for cell in cells)
    assert float(last) == number


@given(LETTERS)
@example("x,'=1")
@example('x, "=1"')
def test_free_text_in_comments_is_read_as_it_was_written(text: str) -> None:
    assert unmark_formulas(mark_formulas(text)) == text
    line = " ".join(text.split())  # comments have no tabs
    assert run_cells(f"# event: {mark_formulas(line)}".replace('"', "")) == []
    assert parse_comments([f"# event: {mark_formulas(line)}"]) == {"event": line}


def test_text_in_a_workbook_stays_text_when_its_cell_is_edited(tmp_path: Path) -> None:
    cells = ((Verbatim(HOSTILE), -1.5), (Verbatim("plain"), 2.0))
    table = Table("t", NOTHING, (Column(Verbatim("x")), Column(Verbatim("y"))), cells)
    section = Section(Verbatim("s"), 0, (table,))
    write_xlsx(Document(NOTHING, NOTHING, "", "", "A4", (), (section,)), tmp_path / "t.xlsx")
    rows = list(load_workbook(tmp_path / "t.xlsx")["t"].iter_rows(min_row=3))
    assert [(cell.value, cell.data_type, cell.quotePrefix) for cell in rows[0]] == [
        (HOSTILE, "s", True),
        (-1.5, "n", False),
    ]
    assert not rows[1][0].quotePrefix
