"""Scaling a record to a design spectrum over a band of periods, to one of its ordinates, or to a peak acceleration."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from records.candidates import DAMPING, PERIODS
from records.errors import RecordError
from records.record import Record
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

LARGEST_FACTOR = 1e9
SCALING_PERIODS: tuple[float, ...] = tuple(float(period) for period in np.geomspace(0.1, 2.0, 41))


@dataclass(frozen=True)
class Scaling:
    """A scale factor [-], and the mean squared difference of natural logarithms that it leaves [-]."""

    factor: float
    mse: float


def least_squares(log_ratio: FloatArray, *, weight: FloatArray | None = None) -> tuple[FloatArray, FloatArray]:
    """Return the scale factors that bring spectra closest to a target, as ln(factor) and mse [...].

    mse = sum w (ln(target) - ln(factor record))^2 / sum w is least at ln(factor) = sum w ln(target / record) / sum w.

    Parameters
    ----------
    log_ratio : ln(target / record) [..., k] [-]
    weight : of each period [k], equal if None

    Source: PEER (2010), Technical report for the PEER ground motion database web application, §3 (mean squared error).
    """
    log_factor = np.average(log_ratio, axis=-1, weights=weight)
    return log_factor, mean_square(log_ratio - log_factor[..., np.newaxis], weight=weight)


def mean_square(difference: FloatArray, *, weight: FloatArray | None = None) -> FloatArray:
    """Return the weighted mean of the squares: the mse of a given factor.

    Parameters
    ----------
    difference : of logarithms [..., k] [-]
    weight : of each period [k], equal if None
    """
    return np.asarray(np.average(difference**2, axis=-1, weights=weight))


def scale_to_spectrum(
    record: Record,
    spectrum: Spectrum,
    *,
    period: ArrayLike = SCALING_PERIODS,
    weight: FloatArray | None = None,
    nodes: FloatArray | None = None,
) -> Scaling:
    """Find the factor that brings the record's 5 % spectrum closest to the target, as `least_squares`.

    Parameters
    ----------
    record : accelerogram
    spectrum : target
    period : periods that are compared [k] [s]
    weight : of each period [k], equal if None
    nodes : as in `log_ratio`

    Raises
    ------
    RecordError : the record has no motion at these periods
    """
    ratio = log_ratio(record, spectrum, period=period, nodes=nodes)
    log_factor, mse = least_squares(ratio, weight=None if weight is None else weight[: ratio.size])
    return Scaling(_factor(float(log_factor), record), float(mse))


def scale_to_ordinate(record: Record, spectrum: Spectrum, *, period: float) -> float:
    """Find the factor that brings the record's 5 % ordinate at one period to the target's.

    Parameters
    ----------
    record : accelerogram
    spectrum : target
    period : at which they are equal [s]
    """
    return _factor(float(log_ratio(record, spectrum, period=period)[0]), record)


def scale_to_pga(record: Record, pga: float) -> float:
    """Find the factor that brings the record's peak ground acceleration to `pga`.

    Parameters
    ----------
    record : accelerogram
    pga : peak ground acceleration [m/s2]

    Raises
    ------
    RecordError : the record has no motion, the PGA is not positive, or the factor is beyond 1e9 either way
    """
    if not record.pga > 0.0:
        raise RecordError(f'record "{record.id}": no motion; it cannot be scaled to a peak ground acceleration')
    if not (np.isfinite(pga) and pga > 0.0):
        raise RecordError(f'record "{record.id}": peak ground acceleration {pga} m/s2 to scale to; it must be positive')
    if not 1 / LARGEST_FACTOR <= pga / record.pga <= LARGEST_FACTOR:
        raise RecordError(
            f'record "{record.id}": peak {record.pga:.3g} m/s2 to be brought to {pga:.3g}; check its unit'
        )
    return pga / record.pga


def misfit(
    record: Record,
    spectrum: Spectrum,
    *,
    factor: float = 1.0,
    period: ArrayLike = SCALING_PERIODS,
    weight: FloatArray | None = None,
    nodes: FloatArray | None = None,
) -> float:
    """Return the mean squared natural-log difference [-] between target and 5 % spectrum of the scaled record.

    Parameters
    ----------
    record : accelerogram
    spectrum : target
    factor : scale factor of the record [-]
    period : periods that are compared [k] [s]
    weight : of each period [k], equal if None
    nodes : as in `log_ratio`
    """
    left = log_ratio(record, spectrum, period=period, nodes=nodes) - np.log(factor)
    return float(mean_square(left, weight=None if weight is None else weight[: left.size]))


def log_ratio(
    record: Record,
    spectrum: Spectrum,
    *,
    period: ArrayLike = SCALING_PERIODS,
    nodes: FloatArray | None = None,
) -> FloatArray:
    """Return ln(target / record), 5 % damping, at each period up to the spectrum's longest.

    Parameters
    ----------
    record : accelerogram
    spectrum : target
    period : rising [k] [s]
    nodes : rising periods [m] [s] at which the record's spectrum is computed, linear in logarithms between them;
        `period` if None

    Raises
    ------
    RecordError : the record has no motion, or the spectrum ends before the first period
    """
    T = np.atleast_1d(np.asarray(period, dtype=np.float64))
    T = T[spectrum.longest_period >= T]
    if not T.size:
        raise RecordError(
            f'record "{record.id}": the spectrum ends at {spectrum.longest_period:.4g} s, before the periods of scaling'
        )
    at = T if nodes is None else nodes
    S_a = response_spectrum(record, at, damping=DAMPING)
    at_rest = at[~(S_a > 0.0)]
    if at_rest.size:
        raise RecordError(
            f'record "{record.id}": no motion at a period of {at_rest[0]:.4g} s; it cannot be scaled to a spectrum'
        )
    logarithm = np.log(S_a) if nodes is None else interpolate(T, nodes, np.log(S_a))
    return np.asarray(np.log(spectrum.acceleration(T, damping=DAMPING)) - logarithm, dtype=np.float64)


ROUNDING = 1e-9
CATALOGUE_STEP = float(np.log(PERIODS[1] / PERIODS[0]))


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
    place = np.where(np.abs(place - np.round(place)) < ROUNDING / CATALOGUE_STEP, np.round(place), place)
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


def _factor(log_factor: float, record: Record) -> float:
    if abs(log_factor) > np.log(LARGEST_FACTOR):
        raise RecordError(
            f'record "{record.id}": a factor of e^{log_factor:.3g} would bring it to the spectrum; check its unit'
        )
    return float(np.exp(log_factor))


def _weight(period: FloatArray, weights: Sequence[tuple[float, float]]) -> FloatArray:
    if not weights:
        return np.ones(period.size)
    at, weight = np.array(weights, dtype=np.float64).T
    bad = not np.all(np.isfinite(at) & np.isfinite(weight) & (at > 0.0) & (weight >= 0.0)) or np.any(np.diff(at) <= 0.0)
    interpolated = np.zeros(period.size) if bad else np.interp(np.log(period), np.log(at), weight)
    if not interpolated.max() > 0.0:
        raise RecordError(
            "weights: they must be pairs (period, weight) of rising periods and weights that are not negative, some of "
            f"them above zero between {period[0]:.4g} s and {period[-1]:.4g} s"
        )
    return np.asarray(interpolated / interpolated.max(), dtype=np.float64)
