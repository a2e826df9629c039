"""The elastic oscillator under piecewise-linear ground acceleration, compiled.

    u'' + 2 damping omega u' + omega^2 u = -a(t)

Between two samples a(t) is a line, so the response there is known in closed form (Nigam & Jennings 1969, BSSA 59,
909-922): the recurrence below has no error of integration, whatever the step.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from records.compilation.kernel import cache_on_disk
from spectra.arrays import FloatArray

FUSED = {"contract", "nnan"}
"""a * b + c in one rounding; no nan comes in, as records hold none."""
VISIT = 2  # steps of one oscillator in a row while its numbers are at hand
BLOCK = 16  # steps whose maximum is looked for together, a multiple of VISIT
NEAR = 1e-5  # [rad] from a maximum, where a parabola is off by its third power


@njit(nogil=True)
def advance(
    u: float, v: float, a: float, slope: float, time: float, omega: float, damping: float
) -> tuple[float, float]:
    """Return displacement [m] and velocity [m/s] after `time` [s] of ground acceleration a + slope t [m/s2]."""
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
def recurrence(period: FloatArray, damping: float, h: float) -> FloatArray:
    """Return the coefficients of a step of h [s] on u, v, the acceleration and its slope, of u then of v [8, k]."""
    found = np.empty((8, period.size))
    for k in range(period.size):
        omega = 2.0 * math.pi / period[k]
        found[0, k], found[4, k] = advance(1.0, 0.0, 0.0, 0.0, h, omega, damping)
        found[1, k], found[5, k] = advance(0.0, 1.0, 0.0, 0.0, h, omega, damping)
        found[2, k], found[6, k] = advance(0.0, 0.0, 1.0, 0.0, h, omega, damping)
        found[3, k], found[7, k] = advance(0.0, 0.0, 0.0, 1.0, h, omega, damping)
    return found


@njit(nogil=True)
def free_part(period: FloatArray, damping: float) -> FloatArray:
    """Return coefficients [4, k] of the free vibration in a step, u(t) + a(t) / omega^2 - 2 damping slope / omega^3.

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
    """Advance all oscillators [k] side by side through some steps; the compiler takes four at a time.

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
def extremum(
    u: float, v: float, a: float, slope: float, low: float, high: float, fraction: float, omega: float, damping: float
) -> float:
    """Return |u| [m] where u' is zero between `low` and `high` [s], where it is monotone and changes its sign.

    By Newton's method, first at a `fraction` of the way, kept within ends that close in; otherwise as `advance`.
    """
    falls = advance(u, v, a, slope, low, omega, damping)[1] > 0.0
    t = low + fraction * (high - low)
    for _ in range(100):
        x, y = advance(u, v, a, slope, t, omega, damping)
        bend = -(a + slope * t) - 2.0 * damping * omega * y - omega * omega * x
        step = -y / bend if bend != 0.0 else high - low
        if abs(step) * omega <= NEAR:
            break
        if (y > 0.0) == falls:
            low = t
        else:
            high = t
        t += step
        if not low < t < high:
            t, step = 0.5 * (low + high), 0.0
    return abs(x + 0.5 * y * step)


@njit(nogil=True)
def largest_within(u: float, v: float, a: float, slope: float, time: float, omega: float, damping: float) -> float:
    """Return the largest |u| [m] during `time` [s], ends included; otherwise as `advance`.

    u'' is a free vibration, as what the ground adds to u is a line. Its zeros are half a turn apart, and from one to
    the next u' is monotone: u has one extremum there if the sign of u' changes, or none.
    """
    omega_d = omega * math.sqrt(1.0 - damping * damping)
    bend = -a - 2.0 * damping * omega * v - omega * omega * u
    change = -slope - 2.0 * damping * omega * bend - omega * omega * v
    turn = math.atan2(-bend, (change + damping * omega * bend) / omega_d)
    if turn <= 0.0:
        turn += math.pi
    largest, begin, before = abs(u), 0.0, v
    while begin < time:
        end = min(turn / omega_d, time)
        x, y = advance(u, v, a, slope, end, omega, damping)
        largest = max(largest, abs(x))
        if before * y < 0.0:
            fraction = before / (before - y)
            largest = max(largest, extremum(u, v, a, slope, begin, end, fraction, omega, damping))
        begin, before, turn = end, y, turn + math.pi
    return largest


@njit(nogil=True)
def turns(v: float, y: float, time: float, omega: float, F: float) -> bool:
    """Return whether u' may be zero during `time` [s], v and y at its ends: it leaves its chord by an arc."""
    return v * y <= 0.0 or min(abs(v), abs(y)) <= (omega * time) ** 2 / 8.0 * omega * F


@njit(nogil=True)
def largest_in(start: FloatArray, slope: FloatArray, dt: float, of: FloatArray, free: FloatArray, u: float, v: float,
               omega: float, damping: float, most: float, held: FloatArray) -> float:  # fmt: skip
    """Return the larger of `most` and |u| [m] of one oscillator within some steps of dt [s], but not at their ends.

    of, free : `recurrence` over a step and `free_part` of the oscillator
    held : the step that may have a larger |u| between its ends, not refined yet, as a later one mostly exceeds it:
    the bound of |u| in it, u and v at its beginning, acceleration and slope there [5]; changed
    """
    arc = (omega * dt) ** 2 / 8.0
    for i in range(start.size):
        a, rise = start[i], slope[i]
        x = (of[0] * u + of[1] * v) + (of[2] * a + of[3] * rise)
        y = (of[4] * u + of[5] * v) + (of[6] * a + of[7] * rise)
        line = free[0] * a + free[1] * rise
        f = u + line
        quarter = free[2] * f + free[3] * (v + free[0] * rise)
        F = math.sqrt(f * f + quarter * quarter)
        if turns(v, y, dt, omega, F):
            static = max(abs(line), abs(line + free[0] * rise * dt))
            bound = min(max(abs(u), abs(x)) + arc * F, static + F)
            if bound > most:
                most = refine_held(held, dt, omega, damping, most)
                held[0], held[1], held[2], held[3], held[4] = bound, u, v, a, rise
        u, v = x, y
    return most


@njit(nogil=True)
def refine_held(held: FloatArray, dt: float, omega: float, damping: float, most: float) -> float:
    """Return the larger of `most` and |u| [m] in the step that is `held`, where its bound is larger."""
    if held[0] > most:
        return max(most, largest_within(held[1], held[2], held[3], held[4], dt, omega, damping))
    return most


@cache_on_disk
@njit(nogil=True)
def peak_displacements(acceleration: FloatArray, dt: float, period: FloatArray, damping: float) -> FloatArray:
    """Return the largest |relative displacement| of each oscillator [m], from rest, during the motion and after it.

    acceleration : of the ground, linear between samples, zero after the last [n] [m/s2]
    dt : step [s]; period [k] [s], positive; damping [-], below 1

    Maxima are those of the closed solution, at samples or between them, and looked for only in steps that could hold
    one. Within a step u is a line, the static displacement under the ground's acceleration and slope, and a free
    vibration f of amplitude F at its beginning; |f| <= F and |f''| <= omega^2 F. So |u| exceeds neither the line's
    largest by more than F, nor the larger of the samples beside it by more than (omega dt)^2 / 8 F, the rise of an arc
    above its chord.
    """
    omega = 2.0 * math.pi / period
    arc = (omega * dt) ** 2 / 8.0
    of, free = recurrence(period, damping, dt), free_part(period, damping)
    still = -(acceleration.size - 1) % BLOCK  # steps of rest before the first, so that blocks are whole
    start, slope = np.zeros(still + acceleration.size - 1), np.zeros(still + acceleration.size - 1)
    start[still:], slope[still:] = acceleration[:-1], (acceleration[1:] - acceleration[:-1]) / dt
    u, v, peak = np.zeros(period.size), np.zeros(period.size), np.zeros(period.size)
    u0, v0, largest, swing = np.empty_like(u), np.empty_like(u), np.empty_like(u), np.empty_like(u)
    held = np.zeros((period.size, 5))
    for i in range(0, start.size, BLOCK):
        a, rise = start[i : i + BLOCK], slope[i : i + BLOCK]
        u0[:], v0[:], largest[:], swing[:] = u, v, np.abs(u), 0.0
        sweep(a, rise, of, free, u, v, largest, swing)
        a_most, rise_most = max(np.max(np.abs(a)), np.max(np.abs(a + rise * dt))), np.max(np.abs(rise))
        for k in range(period.size):
            peak[k] = max(peak[k], largest[k])
            F = math.sqrt(swing[k])
            line = free[0, k] * a_most - free[1, k] * rise_most
            if turns(v0[k], v[k], BLOCK * dt, omega[k], F) and min(largest[k] + arc[k] * F, line + F) > peak[k]:
                peak[k] = largest_in(
                    a, rise, dt, of[:, k], free[:, k], u0[k], v0[k], omega[k], damping, peak[k], held[k]
                )
    for k in range(period.size):  # its largest swing is the first, in the half turn that follows
        half = math.pi / (omega[k] * math.sqrt(1.0 - damping * damping))
        peak[k] = refine_held(held[k], dt, omega[k], damping, peak[k])
        peak[k] = max(peak[k], largest_within(u[k], v[k], 0.0, 0.0, half, omega[k], damping))
    return peak


@cache_on_disk
@njit(nogil=True)
def relative_accelerations(
    acceleration: FloatArray, dt: float, parts: int, period: float, damping: float
) -> FloatArray:
    """Return the relative acceleration u'' [m/s2], from rest, at the samples and `parts` - 1 points between.

    Parameters
    ----------
    acceleration : of the ground, linear between samples [n] [m/s2]
    dt : step [s]
    parts : into which each step is divided
    period : positive [s]
    damping : below 1 [-]

    Returns
    -------
    The acceleration [(n - 1) parts + 1] [m/s2].
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
