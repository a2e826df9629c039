"""The best suites of a pool of scaled records: record by record, by exchanges, or by trying all of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from math import comb, inf
from typing import Literal

import numpy as np

from spectra.arrays import BoolArray, FloatArray, IntArray

Fit = Literal["suite", "each"]

COUNTABLE = 20_000  # suites that are all tried
EXCHANGED = 2_000  # records, those of least misfit, that may be exchanged into a suite
CHUNK = 1_000


@dataclass(frozen=True)
class Pool:
    """What suites are made of: scaled spectrum over target [n, k], weights [k] that sum to 1, group and misfit [n]."""

    ratio: FloatArray
    weight: FloatArray
    group: IntArray
    mse: FloatArray

    def misfit(self, mean: FloatArray) -> FloatArray:
        """Return the misfit of mean spectra over target [..., k]."""
        return np.asarray(np.log(mean) ** 2 @ self.weight)


def best_each(pool: Pool, count: int) -> tuple[list[int], None]:
    """Choose the `count` records of least misfit, the best of each group."""
    chosen: list[int] = []
    taken: set[int] = set()
    for i in np.argsort(pool.mse, kind="stable").tolist():
        if pool.group[i] not in taken and len(chosen) < count:
            chosen.append(i)
            taken.add(int(pool.group[i]))
    return chosen, None


def best_suite(pool: Pool, count: int) -> tuple[list[int], float]:
    """Choose the `count` records whose mean fits best; return also the misfit of the greedy suite, its upper bound."""
    first = greedy(pool, count)
    before = _misfit_of(pool, first)
    if comb(pool.mse.size, count) <= COUNTABLE:
        return exhaustive(pool, count), before
    starts = (first, best_each(pool, count)[0])
    return min((exchange(pool, start) for start in starts), key=lambda chosen: _misfit_of(pool, chosen)), before


def greedy(pool: Pool, count: int) -> list[int]:
    """Choose record by record, each time the one that makes the mean fit best."""
    chosen: list[int] = []
    total = np.zeros(pool.weight.size)
    free = np.ones(pool.mse.size, dtype=np.bool_)
    for size in range(1, count + 1):
        score = np.where(free, pool.misfit((total + pool.ratio) / size), inf)
        best = int(np.argmin(score))
        chosen.append(best)
        total = total + pool.ratio[best]
        free &= pool.group != pool.group[best]
    return chosen


def exchange(pool: Pool, start: Sequence[int]) -> list[int]:
    """Improve a suite by exchanging one record at a time for the best other, until no exchange helps."""
    chosen, among = list(start), np.argsort(pool.mse, kind="stable")[:EXCHANGED]
    ratio, group = pool.ratio[among], pool.group[among]
    least, better = _misfit_of(pool, chosen), True
    while better:
        better = False
        for place in range(len(chosen)):
            others = [i for k, i in enumerate(chosen) if k != place]
            free = ~np.isin(group, pool.group[others])
            score = np.where(free, pool.misfit((pool.ratio[others].sum(axis=0) + ratio) / len(chosen)), inf)
            best = int(np.argmin(score))
            if score[best] < least * (1 - 1e-9):
                chosen[place], least, better = int(among[best]), float(score[best]), True
    return chosen


def exhaustive(pool: Pool, count: int) -> list[int]:
    """Choose the best of all suites."""
    best, least = greedy(pool, count), inf
    for suites in _chunks(combinations(range(pool.mse.size), count)):
        group = np.sort(pool.group[suites], axis=1)
        allowed: BoolArray = np.all(np.diff(group, axis=1) > 0, axis=1)
        if not allowed.any():
            continue
        score = pool.misfit(pool.ratio[suites[allowed]].mean(axis=1))
        if score.min() < least:
            least, best = float(score.min()), suites[allowed][int(np.argmin(score))].tolist()
    return best


def _chunks(suites: Iterator[tuple[int, ...]]) -> Iterator[IntArray]:
    while part := list(islice(suites, CHUNK)):
        yield np.array(part, dtype=np.int64)


def _misfit_of(pool: Pool, chosen: Sequence[int]) -> float:
    return float(pool.misfit(pool.ratio[list(chosen)].mean(axis=0)))


FITS: Mapping[Fit, Callable[[Pool, int], tuple[list[int], float | None]]] = {"suite": best_suite, "each": best_each}
