"""Pulses of the ground: shapes of acceleration, exact functions of a phase, and the primary pulse of a record.

A pulse is a(t) = amplitude * u(theta), theta = 2 pi f_p (t - t_0), where the shape u has the largest absolute value 1.
The first large half of each shape is positive, that of the symmetric Ricker excepted, which has its peak in the middle.

The primary pulse of a record is the pulse of a given shape that matches its acceleration best. The matching index of a
pulse s and a record a is their normalised correlation, <a, s> / sqrt(<a, a> <s, s>), on the acceleration, since the
long pulse of the velocity may carry little of what overturns (Vassiliou & Makris 2011, BSSA 101, 596-618). Its square
is the share of the record's energy that the pulse of least-squares amplitude explains. Here, for each period of a
logarithmic grid, the start with the largest index is found by correlation with a fast Fourier transform; each local
maximum over the period is then refined in period and start together.

It departs from the paper in four points. One shape is matched, by default the one sine of the overturning plots, not
the best of a family: gamma and nu of Mavroeidis & Papageorgiou's shape stay as given. The amplitude is that of least
squares. All local maxima over the period are returned, as a longer, weaker pulse may be the worse one for a large
body. The ground is taken to be at rest before and after the record, so that a pulse may reach beyond its ends. (The
paper was not at hand: its method is given as others describe it.)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil, exp, floor, isfinite, log, pi, sqrt

import numpy as np
from numpy.polynomial.hermite_e import hermeval
from numpy.typing import ArrayLike

from assess.messages.message import Quantity, note
from records.errors import RecordError
from records.record import Record, make_record
from spectra.arrays import FloatArray

ORDERS = 6  # a shape's value and its first five derivatives
FEWEST_SAMPLES = 10.0  # samples per period of a sampled pulse
LONGEST = 10_000_000  # samples of a sampled pulse
GAMMA, NU = 2.0, 0.0
LARGEST_GAMMA = 50.0
NIL = 1e-12
TAIL = 8.25  # standard deviations of the Gaussian beyond which a Ricker pulse is below NIL


@dataclass(frozen=True)
class Harmonics:
    """A sum of cosines over the phase: sum of amplitude cos(rate theta + phase), one tuple each [k] [-] [-] [rad]."""

    amplitude: tuple[float, ...]
    rate: tuple[float, ...]
    phase: tuple[float, ...]

    def derivative(self, theta: FloatArray, *, order: int) -> FloatArray:
        """Return the derivative of `order`, 0 for the value, over the phase at `theta` [n] [rad] -> [n]."""
        terms = zip(self.amplitude, self.rate, self.phase, strict=True)
        turn = 0.5 * pi * order  # each derivative of a cosine is a quarter turn ahead
        return np.asarray(sum(a * r**order * np.cos(r * theta + (phase + turn)) for a, r, phase in terms))


@dataclass(frozen=True)
class GaussianDerivative:
    """A derivative of the Gaussian exp(-x^2 / 2), x = theta / sqrt(order), times `factor`.

    Its Fourier amplitude, w^order exp(-order w^2 / 2) with w = f / f_p, is largest at f_p: the dominant frequency.
    """

    order: int
    factor: float

    def derivative(self, theta: FloatArray, *, order: int) -> FloatArray:
        """Return the derivative of `order`, 0 for the value, over the phase at `theta` [n] [rad] -> [n].

        By (d/dx)^m exp(-x^2 / 2) = (-1)^m He_m(x) exp(-x^2 / 2).
        """
        x, m = theta / sqrt(self.order), self.order + order
        scale = self.factor * (-1) ** m / sqrt(self.order) ** order
        return np.asarray(scale * _hermite(m, x) * np.exp(-0.5 * x**2), dtype=np.float64)


@dataclass(frozen=True)
class PulseShape:
    """The shape of an acceleration pulse over its phase theta, zero outside [start, end].

    name : one of `PULSE_SHAPES`
    start, end : the phase interval [rad]
    form : the function within it
    gamma, nu : of a Mavroeidis-Papageorgiou pulse [-] [rad], None for the others
    """

    name: str
    start: float
    end: float
    form: Harmonics | GaussianDerivative
    gamma: float | None = None
    nu: float | None = None

    def value(self, theta: ArrayLike) -> FloatArray:
        """Return u at `theta` [n] [rad] -> [n] [-]."""
        return self._derivative(np.asarray(theta, dtype=np.float64), order=0)

    def derivatives(self, theta: ArrayLike) -> FloatArray:
        """Return u and its first five derivatives over the phase at `theta` [n] [rad] -> [6, n] [-].

        Exact within the closed interval, so that at its ends they are the limits from within; zero outside.
        """
        phase = np.asarray(theta, dtype=np.float64)
        return np.array([self._derivative(phase, order=order) for order in range(ORDERS)])

    def _derivative(self, theta: FloatArray, *, order: int) -> FloatArray:
        within = (theta >= self.start) & (theta <= self.end)
        inside = np.where(within, theta, self.start)  # far outside, a form may overflow
        return np.where(within, self.form.derivative(inside, order=order), 0.0)

    def duration(self, frequency: float) -> float:
        """Return the time [s] from start to end of a pulse of `frequency` f_p [Hz]."""
        return (self.end - self.start) / (2 * pi * frequency)


def mavroeidis_papageorgiou(*, gamma: float = GAMMA, nu: float = NU) -> PulseShape:
    """Return the acceleration of Mavroeidis & Papageorgiou's velocity pulse, of largest absolute value 1.

    v = A/2 [1 + cos(theta / gamma)] cos(theta + nu), |theta| <= pi gamma, theta = 2 pi f_p (t - t_0). The product of
    cosines is a sum of three, so its derivative is one too. At both ends u = 0. With a_p the peak acceleration,
    A = a_p / (2 pi f_p max|dv/dtheta|), where the maximum is for A = 1.

    gamma : lengthens the pulse, so more half cycles [-], above 1; nu : phase of the carrier [rad]. The defaults, 2 and
    0, are a choice: a velocity symmetric in time with one large swing and two lesser ones.
    Source: Mavroeidis & Papageorgiou 2003, BSSA 93, 1099-1131.
    """
    if not 1.0 < gamma <= LARGEST_GAMMA:
        raise RecordError(f"pulse mavroeidis-papageorgiou: gamma = {gamma}; it must be above 1 and at most 50")
    if not isfinite(nu):
        raise RecordError(f"pulse mavroeidis-papageorgiou: nu = {nu} rad; it must be a finite angle")
    rate = (1.0, 1.0 + 1.0 / gamma, 1.0 - 1.0 / gamma)
    speed = (0.5, 0.25, 0.25)
    phase = (nu + pi / 2,) * 3
    peak = _largest_value(
        Harmonics(tuple(a * r for a, r in zip(speed, rate, strict=True)), rate, phase), reach=pi * gamma
    )
    amplitude = tuple(a * r / peak for a, r in zip(speed, rate, strict=True))
    return PulseShape("mavroeidis-papageorgiou", -pi * gamma, pi * gamma, Harmonics(amplitude, rate, phase), gamma, nu)


def _hermite(order: int, x: FloatArray) -> FloatArray:
    """Return the probabilists' Hermite polynomial He_order at x."""
    return np.asarray(hermeval(x, [0.0] * order + [1.0]), dtype=np.float64)


def _ricker(name: str, *, order: int) -> PulseShape:
    """Return a Ricker wavelet of dominant frequency f_p, cut where it is below 1e-12.

        order 2, symmetric      u = (1 - 2 b) exp(-b), b = (pi f_p t)^2 = theta^2 / 4, theta = 0 at the peak
        order 3, antisymmetric  u = x (x^2 - 3) exp(-x^2 / 2) / 1.380, x = theta / sqrt(3) = 2 pi f_p t / sqrt(3)

    Sources: Ricker 1953, Geophysics 18, 10-40; as ground pulses Vassiliou & Makris 2011, BSSA 101, 596-618.
    """
    x_peak = {2: 0.0, 3: sqrt(3 - sqrt(6))}[order]  # first zero of He_(order + 1)
    peak = abs(float(_hermite(order, np.array(x_peak)) * np.exp(-0.5 * x_peak**2)))
    reach = TAIL * sqrt(order)
    return PulseShape(name, -reach, reach, GaussianDerivative(order, -1.0 / peak))


def _largest_value(form: Harmonics, *, reach: float) -> float:
    """Return the largest |value| of `form` over [-reach, reach], zero at both ends: its extremes by Newton's method."""
    grid, step = np.linspace(-reach, reach, 64 * ceil(reach), retstep=True)
    size = np.abs(form.derivative(grid, order=0))
    coarse = grid[1:-1][(size[1:-1] >= size[:-2]) & (size[1:-1] >= size[2:])]
    theta = coarse
    for _ in range(4):
        newton = theta - form.derivative(theta, order=1) / form.derivative(theta, order=2)
        theta = np.clip(newton, coarse - step, coarse + step)
    return float(np.max(np.abs(form.derivative(theta, order=0))))


PULSE_SHAPES: Mapping[str, PulseShape] = {
    "sine": PulseShape("sine", 0.0, 2 * pi, Harmonics((1.0,), (1.0,), (-pi / 2,))),
    "cosine": PulseShape("cosine", 0.0, 2 * pi, Harmonics((1.0,), (1.0,), (0.0,))),
    "half-sine": PulseShape("half-sine", 0.0, pi, Harmonics((1.0,), (1.0,), (-pi / 2,))),
    "ricker": _ricker("ricker", order=2),
    "ricker-antisymmetric": _ricker("ricker-antisymmetric", order=3),
    "mavroeidis-papageorgiou": mavroeidis_papageorgiou(),
}


def pulse_shape(name: str, *, gamma: float | None = None, nu: float | None = None) -> PulseShape:
    """Return the pulse shape of that name.

    Parameters
    ----------
    name : one of `PULSE_SHAPES`
    gamma, nu : of mavroeidis-papageorgiou alone [-] [rad]

    Raises
    ------
    RecordError : the name is unknown, or gamma and nu are given for another shape
    """
    if name not in PULSE_SHAPES:
        raise RecordError(f"pulse {name!r}: no such shape; known are {', '.join(PULSE_SHAPES)}")
    if gamma is None and nu is None:
        return PULSE_SHAPES[name]
    if name != "mavroeidis-papageorgiou":
        raise RecordError(f"pulse {name}: gamma and nu are of mavroeidis-papageorgiou alone; leave them out")
    return mavroeidis_papageorgiou(gamma=GAMMA if gamma is None else gamma, nu=NU if nu is None else nu)


def pulse_record(shape: PulseShape, *, frequency: float, amplitude: float, dt: float) -> Record:
    """Return the pulse sampled every `dt` [s] from its start, for `frequency` f_p [Hz] and peak `amplitude` [m/s2].

    It begins and ends with a sample of zero: where the shape jumps (cosine), a step before and one after are ramps.
    A negative amplitude is the pulse reversed. Straight lines between n samples per period lower the harmonic at f_p
    by sinc^2(pi / n), about 1 - pi^2 / (3 n^2): 2.1e-5 for n = 400, 3.3 % for the fewest taken here, 10. Thresholds of
    overturning come out higher by as much: divide by it, or use `derivatives`, where that counts.

    Raises RecordError for values that are not positive (zero or not finite: amplitude), or a step too coarse or fine.
    """
    where = f"pulse {shape.name}"
    if not (0.0 < dt < np.inf and 0.0 < frequency < np.inf):
        raise RecordError(f"{where}: frequency {frequency} Hz, time step {dt} s; both must be positive")
    if not isfinite(amplitude) or amplitude == 0.0:
        raise RecordError(f"{where}: amplitude {amplitude} m/s2; it must be a number other than zero")
    if frequency * dt * FEWEST_SAMPLES > 1.0 + 1e-9:
        raise RecordError(
            f"{where}: a step of {dt:.6g} s is {1 / (frequency * dt):.3g} samples per period; take {FEWEST_SAMPLES:g} "
            f"or more, a step of at most {1 / (FEWEST_SAMPLES * frequency):.3g} s"
        )
    if shape.duration(frequency) / dt > LONGEST:
        raise RecordError(f"{where}: a step of {dt:.6g} s gives more than {LONGEST:,} samples; take a longer step")
    size = Quantity(amplitude, "acceleration", 6)
    history = note("pulse", shape=shape.name, frequency=Quantity(frequency, "frequency", 6), amplitude=size)
    acceleration = amplitude * _end_at_zero(shape.value(_phases(shape, step=2 * pi * frequency * dt)))
    return make_record(f"{shape.name}-{frequency:.6g}Hz", acceleration, dt, processing_history=(history,))


PERIODS: tuple[float, ...] = tuple(float(period) for period in np.geomspace(0.1, 20.0, 61))
FEWEST_STEPS = 5.0  # steps of the record in the shortest period
GAIN = 1.5  # of the explained energy by refining, at most: it is some percent between two periods of the default grid
WIDEST = 1.25  # ratio of neighbouring periods of a grid: beyond it a maximum can be missed


@dataclass(frozen=True)
class PrimaryPulse:
    """A pulse a(t) = polarity amplitude u(2 pi frequency (t - start) + shape.start) that matches a record.

    shape : of the pulse
    frequency : f_p [Hz]
    amplitude : of least squares, positive [m/s2]
    start : time [s] of the shape's first phase, from the record's first sample
    polarity : 1, or -1 for the shape reversed
    energy_share : of the whole record's integral of a^2 [-], 0 to 1
    index : matching index [-], the root of the energy share
    at_end : whether it is at an end of the grid of periods, beyond which the match may be better still
    """

    shape: PulseShape
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
    record: Record, *, shape: PulseShape = PULSE_SHAPES["sine"], period: ArrayLike = PERIODS, count: int = 8
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
    maxima = _best_maxima([coarse[k] for k in peaks], record, shape=shape, grid=T, count=count)
    return tuple(_pulse(fit, shape=shape, energy=energy, grid=T) for fit in maxima)


def _phases(shape: PulseShape, *, step: float) -> FloatArray:
    """Return phases from start by `step` [rad] to the last one within the shape: its end itself, where they meet it."""
    steps = (shape.end - shape.start) / step
    if abs(steps - round(steps)) < 1e-9 * steps:
        return np.asarray(np.linspace(shape.start, shape.end, round(steps) + 1), dtype=np.float64)
    return shape.start + step * np.arange(int(steps) + 1, dtype=np.float64)


def _end_at_zero(value: FloatArray) -> FloatArray:
    """Return the samples `value` with a zero at either end, put there where there is none; below 1e-12 is zero."""
    samples = np.where(np.abs(value) < NIL, 0.0, value)
    return np.concatenate([[0.0] * bool(samples[0]), samples, [0.0] * bool(samples[-1])])


def _grid(record: Record, period: ArrayLike, *, shape: PulseShape) -> FloatArray:
    """Return the periods [s] that the record's step allows, checked."""
    T = np.atleast_1d(np.asarray(period, dtype=np.float64))
    if not (np.all(np.isfinite(T)) and np.all(T > 0.0) and np.all(np.diff(T) > 0.0)):
        raise RecordError(f'record "{record.id}": the periods of a pulse must be positive and rising')
    allowed = T[FEWEST_STEPS * record.dt <= T]
    if allowed.size < 3:
        raise RecordError(
            f'record "{record.id}": {allowed.size} periods of at least {FEWEST_STEPS * record.dt:.3g} s, five steps, '
            "to look for a pulse; give three or more"
        )
    if np.any(allowed[1:] > WIDEST * allowed[:-1]):
        raise RecordError(f'record "{record.id}": neighbouring periods of a pulse differ by over 25 %; give more')
    if shape.duration(1.0 / allowed[-1]) > LONGEST * record.dt:
        raise RecordError(f'record "{record.id}": a pulse of {allowed[-1]:.3g} s has too many steps; give less')
    return allowed


def _best_at_each(record: Record, period: FloatArray, *, shape: PulseShape) -> list[_Fit]:
    """Return for each `period` the start, at a sample or before the record, with the largest correlation."""
    a, dt = record.acceleration, record.dt
    from scipy.fft import irfft, next_fast_len, rfft

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


def _fit_at(record: Record, *, shape: PulseShape, period: float, start: float) -> _Fit:
    """Return the pulse of `period` that begins at `start` [s], at the record's samples and those beyond its ends."""
    a, dt = record.acceleration, record.dt
    first, last = ceil(start / dt), floor((start + shape.duration(1.0 / period)) / dt)
    theta = shape.start + 2 * pi / period * (dt * np.arange(first, last + 1) - start)
    s = shape.value(theta)
    low, high = max(first, 0), min(last + 1, a.size)
    correlation = float(a[low:high] @ s[low - first : high - first]) if high > low else 0.0
    return _Fit(period, start, correlation, float(s @ s))


def _refine(record: Record, fit: _Fit, *, shape: PulseShape, grid: FloatArray) -> _Fit:
    """Return the maximum near `fit` over period and start, within the ends of the `grid` of periods."""
    T, width = fit.period, log(grid[1] / grid[0])

    def near(x: FloatArray) -> _Fit:
        period = min(max(T * exp(x[0]), grid[0]), grid[-1])
        return _fit_at(record, shape=shape, period=float(period), start=fit.start + T * float(x[1]))

    def lost(x: FloatArray) -> float:
        return -near(x).explained_energy / fit.explained_energy

    simplex = np.array([[0.0, 0.0], [0.5 * width, 0.0], [0.0, 0.5 * width]])
    from scipy.optimize import minimize

    minimum = minimize(
        lost,
        simplex[0],
        method="Nelder-Mead",
        options={"initial_simplex": simplex, "xatol": 1e-6, "fatol": 1e-11, "maxfev": 200},
    )
    return near(minimum.x)


def _best_maxima(coarse: list[_Fit], record: Record, *, shape: PulseShape, grid: FloatArray, count: int) -> list[_Fit]:
    """Return the `count` best maxima, refined, best first; those that cannot come so far are left as they are."""
    refined: list[_Fit] = []
    maxima: list[_Fit] = []
    for fit in sorted(coarse, key=lambda fit: -fit.explained_energy):
        if len(maxima) >= count and GAIN * fit.explained_energy < maxima[count - 1].explained_energy:
            break
        refined.append(_refine(record, fit, shape=shape, grid=grid))
        maxima = _distinct(refined)
    return maxima[:count]


def _distinct(fits: list[_Fit]) -> list[_Fit]:
    """Return the fits, best first, without those that are the same maximum as a better one."""
    kept: list[_Fit] = []
    for fit in sorted(fits, key=lambda fit: -fit.explained_energy):
        if not any(abs(log(fit.period / k.period)) < 0.02 and abs(fit.start - k.start) < 0.05 * k.period for k in kept):
            kept.append(fit)
    return kept


def _pulse(fit: _Fit, *, shape: PulseShape, energy: float, grid: FloatArray) -> PrimaryPulse:
    """Return the pulse of a fit in a record of `energy` <a, a>."""
    share = fit.explained_energy / energy
    amplitude = fit.correlation / fit.energy
    polarity = 1 if amplitude > 0.0 else -1
    at_end = bool(np.any(np.abs(np.log(fit.period / grid[[0, -1]])) < 1e-6))
    return PrimaryPulse(shape, 1.0 / fit.period, abs(amplitude), fit.start, polarity, share, sqrt(share), at_end)
