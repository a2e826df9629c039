"""Long commands in a terminal: progress, --quiet, --verbose, NO_COLOR."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.support.command import Screen, ended, terminal
from tests.support.projects import write_blocks

QUICK = {"samples": 12, "draws": 100}
SHORT = {"amplitude": {"from": "0 g", "to": "4 g", "count": 3}, "frequency": {"from": "1 Hz", "to": "4 Hz", "count": 3}}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project, its results, and a folder of projects with it."""
    file = write_blocks(tmp_path_factory.mktemp("terminal") / "one", records=2, pulses=SHORT, fragility=QUICK)
    assert ended("run", "-q", file, "--no-report", "--jobs", 1) in (0, 1, 3)
    return file


def on_screen(monkeypatch: pytest.MonkeyPatch, *arguments: str | Path | int, **variables: str) -> str:
    """What a command writes on a terminal."""
    for name in ("NO_COLOR", "FORCE_COLOR", "TTY_COMPATIBLE", "TTY_INTERACTIVE"):
        monkeypatch.delenv(name, raising=False)
    for name, value in {"TERM": "xterm-256color", "COLUMNS": "100", **variables}.items():
        monkeypatch.setenv(name, value)
    screen = Screen()
    with terminal(screen) as stream, monkeypatch.context() as patched:
        patched.setattr(sys, "stderr", stream)
        assert ended(*arguments) in (0, 1, 3)
    return screen.text


@pytest.mark.parametrize(
    ("word", "command"),
    [
        ("rocking histories", ("run", "PROJECT", "-o", "OUT", "--no-report")),
        ("primary pulses", ("envelope", "PROJECT")),
        ("fragility curves", ("fragility", "PROJECT")),
        ("records", ("records", "index", "RECORDS", "--catalogue", "CATALOGUE")),
        ("cases", ("verify", "housner_1963", "--quick")),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_long_command_shows_progress_on_a_terminal_and_none_in_a_pipe(
    word: str,
    command: tuple[str, ...],
    project: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    places = {"PROJECT": project, "RECORDS": project.parent / "records"}

    def arguments(place: Path) -> list[str | Path | int]:
        made = {"OUT": place / "made", "CATALOGUE": place / "catalogue.sqlite"}
        place.mkdir()
        return [*((places | made).get(each, each) for each in command), "--jobs", 1]

    assert word in on_screen(monkeypatch, *arguments(tmp_path / "terminal"))
    capsys.readouterr()
    assert ended(*arguments(tmp_path / "pipe")) in (0, 1, 3)
    said = capsys.readouterr().err
    assert "\x1b" not in said
    assert [line for line in said.splitlines() if ": " not in line] == []  # notes and warnings alone


def test_a_terminal_may_be_without_colour_or_cursor(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    command = ("envelope", project, "--jobs", 1)
    assert "\x1b[38;5" in on_screen(monkeypatch, *command) or "\x1b[3" in on_screen(monkeypatch, *command)
    plain = on_screen(monkeypatch, *command, NO_COLOR="1")
    assert "primary pulses" in plain
    assert "\x1b[3" not in plain
    assert "\x1b" not in on_screen(monkeypatch, *command, TERM="dumb")


@pytest.mark.parametrize("place", ["before", "behind"])
def test_quiet_leaves_results_alone(
    place: str, project: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    command = ("fragility", project, "--jobs", 1, "--csv")
    assert ended(*command) == 0
    usual = capsys.readouterr()
    assert "warning: " in usual.err
    command = ("--quiet", *command) if place == "before" else (*command, "-q")
    assert on_screen(monkeypatch, *command) == ""
    assert capsys.readouterr().out == usual.out


def test_verbose_tells_stages_records_and_compiled_code(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("-v", "run", project, "--no-report", "--jobs", 1) in (0, 1, 3)
    lines = capsys.readouterr().err.splitlines()
    assert [line for line in lines if not line.startswith("assess: ")] == []
    told = "\n".join(lines)
    for part in ("reading: ", "rocking histories: ", "record records/r000.csv, factor ", "machine code: "):
        assert part in told


def test_quiet_and_verbose_exclude_each_other(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("--quiet", "check", project, "--verbose") == 2
    assert "--quiet and --verbose exclude each other" in capsys.readouterr().err
    assert ended("check", project) == 0
