"""Signals that ask for the end end the program, whatever drops them, and not the cleaning up."""

from __future__ import annotations

import contextlib
import signal
import sys
import time

import pytest

from assess.outputs.signals import Terminated, defer_signals, raise_on_signals


@pytest.mark.skipif(sys.platform == "win32", reason="it has no timers that send signals")
def test_a_signal_that_is_dropped_comes_again() -> None:
    with pytest.raises(Terminated) as ended, raise_on_signals():
        with contextlib.suppress(Terminated):  # as a library does that calls Python from C
            signal.raise_signal(signal.SIGINT)
        time.sleep(60.0)
    assert ended.value.number == signal.SIGINT
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


def test_cleaning_up_is_not_interrupted() -> None:
    steps = []
    with pytest.raises(Terminated) as ended, raise_on_signals():
        try:
            signal.raise_signal(signal.SIGTERM)
        finally:
            with contextlib.suppress(OSError):
                signal.raise_signal(signal.SIGINT)
                raise OSError
            steps.append("cleaned")
            try:
                raise ValueError
            except ValueError:
                signal.raise_signal(signal.SIGINT)
                steps.append("within another error")
    assert steps == ["cleaned", "within another error"]
    assert ended.value.number == signal.SIGTERM


def test_a_signal_waits_for_what_must_be_whole() -> None:
    steps = []
    with pytest.raises(Terminated), raise_on_signals():
        with defer_signals():
            signal.raise_signal(signal.SIGINT)
            steps.append("whole")
        steps.append("never")
    assert steps == ["whole"]
