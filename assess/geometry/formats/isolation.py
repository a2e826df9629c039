"""Third-party readers isolated: kept silent, and run in processes of their own where damaged files crash them."""

from __future__ import annotations

import io
import math
import os
import subprocess
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from pathlib import Path

MIN_TIME, SPEED = 60.0, 4e3  # s that any file may take, bytes to a further second: good files take up to 1 s for 20 kB
CLOCK_FACTOR = 5.0  # a busy machine may give it a fifth of the clock's time
OUT_OF_TIME = -24  # the code of a process that the kernel ended by SIGXCPU

LIMITED = """
try:
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, ({seconds}, {seconds} + 1))  # the kernel's limit ends an orphan too
except ImportError:
    pass
"""


def run_in_subprocess(code: str, file: Path, *more: str, name: str) -> int:
    """Run Python `code` in a process of its own, with the paths as its arguments, and return its exit code.

    Parameters
    ----------
    code : Python source
    file : its first argument, by whose size its time is limited
    more : further arguments
    name : of the reader, for errors

    Raises
    ------
    ValueError : it crashed, or took more processor time than a file of this size may
    """
    allowed = math.ceil(MIN_TIME + file.stat().st_size / SPEED)
    command = [sys.executable, "-c", LIMITED.format(seconds=allowed) + code, str(file.absolute()), *more]
    try:
        ended = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=CLOCK_FACTOR * allowed, check=False
        ).returncode
    except subprocess.TimeoutExpired:
        ended = OUT_OF_TIME
    if ended == OUT_OF_TIME:
        raise ValueError(f"{name} has not read it after {allowed} s; is it damaged? save it again")
    if ended < 0:
        raise ValueError(f"{name} crashed on it; it is damaged, save it again")
    return ended


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
