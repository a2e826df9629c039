"""A mechanism as it starts, breaks and collapses, against statics by hand."""

from __future__ import annotations

from dataclasses import replace
from math import asin, atan2, cos, hypot, inf, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import g
from scipy.integrate import quad
from scipy.optimize import brentq

from assess.codes.italian_kinematic import displacement_at_collapse
from assess.errors import FallingError
from assess.geometry.planar import planar_body
from assess.geometry.solid import box
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force, PointMass, Tie, lasts, mirror_load
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.mechanism import height_of_highest_tie, limits, open_seats
from assess.mechanisms.oscillators import collapse_branch
from assess.mechanisms.two_block import two_block
from assess.oscillator import interpolant, restoring_moment
from tests.support.bodies import pier, planar_box

T, L, H, RHO = 0.8, 2.0, 5.0, 1900.0
M = RHO * T * L * H
R, ALPHA = hypot(T / 2, H / 2), atan2(T, H)
WALL = planar_box(T, H, length=L, density=RHO)
TOP = (0.4, 4.5)  # straight above hinge A
THRUST = Force("thrust", (3000.0, 0.0), TOP)
INWARD = Tie("tie", 3000.0, TOP, direction=(-1.0, 0.0))
VOUCHED = replace(INWARD, until="collapse", strength=9000.0, length=8.0, fracture_strain=0.2, evidence="tests 2024")


def d0(rocker):
    return displacement_at_collapse(rocker.positive, mass=rocker.mass)


def on_joint(stiffness, *loads, strength=inf):
    joint = (Joint((-1.0, 0.0), rectangle(T, L), JointLaw(stiffness, strength), "flexible"),)
    return add_joints(pier(*loads), joint, joint, restitution=("thesis", "thesis"))


def test_a_thrust_beside_a_tie_of_its_size_collapses_as_the_thrust_alone():
    both, alone, none = pier(THRUST, INWARD).variants, pier(THRUST).variants, pier().variants
    assert d0(both.starting) == pytest.approx(d0(none.starting), rel=1e-12)
    assert d0(both.collapse) == d0(alone.collapse) == d0(alone.starting)
    np.testing.assert_array_equal(both.collapse.positive.restoring, alone.starting.positive.restoring)
    np.testing.assert_array_equal(both.breaking.positive.restoring, alone.starting.positive.restoring)
    np.testing.assert_array_equal(both.collapse.negative.restoring, none.starting.negative.restoring)


@pytest.mark.parametrize("until", [None, 0.05, 5.0])
def test_a_tie_of_three_percent_of_the_weight_never_moves_d0(until):
    tie = replace(INWARD, pull=0.03 * M * g, until=until)
    assert d0(pier(tie).variants.collapse) == d0(pier().variants.collapse)
    assert d0(pier(tie).variants.starting) > 1.05 * d0(pier().variants.starting)


def test_a_tie_that_is_vouched_for_moves_d0_by_the_closed_form():
    """M g R sin(alpha - phi) + S h cos(phi) = 0; d0 is the way of the centroid, e* being 1."""
    phi = brentq(lambda p: M * g * R * sin(ALPHA - p) + 3000.0 * 4.5 * cos(p), 0.0, 1.0, xtol=1e-15)
    ways = pier(VOUCHED).variants
    assert ways.collapse is ways.starting is ways.breaking
    assert ways.collapse.positive.overturning == pytest.approx(phi, rel=1e-12)
    assert d0(ways.collapse) == pytest.approx(R * (sin(ALPHA) - sin(ALPHA - phi)), rel=1e-9)
    assert d0(ways.collapse) > d0(pier().variants.collapse)


@pytest.mark.parametrize("key", ["until", "strength", "length", "fracture_strain", "evidence"])
def test_a_tie_that_lacks_one_of_its_proofs_does_not_last(key):
    lacking = replace(VOUCHED, **{key: "" if key == "evidence" else None})
    assert lasts(VOUCHED)
    assert not lasts(lacking)
    assert lacking.missing == ("source" if key == "evidence" else key,)
    assert d0(pier(lacking).variants.collapse) == d0(pier().variants.collapse)


def test_a_tie_never_pulls_with_more_than_its_strength():
    weak = replace(VOUCHED, strength=1200.0)
    plain, held = pier().variants.starting.positive.restoring[0], pier(weak).variants.starting.positive.restoring[0]
    assert held - plain == pytest.approx(1200.0 * 4.5, rel=1e-12)


def test_the_moment_drops_by_that_of_the_tie_where_its_point_has_moved_so_far():
    """A point h above the hinge moves by 2 h sin(phi / 2)."""
    tie = replace(INWARD, until=0.1)
    ways, at = pier(tie).variants, 2 * asin(0.1 / (2 * 4.5))
    side = ways.breaking.positive
    jump = int(np.flatnonzero(np.diff(side.rotation) == 0.0)[0])
    assert side.rotation[jump] == pytest.approx(at, rel=1e-12)
    assert side.restoring[jump] - side.restoring[jump + 1] == pytest.approx(3000.0 * 4.5 * cos(at), rel=1e-11)
    np.testing.assert_allclose(side.restoring[jump + 1 :], M * g * R * np.sin(ALPHA - side.rotation[jump + 1 :]),
                               rtol=1e-10, atol=1e-9 * M * g)  # fmt: skip
    (limit,) = limits(pier(tie))
    assert (limit.kind, limit.what, limit.branch, limit.rotation) == ("break", "tie", "positive", side.rotation[jump])
    assert d0(ways.collapse) == d0(pier().variants.collapse)


def test_a_tie_breaks_where_it_has_lengthened_by_its_fracture_strain():
    """Level, it lengthens by h sin(phi): 0.225 m at 0.05 rad. It is no part of the curve of collapse then."""
    brittle = replace(VOUCHED, length=4.5 * sin(0.05) / 0.1, fracture_strain=0.1)
    side = pier(brittle).variants.breaking.positive
    assert side.rotation[np.flatnonzero(np.diff(side.rotation) == 0.0)] == pytest.approx([0.05], rel=1e-12)
    np.testing.assert_array_equal(
        pier(brittle).variants.collapse.positive.restoring, pier().variants.starting.positive.restoring
    )
    assert [limit.rotation for limit in limits(pier(brittle))] == pytest.approx([0.05], rel=1e-12)


def test_towards_an_anchor_it_lengthens_as_the_distance_does():
    anchor, elongation = (-3.0, 4.0), 0.12
    tie = replace(VOUCHED, direction=None, anchor=anchor, length=elongation / 0.05, fracture_strain=0.05)
    length = lambda phi: hypot(anchor[0] - (0.4 + 4.5 * sin(phi)), anchor[1] - 4.5 * cos(phi))  # noqa: E731
    at = brentq(lambda phi: length(phi) - length(0.0) - elongation, 0.0, 0.3, xtol=1e-15)
    assert [limit.rotation for limit in limits(pier(tie))] == pytest.approx([at], rel=1e-11)


def test_a_tie_that_breaks_as_the_wall_would_fall_without_it_ends_the_curve_there():
    """Beyond the block's own overturning only the tie holds: the curve of collapse ends where it breaks."""
    at = 1.02 * ALPHA
    tie = replace(VOUCHED, pull=9000.0, length=4.5 * sin(at) / 0.1, fracture_strain=0.1)
    ways = pier(tie).variants
    assert ways.collapse.positive.overturning == pytest.approx(at, rel=1e-12)
    assert ways.starting.positive.overturning > 1.05 * at
    assert ways.collapse.positive.restoring[0] == ways.starting.positive.restoring[0]


def test_without_ties_and_resisting_forces_the_three_are_one_object():
    for ways in (
        pier().variants,
        pier(PointMass("floor", 900.0, (0.2, 4.0), True)).variants,
        pier(THRUST, sides="one").variants,
    ):
        assert ways.starting is ways.breaking is ways.collapse


def test_a_force_that_resists_and_is_not_shown_to_last_leaves_and_a_weight_that_stays_does_not():
    weight = Force("beam", (0.0, -5000.0), (-0.1, 5.0))
    stays = replace(weight, until="collapse", evidence="a weight, which stays")
    kept = pier(stays).variants
    assert kept.collapse is kept.starting
    assert pier(weight).variants.collapse.positive.restoring[0] == pier().variants.starting.positive.restoring[0]
    assert d0(pier(weight).variants.collapse) < d0(
        pier().variants.collapse
    )  # it drives once it has passed over the hinge


def test_a_force_acts_where_it_drives_and_not_where_it_resists():
    """A load h above and in front of the hinge drives down from the start; behind it, only once it has passed over."""
    behind = Force("beam", (0.0, -9000.0), (0.1, 4.0))
    over = atan2(0.3, 4.0)  # where it stands over hinge A
    side, plain = pier(behind).variants.collapse.positive, pier().variants.collapse.positive
    rotation = np.linspace(0.0, side.overturning, 41)
    moment = 9000.0 * hypot(0.3, 4.0) * np.sin(rotation - over)
    expected = restoring_moment(plain, rotation) - np.maximum(moment, 0.0)
    np.testing.assert_allclose(restoring_moment(side, rotation), expected, rtol=0.0, atol=1e-8 * M * g)
    assert side.rotation[np.flatnonzero(np.diff(side.rotation) == 0.0)] == pytest.approx([over], rel=1e-9)


def test_a_mechanism_that_stands_by_such_a_tie_alone_has_no_curve_of_collapse():
    heavy, holding = Force("thrust", (30000.0, 0.0), TOP), replace(INWARD, pull=20000.0)
    ways = pier(heavy, holding).variants
    assert (ways.breaking, ways.collapse, ways.depends_on) == (None, None, ("tie",))
    assert ways.deciding is ways.starting
    assert limits(pier(heavy, holding)) == ()
    breaking = pier(heavy, replace(holding, until=0.1)).variants
    assert breaking.breaking is not None
    assert breaking.collapse is None


def test_what_rests_on_a_seat_that_is_not_given_moves_with_its_own_point():
    held = PointMass("held", 900.0, TOP, True, seat=0.12)
    found = {each.branch: each for each in open_seats(pier(PointMass("floor", 900.0, TOP, True), held))}
    assert {each.what for each in found.values()} == {"floor"}
    positive, negative = found["positive"], found["negative"]
    assert positive.travel == pytest.approx(4.5 * np.sin(positive.rotation), abs=1e-12)
    r, start = hypot(0.8, 4.5), atan2(0.8, 4.5)  # about the other hinge
    assert negative.travel == pytest.approx(r * np.abs(sin(start) - np.sin(start - negative.rotation)), abs=1e-12)


def test_seats_are_lost_where_the_point_has_moved_sideways_by_them():
    floor = PointMass("floor", 900.0, TOP, True, seat=0.12)
    loose = PointMass("pushes", 900.0, TOP, False, seat=0.12)
    seats = {(limit.kind, limit.branch): limit.rotation for limit in limits(pier(floor, loose))}
    assert seats["seat", "positive"] == pytest.approx(asin(0.12 / 4.5), rel=1e-12)
    r, start = hypot(0.8, 4.5), atan2(0.8, 4.5)  # about the other hinge
    assert seats["seat", "negative"] == pytest.approx(start - asin(sin(start) - 0.12 / r), rel=1e-11)
    assert len(seats) == 2


CASES = [
    (THRUST, replace(INWARD, until=0.15)),
    (THRUST, VOUCHED, replace(INWARD, both=True)),
    (Force("beam", (500.0, -9000.0), (0.1, 4.0)), Tie("stay", 2000.0, (-0.2, 3.0), anchor=(-4.0, 5.0), until=0.2)),
]


@pytest.mark.parametrize("loads", CASES)
def test_the_mirror_image_has_the_branches_of_the_other_side(loads):
    one, two = pier(*loads).variants, pier(*(mirror_load(load) for load in loads)).variants
    for name in ("starting", "breaking", "collapse"):
        a, b = getattr(one, name), getattr(two, name)
        for here, there in ((a.positive, b.negative), (a.negative, b.positive)):
            np.testing.assert_allclose(here.rotation, there.rotation, rtol=1e-12)
            np.testing.assert_allclose(here.restoring, there.restoring, rtol=0.0, atol=1e-9 * M * g)
    ends = {(each.what, each.branch): each.rotation for each in limits(pier(*loads))}
    other = {(each.what, each.branch): each.rotation for each in limits(pier(*(mirror_load(load) for load in loads)))}
    assert {(what, {"positive": "negative", "negative": "positive"}[branch]) for what, branch in ends} == set(other)


PROVEN = {"until": "collapse", "strength": 1e4, "length": 20.0, "fracture_strain": 0.2, "evidence": "tests"}


@st.composite
def ties(draw):
    """A tie with no end, an end on the way, or none before collapse."""
    at, away = (draw(st.floats(-0.4, 0.4)), draw(st.floats(1.0, 5.0))), -draw(st.floats(1.0, 6.0))
    proof = draw(st.sampled_from([{}, PROVEN]) | st.floats(0.02, 0.4).map(lambda until: {"until": until}))
    return replace(Tie("tie", draw(st.floats(200.0, 1500.0)), at, anchor=(away, at[1])), **proof)


@given(added=st.lists(ties(), min_size=1, max_size=4))
def test_more_ties_never_worsen_any_of_the_three(added):
    """One after the other."""
    loads = [Force("thrust", (2000.0, -500.0), (0.0, 4.0))]
    before = pier(*loads).variants
    for number, tie in enumerate(added):
        loads.append(replace(tie, name=f"tie {number}"))
        now = pier(*loads).variants
        for name in ("starting", "breaking", "collapse"):
            was, side = getattr(before, name).positive, getattr(now, name).positive
            rotation = np.linspace(0.0, was.overturning, 301)[1:-1]
            jumps = np.concatenate([each.rotation[1:][np.diff(each.rotation) == 0.0] for each in (was, side)])
            clear = np.abs(rotation[:, None] - jumps).min(axis=1, initial=1.0) > 1e-9
            gain = restoring_moment(side, rotation[clear]) - restoring_moment(was, rotation[clear])
            assert gain.min() > -1e-8 * M * g
            assert side.overturning > was.overturning * (1.0 - 1e-12)
        before = now


def test_a_wall_of_two_blocks_with_a_tie_that_breaks():
    half = {"thickness": 0.4, "length": 1.0, "density": RHO, "name": "half"}
    low = planar_body(box(height=2.5, base=(0, 0, 0), **half), direction=(1, 0, 0))
    high = planar_body(box(height=1.5, base=(0, 0, 2.5), **half), direction=(1, 0, 0))
    hinges = {
        "hinges": ((0.2, 0.0), (-0.2, 2.5), (0.2, 4.0)),
        "hinges_negative": ((-0.2, 0.0), (0.2, 2.5), (-0.2, 4.0)),
    }
    tie = Tie("tie", 500.0, (0.2, 2.0), direction=(-1.0, 0.0), until=0.08)
    ways, plain = (
        two_block("w", low, high, loads=(tie,), **hinges).variants,
        two_block("w", low, high, **hinges).variants,
    )
    side, at = ways.breaking.positive, 2 * asin(0.08 / (2 * 2.0))
    assert side.rotation[np.flatnonzero(np.diff(side.rotation) == 0.0)] == pytest.approx([at], rel=1e-12)
    assert side.restoring[0] - plain.starting.positive.restoring[0] == pytest.approx(500.0 * 2.0, rel=1e-12)
    after = restoring_moment(plain.starting.positive, np.array(1.1 * at))
    assert restoring_moment(side, np.array(1.1 * at)) == pytest.approx(float(after), rel=1e-9)


def test_on_stiff_joints_the_variants_tend_to_the_rigid_ones():
    loads = (THRUST, replace(INWARD, pull=6000.0, until=0.15), Force("beam", (0.0, -4000.0), (-0.1, 5.0)))
    rigid, distance = pier(*loads).variants, []
    for stiffness in (1e10, 1e11, 1e12):
        soft = on_joint(stiffness, *loads).variants
        shares = [
            getattr(soft, name).positive.unstable / getattr(rigid, name).positive.overturning - 1.0
            for name in ("starting", "breaking", "collapse")
        ]
        distance.append(np.abs(shares).max())
    assert distance[1] < 0.4 * distance[0]  # the resultant comes to the edge with the root of the stiffness
    assert distance[2] < 0.4 * distance[1] < 2e-3


def test_on_joints_it_drops_by_the_tie_too_and_normal_forces_follow():
    """A stay that pulls down presses on the joint; as it goes, the resultant moves, so more goes than its moment."""
    stay = Tie("stay", 9000.0, (-0.4, 4.5), direction=(0.0, -1.0), until=0.1)
    side = on_joint(1e9, stay).variants.breaking.positive
    plain = on_joint(1e9).variants.starting.positive
    jumps = (np.diff(side.rotation) == 0.0) & (np.abs(np.diff(side.restoring)) > 1.0)
    (jump,) = np.flatnonzero(jumps & (side.rotation[1:] < side.unstable))
    assert side.rotation[jump] == pytest.approx(2 * asin(0.1 / (2 * hypot(0.8, 4.5))), rel=1e-12)
    after = interpolant(plain.rotation, plain.restoring)(side.rotation[jump + 1])
    assert side.restoring[jump + 1] == pytest.approx(float(after), rel=1e-5)
    assert side.restoring[jump] > side.restoring[jump + 1]


@pytest.mark.parametrize("at", [0.3, 0.39, 0.399])
def test_a_weight_that_crushes_the_joint_does_not_leave_to_make_the_wall_stand_longer(at):
    """Near the edge it resists by its lever, and takes more by what it presses with."""
    weight = Force("beam", (-500.0, -40000.0), (at, 3.4))
    ways = on_joint(1e9, weight, strength=5e5).variants
    for name in ("breaking", "collapse"):
        for side, first in zip(getattr(ways, name).branches, ways.starting.branches, strict=True):
            assert side.unstable <= first.unstable * (1.0 + 1e-6)


def test_one_chain_alone_has_the_same_curve_of_collapse():
    brittle = replace(VOUCHED, length=2.0, fracture_strain=0.1)
    for loads in ((THRUST, INWARD), (THRUST, VOUCHED), (brittle,)):
        mechanism = pier(*loads)
        side = collapse_branch(on_joint(1e9, *loads).positive, name="w")
        np.testing.assert_array_equal(side.restoring, mechanism.variants.collapse.positive.restoring)
    with pytest.raises(FallingError):
        collapse_branch(pier(Force("thrust", (30000.0, 0.0), TOP), replace(INWARD, pull=20000.0)).positive, name="w")


def test_the_highest_tie_that_lasts_holds_the_wall():
    low, slack = replace(VOUCHED, name="low", at=(0.4, 2.0)), replace(VOUCHED, name="slack", direction=(-1.0, 0.0))
    assert height_of_highest_tie(pier(low)) == 2.0
    assert height_of_highest_tie(pier(low, slack)) == 4.5
    assert height_of_highest_tie(pier(INWARD, THRUST)) == 0.0
    assert height_of_highest_tie(pier(replace(low, until=0.1, length=None))) == 2.0


def test_work_up_to_overturning_is_that_of_weights_and_tie_before_and_after_the_break():
    tie = replace(INWARD, pull=8000.0, until=0.2)
    side, at = pier(tie).variants.breaking.positive, 2 * asin(0.2 / (2 * 4.5))
    expected = M * g * (R - H / 2) + 8000.0 * 4.5 * sin(at)
    spline = interpolant(side.rotation, side.restoring)
    assert float(spline.integrate(0.0, ALPHA)) == pytest.approx(expected, rel=1e-10)
    by_parts = quad(lambda p: float(spline(p)), 0.0, at)[0] + quad(lambda p: float(spline(p)), at, ALPHA)[0]
    assert by_parts == pytest.approx(expected, rel=1e-8)
