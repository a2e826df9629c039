"""An elastic oscillator under one acceleration pulse of a full sine: largest responses over the pulse's frequency.

    u'' + 2 xi w u' + w^2 u = -sin(w_p t)  while t <= 1 / f_p, and 0 after

The steady part is a sine and a cosine of the pulse's frequency, the transient part decays with the oscillator's own:
both are in closed form, during the pulse and after it. The largest value is found on points and by a parabola through
the largest point and its neighbours.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray

Quantity = Callable[[FloatArray, FloatArray, FloatArray], FloatArray]

POINTS = 400  # in a period of the pulse or of the oscillator, whichever is shorter


def largest_relative(ratio: ArrayLike, *, damping: float = 0.05) -> FloatArray:
    """Return the largest |u''|, relative to the ground, over the pulse's amplitude (thesis 3.4.1.1, as worded).

    Parameters
    ----------
    ratio : f_p / f_n [n] [-]
    damping : [-]

    Returns
    -------
    array [n] [-]
    """
    return _largest(ratio, lambda pulse, u, v: _relative(pulse, u, v, damping), damping=damping)


def largest_pseudo(ratio: ArrayLike, *, damping: float = 0.05) -> FloatArray:
    """Return the largest w^2 |u|, the pseudo-acceleration S_a, over the pulse's amplitude (thesis 3.4.1.2).

    The scaled envelopes of 8.3.1 turn out to use it.

    Parameters
    ----------
    ratio : f_p / f_n [n] [-]
    damping : [-]

    Returns
    -------
    array [n] [-]
    """
    return _largest(ratio, lambda pulse, u, v: u, damping=damping)


def largest_total(ratio: ArrayLike, *, shape: float, damping: float = 0.05) -> FloatArray:
    """Return the largest |a_g + shape u''| over the pulse's amplitude.

    Parameters
    ----------
    ratio : f_p / f_n [n] [-]
    shape : of the first mode times its participation factor, 1 at the effective height, 0 at the ground [-]
    damping : [-]

    Returns
    -------
    array [n] [-]
    """
    return _largest(ratio, lambda pulse, u, v: pulse + shape * _relative(pulse, u, v, damping), damping=damping)


def _largest(ratio: ArrayLike, quantity: Quantity, *, damping: float) -> FloatArray:
    r = np.asarray(ratio, dtype=np.float64)
    bad = r[~(np.isfinite(r) & (r > 0.0))]
    if bad.size:
        raise ValueError(f"pulse frequency over natural frequency {bad.flat[0]}; it must be positive and finite")
    if not 0.0 < damping < 1.0:
        raise ValueError(f"damping ratio {damping}; it must lie between 0 and 1")
    found = [max(_peak(quantity(*part)) for part in _responses(float(each), damping)) for each in r.ravel()]
    return np.array(found).reshape(r.shape)


def _responses(r: float, damping: float) -> tuple[tuple[FloatArray, FloatArray, FloatArray], ...]:
    """Return a_g, u and u' during the pulse, and for two periods after; time in units of 1 / w, so w_p = r."""
    during = np.linspace(0.0, 2.0 * np.pi / r, int(np.ceil(POINTS * max(1.0, 1.0 / r))) + 1)
    after = np.linspace(0.0, 4.0 * np.pi, 2 * POINTS + 1)
    u, v = _forced(during, r, damping)
    return (np.sin(r * during), u, v), (np.zeros(after.size), *_free(after, u[-1], v[-1], damping))


def _relative(pulse: FloatArray, u: FloatArray, v: FloatArray, damping: float) -> FloatArray:
    """Return u'', by the equation of motion."""
    return -pulse - 2.0 * damping * v - u


def _forced(t: FloatArray, r: float, damping: float) -> tuple[FloatArray, FloatArray]:
    """Return u and u' from rest under -sin(r t): the steady motion, and the free vibration that cancels its start."""
    D = (1.0 - r**2) ** 2 + (2.0 * damping * r) ** 2
    S, C = -(1.0 - r**2) / D, 2.0 * damping * r / D
    u, v = _free(t, -C, -S * r, damping)
    return u + S * np.sin(r * t) + C * np.cos(r * t), v + r * (S * np.cos(r * t) - C * np.sin(r * t))


def _free(t: FloatArray, u: float, v: float, damping: float) -> tuple[FloatArray, FloatArray]:
    """Return the free vibration u and u' from u, v at t = 0."""
    w_d = np.sqrt(1.0 - damping**2)
    decay, cosine, sine = np.exp(-damping * t), np.cos(w_d * t), np.sin(w_d * t) / w_d
    return decay * (u * cosine + (v + damping * u) * sine), decay * (v * cosine - (u + damping * v) * sine)


def _peak(values: FloatArray) -> float:
    """Return the largest |value| of a smooth curve: the top of the parabola through its largest point."""
    size = np.abs(values)
    at = int(np.argmax(size))
    if not 0 < at < size.size - 1:
        return float(size[at])
    before, top, after = size[at - 1 : at + 2]
    bend = 2.0 * top - before - after
    return float(top if bend <= 0.0 else top + (after - before) ** 2 / (8.0 * bend))
