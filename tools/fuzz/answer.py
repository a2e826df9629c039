"""One case run in this process through the real entry point, and what came back."""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import sys
import tempfile
import traceback
import unittest.mock
import warnings
from collections.abc import Callable
from concurrent.futures import Executor, Future
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import typer
from numpy.typing import NDArray

from assess.cli import main
from tools.fuzz.fuzz_input import FuzzInput

Samples = tuple[float, NDArray[np.float64]]
"""Step [s] and accelerations [n] [m/s2] of a record."""
LONGEST = 2_000_000  # characters of what is printed that are kept


@dataclass(frozen=True)
class Answer:
    """How a command ended; code None where it was killed, and `told` then says why.

    told : the last lines of a traceback, for a bug; out, err : what was printed, the folder's name taken out;
    samples : of the records that were listed; written: whether the file that the case shows is there, which `out` then
    is the text of
    """

    code: int | None
    out: str = ""
    err: str = ""
    told: str = ""
    samples: tuple[Samples, ...] = ()
    written: bool = False


class Here(Executor):
    """Computes the rows of a portfolio in this process, as starting another takes longer than most inputs."""

    def __init__(self, number: int) -> None:
        self.number = number

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Compute at once."""
        done: Future[Any] = Future()
        try:
            done.set_result(fn(*args, **kwargs))
        except Exception as error:
            done.set_exception(error)
        return done


def answer(case: FuzzInput) -> Answer:
    """Run `case` in a folder of its own."""
    folder = Path(tempfile.mkdtemp(prefix="case-"))
    before, started = os.environ.get("TMPDIR"), Path.cwd()
    try:
        for name, data in case.files.items():
            (folder / "in" / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / "in" / name).write_bytes(data)
        (folder / "tmp").mkdir()
        tempfile.tempdir = str(folder / "tmp")
        os.chdir(folder / "in")
        arguments = [part.replace("{}", str(folder / "in")) for part in case.arguments]
        got = _shown(_run(arguments, folder), folder / "in" / case.shows) if case.shows else _run(arguments, folder)
        return replace(got, samples=_samples(arguments)) if case.group == "record" and got.code == 0 else got
    finally:
        tempfile.tempdir = before
        os.chdir(started)
        shutil.rmtree(folder, ignore_errors=True)


def _run(arguments: list[str], folder: Path) -> Answer:
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8", errors=how) for how in ("strict", "backslashreplace"))
    code, told = 0, ""
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), warnings.catch_warnings():
        warnings.simplefilter("default")
        sys.modules.pop("__warningregistry__", None)
        try:
            with (
                unittest.mock.patch("typer.main.get_command", _command),
                unittest.mock.patch("assess.portfolio.executors.SpawnedPool", Here),
            ):
                main(arguments)
        except SystemExit as end:
            code = end.code if isinstance(end.code, int) else 0
        except BaseException:
            code, told = -1, traceback.format_exc()
    printed, complaints = (_text(stream, folder) for stream in (out, err))
    logs = sorted((folder / "tmp").glob("assess-*.log"))
    told = told or (logs[-1].read_text(encoding="utf-8", errors="replace") if logs else "")
    return Answer(code, printed, complaints, told[-4000:])


def _shown(got: Answer, file: Path) -> Answer:
    """The answer with the text of a file in place of what was printed, if the file is there."""
    if not file.is_file():
        return got
    return replace(got, out=file.read_text(encoding="utf-8", errors="replace"), written=True)


def _samples(arguments: list[str]) -> tuple[Samples, ...]:
    """What the reader finds in the file that was listed."""
    from records.reading import read_records

    stated = dict(pairwise(arguments))
    step = stated.get("--step")
    found = read_records(Path(arguments[2]), unit=stated.get("--unit"), step=None if step is None else float(step))
    return tuple((record.dt, np.array(record.acceleration)) for record in found)


_command = cache(typer.main.get_command)
"""The commands, made once: typer makes them anew for each call, which takes longer than most inputs."""


def _text(stream: io.TextIOWrapper, folder: Path) -> str:
    stream.flush()
    data = stream.buffer.getvalue()  # type: ignore[attr-defined]
    text: str = data[:LONGEST].decode("utf-8", "replace")
    return text.replace(str(folder / "in"), "{}").replace(str(folder), "{folder}")
