"""Closed forms of overturning under one cycle of a sine, linearised: the branches of the envelope.

A = a_p / (g lambda), Omega = 2 pi f_p / p, eta the restitution, the same on both sides. A body at rest lifts at the
phase psi = asin(1 / A); with x = p (t - t_psi), theta = psi + Omega x and y = phi / phi_ov, up to its first impact

    y(x) = 1 + C1 e^x + C2 e^-x - A / (1 + Omega^2) sin(theta)
    C1 = Omega (s - Omega) / (2 (1 + Omega^2)),   C2 = -Omega (s + Omega) / (2 (1 + Omega^2)),   s = sqrt(A^2 - 1)

and once the pulse is over it overturns where y + dy/dx > 1. Each function returns the amplitudes A at which the outcome
changes. All exponentials decay, so that a long pulse (Omega to zero) cannot overflow. Two or more impacts have no
closed form here, so with a strong bounce (restitution near 1) less than `least` can overturn.

Sources: own derivation, tests/validation/rocking_pulses; without impact and half-sine as Zhang & Makris 2001, J. Eng.
Mech. 127, 473-483.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import asin, cos, exp, expm1, isfinite, nan, pi, sin, sqrt

import numpy as np

SCAN = 400
"""Number of amplitudes scanned for a branch that can turn back: a band thinner than a step can be missed."""
BARELY = 1.0 + 1e-9
"""The least amplitude scanned, as a multiple of that of uplift."""


def without_impact(omega: float) -> float:
    """Return branch (a), above which the body overturns on the side to which it first rotates, without impact.

    (s - Omega) exp((2 pi - psi) / Omega) = A; the difference of the two sides grows with A, so there is one root.
    """
    _check(omega)

    def excess(A: float) -> float:
        return sqrt(A * A - 1.0) - omega - A * exp(-(2.0 * pi - asin(1.0 / A)) / omega)

    return _root(excess, 1.0, (2.0 + omega) / -expm1(-1.5 * pi / omega))


def half_sine(omega: float) -> float:
    """Return the least overturning amplitude under half a cycle: (s - Omega) exp((pi - psi) / Omega) + A = 0.

    It is also that of one-sided rocking under a full cycle that begins by pressing on the support.
    """
    _check(omega)

    def excess(A: float) -> float:
        return sqrt(A * A - 1.0) - omega + A * exp(-(pi - asin(1.0 / A)) / omega)

    return _root(excess, 1.0, 1.0 + omega)


def impact_in_pulse(omega: float, restitution: float) -> tuple[float, ...]:
    """Return branch (b), rising: one impact during the pulse, at whose end the body just overturns on the other side.

    (eta |y'_i| - 1 - A (sin theta_i + Omega cos theta_i) / (1 + Omega^2)) exp((2 pi - theta_i) / Omega)
    + A Omega / (1 + Omega^2) = 0, where theta_i is the phase of landing; and no second landing before the end.

    Parameters
    ----------
    omega : Omega, 2 pi f_p over p [-]
    restitution : eta, the same on both sides [-]
    """
    _check(omega, restitution)

    def excess(A: float) -> float:
        theta, speed = _landing(A, omega)
        push = A / (1.0 + omega**2)
        growing = restitution * speed - 1.0 - push * (sin(theta) + omega * cos(theta))
        return growing + push * omega * exp(-(2.0 * pi - theta) / omega)

    highest = last_in_pulse(omega)
    roots = _roots(excess, BARELY + (highest - BARELY) / SCAN, highest)
    return tuple(A for A in roots if _stays_up(A, omega, restitution))


def impact_after_pulse(omega: float, restitution: float) -> tuple[float, ...]:
    """Return branch (c), rising: the body lands after the pulse with just the energy to overturn on the other side.

    y'_e^2 - (1 - y_e)^2 = 1 / eta^2 - 1 at the end of the pulse, where the left side is -4 D+ D-; the body overturns
    where it exceeds the right side. Between `last_in_pulse` and `without_impact`.

    Parameters
    ----------
    omega : Omega, 2 pi f_p over p [-]
    restitution : eta, the same on both sides [-]
    """
    _check(omega, restitution)

    def excess(A: float) -> float:
        rising, falling = _at_end(A, omega)
        return -4.0 * rising * falling - (1.0 / restitution**2 - 1.0)

    return _roots(excess, last_in_pulse(omega), without_impact(omega)) if restitution > 0.0 else ()


def last_in_pulse(omega: float) -> float:
    """Return the amplitude at which the first landing is at the end of the pulse; above it the landing is later."""
    _check(omega)

    def height(A: float) -> float:
        rising, falling = _at_end(A, omega)
        return _bounded(1.0 + rising + falling)

    return _root(height, BARELY, 1.001 * without_impact(omega))


def least_overturning_amplitude(omega: float, restitution: float) -> float:
    """Return the least overturning amplitude with one impact or none."""
    after = tuple(A for A in impact_after_pulse(omega, restitution) if _begins_after(A, omega))
    return min(*impact_in_pulse(omega, restitution), *after, without_impact(omega), float("inf"))


def _begins_after(A: float, omega: float) -> bool:
    """Return whether the energy left at the end of the pulse grows with the amplitude."""
    above, below = (rising * falling for rising, falling in (_at_end(A * s, omega) for s in (1 + 1e-7, 1 - 1e-7)))
    return above < below


def _constants(A: float, omega: float) -> tuple[float, float, float, float]:
    """Return C1, C2, A / (1 + Omega^2) and psi."""
    s, twice = sqrt(A * A - 1.0), 2.0 * (1.0 + omega**2)
    return omega * (s - omega) / twice, -omega * (s + omega) / twice, 2.0 * A / twice, asin(1.0 / A)


def _at_end(A: float, omega: float) -> tuple[float, float]:
    """Return D+ and D- of y = 1 + D+ e^x + D- e^-x after the pulse; D+ is -inf where it overflows."""
    C1, C2, push, psi = _constants(A, omega)
    x = (2.0 * pi - psi) / omega
    grown = C1 * exp(min(x, 700.0))
    return grown - 0.5 * push * omega, C2 * exp(-x) + 0.5 * push * omega


def _landing(A: float, omega: float) -> tuple[float, float]:
    """Return the phase of the first impact, in the pulse [rad], and |dy/dx| before it.

    The body is pushed up until pi - psi and down from there on, so that it lands once: y e^-x changes its sign.
    """
    C1, C2, push, psi = _constants(A, omega)

    def height(theta: float) -> float:
        x = (theta - psi) / omega
        return C1 + exp(-x) * (1.0 + C2 * exp(-x) - push * sin(theta))

    if height(pi - psi) <= 0.0:
        return pi - psi, 0.0  # lifted by less than the rounding error
    theta = _root(height, pi - psi, 2.0 * pi) if height(2.0 * pi) < 0.0 else 2.0 * pi
    x = (theta - psi) / omega
    # where y = 0, C1 e^x is what the rest leaves
    return theta, 1.0 + 2.0 * C2 * exp(-x) - push * (sin(theta) - omega * cos(theta))


def _stays_up(A: float, omega: float, restitution: float) -> bool:
    """Return whether the body does not land again before the end of the pulse: y e^-x keeps its sign."""
    theta, speed = _landing(A, omega)
    push, v = A / (1.0 + omega**2), restitution * speed
    sine, cosine = push * sin(theta), push * cos(theta)
    rising, falling = 0.5 * (v - 1.0 - sine - omega * cosine), 0.5 * (-v - 1.0 - sine + omega * cosine)
    phase = np.linspace(theta, 2.0 * pi, SCAN)[1:]
    shrunk = np.exp(-(phase - theta) / omega)
    return bool(np.all(rising + shrunk * (1.0 + falling * shrunk + push * np.sin(phase)) > 0.0))


def _roots(f: Callable[[float], float], low: float, high: float) -> tuple[float, ...]:
    """Return where f changes its sign between low and high, in rising order."""
    places = (low + (high - low) * np.linspace(1e-9, 1.0 - 1e-9, SCAN)).tolist()
    values = [f(place) for place in places]
    pairs = zip(pairwise(places), pairwise(values), strict=True)
    return tuple(_root(f, a, b) for (a, b), (fa, fb) in pairs if fa * fb < 0.0)


def _root(f: Callable[[float], float], low: float, high: float) -> float:
    from scipy.optimize import brentq

    return float(brentq(f, low, high, xtol=1e-14, rtol=8.9e-16, maxiter=200))


def _bounded(value: float) -> float:
    return max(min(value, 1e300), -1e300)


def _check(omega: float, restitution: float = nan) -> None:
    """Raise ValueError for an impossible frequency ratio or restitution."""
    if not (isfinite(omega) and omega > 0.0):
        raise ValueError(f"Omega = {omega}: give a positive ratio of the pulse's circular frequency to p")
    if restitution == restitution and not 0.0 <= restitution <= 1.0:
        raise ValueError(f"restitution = {restitution}: give a number between 0 and 1")
