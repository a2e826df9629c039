"""The primary pulse of a record: the pulse of a given shape that matches its acceleration best.

The matching index of a pulse s and a record a is their normalised correlation, <a, s> / sqrt(<a, a> <s, s>), on the
acceleration, since the long pulse of the velocity may carry little of what overturns (Vassiliou & Makris 2011, BSSA
101, 596-618). Its square is the share of the record's energy that the pulse of least-squares amplitude explains. Here,
for each period of a logarithmic grid, the start with the largest index is found by correlation with a fast Fourier
transform; each local maximum over the period is then refined in period and start together.

It departs from the paper in four points. One shape is matched, by default the one sine of the overturning plots, not
the best of a family: gamma and nu of Mavroeidis & Papageorgiou's shape stay as given. The amplitude is that of least
squares. All local maxima over the period are returned, as a longer, weaker pulse may be the worse one for a large body.
The ground is taken to be at rest before and after the record, so that a pulse may reach beyond its ends. (The paper was
not at hand: its method is given as others describe it.)
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, exp, floor, log, pi, sqrt

import numpy as np
from numpy.typing import ArrayLike
from scipy.fft import irfft, next_fast_len, rfft
from scipy.optimize import minimize

from records.errors import RecordError
from records.pulses import LONGEST, SHAPES, Shape
from records.record import Record
from spectra.arrays import FloatArray

PERIODS: tuple[float, ...] = tuple(float(period) for period in np.geomspace(0.1, 20.0, 61))
FEWEST = 5.0  # steps of the record in the shortest period
GAIN = 1.5  # of the explained energy by refining, at most: it is some percent between two periods of the default grid
WIDEST = 1.25  # ratio of neighbouring periods of a grid: beyond it a maximum can be missed


@dataclass(frozen=True)
class PrimaryPulse:
    """A pulse a(t) = polarity amplitude u(2 pi frequency (t - start) + shape.start) that matches a record.

    Attributes
    ----------
    shape : of the pulse
    frequency : f_p [Hz]
    amplitude : of least squares, positive [m/s2]
    start : time [s] of the shape's first phase, from the record's first sample
    polarity : 1, or -1 for the shape reversed
    energy_share : of the whole record's integral of a^2 [-], 0 to 1
    index : matching index [-], the root of the energy share
    at_end : whether it is at an end of the grid of periods, beyond which the match may be better still
    """

    shape: Shape
    frequency: float
    amplitude: float
    start: float
    polarity: int
    energy_share: float
    index: float
    at_end: bool

    def acceleration(self, time: ArrayLike) -> FloatArray:
        """Return the pulse [m/s2] at `time` [n] [s] of the record."""
        theta = self.shape.start + 2 * pi * self.frequency * (np.asarray(time, dtype=np.float64) - self.start)
        return self.polarity * self.amplitude * self.shape.value(theta)


@dataclass(frozen=True)
class _Fit:
    """Correlation <a, s> and energy <s, s> of one pulse, with its `period` and `start` [s]."""

    period: float
    start: float
    correlation: float
    energy: float

    @property
    def explained_energy(self) -> float:
        """Energy that the pulse of least-squares amplitude takes from the record."""
        return self.correlation**2 / self.energy if self.energy > 0.0 else 0.0


def primary_pulses(
    record: Record, *, shape: Shape = SHAPES["sine"], period: ArrayLike = PERIODS, count: int = 8
) -> tuple[PrimaryPulse, ...]:
    """Find the pulse of `shape` that matches the record best, then other local maxima over the period.

    The record should be free of offset and drift, which look like very long pulses.

    Parameters
    ----------
    record : accelerogram
    shape : of the pulse
    period : grid [k] [s], rising, neighbours within 25 %; periods below five of the record's steps are left out. Its
        ends count as maxima where the match grows towards them
    count : largest number of pulses

    Raises
    ------
    RecordError : the record has no motion, or the grid is not as described
    """
    T = _grid(record, period, shape=shape)
    energy = float(record.acceleration @ record.acceleration)
    if not energy > 0.0:
        raise RecordError(f'record "{record.id}": no motion; it has no pulse')
    coarse = _best_at_each(record, T, shape=shape)
    share = np.array([0.0, *(fit.explained_energy for fit in coarse), 0.0])
    peaks = np.flatnonzero((share[1:-1] > share[:-2]) & (share[1:-1] >= share[2:]))
    found = _best([coarse[k] for k in peaks], record, shape=shape, grid=T, count=count)
    return tuple(_pulse(fit, shape=shape, energy=energy, grid=T) for fit in found)


def _grid(record: Record, period: ArrayLike, *, shape: Shape) -> FloatArray:
    """Return the periods [s] that the record's step allows, checked."""
    T = np.atleast_1d(np.asarray(period, dtype=np.float64))
    if not (np.all(np.isfinite(T)) and np.all(T > 0.0) and np.all(np.diff(T) > 0.0)):
        raise RecordError(f'record "{record.id}": the periods of a pulse must be positive and rising')
    allowed = T[FEWEST * record.dt <= T]
    if allowed.size < 3:
        raise RecordError(
            f'record "{record.id}": {allowed.size} periods of at least {FEWEST * record.dt:.3g} s, five steps, to look '
            "for a pulse; give three or more"
        )
    if np.any(allowed[1:] > WIDEST * allowed[:-1]):
        raise RecordError(f'record "{record.id}": neighbouring periods of a pulse differ by over 25 %; give more')
    if shape.duration(1.0 / allowed[-1]) > LONGEST * record.dt:
        raise RecordError(f'record "{record.id}": a pulse of {allowed[-1]:.3g} s has too many steps; give less')
    return allowed


def _best_at_each(record: Record, period: FloatArray, *, shape: Shape) -> list[_Fit]:
    """Return for each `period` the start, at a sample or before the record, with the largest correlation."""
    a, dt = record.acceleration, record.dt
    size = next_fast_len(a.size + ceil(shape.duration(1.0 / period[-1]) / dt) + 1, real=True)
    spectrum = rfft(a, size)
    fits = []
    for T in period:
        theta = np.arange(shape.start, shape.end, 2 * pi * dt / T)
        s = shape.value(theta)
        correlation = irfft(spectrum * np.conj(rfft(s, size)), size)
        best = int(np.argmax(np.abs(correlation)))
        lag = best if best < a.size else best - size
        fits.append(_Fit(float(T), lag * dt, float(correlation[best]), float(s @ s)))
    return fits


def _at(record: Record, *, shape: Shape, period: float, start: float) -> _Fit:
    """Return the pulse of `period` that begins at `start` [s], at the record's samples and those beyond its ends."""
    a, dt = record.acceleration, record.dt
    first, last = ceil(start / dt), floor((start + shape.duration(1.0 / period)) / dt)
    theta = shape.start + 2 * pi / period * (dt * np.arange(first, last + 1) - start)
    s = shape.value(theta)
    low, high = max(first, 0), min(last + 1, a.size)
    correlation = float(a[low:high] @ s[low - first : high - first]) if high > low else 0.0
    return _Fit(period, start, correlation, float(s @ s))


def _refined(record: Record, fit: _Fit, *, shape: Shape, grid: FloatArray) -> _Fit:
    """Return the maximum near `fit` over period and start, within the ends of the `grid` of periods."""
    T, width = fit.period, log(grid[1] / grid[0])

    def near(x: FloatArray) -> _Fit:
        period = min(max(T * exp(x[0]), grid[0]), grid[-1])
        return _at(record, shape=shape, period=float(period), start=fit.start + T * float(x[1]))

    def lost(x: FloatArray) -> float:
        return -near(x).explained_energy / fit.explained_energy

    simplex = np.array([[0.0, 0.0], [0.5 * width, 0.0], [0.0, 0.5 * width]])
    found = minimize(
        lost,
        simplex[0],
        method="Nelder-Mead",
        options={"initial_simplex": simplex, "xatol": 1e-6, "fatol": 1e-11, "maxfev": 200},
    )
    return near(found.x)


def _best(coarse: list[_Fit], record: Record, *, shape: Shape, grid: FloatArray, count: int) -> list[_Fit]:
    """Return the `count` best maxima, refined, best first; those that cannot come so far are left as they are."""
    refined: list[_Fit] = []
    found: list[_Fit] = []
    for fit in sorted(coarse, key=lambda fit: -fit.explained_energy):
        if len(found) >= count and GAIN * fit.explained_energy < found[count - 1].explained_energy:
            break
        refined.append(_refined(record, fit, shape=shape, grid=grid))
        found = _distinct(refined)
    return found[:count]


def _distinct(fits: list[_Fit]) -> list[_Fit]:
    """Return the fits, best first, without those that are the same maximum as a better one."""
    kept: list[_Fit] = []
    for fit in sorted(fits, key=lambda fit: -fit.explained_energy):
        if not any(abs(log(fit.period / k.period)) < 0.02 and abs(fit.start - k.start) < 0.05 * k.period for k in kept):
            kept.append(fit)
    return kept


def _pulse(fit: _Fit, *, shape: Shape, energy: float, grid: FloatArray) -> PrimaryPulse:
    """Return the pulse of a fit in a record of `energy` <a, a>."""
    share = fit.explained_energy / energy
    amplitude = fit.correlation / fit.energy
    polarity = 1 if amplitude > 0.0 else -1
    at_end = bool(np.any(np.abs(np.log(fit.period / grid[[0, -1]])) < 1e-6))
    return PrimaryPulse(shape, 1.0 / fit.period, abs(amplitude), fit.start, polarity, share, sqrt(share), at_end)
