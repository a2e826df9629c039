"""Housner 1963, BSSA 53: free rocking and the rectangular pulse, by the linearised equation.

Period: p T = 4 acosh(1 / (1 - theta_0 / alpha)). Rectangular pulse of duration t_1, overturning without impact:
a / (alpha g) = 1 / (1 - exp(-p t_1)).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.constants import g

from assess.dynamics.history import Jobs, free_rocking, peaks
from records.record import make_record
from tests.support.blocks import block

P, ALPHA = 1.7, 0.2


@pytest.mark.parametrize("ratio", [1e-6, 0.01, 0.3, 0.5, 0.9, 0.999])
def test_free_rocking_period(ratio: float) -> None:
    body = block(P, ALPHA, 1.0)
    p = body.positive.linearised.p
    period = 4 * math.acosh(1 / (1 - ratio)) / p
    found = free_rocking(body, rotation=ratio * ALPHA, duration=2.3 * period, equation="linearised")
    expected = period * np.array([0.25, 0.75, 1.25, 1.75, 2.25])
    np.testing.assert_allclose(found.impact_time, expected, rtol=1e-10 if ratio > 0.1 else 1e-8)
    np.testing.assert_allclose(found.peak_time, period * np.array([0.5, 1.0, 1.5, 2.0]), rtol=1e-8)
    np.testing.assert_allclose(np.abs(found.peak_rotation), ratio * ALPHA, rtol=1e-9)


@pytest.mark.parametrize("restitution", [0.95, 0.7])
def test_amplitudes_decay_by_restitution(restitution: float) -> None:
    """After n impacts theta_n / alpha = 1 - sqrt(1 - r^n (1 - (1 - theta_0 / alpha)^2)), r = restitution^2."""
    found = free_rocking(block(P, ALPHA, restitution), rotation=0.6 * ALPHA, duration=12.0, equation="linearised")
    n = np.arange(1, found.peak_rotation.size + 1)
    expected = 1 - np.sqrt(1 - restitution ** (2 * n) * (1 - 0.4**2))
    assert n.size > 5
    np.testing.assert_allclose(np.abs(found.peak_rotation) / ALPHA, expected, rtol=1e-9, atol=1e-15)


@pytest.mark.parametrize("pt", [0.2, 1.0, 3.0])
def test_rectangular_pulse(pt: float) -> None:
    """The motion ends with the pulse, as a step."""
    body = block(P, ALPHA, 1.0)
    form = body.positive.linearised
    critical = g * form.multiplier / (1 - math.exp(-pt))
    n, t_1 = 50, pt / form.p
    pulse = make_record("rectangle", np.full(n + 1, -1.0), t_1 / n)
    scales = critical * (1 + np.array([-1e-9, 1e-9]))
    found = peaks([body], [pulse], Jobs(*map(np.array, ([0, 0], [0, 0])), scales), equation="linearised")
    assert found.overturned.tolist() == [False, True]
