"""The stream of tasks through an executor: a few chunks at a time, whatever the number of tasks.

Tasks are given out in chunks that take about half a second, so that what a chunk costs beside its tasks is small and
little is lost where the program is killed. When a worker ends, the tasks that were given out are suspects: each is
computed again alone, and one whose worker ends then, and once more, is a broken row.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from itertools import islice

from assess.errors import AssessError, HeldError
from assess.portfolio.executors import Engine, Opened
from assess.portfolio.row import Row
from assess.portfolio.tasks import BUG, INPUT_IS_WRONG, Computed, Job, Runner, broken_row, compute_rows

CHUNK = 0.5  # s
MOST = 256  # tasks of a chunk
PATIENCE = 1.0  # s, between looks at the executor
ENDED = (
    "it ended the process that computed it, alone and twice: not enough memory, or a fault in compiled code; try it "
    "with `assess run`"
)
Keeper = Callable[[Sequence[tuple[Job, Row]]], None]
"""Takes rows as they come, with their jobs."""


def compute_all(jobs: Iterable[Job], *, total: int, runner: Runner, engine: Engine, keep: Keeper) -> None:
    """Compute every job, and hand over the rows in the order in which they are done.

    Parameters
    ----------
    jobs : iterable of Job
        What is to be computed; drawn as it is given out.
    total : int
        How many they are.
    runner : Runner
        Assesses one.
    engine : Engine
        Where it is computed.
    keep : Keeper
        Called in this process with rows that are done.

    Raises
    ------
    AssessError
        If the executor is lost, or cannot compute anything.
    """
    line, suspects, losses = _Line(jobs, total), list[Job](), Counter[str]()
    while line.left or suspects:
        with engine() as opened:
            if suspects:
                suspects = _compute_alone(suspects, losses, runner, opened, keep)
            else:
                suspects = _compute_together(line, runner, opened, keep)


class _Line:
    """The jobs that wait, given out in chunks as large as their pace asks for."""

    def __init__(self, jobs: Iterable[Job], total: int) -> None:
        self._jobs = iter(jobs)
        self._pace: float | None = None  # s a job
        self.left = total

    def take(self, width: int) -> tuple[Job, ...]:
        """Return the next chunk: at the end small ones, so that all workers end together."""
        fair = -(-self.left // (4 * max(width, 1)))
        fit = 1 if self._pace is None else int(CHUNK / max(self._pace, CHUNK / MOST))
        chunk = tuple(islice(self._jobs, max(1, min(fit, fair))))
        self.left -= len(chunk)
        return chunk

    def learn(self, computed: Computed) -> None:
        """Follow the time that jobs take."""
        now = computed.seconds / len(computed.rows)
        self._pace = now if self._pace is None else 0.5 * (self._pace + now)


def _compute_together(line: _Line, runner: Runner, opened: Opened, keep: Keeper) -> list[Job]:
    """Compute the jobs in line until all are done or a worker has ended; return those that may have ended it."""
    given: dict[Future[Computed], tuple[Job, ...]] = {}
    suspects: list[Job] = []
    while given or (line.left and not suspects):
        width = opened.width()
        while line.left and not suspects and len(given) < width + opened.spare:
            chunk = line.take(width)
            try:
                given[opened.executor.submit(compute_rows, runner, chunk)] = chunk
            except opened.losses:
                suspects.extend(chunk)
        rows: list[tuple[Job, Row]] = []
        for future in _done(given, opened) if given else ():
            chunk = given.pop(future)
            computed = _result(future, opened)
            if computed is None:
                suspects.extend(chunk)
            else:
                line.learn(computed)
                rows.extend(zip(chunk, computed.rows, strict=True))
        if rows:
            keep(rows)  # all at once: each time waits for the disk
    return suspects


def _compute_alone(
    suspects: Sequence[Job], losses: Counter[str], runner: Runner, opened: Opened, keep: Keeper
) -> list[Job]:
    """Compute jobs one at a time until one ends its worker; return those that are left.

    losses : how often each, by its key, ended its worker alone
    """
    for place, job in enumerate(suspects):
        future = opened.executor.submit(compute_rows, runner, (job,))
        for _ in _done([future], opened):
            computed = _result(future, opened)
        if computed is not None:
            keep(((job, computed.rows[0]),))
            continue
        losses[job.task.key] += 1
        if losses[job.task.key] < opened.trials:
            return list(suspects[place:])
        keep(((job, _lost_row(job, future.exception())),))
        return list(suspects[place + 1 :])
    return []


def _lost_row(job: Job, error: BaseException | None) -> Row:
    """Return the row of a project that ends its worker, or whose outputs another command writes."""
    if isinstance(error, HeldError):
        return broken_row(job, str(error), INPUT_IS_WRONG)
    return broken_row(job, ENDED, BUG)


def _done(given: Iterable[Future[Computed]], opened: Opened) -> Iterator[Future[Computed]]:
    """Wait until some are done, as long as the executor lasts, and yield those."""
    while not (done := wait(given, PATIENCE, FIRST_COMPLETED).done):
        opened.check()
    yield from done


def _result(future: Future[Computed], opened: Opened) -> Computed | None:
    """Return what a chunk came to; None if its worker ended or its outputs are held by another."""
    losses: tuple[type[BaseException], ...] = (*opened.losses, HeldError)
    try:
        return future.result()
    except losses:
        return None
    except CancelledError:
        opened.check()
        raise AssessError("the scheduler gave up the tasks; go on with --resume") from None
    except ImportError as error:
        raise AssessError(f"a worker cannot import the program ({error}); install rocking-assess there") from None
