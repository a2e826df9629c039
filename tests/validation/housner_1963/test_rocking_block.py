"""Housner 1963, BSSA 53: free rocking and the rectangular pulse, by the linearised equation.

Period: p T = 4 acosh(1 / (1 - theta_0 / alpha)). Rectangular pulse of duration t_1, overturning without impact:
a / (alpha g) = 1 / (1 - exp(-p t_1)).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.constants import g
from scipy.special import ellipk, ellipkinc

from assess.dynamics.history import Jobs, free_rocking, peaks
from assess.oscillator import Branch, Oscillator
from records.record import make_record

P, ALPHA = 1.7, 0.2


def block(restitution: float = 1.0, p: float = P) -> Oscillator:
    phi = np.linspace(0.0, 1.5 * ALPHA, 257)
    one = np.ones_like(phi)
    moment, excitation = g * np.sin(ALPHA - phi), np.cos(ALPHA - phi)
    side = Branch(phi, g / p**2 * one, moment, excitation, one, one, restitution, ALPHA, ALPHA)
    return Oscillator(side, side, 1.0)


@pytest.mark.parametrize("ratio", [1e-6, 0.01, 0.3, 0.5, 0.9, 0.999])
def test_free_rocking_period(ratio: float) -> None:
    body = block()
    p = body.positive.linearised.p
    period = 4 * math.acosh(1 / (1 - ratio)) / p
    found = free_rocking(body, rotation=ratio * ALPHA, duration=2.3 * period, equation="linearised")
    expected = period * np.array([0.25, 0.75, 1.25, 1.75, 2.25])
    np.testing.assert_allclose(found.impact_time, expected, rtol=1e-10 if ratio > 0.1 else 1e-8)
    np.testing.assert_allclose(found.peak_time, period * np.array([0.5, 1.0, 1.5, 2.0]), rtol=1e-8)
    np.testing.assert_allclose(np.abs(found.peak_rotation), ratio * ALPHA, rtol=1e-9)


def test_half_ratio_has_the_published_period() -> None:
    body = block()
    found = free_rocking(body, rotation=0.5 * ALPHA, duration=10.0, equation="linearised")
    p = body.positive.linearised.p
    assert p * (found.impact_time[2] - found.impact_time[0]) == pytest.approx(5.2678, abs=5e-5)


@pytest.mark.parametrize("restitution", [0.95, 0.7])
def test_amplitudes_decay_by_restitution(restitution: float) -> None:
    """After n impacts theta_n / alpha = 1 - sqrt(1 - r^n (1 - (1 - theta_0 / alpha)^2)), r = restitution^2."""
    found = free_rocking(block(restitution), rotation=0.6 * ALPHA, duration=12.0, equation="linearised")
    n = np.arange(1, found.peak_rotation.size + 1)
    expected = 1 - np.sqrt(1 - restitution ** (2 * n) * (1 - 0.4**2))
    assert n.size > 5
    np.testing.assert_allclose(np.abs(found.peak_rotation) / ALPHA, expected, rtol=1e-9, atol=1e-15)


def test_exact_quarter_period_is_the_elliptic_integral() -> None:
    """The inverted pendulum theta'' = -p^2 sin(alpha - theta) from rest at theta_0, by quadrature of its energy.

    With psi = alpha - theta, psi'^2 = 2 p^2 (cos psi_0 - cos psi). With k = sin(psi_0 / 2) and w = cos(psi / 2) =
    sqrt(1 - k^2) sin(u), the time is the integral of du / (p sqrt(1 - (1 - k^2) sin^2 u)) from psi = alpha to psi_0,
    that is u from asin(cos(alpha / 2) / sqrt(1 - k^2)) to pi / 2.
    """
    ratio = 0.5
    k = math.sin((1 - ratio) * ALPHA / 2)
    u = math.asin(math.cos(ALPHA / 2) / math.sqrt(1 - k**2))
    expected = (ellipk(1 - k**2) - ellipkinc(u, 1 - k**2)) / P
    found = free_rocking(block(), rotation=ratio * ALPHA, duration=3.0, equation="exact")
    assert found.impact_time[0] == pytest.approx(expected, rel=1e-10)


@pytest.mark.parametrize("pt", [0.2, 1.0, 3.0])
def test_rectangular_pulse(pt: float) -> None:
    """The motion ends with the pulse, as a step."""
    body = block()
    form = body.positive.linearised
    critical = g * form.multiplier / (1 - math.exp(-pt))
    n, t_1 = 50, pt / form.p
    pulse = make_record("rectangle", np.full(n + 1, -1.0), t_1 / n)
    scales = critical * (1 + np.array([-1e-9, 1e-9]))
    found = peaks([body], [pulse], Jobs(*map(np.array, ([0, 0], [0, 0])), scales), equation="linearised")
    assert found.overturned.tolist() == [False, True]


def test_rectangular_pulse_of_unit_length_has_the_published_amplitude() -> None:
    assert 1 / (1 - math.exp(-1)) == pytest.approx(1.5820, abs=5e-5)
