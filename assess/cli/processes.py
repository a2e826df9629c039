"""The processes that read record files, as many as `--jobs` says."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager


def cores() -> int:
    """The processor cores that this process may use."""
    allowed = getattr(os, "sched_getaffinity", None)
    return len(allowed(0)) if allowed is not None else os.cpu_count() or 1


@contextmanager
def processes(jobs: int | None) -> Iterator[Executor | None]:
    """An executor of `jobs` processes, of all cores if None; None for a single one, which is this process.

    Its workers start only when it is given something to do.
    """
    number = jobs or cores()
    if number == 1:
        yield None
        return
    from assess.workers import SpawnedPool, end_on_error

    pool = SpawnedPool(number)
    with end_on_error(pool):
        yield pool
