"""Loads on a single block against statics, the thesis' closed forms (3.21-3.26) and finite differences."""

from __future__ import annotations

from math import atan2, cos, hypot, sin

import numpy as np
import pytest
from scipy.constants import g

from assess.errors import MechanismError
from assess.geometry.planar import join_planar, planar_body_from_values
from assess.loads.load import Force, PointMass, Tie, pull_at_rest
from assess.mechanisms.chain import Chain, RigidBlock, require_stable
from assess.mechanisms.single_block import single_block
from assess.oscillator import multiplier, participation_ratio, restoring_moment
from tests.support.bodies import pier, planar_box

T, L, H, RHO = 0.8, 2.0, 5.0, 1900.0
WALL = planar_box(T, H, length=L, density=RHO)
M = RHO * T * L * H
FLOOR = PointMass("floor", 900.0, (0.2, 4.0), True)
ROOF = PointMass("roof", 400.0, (-0.1, 4.8), False)
THRUST = Force("thrust", (3000.0, 0.0), (-0.4, 3.5))


def polar(at):
    """Distance from hinge A of a point, and its angle from the vertical towards the body."""
    return hypot(T / 2 - at[0], at[1]), atan2(T / 2 - at[0], at[1])


def test_static_multiplier_by_moments_about_the_hinge():
    tie = Tie("tie", 5000.0, (0.4, 4.5), direction=(-1.0, 0.0))
    branch = pier(FLOOR, ROOF, THRUST, tie).oscillator.positive
    resisting = M * g * T / 2 + 900 * g * (T / 2 - 0.2) + 5000 * 4.5 - 3000 * 3.5
    driving = M * g * H / 2 + 900 * g * 4.0 + 400 * g * 4.8
    assert multiplier(branch)[0] == pytest.approx(resisting / driving, rel=1e-12)


def test_thesis_closed_form_with_bearing_mass_and_force():
    """3.22, 3.24-3.26: K, M, phi_cr and phi_ov; 3.21 for I."""
    branch = pier(FLOOR, THRUST).oscillator.positive
    linear = branch.linearised
    total = M + 900.0
    centre = tuple((M * wall + 900.0 * floor) / total for wall, floor in zip((0.0, H / 2), FLOOR.at, strict=True))
    (R_c, alpha_c), (R_f, alpha_f), (R_i, _) = polar(centre), polar(THRUST.at), polar(FLOOR.at)
    K = g * total * R_c + 3000.0 * R_f * sin(alpha_f - alpha_c)
    moment = 3000.0 * R_f * cos(alpha_f - alpha_c)
    assert linear.critical == pytest.approx(alpha_c, rel=1e-12)
    assert linear.stiffness == pytest.approx(K, rel=1e-8)
    assert linear.moment == pytest.approx(moment, rel=1e-8)
    assert linear.overturning == pytest.approx(alpha_c - moment / K, rel=1e-8)
    assert linear.inertia == pytest.approx(WALL.inertia + M * hypot(T / 2, H / 2) ** 2 + 900.0 * R_i**2, rel=1e-12)
    assert branch.overturning < alpha_c  # exact, and near the linearised one
    assert branch.overturning == pytest.approx(linear.overturning, rel=2e-3)


def test_mass_that_is_not_bearing_has_horizontal_inertia_and_no_weight():
    plain, loaded = pier().oscillator.positive, pier(ROOF).oscillator.positive
    R, alpha = polar(ROOF.at)
    across = R * np.cos(alpha - loaded.rotation)  # x' of the mass
    np.testing.assert_allclose(loaded.restoring, restoring_moment(plain, loaded.rotation), rtol=1e-9, atol=1e-6 * M)
    np.testing.assert_allclose(loaded.inertia - plain.inertia[0], 400.0 * across**2, rtol=1e-9)
    np.testing.assert_allclose(loaded.participation[0] - plain.participation[0], 400.0 * across[0] ** 2, rtol=1e-9)
    assert pier(ROOF).oscillator.mass == M + 400.0
    assert participation_ratio(loaded, mass=M + 400.0) < 1.0


def test_bearing_mass_is_a_small_heavy_body_welded_on():
    heavy = planar_body_from_values(mass=900.0, centroid=FLOOR.at, inertia=0.0, name="floor")
    welded = join_planar([WALL, heavy], name="w")
    one, two = (
        pier(FLOOR).oscillator,
        single_block("w", welded, hinge=(0.4, 0.0), hinge_negative=(-0.4, 0.0)).oscillator,
    )
    for side in ("positive", "negative"):
        a, b = getattr(one, side), getattr(two, side)
        np.testing.assert_allclose(a.restoring, b.restoring, rtol=1e-12, atol=1e-9 * M * g)
        np.testing.assert_allclose(a.inertia, b.inertia, rtol=1e-12)
        np.testing.assert_allclose(a.excitation, b.excitation, rtol=1e-12)
        assert a.restitution == pytest.approx(b.restitution, rel=1e-12)
    assert one.mass == two.mass


def test_restoring_moment_is_the_slope_of_the_work_of_weights_forces_and_tie():
    tie = Tie("tie", 8000.0, (0.4, 4.5), anchor=(-3.0, 4.0))
    branch = pier(FLOOR, THRUST, tie).oscillator.positive
    hinge = np.array([0.4, 0.0])

    def moved(at, phi):
        x, z = at[0] - hinge[0], at[1]
        return hinge + np.array([x * np.cos(phi) + z * np.sin(phi), -x * np.sin(phi) + z * np.cos(phi)])

    def potential(phi):
        weights = g * (M * moved((0.0, H / 2), phi)[1] + 900.0 * moved(FLOOR.at, phi)[1])
        length = np.linalg.norm(np.array([-3.0, 4.0]) - moved((0.4, 4.5), phi))
        return weights - 3000.0 * moved(THRUST.at, phi)[0] + 8000.0 * length

    for phi in (0.01, 0.06, 0.12):
        slope = (potential(phi + 1e-5) - potential(phi - 1e-5)) / 2e-5
        assert restoring_moment(branch, np.array(phi)) == pytest.approx(slope, rel=1e-7)


def test_a_tie_is_slack_on_the_branch_where_it_shortens():
    tie = Tie("tie", 5000.0, (0.4, 4.5), direction=(-1.0, 0.0))
    plain, tied = pier().oscillator, pier(tie).oscillator
    assert tied.positive.restoring[0] == pytest.approx(plain.positive.restoring[0] + 5000 * 4.5, rel=1e-12)
    np.testing.assert_allclose(tied.negative.restoring, plain.negative.restoring, rtol=1e-12, atol=1e-6)
    both = pier(Tie("tie", 5000.0, (0.4, 4.5), direction=(-1.0, 0.0), both=True)).oscillator
    assert both.negative.restoring[0] == pytest.approx(plain.negative.restoring[0] - 5000 * 4.5, rel=1e-12)


def test_loads_mirror_with_the_direction():
    mirrored = PointMass("floor", 900.0, (-0.2, 4.0), True), Force("thrust", (-3000.0, 0.0), (0.4, 3.5))
    one, two = pier(FLOOR, THRUST).oscillator, pier(*mirrored).oscillator
    np.testing.assert_allclose(one.positive.restoring, two.negative.restoring, rtol=1e-14)
    np.testing.assert_allclose(one.negative.excitation, two.positive.excitation, rtol=1e-14)


def test_tables_reach_the_point_of_linearisation_under_a_strong_thrust():
    branch = pier(Force("thrust", (12000.0, 0.0), (0.0, 4.5)), sides="one").oscillator.positive
    assert branch.overturning < 0.5 * branch.critical < branch.critical < branch.rotation[-1]
    assert branch.linearised.overturning == pytest.approx(branch.overturning, rel=0.1)  # fitted far away, at phi_cr


@pytest.mark.parametrize(
    ("load", "words"),
    [
        (Force("thrust", (3e4, 0.0), (0.0, 4.5)), r'falling.* 1.35e\+05 N m: load "thrust" with H = 30 kN, V = \+0 kN'),
        (Tie("tie", 1e7, (0.4, 4.5), direction=(-0.6, 0.8)), "hinges and loads"),
        (PointMass("floor", 90000.0, (0.9, 4.0), True), "already falling in positive"),
    ],
)
def test_loads_that_leave_nothing_to_rock_are_refused(load, words):
    with pytest.raises(MechanismError, match=words):
        assert pier(load).oscillator


def test_pull_of_a_tie_at_rest():
    assert pull_at_rest(Tie("tie", 5000.0, (1.0, 4.0), anchor=(-3.0, 7.0))) == pytest.approx((-4000.0, 3000.0))
    assert pull_at_rest(Tie("tie", 5000.0, (1.0, 4.0), direction=(0.6, -0.8))) == pytest.approx((3000.0, -4000.0))


def test_hinges_on_the_wrong_faces_are_blamed_where_no_force_is_given():
    halves = (RigidBlock(1000.0, (0.0, 1.0), 350.0), RigidBlock(1000.0, (0.0, 3.0), 350.0))
    require_stable(Chain(halves, ((0.2, 0.0), (-0.2, 2.0), (0.2, 4.0))), name="wall")
    words = "no given force overturns it; check its hinges: A and C lie on the face ahead, B on the one behind"
    with pytest.raises(MechanismError, match=words):
        require_stable(Chain(halves, ((-0.2, 0.0), (0.2, 2.0), (-0.2, 4.0))), name="wall")
