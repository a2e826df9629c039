"""One task of a portfolio as a worker computes it, the row that it gives, and the order of rows.

A ranked table begins with what fails, by how little it bears; what is broken comes last.
"""

from __future__ import annotations

import hashlib
import json
import re
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf, isfinite
from pathlib import Path
from time import perf_counter
from typing import Literal

from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.errors import AssessError, FullDiskError, HeldError
from assess.messages.message import Message, Severity
from assess.portfolio.projects import Task
from assess.results.provenance import describe_program
from records.errors import RecordError
from spectra.errors import SpectrumError

Keep = Literal["report", "results", "rows"]
"""What is written of each project besides its row: its report and results, its results alone, or nothing."""
INPUT_IS_WRONG, BUG = 2, 70
Status = Literal["done", "broken"]
RowOutcome = Literal["pass", "fail", "incomplete", ""]
EXIT_CODES: Mapping[Decision, int] = {Decision.PASS: 0, Decision.FAIL: 1, Decision.INCOMPLETE: 3}
"""Exit codes of `assess run`; a run without a verdict counts as incomplete."""
WORST_FIRST = (Decision.FAIL, Decision.INCOMPLETE, Decision.PASS)
"""Outcomes in the order of a ranking; a project without any verdict stands with the incomplete ones."""
LONGEST_REASON = 1000  # characters
NO_VERDICT = "no verdict: nothing says what the project is held against; give it a site"
LONGEST_NAME = 48  # characters of a key that are kept: paths have an end on Windows
LOGS = "logs"


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


@dataclass(frozen=True)
class ProjectRow:
    """One project of a portfolio, assessed or broken. It is plain: processes and the ledger exchange it as it is.

    key : path of the project below the folder, or its cell in the table's id column
    title : title of the project
    sha256 : of everything the task reads
    status : "done", or "broken" for a project that could not be assessed
    reason : why it is broken or incomplete, in one line; "" for one that passes or fails
    outcome : of the verdict; "" where there is none
    basis : what decides, such as "ntc2018"
    limit_state : the limit state that decides
    worst_mechanism : name of the mechanism with the smallest margin
    margin : PGA at its capacity over that of the action [-]; None where unknown
    demand_capacity : its deciding demand over capacity [-]; None where unknown
    procedure : the procedure that gives it
    missing : number of inputs that the verdict lacks
    warnings : number of warnings on the input, as `assess check` prints them
    mechanisms : number of mechanisms
    report : link to the report, relative to the table; "" for none
    results : link to results.json, relative to the table; "" for none
    exit_code : that of `assess run`: 0 pass, 1 fail, 3 incomplete, 2 wrong input, 70 a bug
    unsourced : keys of the values that help and that no source vouches for; the outcome is that of the worse state
    carried : heading and text of the cells of the user's table that the ranked table shows
    """

    key: str
    title: str
    sha256: str
    status: Status
    reason: str = ""
    outcome: RowOutcome = ""
    basis: str = ""
    limit_state: str = ""
    worst_mechanism: str = ""
    margin: float | None = None
    demand_capacity: float | None = None
    procedure: str = ""
    missing: int = 0
    warnings: int = 0
    mechanisms: int = 0
    report: str = ""
    results: str = ""
    exit_code: int = 0
    unsourced: str = ""
    carried: tuple[tuple[str, str], ...] = ()

    def __post_init__(self) -> None:
        """Make tuples of what comes out of the ledger as lists."""
        object.__setattr__(self, "carried", tuple((heading, text) for heading, text in self.carried))


Runner = Callable[[Job], ProjectRow]
"""Assesses a project and returns its row. It is a function of a module, which a worker imports by its name."""


@dataclass(frozen=True)
class Computed:
    """Rows in the order of their jobs, and the time they took [s]."""

    rows: tuple[ProjectRow, ...]
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
    return Computed(tuple(_row_of_job(runner, job) for job in jobs), perf_counter() - start)


def broken_row(job: Job, reason: str, exit_code: int) -> ProjectRow:
    """Return the row of a project that could not be assessed.

    Parameters
    ----------
    job : of the project
    reason : why, and what the user can do; reduced to one line
    exit_code : 2 for wrong input, 70 for a fault of the program or its machine
    """
    task = job.task
    return ProjectRow(
        task.key, task.title, task.sha256, "broken", reason=_one_line(reason), exit_code=exit_code, carried=task.carried
    )


def row_of_verdict(
    job: Job, found: Verdict | None, messages: Sequence[Message] = (), *, report: str = "", results: str = ""
) -> ProjectRow:
    """Return the row of a project that was assessed, by its worst mechanism and the answer that is worst there.

    Parameters
    ----------
    job : of the project
    found : of its run
    messages : on its input
    report, results : links to its report and to its results.json; "" for none
    """
    task = job.task
    warnings = sum(each.severity is Severity.WARNING for each in messages)
    if found is None:
        row = ProjectRow(task.key, task.title, task.sha256, "done", NO_VERDICT, report=report, results=results)
        row = replace(row, carried=task.carried)
        return replace(row, warnings=warnings, exit_code=EXIT_CODES[Decision.INCOMPLETE])
    one = min(found.mechanisms, key=_mechanism_severity, default=None)
    answer = None if one is None else min(one.answers, key=_answer_severity, default=None)
    return ProjectRow(
        key=task.key,
        title=task.title,
        sha256=task.sha256,
        status="done",
        reason=_reason(found, answer),
        outcome=found.outcome.value,
        basis=found.basis,
        limit_state="" if answer is None else answer.limit_state,
        worst_mechanism="" if one is None else one.mechanism,
        margin=None if one is None else one.margin,
        demand_capacity=None if answer is None else answer.ratio,
        procedure="" if answer is None else answer.procedure,
        missing=len(found.missing),
        unsourced=", ".join(each.key for each in found.overrides if not each.source),
        warnings=warnings,
        mechanisms=len(found.mechanisms),
        report=report,
        results=results,
        exit_code=EXIT_CODES[found.outcome],
        carried=task.carried,
    )


def rank(rows: Iterable[ProjectRow]) -> tuple[ProjectRow, ...]:
    """Return the rows in the order in which an owner wants to read them.

    Projects that fail come first, then those without an answer, then those that pass, and broken ones at the end; in
    each of these the least margin first, then those of unknown margin; equals by key.
    """
    return tuple(sorted(rows, key=_rank_key))


def margin_of(row: ProjectRow) -> float:
    """Return the margin that ranks a row [-]: 1 / (D/C) where that of PGA is unknown, infinite if both are."""
    if row.margin is not None and isfinite(row.margin):
        return row.margin
    ratio = row.demand_capacity
    if ratio is None or ratio != ratio or ratio <= 0.0:
        return inf
    return 1.0 / ratio


_FIT = re.compile(rf"[a-z0-9][a-z0-9_-]{{0,{LONGEST_NAME - 1}}}")
_NOT_KEPT = re.compile(r"[^A-Za-z0-9_]+")
_LIKE_ANOTHER = re.compile(r".*-[0-9a-f]{10}")
_DEVICE = re.compile(r"con|prn|aux|nul|com\d|lpt\d")  # which Windows takes for devices


def folder_name(key: str) -> str:
    """Return the name of the folder for the outputs of a project.

    A key that is a name on every system stays as it is; any other is shortened to letters, digits and hyphens, and gets
    the beginning of its SHA-256, so that two keys never share a folder, not even on disks that ignore case. The name
    depends on the key alone.

    Parameters
    ----------
    key : of the project: any text
    """
    if _FIT.fullmatch(key) and not (_LIKE_ANOTHER.fullmatch(key) or _DEVICE.fullmatch(key) or key == LOGS):
        return key
    kept = _NOT_KEPT.sub("-", key)[:LONGEST_NAME].strip("-") or "project"
    return f"{kept}-{hashlib.sha256(key.encode('utf-8', 'surrogatepass')).hexdigest()[:10]}"


def _row_of_job(runner: Runner, job: Job) -> ProjectRow:
    """Return the row of a project; one that cannot be assessed is broken, with the reason in one line."""
    try:
        return runner(job)
    except (HeldError, FullDiskError):
        raise  # of the machine and not of the project
    except (AssessError, RecordError, SpectrumError) as error:
        return broken_row(job, str(error), INPUT_IS_WRONG)
    except MemoryError:
        return broken_row(job, "not enough memory; resume with fewer --jobs", BUG)
    except OSError as error:
        where = f"{error.filename}: " if error.filename else ""
        return broken_row(job, f"{where}{error.strerror or error}; check the path and its permissions", INPUT_IS_WRONG)
    except Exception as error:
        return broken_row(job, f"internal error: {type(error).__name__}: {error} (log: {_write_log(job)})", BUG)


def _write_log(job: Job) -> str:
    """Write the traceback into the folder of the portfolio, under a name that depends on the key alone."""
    name = f"{LOGS}/{folder_name(job.task.key)}.log"
    try:
        (job.place / LOGS).mkdir(exist_ok=True)
        (job.place / name).write_text(traceback.format_exc(), encoding="utf-8", errors="backslashreplace")
    except OSError as error:
        return f"not written, {error.strerror}"
    return name


def _reason(found: Verdict, answer: Answer | None) -> str:
    """Return why a verdict is incomplete, in one line: the inputs that it lacks, else its worst answer."""
    if found.outcome is not Decision.INCOMPLETE:
        return ""
    if not found.missing:
        return "" if answer is None else _one_line(str(answer.reason))
    return _one_line("; ".join(f"{each.key}: {each.text}" for each in found.missing))


def _one_line(text: str) -> str:
    line = " ".join("".join(c if c.isprintable() else " " for c in text).split())
    return line if len(line) <= LONGEST_REASON else f"{line[: LONGEST_REASON - 1]}…"


def _mechanism_severity(one: MechanismVerdict) -> tuple[int, float, float]:
    """Return what sorts mechanisms, the worst first: by outcome, then by margin, then by demand over capacity."""
    ratios = [answer.ratio for answer in one.answers if answer.ratio is not None]
    return (WORST_FIRST.index(one.outcome), inf if one.margin is None else one.margin, -max(ratios, default=-inf))


def _answer_severity(answer: Answer) -> tuple[int, float]:
    return (WORST_FIRST.index(answer.outcome), inf if answer.ratio is None else -answer.ratio)


def _rank_key(row: ProjectRow) -> tuple[int, float, str]:
    if row.status == "broken":
        return len(WORST_FIRST), 0.0, row.key
    return WORST_FIRST.index(Decision(row.outcome or "incomplete")), margin_of(row), row.key
