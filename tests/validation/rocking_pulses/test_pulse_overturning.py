"""Overturning under sine pulses, by the linearised equation, against closed forms of its own derivation.

With A = a_p / (g lambda), O = omega_p / p, psi = asin(1 / A), without impact: one sine (sqrt(A^2 - 1) - O)
exp((2 pi - psi) / O) = A; half a sine (sqrt(A^2 - 1) - O) exp((pi - psi) / O) + A = 0, which is Zhang and Makris 2001.
A sine given by n samples and straight lines between has its first harmonic smaller by sinc^2(pi / n).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import brentq

from assess.dynamics.history import Equation, Jobs, Peaks, peaks
from assess.oscillator import Oscillator
from records.record import Record, make_record
from tests.support.blocks import block
from tests.validation.rocking_pulses.printed import HALF_SINE, ONE_SINE

P, ALPHA = 2.0, 0.2


def pulse(omega: float, *, cycles: float = 1.0, n: int = 20_000) -> Record:
    """Unit A: first half lifting towards positive rotation, n samples a period."""
    form = block(P, ALPHA, 0.9).positive.linearised
    steps = round(cycles * n)
    t = np.arange(steps + 1) / n
    return make_record("pulse", -g * form.multiplier * np.sin(2 * math.pi * t), 2 * math.pi / (omega * form.p * n))


def run(body: Oscillator, motion: Record, amplitudes: np.ndarray, equation: Equation = "linearised") -> Peaks:
    zeros = np.zeros(amplitudes.size, dtype=np.int64)
    return peaks([body], [motion], Jobs(zeros, zeros, amplitudes), equation=equation)


def threshold(body: Oscillator, motion: Record, below: float, above: float) -> float:
    """The amplitude between an outcome that stands and one that overturns."""
    outcomes = lambda amplitude: run(body, motion, np.array([amplitude])).overturned  # noqa: E731
    return float(brentq(lambda amplitude: 1.0 if outcomes(amplitude)[0] else -1.0, below, above, xtol=1e-13))


@pytest.mark.parametrize("omega", ONE_SINE)
def test_one_sine_without_impact(omega: float) -> None:
    """One-sided, so that no other branch is near; the restitution does not enter."""
    n, expected = 20_000, ONE_SINE[omega]
    found = threshold(block(P, ALPHA, 0.0, sides=1), pulse(omega, n=n), expected * 0.999, expected * 1.001)
    assert found * np.sinc(1 / n) ** 2 == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("omega", HALF_SINE)
def test_half_sine_without_impact(omega: float) -> None:
    n, expected = 20_000, HALF_SINE[omega]
    found = threshold(block(P, ALPHA, 0.9), pulse(omega, cycles=0.5, n=n), expected * 0.999, expected * 1.001)
    assert found * np.sinc(1 / n) ** 2 == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("omega", [o for o in HALF_SINE if o > 0.5])
def test_one_sided_under_a_pulse_that_presses_first(omega: float) -> None:
    """The first half presses the body on the wall, the second acts as half a sine: the lower threshold of the two."""
    n, expected = 20_000, HALF_SINE[omega]
    found = threshold(block(P, ALPHA, 0.4, sides=1), pulse(omega, n=n), -expected * 0.999, -expected * 1.001)
    assert -found * np.sinc(1 / n) ** 2 == pytest.approx(expected, rel=1e-8)


def test_coarse_sampling_raises_the_threshold_by_the_first_harmonic() -> None:
    n, expected = 400, ONE_SINE[4.0]
    found = threshold(block(P, ALPHA, 0.0, sides=1), pulse(4.0, n=n), expected * 0.999, expected * 1.001)
    assert found / expected - 1 == pytest.approx(math.pi**2 / (3 * n**2), rel=5e-3)


@pytest.mark.parametrize(
    ("omega", "amplitudes", "falls"),
    [
        (2.0, [1.22, 1.23, 2.30, 2.345, 2.36], [False, True, True, False, True]),
        (4.0, [1.79, 1.80, 4.80, 4.90, 5.23, 5.25], [False, True, True, False, False, True]),
        (6.0, [5.15, 5.18, 7.60, 7.75, 9.40, 9.43], [False, True, True, False, False, True]),
        (8.0, [5.0, 10.0, 14.86, 14.88], [False, False, False, True]),
    ],
)
def test_safe_islands_above_the_impact_branch(omega: float, amplitudes: list[float], falls: list[bool]) -> None:
    """Restitution 0.9: stands, overturns with one impact, stands, overturns without."""
    found = run(block(P, ALPHA, 0.9), pulse(omega, n=400), np.array(amplitudes))
    assert found.overturned.tolist() == falls


def test_beyond_overturning_under_load_and_back() -> None:
    """Omega = 8, A = 12.4, restitution 0.9: 1.0267 phi_ov is reached under load; it returns and stands."""
    found = run(block(P, ALPHA, 0.9), pulse(8.0, n=400), np.array([12.4]))
    assert found.max_ratio[0] == pytest.approx(1.0267, abs=1e-4)
    assert found.impacts[0] == 2
    assert not found.overturned[0]
    assert math.isnan(found.overturning_time[0])


@pytest.mark.parametrize("excess", [-1e-12, 1e-12])
@pytest.mark.parametrize("start", [0.1, 0.4])
def test_free_motion_overturns_where_y_plus_rate_exceeds_one(start: float, excess: float) -> None:
    """A ground step whose end leaves y + y' = 1 + excess, by the closed form under constant acceleration."""
    form = block(P, ALPHA, 0.9).positive.linearised
    # at rest under A > 1: y = (A - 1)(cosh x - 1), y' = (A - 1) sinh x: y + y' = (A - 1)(e^x - 1), y = start
    x = float(
        brentq(lambda x: (math.cosh(x) - 1) / math.expm1(x) - start, 1e-9, 30.0, xtol=1e-15)
    )  # where y is reached
    amplitude = 1 + (1 + excess) / math.expm1(x)
    motion = make_record("step", np.full(2, -g * form.multiplier), x / form.p)
    assert (amplitude - 1) * (math.cosh(x) - 1) == pytest.approx(start, rel=1e-9)
    assert bool(run(block(P, ALPHA, 0.0), motion, np.array([amplitude])).overturned[0]) == (excess > 0)
