"""The periods over which a suite is to fit its target, and how much each counts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from records.candidates import PERIODS
from records.errors import RecordError

FloatArray = NDArray[np.float64]

ROUNDING = 1e-9


@dataclass(frozen=True)
class Band:
    """Rising periods [k] [s] of a catalogue, and their weights [k], the largest 1."""

    period: FloatArray
    weight: FloatArray

    @property
    def ends(self) -> tuple[float, float]:
        """The shortest and the longest of its periods [s]."""
        return float(self.period[0]), float(self.period[-1])

    @property
    def columns(self) -> slice:
        """Where its periods stand among those of a catalogue."""
        first = int(np.searchsorted(PERIODS, self.period[0]))
        return slice(first, first + self.period.size)


def band(shortest: float, longest: float, *, weights: Sequence[tuple[float, float]] = ()) -> Band:
    """The catalogue's periods from `shortest` to `longest` [s], ends included.

    weights : (period [s], weight) at rising periods; between them linear in the logarithm of the period, as the PEER
    web application does, and constant beyond; equal if absent.

    Raises RecordError for a range outside the catalogue's 0.01 to 10 s, or so narrow that none lies in it, and for
    weights that are negative, all zero, or at periods that do not rise.
    """
    low, high = PERIODS[0], PERIODS[-1]
    if not low * (1 - ROUNDING) <= shortest <= longest <= high * (1 + ROUNDING):
        raise RecordError(
            f"periods {shortest:.4g} s to {longest:.4g} s: they must rise, and lie between {low:g} s and {high:g} s"
        )
    inside = (shortest * (1 - ROUNDING) <= PERIODS) & (longest * (1 + ROUNDING) >= PERIODS)
    if not inside.any():
        raise RecordError(f"periods {shortest:.6g} s to {longest:.6g} s: too narrow; widen them by six percent")
    period = PERIODS[inside]
    return Band(period, _weight(period, weights))


def up_to(band: Band, longest: float) -> Band:
    """The band as far as a target reaches; RecordError where that ends before it begins."""
    kept = band.period <= longest
    if not kept.any():
        raise RecordError(
            f"the spectrum ends at {longest:.4g} s, before the periods from {band.period[0]:.4g} s on that it is to be "
            "fitted at; extend its table"
        )
    return Band(band.period[kept], band.weight[kept])


def _weight(period: FloatArray, weights: Sequence[tuple[float, float]]) -> FloatArray:
    if not weights:
        return np.ones(period.size)
    at, of = np.array(weights, dtype=np.float64).T
    bad = not np.all(np.isfinite(at) & np.isfinite(of) & (at > 0.0) & (of >= 0.0)) or np.any(np.diff(at) <= 0.0)
    found = np.zeros(period.size) if bad else np.interp(np.log(period), np.log(at), of)
    if not found.max() > 0.0:
        raise RecordError(
            "weights: they must be pairs (period, weight) of rising periods and weights that are not negative, some of "
            f"them above zero between {period[0]:.4g} s and {period[-1]:.4g} s"
        )
    return np.asarray(found / found.max(), dtype=np.float64)
