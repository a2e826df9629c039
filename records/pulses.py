"""Pulses of the ground: shapes of acceleration, exact functions of a phase.

A pulse is a(t) = amplitude * u(theta), theta = 2 pi f_p (t - t_0), where the shape u has the largest absolute value 1.
The first large half of each shape is positive, that of the symmetric Ricker excepted, which has its peak in the middle.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil, isfinite, pi, sqrt

import numpy as np
from numpy.polynomial.hermite_e import hermeval
from numpy.typing import ArrayLike

from assess.messages.message import Quantity, note
from records.errors import RecordError
from records.record import Record, make_record
from spectra.arrays import FloatArray

ORDERS = 6  # a shape's value and its first five derivatives
FEWEST = 10.0  # samples per period of a sampled pulse
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


def _hermite(order: int, x: FloatArray) -> FloatArray:
    """Return the probabilists' Hermite polynomial He_order at x."""
    return np.asarray(hermeval(x, [0.0] * order + [1.0]), dtype=np.float64)


@dataclass(frozen=True)
class Shape:
    """The shape of an acceleration pulse over its phase theta, zero outside [start, end].

    Attributes
    ----------
    name : one of `SHAPES`
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


def _ricker(name: str, *, order: int) -> Shape:
    """Return a Ricker wavelet of dominant frequency f_p, cut where it is below 1e-12.

        order 2, symmetric      u = (1 - 2 b) exp(-b), b = (pi f_p t)^2 = theta^2 / 4, theta = 0 at the peak
        order 3, antisymmetric  u = x (x^2 - 3) exp(-x^2 / 2) / 1.380, x = theta / sqrt(3) = 2 pi f_p t / sqrt(3)

    Sources: Ricker 1953, Geophysics 18, 10-40; as ground pulses Vassiliou & Makris 2011, BSSA 101, 596-618.
    """
    x_peak = {2: 0.0, 3: sqrt(3 - sqrt(6))}[order]  # first zero of He_(order + 1)
    peak = abs(float(_hermite(order, np.array(x_peak)) * np.exp(-0.5 * x_peak**2)))
    reach = TAIL * sqrt(order)
    return Shape(name, -reach, reach, GaussianDerivative(order, -1.0 / peak))


def mavroeidis_papageorgiou(*, gamma: float = GAMMA, nu: float = NU) -> Shape:
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
    peak = _peak(Harmonics(tuple(a * r for a, r in zip(speed, rate, strict=True)), rate, phase), reach=pi * gamma)
    amplitude = tuple(a * r / peak for a, r in zip(speed, rate, strict=True))
    return Shape("mavroeidis-papageorgiou", -pi * gamma, pi * gamma, Harmonics(amplitude, rate, phase), gamma, nu)


def _peak(form: Harmonics, *, reach: float) -> float:
    """Return the largest |value| of `form` over [-reach, reach], zero at both ends: its extremes by Newton's method."""
    grid, step = np.linspace(-reach, reach, 64 * ceil(reach), retstep=True)
    size = np.abs(form.derivative(grid, order=0))
    coarse = grid[1:-1][(size[1:-1] >= size[:-2]) & (size[1:-1] >= size[2:])]
    theta = coarse
    for _ in range(4):
        newton = theta - form.derivative(theta, order=1) / form.derivative(theta, order=2)
        theta = np.clip(newton, coarse - step, coarse + step)
    return float(np.max(np.abs(form.derivative(theta, order=0))))


SHAPES: Mapping[str, Shape] = {
    "sine": Shape("sine", 0.0, 2 * pi, Harmonics((1.0,), (1.0,), (-pi / 2,))),
    "cosine": Shape("cosine", 0.0, 2 * pi, Harmonics((1.0,), (1.0,), (0.0,))),
    "half-sine": Shape("half-sine", 0.0, pi, Harmonics((1.0,), (1.0,), (-pi / 2,))),
    "ricker": _ricker("ricker", order=2),
    "ricker-antisymmetric": _ricker("ricker-antisymmetric", order=3),
    "mavroeidis-papageorgiou": mavroeidis_papageorgiou(),
}


def shape(name: str, *, gamma: float | None = None, nu: float | None = None) -> Shape:
    """Return the pulse shape of that name.

    Parameters
    ----------
    name : one of `SHAPES`
    gamma, nu : of mavroeidis-papageorgiou alone [-] [rad]

    Raises
    ------
    RecordError : the name is unknown, or gamma and nu are given for another shape
    """
    if name not in SHAPES:
        raise RecordError(f"pulse {name!r}: no such shape; known are {', '.join(SHAPES)}")
    if gamma is None and nu is None:
        return SHAPES[name]
    if name != "mavroeidis-papageorgiou":
        raise RecordError(f"pulse {name}: gamma and nu are of mavroeidis-papageorgiou alone; leave them out")
    return mavroeidis_papageorgiou(gamma=GAMMA if gamma is None else gamma, nu=NU if nu is None else nu)


def pulse_record(shape: Shape, *, frequency: float, amplitude: float, dt: float) -> Record:
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
    if frequency * dt * FEWEST > 1.0 + 1e-9:
        raise RecordError(
            f"{where}: a step of {dt:.6g} s is {1 / (frequency * dt):.3g} samples per period; take {FEWEST:g} or more, "
            f"a step of at most {1 / (FEWEST * frequency):.3g} s"
        )
    if shape.duration(frequency) / dt > LONGEST:
        raise RecordError(f"{where}: a step of {dt:.6g} s gives more than {LONGEST:,} samples; take a longer step")
    size = Quantity(amplitude, "acceleration", 6)
    history = note("pulse", shape=shape.name, frequency=Quantity(frequency, "frequency", 6), amplitude=size)
    samples = amplitude * _between_zeros(shape.value(_phases(shape, step=2 * pi * frequency * dt)))
    return make_record(f"{shape.name}-{frequency:.6g}Hz", samples, dt, processing_history=(history,))


def _phases(shape: Shape, *, step: float) -> FloatArray:
    """Return phases from start by `step` [rad] to the last one within the shape: its end itself, where they meet it."""
    steps = (shape.end - shape.start) / step
    if abs(steps - round(steps)) < 1e-9 * steps:
        return np.asarray(np.linspace(shape.start, shape.end, round(steps) + 1), dtype=np.float64)
    return shape.start + step * np.arange(int(steps) + 1, dtype=np.float64)


def _between_zeros(value: FloatArray) -> FloatArray:
    """Return the samples `value` with a zero at either end, put there where there is none; below 1e-12 is zero."""
    samples = np.where(np.abs(value) < NIL, 0.0, value)
    return np.concatenate([[0.0] * bool(samples[0]), samples, [0.0] * bool(samples[-1])])
