"""Elastic response spectra of a record."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from records.errors import RecordError
from records.kernel import peak_displacements
from records.record import Record
from spectra.arrays import FloatArray

COARSEST = 1000.0  # longest step, in periods, that is worth dividing
MOST_KEPT = 64  # spectra that are kept, of records last asked for


def response_spectrum(record: Record, period: ArrayLike, *, damping: float = 0.05) -> FloatArray:
    """Return the pseudo-acceleration (2 pi / T)^2 S_d of the record; at T = 0 its peak ground acceleration.

    The response is exact for ground acceleration that is linear between samples, free vibration after the end included,
    and so is its maximum, between samples too. Maxima at samples, as in the PEER database, are lower: up to 1 - cos(pi
    dt / T), 1.2 % where a period has 20 samples.

    Parameters
    ----------
    record : accelerogram
    period : periods of the oscillators [any shape] [s]
    damping : damping ratio [-]

    Returns
    -------
    array [shape of period] [m/s2]

    Raises
    ------
    RecordError : a period is negative, not finite or shorter than 1/1000 of the record's step; the damping is outside 0
        <= damping < 1

    Source: Nigam & Jennings 1969, BSSA 59, 909-922.
    """
    T = np.asarray(period, dtype=np.float64)
    S_d = displacement_spectrum(record, T, damping=damping)
    rigid = T == 0.0
    omega = 2.0 * np.pi / np.where(rigid, 1.0, T)
    return np.asarray(np.where(rigid, record.pga, omega**2 * S_d), dtype=np.float64)


def displacement_spectrum(record: Record, period: ArrayLike, *, damping: float = 0.05) -> FloatArray:
    """Return the largest relative displacement S_d [m] at each `period` [s] (same shape), as `response_spectrum`.

    At T = 0 it is 0.
    """
    T = np.asarray(period, dtype=np.float64)
    bad = T[~(np.isfinite(T) & (T >= 0.0))]
    if bad.size:
        raise RecordError(
            f'record "{record.id}": response asked at period {bad.flat[0]} s; periods are finite and not negative'
        )
    if not 0.0 <= damping < 1.0:
        raise RecordError(
            f'record "{record.id}": response asked at damping ratio {damping}; it must be from 0 to below 1'
        )
    moving = T > 0.0
    if np.any(T[moving] * COARSEST < record.dt):
        raise RecordError(
            f'record "{record.id}": its step of {record.dt:.6g} s is too coarse for a period of '
            f"{np.min(T[moving]):.3g} s"
        )
    S_d = np.zeros(T.shape)
    S_d[moving] = _peaks(record.acceleration.tobytes(), record.dt, T[moving].tobytes(), damping)
    return S_d


@lru_cache(maxsize=MOST_KEPT)
def _peaks(acceleration: bytes, dt: float, period: bytes, damping: float) -> FloatArray:
    """Return the largest displacements of oscillators [m]; the same suite is asked of for each of many walls."""
    return peak_displacements(np.frombuffer(acceleration), dt, np.frombuffer(period), damping)
