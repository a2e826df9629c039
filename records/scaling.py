"""Scaling a record to a design spectrum, to one of its ordinates or to a peak ground acceleration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from records.band import interpolate
from records.errors import RecordError
from records.record import Record
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

DAMPING = 0.05
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
    own = response_spectrum(record, at, damping=DAMPING)
    still = at[~(own > 0.0)]
    if still.size:
        raise RecordError(
            f'record "{record.id}": no motion at a period of {still[0]:.4g} s; it cannot be scaled to a spectrum'
        )
    logarithm = np.log(own) if nodes is None else interpolate(T, nodes, np.log(own))
    return np.asarray(np.log(spectrum.acceleration(T, damping=DAMPING)) - logarithm, dtype=np.float64)


def _factor(log_factor: float, record: Record) -> float:
    if abs(log_factor) > np.log(LARGEST_FACTOR):
        raise RecordError(
            f'record "{record.id}": a factor of e^{log_factor:.3g} would bring it to the spectrum; check its unit'
        )
    return float(np.exp(log_factor))
