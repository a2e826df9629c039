"""Third-party readers isolated: kept silent, and run in processes of their own where damaged files crash them."""

from __future__ import annotations

import io
import math
import os
import pickle
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from pathlib import Path
from typing import TypeVar

MIN_TIME, SPEED = 60.0, 4e3  # s that any file may take, bytes to a further second: good files take up to 1 s for 20 kB
CLOCK_FACTOR = 5.0  # a busy machine may give it a fifth of the clock's time
CRASHED = "{name} crashed on it; it is damaged, save it again"
OUT_OF_TIME = -24  # the code of a process that the kernel ended by SIGXCPU

LIMITED = """
try:
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, ({seconds}, {seconds} + 1))  # the kernel's limit ends an orphan too
except ImportError:
    pass
"""

CALL = f"""
import pickle, sys
sys.path.append({str(Path(__file__).parents[3])!r})
from assess.geometry.formats.isolation import answer_request
answer_request(*sys.argv[1:])
"""

Answer = TypeVar("Answer")


class ReaderCrashError(ValueError):
    """A reader ended its process."""


def call_in_subprocess(call: Callable[[Path], Answer], file: Path, *, name: str) -> Answer:
    """Call a module's function of a file in a process of its own, and return its answer.

    Parameters
    ----------
    call : of a module, or a partial of one: it and its answer are pickled
    file : its argument, by whose size its time is limited
    name : of the reader, for errors

    Raises
    ------
    ReaderCrashError : it ended its process
    ValueError : it took more processor time than a file of this size may
    Exception : what the function raises
    """
    with tempfile.TemporaryDirectory() as folder:
        request, answer = Path(folder) / "request", Path(folder) / "answer"
        request.write_bytes(pickle.dumps(call))
        run_in_subprocess(CALL, file, str(request), str(answer), name=name)
        if not answer.is_file():
            raise ReaderCrashError(CRASHED.format(name=name))
        result, problem = pickle.loads(answer.read_bytes())
    if problem is not None:
        raise problem
    return result  # type: ignore[no-any-return]


def answer_request(file: str, request: str, answer: str) -> None:
    """Make the call that was pickled, in the process of its own, and pickle its answer or the error that it raises.

    An error of a package's own class becomes a ValueError, as such classes need not pickle.
    """
    call: Callable[[Path], object] = pickle.loads(Path(request).read_bytes())
    result, problem = None, None
    try:
        result = call(Path(file))
    except Exception as raised:
        problem = raised if type(raised).__module__ == "builtins" else ValueError(str(raised))
    Path(answer).write_bytes(pickle.dumps((result, problem)))


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
    ReaderCrashError : it crashed
    ValueError : it took more processor time than a file of this size may
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
        raise ReaderCrashError(CRASHED.format(name=name))
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
