"""Several processes for one document: where a process can be forked, figures are drawn while pages are set."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Any

from assess.workers import become_worker, end_on_error, hold_signals

Submit = Callable[..., Future[Any]]
"""Asks for a function's answer; the function gets the subject, then the arguments."""
_kept: object = None  # the subject; set in copies of this process only


@contextmanager
def processes(jobs: int, subject: object) -> Iterator[Submit]:
    """Provide `jobs` copies of this process to work on a subject, however large; this one at 1 and if not on Linux.

    Copies need not import anything again, and have no threads but their own. None of this program's holds a lock at
    that moment: those of the dynamics have ended, that of the progress bar locks its console only, to which no copy
    writes. Python warns all the same.
    """
    if jobs == 1 or sys.platform != "linux":
        yield lambda function, *arguments: _done(function(subject, *arguments))
        return
    fork = get_context("fork")
    pool = ProcessPoolExecutor(jobs, mp_context=fork, initializer=become_worker, initargs=(_keep, subject))

    def submit(function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        with hold_signals(), warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*use of fork", category=DeprecationWarning)
            return pool.submit(_of_kept, function, *arguments)

    with end_on_error(pool):
        yield submit


def _done(answer: object) -> Future[Any]:
    done: Future[Any] = Future()
    done.set_result(answer)
    return done


def _keep(subject: object) -> None:
    global _kept
    _kept = subject


def _of_kept(function: Callable[..., Any], *arguments: Any) -> Any:
    return function(_kept, *arguments)
