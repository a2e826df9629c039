"""`assess diff`: what is read, what is printed, how it ends."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from pathlib import Path

import pytest

from assess.cli.tables.results import changes_text
from assess.messages.message import Message, Severity
from assess.project.build import build
from assess.project.project_file import load
from assess.results import SCHEMA_VERSION, Input, Program, ResolvedValue, Results
from assess.results.diff import Difference
from assess.results.json import dumps
from assess.study.mechanism_results import parameters
from tests.support.command import ended
from tests.support.projects import published, tables_toml


@pytest.fixture
def runs(tmp_path: Path) -> tuple[Path, Path]:
    """Two folders of results, that differ by p, a value of the project, a file and a warning."""
    made = []
    for name, p in (("before", 2.4), ("after", 3.0)):
        folder = tmp_path / name
        folder.mkdir()
        parapet = {"parapet": published(p, 0.2, 1.2)}
        (folder / "project.toml").write_text(tables_toml(mechanisms=parapet))
        results = Results(
            SCHEMA_VERSION, Program("assess", "0"), (Input("project.toml", name * 8),),
            (Message("w", Severity.WARNING, "here", f"said\n {name}"),),
            {"mechanisms.parapet.p": ResolvedValue(p, True)}, None, (), parameters(build(load(folder))), None, (), (),
        )  # fmt: skip
        made.append(folder / "project-results" / "results.json")
        made[-1].parent.mkdir()
        made[-1].write_text(dumps(results))
    return made[0], made[1]


def test_blocks_without_two_sides_are_one_line() -> None:
    found = changes_text([Difference("other", "", "blocks that differ", None, "critical, checks of wall")])
    assert found == "other blocks of results.json that differ: critical, checks of wall\n\n1 difference\n"


def test_files_their_folders_and_folders_of_projects_are_one(
    runs: tuple[Path, Path], capsys: pytest.CaptureFixture[str]
) -> None:
    told = []
    for before, after in (runs, (runs[0].parent, runs[1].parent), (runs[0].parents[1], runs[1].parents[1])):
        assert ended("diff", before, after) == 0
        told.append(capsys.readouterr().out)
    assert told[0] == told[1] == told[2]
    lines = [line.split() for line in told[0].splitlines()]
    assert ["parapet", "p_eq_per_s,", "positive", "2.4", "3", "+25.00%"] in lines
    assert ["mechanisms.parapet.p", "2.4", "3", "+25.00%"] in lines
    assert ["project.toml", "sha256", "beforebefore", "afterafteraf"] in lines
    assert "- here: said\\n before\n+ here: said\\n after\n" in told[0]


def test_json_and_csv_hold_the_same_changes(runs: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("diff", *runs, "--json") == 0
    plain = json.loads(capsys.readouterr().out)
    assert ended("diff", *runs, "--csv") == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [(row["kind"], row["where"], row["what"]) for row in rows] == [
        (change["kind"], change["where"], change["what"]) for change in plain
    ]
    (p,) = (change for change in plain if change["kind"] == "project")
    assert (p["before"], p["after"], p["relative"]) == (2.4, 3.0, pytest.approx(0.25))
    assert ended("diff", *runs, "--csv", "--json") == 2


def test_the_exit_code_tells_only_where_asked(runs: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("diff", *runs, "--exit-code") == 1
    assert ended("diff", runs[0], runs[0], "--exit-code") == 0
    assert capsys.readouterr().out.endswith("\nno differences\n")
    assert ended("diff", *runs, "--tolerance", "0.3", "--exit-code") == 1  # a file and a warning differ all the same
    out = capsys.readouterr().out
    assert "p_eq_per_s" not in out


def test_what_is_no_results_file_is_one_line(runs: tuple[Path, Path], capsys: pytest.CaptureFixture[str]) -> None:
    before, after = runs
    text = after.read_text().replace('"schema_version": 2', '"schema_version": 7')
    after.write_text(text)
    for arguments, told in (
        ((before, after), "schema_version: 7: this program reads 2; run the project again"),
        ((before, before.parents[2]), "a folder with none of results.json or envelopes.json"),
        ((before, before.parents[1] / "project.toml"), "not JSON"),
        ((before, before.parent / "absent.json"), "absent.json: No such file"),
    ):
        assert ended("diff", *arguments) == 2
        err = capsys.readouterr().err
        assert told in err
        assert err.count("\n") == 1
    (before.parents[1] / "other-results").mkdir()
    (before.parents[1] / "other-results" / "results.json").write_text("{}")
    assert ended("diff", before.parents[1], before) == 2
    assert "2 folders of results" in capsys.readouterr().err
    assert ended("diff", before, before, "--tolerance", "-1") == 2


def test_names_are_only_text() -> None:
    hostile = "=cmd|' /C calc'!A0\x1b[31m‮" + "x" * 10_000
    change = Difference("verdict", hostile, hostile, "pass", "fail")
    told = changes_text([change, replace(change, kind="warning"), replace(change, kind="project", before=[hostile])])
    assert "\x1b" not in told
    assert max(map(len, told.splitlines()[:3])) < 180
    assert "FAIL" in told


def test_texts_that_are_cut_show_where_they_part() -> None:
    alike = "the same words over and over again, "
    told = changes_text([Difference("project", "", "notes", f"{4 * alike}lime", f"{4 * alike}cement")])
    assert "…over again, lime" in told
    assert "…over again, cement" in told


def test_fragility_is_not_compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "fragility.json").write_text("{}")
    assert ended("diff", tmp_path / "fragility.json", tmp_path / "fragility.json") == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "compare its tables, or two results.json" in line
