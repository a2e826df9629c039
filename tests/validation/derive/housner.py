"""Housner 1963: closed forms of free rocking and of a rectangular pulse, and quadrature of the exact energy."""

from __future__ import annotations

from math import acosh, atan, exp, hypot, sin, sqrt, tan

from scipy.constants import g
from scipy.integrate import quad

THICKNESS, HEIGHT = 0.8, 4.0  # of the stocky block whose exact equation is integrated
BLOCKS = {"slender": (0.2, 4.0), "wall": (0.6, 6.0), "stocky": (1.0, 2.0)}


def free_rocking():
    """p T = 4 acosh(1 / (1 - theta_0 / alpha)) of the linearised block without loss."""
    return {"p T, by θ0/α": {f"{r:g}": 4 * acosh(1 / (1 - r)) for r in (0.1, 0.5, 0.9)}}


def decay():
    """theta_n / alpha = 1 - sqrt(1 - r^n (1 - (1 - theta_0 / alpha)^2)), r = restitution^2, theta_0 = 0.6 alpha."""
    return {"θn/α, by n": {str(n): 1 - sqrt(1 - 0.9 ** (2 * n) * (1 - 0.4**2)) for n in range(1, 11)}}


def exact_fall():
    """p t = int d psi / sqrt(2 (cos psi_0 - cos psi)) from psi_0 = alpha - theta_0 to alpha, with psi = psi_0 + u^2."""
    alpha = atan(THICKNESS / HEIGHT)
    found = {}
    for r in (0.1, 0.5, 0.9):
        first = (1 - r) * alpha

        def integrand(u: float, first: float = first) -> float:
            # cos a - cos(a + u^2) = 2 sin(a + u^2 / 2) sin(u^2 / 2)
            half = u * u / 2
            return 2.0 / sqrt(4.0 * sin(first + half) * (sin(half) / u**2 if u > 0.0 else 0.5))

        found[f"{r:g}"] = quad(integrand, 0.0, sqrt(r * alpha), epsabs=1e-13, epsrel=1e-13)[0]
    return {"p t to the first impact, by θ0/α": found}


def blocks():
    """p^2 = 3 g / 4 R, tan alpha = b / h, restitution 1 - 1.5 sin^2 alpha, uplift at g tan alpha."""
    geometry = {name: (hypot(b, h) / 2, atan(b / h)) for name, (b, h) in BLOCKS.items()}
    return {
        "p": {name: sqrt(3 * g / (4 * R)) for name, (R, _) in geometry.items()},
        "α": {name: alpha for name, (_, alpha) in geometry.items()},
        "uplift acceleration over g": {name: tan(alpha) for name, (_, alpha) in geometry.items()},
        "η": {name: 1 - 1.5 * sin(alpha) ** 2 for name, (_, alpha) in geometry.items()},
    }


def rectangular_pulse():
    """A / (alpha g) = 1 / (1 - exp(-p t_1)), p t_1 = 1: a little below it stands, a little above it overturns."""
    assert abs(1 / (1 - exp(-1.0)) - 1.5819767) < 1e-7
    return {"overturned": {"below": 0.0, "above": 1.0}}


VALUES = {
    "housner_1963/free_rocking": free_rocking,
    "housner_1963/decay": decay,
    "housner_1963/exact_fall": exact_fall,
    "housner_1963/blocks": blocks,
    "housner_1963/rectangular_pulse": rectangular_pulse,
}
