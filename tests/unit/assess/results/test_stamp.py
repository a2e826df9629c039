"""One stamp in every output: of the inputs, the program and the command, and of nothing else."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import openpyxl
import pypdf

from assess.results import Input, Program
from assess.results.provenance import stamp
from tests.support.command import ended
from tests.support.projects import block, project_toml

PROJECT = project_toml(mechanisms={"wall": block(restitution=0.5)}, analysis={"procedures": ["asce43-05-spectrum"]})
PROGRAM, FILES = Program("assess", "1"), (Input("a.toml", "00"), Input("b.csv", "11"))


def test_whatever_decides_the_results_changes_the_stamp() -> None:
    others = {
        stamp("run", PROGRAM, FILES),
        stamp("envelope", PROGRAM, FILES),
        stamp("run", Program("assess", "2"), FILES),
        stamp("run", PROGRAM, FILES[:1]),
        stamp("run", PROGRAM, (FILES[0], Input("b.csv", "12"))),
        stamp("run", PROGRAM, (FILES[0], Input("c.csv", "11"))),
    }
    assert len(others) == 6
    assert all(re.fullmatch("[0-9a-f]{4}(-[0-9a-f]{4}){3}", each) for each in others)


def test_every_output_carries_the_stamp_of_its_results(tmp_path: Path) -> None:
    project, out, again = tmp_path / "wall.toml", tmp_path / "out", tmp_path / "again"
    project.write_text(PROJECT)
    assert ended("run", project, "-o", out, "--jobs", "1") in (0, 1, 3)
    expected = json.loads((out / "results.json").read_text())["stamp"]
    assert ended("report", out / "results.json", "-o", again, "--png") == 0
    for folder in (out, again):
        assert json.loads((folder / "results.json").read_text())["stamp"] == expected
        pages = pypdf.PdfReader(folder / "report.pdf")
        assert pages.metadata is not None
        assert expected in str(pages.metadata.creator)
        assert all(f"stamp {expected}" in page.extract_text() for page in pages.pages)
        assert f"stamp {expected}" in (folder / "report.html").read_text()
        assert openpyxl.load_workbook(folder / "tables.xlsx").properties.keywords == expected
        tables = sorted((folder / "tables").glob("*.csv"))
        for table in tables:
            rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
            assert all(row["stamp"] == expected for row in rows), table
        figures = sorted((folder / "figures").iterdir())
        assert tables
        assert figures
        assert all(expected.encode() in each.read_bytes() for each in figures)
    assert {each.suffix for each in figures} == {".svg", ".png"}


def test_a_change_of_an_input_shows_and_another_place_does_not(tmp_path: Path) -> None:
    found = []
    for name, text in (("a", PROJECT), ("b", PROJECT), ("c", PROJECT + "# a note\n")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "wall.toml").write_text(text)
        assert ended("run", tmp_path / name / "wall.toml", "--no-report", "--jobs", "1") in (0, 1, 3)
        found.append(json.loads((tmp_path / name / "wall-results" / "results.json").read_text())["stamp"])
    assert found[0] == found[1] != found[2]


def stamped(path: Path) -> str:
    found = re.search(r"stamp:? ([0-9a-f]{4}(?:-[0-9a-f]{4}){3})", path.read_text())
    assert found is not None
    return found[1]


def test_files_of_their_own_are_stamped_too(tmp_path: Path) -> None:
    rows = "".join(f"{i / 100},{(i % 7) / 10 - 0.3:.2f}\n" for i in range(60))
    (tmp_path / "in.csv").write_text(f"time [s],acceleration [m/s2]\n{rows}")
    for name, factor in (("a.csv", "2"), ("b.csv", "2"), ("c.csv", "3"), ("a.at2", "2")):
        assert ended("records", "convert", tmp_path / "in.csv", "-o", tmp_path / name, "--scale", factor) == 0
    assert stamped(tmp_path / "a.csv") == stamped(tmp_path / "b.csv") == stamped(tmp_path / "a.at2")
    assert stamped(tmp_path / "a.csv") != stamped(tmp_path / "c.csv")
    spectrum = ("spectrum", "--code", "asce7-16", "--s-ds", "0.5 g", "--s-d1", "0.2 g", "--t-l", "6 s")
    for name, more in (("a.svg", ()), ("b.svg", ()), ("c.svg", ("--pga", "0.3 g"))):
        assert ended(*spectrum, *more, "-o", tmp_path / name) == 0
    assert stamped(tmp_path / "a.svg") == stamped(tmp_path / "b.svg") != stamped(tmp_path / "c.svg")
