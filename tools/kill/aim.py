"""Ending a process by a signal to itself right before its n-th step on the file system below a folder.

Steps are what Python announces to audit hooks: opening for writing, renaming, linking, removing, making folders. The
program knows nothing of it.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

STEPS = ("open", "os.rename", "os.link", "os.remove", "os.mkdir", "os.rmdir", "os.truncate")


def aim(folder: Path, *, at: int, number: int) -> Callable[[], int]:
    """Send this process the signal `number` before step `at` below `folder`, counted from 1; children are spared.

    Returns what tells how many steps there were so far.
    """
    inside, itself, count = str(folder), os.getpid(), 0

    def step(event: str, arguments: tuple[Any, ...]) -> None:
        nonlocal count
        if event not in STEPS or os.getpid() != itself or not any(_below(each, inside) for each in arguments[:2]):
            return
        if event == "open" and not (arguments[2] or 0) & (os.O_WRONLY | os.O_RDWR):
            return
        count += 1
        if count == at:
            os.kill(itself, number)

    sys.addaudithook(step)
    return lambda: count


def _below(argument: Any, folder: str) -> bool:
    return isinstance(argument, str | os.PathLike) and os.fspath(argument).startswith(folder)
