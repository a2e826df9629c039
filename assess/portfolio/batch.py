"""A portfolio assessed: its projects computed, each once, and their rows written as one ranked table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from assess.errors import AssessError
from assess.outputs import manifest
from assess.outputs.folder import make_folder, output_folder, refuse_obstacles
from assess.outputs.lock import LOCK, hold_lock
from assess.portfolio.executors import Engine
from assess.portfolio.ledger import Ledger, open_ledger
from assess.portfolio.projects import Task
from assess.portfolio.row import Row
from assess.portfolio.shard import LEDGERS, WHOLE, Shard
from assess.portfolio.stream import compute_all
from assess.portfolio.tasks import Job, Keep, Runner
from assess.results.program import describe_program

COMMAND = "assess batch"
TABLE = "ranked.html"
WANTED = (TABLE, "ranked.xlsx", "ranked.csv")
WORST = (70, 2, 1, 3, 0)
"""Exit codes, the worst first."""

Writer = Callable[[Sequence[Row], Path], object]
"""Writes the ranked table of rows into a folder."""


@dataclass(frozen=True)
class Order:
    """What is asked for.

    place : folder of the outputs
    keep : what is written of each project
    shard : the share of the projects to be computed here
    resume : whether rows that are done are kept
    """

    place: Path
    keep: Keep = "report"
    shard: Shard = WHOLE
    resume: bool = False


@dataclass(frozen=True)
class Portfolio:
    """What a portfolio came to.

    rows : of this share, in the order of the projects
    left : number of projects of other shares that are not done yet; there is no table before they are
    table : the ranked table as a page; None while projects are left
    """

    rows: tuple[Row, ...]
    left: int
    table: Path | None

    @property
    def exit_code(self) -> int:
        """The worst exit code of its projects; 0 for a share without any."""
        found = {row.exit_code for row in self.rows}
        return next((code for code in WORST if code in found), 0)

    def count(self) -> Mapping[str, int]:
        """Return how many are broken, and how many came to each outcome."""
        return Counter("broken" if row.status == "broken" else row.outcome or "no verdict" for row in self.rows)


def no_progress(done: int, total: int) -> None:
    """Show nothing."""


def run_batch(
    tasks: Sequence[Task],
    order: Order,
    *,
    runner: Runner,
    engine: Engine,
    write: Writer,
    tell: Callable[[str], None],
    progress: Callable[[int, int], None] = no_progress,
) -> Portfolio:
    """Assess the projects of a portfolio that are not done, and write the ranked table once all are.

    The table depends on the rows alone: not on interruptions, on the number of workers, or on where they are.

    Parameters
    ----------
    tasks : sequence of Task
        The whole portfolio, the same for every share.
    order : Order
        What is asked for.
    runner : callable
        Assesses one project, in a worker.
    engine : callable
        Opens the executor.
    write : callable
        Writes the ranked table.
    tell : callable
        Called with a line about what is found in the folder.
    progress : callable
        Called with the number of projects that are done, and of all of this share.

    Raises
    ------
    AssessError
        If two projects have one key, the folder cannot be written, or the executor is lost.
    """
    program = describe_program().sha256
    jobs = {task.key: Job(task, order.place.absolute(), order.keep, program) for task in tasks}
    if len(jobs) < len(tasks):
        twice = next(key for key, number in Counter(task.key for task in tasks).items() if number > 1)
        raise AssessError(f"{twice!r:.100}: the key of two projects; give each its own")
    mine = [job for key, job in jobs.items() if order.shard.holds(key)]
    with _own_ledger(order) as ledger:
        done = _rows_to_keep(jobs, mine, ledger, order, tell)
        left = [job for job in mine if job.task.key not in done]
        _compute(left, len(mine), runner, engine, ledger, progress)
    rows = _known_rows(jobs, order)
    own = tuple(rows[job.task.key] for job in mine)
    if len(rows) < len(jobs):
        return Portfolio(own, len(jobs) - len(rows), None)
    with output_folder(order.place, command=COMMAND, owner=manifest.PORTFOLIO, wanted=WANTED, patient=True) as stage:
        write([rows[key] for key in jobs], stage)
    return Portfolio(own, 0, order.place / TABLE)


@contextmanager
def _own_ledger(order: Order) -> Iterator[Ledger]:
    """Open the ledger of the share, which no other command may use meanwhile."""
    with make_folder(order.place):
        refuse_obstacles(order.place, manifest.read(order.place), manifest.PORTFOLIO, WANTED)
        name = order.shard.ledger
        with hold_lock(order.place, command=COMMAND, name=f"{LOCK}-{name}"), open_ledger(order.place / name) as ledger:
            yield ledger


def _rows_to_keep(
    jobs: Mapping[str, Job], mine: Sequence[Job], ledger: Ledger, order: Order, tell: Callable[[str], None]
) -> Mapping[str, Row]:
    """Return the rows of this share that need not be computed; without `resume` begin the ledger anew."""
    found = sum(1 for _ in ledger.rows())
    if not order.resume:
        if found:
            tell(f"{ledger.path}: has {found} of an earlier run, which are computed again; --resume keeps what is done")
        ledger.clear()
        return {}
    known = _known_rows(jobs, order)
    done = {job.task.key: known[job.task.key] for job in mine if job.task.key in known}
    done = {key: row for key, row in done.items() if row.status == "done" and _has_outputs(row, order.place)}
    if found or done:
        changed = found - sum(1 for identity, row in ledger.rows() if _is_of(jobs, identity, row))
        more = f"; {changed} of other inputs, options or versions of the program are not used" if changed else ""
        tell(f"{ledger.path}: {len(done)} of {len(mine)} projects are done{more}")
    return done


def _has_outputs(row: Row, place: Path) -> bool:
    """Return whether the outputs that a row links to are still there."""
    return all((place / link).is_file() for link in (row.results, row.report) if link)


def _compute(
    left: Sequence[Job],
    total: int,
    runner: Runner,
    engine: Engine,
    ledger: Ledger,
    progress: Callable[[int, int], None],
) -> None:
    """Compute jobs, and enter their rows as they come."""
    done = total - len(left)
    progress(done, total)

    def keep(rows: Sequence[tuple[Job, Row]]) -> None:
        nonlocal done
        ledger.put([(job.identity, row) for job, row in rows])
        done += len(rows)
        progress(done, total)

    compute_all(left, total=len(left), runner=runner, engine=engine, keep=keep)


def _known_rows(jobs: Mapping[str, Job], order: Order) -> dict[str, Row]:
    """Return the rows of all ledgers of the folder, by key; of several of one project the first that is done."""
    names = {path.name for pattern in LEDGERS for path in order.place.glob(pattern)}
    known: dict[str, Row] = {}
    for name in sorted(names, key=lambda name: (name != order.shard.ledger, name)):
        with open_ledger(order.place / name) as ledger:
            for identity, row in ledger.rows():
                if _is_of(jobs, identity, row) and (row.key not in known or known[row.key].status == "broken"):
                    known[row.key] = row
    return known


def _is_of(jobs: Mapping[str, Job], identity: str, row: Row) -> bool:
    """Return whether a row is of a project as it is now."""
    return row.key in jobs and jobs[row.key].identity == identity
