"""Zhang and Makris 2001: the equation for overturning without impact, and amplitudes by integration with DOP853."""

from __future__ import annotations

from math import asin, exp, pi, sqrt, tan

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from tests.validation.derive.rocking import overturning_amplitude, rocked

P, ETA = 2.0, 0.9


def falls(A: float, omega: float, *, alpha: float, linearised: bool) -> bool:
    """Whether one sine of amplitude A = a_p / (g alpha) (linearised) or a_p / (g tan alpha) overturns the block."""
    w = omega * P
    peak = A * g * (alpha if linearised else tan(alpha))
    breaks = np.array([0.0, pi / w, 2 * pi / w])
    motion = lambda t: peak * np.sin(w * t)  # noqa: E731
    return rocked(motion, breaks, p=P, alpha=alpha, restitution=ETA, linearised=linearised)[2]


def half_sine():
    """s = 1 / A: (omega / p) s = sqrt(1 - s^2) + exp(-(p / omega) (pi - asin s)), the paper's equation."""

    def excess(s: float, o: float) -> float:
        return sqrt(1 - s * s) + exp(-(pi - asin(s)) / o) - o * s

    frequencies = (0.5, 1.0, 2.0, 3.0, 4.0, 6.0)
    return {"A, by Ω": {f"{o:g}": 1 / brentq(excess, 1e-9, 1.0, args=(o,), xtol=1e-16) for o in frequencies}}


def one_sine():
    """(sqrt(A^2 - 1) - O) exp((2 pi - asin(1 / A)) / O) = A: no impact, two halves of a sine."""
    return {
        "A, by Ω": {
            f"{o:g}": brentq(
                lambda A, o=o: sqrt(A * A - 1) - o - A * exp(-(2 * pi - asin(1 / A)) / o), 1 + 1e-12, 60.0, xtol=1e-15
            )
            for o in (0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)
        }
    }


WINDOWS = {2.0: (1.20, 1.25, 2.30, 2.3495), 3.0: (1.38, 1.42, 3.40, 3.60), 4.0: (1.78, 1.81, 4.80, 4.90),
           5.0: (2.90, 3.05, 6.20, 6.40), 6.0: (5.10, 5.20, 7.60, 7.75)}  # fmt: skip
"""Omega: windows of A in which overturning after one impact begins and ends, restitution 0.9."""


def with_impact():
    """The two edges of the band in which the block overturns after one impact."""
    found: dict[str, dict[str, float]] = {"A at which the band begins, by Ω": {}, "A at which the band ends, by Ω": {}}
    for omega, (a, b, c, d) in WINDOWS.items():
        run = lambda A, omega=omega: falls(A, omega, alpha=0.2, linearised=True)  # noqa: E731
        first, last = found.values()
        first[f"{omega:g}"] = overturning_amplitude(run, a, b, steps=36)
        last[f"{omega:g}"] = overturning_amplitude(run, c, d, steps=36)
    return found


EXACT = {"1": (1.10, 1.14), "2": (1.20, 1.24), "4": (1.78, 1.82), "6": (4.90, 4.95)}


def exact():
    """The least A of the exact block of slenderness 0.2."""
    return {
        "least A, by Ω": {
            row: overturning_amplitude(
                lambda A, row=row: falls(A, float(row), alpha=0.2, linearised=False), *window, steps=30
            )
            for row, window in EXACT.items()
        }
    }


VALUES = {
    "zhang_makris_2001/half_sine": half_sine,
    "zhang_makris_2001/one_sine": one_sine,
    "zhang_makris_2001/with_impact": with_impact,
    "zhang_makris_2001/exact_block": exact,
}
