"""Rocking as scipy integrates it: the sides of a body, by formulas or by evaluating its splines, and their events."""

from __future__ import annotations

import math
from bisect import bisect
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.dynamics.kernel.events import REST
from assess.oscillator import Branch, interpolant

Event = Callable[[float, np.ndarray], float]


@dataclass(frozen=True)
class Side:
    """One side: its acceleration(phi, v, ground in its own sign) and what its events need."""

    acceleration: Callable[[float, float, float], float]
    threshold: float
    unstable: float
    end: float
    restitution: float
    slow: float


def exact_side(p: float, alpha: float, restitution: float) -> Side:
    """Return a block by its closed formulas, not by tables."""
    rate = math.sqrt(2 * p**2 * (1 - math.cos(alpha))) / alpha  # velocity that reaches alpha, over alpha
    return Side(
        lambda phi, v, a: -(p**2) * (math.sin(alpha - phi) + a / g * math.cos(alpha - phi)),
        g * math.tan(alpha), alpha, 1.5 * alpha, restitution, REST * rate * alpha,
    )  # fmt: skip


def linearised_side(branch: Branch, *, end: float = 1e9) -> Side:
    """Return a branch by its linearised constants, which has overturned at the rotation `end`."""
    form = branch.linearised
    p, phi_ov, gain = form.p, form.overturning, form.excitation / form.inertia
    return Side(
        lambda phi, v, a: p**2 * (phi - phi_ov) - gain * a,
        g * form.multiplier, phi_ov, end, form.restitution, REST * p * phi_ov,
    )  # fmt: skip


def table_side(branch: Branch) -> Side:
    """Return any branch by the cubics of its table, evaluated one number at a time."""
    moment = interpolant(branch.rotation, branch.restoring)
    slow = REST * math.sqrt(2 * float(moment.antiderivative()(branch.unstable)) / branch.inertia[0])
    threshold = float(branch.restoring[0] / branch.excitation[0])
    end = float(branch.rotation[-1])
    return Side(_acceleration(branch), threshold, branch.unstable, end, branch.restitution, slow)


def _acceleration(branch: Branch) -> Callable[[float, float, float], float]:
    nodes, left = branch.rotation[1:-1].tolist(), branch.rotation[:-1].tolist()
    rows = [interpolant(branch.rotation, v).c.T for v in (branch.inertia, branch.restoring, branch.excitation)]
    cubics = np.concatenate(rows, axis=1).tolist()

    def acceleration(phi: float, v: float, a: float) -> float:
        i = bisect(nodes, phi)
        d = phi - left[i]
        i3, i2, i1, i0, r3, r2, r1, r0, b3, b2, b1, b0 = cubics[i]
        bend = 0.5 * ((3 * i3 * d + 2 * i2) * d + i1) * v**2
        moment, excitation = ((r3 * d + r2) * d + r1) * d + r0, ((b3 * d + b2) * d + b1) * d + b0
        return float(-(moment + excitation * a + bend) / (((i3 * d + i2) * d + i1) * d + i0))

    return acceleration


def event(column: int, level: float = 0.0, *, direction: int, terminal: bool = False) -> Event:
    """Return the event that a column of the state crosses a level upwards, 1, or downwards, -1."""

    def crossing(_: float, state: np.ndarray) -> float:
        return float(state[column]) - level

    crossing.direction, crossing.terminal = direction, terminal  # type: ignore[attr-defined]
    return crossing
