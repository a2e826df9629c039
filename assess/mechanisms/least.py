"""The least of a function of one to four bounded parameters that need not be convex."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product
from math import inf

import numpy as np

Parameters = tuple[float, ...]
HALVINGS = 8  # of the distance between stations: a parameter is found to 1/256 of it
STARTS = 3  # lowest valleys of the grid that are refined
ALIKE = 1e-9  # of a value: one that is less by no more is not below


@dataclass(frozen=True)
class Least:
    """The least value, where it is found, and the other valleys that were refined, the lowest first."""

    value: float
    at: Parameters
    evaluations: int
    others: tuple[tuple[float, Parameters], ...] = ()


def find_least(
    function: Callable[[Parameters], float],
    *,
    bounds: Sequence[tuple[float, float]],
    stations: Sequence[int],
    starts: int = STARTS,
    halvings: int = HALVINGS,
) -> Least:
    """Find the least value: on a grid, then from its lowest valleys by steps that are halved where none leads down.

    A step follows one parameter, or two at once, so that a narrow valley that runs askew is followed too.

    Parameters
    ----------
    function : of the parameters; inf where there is no such mechanism
    bounds : of each parameter; two equal ones fix it
    stations : on the grid, of each parameter
    starts : valleys that are refined
    halvings : of the distance between stations

    Returns
    -------
    The least, inf where the function is inf at every station
    """
    known: dict[Parameters, float] = {}

    def value(at: Parameters) -> float:
        if at not in known:
            known[at] = function(at)
        return known[at]

    axes = [
        np.linspace(low, high, count if high > low else 1) for (low, high), count in zip(bounds, stations, strict=True)
    ]
    shape = tuple(len(axis) for axis in axes)
    grid = np.array([value(tuple(map(float, at))) for at in product(*axes)]).reshape(shape)
    steps = [(high - low) / max(len(axis) - 1, 1) for (low, high), axis in zip(bounds, axes, strict=True)]
    found: dict[Parameters, float] = {}
    for place in _valleys(grid)[:starts]:
        at = tuple(float(axis[i]) for axis, i in zip(axes, place, strict=True))
        best = _descend(value, at, steps, bounds, halvings)
        found[best] = value(best)
    ranked = sorted(((each, at) for at, each in found.items()), key=lambda one: one[0])
    if not ranked:
        return Least(inf, tuple(float(axis[0]) for axis in axes), len(known))
    return Least(*ranked[0], len(known), tuple(ranked[1:]))


def _valleys(grid: np.ndarray) -> list[tuple[int, ...]]:
    """Return the places of a grid that no neighbour, corners included, lies below; the lowest first."""
    padded = np.pad(grid, 1, constant_values=inf)
    around = [
        padded[tuple(slice(1 + turn, 1 + turn + size) for turn, size in zip(turns, grid.shape, strict=True))]
        for turns in product((-1, 0, 1), repeat=grid.ndim)
        if any(turns)
    ]
    lowest = np.isfinite(grid) & (grid <= np.min(around, axis=0))
    return sorted(map(tuple, np.argwhere(lowest).tolist()), key=lambda place: float(grid[place]))


def _descend(
    value: Callable[[Parameters], float],
    at: Parameters,
    steps: Sequence[float],
    bounds: Sequence[tuple[float, float]],
    halvings: int,
) -> Parameters:
    """Return where steps of at most one or two parameters at once lead down no more."""
    turns = [each for each in product((-1, 0, 1), repeat=len(at)) if 0 < sum(map(abs, each)) <= 2]
    for halving in range(1, halvings + 1):
        size = 0.5**halving
        while True:
            nearby = {
                tuple(
                    float(np.clip(x + turn * size * step, *bound))
                    for x, turn, step, bound in zip(at, each, steps, bounds, strict=True)
                )
                for each in turns
            }
            best = min(nearby, key=value)
            if not value(best) < value(at) - ALIKE * abs(value(at)):
                break
            at = best
    return at
