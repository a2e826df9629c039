"""Signals that ask for the end end the program, whatever drops them, and not the cleaning up."""

from __future__ import annotations

import contextlib
import signal
import sys
import time

import pytest
from reportlab.lib.utils import annotateException

from assess.outputs.signals import Terminated, defer_signals, raise_on_signals


def drop_a_signal() -> None:
    with raise_on_signals():
        with contextlib.suppress(Terminated):  # as a library does that calls Python from C
            signal.raise_signal(signal.SIGINT)
        time.sleep(60.0)


def clean_up(steps: list[str]) -> None:
    with raise_on_signals():
        try:
            signal.raise_signal(signal.SIGTERM)
        finally:
            signal.raise_signal(signal.SIGINT)
            steps.append("clean")
            try:
                raise ValueError
            except ValueError:
                signal.raise_signal(signal.SIGINT)
                steps.append("clean within another error")


def write_whole(steps: list[str]) -> None:
    with raise_on_signals():
        with defer_signals():
            signal.raise_signal(signal.SIGINT)
            steps.append("whole")
        steps.append("after it")


@pytest.mark.skipif(sys.platform == "win32", reason="it has no timers that send signals")
def test_a_signal_that_is_dropped_comes_again() -> None:
    with pytest.raises(Terminated) as ended:
        drop_a_signal()
    assert ended.value.number == signal.SIGINT
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


def test_cleaning_up_is_not_interrupted() -> None:
    steps: list[str] = []
    with pytest.raises(Terminated) as ended:
        clean_up(steps)
    assert steps == ["clean", "clean within another error"]
    assert ended.value.number == signal.SIGTERM


def test_a_signal_waits_for_what_must_be_whole() -> None:
    steps: list[str] = []
    with pytest.raises(Terminated):
        write_whole(steps)
    assert steps == ["whole"]


def test_a_signal_is_known_again_where_reportlab_raises_it_with_its_place():
    """A run that was killed while a page was laid out ended with 70 and "is not a valid Signals"."""
    try:
        raise Terminated(signal.SIGTERM)
    except Terminated:
        with pytest.raises(Terminated) as ended:
            annotateException("\nraised by class KeepTogether wrap\n")
    assert ended.value.number == signal.SIGTERM
