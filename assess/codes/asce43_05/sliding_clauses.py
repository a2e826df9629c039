"""ASCE/SEI 43-05, Appendix A.1: formulas of the sliding of an unanchored rigid body."""

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
    """mu_e [-] with a peak vertical acceleration [m/s2], not below 0 (A-1)."""
    return max(mu * (1.0 - 0.4 * vertical / g), 0.0)


def friction_of_all(mu: float, *, normal: float, mass: float) -> float:
    """mu N / (M g) [-]: N that presses on the base at rest [N], M all mass that slides [kg]."""
    return mu * normal / (mass * g)


def sliding_coefficient(friction: float) -> float:
    """c_s [m/s2] of an effective friction [-] (A-2)."""
    return 2.0 * friction * g


def sliding_distance(coefficient: float, *, frequency: float) -> float:
    """delta_s [m] (A-3)."""
    return coefficient / (2.0 * pi * frequency) ** 2


def longest_period(context: Context, level: float, coefficient: float) -> float | None:
    """The longest period [s] at which the spectrum of a level [m/s2] reaches c_s [m/s2]; 0 where none does.

    None where the spectrum ends before it falls below c_s.
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
    """delta_s [m] at a level [m/s2], 0 without sliding; None where the spectrum ends too early, or without friction."""
    c_s = sliding_coefficient(effective_friction(mu, vertical=context.vertical_ratio * level))
    period = longest_period(context, level, c_s) if c_s > 0.0 else None
    if period is None:
        return None
    return sliding_distance(c_s, frequency=1.0 / period) if period > 0.0 else 0.0


def pga_at(context: Context, mu: float, allowable: float) -> float | None:
    """The largest PGA [m/s2] whose sliding stays within the allowable [m]; None where the spectrum does not tell.

    More shaking never slides less, so halving finds it.
    """
    low, high = 0.0, HIGHEST
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        found = best_estimate(context, middle, mu)
        low, high = (middle, high) if found is not None and found <= allowable else (low, middle)
    return None if best_estimate(context, high, mu) is None else low
