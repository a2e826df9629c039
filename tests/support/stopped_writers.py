"""Commands that are stopped while they write, in copies of a small process: one of all the tests takes long to copy."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from aim import aim

from assess.outputs.signals import Terminated, raise_on_signals
from tests.support.files import write_output
from tests.support.places import ROOT


class StoppedWriters:
    """Has files written by processes that are sent a signal on the way."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self._process = process

    def write(self, folder: Path, files: Mapping[str, str], *, at: int, number: int) -> int:
        """Write the files in a process that is sent the signal `number` before step `at`; its status, as of `wait`."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps([str(folder), dict(files), at, int(number)]) + "\n")
        self._process.stdin.flush()
        return int(self._process.stdout.readline())


@contextmanager
def stopped_writers() -> Iterator[StoppedWriters]:
    """Start the process that is copied; it ends with the block."""
    places = [str(ROOT), str(ROOT / "tools" / "kill"), os.environ.get("PYTHONPATH", "")]
    with subprocess.Popen(
        [sys.executable, "-m", "tests.support.stopped_writers"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, places))},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        yield StoppedWriters(process)
        assert process.stdin is not None
        process.stdin.close()


def _status_of_copy(folder: Path, files: dict[str, str], *, at: int, number: int) -> int:
    """Write the files in a copy of this process; how it ended."""
    if (child := os.fork()) == 0:
        try:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            with raise_on_signals():
                aim(folder, at=at, number=number)
                write_output(folder, files)
            os._exit(0)
        except Terminated:
            os._exit(3)
        finally:
            os._exit(70)
    return os.waitpid(child, 0)[1]


if __name__ == "__main__":
    with TemporaryDirectory() as place:
        write_output(Path(place) / "out", {"results.json": "1"})  # so that what writing imports is there to be copied
    for line in sys.stdin:
        folder, files, at, number = json.loads(line)
        sys.stdout.write(f"{_status_of_copy(Path(folder), files, at=at, number=number)}\n")
        sys.stdout.flush()
