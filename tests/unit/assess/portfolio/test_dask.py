"""A portfolio on a Dask scheduler with two workers, processes of their own, comes to the table of one machine."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

import pytest

from assess.errors import AssessError
from assess.portfolio.batch import BatchOptions
from assess.portfolio.executors import dask
from tests.support.places import SOURCES
from tests.support.portfolios import assess, table, task

pytest.importorskip("distributed")


@contextmanager
def cluster(folder: Path, *, workers: int = 2, allowed_failures: int = 3) -> Iterator[str]:
    """Start a scheduler and workers, and give the scheduler's address; end them."""
    file = folder / "scheduler.json"
    where = ["--scheduler-file", str(file), "--no-dashboard"]
    one = ["--nthreads", "1", "--no-nanny", "--local-directory", str(folder)]
    commands = [["dask_scheduler", "--host", "127.0.0.1", "--port", "0"], *[["dask_worker", *one]] * workers]
    told = {"DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": str(allowed_failures), "PYTHONPATH": str(SOURCES)}
    with ExitStack() as ended, (folder / "log").open("wb") as log:
        for name, *options in commands:
            command = [sys.executable, "-m", f"distributed.cli.{name}", *options, *where]
            process = subprocess.Popen(command, env={**os.environ, **told}, cwd=SOURCES, stdout=log, stderr=log)
            ended.callback(process.wait)
            ended.callback(process.kill)
        yield _address(file)


def _address(file: Path) -> str:
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        with suppress(OSError, ValueError):
            return str(json.loads(file.read_text())["address"])
        time.sleep(0.02)
    raise TimeoutError(file)


def test_a_killed_worker_changes_no_byte_of_the_table(tmp_path: Path) -> None:
    tasks = [task(str(n), "sleep 0.01") for n in range(30)]
    tasks.insert(9, task("once", f"once {tmp_path / 'seen'}"))  # ends its worker when it is first computed
    tasks.append(task("wrong", "wrong"))
    with cluster(tmp_path) as address:
        found = assess(tasks, BatchOptions(tmp_path / "dask", "rows"), engine=dask(address))
    assert (tmp_path / "seen").exists()  # so no thread of this process ends it
    assess(tasks, BatchOptions(tmp_path / "threads", "rows"))
    assert table(tmp_path / "dask") == table(tmp_path / "threads")
    assert [row.key for row in found.rows if row.status == "broken"] == ["wrong"]


@pytest.mark.study
def test_a_project_that_ends_its_workers_is_a_row(tmp_path: Path) -> None:
    tasks = [task(str(n), "sleep 0.01") for n in range(9)]
    with cluster(tmp_path, workers=3, allowed_failures=0) as address:
        found = assess([*tasks, task("fatal", "killed")], BatchOptions(tmp_path / "out", "rows"), engine=dask(address))
    assert [(row.key, row.exit_code) for row in found.rows if row.status == "broken"] == [("fatal", 70)]


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nonsense://x"])
def test_an_address_without_a_scheduler_is_one_clear_line(
    address: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("assess.portfolio.executors.CONNECT_WITHIN", 0.3)
    with pytest.raises(AssessError, match="no Dask scheduler answers there"):
        assess([task("a")], BatchOptions(tmp_path / "out", "rows"), engine=dask(address))


@pytest.mark.parametrize("address", ["", "node1", "127.0.0.1:8786"])
def test_what_is_no_address_is_refused_at_once(address: str) -> None:
    with pytest.raises(AssessError, match="no address; give the one that `dask scheduler` prints"):
        dask(address)


def test_without_dask_the_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(AssessError, match="pip install distributed"):
        dask("tcp://127.0.0.1:8786")
