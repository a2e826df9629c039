"""Circolare 617/2009 C8A.4 on a wall 0.6 m thick and 6 m high, evaluated by hand on a linear curve with g = 9.81 m/s2.

The model's own curve is tan(alpha - phi), 0.2 % from the straight line here; with g's 0.03 % that is the tolerance.
"""

from __future__ import annotations

import dataclasses
from functools import partial

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import dmi2008
from assess.codes.check import Reason
from assess.codes.context import Building, Context
from assess.codes.dmi2008 import floor_acceleration, floor_displacement, ground_displacement
from assess.codes.italian_limit_states import ItalianOptions, curves_of_all_actions, floor_of
from assess.geometry.planar import planar_body
from assess.geometry.solid import box
from assess.mechanisms.single_block import single_block
from spectra.asce7 import design_spectrum
from spectra.ec8 import elastic_spectrum
from tests.support.answered import context_at
from tests.support.bodies import free_wall


@pytest.fixture(scope="module")
def rocker():
    return free_wall()


context = partial(context_at, design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0), levels=(0.15 * g,))
HOUSE = Building(height=9.0, storeys=3, period=0.26, damping=0.05)
LC1 = 1.35


def capacity_of(rocker, *, confidence_factor=LC1):
    (curves,) = curves_of_all_actions(rocker)
    return dmi2008.capacity_of(curves, confidence_factor=confidence_factor)


@pytest.mark.parametrize(("FC", "a0", "as_", "Ts"), [(1.0, 0.981, 0.8240, 1.516), (1.35, 0.7267, 0.6104, 1.762)])
def test_capacity(rocker, FC, a0, as_, Ts):
    cap = capacity_of(rocker, confidence_factor=FC)
    assert cap.e == pytest.approx(1.0, rel=1e-12)
    assert cap.a0 == pytest.approx(a0, rel=2e-3)
    assert (cap.d0, cap.du, cap.ds) == pytest.approx((0.300, 0.120, 0.048), rel=1e-9)
    assert cap.as_ == pytest.approx(as_, rel=2e-3)
    assert cap.Ts == pytest.approx(Ts, rel=2e-3)


@pytest.mark.parametrize(("r", "factor"), [(1.0, 7.071), (1.5, 4.252), (2.0, 3.922), (5.0, 6.231)])
def test_height_factor_of_the_displacement_demand(r, factor):
    at = context(elevation=9.0, building=HOUSE)
    floor = floor_of(at)
    first_mode = ground_displacement(at, floor.T1) * 9 / 7  # psi = 1 at the top, gamma = 3N/(2N+1)
    assert floor_displacement(at, floor, r * floor.T1) / first_mode == pytest.approx(factor, rel=1e-4)


def test_linear_check_with_q(rocker):
    (check,) = dmi2008.assess_linear(rocker, context(), options=ItalianOptions())
    assert check.capacity_pga_g == pytest.approx(0.148, rel=5e-3)  # ag S <= 2 x 0.7267 m/s2
    assert check.verdict == "fail"
    (passing,) = dmi2008.assess_linear(rocker, context(levels=(0.14 * g,)), options=ItalianOptions())
    assert passing.verdict == "pass"


def test_damage_limit_state_has_no_behaviour_factor(rocker):
    damage, life = dmi2008.assess_linear(rocker, context(), options=ItalianOptions(limit_states=("SLD", "SLV")))
    assert damage.capacity_pga_g == pytest.approx(life.capacity_pga_g / 2, rel=1e-12)


def test_above_ground_the_floor_governs(rocker):
    at = context(elevation=9.0, building=HOUSE)
    (raised,) = dmi2008.assess_linear(rocker, at, options=ItalianOptions())
    assert raised.demand == pytest.approx(floor_acceleration(at, floor_of(at)) * 0.15 / 0.2 / 2, rel=1e-12)
    assert raised.input_at == "mechanism base"
    (ground,) = dmi2008.assess_linear(rocker, context(), options=ItalianOptions())
    assert raised.capacity_pga_g < ground.capacity_pga_g


def test_nonlinear_demand_is_the_displacement_spectrum_at_the_secant_period(rocker):
    at = context(levels=(0.18 * g,))
    (check,) = dmi2008.assess_nonlinear(rocker, at, options=ItalianOptions())
    cap = capacity_of(rocker)
    assert 0.4 < cap.Ts < 6.0  # on the branch S_D1 / T
    by_hand = 0.2 * g / cap.Ts * (cap.Ts / 6.283185307179586) ** 2 * 0.18 / 0.2
    assert check.demand == pytest.approx(by_hand, rel=1e-9)
    assert check.capacity_pga_g == pytest.approx(0.18 * cap.du / by_hand, rel=1e-9)


@pytest.mark.parametrize(("size", "beyond"), [(1.0, False), (25.0, True)])
def test_beyond_t_e_the_demand_is_the_code_s_own_displacement(size, beyond):
    """EC8, type 1, ground B, a_g S = 0.24 g: T_E = 5 s, d_g = 0.025 a_g S T_C T_D; T_F = 10 s; by hand.

    A wall 25 times as large has a T_s five times as long, beyond T_E. S_e (T / 2 pi)^2 would stay at its value at T_D.
    """
    wall = box(thickness=0.6 * size, length=1.0, height=6.0 * size, base=(0, 0, 0), density=1800.0, name="wall")
    rocker = single_block("wall", planar_body(wall, direction=(1, 0, 0))).oscillator
    spectrum = elastic_spectrum(a_g=0.2 * g, ground_type="B")
    (check,) = dmi2008.assess_nonlinear(
        rocker, Context(spectrum, (0.24 * g,), 0.0, 0.0, None), options=ItalianOptions()
    )
    T = capacity_of(rocker).Ts
    assert (5.0 < T < 10.0) is beyond
    d_g = 0.025 * 0.24 * g * 0.5 * 2.0
    long = d_g * (2.5 + (T - 5.0) / 5.0 * (1.0 - 2.5))
    short = 2.5 * 0.24 * g * 0.5 / T * (T / (2 * np.pi)) ** 2  # T_C < T < T_D
    assert check.demand == pytest.approx(long if beyond else short, rel=1e-9)
    (step,) = (step for step in check.steps if step.symbol == "S_De(T_s)")
    assert step.value == pytest.approx(check.demand, rel=1e-12)
    assert ("T > T_E" in step.formula) is beyond


def test_below_uplift_nothing_rocks(rocker):
    (check,) = dmi2008.assess_nonlinear(rocker, context(levels=(0.07 * g,)), options=ItalianOptions())
    assert (check.demand, check.rotation_ratio, check.verdict) == (0.0, 0.0, "pass")
    assert check.reason.key == Reason.NO_ROCKING


def test_floor_of_a_wall_between_floors_is_at_the_mean_of_its_supports():
    """C8A.4.2.3: Z is that of the centroid of the lines that hold the mechanism: (3 + 6) / 2 of 9 m."""
    between = dataclasses.replace(context(elevation=3.0, building=HOUSE), rise=3.0)
    found, free = floor_of(between), floor_of(dataclasses.replace(between, rise=0.0))
    assert (found.psi, free.psi) == pytest.approx((0.5, 1 / 3), rel=1e-12)
    assert floor_of(dataclasses.replace(between, elevation=0.0)).psi == pytest.approx(1.5 / 9, rel=1e-12)
    assert floor_of(dataclasses.replace(between, elevation=0.0, rise=0.0)) is None
