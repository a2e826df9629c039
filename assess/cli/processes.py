"""The processes that read record files, as many as `--jobs` says."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import Annotated

import typer

Jobs = Annotated[int | None, typer.Option("--jobs", metavar="N", min=1, help="Processor cores to use; all if absent.")]


@contextmanager
def processes(jobs: int | None) -> Iterator[Executor | None]:
    """An executor of `jobs` processes, of all cores if None; None for a single one, which is this process.

    Its workers start only when it is given something to do.
    """
    number = jobs or os.cpu_count() or 1
    if number == 1:
        yield None
        return
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    with ProcessPoolExecutor(number, mp_context=get_context("spawn")) as executor:
        yield executor
