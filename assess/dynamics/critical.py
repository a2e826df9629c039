"""The mechanism that the weakest pulse overturns, at each frequency (thesis 3.4.2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray

TIE = 0.05
"""Bounds within this share of the least are in no clear order: a pulse, restitution or density could change it."""


@dataclass(frozen=True)
class Band:
    """Frequencies [Hz] from start to end at which one mechanism is critical; None: nothing overturns."""

    mechanism: int | None
    start: float
    end: float


@dataclass(frozen=True, repr=False)
class Critical(ShortRepr):
    """Of m mechanisms at n frequencies.

    mechanism : the one with the least bound, -1 where none has one [n]
    lower_bound : its bound, nan where there is none [n] [m/s2]
    runner_up : the second least, -1 where there is none [n]
    margin : how much more the second needs, as a share of the least, nan where there is none [n] [-]
    near : whether each mechanism is within TIE of the least [m, n]
    bands : the same along the frequency; two bounds cross between two frequencies where lines through their
        logarithms do
    """

    mechanism: IntArray
    lower_bound: FloatArray
    runner_up: IntArray
    margin: FloatArray
    near: NDArray[np.bool_]
    bands: tuple[Band, ...]


def find_critical(frequency: FloatArray, bounds: FloatArray) -> Critical:
    """Find the mechanism with the least lower bound at each frequency.

    Parameters
    ----------
    frequency : rising [n] [Hz]
    bounds : lower bound of each of m mechanisms, nan where nothing overturns it [m, n] [m/s2]
    """
    filled = np.where(np.isnan(bounds), np.inf, bounds)
    order = np.argsort(filled, axis=0, kind="stable")
    columns = np.arange(frequency.size)
    least = filled[order[0], columns]
    second = filled[order[1], columns] if len(bounds) > 1 else np.full(frequency.size, np.inf)
    first = np.where(np.isfinite(least), order[0], -1)
    other = np.where(np.isfinite(second), order[1], -1) if len(bounds) > 1 else np.full(frequency.size, -1)
    with np.errstate(invalid="ignore"):
        margin = np.where(np.isfinite(second), second / least - 1.0, np.nan)
        near = np.isfinite(filled) & (filled <= (1.0 + TIE) * least)
    return Critical(
        first, np.where(np.isfinite(least), least, np.nan), other, margin, near, tuple(_bands(frequency, filled, first))
    )


def _bands(frequency: FloatArray, bounds: FloatArray, first: IntArray) -> list[Band]:
    """Return the bands of frequency in which one mechanism is critical."""
    changes = np.flatnonzero(np.diff(first)) + 1
    places = [_crossing(frequency, bounds, first, int(k)) for k in changes]
    edges = [float(frequency[0]), *places, float(frequency[-1])]
    members = [int(first[0]), *(int(first[k]) for k in changes)]
    return [Band(m if m >= 0 else None, a, b) for m, a, b in zip(members, edges[:-1], edges[1:], strict=True)]


def _crossing(frequency: FloatArray, bounds: FloatArray, first: IntArray, k: int) -> float:
    """Return where two bounds cross between frequencies k - 1 and k [Hz]; halfway if one is not known at both."""
    one, other = first[k - 1], first[k]
    a, b = float(frequency[k - 1]), float(frequency[k])
    both = bounds[[other, one]][:, [k - 1, k]] if min(one, other) >= 0 else np.full((2, 2), np.inf)
    if not np.all(np.isfinite(both)):
        return 0.5 * (a + b)
    gaps = np.diff(np.log(both), axis=0)[0]
    if gaps[0] == gaps[1]:
        return 0.5 * (a + b)
    return a + (b - a) * float(gaps[0] / (gaps[0] - gaps[1]))
