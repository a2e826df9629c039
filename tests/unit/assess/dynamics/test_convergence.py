"""Orders of convergence of the exact equation's steps, of its tables, and of the pieces of a pulse.

A step takes y to the fifth power of time and corrects by what y'' lacks at the end. With y6, y7 for the derivatives,
the lack is y6 h^4 / 24 + y7 h^5 / 120; a thirtieth of it times h^2 completes y to the sixth power, a fifth of it times
h completes y' to the fifth of its own, and leaves y7 h^6 (1 / 600 - 1 / 720). So one step errs by h^7 in y and h^6 in
y', and many steps over a time err by h^5.

On joints a step follows Hermite's quintic through y'' and its first two derivatives at both ends, whose integral errs
by h^7, and many steps by h^6.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics import pulses
from assess.dynamics.history import trace
from assess.oscillator import Oscillator
from records.pulses import PULSE_SHAPES
from records.record import make_record
from tests.support.blocks import block, branch

P, ALPHA, UNCHECKED = 2.0, 0.2, 1e300
"""UNCHECKED: a tolerance that every step meets, so that the record's interval is the step."""


def moment(phi: float) -> float:
    """A cubic near g sin(alpha - phi): four nodes hold it, whatever the spline."""
    return g * ((ALPHA - phi) - (ALPHA - phi) ** 3 / 6)


def arm(phi: float) -> float:
    return 1.0 - (ALPHA - phi) ** 2 / 2


PHI = np.linspace(0.0, 1.5 * ALPHA, 4)
SIDE = replace(
    branch(P, ALPHA, nodes=4), restoring=np.array([*map(moment, PHI)]), excitation=np.array([*map(arm, PHI)])
)
CUBIC = Oscillator(SIDE, None, 1.0)


def by_scipy(duration: float, moment: Callable[[float, float], float], start: float = 0.0) -> np.ndarray:
    """phi and phi' at the end, from a rest at `start` under a restoring moment(t, phi) for an M R of 1 kg m."""
    motion = lambda t, y: [y[1], -(P**2) / g * moment(t, y[0])]  # noqa: E731
    out = solve_ivp(motion, (0.0, duration), [start, 0.0], method="DOP853", rtol=3e-14, atol=1e-17)
    return np.asarray(out.y[:, -1])


def error(
    duration: float,
    steps: int,
    ground: tuple[float, float],
    *,
    body: Oscillator = CUBIC,
    moment: Callable[[float], float] = moment,
    start: float = 0.0,
) -> np.ndarray:
    """Of phi and phi' after that many steps."""
    t = np.linspace(0.0, duration, steps + 1)
    record = make_record("line", ground[0] + ground[1] * t, duration / steps)
    path = trace(body, record, scale=1.0, equation="exact", tolerance=UNCHECKED, release=start)
    theirs = by_scipy(duration, lambda t, phi: moment(phi) + arm(phi) * (ground[0] + ground[1] * t), start)
    return np.abs([path.rotation[-1], path.velocity[-1]] - theirs)


def orders(sizes: np.ndarray, errors: np.ndarray) -> np.ndarray:
    """Slopes of log error [n, 2] over log size [n]."""
    return np.asarray(np.polyfit(np.log(sizes), np.log(errors), 1)[0])


def test_one_step_errs_by_the_seventh_power_in_rotation_and_the_sixth_in_velocity() -> None:
    h = np.array([0.03, 0.04, 0.06, 0.08])
    errors = np.array([error(x, 1, (-2.5, -5.0)) for x in h])
    np.testing.assert_allclose(orders(h, errors), [7.0, 6.0], rtol=0, atol=0.15)


def test_many_steps_err_by_the_fifth_power() -> None:
    steps = np.array([8, 12, 16, 24])
    errors = np.array([error(0.8, int(n), (-4.0, 7.0)) for n in steps])
    np.testing.assert_allclose(orders(0.8 / steps, errors), [5.0, 5.0], rtol=0, atol=0.15)


def spring(phi: float) -> float:
    """A moment that is zero at rest, as on joints, stiffens and falls to zero at ALPHA: a cubic too."""
    return 4.0 * g * phi * (1.0 - phi / ALPHA) * (1.0 + phi)


ON_JOINTS = Oscillator(replace(SIDE, restoring=np.array([*map(spring, PHI)])), None, 1.0)
SPRUNG: dict[str, Any] = {"body": ON_JOINTS, "moment": spring, "start": 0.5 * ALPHA}


def test_on_joints_many_steps_err_by_the_sixth_power() -> None:
    steps = np.array([3, 4, 6, 8])
    errors = np.array([error(0.25, int(n), (-2.5, -5.0), **SPRUNG) for n in steps])
    np.testing.assert_allclose(orders(0.25 / steps, errors), [6.0, 6.0], rtol=0, atol=0.25)


def test_a_finer_table_converges_by_the_fourth_power_or_better() -> None:
    """A spline errs by h^4, and by h^5 at its ends. Against the closed formula, from rest under a constant push."""
    duration, push = 0.7, -3.4
    theirs = by_scipy(duration, lambda t, phi: g * math.sin(ALPHA - phi) + math.cos(ALPHA - phi) * push)
    record = make_record("push", np.full(201, push), duration / 200)
    nodes, errors = np.array([17, 33, 65]), []
    for n in nodes:
        path = trace(block(P, ALPHA, sides=1, nodes=n), record, scale=1.0, equation="exact", tolerance=1e-14)
        errors.append(np.abs([path.rotation[-1], path.velocity[-1]] - theirs))
    assert 0.2 * ALPHA < theirs[0] < 1.5 * ALPHA
    assert np.all(orders(1.0 / (nodes - 1), np.array(errors)) > 4.0)


@pytest.mark.parametrize("name", ["sine", "ricker"])
def test_pieces_of_a_pulse_err_by_the_sixth_power(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    shape, counts, errors = PULSE_SHAPES[name], np.array([12, 24, 48]), []
    for count in counts:
        monkeypatch.setattr(pulses, "PIECES", int(count))
        pieces, width = pulses.pulse_polynomials(shape)
        middle = sum(pieces[:, m] * (0.5 * width) ** m for m in range(6))
        theta = shape.start + width * (np.arange(len(pieces)) + 0.5)
        errors.append(np.abs(middle - shape.value(theta)).max())
    np.testing.assert_allclose(orders(1.0 / counts, np.array(errors)), 6.0, rtol=0, atol=0.25)
