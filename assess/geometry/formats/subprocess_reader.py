"""A C++ reader run in a process of its own, because some damaged files crash it or never end."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path

MIN_TIME, SPEED = 60.0, 4e3  # s that any file may take, bytes to a further second: good files take up to 1 s for 20 kB
CLOCK_FACTOR = 5.0  # a busy machine may give it a fifth of the clock's time
OUT_OF_TIME = -24  # the code of a process that the kernel ended by SIGXCPU
LIMITED = """
try:
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, ({seconds}, {seconds} + 1))  # the kernel's limit ends an orphan too
except ImportError:
    pass
"""


def run_in_subprocess(code: str, file: Path, *more: str, name: str) -> int:
    """Run Python `code` in a process of its own, with the paths as its arguments, and return its exit code.

    Parameters
    ----------
    code : Python source
    file : its first argument, by whose size its time is limited
    more : further arguments
    name : of the reader, for errors

    Raises
    ------
    ValueError : it crashed, or took more processor time than a file of this size may
    """
    allowed = math.ceil(MIN_TIME + file.stat().st_size / SPEED)
    command = [sys.executable, "-c", LIMITED.format(seconds=allowed) + code, str(file.absolute()), *more]
    try:
        ended = subprocess.run(
            command, stdin=subprocess.DEVNULL, capture_output=True, timeout=CLOCK_FACTOR * allowed, check=False
        ).returncode
    except subprocess.TimeoutExpired:
        ended = OUT_OF_TIME
    if ended == OUT_OF_TIME:
        raise ValueError(f"{name} has not read it after {allowed} s; is it damaged? save it again")
    if ended < 0:
        raise ValueError(f"{name} crashed on it; it is damaged, save it again")
    return ended
