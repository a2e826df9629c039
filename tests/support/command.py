"""The command line as a test calls it: in this process, in a terminal of its own, and with Ctrl-C typed into it."""

from __future__ import annotations

import contextlib
import os
import pty
import re
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TextIO

import pytest

from assess.cli import main


def ended(*arguments: str | Path | float) -> int:
    """The exit code of a command."""
    with pytest.raises(SystemExit) as caught:
        main([str(argument) for argument in arguments])
    return int(caught.value.code or 0)


def ended_with(capsys: pytest.CaptureFixture[str], *arguments: str | Path | float) -> tuple[int, str]:
    """The exit code of a command, and the last line that it wrote on stderr."""
    code = ended(*arguments)
    return code, (capsys.readouterr().err.splitlines() or [""])[-1]


ROOT = Path(__file__).parents[2]
TURN = 0.02  # s between two looks at what is awaited
PATIENCE = 120.0  # s: on a busy machine everything takes long


@dataclass
class Screen:
    """What has been written to a terminal; `seen` is set as soon as it contains `awaited`."""

    awaited: str = "\0"
    text: str = ""
    seen: threading.Event = field(default_factory=threading.Event)
    closed: threading.Event = field(default_factory=threading.Event)

    def read(self, master: int) -> None:
        """Read until the other end is closed here, and all of it; other processes may hold it open for longer."""
        while select.select([master], [], [], TURN)[0] or not self.closed.is_set():
            try:
                found = os.read(master, 4096) if select.select([master], [], [], 0)[0] else b""
            except OSError:  # the other end is closed everywhere
                break
            self.text += found.decode(errors="replace")
            if self.awaited in self.plain:
                self.seen.set()
        self.seen.set()

    @property
    def plain(self) -> str:
        """The text without what moves the cursor and sets colours."""
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", self.text)


@contextmanager
def terminal(screen: Screen) -> Iterator[TextIO]:
    """Give the writing end of a terminal, whose text the screen collects."""
    master, slave = pty.openpty()
    reader = threading.Thread(target=screen.read, args=(master,), daemon=True)
    reader.start()
    try:
        with os.fdopen(slave, "w") as stream:
            yield stream
    finally:
        screen.closed.set()
        reader.join()
        os.close(master)


@dataclass(frozen=True)
class Interrupted:
    """How a command ended that was interrupted: exit code, last line on stderr, all of it, and how long it took [s].

    workers : how many processes it had when it was interrupted
    left : the command lines of those that went on for 10 s after it
    """

    code: int
    line: str
    screen: str
    seconds: float
    workers: int
    left: tuple[str, ...]


def interrupt(*arguments: str | Path | int, at: str, after: float = 0.0, group: bool = True) -> Interrupted:
    """Run a command in a terminal and send it Ctrl-C.

    Parameters
    ----------
    arguments : of the command
    at : what its progress shows by then; "" for its start
    after : how long to wait from then on [s]
    group : whether every process of the command gets the signal, as from a terminal, or only the first
    """
    screen = Screen(at)
    variables = os.environ | {"PYTHONPATH": str(ROOT), "TERM": "xterm", "COLUMNS": "100"}
    command = [sys.executable, "-m", "assess", *map(str, arguments)]
    with terminal(screen) as stream:
        process = subprocess.Popen(
            command, stderr=stream, stdout=subprocess.DEVNULL, env=variables, start_new_session=True
        )
        try:
            if at:
                _wait(lambda: screen.seen.is_set() or process.poll() is not None)
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(after)
            workers = len(members(process.pid))
            begun = time.monotonic()
            if process.poll() is None:
                (os.killpg if group else os.kill)(process.pid, signal.SIGINT)
            code = process.wait(PATIENCE)
            seconds = time.monotonic() - begun
            with contextlib.suppress(TimeoutError):
                _wait(lambda: not members(process.pid), patience=10.0)
            left = tuple(members(process.pid).values())
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    line = screen.plain.strip().rpartition("\n")[2].rpartition("\r")[2]
    return Interrupted(code, line.strip(), screen.plain, seconds, workers, left)


def _wait(condition: Callable[[], bool], *, patience: float = PATIENCE) -> None:
    deadline = time.monotonic() + patience
    while not condition():
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(TURN)


def members(session: int) -> dict[int, str]:
    """Return the processes of a session that have not ended, with their command lines."""
    found = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            words = stat.read_text().rpartition(")")[2].split()
            if int(words[3]) == session and words[0] != "Z":
                said = (stat.parent / "cmdline").read_bytes().replace(b"\0", b" ")
                found[int(stat.parent.name)] = said.decode(errors="replace").strip()
    return found
