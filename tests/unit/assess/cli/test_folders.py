"""Folders of outputs from the command line: refused before the analysis, in one line; and the number of processes."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.outputs.lock import hold_lock
from assess.workers import available_cores
from tests.support.command import ended
from tests.support.projects import project_toml


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project of which no analysis may begin."""
    (tmp_path / "wall.toml").write_text(project_toml())
    monkeypatch.setattr("assess.project.build.build", lambda *_, **__: pytest.fail("the analysis began"))
    return tmp_path / "wall.toml"


@pytest.mark.parametrize(
    ("command", "name"),
    [("run", "report.pdf"), ("run", "report.html"), ("run", "tables.xlsx"), ("run", "results.json"),
     ("envelope", "envelopes.json"), ("envelope", "envelopes.pdf"), ("envelope", "tables.xlsx")],
)  # fmt: skip
def test_a_file_of_the_users_is_told_before_the_analysis(
    command: str, name: str, project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / name).write_text("mine")
    assert ended(command, project, "-o", tmp_path / "out", "--jobs", "1") == 2
    err = capsys.readouterr().err
    assert err.startswith(f"assess: error: {tmp_path / 'out' / name}: was not written by assess")
    assert err.count("\n") == 1
    assert [path.name for path in (tmp_path / "out").iterdir()] == [name]


@pytest.mark.parametrize("command", ["run", "envelope"])
def test_a_second_command_in_a_folder_ends_at_once(
    command: str, project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with hold_lock(tmp_path, command="assess run"):
        assert ended(command, project, "-o", tmp_path, "--jobs", "1") == 2
    err = capsys.readouterr().err
    assert err.startswith(f"assess: error: {tmp_path}: is being written by assess run (process ")
    assert err.count("\n") == 1


@pytest.mark.parametrize("command", ["run", "envelope"])
@pytest.mark.parametrize("jobs", ["0", "-1", "nan", "1e3", "2.5", "", "9" * 5000])
def test_a_number_of_processes_that_is_none_is_refused(
    command: str, jobs: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert ended(command, project, "--jobs", jobs) == 2
    err = capsys.readouterr().err
    assert "--jobs" in err
    assert err.count("\n") == 1


def test_no_more_processes_are_begun_than_there_are_cores(tmp_path: Path) -> None:
    (tmp_path / "wall.toml").write_text(project_toml(analysis={"procedures": ["asce43-05-spectrum"]}))
    assert available_cores() >= 1
    assert ended("run", tmp_path / "wall.toml", "--no-report", "--jobs", "99999999999") in (0, 1, 3)
