"""A reader in C++ in a process of its own, because some damaged files crash it or keep it for ever."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

LEAST, SPEED = 60.0, 4e3  # s that any file may take, bytes to a further second: good files take up to 1 s for 20 kB


def run_apart(code: str, file: Path, *more: str, name: str) -> int:
    """Run the Python `code` with the paths as its arguments; the code at its end.

    name : of the reader, for errors

    Raises
    ------
    ValueError : it crashed, or took longer than a file of this size may
    """
    allowed = LEAST + file.stat().st_size / SPEED
    command = [sys.executable, "-c", code, str(file.absolute()), *more]
    try:
        ended = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=allowed, check=False)
    except subprocess.TimeoutExpired:
        raise ValueError(f"{name} has not read it after {allowed:.0f} s; is it damaged? save it again") from None
    if ended.returncode < 0:
        raise ValueError(f"{name} crashed on it; it is damaged, save it again")
    return ended.returncode
