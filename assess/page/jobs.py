"""A run of the project beside the page, in a process of its own."""

from __future__ import annotations

import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

from assess.portfolio.tasks import EXIT_CODES


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
