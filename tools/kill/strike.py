"""One command of the program, ended by a signal to itself at its n-th step on the disk or its n-th batch of records.

python strike.py FOLDER AT NUMBER ARGUMENTS… with AT 0 for never, and NUMBER 0 to tell the steps on
the last line of stderr.
"""

from __future__ import annotations

import atexit
import os
import sys
from pathlib import Path
from typing import Any

from aim import aim

from assess.cli import main
from records import catalogue


def aim_at_batches(*, at: int, number: int) -> None:
    """Send this process the signal before it stores batch `at`, of a few files each."""
    store, count = catalogue._store, 0

    def counted(*arguments: Any) -> None:
        nonlocal count
        count += 1
        if count == at:
            os.kill(os.getpid(), number)
        store(*arguments)

    catalogue.BATCH, catalogue._store = 5, counted


if __name__ == "__main__":
    folder, at, number, *arguments = sys.argv[1:]
    if "index" in arguments:
        aim_at_batches(at=int(at), number=int(number))
    else:
        steps = aim(Path(folder), at=int(at), number=int(number))
        if at == number == "0":
            atexit.register(lambda: os.write(2, f"{steps()} steps\n".encode()))
    main(arguments)
