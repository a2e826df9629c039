"""A process that writes the report: where one can be forked, it gets ready while the analysis runs.

The modules that draw pages take a second to import; for most of that time the analysis leaves a second core idle.
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

Progress = Callable[[str], None]
Begin = Callable[["Results", Path, Progress], Callable[[], Path]]
"""Begins to write a report into a folder and reports the stages; returns what waits for the path of the PDF."""


@contextmanager
def report_writer(jobs: int | None) -> Iterator[Begin]:
    """Provide a function that writes a report by `jobs` processes, on all cores if None."""
    number = jobs or available_cores()
    if number == 1 or sys.platform != "linux":
        yield lambda results, folder, progress: lambda: _write(results, folder, progress, jobs=number)
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
        self._has_begun = self._has_replied = False

    def begin(self, results: Results, folder: Path, progress: Progress) -> Callable[[], Path]:
        self._has_begun = True
        try:
            self._connection.send((results, folder))
        except ConnectionError:
            raise self._ended() from None
        return partial(self._wait, progress)

    def _wait(self, progress: Progress) -> Path:
        while True:
            reply = self._receive()
            if isinstance(reply, str):
                progress(reply)
                continue
            self._has_replied = True
            if isinstance(reply, BaseException):
                raise reply
            assert isinstance(reply, Path)  # the last of what it sends
            return reply

    def _receive(self) -> object:
        try:
            return self._connection.recv()
        except (EOFError, ConnectionError):
            raise self._ended() from None

    def _ended(self) -> RuntimeError:
        self._process.join()
        return RuntimeError(f"the process that writes the report ended by itself (exit code {self._process.exitcode})")

    def end(self) -> None:
        """End it, whatever it has not begun or not finished, and wait for that."""
        self._connection.close()
        if not self._has_begun:
            self._process.kill()
        elif not self._has_replied:
            self._process.terminate()
        self._process.join()


def _serve(connection: Connection, other_end: Connection, jobs: int) -> None:
    """Get ready, write the results received, send the stages, and last the path or the error."""
    other_end.close()
    end_with_parent()
    for number in ENDING:
        if signal.getsignal(number) is not signal.SIG_IGN:  # as Ctrl-C is in the background: the analysis goes on too
            signal.signal(number, _interrupt)
    try:
        hear_signals()
        with suppress(Exception):  # an error here comes again when it is to write, and is sent then
            import reports.writing  # noqa: F401 - while the analysis runs
        results, folder = connection.recv()
        try:
            connection.send(_write(results, folder, connection.send, jobs=jobs))
        except Exception as error:
            error.add_note(traceback.format_exc())
            connection.send(error)
    except (EOFError, OSError, KeyboardInterrupt):
        pass  # no one waits for it


def _interrupt(*_: object) -> None:
    """Interrupt once, however often the signal comes."""
    for number in ENDING:
        signal.signal(number, lambda *_: None)  # SIG_IGN says so of one that has come already
    raise KeyboardInterrupt


def _write(results: Results, folder: Path, progress: Progress, *, jobs: int) -> Path:
    from reports.writing import write_all

    return write_all(results, folder, jobs=jobs, progress=progress)
