"""Several processes for one document: where a process can be forked, figures are drawn while pages are set."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Any

from assess.workers import become_worker, end_on_error, hold_signals


class _Here(Executor):
    """An executor that works at once, in this process."""

    def __init__(self, subject: object) -> None:
        self._subject = subject

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        done: Future[Any] = Future()
        done.set_result(fn(self._subject, *args, **kwargs))
        return done


class _Copies(ProcessPoolExecutor):
    """Copies of this process, which need not import anything again, nor be sent the subject.

    Copies have no threads but their own. None of this program's holds a lock at that moment: those of the dynamics have
    ended, that of the progress bar locks its console only, to which no copy writes. Python warns all the same.
    """

    def __init__(self, jobs: int, subject: object) -> None:
        super().__init__(jobs, mp_context=get_context("fork"), initializer=become_worker, initargs=(_keep, subject))

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        with hold_signals(), warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*use of fork", category=DeprecationWarning)
            return super().submit(_of_kept, fn, *args, **kwargs)


Pool = _Here | _Copies
_kept: object = None  # the subject; set in copies only


def _keep(subject: object) -> None:
    global _kept
    _kept = subject


def _of_kept(fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Any:
    return fn(_kept, *args, **kwargs)


@contextmanager
def processes(jobs: int, subject: object) -> Iterator[Pool]:
    """Provide a pool of `jobs` processes besides this one; at 1, and where a process cannot be copied, this one.

    A function that is submitted gets the `subject` before its arguments: that need not be sent, however large it is.
    An error ends the rest at once.
    """
    if jobs == 1 or sys.platform != "linux":
        yield _Here(subject)
        return
    pool = _Copies(jobs, subject)
    with end_on_error(pool):
        yield pool
