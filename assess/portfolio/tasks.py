"""What a worker does: it computes the rows of a few projects, and whatever happens to one does not stop the others."""

from __future__ import annotations

import hashlib
import json
import traceback
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Literal

from assess.errors import AssessError, HeldError
from assess.portfolio.folder_names import LOGS, folder_name
from assess.portfolio.projects import Task
from assess.portfolio.row import Row
from assess.results.program import describe_program
from records.errors import RecordError
from spectra.errors import SpectrumError

Keep = Literal["report", "results", "rows"]
"""What is written of each project besides its row: its report and results, its results alone, or nothing."""
INPUT_IS_WRONG, BUG = 2, 70
LONGEST_REASON = 1000  # characters


@dataclass(frozen=True)
class Job:
    """A task as a worker gets it.

    place : folder of the portfolio's outputs, where every worker can write
    keep : what is written of the project
    program : digest of the program that gives it out, which is to be the worker's own
    """

    task: Task
    place: Path
    keep: Keep
    program: str

    @property
    def folder(self) -> Path:
        """The folder for the outputs of the project."""
        return self.place / folder_name(self.task.key)

    @property
    def identity(self) -> str:
        """The hash of all that its row depends on: what the project reads, the program, and what is written."""
        whole = json.dumps([self.task.key, self.task.title, self.task.sha256, self.program, self.keep])
        return hashlib.sha256(whole.encode()).hexdigest()


Runner = Callable[[Job], Row]
"""Assesses a project and returns its row. It is a function of a module, which a worker imports by its name."""


@dataclass(frozen=True)
class Computed:
    """Rows in the order of their jobs, and the time they took [s]."""

    rows: tuple[Row, ...]
    seconds: float


def compute_rows(runner: Runner, jobs: Sequence[Job]) -> Computed:
    """Compute the rows of some jobs; this is what is sent to a worker.

    Raises
    ------
    AssessError : the worker runs another version of the program, whose numbers may differ
    HeldError : another worker, thought to be lost, is still writing the same outputs
    """
    start = perf_counter()
    if any(job.program != describe_program().sha256 for job in jobs):
        raise AssessError("a worker runs another version of this program; install the same one on all machines")
    return Computed(tuple(row_of_job(runner, job) for job in jobs), perf_counter() - start)


def row_of_job(runner: Runner, job: Job) -> Row:
    """Return the row of a project; one that cannot be assessed is broken, with the reason in one line."""
    try:
        return runner(job)
    except HeldError:
        raise
    except (AssessError, RecordError, SpectrumError) as error:
        return broken_row(job, str(error), INPUT_IS_WRONG)
    except MemoryError:
        return broken_row(job, "not enough memory; resume with fewer --jobs", BUG)
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return broken_row(job, f"{where}{error.strerror or error}; check the path and its permissions", INPUT_IS_WRONG)
    except Exception as error:
        return broken_row(job, f"internal error: {type(error).__name__}: {error} (log: {_log(job)})", BUG)


def broken_row(job: Job, reason: str, exit_code: int) -> Row:
    """Return the row of a project that could not be assessed.

    Parameters
    ----------
    job : Job
        Of the project.
    reason : str
        Why, and what the user can do; reduced to one line.
    exit_code : int
        2 for wrong input, 70 for a fault of the program or its machine.
    """
    line = " ".join("".join(c if c.isprintable() else " " for c in reason).split())
    if len(line) > LONGEST_REASON:
        line = f"{line[: LONGEST_REASON - 1]}…"
    task = job.task
    return Row(task.key, task.title, task.sha256, "broken", reason=line, exit_code=exit_code)


def _log(job: Job) -> str:
    """Write the traceback into the folder of the portfolio, under a name that depends on the key alone."""
    name = f"{LOGS}/{folder_name(job.task.key)}.log"
    try:
        (job.place / LOGS).mkdir(exist_ok=True)
        (job.place / name).write_text(traceback.format_exc(), encoding="utf-8", errors="backslashreplace")
    except OSError as error:
        return f"not written, {error.strerror}"
    return name
