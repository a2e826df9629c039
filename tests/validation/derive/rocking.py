"""Independent integration of a plain rocking block: scipy's DOP853 between impacts found as events."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from scipy.constants import g
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

FAR = 6.0
"""|theta| / alpha from which the block is lost, for good at the accelerations here."""


def rocked(
    acceleration: Callable[[float], float],
    breaks: np.ndarray,
    *,
    p: float,
    alpha: float,
    restitution: float,
    linearised: bool = False,
    rtol: float = 1e-11,
) -> tuple[float, int, bool]:
    """Return the largest |theta| / alpha, the impacts, and whether the block overturns.

    Parameters
    ----------
    acceleration : of the ground [m/s2], smooth between `breaks`
    breaks : times, the first the start; after the last the ground is still [s]
    p, alpha, restitution : of the block; linearised : sines and cosines of small angles
    """

    def rate(t: float, y: np.ndarray, side: float, ground: Callable[[float], float]) -> list[float]:
        theta, a = y[0], ground(t) / g
        if linearised:
            return [y[1], p**2 * (theta - side * alpha - a)]
        return [y[1], -(p**2) * (np.sin(side * alpha - theta) + a * np.cos(side * alpha - theta))]

    lift = alpha if linearised else np.tan(alpha)
    largest, impacts, theta, omega, side = 0.0, 0, 0.0, 0.0, 0.0
    intervals = [(a, b, acceleration) for a, b in pairwise(breaks)]
    intervals.append((breaks[-1], breaks[-1] + 60.0 / p, lambda t: 0.0))
    for start, end, ground in intervals:
        t = start
        while t < end:
            if side == 0.0:  # at rest: until the ground lifts it
                t = _lifted(ground, t, end, lift)
                if t >= end:
                    break
                side = -np.sign(ground(t if abs(ground(t)) > lift * g * (1 - 1e-12) else end))
            landing = lambda t, y, side=side: side * y[0] if t > 0 else 1.0  # noqa: E731
            landing.terminal, landing.direction = True, -1.0
            lost = lambda t, y: abs(y[0]) - FAR * alpha  # noqa: E731
            lost.terminal = True
            top = lambda t, y: y[1]  # noqa: E731
            out = solve_ivp(
                lambda t, y, side=side, ground=ground: rate(t, y, side, ground), (t, end), [theta, omega],
                method="DOP853", rtol=rtol, atol=1e-14, events=(landing, lost, top),
            )  # fmt: skip
            tops = out.y_events[2]
            seen = np.abs(np.concatenate([[out.y[0, 0], out.y[0, -1]], tops[:, 0] if tops.size else []]))
            largest = max(largest, float(seen.max()) / alpha)
            if out.t_events[1].size:
                return largest, impacts, True
            t, (theta, omega) = float(out.t[-1]), out.y[:, -1]
            if out.t_events[0].size:
                impacts, theta, omega, side = impacts + 1, 0.0, restitution * omega, -side
                if abs(omega) < 1e-9 * p:
                    omega, side = 0.0, 0.0
                    if ground is intervals[-1][2]:
                        return largest, impacts, False
                if ground is intervals[-1][2]:  # free: what it has left decides
                    energy = 0.5 * omega**2
                    barrier = p**2 * (alpha**2 / 2 if linearised else 1 - np.cos(alpha))
                    if energy < barrier:
                        swing = alpha - (
                            np.sqrt(alpha**2 - omega**2 / p**2)
                            if linearised
                            else np.arccos(np.cos(alpha) + energy / p**2)
                        )
                        return max(largest, float(swing) / alpha), impacts, False
    return largest, impacts, False


def _lifted(ground: Callable[[float], float], t: float, end: float, lift: float) -> float:
    """Return when |ground| first reaches the acceleration of uplift, or the end."""
    if abs(ground(t)) >= lift * g:
        return t
    times = np.linspace(t, end, 2001)
    above = np.flatnonzero([abs(ground(x)) > lift * g for x in times])
    if not above.size:
        return end
    k = int(above[0])
    return float(brentq(lambda x: abs(ground(x)) - lift * g, times[k - 1], times[k], xtol=1e-15))


def overturning_amplitude(run: Callable[[float], bool], low: float, high: float, *, steps: int = 44) -> float:
    """Bisect for the amplitude at which `run` (overturned?) changes between low and high."""
    below = run(low)
    assert below != run(high)
    for _ in range(steps):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if run(middle) == below else (low, middle)
    return 0.5 * (low + high)
