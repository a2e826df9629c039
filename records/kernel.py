"""The elastic oscillator under piecewise-linear ground acceleration, compiled.

    u'' + 2 damping omega u' + omega^2 u = -a(t)

Between two samples a(t) is a line, so the response there is known in closed form (Nigam & Jennings 1969, BSSA 59,
909-922): the recurrence below has no error of integration, whatever the step.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

from records.compilation.kernel import cache_on_disk

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

FUSED = {"contract", "nnan"}
"""a * b + c in one rounding; no nan comes in, as records hold none."""
STEPS_PER_PERIOD = 20.0
VISIT = 2  # steps of one oscillator in a row while its numbers are at hand
BLOCK = 16  # steps whose maximum is looked for together, a multiple of VISIT


@njit(nogil=True)
def advance(
    u: float, v: float, a: float, slope: float, time: float, omega: float, damping: float
) -> tuple[float, float]:
    """Displacement [m] and velocity [m/s] after `time` [s] under ground acceleration a + slope t [m/s2], from u, v."""
    omega_d = omega * math.sqrt(1.0 - damping * damping)
    drift = -slope / omega**2
    start = -a / omega**2 + 2.0 * damping * slope / omega**3
    x, y = u - start, v - drift
    decay = math.exp(-damping * omega * time)
    cosine, sine = decay * math.cos(omega_d * time), decay * math.sin(omega_d * time) / omega_d
    u_end = start + drift * time + x * cosine + (y + damping * omega * x) * sine
    v_end = drift + y * cosine - (omega * omega * x + damping * omega * y) * sine
    return u_end, v_end


@njit(nogil=True)
def divisions(period: FloatArray, dt: float) -> IntArray:
    """Equal parts of a step [k] that are at most a twentieth of each period."""
    parts = np.empty(period.size, dtype=np.int64)
    for k in range(period.size):
        parts[k] = max(1, math.ceil(dt * STEPS_PER_PERIOD / period[k] - 1e-9))
    return parts


@njit(nogil=True)
def recurrence(period: FloatArray, damping: float, h: FloatArray) -> FloatArray:
    """What displacement and velocity become over h [k] [s]: of themselves, of the acceleration and its slope [8, k]."""
    found = np.empty((8, period.size))
    for k in range(period.size):
        omega = 2.0 * math.pi / period[k]
        found[0, k], found[4, k] = advance(1.0, 0.0, 0.0, 0.0, h[k], omega, damping)
        found[1, k], found[5, k] = advance(0.0, 1.0, 0.0, 0.0, h[k], omega, damping)
        found[2, k], found[6, k] = advance(0.0, 0.0, 1.0, 0.0, h[k], omega, damping)
        found[3, k], found[7, k] = advance(0.0, 0.0, 0.0, 1.0, h[k], omega, damping)
    return found


@njit(nogil=True)
def free_part(period: FloatArray, damping: float) -> FloatArray:
    """Coefficients [4, k] of the free vibration within a step, u(t) + a(t) / omega^2 - 2 damping slope / omega^3.

    It is free = u + [0] a + [1] slope, and a quarter of its turn away [2] free + [3] (v + [0] slope).
    """
    found = np.empty((4, period.size))
    for k in range(period.size):
        omega = 2.0 * math.pi / period[k]
        found[0, k], found[1, k] = 1.0 / omega**2, -2.0 * damping / omega**3
        found[2, k] = damping / math.sqrt(1.0 - damping * damping)
        found[3, k] = 1.0 / (omega * math.sqrt(1.0 - damping * damping))
    return found


@njit(nogil=True, fastmath=FUSED)
def sweep(start: FloatArray, slope: FloatArray, of: FloatArray, free: FloatArray, u: FloatArray, v: FloatArray,
          largest: FloatArray, swing: FloatArray) -> None:  # fmt: skip
    """Through some steps with all oscillators [k] side by side, which the compiler does four at a time.

    start, slope : ground acceleration at the beginning of each step and its slope in it [n], n a multiple of VISIT
    of, free : `recurrence` over a step and `free_part` of the oscillators; u, v : displacement, velocity [k], moved on
    largest : |u| at the samples so far [k], raised; swing : squared amplitude of the free vibration [k], raised
    """
    uu, uv, ua, us, vu, vv, va, vs = of[0], of[1], of[2], of[3], of[4], of[5], of[6], of[7]
    fa, fs, qf, qv = free[0], free[1], free[2], free[3]
    for i in range(0, start.size, VISIT):
        for k in range(u.size):
            x, y, most, square = u[k], v[k], largest[k], swing[k]
            for j in range(i, i + VISIT):
                a, rise = start[j], slope[j]
                f = x + (fa[k] * a + fs[k] * rise)
                quarter = qf[k] * f + qv[k] * (y + fa[k] * rise)
                square = max(square, f * f + quarter * quarter)
                x, y = (
                    (uu[k] * x + uv[k] * y) + (ua[k] * a + us[k] * rise),
                    (vu[k] * x + vv[k] * y) + (va[k] * a + vs[k] * rise),
                )
                most = max(most, abs(x))
            u[k], v[k], largest[k], swing[k] = x, y, most, square


@njit(nogil=True)
def largest_in(start: FloatArray, slope: FloatArray, h: float, parts: int, of: FloatArray, u: float, v: float) -> float:
    """Largest |u| [m] of one oscillator at `parts` points h [s] apart in each of some steps; of : recurrence over h."""
    largest = 0.0
    for i in range(start.size):
        for part in range(parts):
            a = start[i] + slope[i] * (part * h)
            u, v = (
                (of[0] * u + of[1] * v) + (of[2] * a + of[3] * slope[i]),
                (of[4] * u + of[5] * v) + (of[6] * a + of[7] * slope[i]),
            )
            largest = max(largest, abs(u))
    return largest


@njit(nogil=True)
def largest_after(time: float, h: float, of: FloatArray, u: float, v: float) -> float:
    """Largest |u| [m] at points h [s] apart during `time` [s] of free vibration; of : recurrence over h."""
    largest = 0.0
    for _ in range(math.ceil(time / h)):
        u, v = of[0] * u + of[1] * v, of[4] * u + of[5] * v
        largest = max(largest, abs(u))
    return largest


@cache_on_disk
@njit(nogil=True)
def peak_displacements(acceleration: FloatArray, dt: float, period: FloatArray, damping: float) -> FloatArray:
    """Largest |relative displacement| of each oscillator [m], from rest, during the motion and after it.

    acceleration : of the ground, linear between samples, zero after the last [n] [m/s2]
    dt : step [s]; period [k] [s], positive; damping [-], below 1

    Maxima are taken at the samples, each step divided into equal parts where it exceeds a twentieth of the period.
    A block of steps is divided only where its parts could hold the maximum. Within a step u is a line, the static
    displacement under the ground's acceleration and slope, and a free vibration f of amplitude F at its beginning;
    |f| <= F and |f''| <= omega^2 F. So |u| exceeds neither the line's largest by more than F, nor the larger of the
    samples beside it by more than (omega dt)^2 / 8 F, the rise of an arc above its chord.
    """
    parts = divisions(period, dt)
    h, arc = dt / parts, (2.0 * math.pi * dt / period) ** 2 / 8.0
    of, finer = recurrence(period, damping, np.full(period.size, dt)), recurrence(period, damping, h)
    free = free_part(period, damping)
    still = -(acceleration.size - 1) % BLOCK  # steps of rest before the first, so that blocks are whole
    start, slope = np.zeros(still + acceleration.size - 1), np.zeros(still + acceleration.size - 1)
    start[still:], slope[still:] = acceleration[:-1], (acceleration[1:] - acceleration[:-1]) / dt
    u, v, peak = np.zeros(period.size), np.zeros(period.size), np.zeros(period.size)
    u0, v0, largest, swing = np.empty_like(u), np.empty_like(u), np.empty_like(u), np.empty_like(u)
    for i in range(0, start.size, BLOCK):
        a, rise = start[i : i + BLOCK], slope[i : i + BLOCK]
        u0[:], v0[:], largest[:], swing[:] = u, v, np.abs(u), 0.0
        sweep(a, rise, of, free, u, v, largest, swing)
        a_most, rise_most = max(np.max(np.abs(a)), np.max(np.abs(a + rise * dt))), np.max(np.abs(rise))
        for k in range(period.size):
            F = math.sqrt(swing[k])
            line = free[0, k] * a_most - free[1, k] * rise_most
            if min(largest[k] + arc[k] * F, line + F) > peak[k]:
                within = largest_in(a, rise, h[k], parts[k], finer[:, k], u0[k], v0[k])
                peak[k] = max(peak[k], within)
    for k in range(period.size):  # one period of free vibration holds its largest swing
        peak[k] = max(peak[k], largest_after(period[k], h[k], finer[:, k], u[k], v[k]))
    return peak


@cache_on_disk
@njit(nogil=True)
def relative_accelerations(
    acceleration: FloatArray, dt: float, parts: int, period: float, damping: float
) -> FloatArray:
    """Relative acceleration u'' [m/s2] of the oscillator, from rest, at the samples and `parts` - 1 points between.

    acceleration : of the ground, linear between samples [n] [m/s2]
    dt : step [s]; period [s], positive; damping [-], below 1

    Returns [(n - 1) parts + 1].
    """
    omega = 2.0 * math.pi / period
    h = dt / parts
    uu, vu = advance(1.0, 0.0, 0.0, 0.0, h, omega, damping)
    uv, vv = advance(0.0, 1.0, 0.0, 0.0, h, omega, damping)
    ua, va = advance(0.0, 0.0, 1.0, 0.0, h, omega, damping)
    us, vs = advance(0.0, 0.0, 0.0, 1.0, h, omega, damping)
    found = np.empty((acceleration.size - 1) * parts + 1)
    found[0] = -acceleration[0]
    u, v = 0.0, 0.0
    for i in range(acceleration.size - 1):
        a, slope = acceleration[i], (acceleration[i + 1] - acceleration[i]) / dt
        for part in range(parts):
            now = a + slope * (part * h)
            u, v = uu * u + uv * v + ua * now + us * slope, vu * u + vv * v + va * now + vs * slope
            after = a + slope * ((part + 1) * h)
            found[i * parts + part + 1] = -after - 2.0 * damping * omega * v - omega * omega * u
    return found
