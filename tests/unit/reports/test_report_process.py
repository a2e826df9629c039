"""The process that writes the report: what it is told, what it tells, and how it ends."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import time
from contextlib import nullcontext, suppress
from pathlib import Path
from typing import Any

import pytest

import reports.writing
from reports.report_process import report_writer

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="a process is copied on Linux only")


def stand_in(monkeypatch: pytest.MonkeyPatch, write: Any) -> None:
    """Let `write(results, folder, progress)` stand for the report."""
    monkeypatch.setattr(
        reports.writing, "write_all", lambda results, folder, *, jobs, progress: write(results, folder, progress)
    )


@pytest.mark.parametrize("jobs", [1, 2])
def test_stages_are_said_and_the_path_comes_back(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, jobs: int) -> None:
    def write(results: str, folder: Path, say: Any) -> Path:
        say("figures")
        say("report")
        (folder / "report.pdf").write_text(f"{results} {os.getpid() == parent}", encoding="utf-8")
        return folder / "report.pdf"

    parent, said = os.getpid(), list[str]()
    stand_in(monkeypatch, write)
    with report_writer(jobs) as begin:
        path = begin("walls", tmp_path, said.append)()  # type: ignore[arg-type]  # stands for results
    assert said == ["figures", "report"]
    assert path == tmp_path / "report.pdf"
    assert path.read_text(encoding="utf-8") == f"walls {jobs == 1}"
    assert not multiprocessing.active_children()


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_goes_wrong_is_raised_here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, jobs: int) -> None:
    def write(*_: Any) -> Path:
        raise OSError(28, "No space left on device", str(tmp_path / "report.pdf"))

    stand_in(monkeypatch, write)
    with pytest.raises(OSError, match="No space left") as raised, report_writer(jobs) as begin:
        begin("walls", tmp_path, print)()  # type: ignore[arg-type]
    assert raised.value.filename == str(tmp_path / "report.pdf")
    assert not multiprocessing.active_children()


def test_the_place_of_a_mistake_in_the_program_is_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def write(*_: Any) -> Path:
        raise ZeroDivisionError("a mistake")

    stand_in(monkeypatch, write)
    with pytest.raises(ZeroDivisionError) as raised, report_writer(2) as begin:
        begin("walls", tmp_path, print)()  # type: ignore[arg-type]
    assert any("test_report_process.py" in note for note in raised.value.__notes__)


def test_a_writer_that_is_killed_is_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    stand_in(monkeypatch, lambda *_: os.kill(os.getpid(), signal.SIGKILL))
    with pytest.raises(RuntimeError, match=r"ended by itself \(exit code -9\)"), report_writer(2) as begin:
        begin("walls", tmp_path, print)()  # type: ignore[arg-type]


def test_a_writer_that_is_killed_before_it_is_asked_is_told(tmp_path: Path) -> None:
    with report_writer(2) as begin:
        (child,) = multiprocessing.active_children()
        os.kill(child.pid or 0, signal.SIGKILL)
        child.join(20.0)
        with pytest.raises(RuntimeError, match=r"ended by itself \(exit code -9\)"):
            begin("walls" * 100_000, tmp_path, print)()  # type: ignore[arg-type]


def test_what_goes_wrong_while_it_gets_ready_is_raised_here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "reports.writing", None)
    with pytest.raises(ModuleNotFoundError, match="writing"), report_writer(2) as begin:
        begin("walls", tmp_path, print)()  # type: ignore[arg-type]


@pytest.mark.parametrize("ignored", [False, True])
def test_ctrl_c_reaches_the_writer_only_where_it_reaches_the_analysis(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, ignored: bool
) -> None:
    def write(results: str, folder: Path, say: Any) -> Path:
        os.kill(os.getpid(), signal.SIGINT)
        return folder

    stand_in(monkeypatch, write)
    before = signal.signal(signal.SIGINT, signal.SIG_IGN if ignored else signal.default_int_handler)
    try:
        with (
            nullcontext() if ignored else pytest.raises(RuntimeError, match="ended by itself"),
            report_writer(2) as begin,
        ):
            assert begin("walls", tmp_path, print)() == tmp_path  # type: ignore[arg-type]
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("asked", [False, True])
def test_nothing_waits_for_a_report_that_is_not_wanted_any_more(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, asked: bool
) -> None:
    def write(_: str, folder: Path, __: Any) -> None:
        time.sleep(60)
        (folder / "written").touch()

    stand_in(monkeypatch, write)
    with suppress(KeyboardInterrupt), report_writer(2) as begin:
        if asked:
            begin("walls", tmp_path, print)  # type: ignore[arg-type]
        raise KeyboardInterrupt
    assert not (tmp_path / "written").exists()
    assert not multiprocessing.active_children()
