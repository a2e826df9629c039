"""ASCE/SEI 43-05, Appendix A: every formula on numbers worked by hand (g = 9.80665 m/s2)."""

from __future__ import annotations

from dataclasses import replace
from math import cos, exp, pi, sin

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import asce43_05, sliding
from assess.codes.context import Context
from assess.oscillator import RockingBlock, plain_branch
from spectra.table import table_spectrum
from tests.support.straight import GROUND, MASS, SPECTRUM, STRAIGHT

HAND = 2e-5  # hand values have six figures


@pytest.mark.parametrize(
    ("a", "ratio", "factor"),
    [(0.2, 0.0, 1.0), (0.75, 1.0, 1.25), (0.2, 0.5, 1.004988), (1.5, 0.5, 1.25)],  # 3-4-5; sqrt(1.01)
)
def test_vertical_factor(a: float, ratio: float, factor: float) -> None:
    assert asce43_05.vertical_factor(a, ratio) == pytest.approx(factor, rel=HAND)


@pytest.mark.parametrize(("support", "factor"), [("free", 1.077033), ("spanning", 1.0), ("hinged", 1.0)])
def test_component_factor(support, factor: float) -> None:
    """100-40: sqrt(1 + 0.16) where nothing holds the body across its plane."""
    assert asce43_05.component_factor(replace(GROUND, support=support)) == pytest.approx(factor, rel=HAND)


@pytest.mark.parametrize(("theta", "f1"), [(0.05, 0.00875), (0.1, 0.015), (0.2, 0.02)])  # 0.2 theta - theta^2 / 2
def test_stored_work(theta: float, f1: float) -> None:
    assert asce43_05.stored_work(STRAIGHT, np.array([theta])) == pytest.approx([f1], rel=HAND)


@pytest.mark.parametrize("theta", [0.02, 0.1, 0.19])
def test_stored_work_of_a_block(theta: float) -> None:
    """f1 = cos(theta) + a sin(theta) - 1 with a = tan(alpha) (Eq. A-5(a))."""
    block = plain_branch(RockingBlock(500.0, 2.0, 0.2, 2700.0), restitution=0.9)
    f1 = cos(theta) + np.tan(0.2) * sin(theta) - 1.0
    assert asce43_05.stored_work(block, np.array([theta])) == pytest.approx([f1], rel=1e-8)


@pytest.mark.parametrize(
    ("theta", "f_v", "in_g"),
    [(0.1, 1.0, 0.3), (0.1, 1.25, 0.24), (0.2, 1.0, 0.2), (0.05, 1.0, 0.35)],  # 2 f1 / (F_V theta)
)
def test_capacity_acceleration(theta: float, f_v: float, in_g: float) -> None:
    found = asce43_05.capacity_acceleration(STRAIGHT, np.array([theta]), f_v=f_v)
    assert found / g == pytest.approx([in_g], rel=HAND)


@pytest.mark.parametrize(
    ("theta", "f_e"),
    # omega^2 = 2 g 2000 f1 / (8000 theta^2) = g f1 / (2 theta^2): 0.75 g at 0.1, 0.25 g at 0.2
    [(0.1, 0.431628), (0.2, 0.249201)],
)
def test_effective_frequency(theta: float, f_e: float) -> None:
    assert asce43_05.effective_frequency(STRAIGHT, np.array([theta])) == pytest.approx([f_e], rel=HAND)


@pytest.mark.parametrize(
    ("restitution", "damping"),
    [
        (exp(-pi), 0.707107),  # gamma = 2 pi
        (0.9, 0.0335187),  # gamma = 0.210721
        (1.0, 0.0),
        (1.05, 0.0),  # onto a nearer hinge: never negative
        (0.0, 1.0),
    ],
)
def test_effective_damping(restitution: float, damping: float) -> None:
    assert asce43_05.effective_damping(restitution) == pytest.approx(damping, rel=HAND)


@pytest.mark.parametrize(("inertia", "k"), [(6000.0, 4.0 / 3.0), (9000.0, 2.0)])  # M R^2 = 4500
def test_inertia_ratio(inertia: float, k: float) -> None:
    assert asce43_05.inertia_ratio(RockingBlock(500.0, 3.0, 0.2, inertia)) == pytest.approx(k, rel=HAND)


@pytest.mark.parametrize(
    ("slenderness", "ratio"),
    # 4/3 alpha / sin(2 alpha): pi/4 gives pi/3; pi/6 gives 4/3 (pi/6) / (sqrt(3)/2)
    [(pi / 4, 1.047198), (pi / 6, 0.806133), (0.2, 0.684783)],
)
def test_thesis_limit_ratio(slenderness: float, ratio: float) -> None:
    block = RockingBlock(500.0, 3.0, slenderness, 4.0 / 3.0 * 4500.0)
    assert asce43_05.thesis_limit_ratio(block) == pytest.approx(ratio, rel=HAND)


@pytest.mark.parametrize(
    ("slenderness", "limit"),
    [(0.2, 0.136957), (0.3, 0.212523), (0.9, 0.9)],  # 0.9 x 1.2322 lies beyond overturning
)
def test_thesis_limit(slenderness: float, limit: float) -> None:
    branch = plain_branch(RockingBlock(500.0, 3.0, slenderness, 4.0 / 3.0 * 4500.0), restitution=0.9)
    assert asce43_05.thesis_limit(branch, mass=500.0) == pytest.approx(limit, rel=HAND)


@pytest.mark.parametrize(("share", "value"), [(asce43_05.HALF, 0.5), (asce43_05.THIRD, 0.333333)])
def test_shares_of_the_overturning_rotation(share: float, value: float) -> None:
    assert share == pytest.approx(value, rel=HAND)


@pytest.mark.parametrize(
    ("theta", "f_v", "in_g"),
    # S_a / PGA = 1 / T with T = 1 / f_e: 2.31681 s at 0.1 rad, 4.01283 s at 0.2 rad
    [(0.1, 1.0, 0.695043), (0.1, 1.25, 0.556034), (0.2, 1.0, 0.802566)],
)
def test_spectral_pga_rotation(theta: float, f_v: float, in_g: float) -> None:
    curve = asce43_05.spectral_pga_rotation(STRAIGHT, SPECTRUM, damping=0.05, f_v=f_v, uplift=0.15 * g)
    assert curve.pga_of(np.array([theta])) / g == pytest.approx([in_g], rel=HAND)
    assert curve.least[0] >= 0.15 * g
    assert curve.complete


@pytest.mark.parametrize(
    ("theta", "pga", "in_g"),
    # the floor's ordinates belong to a ground of 0.1 g: S_a / PGA = 2 / T; to one of 0.2 g: 1 / T
    [(0.1, 0.1, 0.347521), (0.2, 0.1, 0.401283), (0.1, 0.2, 0.695043)],
)
def test_floor_spectral_pga_rotation(theta: float, pga: float, in_g: float) -> None:
    curve = asce43_05.floor_spectral_pga_rotation(
        STRAIGHT, SPECTRUM, damping=0.05, f_v=1.0, uplift=0.3 * g, pga=pga * g
    )
    assert curve.pga_of(np.array([theta])) / g == pytest.approx([in_g], rel=HAND)
    assert curve.least[0] / g == pytest.approx(0.3 * pga / 0.2, rel=1e-9)  # uplift of the floor, at the ground
    assert curve.falls_again


@pytest.mark.parametrize(
    ("mu", "vertical", "effective"), [(0.5, 0.0, 0.5), (0.5, 0.5, 0.4), (0.3, 1.0, 0.18), (0.3, 3.0, 0.0)]
)
def test_effective_friction(mu: float, vertical: float, effective: float) -> None:
    """mu (1 - 0.4 A_v / g), not below 0 (A-1); A_v in g."""
    assert sliding.effective_friction(mu, vertical=vertical * g) == pytest.approx(effective, abs=1e-12)


@pytest.mark.parametrize(("share", "friction"), [(1.0, 0.6), (0.5, 0.3), (0.25, 0.15)])
def test_friction_of_all(share: float, friction: float) -> None:
    """Of the mass that slides only a share presses on the base."""
    found = sliding.friction_of_all(0.6, normal=share * MASS * g, mass=MASS)
    assert found == pytest.approx(friction, rel=1e-12)


@pytest.mark.parametrize(("friction", "coefficient"), [(0.25, 4.903325), (0.5, 9.80665), (0.0, 0.0)])
def test_sliding_coefficient(friction: float, coefficient: float) -> None:
    assert sliding.sliding_coefficient(friction) == pytest.approx(coefficient, rel=1e-12)


@pytest.mark.parametrize(
    ("coefficient", "frequency", "distance"),
    [(4.0 * pi**2, 1.0, 1.0), (3.92266, 0.5, 0.397450), (3.92266, 1.0, 0.0993625)],  # 3.92266 / pi^2; a quarter
)
def test_sliding_distance(coefficient: float, frequency: float, distance: float) -> None:
    found = sliding.sliding_distance(coefficient, frequency=frequency)
    assert found == pytest.approx(distance, rel=HAND)


TABLE = table_spectrum([0.0, 0.1, 0.5, 4.0], np.array([0.4, 1.0, 1.0, 0.125]) * g)  # at 10 %: times 0.816497
ON_TABLE = Context(TABLE, (0.4 * g,), 0.0, 0.0, None)


@pytest.mark.parametrize(
    ("level", "coefficient", "period"),
    [
        (0.4, 0.4, 2.540408),  # 0.5 + (1 - 0.4 / 0.816497) / 0.875 x 3.5
        (0.8, 0.8, 2.540408),  # both doubled
        (0.4, 0.9, 0.0),  # above the plateau of 0.816497 g
        (0.4, 0.1, None),  # below the last ordinate, 0.102062 g
    ],
)
def test_longest_period(level: float, coefficient: float, period: float | None) -> None:
    found = sliding.longest_sliding_period(ON_TABLE, level * g, coefficient * g)
    assert found == (None if period is None else pytest.approx(period, rel=HAND))


@pytest.mark.parametrize(
    ("level", "mu", "distance"),
    [(0.4, 0.2, 0.641249), (0.8, 0.4, 1.282498), (0.4, 0.5, 0.0), (0.4, 0.05, None), (0.4, 0.0, None)],
)  # 0.4 g (2.540408 / 2 pi)^2
def test_best_estimate(level: float, mu: float, distance: float | None) -> None:
    found = sliding.sliding_estimate(ON_TABLE, level * g, mu)
    assert found == (None if distance is None else pytest.approx(distance, rel=HAND))


@pytest.mark.parametrize(("mu", "allowable", "in_g"), [(0.2, 0.641249, 0.4), (0.4, 1.282498, 0.8)])
def test_pga_at(mu: float, allowable: float, in_g: float) -> None:
    """The PGA that slides the body as far as in `test_best_estimate`."""
    found = sliding.capacity_pga(ON_TABLE, mu, allowable)
    assert found is not None
    assert found / g == pytest.approx(in_g, rel=1e-4)  # sliding grows faster than PGA here


def test_pga_at_is_not_known_without_friction() -> None:
    assert sliding.capacity_pga(GROUND, 0.0, 0.1) is None
