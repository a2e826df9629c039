"""Closed forms of our own: pulses that fall straight to zero, a lognormal thickness, sliding, and annual rates."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import cosh, exp, hypot, log, pi, sin, sinh, sqrt
from statistics import NormalDist

import numpy as np
from scipy.constants import g
from scipy.integrate import solve_ivp

Values = Mapping[str, Mapping[str, float]]
P, ALPHA = 2.0, 0.2
TRIANGLES = {"short": (0.8, 0.10), "middle": (0.75, 0.16), "long": (0.7, 0.20)}
"""Amplitude [g] and duration [s]."""
FC = 1.35
z = NormalDist().inv_cdf


def turning(amplitude: float, duration: float) -> float:
    """The rotation at which a block turns back that the end of the pulse leaves still tilting, over α."""
    slope = -amplitude / duration
    c, d = amplitude - ALPHA, slope / P
    u = c * cosh(P * duration) + d * sinh(P * duration)
    v = -slope + P * (c * sinh(P * duration) + d * cosh(P * duration))
    assert v > 0.0
    return (ALPHA - sqrt(u * u - (v / P) ** 2)) / ALPHA


def at_height(amplitude: float, duration: float) -> float:
    """The factor √((S_a/a_g h/h_e)² + 1) with h/h_e = 0.5 and S_a at 10 Hz, 5 % of damping, during the pulse."""
    w = 2.0 * pi * 10.0

    def moved(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -0.1 * w * y[1] - w * w * y[0] - (1.0 - t / duration)]

    found = solve_ivp(moved, (0.0, duration), [0.0, 0.0], "DOP853", rtol=1e-12, atol=1e-16, dense_output=True)
    largest = np.abs(found.sol(np.linspace(0.0, duration, 100_001))[0]).max()
    return hypot(w * w * largest * 0.5, 1.0)


def triangles() -> Values:
    plain = {name: turning(*each) for name, each in TRIANGLES.items()}
    raised = {name: turning(at_height(*each) * each[0], each[1]) for name, each in TRIANGLES.items()}
    largest = max(turning(FC * a, duration) for a, duration in TRIANGLES.values())
    moved = (sin(ALPHA) - sin(ALPHA - largest * ALPHA)) / sin(ALPHA)
    return {
        "largest φ/α": plain,
        "largest φ/α at height": raised,
        "largest φ/α at height, relative motion": raised,
        "ASCE 43-05: mean of φ/φ_u over 0.5": {"": sum(plain.values()) / 3 / 0.5},
        "largest d* over d0*, at FC = 1.35": {"ntc2018-history": moved, "dmi2008-history": moved},
        "largest d* over 0.4 d0*, at FC = 1.35": {"ntc2018-history": moved / 0.4, "dmi2008-history": moved / 0.4},
    }


def uncertain() -> Values:
    at_mean, c = 0.261 * (1.4 - 0.4 * 2.364 * 0.261) * FC / (2.0 * 0.1), 0.1
    beta = sqrt(log(1.0 + c * c))
    quantiles = [at_mean * sqrt(1.0 + c * c) * exp(beta * z(q)) for q in (0.05, 0.16, 0.5, 0.84, 0.95)]
    return {
        "ratio with all numbers at their means": {"": at_mean},
        "quantiles of the ratio: 5, 16, 50, 84, 95 %": {str(i): each for i, each in enumerate(quantiles)},
        "rank correlation with the thickness": {"": -1.0},
        "ratio as the thickness alone is varied by a fifth": {
            "at_low": at_mean / 0.8, "at_base": at_mean, "at_high": at_mean / 1.2
        },
    }  # fmt: skip


def sliding() -> Values:
    c_s = 2.0 * 0.2 * g
    T = 0.35 * g * 2.5 * sqrt(10.0 / 15.0) * 0.4 / c_s
    distance = c_s * (T / (2.0 * pi)) ** 2
    return {
        "least PGA that slides it": {"": 0.2},
        "friction needed over that there is": {"": 0.35 / 0.2},
        "ASCE 43-05, A.1": {"c_s": c_s, "f_es": 1.0 / T, "δ_s": distance},
        "PGA that slides it by 0.05 m": {"": 0.35 * sqrt(0.05 / distance)},
    }


def rates() -> Values:
    curves = {"facade": (0.40, 0.45, 2.5), "wall": (0.15, 0.30, 1.8), "tower": (1.2, 0.6, 3.0)}
    plain = {name: 2e-5 * m**-k * exp(0.5 * (k * b) ** 2) for name, (m, b, k) in curves.items()}
    widened = {name: plain[name] * exp(0.5 * (0.3 * k) ** 2) for name, (_, _, k) in curves.items()}
    stripes = {"two": (0.2, 0.5, 3 / 20, 14 / 20), "half": (0.1, 0.3, 2 / 10, 5 / 10)}
    beta = {name: log(x2 / x1) / (z(p2) - z(p1)) for name, (x1, x2, p1, p2) in stripes.items()}
    share, n, normal = 3 / 20, 20, z(0.975)
    middle = (share + normal**2 / (2 * n)) / (1 + normal**2 / n)
    half = normal * sqrt(share * (1 - share) / n + normal**2 / (4 * n * n)) / (1 + normal**2 / n)
    return {
        "median": {name: exp(log(x1) - beta[name] * z(p1)) for name, (x1, _, p1, _) in stripes.items()},
        "β": beta,
        "Wilson's interval of 3 in 20": {"low": middle - half, "high": middle + half},
        "annual rate": {**plain, "counted": counted()},
        "annual rate, widened": widened,
        "probability in 50 years": {name: 1.0 - exp(-50.0 * each) for name, each in plain.items()},
    }


def counted() -> float:
    """∫ P |dλ| by parts, P straight in ln x between its points and λ = 1e-4/x², from 0.01 to 10."""
    x, share = (0.2, 0.3, 0.4, 0.6, 0.8), (0.0, 0.3, 0.2, 0.7, 0.9)
    level = [1e-4 / each**2 for each in x]
    total = share[-1] * (level[-1] - 1e-6)
    for i in range(4):
        slope = (share[i + 1] - share[i]) / log(x[i + 1] / x[i])
        total += share[i] * level[i] - share[i + 1] * level[i + 1] + 0.5 * slope * (level[i] - level[i + 1])
    return total


VALUES: Mapping[str, Callable[[], Values]] = {
    "own_arithmetic/triangles": triangles,
    "own_arithmetic/uncertain": uncertain,
    "own_arithmetic/sliding": sliding,
    "cornell_2002/rates": rates,
}
