"""ASCE/SEI 43-05, Appendix A.1: formulas of the sliding of an unanchored rigid body. One function for each.

    mu_e = mu (1 - 0.4 A_v / g)      c_s = 2 mu_e g      delta_s = c_s / (2 pi f_es)^2            (A-1, A-2, A-3)

f_es is the lowest frequency at which the horizontal spectrum of 10 % damping reaches c_s. Not checked against the
printed standard: A-3 is from memory.
"""

from __future__ import annotations

from math import pi

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.context import Context

DAMPING = 0.1
SHORTEST, MOST = 0.01, 1e4  # s: periods between which the spectrum is looked at
HIGHEST, HALVINGS = 100.0 * g, 60  # PGA [m/s2] up to which its capacity is looked for, and how finely


def effective_friction(mu: float, *, vertical: float) -> float:
    """Return mu_e = mu (1 - 0.4 A_v / g), not below 0 (A-1).

    Parameters
    ----------
    mu : coefficient of friction [-]
    vertical : peak vertical acceleration A_v [m/s2]

    Returns
    -------
    float
        mu_e [-].
    """
    return max(mu * (1.0 - 0.4 * vertical / g), 0.0)


def friction_of_all(mu: float, *, normal: float, mass: float) -> float:
    """Return mu N / (M g), the friction over the weight of all that slides.

    Parameters
    ----------
    mu : coefficient of friction [-]
    normal : N that presses on the base at rest [N]
    mass : M of all that slides [kg]

    Returns
    -------
    float [-]
    """
    return mu * normal / (mass * g)


def sliding_coefficient(friction: float) -> float:
    """Return c_s = 2 mu_e g [m/s2] of an effective friction [-] (A-2)."""
    return 2.0 * friction * g


def sliding_distance(coefficient: float, *, frequency: float) -> float:
    """Return delta_s = c_s / (2 pi f_es)^2 (A-3).

    Parameters
    ----------
    coefficient : c_s [m/s2]
    frequency : f_es [Hz]

    Returns
    -------
    float [m]
    """
    return coefficient / (2.0 * pi * frequency) ** 2


def longest_period(context: Context, level: float, coefficient: float) -> float | None:
    """Return the longest period at which the spectrum reaches c_s, 1 / f_es.

    Parameters
    ----------
    context : its spectrum is scaled to `level`
    level : PGA [m/s2]
    coefficient : c_s [m/s2]

    Returns
    -------
    float or None
        Period [s]; 0 where no ordinate reaches c_s, None where the spectrum ends before it falls below c_s.
    """
    spectrum, scale = context.spectrum, level / context.spectrum.pga

    def excess(period: float) -> float:
        return scale * float(spectrum.acceleration(period, damping=DAMPING)) - coefficient

    periods = np.geomspace(SHORTEST, min(spectrum.longest_period, MOST), 400)
    above = np.flatnonzero(scale * spectrum.acceleration(periods, damping=DAMPING) >= coefficient)
    if not above.size:
        return 0.0
    last = int(above[-1])
    return None if last == periods.size - 1 else float(brentq(excess, periods[last], periods[last + 1], xtol=1e-12))


def best_estimate(context: Context, level: float, mu: float) -> float | None:
    """Return the best estimate of sliding, delta_s.

    Parameters
    ----------
    context : spectrum and vertical motion
    level : PGA [m/s2]
    mu : coefficient of friction [-]

    Returns
    -------
    float or None
        delta_s [m], 0 without sliding; None where the spectrum ends too early, or without friction.
    """
    c_s = sliding_coefficient(effective_friction(mu, vertical=context.vertical_ratio * level))
    period = longest_period(context, level, c_s) if c_s > 0.0 else None
    if period is None:
        return None
    return sliding_distance(c_s, frequency=1.0 / period) if period > 0.0 else 0.0


def pga_at(context: Context, mu: float, allowable: float) -> float | None:
    """Return the largest PGA whose sliding stays within the allowable one.

    Found by bisection, as more shaking never slides less.

    Parameters
    ----------
    context : spectrum and vertical motion
    mu : coefficient of friction [-]
    allowable : delta_s allowed [m]

    Returns
    -------
    float or None
        PGA [m/s2]; None where the spectrum ends too early to tell.
    """
    low, high = 0.0, HIGHEST
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        found = best_estimate(context, middle, mu)
        low, high = (middle, high) if found is not None and found <= allowable else (low, middle)
    return None if best_estimate(context, high, mu) is None else low
