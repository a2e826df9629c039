"""Worker processes, which end with this process however it ends, and a thread that does what was asked last."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, InvalidStateError, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import active_children, get_context, parent_process
from multiprocessing.resource_tracker import ensure_running
from typing import Any

from assess.outputs.signals import ENDING


def become_worker(keep: Callable[..., None] | None = None, *arguments: Any) -> None:
    """Start as a worker: leave signals to the parent, which ends its workers, and call `keep` with the arguments."""
    for number in ENDING:
        signal.signal(number, signal.SIG_IGN if number == signal.SIGINT else signal.SIG_DFL)
    _hear_signals()
    _end_with_parent()
    if keep is not None:
        keep(*arguments)


class SpawnedPool(ProcessPoolExecutor):
    """Spawned processes, which import what they need; they start with the first task."""

    def __init__(self, number: int) -> None:
        super().__init__(number, mp_context=get_context("spawn"), initializer=become_worker)

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Any:
        with hold_signals():
            return super().submit(fn, *args, **kwargs)


def available_cores() -> int:
    """Return the number of processor cores that this process may use."""
    allowed = getattr(os, "sched_getaffinity", None)
    return len(allowed(0)) if allowed is not None else os.cpu_count() or 1


@contextmanager
def process_pool(jobs: int | None) -> Iterator[Executor | None]:
    """Provide an executor of `jobs` processes, of all cores if None; None for a single one, which is this process.

    Its workers start only when they are given something to do.
    """
    number = jobs or available_cores()
    if number == 1:
        yield None
        return
    pool = SpawnedPool(number)
    with end_on_error(pool):
        yield pool


@contextmanager
def end_on_error(pool: ProcessPoolExecutor) -> Iterator[None]:
    """Shut the pool down after the block; at once if the block raises, whatever it is doing."""
    try:
        yield
    except BaseException:
        with _silence_broken_pools():
            for child in active_children():
                child.terminate()
            pool.shutdown(cancel_futures=True)
        raise
    pool.shutdown()


class Newest:
    """Does one job at a time in a thread, and of those that wait only the one that came last."""

    def __init__(self, name: str) -> None:
        self._ready = threading.Condition()
        self._waiting: Callable[[], None] | None = None
        self._closed = self._busy = False
        self._thread = threading.Thread(target=self._work, name=name, daemon=True)
        self._thread.start()

    def ask(self, job: Callable[[], None]) -> None:
        """Do a job as soon as the one in hand is done; one that waits is dropped."""
        with self._ready:
            self._waiting = job
            self._ready.notify_all()

    def wait(self, seconds: float) -> bool:
        """Wait until nothing is left to be done; return whether that is so."""
        with self._ready:
            return self._ready.wait_for(lambda: self._waiting is None and not self._busy, seconds)

    def close(self) -> None:
        """Do no more jobs, but for the one in hand."""
        with self._ready:
            self._closed = True
            self._ready.notify_all()

    def _work(self) -> None:
        while True:
            with self._ready:
                self._busy = False
                self._ready.notify_all()
                self._ready.wait_for(lambda: self._waiting is not None or self._closed)
                if self._closed or self._waiting is None:
                    return
                job, self._waiting, self._busy = self._waiting, None, True
            job()


@contextmanager
def hold_signals() -> Iterator[None]:
    """Block signals within the block, so that processes started there ignore them until they call `_hear_signals`.

    Here signals arrive after the block. A process that is just starting would print a traceback of its own.
    """
    if sys.platform == "win32" or threading.current_thread() is not threading.main_thread():
        yield
        return
    ensure_running()  # which would let them through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _end_with_parent() -> None:
    """Let this process end as soon as its parent has ended, even if that was killed."""
    threading.Thread(target=_wait_for_parent, daemon=True, name="parent").start()


def _wait_for_parent() -> None:
    if (parent := parent_process()) is not None:
        parent.join()
        os._exit(1)


@contextmanager
def _silence_broken_pools() -> Iterator[None]:
    """Keep a pool whose workers are terminated from reporting futures that were just cancelled."""
    before = threading.excepthook
    threading.excepthook = lambda seen: None if seen.exc_type is InvalidStateError else before(seen)
    try:
        yield
    finally:
        threading.excepthook = before


def _hear_signals() -> None:
    """Unblock signals in a process that was started while they were blocked."""
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING)
