"""`assess summary`: one row a mechanism of several runs, and one line for what cannot be read."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from tests.support.command import ended
from tests.support.projects import ASCE7, published, tables_toml


@pytest.fixture
def results(tmp_path: Path) -> Path:
    """A run of two mechanisms, one with a hostile name."""
    tables = {
        "site": {"spectrum": ASCE7},
        "mechanisms": {"=1+1": published(2.0, 0.1), "quick": published(4.0, 0.2)},
        "analysis": {"procedures": ["asce43-05-spectrum"]},
    }
    (tmp_path / "project.toml").write_text(tables_toml(**tables))
    assert ended("run", "-q", tmp_path, "--no-report", "--jobs", 1) in (0, 1, 3)
    return tmp_path / "project-results" / "results.json"


def test_each_mechanism_of_each_run_has_a_row(results: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert ended("summary", results, results.parents[1], "--json") == 0
    rows = json.loads(capsys.readouterr().out)
    assert [row["mechanism"] for row in rows] == ["=1+1", "quick", "=1+1", "quick"]
    assert [row["run"] for row in rows[1:3]] == [str(results), str(results.parents[1])]
    assert [row["p_per_s"] for row in rows[:2]] == pytest.approx([2.0, 4.0])
    found = json.loads(results.read_text())["verdict"]
    for row, one in zip(rows, (found or {"mechanisms": []})["mechanisms"], strict=False):
        assert row["verdict"] == one["outcome"]
    assert ended("summary", results, "--csv") == 0
    names, first, *_ = csv.reader(io.StringIO(capsys.readouterr().out))
    assert names == list(rows[0])
    assert first[1] == "'=1+1"
    assert ended("summary", results) == 0
    assert len(capsys.readouterr().out.splitlines()) == 3


@pytest.mark.parametrize("text", ["", "{", "[]", None])
def test_what_is_no_run_is_one_line(text: str | None, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "results.json"
    if text is not None:
        file.write_text(text)
    assert ended("summary", file) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith(f"assess: error: {file}: ")
    assert said.err.count("\n") == 1
