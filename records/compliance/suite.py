"""A suite of scaled records as codes look at it: spectra beside the target, peaks, steps, durations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from records.record import Record
from records.response import response_spectrum
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

DAMPING = 0.05
FINE: FloatArray = np.geomspace(0.02, 10.0, 271)  # s, a hundred to the decade from 50 Hz to 0.1 Hz
FINE.flags.writeable = False


@dataclass(frozen=True)
class Suite:
    """Scaled records and their target, 5 % damping.

    period [k] [s]; target [k], spectra [n, k]: pseudo-acceleration [m/s2]; target_pga, pga [n] [m/s2]; factor [n]: that
    the records were scaled by; dt, duration [n] [s]
    artificial [n] : which of the records were made; stationary [n] : how long their envelope is level, 0 of others [s]
    usable [n] : longest period that the source's processing left usable, infinite where it does not say [s]
    """

    period: FloatArray
    target: FloatArray
    spectra: FloatArray
    target_pga: float
    pga: FloatArray
    factor: FloatArray
    dt: FloatArray
    duration: FloatArray
    artificial: NDArray[np.bool_]
    stationary: FloatArray
    usable: FloatArray

    @property
    def count(self) -> int:
        """Number of records."""
        return int(self.spectra.shape[0])

    @property
    def mean(self) -> FloatArray:
        """Arithmetic mean of the spectra [k] [m/s2]."""
        return np.asarray(self.spectra.mean(axis=0), dtype=np.float64)

    @property
    def period_range(self) -> tuple[float, float]:
        """Shortest and longest period [s]."""
        return float(self.period[0]), float(self.period[-1])


def suite_of(records: Sequence[Record], factors: Sequence[float], spectrum: Spectrum) -> Suite:
    """Set the spectra of scaled records beside their target.

    Parameters
    ----------
    records : before scaling [n]
    factors : scale factor of each [n] [-]
    spectrum : target, 5 % damping
    """
    end = min(float(FINE[-1]), spectrum.longest_period)
    period = np.append(FINE[end > FINE], end)
    spectra = [f * response_spectrum(r, period, damping=DAMPING) for r, f in zip(records, factors, strict=True)]
    return Suite(
        period=period,
        target=spectrum.acceleration(period, damping=DAMPING),
        spectra=np.array(spectra).reshape(len(records), period.size),
        target_pga=spectrum.pga,
        pga=np.array([f * record.pga for record, f in zip(records, factors, strict=True)]),
        factor=np.array(factors, dtype=np.float64),
        dt=np.array([record.dt for record in records]),
        duration=np.array([record.dt * (record.npts - 1) for record in records]),
        artificial=np.array([record.artificial for record in records], dtype=np.bool_),
        stationary=np.array([record.stationary or 0.0 for record in records]),
        usable=np.array([record.longest_period or np.inf for record in records]),
    )
