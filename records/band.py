"""The periods over which a suite is to fit its target, with their weights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from records.candidates import PERIODS
from records.errors import RecordError
from spectra.arrays import FloatArray

ROUNDING = 1e-9
STEP = float(np.log(PERIODS[1] / PERIODS[0]))


@dataclass(frozen=True)
class Band:
    """Rising periods [k] [s], from one end of a range to the other, and their weights [k], the largest 1.

    nodes : rising periods [m] [s] at which spectra of records are taken; ends lie between
    """

    period: FloatArray
    weight: FloatArray
    nodes: FloatArray

    @property
    def ends(self) -> tuple[float, float]:
        """The shortest and the longest of its periods [s]."""
        return float(self.period[0]), float(self.period[-1])

    @property
    def columns(self) -> slice:
        """Slice of its nodes among the periods of a catalogue."""
        first = int(np.searchsorted(PERIODS, self.nodes[0]))
        return slice(first, first + self.nodes.size)

    def at_periods(self, logarithm: FloatArray) -> FloatArray:
        """Return the logarithms of spectra at the nodes [..., m], as `interpolate`, at the periods [..., k]."""
        return interpolate(self.period, self.nodes, logarithm)


def interpolate(period: FloatArray, nodes: FloatArray, logarithm: FloatArray) -> FloatArray:
    """Interpolate logarithms linearly over the logarithm of the period.

    Parameters
    ----------
    period : periods to interpolate at [..., k] [s]
    nodes : rising periods [m] [s]
    logarithm : values at the nodes [..., m]

    Returns
    -------
    array [..., k]
    """
    at = np.interp(np.log(period), np.log(nodes), np.arange(nodes.size))
    before, after = np.floor(at).astype(np.int64), np.ceil(at).astype(np.int64)
    share = at - before
    return np.asarray(logarithm[..., before] * (1.0 - share) + logarithm[..., after] * share)


def band(shortest: float, longest: float, *, weights: Sequence[tuple[float, float]] = ()) -> Band:
    """Return the periods from `shortest` to `longest`: both ends, and the periods of a catalogue between them.

    Periods of the catalogue within half a step of an end are left out, so that all can count alike.

    Parameters
    ----------
    shortest, longest : ends of the range [s]
    weights : (period [s], weight [-]) at rising periods; linear in the logarithm of the period between them, as in the
        PEER web application, and constant beyond; equal if absent

    Raises
    ------
    RecordError : the range leaves the catalogue's 0.01 to 10 s or holds none of its periods; weights are negative, all
        zero, or at periods that do not rise
    """
    low, high = PERIODS[0], PERIODS[-1]
    if not low * (1 - ROUNDING) <= shortest <= longest <= high * (1 + ROUNDING):
        raise RecordError(
            f"periods {shortest:.4g} s to {longest:.4g} s: they must rise, and lie between {low:g} s and {high:g} s"
        )
    if not np.any((shortest * (1 - ROUNDING) <= PERIODS) & (longest * (1 + ROUNDING) >= PERIODS)):
        raise RecordError(f"periods {shortest:.6g} s to {longest:.6g} s: too narrow; widen them by six percent")
    ends = np.array([shortest, longest])
    place = np.interp(np.log(ends), np.log(PERIODS), np.arange(PERIODS.size))
    place = np.where(np.abs(place - np.round(place)) < ROUNDING / STEP, np.round(place), place)
    first, last = int(np.floor(place[0])), int(np.ceil(place[1]))
    at = np.arange(first, last + 1)
    between = PERIODS[at[(at > place[0] + 0.5) & (at < place[1] - 0.5)]]
    ends = np.where(place == np.round(place), PERIODS[np.round(place).astype(np.int64)], ends)
    period = np.unique([ends[0], *between, ends[1]])
    return Band(period, _weight(period, weights), PERIODS[first : last + 1])


def truncate_band(band: Band, longest: float) -> Band:
    """Keep the periods of the band up to `longest`, where a target spectrum ends.

    Parameters
    ----------
    band : periods to fit at
    longest : longest period of the target [s]

    Raises
    ------
    RecordError : the target ends before the first period of the band
    """
    kept = band.period <= longest
    if not kept.any():
        raise RecordError(
            f"the spectrum ends at {longest:.4g} s, before the periods from {band.period[0]:.4g} s on that it is to be "
            "fitted at; extend its table"
        )
    return Band(band.period[kept], band.weight[kept], band.nodes)


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
