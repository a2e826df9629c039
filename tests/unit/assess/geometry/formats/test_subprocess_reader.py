"""Readers in processes of their own: what crashes or never ends is told, and no process outlives its limit."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from assess.geometry.formats import isolation
from assess.geometry.formats.isolation import ReaderCrashError, call_in_subprocess, run_in_subprocess


@pytest.fixture
def file(tmp_path: Path) -> Path:
    (path := tmp_path / "wall.step").write_bytes(b" " * 100)
    return path


def test_the_code_at_its_end_comes_back(file: Path) -> None:
    assert run_in_subprocess("import sys; sys.exit(len(sys.argv[1:]))", file, "more", name="the reader") == 2


def test_a_reader_that_never_ends_is_stopped_by_the_kernel(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The limit is the process's own, so that it holds after this one was killed."""
    pytest.importorskip("resource")
    monkeypatch.setattr(isolation, "MIN_TIME", 0.5)
    monkeypatch.setattr(isolation, "CLOCK_FACTOR", 1000.0)
    with pytest.raises(ValueError, match="the reader has not read it after 1 s"):
        run_in_subprocess("while True: pass", file, name="the reader")


def test_a_reader_that_waits_for_ever_is_stopped_by_the_clock(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(isolation, "MIN_TIME", 0.1)
    monkeypatch.setattr(isolation, "CLOCK_FACTOR", 0.5)
    with pytest.raises(ValueError, match="has not read it"):
        run_in_subprocess("import time; time.sleep(60)", file, name="the reader")


def test_a_crash_is_told(file: Path) -> None:
    with pytest.raises(ValueError, match="the reader crashed on it"):
        run_in_subprocess("import os; os.abort()", file, name="the reader")


def exit_at_once(_: Path) -> None:
    sys.exit(3)


def raise_own_error(_: Path) -> None:
    raise OwnError("no such thing")


class OwnError(RuntimeError):
    """An error of a package."""


def test_a_call_returns_its_answer_or_raises_its_error(file: Path) -> None:
    assert call_in_subprocess(Path.stat, file, name="the reader").st_size == 100
    with pytest.raises(NotADirectoryError):
        call_in_subprocess(os.listdir, file, name="the reader")
    with pytest.raises(ValueError, match="no such thing"):
        call_in_subprocess(raise_own_error, file, name="the reader")
    with pytest.raises(ReaderCrashError, match="the reader crashed on it"):
        call_in_subprocess(exit_at_once, file, name="the reader")
