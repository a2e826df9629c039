"""Progress on stderr: a bar in a terminal, nothing elsewhere."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol


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


@contextmanager
def progress() -> Iterator[Progress]:
    """Show progress while the block runs."""
    if not sys.stderr.isatty():
        yield _Silent()
        return
    with _bar() as bar:
        yield bar


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
            def count(self, stage: str, done: int, total: int) -> None:
                display.update(task, description=escape(stage), completed=done, total=total or None)

            def step(self, stage: str) -> None:
                display.update(task, description=escape(stage), completed=0, total=None)

        yield Bar()
