"""Processes that work for this one, and end with it however it ends."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import active_children, get_context, parent_process
from typing import Any


def end_with_parent() -> None:
    """Let this process end as soon as the one that started it has ended, even if that was killed."""
    threading.Thread(target=_wait_for_parent, daemon=True, name="parent").start()


def _wait_for_parent() -> None:
    if (parent := parent_process()) is not None:
        parent.join()
        os._exit(1)


def become_worker(keep: Callable[..., None] | None = None, *arguments: Any) -> None:
    """Begin as a worker: signals are the parent's to hear, which ends its workers; `keep` is called with the rest."""
    for name, handler in (("SIGINT", signal.SIG_IGN), ("SIGTERM", signal.SIG_DFL), ("SIGHUP", signal.SIG_DFL)):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), handler)
    end_with_parent()
    if keep is not None:
        keep(*arguments)


class SpawnedPool(ProcessPoolExecutor):
    """Fresh processes, which import what they need; they start when they are given something to do."""

    def __init__(self, number: int) -> None:
        super().__init__(number, mp_context=get_context("spawn"), initializer=become_worker)

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Any:
        with _interrupts_held_back():
            return super().submit(fn, *args, **kwargs)


@contextmanager
def ended_on_error(pool: ProcessPoolExecutor) -> Iterator[None]:
    """Shut the pool down after the block; at once, whatever it is doing, where the block raises."""
    try:
        yield
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        for child in active_children():
            child.terminate()
        pool.shutdown()
        raise
    pool.shutdown()


@contextmanager
def _interrupts_held_back() -> Iterator[None]:
    """Start processes with Ctrl-C held back, which they stay deaf to; here it is heard after the block."""
    if sys.platform == "win32" or threading.current_thread() is not threading.main_thread():
        yield
        return
    from multiprocessing.resource_tracker import ensure_running

    ensure_running()  # which would let them through again
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
