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
def peak_displacements(acceleration: FloatArray, dt: float, period: FloatArray, damping: float) -> FloatArray:
    """Largest |relative displacement| of each oscillator [m], from rest, during the motion and after it.

    acceleration : of the ground, linear between samples, zero after the last [n] [m/s2]
    dt : step [s]; period [k] [s], positive; damping [-], below 1

    Maxima are taken at the samples, each step divided into equal parts where it exceeds a twentieth of the period.
    """
    peaks = np.zeros(period.size)
    for k in range(period.size):
        omega = 2.0 * math.pi / period[k]
        parts = max(1, math.ceil(dt * STEPS_PER_PERIOD / period[k] - 1e-9))
        h = dt / parts
        uu, vu = advance(1.0, 0.0, 0.0, 0.0, h, omega, damping)
        uv, vv = advance(0.0, 1.0, 0.0, 0.0, h, omega, damping)
        ua, va = advance(0.0, 0.0, 1.0, 0.0, h, omega, damping)
        us, vs = advance(0.0, 0.0, 0.0, 1.0, h, omega, damping)
        u, v, peak = 0.0, 0.0, 0.0
        for i in range(acceleration.size - 1):
            a, slope = acceleration[i], (acceleration[i + 1] - acceleration[i]) / dt
            for part in range(parts):
                now = a + slope * (part * h)
                u, v = uu * u + uv * v + ua * now + us * slope, vu * u + vv * v + va * now + vs * slope
                peak = max(peak, abs(u))
        for _ in range(math.ceil(period[k] / h)):  # one period of free vibration holds its largest swing
            u, v = uu * u + uv * v, vu * u + vv * v
            peak = max(peak, abs(u))
        peaks[k] = peak
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
