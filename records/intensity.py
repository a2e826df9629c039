"""Measures of a ground motion's strength and duration."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.constants import g

from records.integration import integrate_absolute, integrate_squared, largest_displacement, largest_velocity
from records.record import Record
from records.response import response_spectrum
from spectra.arrays import FloatArray

LOWEST, HIGHEST = 0.25, 20.0  # Hz, of the mean period
FINEST = 0.05  # Hz, widest spacing of its frequencies (Rathje et al. 2004)
HOUSNER_PERIODS: FloatArray = np.linspace(0.1, 2.5, 121)  # s


@dataclass(frozen=True)
class Measures:
    """All measures of a record.

    pga [m/s2], pgv [m/s], pgd [m] : peaks; arias : Arias intensity [m/s]; cav : cumulative absolute velocity [m/s]
    d5_75, d5_95 : significant durations [s]; mean_period : T_m [s]; housner : spectrum intensity [m]
    """

    pga: float
    pgv: float
    pgd: float
    arias: float
    cav: float
    d5_75: float
    d5_95: float
    mean_period: float
    housner: float


def measures(record: Record) -> Measures:
    """Compute every measure of the record as it is; without a corrected baseline `pgv` and `pgd` may hold a drift."""
    return Measures(
        pga=record.pga,
        pgv=pgv(record),
        pgd=pgd(record),
        arias=arias(record),
        cav=cav(record),
        d5_75=significant_duration(record, start=0.05, end=0.75),
        d5_95=significant_duration(record, start=0.05, end=0.95),
        mean_period=mean_period(record),
        housner=housner(record),
    )


def pgv(record: Record) -> float:
    """Return the peak ground velocity [m/s], of acceleration that is linear between samples."""
    return largest_velocity(record)


def pgd(record: Record) -> float:
    """Return the peak ground displacement [m], of acceleration that is linear between samples."""
    return largest_displacement(record)


def arias(record: Record) -> float:
    """Return the Arias intensity pi / (2 g) * integral of a^2 dt [m/s].

    Source: Arias (1970), A measure of earthquake intensity, in Hansen (ed.), Seismic design for nuclear power plants.
    """
    return float(pi / (2.0 * g) * integrate_squared(record)[-1])


def cav(record: Record) -> float:
    """Return the cumulative absolute velocity, integral of |a| dt [m/s]. Source: EPRI (1988), report NP-5930."""
    return float(integrate_absolute(record)[-1])


def significant_duration(record: Record, *, start: float, end: float) -> float:
    """Return the time [s] in which the Arias intensity grows from `start` to `end` of the whole; 0 without motion.

    Source: Trifunac & Brady (1975), BSSA 65, 581-626: D5-95; Somerville et al. (1997), Seism. Res. Lett. 68: D5-75.
    """
    build_up = integrate_squared(record)
    if not build_up[-1] > 0.0:
        return 0.0
    instants = np.interp(np.array([start, end]) * build_up[-1], build_up, record.time)
    return float(instants[1] - instants[0])


def mean_period(record: Record) -> float:
    """Return the mean period T_m = sum(C^2 / f) / sum(C^2) [s] over Fourier amplitudes C from 0.25 to 20 Hz.

    It is 0 without any. Zeros after the record make the frequencies at most 0.05 Hz apart. Source: Rathje, Abrahamson &
    Bray (1998), J. Geotech. Geoenviron. Eng. 124, 150-159; spacing: Rathje, Faraj, Russell & Bray (2004), Earthquake
    Spectra 20.
    """
    size = max(record.npts, int(np.ceil(1.0 / (FINEST * record.dt))))
    f = np.fft.rfftfreq(size, record.dt)
    C = np.abs(np.fft.rfft(record.acceleration, size))
    inside = (f >= LOWEST) & (f <= HIGHEST)
    f, C = f[inside], C[inside]
    power = float(np.sum(C**2))
    return float(np.sum(C**2 / f)) / power if power > 0.0 else 0.0


def housner(record: Record, *, damping: float = 0.05) -> float:
    """Return the spectrum intensity [m], the integral of the pseudo-velocity over periods of 0.1 to 2.5 s.

    damping : ratio [-]. Source: Housner (1952), Spectrum intensities of strong-motion earthquakes, Proc. symp.
    earthquake and blast effects on structures, EERI; by the trapezoidal rule over 121 periods.
    """
    PSV = response_spectrum(record, HOUSNER_PERIODS, damping=damping) * HOUSNER_PERIODS / (2.0 * pi)
    return float(np.trapezoid(PSV, HOUSNER_PERIODS))
