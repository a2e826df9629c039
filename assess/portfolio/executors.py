"""Where the tasks of a portfolio are computed: processes of this machine, or the workers of a Dask scheduler.

Both are a `concurrent.futures.Executor`. Dask computes the tasks of a lost worker again by itself; a pool of processes
breaks whole, and is made again.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from assess.errors import AssessError
from assess.workers import SpawnedPool, available_cores, end_on_error

if TYPE_CHECKING:
    from distributed import Client

CONNECT_WITHIN = 10.0  # s
MOST_WAITING = 16  # chunks that wait at a scheduler, so that it sees work for workers which are yet to come


@dataclass(frozen=True)
class Opened:
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


Engine = Callable[[], AbstractContextManager[Opened]]
"""Opens an executor; again after one has broken."""


def processes(jobs: int | None) -> Engine:
    """Return the engine of `jobs` processes of this machine, as many as it has cores if None."""
    number = jobs or available_cores()

    @contextmanager
    def opened() -> Iterator[Opened]:
        pool = SpawnedPool(number)
        with end_on_error(pool):
            yield Opened(pool, lambda: number, number, (BrokenExecutor,), 2, lambda: None)

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
    def opened() -> Iterator[Opened]:
        try:
            client = Client(address, timeout=CONNECT_WITHIN, set_as_default=False)
        except (OSError, TimeoutError, ValueError) as error:
            raise AssessError(
                f"--scheduler {address}: no Dask scheduler answers there ({type(error).__name__}); start one with "
                "`dask scheduler`, and give the address that it prints"
            ) from None
        with client:
            yield Opened(
                client.get_executor(pure=False),
                lambda: _width(client, address),
                MOST_WAITING,
                (KilledWorker,),
                1,  # after several workers
                lambda: _check(client, address),
            )

    return opened


def _width(client: Client, address: str) -> int:
    """Return how many tasks the workers compute at a time; raise AssessError if the scheduler has gone."""
    try:
        return sum(client.nthreads().values())
    except OSError:
        raise _gone(address) from None


def _check(client: Client, address: str) -> None:
    """Raise AssessError if the scheduler has gone."""
    if client.status != "running":
        raise _gone(address)


def _gone(address: str) -> AssessError:
    return AssessError(f"--scheduler {address}: the scheduler has gone; start it again, and go on with --resume")
