"""Third-party readers kept silent, so that what they print and log never mixes with results."""

from __future__ import annotations

import io
import os
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress


@contextmanager
def silence_output() -> Iterator[None]:
    """Suppress what packages print, log or warn of; the errors that they raise say the same."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()
    with (
        warnings.catch_warnings(),
        redirect_stdout(io.StringIO()),
        redirect_stderr(io.StringIO()),
        _silence_descriptors(),
    ):
        warnings.simplefilter("ignore")
        yield


@contextmanager
def _silence_descriptors() -> Iterator[None]:
    """Redirect the streams of the process, to which compiled packages write, to nowhere."""
    kept = {stream: saved for stream in (1, 2) if (saved := _duplicate(stream)) is not None}
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for stream in kept:
            os.dup2(nowhere, stream)
        yield
    finally:
        for stream, saved in kept.items():
            os.dup2(saved, stream)
            os.close(saved)
        os.close(nowhere)


def _duplicate(stream: int) -> int | None:
    """Duplicate a stream of the process; None where it has been closed."""
    try:
        return os.dup(stream)
    except OSError:
        return None
