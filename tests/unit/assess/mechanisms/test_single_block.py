"""The single block: kinematics, virtual work, hinges, restitution."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, hypot, pi, sin

import numpy as np
import pytest
from scipy.constants import g

from assess.errors import MechanismError
from assess.geometry.planar import join_planar, planar_body, planar_body_from_values
from assess.geometry.solid import box
from assess.mechanisms.chain import Chain, RigidBlock, move, trace_point, virtual_work
from assess.mechanisms.restitution import plain_block
from assess.mechanisms.single_block import equivalent_block, single_block
from assess.oscillator import energy, participation_ratio, restoring_moment
from assess.oscillator import equivalent_block as at_rest

WALL = {"thickness": 0.8, "length": 2.0, "height": 5.0, "base": (0.0, 0.0, 0.0), "density": 1900.0, "name": "wall"}


def wall_in_plane(direction=(1, 0, 0), **changes):
    return planar_body(box(**(WALL | changes)), direction=direction)


def test_rates_are_the_derivatives_of_the_turned_centroid():
    chain = Chain((RigidBlock(3.0, (-0.4, 2.1), 1.0),), ((0.3, 0.2),))
    behind, height = 0.7, 1.9
    rotation, step = np.array([0.0, 0.1, 0.4]), 1e-6

    def position(phi):
        return np.array([-behind * np.cos(phi) + height * np.sin(phi), behind * np.sin(phi) + height * np.cos(phi)])

    central = (position(rotation + step) - position(rotation - step)) / (2 * step)
    motion = trace_point(move(chain, rotation), block=0, at=(-0.4, 2.1))
    np.testing.assert_allclose(motion.dx, central[0], rtol=1e-8)
    np.testing.assert_allclose(motion.dz, central[1], rtol=1e-8)


def test_rectangle_has_the_closed_form_of_a_single_block():
    b, h = WALL["thickness"] / 2, WALL["height"] / 2
    R, alpha = hypot(b, h), atan2(b, h)
    rocker = single_block("w", wall_in_plane()).oscillator
    M, branch = rocker.mass, rocker.positive
    assert pytest.approx(1900 * 0.8 * 2.0 * 5.0) == M
    assert branch.overturning == pytest.approx(alpha, rel=1e-13)
    phi = np.linspace(0, 1.5 * alpha, 1000)
    np.testing.assert_allclose(restoring_moment(branch, phi), M * g * R * np.sin(alpha - phi), atol=1e-9 * M * g * R)
    np.testing.assert_allclose(
        energy(branch, phi), M * g * R * (np.cos(alpha - phi) - cos(alpha)), atol=1e-11 * M * g * R
    )
    np.testing.assert_allclose(branch.inertia, 4 / 3 * M * R**2, rtol=1e-12)
    linear = branch.linearised
    assert linear.p == pytest.approx(np.sqrt(3 * g / (4 * R)), rel=1e-9)  # Housner 1963
    assert linear.multiplier == pytest.approx(alpha, rel=1e-9)  # thesis 3.11: K phi_cr / (g B)
    assert linear.overturning == pytest.approx(alpha, rel=1e-12)
    assert participation_ratio(branch, mass=M) == pytest.approx(1.0, rel=1e-12)


def test_restoring_moment_is_the_derivative_of_the_potential():
    branch = single_block("w", wall_in_plane()).oscillator.positive
    phi, step = np.array([0.01, 0.05, 0.1]), 1e-5
    slope = (energy(branch, phi + step) - energy(branch, phi - step)) / (2 * step)
    np.testing.assert_allclose(slope, restoring_moment(branch, phi), rtol=1e-8)


def test_a_block_made_of_welded_parts_is_the_same_oscillator():
    lower = wall_in_plane(height=2.0)
    upper = wall_in_plane(height=3.0, base=(0.0, 0.0, 2.0))
    whole = single_block("w", wall_in_plane()).oscillator
    welded = single_block("w", join_planar([lower, upper], name="w")).oscillator
    for column in ("rotation", "inertia", "restoring", "excitation", "participation", "lift"):
        expected = getattr(whole.positive, column)
        np.testing.assert_allclose(
            getattr(welded.positive, column), expected, rtol=1e-12, atol=1e-9 * np.abs(expected).max()
        )


def test_a_leaning_block_has_two_different_branches_and_mirrors_with_its_direction():
    leaning = planar_body_from_values(mass=1000.0, centroid=(0.1, 2.0), inertia=900.0, name="leaning")
    mirrored = planar_body_from_values(mass=1000.0, centroid=(-0.1, 2.0), inertia=900.0, name="leaning")
    one = single_block("a", leaning, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0)).oscillator
    two = single_block("a", mirrored, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0)).oscillator
    assert one.positive.overturning < one.negative.overturning
    np.testing.assert_allclose(one.positive.restoring, two.negative.restoring, rtol=1e-14)
    np.testing.assert_allclose(one.negative.restoring, two.positive.restoring, rtol=1e-14)


def test_momentum_restitution_of_a_leaning_block_by_angular_momentum_about_the_new_hinge():
    body = planar_body_from_values(mass=1000.0, centroid=(0.1, 2.0), inertia=900.0, name="leaning")
    mechanism = single_block(
        "a", body, hinge=(0.5, 0.0), hinge_negative=(-0.6, 0.0), restitution=("momentum", "momentum")
    )
    r_old, r_new = np.array([0.1 - 0.5, 2.0]), np.array([0.1 + 0.6, 2.0])
    velocity = np.array([r_old[1], -r_old[0]])  # of the centroid for one unit of clockwise rotation
    about_new = 900.0 + 1000.0 * (r_new[1] * velocity[0] - r_new[0] * velocity[1])
    assert mechanism.restitution[0] == pytest.approx(about_new / (900.0 + 1000.0 * r_new @ r_new), rel=1e-12)


def test_default_hinges_of_a_sloping_base_are_its_ends_each_at_its_elevation():
    sloping = replace(wall_in_plane(), base=((-0.4, 1.0), (0.4, 1.3)))
    mechanism = single_block("w", sloping)
    assert mechanism.positive.hinges == ((0.4, 1.3),)
    assert mechanism.negative.hinges == ((0.4, 1.0),)  # mirrored
    assert mechanism.elevation == 1.3
    assert [text.split(" though")[0] for text in map(str, mechanism.warnings)] == ["restitution 1.011 is above 1"]
    r_old, r_new = np.array([-0.4, 1.2]), np.array([0.4, 1.5])  # hinge to centroid
    J = sloping.inertia
    about_new = J + sloping.mass * r_new @ r_old
    assert mechanism.restitution[0] == pytest.approx(about_new / (J + sloping.mass * r_new @ r_new), rel=1e-12)


@pytest.mark.parametrize(("hinge", "doubts"), [((0.1, 1.1875), 0), ((0.2, 1.225), 0), ((0.2, 1.0), 1), ((0.4, 1.4), 1)])
def test_a_given_hinge_is_looked_for_on_the_sloping_base(hinge, doubts):
    sloping = replace(wall_in_plane(), base=((-0.4, 1.0), (0.4, 1.3)))
    mechanism = single_block("w", sloping, hinge=hinge, sides="one", restitution=(0.5, 0.5))
    assert len(mechanism.warnings) == doubts
    assert all(
        "reaches from x = -0.4 m, z = 1 m to x = 0.4 m, z = 1.3 m" in text for text in map(str, mechanism.warnings)
    )


def test_momentum_is_housners_for_a_symmetric_block():
    housner = single_block("w", wall_in_plane(), restitution=("housner", "housner")).restitution
    momentum = single_block("w", wall_in_plane(), restitution=("momentum", "momentum")).restitution
    alpha = atan2(0.4, 2.5)
    assert housner == pytest.approx((1 - 1.5 * sin(alpha) ** 2,) * 2, rel=1e-12)  # Housner 1963
    assert momentum == pytest.approx(housner, rel=1e-12)


def test_equivalent_block_returns_itself():
    mechanism = equivalent_block("W0a", p=1.6, uplift=0.14, radius=2.84, mass=7.0)
    rocker = mechanism.oscillator
    block, linear = at_rest(rocker.positive, mass=7.0), rocker.positive.linearised
    assert (linear.p, linear.multiplier) == pytest.approx((1.6, 0.14), rel=1e-9)
    assert (block.radius, block.slenderness, block.mass) == pytest.approx((2.84, 0.14, 7.0), rel=1e-12)
    assert rocker.positive.overturning == pytest.approx(0.14, rel=1e-12)


def test_direction_picks_the_hinge_and_the_slenderness():
    across = single_block("w", wall_in_plane((0, -1, 0)))
    assert across.positive.hinges[0] == pytest.approx((1.0, 0.0))
    assert plain_block(across.positive).slenderness == pytest.approx(atan2(1.0, 2.5), rel=1e-12)


def test_one_sided_rocking_rebounds_by_sorrentinos_formula():
    mechanism = single_block("w", wall_in_plane(), sides="one")
    s, c = sin(atan2(0.4, 2.5)) ** 2, cos(atan2(0.4, 2.5)) ** 2
    signed = (1 - 1.5 * s) ** 2 * (1 - 1.5 * c)
    assert signed < 0
    assert mechanism.restitution[0] == pytest.approx(-signed, rel=1e-12)
    assert mechanism.oscillator.negative is None


def test_one_sided_stocky_block_does_not_rebound_and_says_so():
    mechanism = single_block("w", wall_in_plane(thickness=4.9), sides="one")
    assert mechanism.restitution[0] == 0.0
    assert "no rebound" in str(mechanism.warnings[0])


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: single_block("w", wall_in_plane(), hinge=(-0.1, 0.0)), "already falling in positive"),
        (lambda: single_block("w", wall_in_plane(), hinge_negative=(0.1, 0.0)), "already falling in negative"),
        (lambda: single_block("w", wall_in_plane(), hinge=(0.4, 3.0)), "below the hinge"),
        (lambda: single_block("w", wall_in_plane(), restitution=("sorrentino", "thesis")), "sides"),
        (lambda: single_block("w", wall_in_plane(), sides="one", restitution=("housner", "thesis")), "sides"),
        (
            lambda: single_block("w", planar_body_from_values(mass=1.0, centroid=(0.0, 1.0), inertia=0.1, name="w")),
            "give hinges",
        ),
    ],
)
def test_what_cannot_rock_is_refused_with_its_reason(make, words):
    with pytest.raises(MechanismError, match=words):
        make()


def test_virtual_work_of_a_block_at_its_overturning_rotation_vanishes():
    chain = single_block("w", wall_in_plane()).positive
    alpha = atan2(0.4, 2.5)
    work = virtual_work(chain, np.array([0.0, alpha, pi / 2]))
    assert work.weight[1] == pytest.approx(0.0, abs=1e-9 * work.weight[0])
    assert work.excitation[1] == pytest.approx(15200.0 * hypot(0.4, 2.5), rel=1e-12)


def test_a_restitution_above_one_says_that_energy_is_kept():
    """Onto a hinge 1.5 m higher: the angular momentum about it is kept, and turns a smaller inertia."""
    m, J, height, half = 1000.0, 600.0, 2.0, 0.3
    body = planar_body_from_values(mass=m, centroid=(0.0, height), inertia=J, name="b")
    mechanism = single_block(
        "b", body, hinge=(half, 0.0), hinge_negative=(-half, 1.5), restitution=("momentum", "momentum")
    )
    old, new = J + m * (height**2 + half**2), J + m * ((height - 1.5) ** 2 + half**2)
    eta = (J + m * (height * (height - 1.5) - half**2)) / new
    assert mechanism.restitution[0] == pytest.approx(eta, rel=1e-12)
    (told,) = [text for text in map(str, mechanism.warnings) if "restitution" in text]
    assert told.startswith(f"restitution {eta:.4g} is above 1 though energy is lost")
    assert told.endswith(f"keeps {100 * eta**2 * new / old:.3g} % of the energy")


def test_a_block_that_is_the_same_both_ways_has_one_branch():
    assert single_block("w", wall_in_plane()).oscillator.symmetric
    leaning = planar_body_from_values(mass=1000.0, centroid=(0.1, 2.0), inertia=900.0, name="leaning")
    assert not single_block("a", leaning, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0)).oscillator.symmetric


@pytest.mark.parametrize(("off", "symmetric"), [(1e-15, True), (1e-9, False)])
def test_rounding_does_not_make_two_branches_of_one(off, symmetric):
    body = planar_body_from_values(mass=1000.0, centroid=(off, 2.0), inertia=900.0, name="w")
    both = single_block("a", body, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0)).oscillator
    assert both.symmetric == symmetric
    np.testing.assert_allclose(both.negative.restoring, both.positive.restoring, rtol=1e-7, atol=1e-6)
