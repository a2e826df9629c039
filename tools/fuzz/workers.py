"""Processes that judge batches, watched from outside: killed where they hang, started again where they die."""

from __future__ import annotations

import os
import re
import resource
import signal
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from pathlib import Path

from tools.fuzz.answer import answer
from tools.fuzz.fuzz_input import FuzzInput
from tools.fuzz.judge import Judge
from tools.fuzz.judgement import BROKEN, HANG, MEMORY, SILENT, Judged, judged_dead
from tools.fuzz.mutations import Batch, cases_of
from tools.fuzz.seeds import seed_case

CONTEXT = get_context("spawn")
HANGS_AFTER = 320.0  # s: readers in processes of their own may take 60 s of the processor, on a busy machine 300
ROOM = 2 * 1024**3  # bytes of address space beyond those of the process when it starts
Take = Callable[[FuzzInput, Judged, FuzzInput], None]
"""Hears of a case without its files, its outcome, and the smallest case with the same, whole where one will read it."""


class Worker:
    """One process, the batch that it is at, and how far it is."""

    def __init__(self, seed: int, *, hangs_after: float = HANGS_AFTER, room: int = ROOM) -> None:
        self.seed, self.hangs_after, self.room = seed, hangs_after, room
        self.batch: Batch | None = None
        self._start()

    def _start(self) -> None:
        self.ours, theirs = CONTEXT.Pipe()
        self.process = CONTEXT.Process(target=_serve, args=(theirs, self.seed, self.room))
        self.process.start()  # not a daemon, which has no children
        theirs.close()

    def give(self, batch: Batch | None, *, begin: int = 0) -> None:
        """Have it judge a batch from its case `begin` on; None is nothing to do."""
        self.batch, self.at, self.since = batch, begin, time.monotonic()
        if batch is not None:
            self.ours.send((batch, begin))

    def hear(self, take: Take) -> bool:
        """Take one case that is judged; False where the batch is done."""
        try:
            told = self.ours.recv()
        except (EOFError, ConnectionResetError):
            self.process.join(5.0)
            code = self.process.exitcode
            return self._lost(MEMORY if code == -signal.SIGKILL else f"killed, code {code}", take)
        if told is None:
            return False
        take(*told)
        self.at, self.since = self.at + 1, time.monotonic()
        return True

    def watch(self, take: Take) -> None:
        """Kill it where the case that it is at takes too long."""
        if self.batch is not None and time.monotonic() - self.since > self.hangs_after:
            self._lost(HANG, take)

    def _lost(self, told: str, take: Take) -> bool:
        """Count the case that it was at, and begin again after it."""
        assert self.batch is not None
        case = list(cases_of(self.batch, seed_case(self.batch.group, self.batch.name), seed=self.seed))[self.at]
        take(replace(case, files={}), judged_dead(told), case)
        self.stop()
        self._start()
        self.give(self.batch, begin=self.at + 1)
        return True

    def stop(self) -> None:
        """End the process."""
        self.ours.close()
        self.process.kill()
        self.process.join()


def judge_batches(batches: Iterator[Batch], take: Take, *, seed: int, jobs: int, until: float) -> None:
    """Judge batches by several processes until there are no more or the time `until` of the monotonic clock."""
    crew = [Worker(seed) for _ in range(jobs)]
    try:
        for worker in crew:
            worker.give(next(batches, None))
        while (busy := [each for each in crew if each.batch is not None]) and time.monotonic() < until:
            ready = wait([each.ours for each in busy], timeout=1.0)
            for worker in busy:
                if worker.ours not in ready:
                    worker.watch(take)
                elif not worker.hear(take):
                    worker.give(next(batches, None))
    finally:
        for worker in crew:
            worker.stop()


def _serve(connection: Connection, seed: int, room: int) -> None:
    """Judge batches until the pipe closes."""
    import faulthandler

    faulthandler.disable()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    judge, limited = Judge(answer), False
    while True:
        try:
            batch, begin = connection.recv()
        except EOFError:
            os._exit(0)
        whole = seed_case(batch.group, batch.name)
        for number, case in enumerate(cases_of(batch, whole, seed=seed)):
            if number < begin:
                continue
            found = judge.judge(case, whole)
            read = found.outcome in BROKEN or found.outcome == SILENT
            plain = replace(case, files={})
            if not limited:  # once everything is imported
                limit = _size() + room
                resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
                limited = True
            connection.send((plain, found, judge.smallest(case, whole, found) if read else plain))
        connection.send(None)


def _size() -> int:
    """Address space of this process [bytes]."""
    found = re.search(r"VmSize:\s+(\d+) kB", Path("/proc/self/status").read_text())
    return 1024 * int(found[1]) if found else 0
