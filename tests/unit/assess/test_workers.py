"""Processes that work for another end with it, however it ends, and quietly; of threads the newest job is done."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from assess.workers import Newest

pytestmark = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="processes are counted in /proc")

SPAWNED = """
import os, sys, time
from assess.outputs.signals import Terminated, raise_on_signals
from assess.workers import process_pool
if __name__ == "__main__":
    try:
        with raise_on_signals(), process_pool(2) as pool:
            started = set()
            while len(started) < 2:  # a worker ended while it starts may print a traceback
                started.update([made.result() for made in [pool.submit(os.getpid) for _ in range(4)]])
            print("ready", flush=True)
            list(pool.map(time.sleep, [60.0] * 9))
    except Terminated as ended:
        sys.exit(128 + ended.number)
"""
COPIED = """
import sys, time
from assess.outputs.signals import Terminated, raise_on_signals
from reports.render.vector import document_processes
def rest(_, seconds):
    time.sleep(seconds)
try:
    with raise_on_signals(), document_processes(2, None) as submit:
        made = [submit(rest, seconds) for seconds in (0.0, *[60.0] * 9)]
        made[0].result()
        print("ready", flush=True)
        made[1].result()
except Terminated as ended:
    sys.exit(128 + ended.number)
"""


def members(session: int) -> list[int]:
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(words[3]) == session and words[0] != "Z":
            found.append(int(stat.parent.name))
    return found


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT], ids=["KILL", "TERM", "INT"])
@pytest.mark.parametrize("program", [SPAWNED, COPIED], ids=["spawned", "copied"])
def test_no_worker_outlives_its_parent(program: str, number: int, tmp_path: Path) -> None:
    script = tmp_path / "program.py"
    script.write_text(program)
    with subprocess.Popen(
        [sys.executable, str(script)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        assert process.stdout is not None
        assert "ready" in process.stdout.readline()
        at_work = len(members(process.pid))
        if number == signal.SIGINT:  # as a terminal does, to all of them
            os.killpg(process.pid, number)
        else:
            process.send_signal(number)
        _, told = process.communicate(timeout=30)
        assert process.returncode == (-number if number == signal.SIGKILL else 128 + number), told
    deadline = time.monotonic() + 10.0
    while members(process.pid) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert at_work >= 2
    assert members(process.pid) == []
    assert "Traceback" not in told, told
    assert "Error" not in told


def test_of_those_that_wait_the_newest_is_done() -> None:
    done: list[int] = []
    begun, go = threading.Event(), threading.Event()

    def first() -> None:
        begun.set()
        go.wait(30.0)
        done.append(0)

    jobs = Newest("test")
    jobs.ask(first)
    assert begun.wait(30.0)
    for number in range(1, 5):
        jobs.ask(lambda number=number: done.append(number))
    assert not jobs.wait(0.01)
    go.set()
    assert jobs.wait(30.0)
    assert done == [0, 4]
    jobs.close()
