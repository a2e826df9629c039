"""The tasks of a portfolio given out to processes of this machine, or to the workers of a Dask scheduler.

Both are a `concurrent.futures.Executor`. Dask computes the tasks of a lost worker again by itself; a pool of processes
breaks whole, and is made again.

Tasks are given out in chunks that take about half a second, a few chunks at a time whatever the number of tasks, so
that what a chunk costs beside its tasks is small and little is lost where the program is killed. When a worker ends,
the tasks that were given out are suspects: each is computed again alone, and one whose worker ends then, and once more,
is a broken row.
"""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING

from assess.errors import AssessError, HeldError
from assess.portfolio.tasks import BUG, INPUT_IS_WRONG, Computed, Job, ProjectRow, Runner, broken_row, compute_rows
from assess.workers import SpawnedPool, available_cores, end_on_error

if TYPE_CHECKING:
    from distributed import Client


CHUNK_DURATION = 0.5  # s
LARGEST_CHUNK = 256  # tasks of a chunk
CHECK_EVERY = 1.0  # s, between checks of the executor
CONNECT_WITHIN = 10.0  # s
MOST_WAITING = 16  # chunks that wait at a scheduler, so that it sees work for workers which are yet to come
WORKER_ENDED = (
    "it ended the process that computed it, alone and twice: not enough memory, or a fault in compiled code; try it "
    "with `assess run`"
)
RowReceiver = Callable[[Sequence[tuple[Job, ProjectRow]]], None]
"""Takes rows as they come, with their jobs."""


@dataclass(frozen=True)
class OpenExecutor:
    """An executor that takes work.

    width : returns how many tasks it computes at a time; 0 while there are no workers
    spare : chunks of tasks given to it beyond those
    losses : exceptions of a task whose worker ended
    trials : how often a task may end its worker, alone, before it is given up
    check : raises AssessError if the executor itself is lost
    """

    executor: Executor
    width: Callable[[], int]
    spare: int
    losses: tuple[type[BaseException], ...]
    trials: int
    check: Callable[[], None]


Engine = Callable[[], AbstractContextManager[OpenExecutor]]
"""Opens an executor; again after one has broken."""


def compute_all(jobs: Iterable[Job], *, total: int, runner: Runner, engine: Engine, keep: RowReceiver) -> None:
    """Compute every job, and hand over the rows in the order in which they are done.

    Parameters
    ----------
    jobs : what is to be computed; drawn as it is given out
    total : how many they are
    runner : assesses one
    engine : where it is computed
    keep : called in this process with rows that are done

    Raises
    ------
    AssessError : if the executor is lost, or cannot compute anything
    """
    queue, suspects, losses = _Queue(jobs, total), list[Job](), Counter[str]()
    while queue.left or suspects:
        with engine() as opened:
            if suspects:
                suspects = _compute_alone(suspects, losses, runner, opened, keep)
            else:
                suspects = _compute_together(queue, runner, opened, keep)


class _Queue:
    """The jobs that wait, given out in chunks as large as their pace asks for."""

    def __init__(self, jobs: Iterable[Job], total: int) -> None:
        self._jobs = iter(jobs)
        self._pace: float | None = None  # s a job
        self.left = total

    def take(self, width: int) -> tuple[Job, ...]:
        """Return the next chunk: at the end small ones, so that all workers end together."""
        fair = -(-self.left // (4 * max(width, 1)))
        fit = 1 if self._pace is None else int(CHUNK_DURATION / max(self._pace, CHUNK_DURATION / LARGEST_CHUNK))
        chunk = tuple(islice(self._jobs, max(1, min(fit, fair))))
        self.left -= len(chunk)
        return chunk

    def learn(self, computed: Computed) -> None:
        """Follow the time that jobs take."""
        now = computed.seconds / len(computed.rows)
        self._pace = now if self._pace is None else 0.5 * (self._pace + now)


def processes(jobs: int | None) -> Engine:
    """Return the engine of `jobs` processes of this machine, as many as it has cores if None."""
    number = jobs or available_cores()

    @contextmanager
    def opened() -> Iterator[OpenExecutor]:
        pool = SpawnedPool(number)
        with end_on_error(pool):
            yield OpenExecutor(pool, lambda: number, number, (BrokenExecutor,), 2, lambda: None)

    return opened


def dask(address: str) -> Engine:
    """Return the engine of the workers of the Dask scheduler at `address`, such as "tcp://node1:8786".

    Raises
    ------
    AssessError : no address is given, Dask is not installed, or the engine, when it is opened, reaches no scheduler
    """
    if "://" not in address:
        raise AssessError(f"--scheduler '{address}': no address; give the one that `dask scheduler` prints, tcp://…")
    try:
        from distributed import Client, KilledWorker
    except ImportError:
        raise AssessError("--scheduler: Dask is not installed; install it: pip install distributed") from None

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # it writes tracebacks of what is handled here

    @contextmanager
    def opened() -> Iterator[OpenExecutor]:
        try:
            client = Client(address, timeout=CONNECT_WITHIN, set_as_default=False)
        except (OSError, TimeoutError, ValueError) as error:
            raise AssessError(
                f"--scheduler {address}: no Dask scheduler answers there ({type(error).__name__}); start one with "
                "`dask scheduler`, and give the address that it prints"
            ) from None
        with client:
            yield OpenExecutor(
                client.get_executor(pure=False),
                lambda: _dask_width(client, address),
                MOST_WAITING,
                (KilledWorker,),
                1,  # after several workers
                lambda: _check_scheduler(client, address),
            )

    return opened


def _compute_together(queue: _Queue, runner: Runner, opened: OpenExecutor, keep: RowReceiver) -> list[Job]:
    """Compute the jobs in the queue until all are done or a worker has ended; return those that may have ended it."""
    running: dict[Future[Computed], tuple[Job, ...]] = {}
    suspects: list[Job] = []
    while running or (queue.left and not suspects):
        width = opened.width()
        while queue.left and not suspects and len(running) < width + opened.spare:
            chunk = queue.take(width)
            try:
                running[opened.executor.submit(compute_rows, runner, chunk)] = chunk
            except opened.losses:
                suspects.extend(chunk)
        rows: list[tuple[Job, ProjectRow]] = []
        for future in _wait_for_some(running, opened) if running else ():
            chunk = running.pop(future)
            computed = _result(future, opened)
            if computed is None:
                suspects.extend(chunk)
            else:
                queue.learn(computed)
                rows.extend(zip(chunk, computed.rows, strict=True))
        if rows:
            keep(rows)  # all at once: each time waits for the disk
    return suspects


def _compute_alone(
    suspects: Sequence[Job], losses: Counter[str], runner: Runner, opened: OpenExecutor, keep: RowReceiver
) -> list[Job]:
    """Compute jobs one at a time until one ends its worker; return those that are left.

    losses : how often each, by its key, ended its worker alone
    """
    for place, job in enumerate(suspects):
        future = opened.executor.submit(compute_rows, runner, (job,))
        for _ in _wait_for_some([future], opened):
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


def _lost_row(job: Job, error: BaseException | None) -> ProjectRow:
    """Return the row of a project that ends its worker, or whose outputs another command writes."""
    if isinstance(error, HeldError):
        return broken_row(job, str(error), INPUT_IS_WRONG)
    return broken_row(job, WORKER_ENDED, BUG)


def _wait_for_some(running: Iterable[Future[Computed]], opened: OpenExecutor) -> Iterator[Future[Computed]]:
    """Wait until some are done, as long as the executor lasts, and yield those."""
    while not (done := wait(running, CHECK_EVERY, FIRST_COMPLETED).done):
        opened.check()
    yield from done


def _result(future: Future[Computed], opened: OpenExecutor) -> Computed | None:
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


def _dask_width(client: Client, address: str) -> int:
    """Return how many tasks the workers compute at a time; raise AssessError if the scheduler has gone."""
    try:
        return sum(client.nthreads().values())
    except OSError:
        raise _scheduler_gone(address) from None


def _check_scheduler(client: Client, address: str) -> None:
    """Raise AssessError if the scheduler has gone."""
    if client.status != "running":
        raise _scheduler_gone(address)


def _scheduler_gone(address: str) -> AssessError:
    return AssessError(f"--scheduler {address}: the scheduler has gone; start it again, and go on with --resume")
