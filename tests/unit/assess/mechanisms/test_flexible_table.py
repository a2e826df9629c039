"""Oscillators on flexible joints: where they rest, what their tables hold, against closed forms of rectangles."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from math import asin, atan2, cos, hypot, inf, pi, sin, sqrt

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import quad
from scipy.optimize import brentq

from assess.errors import MechanismError
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force, PointMass, mirror_load
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.two_block import two_block
from assess.oscillator import (
    block_at,
    elastic_frequency,
    energy,
    equivalent_block,
    interpolant,
    linear_multiplier,
    multiplier,
    restoring_moment,
)
from tests.support.bodies import body_of_block, rectangle_block, wall_on_joints

B, H, L, RHO = 1.0, 6.0, 2.0, 1800.0
block_of = partial(rectangle_block, length=L)
MASS = B * H * L * RHO
W = MASS * g
LAW = JointLaw(2e8, 1.5e6)
THESIS = ("thesis", "thesis")


def wall(*, law=LAW, size=1.0, **more):
    """A wall of 1 x 6 x 2 m, times `size`, on a level joint."""
    return wall_on_joints(size * B, size * H, law, length=size * L, restitution=THESIS, **more)


def chain_of(blocks, front, back, ways, *, over=0.0, depth, law=LAW, model="flexible"):
    """Level joints; over: a force down through the hinge at the top of a wall, whichever way it moves."""
    bodies = [body_of_block(each) for each in blocks]
    joints = tuple(Joint((float(way), 0.0), rectangle(depth, L), law, model) for way in ways)
    if len(bodies) == 2:
        rigid = two_block("m", *bodies, hinges=front, hinges_negative=back)
        loads = (Force("overburden", (0.0, -over), front[2], 1),)
        rigid = replace(rigid, positive=replace(rigid.positive, loads=loads),
                        negative=replace(rigid.negative, loads=loads))  # fmt: skip
    else:
        rigid = four_hinge("m", bodies, hinges=front, hinges_negative=back)
    return add_joints(rigid, joints, joints, restitution=("momentum", "momentum"))


def storey(**more):
    """A wall between floors, cracked at 2.4 m of 4 m."""
    halves = block_of(-0.25, 0.0, 0.5, 2.4), block_of(-0.25, 2.4, 0.5, 1.6)
    edges = ((0.25, 0.0), (-0.25, 2.4), (0.25, 4.0)), ((-0.25, 0.0), (0.25, 2.4), (-0.25, 4.0))
    return chain_of(halves, *edges, (-1, 1, -1), over=4e4, depth=0.5, **more)


def portal(**more):
    legs = block_of(-0.3, 0.0, 0.6, 3.0), block_of(-0.3, 3.0, 5.2, 0.7), block_of(4.3, 0.0, 0.6, 3.0)
    front = ((0.3, 0.0), (-0.3, 3.0), (4.3, 3.0), (4.9, 0.0))
    back = ((-0.3, 0.0), (0.3, 3.0), (4.9, 3.0), (4.3, 0.0))
    return chain_of(legs, front, back, (-1, 1, 1, -1), depth=0.6, **more)


ALL = {
    "wall": wall(),
    "elastic wall": wall(law=JointLaw(2e8, inf)),
    "stiff wall": wall(law=JointLaw(1e11, 1.5e6)),
    "semi-flexible wall": wall(model="semi-flexible"),
    "wall leaning under a load": wall(loads=(Force("F", (0.0, -5e4), (0.2, 5.5)),)),
    "wall on one side": wall(sides="one"),
    "storey": storey(),
    "portal": portal(),
}
EVERY = pytest.mark.parametrize("mechanism", ALL.values(), ids=ALL)


# ---------------------------------------------------------------------------------------------------- closed forms


def shift(phi, *, N=W, law=LAW):
    """a_f of the rectangle by thesis 6.2-6.7, turned by phi, of which sin phi is the slope of its closing."""
    k, f, s = law.stiffness, law.strength, sin(phi)
    if s <= 2 * N / (k * B**2 * L):  # full contact
        return B / 2 - k * s * L * B**3 / (12 * N)
    if f == inf or s <= f**2 * L / (2 * k * N):
        return sqrt(2 * N / (k * s * L)) / 3
    return (N / (f * L) + f**3 * L / (12 * k**2 * s**2 * N)) / 2


def moment(phi, *, law=LAW):
    """W [R0 sin(alpha - phi) - a_f cos phi] (thesis 6.54)."""
    return W * (hypot(B / 2, H / 2) * sin(atan2(B, H) - phi) - shift(phi, law=law) * cos(phi))


def test_moments_of_a_wall_are_the_closed_forms_of_the_thesis():
    side = wall().oscillator.positive
    phi = side.rotation[1:]
    expected = [moment(each) for each in phi]
    np.testing.assert_allclose(side.restoring[1:], expected, rtol=0, atol=1e-11 * W)
    assert side.overturning == pytest.approx(atan2(B, H), rel=1e-12)
    assert side.overturning_flexible == pytest.approx(brentq(moment, 0.05, 0.2, xtol=1e-14), rel=1e-8)


def test_tables_have_a_kink_where_the_joint_opens_and_where_it_begins_to_crush():
    rotation = wall().oscillator.positive.rotation
    kinks = rotation[:-1][np.diff(rotation) == 0.0]
    k, f = LAW.stiffness, LAW.strength
    opening, crushing = asin(2 * W / (k * B**2 * L)), asin(f**2 * L / (2 * k * W))  # 6.2, 6.4
    np.testing.assert_allclose(kinks, [opening, crushing], rtol=1e-9)


def test_moments_are_stationary_through_the_kinks_of_the_table():
    """The moment and its slope are continuous there; only curvature jumps, so two nodes at one place are no jump."""
    side = wall().oscillator.positive
    twice = np.flatnonzero(np.diff(side.rotation) == 0.0)
    for column in (side.restoring, side.inertia, side.excitation, side.participation, side.lift):
        np.testing.assert_allclose(column[twice], column[twice + 1], rtol=0, atol=1e-13 * np.abs(column).max())


def test_plastic_block_overturns_by_hand():
    """tan phi_ov = (b / 2 - W / (2 f l)) / (h / 2)."""
    side = wall(law=JointLaw(inf, 1.5e6), model="rigid").oscillator.positive
    c = W / (2 * 1.5e6 * L)
    assert side.overturning_flexible == pytest.approx(atan2(B / 2 - c, H / 2), rel=1e-9)
    assert side.restoring[0] == pytest.approx(W * (B / 2 - c), rel=1e-12)


@EVERY
def test_between_nodes_the_table_is_what_the_chain_answers(mechanism):
    found = mechanism.oscillator
    if found.equilibrium:
        return  # counted from there: tested below
    chain = FlexibleChain(mechanism.positive, "m")
    side = found.positive
    phi = np.unique((side.rotation[1:] + side.rotation[:-1]) / 2)
    work = chain.solve_equilibrium(phi).work
    for what in ("restoring", "inertia", "excitation", "participation", "lift"):
        exact = getattr(work, what)
        table = interpolant(side.rotation, getattr(side, what))(phi)
        most = 1e-6 if what == "restoring" else 2e-6
        np.testing.assert_allclose(table, exact, rtol=0, atol=most * np.abs(exact).max())


@EVERY
def test_nothing_jumps_at_rest(mechanism):
    """Moments begin at nothing, both branches have one stiffness and one inertia there."""
    found = mechanism.oscillator
    if found.negative is None:
        assert found.positive.restoring[0] == 0.0
        return
    ahead, back = found.positive, found.negative
    assert ahead.restoring[0] == back.restoring[0] == 0.0
    stiffness = [float(interpolant(side.rotation, side.restoring)(0.0, 1)) for side in (ahead, back)]
    assert stiffness[0] == pytest.approx(stiffness[1], rel=1e-5)
    assert stiffness[0] > 0.0
    if "semi" not in str(mechanism.positive.joints[0].model):
        assert ahead.inertia[0] == pytest.approx(back.inertia[0], rel=1e-9)
        assert ahead.excitation[0] == pytest.approx(back.excitation[0], rel=1e-9)
        assert ahead.lift[0] == pytest.approx(-back.lift[0], abs=1e-9 * ahead.excitation[0])


# ------------------------------------------------------------------------------------------------- elastic frequency


@pytest.mark.parametrize("floor", [0.0, 5000.0])
def test_elastic_frequency_by_hand(floor):
    """sqrt((k I - sum m g z) / (J + sum m z^2)) / 2 pi, about the middle of the joint."""
    loads = (PointMass("floor", floor, (0.0, 5.0), True),) if floor else ()
    J = MASS * (B**2 + H**2) / 12 + MASS * 9.0 + floor * 25.0
    K = LAW.stiffness * L * B**3 / 12 - W * 3.0 - floor * g * 5.0
    side = wall(loads=loads).oscillator.positive
    assert side.inertia[0] == pytest.approx(J, rel=1e-12)
    assert elastic_frequency(side) == pytest.approx(sqrt(K / J) / (2 * pi), rel=1e-6)


def test_rigid_joints_have_a_threshold_and_no_frequency():
    side = wall(law=JointLaw(inf, 1.5e6), model="rigid").oscillator.positive
    assert elastic_frequency(side) is None
    assert (
        linear_multiplier(side)
        == multiplier(side)[0]
        == pytest.approx((B / 2 - W / (2 * 1.5e6 * L)) / (H / 2), rel=1e-12)
    )


# -------------------------------------------------------------------------------------------------- eccentric rests


def excess(phi, *, F, at, law=LAW):
    """What overturns a wall with a force F down at (x, z) [N m], by hand, for a contact that is full and elastic."""
    middle = LAW.stiffness * L * B**3 / 12 * sin(phi) / (W + F)  # of the resultant from the middle, to the edge
    x_G = -B / 2 * cos(phi) + H / 2 * sin(phi)
    x_F = (at[0] - B / 2) * cos(phi) + at[1] * sin(phi)
    return W * x_G + F * x_F + (W + F) * (B / 2 - middle) * cos(phi)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("law", [LAW, JointLaw(2e8, inf)])
def test_rest_under_an_eccentric_load_by_hand(side, law):
    F, at = 5e4, (0.15, 5.5)
    expected = brentq(lambda phi: excess(phi, F=F, at=at), 0.0, 2e-3, xtol=1e-16)
    found = wall(law=law, loads=(Force("F", (0.0, -F), (side * at[0], at[1])),)).oscillator
    assert found.equilibrium == pytest.approx(side * expected, rel=1e-9)
    assert expected > 1e-4


def test_rest_under_a_thrust_by_hand():
    T, z = 6e3, 4.0
    stiffness = LAW.stiffness * L * B**3 / 12
    over = lambda phi: T * (B / 2 * sin(phi) + z * cos(phi)) + W * H / 2 * sin(phi) - stiffness * sin(phi) * cos(phi)  # noqa: E731
    found = wall(loads=(Force("thrust", (T, 0.0), (0.0, z)),)).oscillator
    assert found.equilibrium == pytest.approx(brentq(over, 0.0, 3e-3, xtol=1e-16), rel=1e-9)


LEANING = wall(loads=(Force("F", (0.0, -5e4), (0.15, 5.5)),))


def total(phi):
    """The potential at a rotation of either sign [J]: weight, force and joint, stationary over its closing."""
    chain = LEANING.positive if phi >= 0.0 else LEANING.negative
    flexible, at = FlexibleChain(chain, "m"), np.array([abs(phi)])
    u, s = float(flexible.solve_joints(at).closure[0, 0]), sin(abs(phi))
    down, e = u - float(flexible.rest[0]), 0.15 * np.sign(phi)
    z_G = -down + B / 2 * s + H / 2 * cos(phi)
    z_F = -down + (B / 2 - e) * s + 5.5 * cos(phi)
    k, crushed = LAW.stiffness, LAW.strength / LAW.stiffness
    density = lambda v: L * k * (min(max(v, 0.0), crushed) ** 2 / 2 + crushed * max(v - crushed, 0.0))  # noqa: E731
    strain = quad(lambda x: density(u - s * x), 0.0, B, points=[min(max((u - v) / s, 0.0), B) for v in (0.0, 0.0075)],
                  epsabs=1e-9, epsrel=1e-13)[0]  # fmt: skip
    return W * z_G + 5e4 * z_F + strain


def test_energy_of_both_branches_counts_from_the_eccentric_rest():
    found = LEANING.oscillator
    rest = found.equilibrium
    at_rest = total(rest)
    for sign, side in ((1.0, found.positive), (-1.0, found.negative)):
        for phi in (0.3 * rest, 2.5 * rest, 0.01, 0.05):
            if sign > 0 or abs(phi - rest) > 1e-9:
                stored = float(energy(side, np.array(phi)))
                assert stored == pytest.approx(total(rest + sign * phi) - at_rest, rel=2e-6, abs=1e-6)


def test_branches_meet_at_the_eccentric_rest():
    found = LEANING.oscillator
    rest, ahead, back = found.equilibrium, found.positive, found.negative
    first, second = (FlexibleChain(chain, "m") for chain in (LEANING.positive, LEANING.negative))
    scale = ahead.restoring.max()
    assert abs(first.solve_equilibrium(np.array([rest])).work.restoring[0]) < 1e-9 * scale
    beyond = np.array([0.01, 0.03, 0.08])
    expected = first.solve_equilibrium(rest + beyond).work.restoring
    np.testing.assert_allclose(restoring_moment(ahead, beyond), expected, rtol=1e-6)
    way_back = rest * np.array([0.2, 0.5, 0.9])
    expected = -first.solve_equilibrium(rest - way_back).work.restoring
    np.testing.assert_allclose(restoring_moment(back, way_back), expected, rtol=0, atol=1e-6 * scale)
    expected = second.solve_equilibrium(beyond).work.restoring
    np.testing.assert_allclose(restoring_moment(back, rest + beyond), expected, rtol=1e-6)
    around = restoring_moment(back, rest * np.array([1.0 - 1e-7, 1.0 + 1e-7]))
    assert np.ptp(around) < 1e-5 * scale
    assert ahead.overturning_flexible + rest == pytest.approx(back.overturning_flexible - rest, rel=0.2)
    assert ahead.overturning_flexible < back.overturning_flexible


def test_where_a_leaning_wall_overturns_counts_from_its_rest():
    """The moment of all falls to zero at phi_ov, that of weight and joints alone at phi_cr, each from the rest on."""
    thrust = lambda phi: 1e3 * (B / 2 * sin(phi) + 4.0 * cos(phi))  # noqa: E731
    leaning = brentq(lambda phi: excess(phi, F=5e4, at=(0.15, 5.5)) + thrust(phi), 0.0, 2e-3, xtol=1e-16)
    found = TIED.oscillator
    assert found.equilibrium == pytest.approx(leaning, rel=1e-9)
    assert found.equilibrium_negative == -found.equilibrium
    chains = [FlexibleChain(chain, "m") for chain in (TIED.positive, TIED.negative)]
    for chain, side, rest in zip(chains, found.branches, (leaning, -leaning), strict=True):
        works = lambda phi, by=chain: by.solve_equilibrium(np.array([phi])).work  # noqa: E731
        falls = [
            brentq(lambda phi, of=works: float(of(phi).restoring[0]), 0.02, 0.3, xtol=1e-14),
            brentq(lambda phi, of=works: float(of(phi).weight[0]), 0.02, 0.3, xtol=1e-14),
        ]
        assert falls[0] != pytest.approx(falls[1], rel=1e-3)
        assert [side.overturning_flexible + rest, side.critical + rest] == pytest.approx(falls, rel=1e-7)
        assert float(restoring_moment(side, np.array(side.overturning_flexible))) == pytest.approx(0.0, abs=1e-4 * W)


TIED = wall(loads=(Force("F", (0.0, -5e4), (0.15, 5.5)), Force("T", (1e3, 0.0), (0.0, 4.0))))


def test_mirrored_loads_change_the_branches():
    ours, theirs = (
        LEANING.oscillator,
        wall(loads=tuple(mirror_load(load) for load in LEANING.positive.loads)).oscillator,
    )
    assert theirs.equilibrium == -ours.equilibrium
    assert (theirs.equilibrium_negative, ours.equilibrium_negative) == (-theirs.equilibrium, -ours.equilibrium)
    for side, other in ((ours.positive, theirs.negative), (ours.negative, theirs.positive)):
        for what in ("rotation", "inertia", "restoring", "excitation", "participation", "lift"):
            np.testing.assert_array_equal(getattr(side, what), getattr(other, what))


def test_one_sided_wall_pressed_on_what_is_behind_has_a_threshold():
    F, e = 5e4, 0.15
    found = wall(sides="one", loads=(Force("F", (0.0, -F), (-e, 5.5)),)).oscillator
    assert found.equilibrium == 0.0
    assert found.positive.restoring[0] == pytest.approx(F * e, rel=1e-9)
    assert elastic_frequency(found.positive) is None


def test_one_sided_wall_leans_away_from_what_is_behind():
    F, at = 5e4, (0.15, 5.5)
    found = wall(sides="one", loads=(Force("F", (0.0, -F), at),)).oscillator
    expected = brentq(lambda phi: excess(phi, F=F, at=at), 0.0, 2e-3, xtol=1e-16)
    assert found.equilibrium == pytest.approx(expected, rel=1e-9)
    assert found.positive.restoring[0] == 0.0


def test_no_stable_rest_under_a_load_too_far_out():
    """It stands on rigid joints, for the loads' line meets the base; the joint gives way under it."""
    soft = JointLaw(6e6, 1.5e6)
    assert soft.stiffness * L * B**3 / 12 > 3.0 * W  # a wall alone would stand
    with pytest.raises(MechanismError, match=r'mechanism "w": it falls by itself: the load on its joints lies too far'):
        _ = wall(law=soft, loads=(Force("F", (0.0, -5e4), (0.4, 5.5)),)).oscillator


@pytest.mark.parametrize("sides", ["one", "two"])
def test_no_stable_rest_on_a_joint_too_soft(sides):
    """k I < W h: upright it is in balance, but any push makes it fall."""
    soft = JointLaw(0.9 * 3.0 * W / (L * B**3 / 12), inf)
    with pytest.raises(MechanismError, match=r'mechanism "w": it falls by itself: its joints are too soft'):
        _ = wall(law=soft, sides=sides).oscillator


# -------------------------------------------------------------------------------------------- similarity and limits


def test_larger_walls_of_the_same_shape_rock_more_slowly():
    """Lengths times s, f_m times s, k_n as it is: p goes with s^(-1/2), rotations and multipliers stay."""
    s = 4.0
    large = wall(size=s, law=JointLaw(LAW.stiffness, s * LAW.strength)).oscillator.positive
    small = wall().oscillator.positive
    assert large.linearised.p == pytest.approx(small.linearised.p / sqrt(s), rel=1e-9)
    assert large.overturning_flexible == pytest.approx(small.overturning_flexible, rel=1e-9)
    assert large.restitution == pytest.approx(small.restitution, rel=1e-12)
    assert linear_multiplier(large) == pytest.approx(linear_multiplier(small), rel=1e-9)
    assert elastic_frequency(large) == pytest.approx(elastic_frequency(small) / sqrt(s), rel=1e-6)


@pytest.mark.parametrize("made", [wall, storey, portal], ids=["wall", "storey", "portal"])
def test_stiff_strong_joints_tend_to_the_rigid_oscillator(made):
    """At the root of the stiffness, in overturning and in the largest multiplier."""
    rigid = [made(law=JointLaw(inf, 1e15), model="rigid").oscillator.positive]
    stiff = 10.0 ** np.arange(12.0, 16.0)
    found = [made(law=JointLaw(k, inf)).oscillator.positive for k in stiff]
    off = np.array([side.overturning - side.overturning_flexible for side in found])
    assert np.polyfit(np.log(stiff), np.log(off), 1)[0] == pytest.approx(-0.5, abs=0.01)
    assert found[-1].restitution == pytest.approx(rigid[0].restitution, rel=1e-9)  # no strength: a_SF = 0
    lifts = np.array([multiplier(rigid[0])[0] - linear_multiplier(side) for side in found])
    assert (np.diff(lifts) < 0.0).all()
    assert lifts[-1] < 2e-3 * multiplier(rigid[0])[0]


# -------------------------------------------------------------------------------------------------- models together


def test_semi_flexible_has_a_fixed_inertia_and_everything_else_as_flexible():
    """I_SF = I_C + W / g R_P^2 about the hinge a_SF = 2 W / (3 f l) inside the edge (thesis 6.55-6.59; errata 5)."""
    flexible, fixed = (wall(model=model).oscillator.positive for model in ("flexible", "semi-flexible"))
    a_SF = 2 * W / (3 * LAW.strength * L)
    I_SF = MASS * (B**2 + H**2) / 12 + MASS * ((B / 2 - a_SF) ** 2 + (H / 2) ** 2)
    np.testing.assert_allclose(fixed.inertia, I_SF, rtol=1e-12)
    for what in ("rotation", "restoring", "excitation", "lift"):
        np.testing.assert_array_equal(getattr(fixed, what), getattr(flexible, what))
    assert fixed.restitution == flexible.restitution
    np.testing.assert_allclose(flexible.inertia, I_SF, rtol=0.025)  # thesis 6.3.1.2: within 2.5 %


def test_a_block_of_the_same_constants_at_any_rotation_is_6_50_to_6_52():
    side = wall(model="flexible-thesis").oscillator.positive
    for phi in (0.01, 0.05, 0.1):
        found = block_at(side, phi, mass=MASS)
        a = shift(phi)
        # the vertical arm of 6.49 is that of the mark on the block, of 6.54 that of the resultant on the ground
        assert found.radius == pytest.approx(hypot(B / 2 - a, H / 2), rel=2e-3)
        assert found.slenderness == pytest.approx(atan2(B / 2 - a, H / 2), rel=2e-3)
        assert found.inertia == pytest.approx(MASS * (B**2 + H**2) / 12 + MASS * hypot(B / 2 - a, H / 2) ** 2, rel=1e-6)


def test_equivalent_block_at_rest_stands_on_the_middle_of_its_joint():
    found = equivalent_block(wall().oscillator.positive, mass=MASS)
    assert (found.radius, found.slenderness) == pytest.approx((H / 2, 0.0), rel=1e-9, abs=1e-12)
