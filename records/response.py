"""Elastic response spectra of a record, and measures of its strength and duration.

Velocity and displacement of the ground are exact for acceleration that is linear between samples.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from records.errors import RecordError
from records.record import Record
from spectra.arrays import FloatArray
from spectra.gravity import g

COARSEST = 1000.0  # longest step, in periods, that is worth dividing
SPECTRA_KEPT = 256  # spectra that are kept in memory, of the records used last


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
    flexible = T > 0.0
    if np.any(T[flexible] * COARSEST < record.dt):
        raise RecordError(
            f'record "{record.id}": its step of {record.dt:.6g} s is too coarse for a period of '
            f"{np.min(T[flexible]):.3g} s"
        )
    S_d = np.zeros(T.shape)
    S_d[flexible] = _peak_displacements(record.acceleration.tobytes(), record.dt, T[flexible].tobytes(), damping)
    return S_d


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
    """Return the peak ground velocity [m/s], at a sample or between two where the acceleration passes through zero."""
    a, b, v = record.acceleration[:-1], record.acceleration[1:], velocity(record)
    passes = a * b < 0.0
    until = record.dt * a[passes] / (a - b)[passes]
    return float(max(np.max(np.abs(v)), np.max(np.abs(v[:-1][passes] + 0.5 * a[passes] * until), initial=0.0)))


def pgd(record: Record) -> float:
    """Return the peak ground displacement [m], at a sample or between two where v + a t + j t^2 / 2 is zero."""
    a, v, d = record.acceleration[:-1], velocity(record)[:-1], displacement(record)
    j = np.diff(record.acceleration) / record.dt
    with np.errstate(divide="ignore", invalid="ignore"):
        q = -(a + np.copysign(np.sqrt(a**2 - 2.0 * j * v), a))  # nan where the velocity is nowhere zero
        roots = np.array([q / j, 2.0 * v / q])
    t = np.where((roots > 0.0) & (roots < record.dt), roots, 0.0)
    return float(max(np.abs(d[-1]), np.max(np.abs(d[:-1] + t * (v + t * (a / 2.0 + t * j / 6.0))))))


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


def velocity(record: Record) -> FloatArray:
    """Return the velocity of the ground at each sample [n] [m/s], from rest.

    As recorded: an offset of the baseline becomes a drift; correct the record first (`correct_baseline`).
    """
    a = record.acceleration
    return _cumulative_sum(0.5 * record.dt * (a[:-1] + a[1:]))


def displacement(record: Record) -> FloatArray:
    """Return the displacement of the ground at each sample [n] [m], from rest. As `velocity`."""
    a, v, h = record.acceleration, velocity(record), record.dt
    return _cumulative_sum(h * v[:-1] + h**2 / 6.0 * (2.0 * a[:-1] + a[1:]))


def integrate_squared(record: Record) -> FloatArray:
    """Integrate the squared acceleration up to each sample [n] [m2/s3]."""
    a, b = record.acceleration[:-1], record.acceleration[1:]
    return _cumulative_sum(record.dt / 3.0 * (a**2 + a * b + b**2))


def integrate_absolute(record: Record) -> FloatArray:
    """Integrate the absolute acceleration up to each sample [n] [m/s]; a step that changes sign is two triangles."""
    a, b = record.acceleration[:-1], record.acceleration[1:]
    total = np.abs(a) + np.abs(b)
    crossing = (a**2 + b**2) / np.where(total > 0.0, total, 1.0)
    return _cumulative_sum(0.5 * record.dt * np.where(a * b < 0.0, crossing, total))


@lru_cache(maxsize=SPECTRA_KEPT)
def _peak_displacements(acceleration: bytes, dt: float, period: bytes, damping: float) -> FloatArray:
    """Return the largest displacements of oscillators [m]; many walls ask for the spectra of one suite."""
    from records.kernel import peak_displacements  # brings numba, which takes half a second to import

    return peak_displacements(np.frombuffer(acceleration), dt, np.frombuffer(period), damping)


def _cumulative_sum(steps: FloatArray) -> FloatArray:
    """Return the running sum from 0, one longer than `steps`."""
    return np.concatenate(([0.0], np.cumsum(steps)))
