"""Chains on joints that give way, against the whole potential: weights, forces, ties and the strain of every joint.

The potential is written here once more: places by intersecting circles, the strain energy of a rectangle in closed
form, with the closing of each joint as a freedom beside the rotation. At rotation phi the program's closings must make
it stationary, and its restoring moment must be the derivative of what is left over phi.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, hypot, inf, pi, sin

import numpy as np
import pytest
from scipy.constants import g

from assess.errors import InterfaceError, MechanismError
from assess.geometry.planar import planar_body_from_values
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force, PointMass, Tie
from assess.mechanisms.chain import Chain, Joint, RigidBlock, virtual_work
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.mechanisms.four_hinge import divide_arch, weakest_hinges
from tests.support.bodies import rectangle_block as block_of

SOFT = JointLaw(2e8, 1.5e6)
LENGTH = 1.0  # of every contact along the axis of rotation [m]
SLOPES = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}  # of differences of eighth order


@dataclass(frozen=True)
class Bed:
    """A joint: the way along it from its hinge, and its normal from the held face to the pressing block; depth [m]."""

    inward: complex
    normal: complex
    depth: float
    law: JointLaw = SOFT

    def joint(self, model="flexible"):
        return Joint((self.inward.real, self.inward.imag), rectangle(self.depth, LENGTH), self.law, model)


@dataclass(frozen=True)
class ChainOnBeds:
    """Blocks, hinges and loads as of a `Chain`; beds: None where the hinge is rigid; at: rotations [rad]."""

    blocks: tuple
    hinges: tuple
    beds: tuple
    at: tuple = (2e-4, 2.5e-3, 9e-3, 0.03, 0.07)
    loads: tuple = ()

    def chain(self, model="flexible"):
        joints = tuple(bed and bed.joint(model) for bed in self.beds)
        return Chain(self.blocks, self.hinges, self.loads, joints=joints)

    def flexible(self, model="flexible"):
        return FlexibleChain(self.chain(model), "m")


def level(*sides, depth, law=SOFT):
    """Level beds, the faces below: +1 where the contact lies towards +x from its hinge."""
    return tuple(Bed(complex(side), 1j, depth, law) for side in sides)


def arch():
    """Nine voussoirs over 150 degrees, hinged where they resist least; beds along the radial joints."""
    angles, inside, outside = np.linspace(0.92 * pi, 0.10 * pi, 10), 5.0, 5.9
    lines = [((inside * cos(a), inside * sin(a)), (outside * cos(a), outside * sin(a))) for a in angles]
    middles = (angles[1:] + angles[:-1]) / 2
    mass = 1800.0 * (outside**2 - inside**2) / 2 * abs(angles[1] - angles[0])
    stones = [RigidBlock(mass, (5.45 * cos(a), 5.45 * sin(a)), 0.1 * mass) for a in middles]
    found = weakest_hinges(stones, lines, name="arch")
    bodies = [planar_body_from_values(mass=b.mass, centroid=b.centroid, inertia=b.inertia, name="v") for b in stones]
    chain = divide_arch(bodies, found)[1]
    beds = []
    for number, (hinge, joint) in enumerate(zip(chain.hinges, found.joints, strict=True)):
        a, on = angles[joint], hypot(*hinge)
        way = 1.0 if on < 5.45 else -1.0  # from the intrados outwards, or back
        beds.append(Bed(way * np.exp(1j * a), (-1j if number < 2 else 1j) * np.exp(1j * a), outside - inside))
    return ChainOnBeds(chain.blocks, chain.hinges, tuple(beds), at=(2e-4, 2e-3, 9e-3, 0.025))


AT = (2e-4, 2e-3, 9e-3, 0.03, 0.07)
WALL = block_of(-0.5, 0.0, 1.0, 6.0)
HALVES = block_of(-0.25, 0.0, 0.5, 2.4), block_of(-0.25, 2.4, 0.5, 1.6)
EDGES = (0.25, 0.0), (-0.25, 2.4), (0.25, 4.0)
OVER = Force("overburden", (0.0, -2e4), (0.25, 4.0), 1)
LEGS = block_of(-0.3, 0.0, 0.6, 3.0), block_of(-0.3, 3.0, 5.2, 0.7), block_of(4.3, 0.0, 0.6, 3.0)
UNEVEN = block_of(-0.3, 0.0, 0.6, 3.0), RigidBlock(6600.0, (2.2, 3.9), 15000.0), block_of(4.2, 0.9, 0.8, 2.7)
CASES = {
    "wall": ChainOnBeds((WALL,), ((0.5, 0.0),), level(-1, depth=1.0), at=(2e-4, 3e-3, 0.02, 0.1)),
    "elastic wall": ChainOnBeds(
        (WALL,), ((0.5, 0.0),), level(-1, depth=1.0, law=JointLaw(2e8, inf)), at=(2e-4, 3e-3, 0.02, 0.1)
    ),
    "wall near its bearing capacity": ChainOnBeds(
        (WALL,), ((0.5, 0.0),), level(-1, depth=1.0, law=JointLaw(2e8, 1.6e5)), at=(4e-4, 1e-3, 3e-3, 0.02)
    ),
    "wall with loads": ChainOnBeds((WALL,), ((0.5, 0.0),), level(-1, depth=1.0), loads=(
        PointMass("floor", 2500.0, (0.2, 4.0), True), PointMass("roof", 400.0, (-0.1, 5.8), False),
        Force("thrust", (1500.0, -600.0), (-0.4, 3.5)), Tie("tie", 2500.0, (0.4, 5.5), anchor=(-4.0, 5.2)),
        Tie("slack", 1800.0, (0.4, 3.0), direction=(0.8, -0.6)),
    )),
    "two blocks under a load": ChainOnBeds(HALVES, EDGES, level(-1, 1, -1, depth=0.5), loads=(OVER,)),
    "two blocks under a load and more": ChainOnBeds(HALVES, EDGES, level(-1, 1, -1, depth=0.5), AT, loads=(
        OVER, PointMass("floor", 700.0, (0.1, 2.0), True), Tie("tie", 900.0, (0.25, 3.4), anchor=(-2.0, 3.3), block=1),
    )),
    "two blocks, rigid top": ChainOnBeds(
        HALVES, EDGES, (*level(-1, 1, depth=0.5), None), loads=(Force("F", (0.0, -2e4), (0.05, 4.0), 1),)
    ),
    "portal": ChainOnBeds(LEGS, ((0.3, 0.0), (-0.3, 3.0), (4.3, 3.0), (4.9, 0.0)), level(-1, 1, 1, -1, depth=0.6)),
    "portal, rigid feet": ChainOnBeds(
        LEGS, ((0.3, 0.0), (-0.3, 3.0), (4.3, 3.0), (4.9, 0.0)), (None, *level(1, 1, depth=0.6), None)
    ),
    "uneven frame": ChainOnBeds(
        UNEVEN, ((0.3, 0.0), (-0.3, 3.0), (4.2, 3.6), (5.0, 0.9)), level(-1, 1, 1, -1, depth=0.6),
        loads=(PointMass("roof", 2000.0, (1.7, 4.4), True, 1), Force("vault", (400.0, -300.0), (0.3, 2.5)),
               Tie("stay", 900.0, (4.4, 3.0), anchor=(0.0, 2.8), block=2)),
    ),
    "arch": arch(),
}  # fmt: skip
EVERY = pytest.mark.parametrize("case", CASES.values(), ids=CASES)


# -------------------------------------------------------------------------------------------------- the whole potential


def places(case, phi, sunk):
    """Of each block where one of its points has come to and how it has turned: [(then, now, exp(-i theta))].

    phi [n]; sunk: of each joint below its place at rest, square to its held face [hinges, n] [m]
    """
    h = [complex(*at) for at in case.hinges]
    n = [0j if bed is None else bed.normal for bed in case.beds]
    first, foot = np.exp(-1j * phi), h[0] - sunk[0] * n[0]
    found = [(h[0], foot, first)]
    if len(case.blocks) == 1:
        return found
    b = foot + (h[1] - sunk[1] * n[1] - h[0]) * first
    arm = h[2] - h[1]
    if len(case.blocks) == 2:  # the top keeps to its vertical
        return [*found, (h[1], b, np.exp(1j * (np.arccos((h[2].real - b.real) / abs(arm)) - np.angle(arm))))]
    d, leg = h[3] - sunk[3] * n[3], h[2] - sunk[2] * n[2] - h[3]
    span, l2, l3 = np.abs(d - b), abs(arm), np.abs(leg)
    x = (span**2 + l2**2 - l3**2) / (2 * span)
    bend = np.sign((np.conj(arm) * (h[3] - h[2])).imag)
    c = b + (d - b) / span * (x - 1j * bend * np.sqrt(l2**2 - x**2))
    return [*found, (h[1], b, (c - b) / arm), (h[3], d, (c - d) / leg)]


def turned(case, stand):
    """Rotation of each joint, pressing block against held face [hinges, n]."""
    angle = [-np.angle(turn) for *_, turn in stand]
    return {1: lambda: [angle[0]],
            2: lambda: [angle[0], angle[0] - angle[1], -angle[1]],
            3: lambda: [angle[0], angle[0] - angle[1], angle[2] - angle[1], angle[2]]}[len(case.blocks)]()  # fmt: skip


def strain(bed, closing, slope):
    """Energy of a rectangle closed by `closing` at its edge and less by `slope` x: of clip(k v, 0, f) over v [J]."""
    k, most, depth = bed.law.stiffness, bed.law.strength / bed.law.stiffness, bed.depth
    whole = depth * (closing**2 - closing * slope * depth + (slope * depth) ** 2 / 3) / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        cubes = [np.maximum(v, 0.0) ** 3 / 6 for v in (
            closing, closing - slope * depth, closing - most, closing - most - slope * depth)]  # fmt: skip
        parts = (cubes[0] - cubes[1] - cubes[2] + cubes[3]) / slope
    full = (closing - slope * depth > 0) & (closing < most)
    return k * LENGTH * np.where(full, whole, parts)


def potential(case, phi, sunk, rest):
    """Energy of the whole [n] [J], above that at rest; rest: closings there [hinges] [m]."""
    stand, total = places(case, phi, sunk), 0.0

    def moved(number, at):
        then, now, turn = stand[number]
        return now + (complex(*at) - then) * turn - complex(*at)

    for number, each in enumerate(case.blocks):
        total = total + each.mass * g * moved(number, each.centroid).imag
    for load in case.loads:
        away = moved(load.block, load.at)
        if load.name == "overburden":  # stands on the joint at the top, which closes under it
            total = total - load.force[1] * (away.imag - sunk[2])
        elif isinstance(load, PointMass):
            total = total + load.bearing * load.mass * g * away.imag
        elif isinstance(load, Force):
            total = total - load.force[0] * away.real - load.force[1] * away.imag
        elif load.name != "slack":
            far = complex(*load.at) - complex(*load.anchor)
            total = total + load.pull * (np.abs(away + far) - abs(far))
    for bed, psi, down, start in zip(case.beds, turned(case, stand), sunk, rest, strict=True):
        if bed is not None:
            total = total + strain(bed, start + down, np.sin(np.abs(psi)))
    return total


def steps(phi):
    """Of differences over rotation: long beside rounding, short beside the distance to a change of regime."""
    return np.maximum(5e-3 * phi, 4e-6)


def sunk_at(flexible, rotation):
    """Of every joint below its place at rest, as the program has it [hinges, n] [m]."""
    return flexible.solve_joints(rotation).closure - flexible.rest[:, None]


def slope(f, x, step):
    """Derivative by differences of eighth order."""
    return sum(w * (f(x + k * step) - f(x - k * step)) for k, w in SLOPES.items()) / step


# --------------------------------------------------------------------------------------------------------- equilibrium


@EVERY
def test_restoring_is_the_derivative_of_the_whole_potential(case):
    flexible, phi = case.flexible(), np.array(case.at)

    def along(x):
        return potential(case, x, sunk_at(flexible, x), flexible.rest)

    found = flexible.solve_equilibrium(phi).work.restoring
    expected = slope(along, phi, steps(phi))
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


@EVERY
def test_joints_close_so_that_the_potential_is_stationary(case):
    flexible, phi = case.flexible(), np.array(case.at)
    sunk, weight = sunk_at(flexible, phi), sum(each.mass for each in case.blocks) * g
    for number, bed in enumerate(case.beds):
        if bed is None:
            continue

        def along(by, number=number):
            moved = sunk.copy()
            moved[number] += by
            return potential(case, phi, moved, flexible.rest)

        assert np.abs(slope(along, 0.0, 1e-6)).max() < 1e-8 * weight


def test_the_energy_of_the_joints_has_its_part():
    """Without it the derivative is off by half of W a_f where the contact is partial and elastic (errata)."""
    case = CASES["elastic wall"]
    flexible, phi = case.flexible(), np.array([0.02])
    held = flexible.solve_equilibrium(phi)
    mass_alone = slope(lambda x: -case.blocks[0].mass * g * (sunk_at(flexible, x)[0] + 3.0 * (1 - np.cos(x))
                       - 0.5 * np.sin(x)), phi, 1e-4)  # fmt: skip
    assert abs(mass_alone[0] / held.work.restoring[0] - 1) > 0.05


def test_the_cases_reach_every_regime():
    """Full and partial contact, elastic and crushed."""
    met = set()
    for case in CASES.values():
        for bed, contact in zip(case.beds, case.flexible().solve_equilibrium(np.array(case.at)).contacts, strict=True):
            if bed is not None:
                met |= set(zip(contact.depth < bed.depth, contact.crushed_depth > 0.0, strict=True))
    assert len(met) == 4


@pytest.mark.parametrize("name", ["wall", "elastic wall"])
def test_inertia_of_a_block_is_that_of_its_motion(name):
    """Under its own weight the path of the centroid follows from the closing alone."""
    case = CASES[name]
    flexible, phi = case.flexible(), np.array(case.at)
    (body,) = case.blocks

    def centroid(x):
        ((then, now, turn),) = places(case, x, sunk_at(flexible, x))
        return now + (complex(*body.centroid) - then) * turn

    work, rate = flexible.solve_equilibrium(phi).work, slope(centroid, phi, steps(phi))
    np.testing.assert_allclose(work.inertia, body.inertia + body.mass * np.abs(rate) ** 2, rtol=1e-9)
    np.testing.assert_allclose(work.excitation, body.mass * rate.real, rtol=1e-9)
    np.testing.assert_allclose(work.lift, body.mass * rate.imag, rtol=1e-8, atol=1e-8 * body.mass)
    np.testing.assert_allclose(work.participation, body.mass * rate.real**2, rtol=1e-9)


@pytest.mark.parametrize(
    ("name", "most"),
    [("two blocks under a load", 0.01), ("portal", 0.01), ("uneven frame", 0.02), ("arch", 0.07)],
)
def test_inertia_of_a_chain_leaves_out_how_its_forces_change(name, most):
    """The motion is that of joints under constant forces; what that leaves out is small (bound stated)."""
    case = CASES[name]
    flexible, phi = case.flexible(), np.array(case.at)
    inertia = np.zeros(phi.size)
    masses = [(b.mass, b.inertia, b.centroid, k) for k, b in enumerate(case.blocks)]
    masses += [(p.mass, 0.0, p.at, p.block) for p in case.loads if isinstance(p, PointMass)]
    for mass, about, at, k in masses:

        def path(x, at=at, k=k):
            then, now, turn = places(case, x, sunk_at(flexible, x))[k]
            return now + (complex(*at) - then) * turn

        rate = slope(path, phi, steps(phi))
        spin = slope(lambda x, k=k: -np.angle(places(case, x, sunk_at(flexible, x))[k][2]), phi, steps(phi))
        inertia = inertia + mass * np.abs(rate) ** 2 + about * spin**2
    np.testing.assert_allclose(flexible.solve_equilibrium(phi).work.inertia, inertia, rtol=most)
    assert np.abs(flexible.solve_equilibrium(phi).work.inertia / inertia - 1).max() > 1e-9  # so it is stated, not exact


# ------------------------------------------------------------------------------------------------------- normal forces


def at_rest(case):
    """Normal forces at rest [hinges] [N]."""
    return case.flexible().solve_equilibrium(np.zeros(1)).normal_force[:, 0]


def test_table_6_1_forces_of_a_wall_of_two_blocks():
    W1, W2 = (each.mass * g for each in HALVES)
    F = -OVER.force[1]
    np.testing.assert_allclose(at_rest(CASES["two blocks under a load"]), [F + W1 + W2, F + W2, F], rtol=1e-12)


def test_table_6_2_forces_of_a_portal():
    W1, W2, _ = (each.mass * g for each in LEGS)
    np.testing.assert_allclose(at_rest(CASES["portal"]), [W1 + W2 / 2, W2 / 2, W2 / 2, W1 + W2 / 2], rtol=1e-12)


def test_table_6_3_forces_of_an_uneven_frame():
    """The beam's centroid midway between the middles of its joints; at D it is W_3 + W_2 / 2 (errata)."""
    blocks = block_of(-0.3, 0.0, 0.6, 3.0), RigidBlock(6600.0, (2.3, 3.9), 15000.0), block_of(4.2, 0.9, 0.8, 2.7)
    case = ChainOnBeds(blocks, ((0.3, 0.0), (-0.3, 3.0), (4.2, 3.6), (5.0, 0.9)), tuple(
        Bed(complex(way), 1j, depth) for way, depth in ((-1, 0.6), (1, 0.6), (1, 0.8), (-1, 0.8))))  # fmt: skip
    W1, W2, W3 = (each.mass * g for each in blocks)
    np.testing.assert_allclose(at_rest(case), [W1 + W2 / 2, W2 / 2, W2 / 2, W3 + W2 / 2], rtol=1e-12)
    assert abs((W1 + W2 / 2) / (W3 + W2 / 2) - 1) > 0.05  # as printed for D


def test_table_6_4_forces_of_a_side_aisle_vault():
    """An upright joint at the apex carries the thrust T; the wall's centroid where the vault leaves it in balance."""
    W, W3, depth, thick = 2500.0 * g, 40000.0 * g, 0.3, 1.2
    apex, spring = 8.3 - depth / 2, 0.2 - depth / 2  # of the middles of the joints: height, and distance inwards
    halves = RigidBlock(W / g, (1.15, 7.9), 1500.0), RigidBlock(W / g, (3.85, 7.9), 1500.0)
    T = W * (1.15 - spring) / (apex - 7.0)
    foot = 6.2 - thick / 2
    x3 = foot + (W * (foot - (5.0 - spring)) - T * 7.0) / W3  # moments of the wall about the middle of its foot
    blocks = (*halves, RigidBlock(W3 / g, (x3, 3.7), 1e4))
    case = ChainOnBeds(blocks, ((0.2, 7.0), (2.5, 8.3), (4.8, 7.0), (6.2, 0.0)), (
        Bed(-1 + 0j, 1j, depth), Bed(-1j, 1 + 0j, depth), Bed(1 + 0j, 1j, depth), Bed(-1 + 0j, 1j, thick)))  # fmt: skip
    np.testing.assert_allclose(at_rest(case), [W, T, W, W + W3], rtol=1e-9)


def test_force_on_a_turned_face_by_hand():
    """Two blocks held at a rotation: the support at the top gives H, by moments of the upper block about B."""
    case, phi = CASES["two blocks, rigid top"], 0.04
    flexible = case.flexible()
    rotation = np.array([phi])
    held, sunk = flexible.solve_equilibrium(rotation), sunk_at(flexible, rotation)
    (_, _, turn), (then, now, turn2) = places(case, rotation, sunk)
    upper = HALVES[1]
    shift = held.contacts[1].resultant * np.cos(held.relative[1])
    at = (now + shift * turn)[0]  # the resultant, on the lower block's face

    def arm(place):
        return (now + (complex(*place) - then) * turn2)[0] - at

    W2, F = upper.mass * g, 2e4
    top, load = arm((0.25, 4.0)), arm((0.05, 4.0))
    H = (W2 * arm(upper.centroid).real + F * load.real) / -top.imag
    normal = 1j * turn[0]
    expected = -(normal.conjugate() * complex(H, -W2 - F)).real
    assert held.normal_force[1, 0] == pytest.approx(expected, rel=1e-9)
    assert held.normal_force[0, 0] == pytest.approx(W2 + F + HALVES[0].mass * g, rel=1e-12)
    assert abs(expected / (W2 + F) - 1) > 1e-3  # not merely the weights above


# -------------------------------------------------------------------------------------------------------------- limits


@pytest.mark.parametrize("name", ["wall", "two blocks under a load", "portal", "uneven frame", "arch"])
def test_stiff_joints_tend_to_the_rigid_chain_with_the_root_of_the_stiffness(name):
    """a_f = 1/3 sqrt(2 N / (k phi l)) while the contact is partial and elastic (thesis 6.5)."""
    case, stiff = CASES[name], 10.0 ** np.arange(12.0, 17.0)
    phi = np.array(case.at[-2:])
    rigid = virtual_work(replace(case.chain(), joints=()), phi)
    off = []
    for k in stiff:
        work = hardened(case, JointLaw(k, inf)).flexible().solve_equilibrium(phi).work
        off.append([np.abs(work.restoring / rigid.restoring - 1).max(), np.abs(work.inertia / rigid.inertia - 1).max()])
    orders = np.polyfit(np.log(stiff), np.log(off), 1)[0]
    np.testing.assert_allclose(orders, [-0.5, -0.5], rtol=0, atol=0.01)
    assert off[-1][0] < 1e-4


@pytest.mark.parametrize("name", ["wall", "two blocks under a load", "portal", "uneven frame", "arch"])
def test_rigid_joints_with_strength_tend_to_the_rigid_chain_with_it(name):
    """a_f = N / (2 f l)."""
    case, strong = CASES[name], 10.0 ** np.arange(8.0, 12.0)
    phi = np.array(case.at[1:3])
    rigid = virtual_work(replace(case.chain(), joints=()), phi).restoring
    off = [
        np.abs(hardened(case, JointLaw(inf, f)).flexible("rigid").solve_equilibrium(phi).work.restoring / rigid - 1)
        for f in strong
    ]
    orders = np.polyfit(np.log(strong), np.log(off), 1)[0]
    np.testing.assert_allclose(orders, [-1.0, -1.0], rtol=0, atol=0.01)


def hardened(case, law):
    return replace(case, beds=tuple(bed and replace(bed, law=law) for bed in case.beds))


def test_rigid_joint_with_strength_is_the_plastic_block():
    """W [R0 sin(alpha - phi) - W / (2 f l) cos phi] (thesis 6.1 with the block of stress; errata 4)."""
    case = hardened(CASES["wall"], JointLaw(inf, 1.5e6))
    phi, W = np.array([0.0, 0.01, 0.1]), WALL.mass * g
    held = case.flexible("rigid").solve_equilibrium(phi)
    shift, alpha = W / (2 * 1.5e6 * LENGTH), np.arctan2(0.5, 3.0)
    expected = W * (hypot(0.5, 3.0) * np.sin(alpha - phi) - shift * np.cos(phi))
    np.testing.assert_allclose(held.work.restoring, expected, rtol=1e-12)
    centred = 2 * shift * 1.5e6 * LENGTH
    assert held.normal_force[0] == pytest.approx([centred] * 3, rel=1e-12)


@pytest.mark.parametrize("name", CASES)
def test_larger_bodies_of_the_same_shape(name):
    """Lengths times s, masses s^3, forces s^3, f_m times s, k_n as it is: moments go with s^4, inertia with s^5."""
    case, s = CASES[name], 3.0

    def long(at):
        return (s * at[0], s * at[1])

    def force(load):
        if isinstance(load, PointMass):
            return replace(load, mass=s**3 * load.mass, at=long(load.at))
        if isinstance(load, Force):
            return replace(load, force=(s**3 * load.force[0], s**3 * load.force[1]), at=long(load.at))
        return replace(load, pull=s**3 * load.pull, at=long(load.at), anchor=load.anchor and long(load.anchor))

    blocks = tuple(RigidBlock(s**3 * b.mass, long(b.centroid), s**5 * b.inertia) for b in case.blocks)
    joints = tuple(
        joint and replace(joint, section=rectangle(s * bed.depth, s * LENGTH),
                          law=JointLaw(bed.law.stiffness, s * bed.law.strength))
        for joint, bed in zip(case.chain().joints, case.beds, strict=True)
    )  # fmt: skip
    large = Chain(blocks, tuple(map(long, case.hinges)), tuple(map(force, case.loads)), joints=joints)
    phi = np.array(case.at)
    ours, theirs = case.flexible().solve_equilibrium(phi), FlexibleChain(large, "m").solve_equilibrium(phi)
    for what, power in (("restoring", 4), ("inertia", 5), ("excitation", 4), ("lift", 4), ("participation", 5)):
        expected = s**power * getattr(ours.work, what)
        np.testing.assert_allclose(getattr(theirs.work, what), expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())
    np.testing.assert_allclose(theirs.normal_force, s**3 * ours.normal_force, rtol=1e-9)


# -------------------------------------------------------------------------------------------------------------- models


def test_flexible_thesis_has_the_inertia_about_the_resultant():
    """I = I_C + W / g R(phi)^2, R(phi) by 6.51, and B by 6.49."""
    case = CASES["wall"]
    phi = np.array(case.at)
    held = case.flexible("flexible-thesis").solve_equilibrium(phi)
    a, (body,) = held.contacts[0].resultant, case.blocks
    np.testing.assert_allclose(held.work.inertia, body.inertia + body.mass * (9.0 + (0.5 - a) ** 2), rtol=1e-12)
    B = body.mass * (3.0 * np.cos(phi) + (0.5 - a) * np.sin(phi))
    np.testing.assert_allclose(held.work.excitation, B, rtol=1e-12)
    np.testing.assert_allclose(held.work.restoring, case.flexible().solve_equilibrium(phi).work.restoring, rtol=1e-12)


def test_inertia_about_the_resultant_differs_little_from_that_of_the_motion():
    """The faces turn about the middle of what is elastic, not about the resultant (1/2 and 1/3 of an elastic depth)."""
    case = CASES["elastic wall"]
    phi = np.array([0.02, 0.1])
    ours, theirs = (case.flexible(model).solve_equilibrium(phi) for model in ("flexible", "flexible-thesis"))
    a = ours.contacts[0].depth
    np.testing.assert_allclose(ours.contacts[0].instantaneous_centre, a / 2, rtol=1e-12)
    np.testing.assert_allclose(theirs.contacts[0].resultant, a / 3, rtol=1e-12)
    off = theirs.work.inertia / ours.work.inertia - 1
    assert (np.abs(off) > 1e-4).all()
    assert (np.abs(off) < 0.02).all()


def test_only_inertia_depends_on_the_model():
    for name in ("wall", "two blocks under a load", "uneven frame"):
        case = CASES[name]
        phi = np.array(case.at)
        ours, theirs = (case.flexible(model).solve_equilibrium(phi).work for model in ("flexible", "semi-flexible"))
        for what in ("restoring", "excitation", "lift", "weight"):
            np.testing.assert_array_equal(getattr(ours, what), getattr(theirs, what))
        assert (np.abs(theirs.inertia / ours.inertia - 1) > 1e-5).any()


# -------------------------------------------------------------------------------------------------------------- errors


def test_a_body_too_heavy_for_its_joint():
    case = hardened(CASES["wall"], JointLaw(2e8, 1.0e5))
    with pytest.raises(InterfaceError, match=r'"m": interface A: its normal force, 105912 N, is 1\.059 times'):
        case.flexible().solve_equilibrium(np.zeros(1))


def test_a_joint_that_is_pulled():
    up = (Force("uplift", (0.0, 1.2 * WALL.mass * g), (0.0, 5.0)),)
    with pytest.raises(InterfaceError, match=r"interface A: its normal force is -[\d.]+ N, so it would have to pull"):
        replace(CASES["wall"], loads=up).flexible().solve_equilibrium(np.zeros(1))


def test_a_joint_that_would_open_at_its_hinge():
    """A bar over a leg that leans in: at B it first turns less than the leading leg, and then overtakes it."""
    blocks = block_of(-0.3, 0.0, 0.6, 3.8), RigidBlock(6600.0, (2.8, 4.2), 15000.0), block_of(1.7, 0.9, 0.6, 1.7)
    bed = (None, *level(1, depth=0.6), None, None)
    case = ChainOnBeds(blocks, ((0.0, 0.0), (0.8, 3.8), (4.8, 2.6), (2.3, 0.9)), bed)
    with pytest.raises(MechanismError, match=r'mechanism "m": interface B: its faces turn by 0\.01\d+ rad away'):
        case.flexible().solve_equilibrium(np.linspace(0.0, 0.3, 4))
