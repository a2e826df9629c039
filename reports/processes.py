"""Several processes for one document: where the system can copy a process, figures are drawn beside the pages."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Any


class _Here(Executor):
    """Does what is asked at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        done: Future[Any] = Future()
        done.set_result(fn(*args, **kwargs))
        return done


class _Copies(ProcessPoolExecutor):
    """Copies of this process, which need not import anything again.

    Copies have no threads but their own. None of this program's holds a lock at that moment: those of the dynamics have
    ended, that of the progress bar locks its console only, of which no copy says anything. Python warns all the same.
    """

    def __init__(self, jobs: int) -> None:
        super().__init__(jobs, mp_context=get_context("fork"))

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*use of fork", category=DeprecationWarning)
            return super().submit(fn, *args, **kwargs)


@contextmanager
def processes(jobs: int) -> Iterator[Executor]:
    """What does work on `jobs` processes besides this one; at 1, and where a process cannot be copied, in this one.

    An error ends the rest: what has not begun is not done.
    """
    copies = jobs > 1 and sys.platform == "linux"
    pool: Executor = _Copies(jobs) if copies else _Here()
    try:
        yield pool
    except BaseException:
        pool.shutdown(cancel_futures=True)
        raise
    pool.shutdown()
