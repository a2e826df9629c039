"""The lock of a folder: one holder, who is named; those that are gone hold nobody up."""

import json
import os
import socket
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

import pytest

from assess.errors import HeldError
from assess.outputs import lock
from assess.outputs.lock import LOCK, Holder, is_abandoned
from tests.support.files import contents_of, write_output

HOLD = """
import sys, time
from pathlib import Path
from assess.outputs.lock import hold_lock
with hold_lock(Path(sys.argv[1]), command="assess run"):
    print("held\\n", end="", flush=True)
    time.sleep(60)
"""


def test_a_second_command_is_told_who_is_writing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Another process that holds the lock of the folder
    process = subprocess.Popen([sys.executable, "-c", HOLD, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "held\n"
    with process as first:
        monkeypatch.setattr(lock.time, "sleep", lambda _: pytest.fail("it waits"))
        words = rf"{tmp_path}: is being written by assess run \(process {first.pid} on {socket.gethostname()}, since 20"
        with pytest.raises(HeldError, match=words):
            write_output(tmp_path, {"results.json": "1"})
        assert not is_abandoned(tmp_path / LOCK)
        first.kill()
    assert is_abandoned(tmp_path / LOCK)
    write_output(tmp_path, {"results.json": "1"})
    assert contents_of(tmp_path) == {"results.json": "1"}
    assert not (tmp_path / LOCK).exists()


@pytest.mark.skipif(sys.platform == "win32", reason="a process is copied")
def test_children_of_a_holder_that_was_killed_are_waited_for(tmp_path: Path) -> None:
    forking = HOLD.replace("    print(", "    import os; child = os.fork(); print(")
    short = forking.replace("60", "60 if child else 1")
    with subprocess.Popen([sys.executable, "-c", short, str(tmp_path)], stdout=subprocess.PIPE, text=True) as first:
        assert first.stdout is not None
        assert [first.stdout.readline() for _ in range(2)] == ["held\n"] * 2
        first.kill()
        first.wait()
        write_output(tmp_path, {"results.json": "1"})
        assert first.stdout.read() == ""  # the child has ended too
    assert contents_of(tmp_path) == {"results.json": "1"}


def signed(folder: Path, **changed: object) -> Path:
    """A lock file left behind that says this of its holder."""
    mine = Holder(os.getpid(), socket.gethostname(), lock._boot(), "assess run", "2024-01-01 00:00:00+00:00")
    (folder / LOCK).write_text(json.dumps({**asdict(mine), **changed}))
    return folder / LOCK


def test_a_holder_on_another_machine_is_believed(tmp_path: Path) -> None:
    file = signed(tmp_path, host="far-away", boot="another")
    with pytest.raises(HeldError, match=rf"on far-away.*if it is certain that it has ended, delete {LOCK} in that"):
        write_output(tmp_path, {"results.json": "1"})
    assert file.exists()


@pytest.mark.parametrize("text", ["", "{", "[]", '{"pid": "x"}'])
def test_a_lock_without_a_name_is_taken_over(tmp_path: Path, text: str) -> None:
    (tmp_path / LOCK).write_text(text)
    write_output(tmp_path, {"results.json": "1"})
    assert not (tmp_path / LOCK).exists()


def test_a_number_of_a_process_that_came_again_does_not_matter(tmp_path: Path) -> None:
    signed(tmp_path)  # this process itself is said to hold it
    write_output(tmp_path, {"results.json": "1"})
    signed(tmp_path, boot="before the machine was started anew", pid=1)
    write_output(tmp_path, {"results.json": "2"})
    assert contents_of(tmp_path) == {"results.json": "2"}


def test_on_a_disk_without_locks_the_process_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lock, "_try_lock", lambda _: None)
    signed(tmp_path)
    with pytest.raises(HeldError, match="delete"):
        write_output(tmp_path, {"results.json": "1"})
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait()
    signed(tmp_path, pid=ended.pid)
    write_output(tmp_path, {"results.json": "1"})
    assert contents_of(tmp_path) == {"results.json": "1"}


@pytest.mark.skipif(not hasattr(os, "O_NOFOLLOW"), reason="links are not told apart")
def test_a_lock_that_is_a_link_is_not_followed(tmp_path: Path) -> None:
    (tmp_path / "precious").write_text("x")
    (tmp_path / LOCK).symlink_to(tmp_path / "precious")
    with pytest.raises(OSError, match="symbolic link"):
        write_output(tmp_path, {"results.json": "1"})
    assert (tmp_path / "precious").read_text() == "x"
