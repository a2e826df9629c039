"""Signals that ask the program to end: they end it in order, and never within a step that must be whole."""

from __future__ import annotations

import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGALRM") if hasattr(signal, name))
"""Signals that ask a program to end: Ctrl-C, `kill`, a closed terminal, and the repetition of one of these."""
AGAIN = 0.5  # s


class Terminated(BaseException):
    """A signal asked the program to end.

    It is not a KeyboardInterrupt, on which typer ends with 130 without a word.

    asked : the number of the signal, or a text that ends in its name: reportlab raises an error again with its place
    """

    def __init__(self, asked: int | str) -> None:
        found = signal.Signals(asked) if isinstance(asked, int) else signal.Signals[asked.split()[-1]]
        super().__init__(found.name)
        self.number = int(found)


@contextmanager
def raise_on_signals() -> Iterator[None]:
    """Let signals that ask for the end raise Terminated while the block runs.

    It is raised again until it is on its way: compiled libraries that call Python, as numba does, may drop it. What
    then cleans up is not interrupted by another signal.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []

    def terminate(number: int, _: object) -> None:
        came.append(number)
        _repeat(AGAIN)
        if not _is_under_way():
            raise Terminated(came[0])

    heard = [number for number in ENDING if signal.getsignal(number) is not signal.SIG_IGN]  # as nohup has it
    before = {number: signal.signal(number, terminate) for number in heard}
    try:
        yield
    finally:
        if came:
            _repeat(0.0)
        for number, handler in before.items():
            signal.signal(number, handler)


@contextmanager
def defer_signals() -> Iterator[None]:
    """Hold back signals that ask for the end until the block has ended."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[int] = []
    ending = [number for number in ENDING if callable(signal.getsignal(number))]
    before = {number: signal.signal(number, lambda number, _: came.append(number)) for number in ending}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if came:
            signal.raise_signal(came[0])


def _is_under_way() -> bool:
    """Return whether the program is ending: whether what runs now cleans up after Terminated."""
    error = sys.exc_info()[1]
    while error is not None and not isinstance(error, Terminated):
        error = error.__context__
    return error is not None


def _repeat(seconds: float) -> None:
    """Let SIGALRM come every so many seconds, never for 0; not on Windows."""
    if sys.platform != "win32":
        signal.setitimer(signal.ITIMER_REAL, seconds, seconds)
