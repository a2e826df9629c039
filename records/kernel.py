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

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

FUSED = {"contract", "nnan"}
"""a * b + c in one rounding; no nan comes in, as records hold none."""
STEPS_PER_PERIOD = 20.0


@njit(cache=True, nogil=True)
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


@njit(cache=True, nogil=True)
def divisions(period: FloatArray, dt: float) -> IntArray:
    """Equal parts of a step [k] that are at most a twentieth of each period."""
    parts = np.empty(period.size, dtype=np.int64)
    for k in range(period.size):
        parts[k] = max(1, math.ceil(dt * STEPS_PER_PERIOD / period[k] - 1e-9))
    return parts


@njit(cache=True, nogil=True)
def recurrence(period: FloatArray, damping: float, h: float) -> FloatArray:
    """What displacement and velocity become over h [s]: of themselves, of the acceleration and its slope [8, k]."""
    found = np.empty((8, period.size))
    for k in range(period.size):
        omega = 2.0 * math.pi / period[k]
        found[0, k], found[4, k] = advance(1.0, 0.0, 0.0, 0.0, h, omega, damping)
        found[1, k], found[5, k] = advance(0.0, 1.0, 0.0, 0.0, h, omega, damping)
        found[2, k], found[6, k] = advance(0.0, 0.0, 1.0, 0.0, h, omega, damping)
        found[3, k], found[7, k] = advance(0.0, 0.0, 0.0, 1.0, h, omega, damping)
    return found


@njit(cache=True, nogil=True, fastmath=FUSED)
def sweep(acceleration: FloatArray, dt: float, parts: int, of: FloatArray, u: FloatArray, v: FloatArray,
          peak: FloatArray) -> None:  # fmt: skip
    """Through the motion with all oscillators [k] side by side, which the compiler does four at a time.

    of : their recurrence [8, k]; u, v : displacement and velocity [k], moved on; peak : largest |u| so far [k], raised
    """
    uu, uv, ua, us, vu, vv, va, vs = of[0], of[1], of[2], of[3], of[4], of[5], of[6], of[7]
    for i in range(acceleration.size - 1):
        slope = (acceleration[i + 1] - acceleration[i]) / dt
        for part in range(parts):
            now = acceleration[i] + slope * (part * (dt / parts))
            for k in range(u.size):
                moved = (uu[k] * u[k] + uv[k] * v[k]) + (ua[k] * now + us[k] * slope)
                v[k] = (vu[k] * u[k] + vv[k] * v[k]) + (va[k] * now + vs[k] * slope)
                u[k] = moved
                peak[k] = max(peak[k], abs(moved))


@njit(cache=True, nogil=True)
def peak_displacements(acceleration: FloatArray, dt: float, period: FloatArray, damping: float) -> FloatArray:
    """Largest |relative displacement| of each oscillator [m], from rest, during the motion and after it.

    acceleration : of the ground, linear between samples, zero after the last [n] [m/s2]
    dt : step [s]; period [k] [s], positive; damping [-], below 1

    Maxima are taken at the samples, each step divided into equal parts where it exceeds a twentieth of the period.
    """
    peaks, parts = np.zeros(period.size), divisions(period, dt)
    for count in np.unique(parts):
        which = np.flatnonzero(parts == count)
        h = dt / count
        of = recurrence(period[which], damping, h)
        u, v, peak = np.zeros(which.size), np.zeros(which.size), np.zeros(which.size)
        sweep(acceleration, dt, count, of, u, v, peak)
        for k in range(which.size):
            for _ in range(math.ceil(period[which[k]] / h)):  # one period of free vibration holds its largest swing
                u[k], v[k] = of[0, k] * u[k] + of[1, k] * v[k], of[4, k] * u[k] + of[5, k] * v[k]
                peak[k] = max(peak[k], abs(u[k]))
        peaks[which] = peak
    return peaks


@njit(cache=True, nogil=True)
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
