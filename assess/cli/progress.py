"""Progress on stderr: a bar in a terminal, with --verbose a line for each stage, nothing elsewhere."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

from assess.cli.stderr import is_quiet, is_verbose, print_detail


class Progress(Protocol):
    """The receiver of a long command's progress."""

    def count(self, stage: str, done: int, total: int) -> None:
        """Show that `done` of `total` items of a stage are done; 0 for a total that is not known yet."""

    def step(self, stage: str) -> None:
        """Show that a stage without items has begun."""


class _Silent:
    def count(self, stage: str, done: int, total: int) -> None:
        pass

    def step(self, stage: str) -> None:
        pass


class _Timed:
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
def progress() -> Iterator[Progress]:
    """Show progress while the block runs."""
    if is_verbose():
        with _lines() as lines:
            yield lines
    elif is_quiet() or not sys.stderr.isatty() or os.environ.get("TERM") in ("dumb", "unknown"):
        yield _Silent()
    else:
        with _bar() as bar:
            yield bar


@contextmanager
def _lines() -> Iterator[Progress]:
    from assess.cli.compiled_code import compiled_since

    begin, lines = time.time(), _Timed()
    yield lines
    lines.step("")
    if found := compiled_since(begin):
        print_detail(found)


@contextmanager
def _bar() -> Iterator[Progress]:
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
