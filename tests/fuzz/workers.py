"""A process that answers cases, watched from outside: killed where it hangs, started again where it dies."""

from __future__ import annotations

import os
import re
import resource
import signal
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

from tests.fuzz.answer import Answer, answer
from tests.fuzz.case import Case
from tests.fuzz.judgement import HANG, MEMORY

CONTEXT = get_context("spawn")
HANGS_AFTER = 90.0  # s: readers in processes of their own have 60
STARTS_WITHIN = 120.0  # s, of the first case of a process, which imports everything
ROOM = 2 * 1024**3  # bytes of address space beyond those of the process when it starts


class Worker:
    """One process; `ask` gives the answer of a case."""

    def __init__(self, *, hangs_after: float = HANGS_AFTER, room: int = ROOM) -> None:
        self.hangs_after, self.room = hangs_after, room
        self._start()

    def _start(self) -> None:
        self.ours, theirs = CONTEXT.Pipe()
        self.process = CONTEXT.Process(target=_serve, args=(theirs, self.room), daemon=True)
        self.process.start()
        theirs.close()
        self.fresh = True

    def ask(self, case: Case) -> Answer:
        """The answer; of code None where the process had to be killed or died."""
        self.ours.send(case)
        wait, self.fresh = (STARTS_WITHIN if self.fresh else self.hangs_after), False
        try:
            if self.ours.poll(wait):
                found: Answer = self.ours.recv()
                return found
        except (EOFError, ConnectionResetError):
            self.process.join(5.0)
            code = self.process.exitcode
            self._again()
            return Answer(None, told=MEMORY if code == -signal.SIGKILL else f"killed, code {code}")
        self._again()
        return Answer(None, told=HANG)

    def _again(self) -> None:
        self.stop()
        self._start()

    def stop(self) -> None:
        """End the process."""
        self.ours.close()
        self.process.kill()
        self.process.join()


def _serve(connection: Connection, room: int) -> None:
    """Answer cases until the pipe closes."""
    import faulthandler

    faulthandler.disable()
    limited = False
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    while True:
        try:
            case = connection.recv()
        except EOFError:
            os._exit(0)
        found = answer(case)
        if not limited:  # once everything is imported
            limit = _size() + room
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
            limited = True
        connection.send(found)


def _size() -> int:
    """Address space of this process [bytes]."""
    found = re.search(r"VmSize:\s+(\d+) kB", Path("/proc/self/status").read_text())
    return 1024 * int(found[1]) if found else 0
