"""Times of programs that answer the same question, measured in turns in one process."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from statistics import median

import numpy as np

SHORTEST = 0.02
"""Seconds of one measurement: quicker programs are called often enough to fill it."""


@dataclass(frozen=True)
class Program:
    """One way to answer: by whom, how it is set, and what returns the answer."""

    name: str
    setting: str
    work: Callable[[], object]
    batch: int = 1
    """How many answers a call gives at once; the time is that of one."""


@dataclass(frozen=True)
class Row:
    """One line of a table: seconds of a call, shortest and median of `rounds`; the median ratio to ours in a round."""

    program: Program
    rounds: int
    least: float
    middle: float
    times_ours: float
    errors: tuple[float, ...]
    answer: object


@dataclass(frozen=True)
class Table:
    """What was asked, the titles of its errors, its lines, and how the time grows."""

    title: str
    asked: str
    error_titles: tuple[str, ...]
    rows: tuple[Row, ...]
    growth: tuple[str, ...]


def measure(
    programs: list[Program], errors: Callable[[object], tuple[float, ...]], *, rounds: int, seconds: float
) -> tuple[Row, ...]:
    """Run every program once in each round; the first is ours, and none has more than `seconds` in all.

    A program that fails in its work is an error of this comparison, and is raised.
    """
    answers, calls = {}, {}
    for program in programs:  # compiles, and fills caches
        start = time.perf_counter()
        answers[program] = program.work()
        once = time.perf_counter() - start
        calls[program] = max(1, math.ceil(SHORTEST / max(once, 1e-6)))
    found: Mapping[Program, list[float]] = {program: [] for program in programs}
    ratios: Mapping[Program, list[float]] = {program: [] for program in programs}
    for _ in range(rounds):
        for program in programs:
            if sum(found[program]) * calls[program] * program.batch <= seconds:
                found[program].append(duration(program.work, calls[program]) / program.batch)
                ratios[program].append(found[program][-1] / found[programs[0]][-1])
    return tuple(
        Row(program, len(found[program]), min(found[program]), median(found[program]), median(ratios[program]),
            errors(answers[program]), answers[program])
        for program in programs
    )  # fmt: skip


def off(reference: float, found: object) -> tuple[float]:
    """Return the relative difference of a number, without sign."""
    return (abs(float(found) / reference - 1.0),)  # type: ignore[arg-type]


def duration(work: Callable[[], object], calls: int) -> float:
    """Seconds of one call."""
    start = time.perf_counter()
    for _ in range(calls):
        work()
    return (time.perf_counter() - start) / calls


def least(work: Callable[[], object], *, rounds: int) -> float:
    """Seconds of one call, the shortest of the rounds, after one call that is not measured."""
    once = max(duration(work, 1), 1e-6)
    return min(duration(work, max(1, math.ceil(SHORTEST / once))) for _ in range(rounds))


def order(sizes: list[float], seconds: list[float]) -> float:
    """Return the power of the size with which the seconds grow, by least squares of logarithms."""
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


@contextmanager
def silence() -> Iterator[None]:
    """Throw away what compiled programs write to the terminal, past Python's own streams."""
    kept = [os.dup(stream) for stream in (1, 2)]
    with open(os.devnull, "w") as nowhere:
        try:
            for stream in (1, 2):
                os.dup2(nowhere.fileno(), stream)
            yield
        finally:
            for stream, old in zip((1, 2), kept, strict=True):
                os.dup2(old, stream)
                os.close(old)
