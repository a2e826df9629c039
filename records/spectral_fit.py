"""Fitting of an accelerogram's 5 % spectrum to a target: rounds of correction in the frequency domain."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from records.kernel import peak_displacements
from spectra.arrays import FloatArray

DAMPING = 0.05
ROUNDS = 40
RISE, STATIONARY = 0.1, 0.5  # shares of the duration
END_LEVEL = 0.05  # of the envelope at the end of the duration
TAPER = 0.05  # share of the duration over which the end is brought to zero


@dataclass(frozen=True)
class Match:
    """An accelerogram [n] [m/s2] and how its spectrum compares with the target over the band.

    low, high : smallest and largest of record / target - 1 [-]; rms of it [-]
    """

    acceleration: FloatArray
    low: float
    high: float
    rms: float

    @property
    def worst(self) -> float:
        """Largest difference, either way [-]."""
        return max(-self.low, self.high)


@dataclass(frozen=True)
class Target:
    """What an accelerogram is fitted to: ordinates [k] [m/s2] at rising period [k] [s]; zero-period ordinate [m/s2]."""

    period: FloatArray
    ordinate: FloatArray
    pga: float


@dataclass(frozen=True)
class Stage:
    """What all records of a set share.

    dt, duration : step and length [s]; n samples from 0
    envelope : of the amplitude [n]
    gate : 1 wherever the envelope is above a twentieth, less outside, so that nothing creeps into the ends [n]
    ends : see `end_weights` [3, n]
    shapes : accelerations that correct the ends [3, n]
    log_period : of each harmonic, ln(T / 1 s), held within the band [m]
    amplitude : of each harmonic at the start, up to a factor [m]
    high_pass : what each harmonic is multiplied by in each round: 0 for periods above 2.5 times the band's longest [m]
    """

    dt: float
    duration: float
    envelope: FloatArray
    gate: FloatArray
    ends: FloatArray
    shapes: FloatArray
    log_period: FloatArray
    amplitude: FloatArray
    high_pass: FloatArray


def make_stage(target: Target, *, duration: float, dt: float) -> Stage:
    """Return the fixed arrays of a set of records; a random motion's amplitudes go as S_a / sqrt(f) to first order."""
    time = dt * np.arange(round(duration / dt) + 1, dtype=np.float64)
    level = envelope(time, duration=float(time[-1]))
    f = np.fft.rfftfreq(2 * time.size, dt)
    T = 1.0 / np.maximum(f, f[1])
    log_period = np.log(np.clip(T, target.period[0], target.period[-1]))
    start = np.interp(log_period, np.log(target.period), target.ordinate) * np.sqrt(T)
    high_pass = np.clip(5.0 * f * target.period[-1] - 2.0, 0.0, 1.0)
    return Stage(
        dt=dt,
        duration=float(time[-1]),
        envelope=level,
        gate=np.minimum(1.0, 20.0 * level),
        ends=end_weights(time.size, dt=dt),
        shapes=np.vstack([level * (time / time[-1]) ** power for power in range(3)]),
        log_period=log_period,
        amplitude=start * high_pass,
        high_pass=high_pass,
    )


def envelope(time: FloatArray, *, duration: float) -> FloatArray:
    """Return the amplitude's envelope [-] at `time` [n] [s]: parabola, level, exponential, brought to zero at the end.

    Source: Jennings, Housner & Tsai 1968, the form of their type A and B earthquakes, in shares of the duration.
    """
    rise, fall = RISE * duration, (RISE + STATIONARY) * duration
    decay = np.log(END_LEVEL) / (duration - fall)
    level = np.minimum(1.0, (time / rise) ** 2) * np.exp(decay * np.maximum(time - fall, 0.0))
    return np.asarray(level * np.sin(0.5 * np.pi * np.clip((duration - time) / (TAPER * duration), 0.0, 1.0)) ** 2)


def end_weights(npts: int, *, dt: float) -> FloatArray:
    """Return rows w [3, npts] so that w . a are the final velocity, displacement and integral of displacement.

    The motion starts from rest. These are the integrals of a(t) (t_end - t)^k / k! for k = 0, 1, 2, exact for a(t)
    linear between samples: at the two ends of a step that ends `left` before t_end, the weights are integrals of that
    over the two hat functions.
    """
    left, h = dt * np.arange(npts - 2, -1, -1), dt
    start = (0.5 * h, h * left / 2 + h**2 / 3, h * left**2 / 4 + h**2 * left / 3 + h**3 / 8)
    end = (0.5 * h, h * left / 2 + h**2 / 6, h * left**2 / 4 + h**2 * left / 6 + h**3 / 24)
    weights = np.zeros((3, npts))
    for row in range(3):
        weights[row, :-1] += start[row]
        weights[row, 1:] += end[row]
    return weights


def fit_rounds(target: Target, stage: Stage, *, phase: FloatArray) -> Iterator[Match]:
    """Yield the accelerograms that these phases [m] [rad] lead to, round after round."""
    n, harmonics = stage.envelope.size, stage.amplitude * np.exp(1j * phase)
    a = stage.envelope * np.fft.irfft(harmonics, 2 * n)[:n]
    a *= target.pga / np.max(np.abs(a))
    for _ in range(ROUNDS):
        a = _without_drift(a * stage.gate, stage, pga=target.pga)
        ratio = _ratio(a, target, stage.dt)
        yield _match(a, ratio)
        correction = stage.high_pass * np.exp(-np.interp(stage.log_period, np.log(target.period), np.log(ratio)))
        a = np.fft.irfft(correction * np.fft.rfft(a, 2 * n), 2 * n)[:n]


def _match(a: FloatArray, ratio: FloatArray) -> Match:
    """Return the accelerogram [n] with record / target [k] summed up."""
    low, high, rms = np.min(ratio) - 1.0, np.max(ratio) - 1.0, np.sqrt(np.mean((ratio - 1.0) ** 2))
    return Match(a, float(low), float(high), float(rms))


def _without_drift(a: FloatArray, stage: Stage, *, pga: float) -> FloatArray:
    """Return the accelerogram [n] with peak `pga` [m/s2] and no velocity or displacement left at the end."""
    system = stage.ends @ stage.shapes.T
    for _ in range(3):
        a = with_peak(a - np.linalg.solve(system, stage.ends @ a) @ stage.shapes, pga=pga)
    a = a - np.linalg.solve(system, stage.ends @ a) @ stage.shapes
    return np.asarray(a * (pga / np.max(np.abs(a))))


def with_peak(a: FloatArray, *, pga: float) -> FloatArray:
    """Return the accelerogram [n] with its peak at `pga` [m/s2].

    Every half-cycle that exceeds it is lowered to it; if none does, the largest is raised. A half-cycle, between
    two changes of sign, is multiplied as a whole: nothing is clipped flat.
    """
    starts = np.concatenate([[0], np.flatnonzero(np.diff(np.signbit(a))) + 1])
    peak = np.maximum.reduceat(np.abs(a), starts)
    scale = pga / np.maximum(peak, pga)
    if np.max(peak) < pga:
        scale[np.argmax(peak)] = pga / np.max(peak)
    return np.asarray(a * np.repeat(scale, np.diff(np.append(starts, a.size))))


def _ratio(a: FloatArray, target: Target, dt: float) -> FloatArray:
    """Return the accelerogram's 5 % response spectrum over the target [k]."""
    omega = 2.0 * np.pi / target.period
    return np.asarray(omega**2 * peak_displacements(a, dt, target.period, DAMPING) / target.ordinate)
