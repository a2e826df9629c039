"""Lines on stderr besides errors: warnings and notes, progress, and what stands after an interruption.

Progress is a bar in a terminal, with --verbose a line for each stage, nothing elsewhere.
"""

from __future__ import annotations

import logging
import os
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Protocol

from assess.messages.message import Message, escape_text
from assess.outputs.signals import Terminated

MAX_LINES = 5
QUIET, USUAL, VERBOSE = logging.ERROR, logging.INFO, logging.DEBUG
LEVELS = {"error": logging.ERROR, "warning": logging.WARNING, "note": logging.INFO}
LOG = logging.getLogger("assess.cli")
NOTHING_WRITTEN = "nothing was written"


class _Stderr(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        print(record.getMessage(), file=sys.stderr)


def log_to_stderr() -> None:
    """Let what the commands say go to stderr, as much as is usual."""
    LOG.handlers, LOG.propagate = [_Stderr()], False
    LOG.setLevel(USUAL)


def print_warnings(warnings: Sequence[str], *, of: str = "records with warnings") -> None:
    """Print a line for each warning that is not empty, the first few of many; of : what the others are."""
    found = [warning for warning in warnings if warning]
    more = [f"and {len(found) - MAX_LINES} more {of}"] if len(found) > MAX_LINES else []
    for text in (*found[:MAX_LINES], *more):
        LOG.warning("assess: warning: %s", escape_text(text))


def print_message(message: Message) -> None:
    """Print a message on one line."""
    where, text = escape_text(message.where), escape_text(message.text)
    LOG.log(LEVELS[message.severity], "assess: %s: %s: %s", message.severity, where, text)


def print_messages(messages: Sequence[Message]) -> None:
    """Print messages as the tables of results do, which JSON and CSV leave out."""
    for each in messages:
        LOG.log(LEVELS[each.severity], "%s: %s: %s", each.severity, escape_text(each.where), escape_text(each.text))


def print_note(text: str) -> None:
    """Print a note on what was found or done."""
    LOG.info("assess: note: %s", escape_text(text))


def print_detail(text: str) -> None:
    """Print, with --verbose only, a line on what is being done."""
    LOG.debug("assess: %s", escape_text(text))


@contextmanager
def on_interruption(what_stands: str) -> Iterator[None]:
    """Add to an interruption of the block what then stands."""
    try:
        yield
    except (Terminated, KeyboardInterrupt) as stop:
        stop.add_note(what_stands)
        raise


class ProgressDisplay(Protocol):
    """The receiver of a long command's progress."""

    def count(self, stage: str, done: int, total: int) -> None:
        """Show that `done` of `total` items of a stage are done; 0 for a total that is not known yet."""

    def step(self, stage: str) -> None:
        """Show that a stage without items has begun."""


class _NoProgress:
    def count(self, stage: str, done: int, total: int) -> None:
        pass

    def step(self, stage: str) -> None:
        pass


class _TimedStages:
    """A line for each stage when it ends: its time and, where they are counted, its items."""

    def __init__(self) -> None:
        self._stage, self._items, self._begin = "reading", 0, time.perf_counter()

    def count(self, stage: str, done: int, total: int) -> None:
        if stage != self._stage:
            self.step(stage)
        self._items = total

    def step(self, stage: str) -> None:
        items = f", {self._items} items" if self._items > 1 else ""
        now = time.perf_counter()
        print_detail(f"{self._stage}: {now - self._begin:.2f} s{items}")
        self._stage, self._items, self._begin = stage, 0, now


@contextmanager
def progress() -> Iterator[ProgressDisplay]:
    """Show progress while the block runs."""
    if is_verbose():
        with _progress_lines() as lines:
            yield lines
    elif _is_quiet() or not sys.stderr.isatty() or os.environ.get("TERM") in ("dumb", "unknown"):
        yield _NoProgress()
    else:
        with _progress_bar() as bar:
            yield bar


def is_verbose() -> bool:
    """Whether --verbose was given."""
    return LOG.isEnabledFor(VERBOSE)


def _is_quiet() -> bool:
    """Whether --quiet was given."""
    return not LOG.isEnabledFor(USUAL)


@contextmanager
def _progress_lines() -> Iterator[ProgressDisplay]:
    begin, lines = time.time(), _TimedStages()
    yield lines
    lines.step("")
    if found := _describe_compiled_code(begin):
        print_detail(found)


@contextmanager
def _progress_bar() -> Iterator[ProgressDisplay]:
    from rich.console import Console
    from rich.markup import escape
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Display

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Display(*columns, console=Console(stderr=True), transient=True) as display:
        task = display.add_task("reading", total=None)

        class Bar:
            shown = ""

            def count(self, stage: str, done: int, total: int) -> None:
                """Draw at once what is new, also if it ends before the display draws again by itself."""
                new, self.shown = stage != self.shown, stage
                display.update(task, description=escape(stage), completed=done, total=total or None, refresh=new)

            def step(self, stage: str) -> None:
                self.count(stage, 0, 0)

        yield Bar()


def _describe_compiled_code(begin: float) -> str:
    """Return where the code of the kernels is kept and how much of it is new; empty where no kernel was used.

    begin : time in seconds of the epoch
    """
    kernel = sys.modules.get("records.compilation.kernel")
    if kernel is None:
        return ""
    folder = kernel.code_folder()
    if folder is None:
        return "machine code: no folder to keep it in; every process compiles for itself"
    files = list(folder.glob("*.code"))
    new = sum(file.stat().st_mtime >= begin for file in files)
    return f"machine code: {len(files)} kernels in {folder}, {new} compiled now"
