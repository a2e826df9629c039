"""Portfolios of tests: tasks that do what their content says, and the table of their rows."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import BrokenExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import astuple
from pathlib import Path

from assess.errors import FullDiskError, HeldError, ProjectError
from assess.portfolio.batch import BatchOptions, Portfolio, run_batch
from assess.portfolio.executors import OpenExecutor, processes
from assess.portfolio.projects import Task
from assess.portfolio.tasks import Job, ProjectRow


def act(job: Job) -> ProjectRow:
    """Return a row, or do what the task's content says instead; a runner."""
    what, _, where = (job.task.content or "").partition(" ")
    if what == "wrong":
        raise ProjectError("walls[3]:\nno such wall; give one")
    if what == "bug":
        raise ZeroDivisionError("a bug")
    if what == "full":
        raise FullDiskError("out: no space is left on the disk; make room")
    if what == "held":
        raise HeldError("another writes there")
    if what == "missing":
        raise FileNotFoundError(2, "No such file or directory", "records/x.AT2")
    if what == "exit":
        os._exit(1)
    if what == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    if what == "once" and _first(where):
        os.kill(os.getpid(), signal.SIGKILL)
    if what == "sleep":
        time.sleep(float(where))
    if what == "count":
        with Path(where).open("a") as file:
            file.write(f"{job.task.key}\n")
    margin = int(job.task.sha256[:6], 16) / 0x800000
    outcome, code = ("pass", 0) if margin >= 1.0 else ("fail", 1)
    return ProjectRow(
        job.task.key, job.task.title, job.task.sha256, "done", outcome=outcome, margin=margin, exit_code=code
    )


def _first(where: str) -> bool:
    """Return whether this is the first call that names a file, which then exists."""
    try:
        Path(where).touch(exist_ok=False)
    except FileExistsError:
        return False
    return True


def task(key: str, content: str = "", *, sha256: str = "") -> Task:
    """Return a task; its hash stands for what it reads."""
    return Task(key, f"Wall {key}", Path("wall.toml"), content, sha256 or f"{hash_of(key):06x}")


def hash_of(key: str) -> int:
    """Return a number that scatters with a key."""
    return sum(ord(c) * 7919 ** (n + 1) for n, c in enumerate(key)) % 0x1000000


def write_rows(rows: Sequence[ProjectRow], folder: Path) -> None:
    """Write the rows as they are."""
    (folder / "ranked.csv").write_text("".join(f"{astuple(row)!r}\n" for row in rows), encoding="utf-8")


@contextmanager
def threads() -> Iterator[OpenExecutor]:
    """Open an executor of two threads; an engine."""
    with ThreadPoolExecutor(2) as pool:
        yield OpenExecutor(pool, lambda: 2, 2, (BrokenExecutor,), 2, lambda: None)


def assess(tasks: Sequence[Task], order: BatchOptions, *, engine=threads, said: list[str] | None = None) -> Portfolio:  # type: ignore[no-untyped-def]
    """Assess tasks by what their contents say."""
    lines = [] if said is None else said
    return run_batch(tasks, order, runner=act, engine=engine, write=write_rows, tell=lines.append)


def table(folder: Path) -> bytes:
    """Return the bytes of the table in a folder."""
    return (folder / "ranked.csv").read_bytes()


if __name__ == "__main__":  # python -m tests.support.portfolios FOLDER NUMBER SECONDS: a portfolio to be killed
    place, number, seconds = sys.argv[1:]
    order = BatchOptions(Path(place), "rows", resume=True)
    assess([task(str(n), f"sleep {seconds}") for n in range(int(number))], order, engine=processes(2))
