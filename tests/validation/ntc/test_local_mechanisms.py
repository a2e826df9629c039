"""Circolare 7/2019 C8.7.1.2 on a wall 0.6 m thick and 6 m high, worked by hand on a linear curve with g = 9.81 m/s2.

The site is that of the elastic spectra's check: a_g = 0.261 g, F_0 = 2.364, T_C* = 0.347 s, soil B, so S = 1.1532,
T_C = 0.4717 s, T_D = 2.644 s. The model's own curve is tan(alpha - phi), up to 0.5 % from the straight line here.
"""

from __future__ import annotations

import dataclasses
from functools import partial
from math import pi, sqrt

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import ntc2018, ntc2018_clauses
from assess.codes.check import Reason
from assess.codes.context import Building, Context, FreePeriod, StatedFirstMode
from assess.codes.italian_limit_states import ItalianOptions, curves_of_all_actions
from assess.codes.ntc2018_clauses import FreeElement, free_period
from assess.geometry.planar import planar_body
from assess.geometry.solid import box
from assess.mechanisms.single_block import equivalent_block, single_block
from spectra import ntc
from spectra.asce7 import design_spectrum
from spectra.table import table_spectrum
from tests.support.answered import context_at, step_values
from tests.support.bodies import free_wall

A_G, F_0, S, T_C, T_D = 0.261 * g, 2.364, 1.1532, 0.4717, 2.644
PGA = A_G * S
ETA_8, ETA_10 = sqrt(10 / 13), sqrt(10 / 15)
LC1 = 1.35
MODEL = 5e-3  # of the straight line beside the model's own curve, and of 9.81 beside g


@pytest.fixture(scope="module")
def rocker():
    return free_wall(0.6)


SITE = ntc.elastic_spectrum(ntc.Hazard(A_G, F_0, 0.347), place=ntc.SoilAndTopography("B"))
ground = partial(context_at, SITE, levels=(PGA,))


def top(*, levels=(0.2 * g,), modes=None, **more):
    """The top of a house of three storeys with T_1 = 0.3 s, where S_e(T_1) = 0.5 g at a PGA of 0.2 g."""
    spectrum = design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0)
    house = Building(height=9.0, storeys=3, period=0.3, damping=0.05, limit_states=modes or {})
    return Context(spectrum, levels, 0.0, 9.0, house, **more)


def capacity_of(rocker, *, state, confidence_factor, T0=0.0):
    (curves,) = curves_of_all_actions(rocker)
    return ntc2018_clauses.capacity_of(curves, state=state, confidence_factor=confidence_factor, T0=T0)


STIFF = {"SLV": StatedFirstMode(0.3, 0.05, "hardly cracked")}


@pytest.mark.parametrize(
    ("state", "d", "a", "T"), [("SLV", 0.120, 0.4360, 2.769), ("SLC", 0.180, 0.2907, 3.857)], ids=["SLV", "SLC"]
)
def test_capacity(rocker, state, d, a, T):
    cap = capacity_of(rocker, state=state, confidence_factor=LC1)
    assert cap.e == pytest.approx(1.0, rel=1e-12)
    assert (cap.d0, cap.d) == pytest.approx((0.300, d), rel=1e-9)
    assert cap.a0 == pytest.approx(0.7267, rel=MODEL)
    assert cap.a == pytest.approx(a, rel=MODEL)
    assert pytest.approx(T, rel=MODEL) == cap.T


def test_linear_at_the_ground(rocker):
    """a_g,SLD S = a0* = 0.7267 m/s2, a_g,SLV S = 2 a_g,SLD S = 0.148 g (C8.7.1.8)."""
    damage, life = ntc2018.assess_linear(rocker, ground(), options=ItalianOptions(limit_states=("SLD", "SLV")))
    assert damage.capacity_pga_g == pytest.approx(0.7267 / 9.81, rel=MODEL)
    assert life.capacity_pga_g == pytest.approx(0.148, rel=MODEL)
    assert damage.ratio == pytest.approx(0.301 * 9.81 / 0.7267, rel=MODEL)
    assert life.safety_index == pytest.approx(0.148 / 0.301, rel=MODEL)
    assert (damage.verdict, life.verdict) == ("fail", "fail")


@pytest.mark.parametrize(("state", "eta", "d"), [("SLV", ETA_8, 0.120), ("SLC", ETA_10, 0.180)], ids=["SLV", "SLC"])
def test_nonlinear_at_the_ground(rocker, state, eta, d):
    """Both periods lie beyond T_D, where S_De = a_g S eta F_0 T_C T_D / 4 pi2: 0.193 m at 8 %, 0.180 m at 10 %."""
    (check,) = ntc2018.assess_nonlinear(rocker, ground(), options=ItalianOptions(limit_states=(state,)))
    by_hand = PGA * eta * F_0 * T_C * T_D / (4 * pi**2)
    assert check.demand == pytest.approx(by_hand, rel=5e-4)
    assert check.capacity == pytest.approx(d, rel=1e-9)
    assert check.capacity_pga_g == pytest.approx(0.301 * d / by_hand, rel=1e-3)
    assert check.safety_index == pytest.approx(d / by_hand, rel=1e-3)
    assert check.damping == {"SLV": 0.08, "SLC": 0.10}[state]


def test_nonlinear_stands_at_least_the_pga_of_activation():
    """A thick low wall whose displacement capacity would allow less than a0* does not rock below a_g,SLD S = a0*."""
    low = box(thickness=0.6, length=1.0, height=0.9, base=(0, 0, 0), density=1800.0, name="low")
    rocker = single_block("low", planar_body(low, direction=(1, 0, 0))).oscillator
    (check,) = ntc2018.assess_nonlinear(rocker, ground(levels=(0.45 * g,)), options=ItalianOptions())
    assert check.capacity_pga_g >= 0.6667 / LC1 * (1 - MODEL)  # b / h over FC, rigid at the ground
    assert (check.demand, check.verdict, check.reason.key) == (0.0, "pass", Reason.NO_ROCKING)


def test_floor_acceleration_and_activation_at_height(rocker):
    """a_Z = 0.5 g 9/7 sqrt(1 + 0.0004 25) = 0.6461 g, so a_g,SLD S = 0.1 g / 1.35 0.2 / 0.6461 (C7.2.7, .8)."""
    damage, life = ntc2018.assess_linear(rocker, top(), options=ItalianOptions(limit_states=("SLD", "SLV")))
    assert step_values(damage)["a_Z(T1)"] / g == pytest.approx(0.6461, rel=1e-4)
    assert damage.demand / g == pytest.approx(0.6461, rel=1e-4)
    assert damage.capacity_pga_g == pytest.approx(0.1 / LC1 * 0.2 / 0.6461, rel=MODEL)
    assert life.capacity_pga_g == pytest.approx(2 * 0.1 / LC1 * 0.2 / 0.6461, rel=MODEL)
    assert damage.input_at == "mechanism base"


@pytest.mark.parametrize(("T0", "ordinate"), [(0.15, 1.7501), (0.3, 3.1782), (0.66, 0.6461), (1.0, 0.3126)])
def test_free_elements_at_height_feel_the_floor_spectrum_at_their_period(rocker, T0, ordinate):
    """S_eZ(T0) of C7.2.6 [g], 5 % damping (C8.7.1.9)."""
    at = top(free_period=FreePeriod(T0))
    (check,) = ntc2018.assess_linear(rocker, at, options=ItalianOptions(limit_states=("SLD",)))
    assert check.demand / g == pytest.approx(ordinate, rel=2e-4)
    assert check.capacity_pga_g == pytest.approx(0.1 / LC1 * 0.2 / ordinate, rel=MODEL)


def test_free_elements_at_the_ground_feel_the_ground_spectrum_at_their_period(rocker):
    """On the level branch S_e = a_g S F_0."""
    (check,) = ntc2018.assess_linear(rocker, ground(free_period=FreePeriod(0.3)), options=ItalianOptions())
    assert check.demand == pytest.approx(PGA * F_0 / 2, rel=1e-4)


def test_nonlinear_at_height(rocker):
    """C8.7.1.12: T_SLV = 1.68 pi sqrt(0.12 / 0.4360) = 2.769 s lies on the falling branch of the floor spectrum.

    The building has 0.3 s and 5 % at SLV, as stated. A = 1.1 / sqrt(0.05) B, with B of the damping;
    S_eZ = A a_Z / (1 + (A - 1) (T / 0.33 - 1)^1.2), at least S_e(T).
    """
    (check,) = ntc2018.assess_nonlinear(rocker, top(modes=STIFF), options=ItalianOptions())
    found = step_values(check)
    T, A = 1.68 * pi * sqrt(0.12 / 0.4360), 1.1 / sqrt(0.05) * ETA_8
    assert found["T_SLV"] == pytest.approx(T, rel=MODEL)
    assert pytest.approx(A, rel=1e-9) == found["A"]
    by_hand = A * 0.6461 * g / (1 + (A - 1) * (found["T_SLV"] / 0.33 - 1) ** 1.2)
    at_ground = found["S_e(T)"]
    assert found["S_eZ(T_SLV)"] == pytest.approx(max(by_hand, at_ground), rel=1e-4)
    assert found["d(b T1', Z)"] == pytest.approx(A * 0.6461 * g * (1.1 * 0.3 / (2 * pi)) ** 2, rel=1e-4)
    demands = [value * (found["T_SLV"] / (2 * pi)) ** 2 for value in (at_ground, found["S_eZ(T_SLV)"])]
    assert check.demand == pytest.approx(max(*demands, found["d(b T1', Z)"]), rel=1e-9)


def test_stiff_mechanism_near_resonance_is_governed_by_the_floor():
    """A small pinnacle with T_SLV about b T1 of a flexible tower."""
    small = box(thickness=0.5, length=0.5, height=1.5, base=(0, 0, 20.0), density=1800.0, name="pinnacle")
    rocker = single_block("pinnacle", planar_body(small, direction=(1, 0, 0))).oscillator
    tower = Building(height=20.0, storeys=5, period=1.0, damping=0.05)
    at = Context(top().spectrum, (0.3 * g,), 0.0, 20.0, tower)
    (check,) = ntc2018.assess_nonlinear(rocker, at, options=ItalianOptions())
    found = step_values(check)
    assert check.input_at == "mechanism base"
    assert found["S_eZ(T_SLV)"] > 2 * found["S_e(T)"]
    assert check.ratio > 1


def test_floor_is_never_taken_to_shake_less_than_the_ground(rocker):
    """Low in the house gamma psi tends to zero, and a_Z with it; the demand stays the PGA."""
    low = dataclasses.replace(top(), elevation=0.6)
    (check,) = ntc2018.assess_linear(rocker, low, options=ItalianOptions(limit_states=("SLD",)))
    assert step_values(check)["a_Z(T1)"] < 0.2 * g
    assert check.demand == pytest.approx(0.2 * g, rel=1e-12)


def test_largest_displacement_of_a_spectrum_that_is_not_monotone(rocker):
    """A table with a resonance at 1.5 s: its displacement there exceeds that at T_SLV = 2.38 s."""
    period = np.array([0.0, 0.1, 1.3, 1.5, 1.7, 3.0, 5.0])
    spectrum = table_spectrum(period, np.array([0.2, 0.5, 0.2, 0.6, 0.1, 0.02, 0.01]) * g)
    at = Context(spectrum, (0.2 * g,), 0.0, 0.0, None)
    (check,) = ntc2018.assess_nonlinear(rocker, at, options=ItalianOptions())
    peak = float(spectrum.acceleration(1.5, damping=0.08)) * (1.5 / (2 * pi)) ** 2
    T_SLV = step_values(check)["T_SLV"]
    end = float(spectrum.acceleration(T_SLV, damping=0.08)) * (T_SLV / (2 * pi)) ** 2
    assert peak > 2 * end
    assert check.demand == pytest.approx(peak, rel=1e-2)  # between the periods that are tried


def test_period_of_a_free_wall():
    """C8.7.1.7 by hand: L = 2 m, t = 0.3 m, E = 0.8 GPa, 1800 kg/m3: 6.2 · 6.667 · 2 · sqrt(1800 / 0.8e9) = 0.124 s.

    The first mode of a cantilever is T = 2 pi / 3.516 sqrt(12) L2 / t sqrt(rho / E): 6.19 in place of 6.2.
    """
    given = {"length": 2.0, "thickness": 0.3, "young_modulus": 0.8e9, "density": 1800.0}
    assert free_period(FreeElement(**given)).value == pytest.approx(0.124, rel=1e-3)
    bernoulli = 2 * pi / 3.516 * sqrt(12) * 2.0**2 / 0.3 * sqrt(1800 / 0.8e9)
    assert free_period(FreeElement(**given)).value == pytest.approx(bernoulli, rel=2e-3)
    simply = 2 * pi / pi**2 * sqrt(12) * 2.0**2 / 0.3 * sqrt(1800 / 0.8e9)
    assert free_period(FreeElement(**given, support="supported")).value == pytest.approx(
        simply, rel=5e-3
    )  # 2.2 for 2.205


def test_elastic_branch_leaves_a_mechanism_of_short_period_as_it_is(rocker):
    """It ends where it meets the rocking curve, far short of d_SLV; a very soft one goes on beyond it."""
    rigid = capacity_of(rocker, state="SLV", confidence_factor=1.0)
    stiff = capacity_of(rocker, state="SLV", confidence_factor=1.0, T0=0.3)
    soft = capacity_of(rocker, state="SLV", confidence_factor=1.0, T0=4.0)
    assert pytest.approx(rigid.T, rel=1e-12) == stiff.T
    assert soft.a == pytest.approx((2 * pi / 4.0) ** 2 * soft.d, rel=1e-12)


def test_wider_base_never_fares_worse():
    for procedure in (ntc2018.assess_linear, ntc2018.assess_nonlinear):
        capacities = []
        for thickness in (0.3, 0.5, 0.7, 0.9, 1.2):
            (check,) = procedure(free_wall(thickness), ground(), options=ItalianOptions())
            capacities.append(check.capacity_pga_g)
        assert capacities == sorted(capacities)


def test_an_element_that_begins_to_rock_is_not_displaced_less_than_before():
    """T0 = b T1: before it rocks 5 % of damping at T0, after it at least 10 % there, which is eta = 0.82 of that."""
    rocker = equivalent_block("pinnacle", p=2.0, uplift=0.3, radius=1.0).oscillator
    tower = Building(10.0, 3, 1.0, 0.05, {"SLC": StatedFirstMode(1.0, 0.05, "hardly cracked")})
    levels = tuple(float(level) for level in np.linspace(0.04, 0.06, 21) * g / LC1)
    at = Context(ground().spectrum, levels, 0.0, 9.0, tower, free_period=FreePeriod(1.1))
    checks = ntc2018.assess_nonlinear(rocker, at, options=ItalianOptions(limit_states=("SLC",)))
    ratios = [check.ratio for check in checks]
    assert ratios == sorted(ratios)
    assert any("as it begins to rock" in step.remark for check in checks for step in check.steps)
