"""The writer of the report: where a process can be copied, one of its own that gets ready while the analysis runs.

What draws pages takes a second to import, and in most of that time the analysis has no use for a second core.
"""

from __future__ import annotations

import signal
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING

from assess.outputs.signals import ENDING
from assess.workers import available_cores, end_with_parent, hear_signals, hold_signals

if TYPE_CHECKING:
    from assess.results import Results

Say = Callable[[str], None]
Begin = Callable[["Results", Path, Say], Callable[[], Path]]
"""Begins to write the report of results into a folder and says the stages; its answer waits for the path of the PDF."""


@contextmanager
def report_writer(jobs: int | None) -> Iterator[Begin]:
    """What writes a report by `jobs` processes, of all cores if None."""
    number = jobs or available_cores()
    if number == 1 or sys.platform != "linux":
        yield lambda results, folder, say: lambda: _write(results, folder, say, jobs=number)
        return
    process = _Process(number)
    try:
        yield process.begin
    finally:
        process.end()


class _Process:
    """A copy of this process that writes one report."""

    def __init__(self, jobs: int) -> None:
        context = get_context("fork")
        self._connection, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, self._connection, jobs))
        with hold_signals():
            self._process.start()
        theirs.close()
        self._asked = self._answered = False

    def begin(self, results: Results, folder: Path, say: Say) -> Callable[[], Path]:
        self._asked = True
        try:
            self._connection.send((results, folder))
        except ConnectionError:
            raise self._ended() from None
        return partial(self._wait, say)

    def _wait(self, say: Say) -> Path:
        while True:
            told = self._told()
            if isinstance(told, str):
                say(told)
                continue
            self._answered = True
            if isinstance(told, BaseException):
                raise told
            assert isinstance(told, Path)  # all that is told
            return told

    def _told(self) -> object:
        try:
            return self._connection.recv()
        except (EOFError, ConnectionError):
            raise self._ended() from None

    def _ended(self) -> RuntimeError:
        self._process.join()
        return RuntimeError(f"the process that writes the report ended by itself (exit code {self._process.exitcode})")

    def end(self) -> None:
        """Wait until it has ended; what it has not begun or not finished is not wanted any more."""
        self._connection.close()
        if not self._asked:
            self._process.kill()
        elif not self._answered:
            self._process.terminate()
        self._process.join()


def _serve(connection: Connection, other_end: Connection, jobs: int) -> None:
    """Get ready, write what comes, tell the stages, and last the path or what went wrong."""
    other_end.close()
    end_with_parent()
    for number in ENDING:
        if signal.getsignal(number) is not signal.SIG_IGN:  # as Ctrl-C is in the background: the analysis goes on too
            signal.signal(number, _interrupt)
    try:
        hear_signals()
        with suppress(Exception):  # what goes wrong here goes wrong again when it is to write, and is told then
            import reports.writing  # noqa: F401 - while the analysis runs
        results, folder = connection.recv()
        try:
            connection.send(_write(results, folder, connection.send, jobs=jobs))
        except Exception as error:
            error.add_note(traceback.format_exc())
            connection.send(error)
    except (EOFError, OSError, KeyboardInterrupt):
        pass  # nobody waits for it


def _interrupt(*_: object) -> None:
    """End once, however often it is asked for."""
    for number in ENDING:
        signal.signal(number, lambda *_: None)  # SIG_IGN says so of one that has come already
    raise KeyboardInterrupt


def _write(results: Results, folder: Path, say: Say, *, jobs: int) -> Path:
    from reports.writing import write_all

    return write_all(results, folder, jobs=jobs, progress=say)
