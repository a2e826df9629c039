"""The branches of overturning under a sine: closed forms, envelopes by integration, and tables of another integrator.

The numbers were printed by an event-exact integrator of its own, for a sine of 400 samples a period with straight lines
between, whose first harmonic is smaller by sinc^2(pi / 400): printed thresholds are higher than those of a true sine by
2.06e-5, relative.
"""

from __future__ import annotations

from decimal import Decimal, getcontext
from functools import partial
from math import asin, pi, tan

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics import sine_branches as sine
from assess.dynamics.packing import Equation
from assess.dynamics.pulses import PulseJobs, envelope, pulse_outcomes
from assess.oscillator import Oscillator
from records.pulses import PULSE_SHAPES
from tests.support.blocks import tabulated_block
from tests.validation.rocking_pulses.printed import HALF_SINE, ONE_SINE

P, SAMPLED = 2.0, 1.0 / np.sinc(1 / 400) ** 2
block_of = partial(tabulated_block, P)

ISLANDS = {2.0: (1.2252, 2.34), 3.0: (1.40, 3.5), 4.0: (1.7955, 4.85), 5.0: (3.0, 6.3), 6.0: (5.164, 7.68)}
"""Restitution 0.9: where one impact begins to overturn, and ceases to (to a few hundredths)."""


def unit(body: Oscillator, equation: Equation) -> tuple[float, float]:
    """Acceleration of A = 1 [m/s2] and frequency of Omega = 1 [Hz]; a block's uplift is g tan(alpha)."""
    form = body.positive.linearised
    if equation == "linearised":
        return g * form.multiplier, form.p / (2 * pi)
    return g * tan(body.positive.overturning), P / (2 * pi)


def falls(
    body: Oscillator, omega: float, A: object, equation: Equation = "linearised", name: str = "sine"
) -> list[bool]:
    """Outcomes at amplitudes A; the shapes begin with a positive half, which lifts to the negative side."""
    amplitude, frequency = unit(body, equation)
    signed = -amplitude * np.atleast_1d(np.asarray(A, dtype=float))
    none = np.zeros(signed.size, dtype=np.int64)
    jobs = PulseJobs(none, none, signed)
    found = pulse_outcomes(
        [body], PULSE_SHAPES[name], np.array([omega * frequency]), jobs, equation=equation, threads=1
    )
    return list(found.overturned.tolist())


def bounds(body: Oscillator, omegas: object, highest: float, equation: Equation) -> np.ndarray:
    """The lower bound of the envelope as A."""
    amplitude, frequency = unit(body, equation)
    grid = np.array([0.0, highest]) * amplitude
    found = envelope(body, PULSE_SHAPES["sine"], np.asarray(omegas) * frequency, grid, equation=equation, threads=1)
    return found.lower_bound / amplitude


@pytest.mark.parametrize("omega", [1e-3, 1e-2, 0.05])
def test_a_long_pulse_acts_as_a_static_load_and_overflows_nothing(omega: float) -> None:
    """Both branches go to sqrt(1 + Omega^2)."""
    getcontext().prec = 30
    limit = float((1 + Decimal(omega) ** 2).sqrt())
    assert sine.without_impact(omega) == pytest.approx(limit, rel=1e-15)
    assert sine.half_sine(omega) == pytest.approx(limit, rel=1e-15)
    assert 1.0 < sine.least_overturning_amplitude(omega, 0.9) <= limit * (1 + 1e-15)


def test_a_short_half_sine_acts_by_its_area() -> None:
    """Impulse 2 a_p / omega = p g lambda, so A -> Omega / 2 (Housner 1963); the next term falls as 1 / Omega^2."""
    found = np.array([sine.half_sine(omega) / omega for omega in (100.0, 200.0)])
    assert found[1] == pytest.approx(0.5, abs=5e-3)
    assert found[1] - 0.5 < 0.6 * (found[0] - 0.5)


@pytest.mark.parametrize("omega", ISLANDS)
def test_branches_with_one_impact_are_where_the_outcomes_change(omega: float) -> None:
    first, last = ISLANDS[omega]
    found = (*sine.impact_in_pulse(omega, 0.9), *sine.impact_after_pulse(omega, 0.9))
    assert found == pytest.approx((first, last), abs=0.03)
    for A in found:
        fallen = falls(block_of(restitution=0.9), omega, [A * (1 - 1e-9), A * (1 + 1e-9)])
        assert fallen == [found[1] == A, found[0] == A]


@pytest.mark.parametrize("omega", ONE_SINE)
@pytest.mark.parametrize("restitution", [0.0, 0.3, 0.9])
def test_the_branch_without_impact_is_where_the_outcome_changes(omega: float, restitution: float) -> None:
    """To 1e-10; where an impact overturns the body just below it, it does so on the other side."""
    A = ONE_SINE[omega]
    one_sided = block_of(restitution=0.0, sides=1)
    amplitude, frequency = unit(one_sided, "linearised")
    jobs = PulseJobs(*np.zeros((2, 2), dtype=np.int64), -amplitude * A * np.array([1 - 1e-10, 1 + 1e-10]))
    found = pulse_outcomes(
        [one_sided], PULSE_SHAPES["sine"], np.array([omega * frequency]), jobs, equation="linearised", threads=1
    )
    assert found.overturned.tolist() == [False, True]
    assert falls(block_of(restitution=restitution), omega, A * (1 + 1e-10)) == [True]


@pytest.mark.parametrize("omega", HALF_SINE)
def test_half_a_sine_overturns_from_its_branch_on(omega: float) -> None:
    A = sine.half_sine(omega)
    fallen = falls(block_of(restitution=0.9), omega, [A * (1 - 1e-10), A * (1 + 1e-10)], name="half-sine")
    assert fallen == [False, True]


@pytest.mark.parametrize("restitution", [0.3, 0.5, 0.7, 0.8, 0.9])
def test_lower_bound_of_the_envelope_is_the_least_branch(restitution: float) -> None:
    """Below Omega = 1 a second or third impact can overturn: there the envelope is never above the branches."""
    omegas = [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0]
    least = [sine.least_overturning_amplitude(omega, restitution) for omega in omegas]
    np.testing.assert_allclose(bounds(block_of(restitution=restitution), omegas, 40.0, "linearised"), least, rtol=1e-9)
    long = [0.1, 0.2, 0.3, 0.5, 0.7]
    found = bounds(block_of(restitution=restitution), long, 40.0, "linearised")
    assert np.all(
        found <= np.array([sine.least_overturning_amplitude(omega, restitution) for omega in long]) * (1 + 1e-9)
    )


def test_a_branch_at_the_change_from_in_the_pulse_to_after_it() -> None:
    """Omega 4.4352, restitution 0.85: it lands at the very end of the pulse, nearly."""
    A = sine.least_overturning_amplitude(4.4351758793969855, 0.85)
    assert pytest.approx(sine.last_in_pulse(4.4351758793969855), rel=0.01) == A
    assert falls(block_of(restitution=0.85), 4.4351758793969855, [A * (1 - 1e-9), A * (1 + 1e-9)]) == [False, True]


@pytest.mark.parametrize("restitution", [0.9, 0.7])
@pytest.mark.parametrize("omega", [2.0, 3.0, 4.0, 5.0, 6.0, 8.0])
def test_outcomes_are_those_between_the_branches(omega: float, restitution: float) -> None:
    """Every A from 1.02 to 14 by steps of 0.02: an odd number of branches below means overturned."""
    A = np.arange(1.02, 14.0, 0.02)
    branches = np.sort(
        [*sine.impact_in_pulse(omega, restitution), *sine.impact_after_pulse(omega, restitution), ONE_SINE[omega]]
    )
    expected = np.searchsorted(branches, A) % 2 == 1
    np.testing.assert_array_equal(falls(block_of(restitution=restitution), omega, A), expected)


def test_the_map_shows_the_safe_island() -> None:
    """Omega 4, restitution 0.9: overturned from 1.7955 to 4.8501, stands up to 5.2390."""
    body = block_of(restitution=0.9)
    amplitude, frequency = unit(body, "linearised")
    A = np.arange(0.0, 6.0, 0.05)
    found = envelope(
        body, PULSE_SHAPES["sine"], np.array([4.0, 8.0]) * frequency, A * amplitude, equation="linearised", threads=1
    )
    changes = A[1:][np.diff(found.overturned[0].astype(int)) != 0]
    assert changes == pytest.approx([1.80, 4.90, 5.25])
    assert not found.overturned[1].any()
    assert np.isnan(found.lower_bound[1])


@pytest.mark.parametrize("omega", HALF_SINE)
def test_one_sided_rocking_needs_less_where_the_pulse_presses_first(omega: float) -> None:
    """The plot of the thesis shows the other polarity; the envelope takes the worse. Restitution 0.4 does not enter."""
    body = block_of(restitution=0.4, sides=1)
    amplitude, frequency = unit(body, "linearised")
    lifting, pressing = ONE_SINE[omega], sine.half_sine(omega)
    assert falls(body, omega, [lifting * (1 - 1e-10), lifting * (1 + 1e-10)]) == [False, True]
    if omega > 0.5:  # longer pulses overturn after rebounds, below
        assert falls(body, omega, [-pressing * (1 - 1e-10), -pressing * (1 + 1e-10)]) == [False, True]
    grid = np.array([0.0, 20.0]) * amplitude
    made = envelope(body, PULSE_SHAPES["sine"], np.array([omega * frequency]), grid, equation="linearised", threads=1)
    assert made.polarity.tolist() == [1]  # the ground moves in the direction first, which presses on the support
    assert made.lower_bound[0] / amplitude == pytest.approx(pressing, rel=1e-9)


SECTION_5 = {
    0.05: ((1.0, 1.132, 1.4183), (2.0, 1.2252, 2.3503), (4.0, 1.7959, 5.2425), (6.0, 5.147, 9.429)),
    0.1: ((1.0, 1.132, 1.4182), (2.0, 1.2251, 2.3512), (4.0, 1.7971, 5.2526), (6.0, 5.096, 9.464)),
    0.2: ((1.0, 1.132, 1.4179), (2.0, 1.2249, 2.3550), (4.0, 1.8021, 5.2931), (6.0, 4.924, 9.605)),
    0.3: ((1.0, 1.131, 1.4172), (2.0, 1.2245, 2.3610), (4.0, 1.8102, 5.3595), (6.0, 4.705, 9.840)),
    0.4: ((1.0, 1.130, 1.4160), (2.0, 1.2239, 2.3688), (4.0, 1.8216, 5.4499), (6.0, 4.481, 10.161)),
}
"""Of the exact block, restitution 0.9: Omega, the least A that overturns, the A that does so without impact."""


LAST_DIGIT = {1.0: (1e-3, 1e-4), 2.0: (1e-4, 1e-4), 4.0: (1e-4, 1e-4), 6.0: (1e-3, 1e-3)}
"""Of both columns; agreement is to 0.6 of it, half for rounding and a tenth for the search of the printed ones."""


@pytest.mark.parametrize("alpha", SECTION_5)
def test_exact_block_against_the_printed_thresholds(alpha: float) -> None:
    """The table of rotation long enough for those that return from far beyond alpha while the pulse lasts."""
    body = block_of(restitution=0.9, alpha=alpha, end=4.0)
    found = bounds(body, [row[0] for row in SECTION_5[alpha]], 12.0, "exact") * SAMPLED
    for (omega, least, without), ours in zip(SECTION_5[alpha], found, strict=True):
        near, far = (0.6 * digit for digit in LAST_DIGIT[omega])
        assert ours == pytest.approx(least, abs=near)
        edges = (without + np.array([-far, far])) / SAMPLED
        assert falls(body, omega, edges, "exact") == [False, True]


def test_leaving_the_table_counts_as_overturned() -> None:
    """Omega 2, alpha 0.2: between 0.98 and 1 of the amplitude without impact the block passes 1.5 alpha and would
    return under load. The table ends there, which is the safe side."""
    A = 0.99 * 2.3550
    assert falls(block_of(restitution=0.9, end=4.0), 2.0, A, "exact") == [False]
    assert falls(block_of(restitution=0.9, end=1.5), 2.0, A, "exact") == [True]


@pytest.mark.parametrize(("omega", "A"), [(4.0, 1.9), (2.0, 1.9), (3.0, 1.3)])
def test_landing_in_the_pulse_against_dop853(omega: float, A: float) -> None:
    """Phase and velocity of the first impact, by integration from uplift."""
    impact = lambda x, y: y[0]  # noqa: E731
    impact.terminal, impact.direction = True, -1
    psi = asin(1 / A)
    out = solve_ivp(
        lambda x, y: [y[1], y[0] - 1 + A * np.sin(psi + omega * x)],
        (0.0, (2 * pi - psi) / omega), [0.0, 0.0], method="DOP853", rtol=3e-14, atol=1e-15, events=impact,
    )  # fmt: skip
    assert out.t_events[0].size == 1
    theta, speed = sine._landing(A, omega)
    assert theta == pytest.approx(psi + omega * out.t_events[0][0], rel=1e-11)
    assert speed == pytest.approx(-out.y_events[0][0][1], rel=1e-11)


@pytest.mark.parametrize("bad", [0.0, -1.0, float("nan"), float("inf")])
def test_no_frequency_no_branch(bad: float) -> None:
    for branch in (sine.without_impact, sine.half_sine, lambda omega: sine.least_overturning_amplitude(omega, 0.9)):
        with pytest.raises(ValueError, match="Omega"):
            branch(bad)


@pytest.mark.parametrize("bad", [-0.1, 1.1])
def test_no_restitution_no_branch(bad: float) -> None:
    with pytest.raises(ValueError, match="restitution"):
        sine.least_overturning_amplitude(2.0, bad)
