"""Scaling a record to a design spectrum or to a peak ground acceleration."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from records.errors import RecordError
from records.record import Record
from records.response import response_spectrum
from spectra.spectrum import Spectrum

FloatArray = NDArray[np.float64]

DAMPING = 0.05
LARGEST_FACTOR = 1e9
SCALING_PERIODS: tuple[float, ...] = tuple(float(period) for period in np.geomspace(0.1, 2.0, 41))


@dataclass(frozen=True)
class Scaling:
    """A scale factor [-], and the mean squared difference of natural logarithms that it leaves [-]."""

    factor: float
    mse: float


def scale_to_spectrum(record: Record, spectrum: Spectrum, *, period: ArrayLike = SCALING_PERIODS) -> Scaling:
    """The factor that brings the record's 5 % spectrum closest to the target over `period` [k] [s], equally weighted.

    It minimises mse = mean (ln(target) - ln(factor record))^2, so ln(factor) = mean ln(target / record), and the mse
    left is the variance of ln(target / record).
    Raises RecordError for a record without motion at these periods.
    Source: PEER (2010), Technical report for the PEER ground motion database web application, §3 (mean squared error).
    """
    ratio = log_ratio(record, spectrum, period=period)
    if abs(float(np.mean(ratio))) > np.log(LARGEST_FACTOR):
        raise RecordError(
            f'record "{record.id}": a factor of e^{np.mean(ratio):.3g} would bring it to the spectrum; check its unit'
        )
    return Scaling(float(np.exp(np.mean(ratio))), float(np.var(ratio)))


def scale_to_pga(record: Record, pga: float) -> float:
    """The factor that brings the record's peak ground acceleration to `pga` [m/s2]."""
    if not record.pga > 0.0:
        raise RecordError(f'record "{record.id}": no motion; it cannot be scaled to a peak ground acceleration')
    if not (np.isfinite(pga) and pga > 0.0):
        raise RecordError(f'record "{record.id}": peak ground acceleration {pga} m/s2 to scale to; it must be positive')
    if not 1 / LARGEST_FACTOR <= pga / record.pga <= LARGEST_FACTOR:
        raise RecordError(
            f'record "{record.id}": peak {record.pga:.3g} m/s2 to be brought to {pga:.3g}; check its unit'
        )
    return pga / record.pga


def misfit(record: Record, spectrum: Spectrum, *, factor: float = 1.0, period: ArrayLike = SCALING_PERIODS) -> float:
    """Mean squared natural-log difference [-] between target and 5 % spectrum of the record times `factor`."""
    return float(np.mean((log_ratio(record, spectrum, period=period) - np.log(factor)) ** 2))


def log_ratio(record: Record, spectrum: Spectrum, *, period: ArrayLike = SCALING_PERIODS) -> FloatArray:
    """ln(target / record), 5 % damping, at each `period` [k] [s] up to the spectrum's longest.

    RecordError where the record has no motion, or the spectrum ends before all periods.
    """
    T = np.atleast_1d(np.asarray(period, dtype=np.float64))
    T = T[spectrum.longest_period >= T]
    if not T.size:
        raise RecordError(
            f'record "{record.id}": the spectrum ends at {spectrum.longest_period:.4g} s, before the periods of scaling'
        )
    own = response_spectrum(record, T, damping=DAMPING)
    still = T[~(own > 0.0)]
    if still.size:
        raise RecordError(
            f'record "{record.id}": no motion at a period of {still[0]:.4g} s; it cannot be scaled to a spectrum'
        )
    return np.asarray(np.log(spectrum.acceleration(T, damping=DAMPING) / own), dtype=np.float64)
