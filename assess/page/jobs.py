"""Work beside the page: the newest question of those that wait, and a run of the project in a process of its own."""

from __future__ import annotations

import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

from assess.portfolio.tasks import EXIT_CODES

Job = Callable[[], None]


class Newest:
    """Does one job at a time in a thread, and of those that wait only the one that came last."""

    def __init__(self, name: str) -> None:
        self._ready = threading.Condition()
        self._waiting: Job | None = None
        self._closed = self._busy = False
        self._thread = threading.Thread(target=self._work, name=name, daemon=True)
        self._thread.start()

    def ask(self, job: Job) -> None:
        """Do a job as soon as the one in hand is done; one that waits is dropped."""
        with self._ready:
            self._waiting = job
            self._ready.notify_all()

    def wait(self, seconds: float) -> bool:
        """Wait until nothing is left to be done; return whether that is so."""
        with self._ready:
            return self._ready.wait_for(lambda: self._waiting is None and not self._busy, seconds)

    def close(self) -> None:
        """Do no more jobs, but for the one in hand."""
        with self._ready:
            self._closed = True
            self._ready.notify_all()

    def _work(self) -> None:
        while True:
            with self._ready:
                self._busy = False
                self._ready.notify_all()
                self._ready.wait_for(lambda: self._waiting is not None or self._closed)
                if self._closed or self._waiting is None:
                    return
                job, self._waiting, self._busy = self._waiting, None, True
            job()


class ProjectRun:
    """`assess run` of a project, in a process of its own.

    tell : called with each line that it writes about what it is doing
    done : called when it has ended: with its last line where the input is wrong or it was cancelled, or with ""
    """

    def __init__(self, project: Path, *, tell: Callable[[str], None], done: Callable[[str], None]) -> None:
        self.folder = project.parent / f"{project.stem}-results"
        command = [sys.executable, "-m", "assess", "run", str(project), "-o", str(self.folder), "--verbose"]
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8"
        )
        self._tell, self._done = tell, done
        self._thread = threading.Thread(target=self._follow, daemon=True)
        self._thread.start()

    def cancel(self) -> None:
        """Ask it to end; what stood in its folder before stays there."""
        self._process.terminate()

    def wait(self, seconds: float) -> None:
        """Wait until it has ended and that is told."""
        self._thread.join(seconds)

    def _follow(self) -> None:
        last = ""
        assert self._process.stderr is not None
        with self._process.stderr as lines:
            for line in lines:
                last = line.strip().removeprefix("assess: ")
                self._tell(last)
        ended = self._process.wait() in EXIT_CODES.values()
        self._done("" if ended else last or "ended without a word")
