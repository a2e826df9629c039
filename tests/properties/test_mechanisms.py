"""What must hold for every mechanism of blocks, in both directions."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import g
from scipy.integrate import quad

from assess.dynamics.history import free_rocking
from assess.geometry.planar import join_planar, planar_body_from_values
from assess.loads.load import Force, PointMass, Tie, mirror_load, pull_at_rest
from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain, mirror_point, move, trace_point, virtual_work
from assess.mechanisms.four_hinge import FOUR_HINGE, divide_arch, four_hinge, weakest_hinges
from assess.mechanisms.hinge_forces import hinge_forces, incipient_motion
from assess.mechanisms.mechanism import Face
from assess.mechanisms.restitution import find_restitution
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.oscillator import energy, interpolant, multiplier
from tests.support import projects
from tests.support.bodies import PORTAL_HINGES, UNEVEN_HINGES, body_of_block, portal_blocks, rectangle_block
from tests.support.differences import slope
from tests.support.projects import mechanism_of, project_toml

LOOKS_DOWN = (0.0, -1.0)
TABLES = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")


@dataclass(frozen=True)
class HingedBlocks:
    """Blocks with the hinges of each direction, as they stand, and their loads.

    kind : of the mechanism; that of so many blocks where None
    """

    blocks: tuple
    front: tuple
    back: tuple
    loads: tuple = ()
    kind: str | None = None

    def chains(self):
        return Chain(self.blocks, self.front, self.loads), mirror_chain(self.blocks, self.back, self.loads)

    def mechanism(self, *, weld=lambda body: body, restitution="momentum"):
        bodies = [weld(body_of_block(block)) for block in self.blocks]
        more = {"loads": self.loads, "restitution": (restitution, restitution)}
        kind = self.kind or ("single-block", "two-block", "four-hinge")[len(bodies) - 1]
        if kind == "single-block":
            return single_block("m", *bodies, hinge=self.front[0], hinge_negative=self.back[0], **more)
        if kind == "two-block":
            return two_block("m", *bodies, hinges=self.front, hinges_negative=self.back, **more)
        if kind == "four-hinge":
            return four_hinge("m", bodies, hinges=self.front, hinges_negative=self.back, **more)
        raise NotImplementedError(f"no constructor of {kind} here: add the call of yours to HingedBlocks.mechanism")


def arch():
    """An arch of nine voussoirs, lopsided, and the hinges found for it each way."""
    angles = np.linspace(0.93 * pi, 0.12 * pi, 10)
    joints = [((5.0 * cos(a), 5 * sin(a)), ((5.9 + k / 20) * cos(a), (5.9 + k / 20) * sin(a)))
              for k, a in enumerate(angles)]  # fmt: skip
    voussoirs = []
    for k in range(9):
        middle, reach = (angles[k] + angles[k + 1]) / 2, 5.5 + k / 40
        block = RigidBlock(1000.0 + 40 * k, (reach * cos(middle), reach * sin(middle)), 300.0)
        voussoirs.append(body_of_block(block))
    found = weakest_hinges([RigidBlock(v.mass, v.centroid, v.inertia) for v in voussoirs], joints, name="a")
    chain = divide_arch(voussoirs, found)[1]
    lower, upper = (tuple(joints[k][face] for k in found.joints) for face in (0, 1))
    back = tuple(
        (upper, lower)[k % 2][k] if lower[0] == found.hinges[0] else (lower, upper)[k % 2][k] for k in range(4)
    )
    return HingedBlocks(chain.blocks, chain.hinges, back)


block_of = partial(rectangle_block, density=2000.0)
WALL = block_of(-0.4, 0.0, 0.8, 5.0)
LEANING = RigidBlock(9000.0, (0.15, 2.6), 21000.0)
HALVES = block_of(-0.25, 0.0, 0.5, 2.6), block_of(-0.25, 2.6, 0.5, 1.6)
PORTAL, UNEVEN = portal_blocks(density=2000.0), portal_blocks(uneven=True, density=2000.0)
EDGES = ((0.25, 0.0), (-0.25, 2.6), (0.25, 4.2)), ((-0.25, 0.0), (0.25, 2.6), (-0.25, 4.2))

CASES = {
    "wall": HingedBlocks((WALL,), ((0.4, 0.0),), ((-0.4, 0.0),)),
    "leaning wall": HingedBlocks((LEANING,), ((0.7, 0.2),), ((-0.5, 0.0),)),
    "wall with loads": HingedBlocks((WALL,), ((0.4, 0.0),), ((-0.4, 0.0),), (
        PointMass("floor", 900.0, (0.2, 4.0), True), PointMass("roof", 400.0, (-0.1, 4.8), False),
        Force("thrust", (1500.0, -600.0), (-0.4, 3.5)), Tie("tie", 2500.0, (0.4, 4.5), anchor=(-4.0, 4.2), both=True),
        Tie("slack one way", 1800.0, (-0.4, 3.0), direction=(-0.8, 0.6)),
    )),
    "two blocks": HingedBlocks(HALVES, *EDGES),
    "two blocks, load off centre": HingedBlocks(HALVES, *EDGES, (
        Force("overburden", (0.0, -21000.0), (0.15, 4.2), block=1), PointMass("floor", 700.0, (0.1, 2.0), True),
        PointMass("beside", 300.0, (-0.2, 3.0), False, 1), Tie("tie", 900.0, (0.25, 3.4), anchor=(-2.0, 3.3), block=1),
    )),
    "symmetric portal": HingedBlocks(PORTAL, *PORTAL_HINGES),
    "asymmetric portal": HingedBlocks(UNEVEN, *UNEVEN_HINGES),
    "portal with loads": HingedBlocks(UNEVEN, *UNEVEN_HINGES, (
        PointMass("roof", 2000.0, (1.7, 5.4), True, 1), PointMass("wall beside", 500.0, (4.2, 3.0), False, 2),
        Force("vault", (1100.0, -400.0), (0.8, 3.0)), Force("lift", (-200.0, 500.0), (4.4, 4.0), block=2),
        Tie("tie", 1500.0, (0.4, 3.8), anchor=(7.0, 3.8)),
        Tie("stay", 900.0, (3.0, 4.8), direction=(-0.6, -0.8), block=1),
    )),
    "arch": arch(),
}  # fmt: skip
EVERY = pytest.mark.parametrize("case", CASES.values(), ids=CASES)


def sides(case):
    """Each chain with its branch."""
    return [(chain, rigid_branch(chain, restitution=0.9, name="m")) for chain in case.chains()]


def potential(chain, rotation):
    """Sum of m g z of what the blocks bear, less the work of forces, and the pull of taut ties times their length."""
    motion, total = move(chain, rotation), 0.0
    for number, block in enumerate(chain.blocks):
        total = total + block.mass * g * trace_point(motion, block=number, at=block.centroid).z
    for each in chain.loads:
        at = trace_point(motion, block=each.block, at=each.at)
        if isinstance(each, PointMass):
            total = total + each.bearing * each.mass * g * at.z
        elif isinstance(each, Force):
            total = total - each.force[0] * at.x - each.force[1] * at.z
        elif taut(chain, each):
            total = total + each.pull * stretch(each, at)
    return total


def stretch(tie, at):
    """Length of a tie, or of its part along its direction."""
    if tie.anchor is None:
        return -tie.direction[0] * at.x - tie.direction[1] * at.z
    return np.hypot(tie.anchor[0] - at.x, tie.anchor[1] - at.z)


def taut(chain, tie):
    """A tie is slack on the branch where it shortens."""
    length = stretch(tie, trace_point(move(chain, np.array([0.0, 1e-6])), block=tie.block, at=tie.at))
    return tie.both or length[1] > length[0]


@EVERY
def test_restoring_moment_is_the_slope_of_the_whole_potential(case):
    """To 1e-8, by differences of eighth order; without loads it is that of the weights alone."""
    for chain, side in sides(case):
        phi = side.rotation[::16]
        bare = replace(chain, loads=tuple(each for each in chain.loads if isinstance(each, PointMass)))
        work = virtual_work(chain, phi)
        for of, found in ((chain, work.restoring), (bare, work.weight)):
            climbed = slope(partial(potential, of), phi)
            np.testing.assert_allclose(found, climbed, rtol=1e-8, atol=1e-8 * np.abs(found).max())
        assert work.weight == pytest.approx(g * work.lift, rel=1e-14)


@EVERY
def test_energy_of_the_table_is_the_potential_climbed(case):
    for chain, side in sides(case):
        phi = np.linspace(0.0, side.rotation[-1], 37)
        climbed = potential(chain, phi) - potential(chain, np.zeros(1))
        np.testing.assert_allclose(energy(side, phi), climbed, rtol=1e-8, atol=1e-9 * np.abs(climbed).max())


@EVERY
def test_kinetic_energy_and_momentum_by_differences_of_places(case):
    """I phi'^2 is twice the kinetic energy; B and C are the slopes of the first moments of mass."""
    step = 1e-5
    for chain, _ in sides(case):
        phi, moved = np.array([0.01, 0.05]), []
        work = virtual_work(chain, phi)
        for rotation in (phi - step, phi + step):
            motion = move(chain, rotation)
            points = [(b.mass, b.mass, trace_point(motion, block=k, at=b.centroid)) for k, b in enumerate(chain.blocks)]
            points += [(one.mass, one.mass * one.bearing, trace_point(motion, block=one.block, at=one.at))
                       for one in chain.loads if isinstance(one, PointMass)]  # fmt: skip
            moved.append((points, motion.angle))
        (before, old), (after, new) = moved
        along = [(m, (b.x - a.x) / (2 * step)) for (m, _, a), (_, _, b) in zip(before, after, strict=True)]
        up = [(m, (b.z - a.z) / (2 * step)) for (_, m, a), (_, _, b) in zip(before, after, strict=True)]
        turning = sum(b.inertia * r**2 for b, r in zip(chain.blocks, (new - old) / (2 * step), strict=True))
        kinetic = turning + sum(m * v**2 for m, v in (*along, *up))
        np.testing.assert_allclose(work.inertia, kinetic, rtol=1e-7)
        np.testing.assert_allclose(work.excitation, sum(m * v for m, v in along), rtol=1e-7)
        np.testing.assert_allclose(work.participation, sum(m * v**2 for m, v in along), rtol=1e-7)
        scale = sum(m for m, _ in up) * 5.0
        np.testing.assert_allclose(work.lift, sum(m * v for m, v in up), rtol=1e-7, atol=1e-8 * scale)


@EVERY
def test_balance_of_every_block_gives_the_multiplier_of_virtual_work(case):
    for chain, side in sides(case):
        assert incipient_motion(chain).multiplier == pytest.approx(multiplier(side)[0], rel=1e-12)


def image(case):
    """The whole mirrored in the vertical through the origin."""
    return HingedBlocks(
        tuple(RigidBlock(b.mass, mirror_point(b.centroid), b.inertia) for b in case.blocks),
        tuple(mirror_point(each) for each in case.back),
        tuple(mirror_point(each) for each in case.front),
        tuple(mirror_load(each) for each in case.loads),
        case.kind,
    )


@EVERY
def test_mirror_image_has_the_branches_the_other_way_round(case):
    one, two = case.mechanism(), image(case).mechanism()
    assert one.restitution == pytest.approx(two.restitution[::-1], rel=1e-12)
    first, second = one.oscillator, two.oscillator
    for a, b in ((first.positive, second.negative), (first.negative, second.positive)):
        assert (a.overturning, a.critical) == pytest.approx((b.overturning, b.critical), rel=1e-12)
        same_tables(a, b, 1e-11)


def same_tables(a, b, tolerance, tables=TABLES):
    for name in tables:
        expected = getattr(a, name)
        np.testing.assert_allclose(
            getattr(b, name), expected, rtol=tolerance, atol=tolerance * np.abs(expected).max(), err_msg=name
        )


def scaled(case, s):
    """Lengths times s: masses times s^3, inertias s^5, forces s^3."""
    loads = []
    for each in case.loads:
        at = tuple(s * x for x in each.at)
        if isinstance(each, PointMass):
            loads.append(replace(each, at=at, mass=s**3 * each.mass))
        elif isinstance(each, Force):
            loads.append(replace(each, at=at, force=tuple(s**3 * x for x in each.force)))
        else:
            anchor = each.anchor and tuple(s * x for x in each.anchor)
            loads.append(replace(each, at=at, anchor=anchor, pull=s**3 * each.pull))
    blocks = tuple(RigidBlock(s**3 * b.mass, tuple(s * x for x in b.centroid), s**5 * b.inertia) for b in case.blocks)
    front, back = (tuple((s * x, s * z) for x, z in hinges) for hinges in (case.front, case.back))
    return HingedBlocks(blocks, front, back, tuple(loads), case.kind)


@EVERY
@pytest.mark.parametrize("s", [0.1, 3.7])
def test_lengths_times_s(case, s):
    """p^2 goes with 1/s; multiplier, rotations and restitution stay."""
    one, two = case.mechanism(), scaled(case, s).mechanism()
    assert two.restitution == pytest.approx(one.restitution, rel=1e-12)
    for a, b in zip(one.oscillator.branches, two.oscillator.branches, strict=True):
        first, second = a.linearised, b.linearised
        assert second.p**2 * s == pytest.approx(first.p**2, rel=1e-9)
        assert (second.multiplier, second.overturning) == pytest.approx((first.multiplier, first.overturning), rel=1e-9)
        assert b.overturning == pytest.approx(a.overturning, rel=1e-11)
        np.testing.assert_allclose(multiplier(b), multiplier(a), rtol=1e-9, atol=1e-9)


def welded(body):
    """Three bodies of uneven size, one far out, that are this one when they move together."""
    m, (x, z), J = body.mass, body.centroid, body.inertia
    arms = np.array([(0.3, 0.4), (-0.2, 0.1), (0.0, 0.0)]) * np.sqrt(J / m)
    masses = np.array([0.3, 0.25, 0.45]) * m
    arms[2] = -(masses[:2] @ arms[:2]) / masses[2]
    left = (J - masses @ (arms**2).sum(axis=1)) / 3
    parts = [
        planar_body_from_values(
            mass=float(mass), centroid=(float(x + dx), float(z + dz)), inertia=float(left), name="part"
        )
        for mass, (dx, dz) in zip(masses, arms, strict=True)
    ]
    return join_planar(parts, name=body.name)


@EVERY
def test_blocks_of_welded_bodies_are_the_same_mechanism(case):
    one, two = case.mechanism(), case.mechanism(weld=welded)
    assert two.restitution == pytest.approx(one.restitution, rel=1e-9)
    for a, b in zip(one.oscillator.branches, two.oscillator.branches, strict=True):
        same_tables(a, b, 1e-9)


@EVERY
def test_a_bearing_mass_is_a_body_welded_on(case):
    """Without rotary inertia, on the last block; only in sum m x'^2 it counts at its own place."""
    last = len(case.blocks) - 1
    at = tuple(x + d for x, d in zip(case.blocks[last].centroid, (0.1, 0.5), strict=True))
    mass = case.blocks[last].mass / 5
    bodies = [
        body_of_block(case.blocks[last]),
        planar_body_from_values(mass=mass, centroid=at, inertia=0.0, name="floor"),
    ]
    joint = join_planar(bodies, name="b")
    block = RigidBlock(joint.mass, joint.centroid, joint.inertia)
    heavier = replace(case, blocks=(*case.blocks[:-1], block))
    loaded = replace(case, loads=(*case.loads, PointMass("floor", mass, at, True, last)))
    assert heavier.mechanism().restitution == pytest.approx(loaded.mechanism().restitution, rel=1e-12)
    for (_, a), (_, b) in zip(sides(heavier), sides(loaded), strict=True):
        same_tables(a, b, 1e-11, tables=[name for name in TABLES if name != "participation"])


@pytest.mark.parametrize("rule", ["momentum", "thesis"])
@EVERY
def test_no_impact_adds_energy(case, rule):
    """1/2 I phi'^2 of the branch that follows, after the impact, is at most that of the branch before."""
    kept = case.mechanism(restitution=rule).restitution
    before, after = (virtual_work(chain, np.zeros(1)).inertia[0] for chain in case.chains())
    for factor, (ending, starting) in zip(kept, ((before, after), (after, before)), strict=True):
        assert 0.0 <= factor**2 * starting <= ending * (1 + 1e-12)


SOME = st.floats(0.2, 5.0)  # times a mass or inertia
ASIDE = st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))


def jogged(point, way, by):
    return (point[0] + by * way[0], point[1] + by * way[1])


@st.composite
def frames(draw):
    """Two legs and a beam whose masses, centres and hinges lie about those of an uneven frame."""
    blocks = tuple(
        RigidBlock(b.mass * draw(SOME), jogged(b.centroid, draw(ASIDE), 0.2), b.inertia * draw(SOME)) for b in UNEVEN
    )
    return blocks, *(tuple(jogged(hinge, draw(ASIDE), 0.3) for hinge in hinges) for hinges in UNEVEN_HINGES)


@given(frame=frames())
def test_no_impact_of_any_frame_adds_energy(frame):
    """Momentum kept over the mechanism, or brought to rest where too squat."""
    blocks, front, back = frame
    ending, starting = Chain(blocks, front), mirror_chain(blocks, back)
    kept = find_restitution(
        "momentum", ending=ending, starting=starting, rules=FOUR_HINGE.impacts, kind="four-hinge", name="m"
    )
    assert (kept.value == 0.0) == (kept.stopped is not None)
    before, after = (virtual_work(chain, np.zeros(1)).inertia[0] for chain in (ending, starting))
    assert kept.value**2 * after <= before * (1 + 1e-12)


@pytest.mark.parametrize("name", ["leaning wall", "two blocks", "asymmetric portal", "arch"])
def test_free_motion_keeps_its_energy_between_impacts(name):
    """The exact equation, with I' phi'^2 / 2: peaks and impact velocities, through impacts that keep restitution."""
    rocker = (CASES[name].mechanism()).oscillator
    start = 0.6 * rocker.positive.overturning
    found = free_rocking(rocker, rotation=start, duration=12.0)
    assert found.peak_rotation.size >= 4
    peaks = np.concatenate([[start], found.peak_rotation])
    for number in range(4):
        side = rocker.branches[int(peaks[number] < 0)]
        other = rocker.branches[int(peaks[number + 1] < 0)]
        speed = abs(found.impact_velocity[number])
        assert energy(side, abs(peaks[number])) == pytest.approx(0.5 * side.inertia[0] * speed**2, rel=1e-7)
        left = 0.5 * other.inertia[0] * (side.restitution * speed) ** 2
        assert energy(other, abs(peaks[number + 1])) == pytest.approx(left, rel=1e-7)


@pytest.mark.parametrize("name", ["leaning wall", "two blocks", "asymmetric portal", "arch"])
def test_time_to_the_first_impact_by_quadrature(name):
    """t = integral of sqrt(I / 2 (E_0 - E)) d phi, with phi = phi_0 (1 - u^2) against the singular end."""
    rocker = (CASES[name].mechanism()).oscillator
    side, start = rocker.positive, 0.6 * rocker.positive.overturning
    top, inertia = float(energy(side, start)), interpolant(side.rotation, side.inertia)

    def pace(u):
        phi = start * (1 - u**2)
        return 2 * start * u * np.sqrt(inertia(phi) / (2 * (top - energy(side, phi))))

    time = quad(pace, 1e-7, 1.0, epsabs=1e-12, epsrel=1e-10)[0]
    found = free_rocking(rocker, rotation=start, duration=2 * time)
    assert found.impact_time[0] == pytest.approx(time, rel=1e-6)  # 1e-7 of the start is left out


PARTS = {
    "two-block": {
        "direction": [1, 0, 0],
        "loads": [{"kind": "overburden", "force": "21 kN", "eccentricity": 0.1}],
    },
    "four-hinge": {
        "hinges": {"A": [0.8, 0], "B": [0, 4], "C": [3.6, 4], "D": [4.6, 0]},
        "hinges_negative": {"A": [0, 0], "B": [0.8, 4], "C": [4.6, 4], "D": [3.6, 0]},
    },
}
BOXES = {
    "two-block": [("a", 0.5, 2.6, 0.0, 0.0), ("b", 0.5, 1.6, 0.0, 2.6)],
    "four-hinge": [("a", 0.8, 4.0, 0.4, 0.0), ("b", 4.6, 0.7, 2.3, 4.0), ("c", 1.0, 4.0, 4.1, 0.0)],
}


@pytest.mark.parametrize("kind", BOXES)
def test_a_block_of_several_bodies_in_a_project_file(tmp_path, kind):
    """Each box, and then each cut into a lower and an upper part that move as one."""
    found = []
    for share in (1.0, 0.37):
        bodies, blocks = {}, []
        for name, t, h, x, z in BOXES[kind]:
            parts = [(f"{name}1", share * h, z), (f"{name}2", h - share * h, z + share * h)][: 2 if share < 1 else 1]
            blocks.append([part for part, _, _ in parts])
            bodies |= {part: projects.wall(t, 1.0, high, base=[x, 0, low]) for part, high, low in parts}
        text = project_toml(bodies=bodies, mechanisms={"m": projects.block(*blocks, kind=kind, **PARTS[kind])})
        found.append(mechanism_of(tmp_path, text))
    assert found[0].restitution == pytest.approx(found[1].restitution, rel=1e-9)
    for a, b in zip(*(each.oscillator.branches for each in found), strict=True):
        same_tables(a, b, 1e-9)


def pushed(case):
    """The forces at the hinges of both branches, on level faces."""
    made, hinges = case.mechanism(), len(case.front)
    faces = tuple(Face(LOOKS_DOWN) if len(case.blocks) == number == 2 else Face() for number in range(hinges))
    return hinge_forces(replace(made, faces=(faces, faces)))


@EVERY
def test_supports_carry_weights_and_forces_and_what_the_ground_pushes_with(case):
    """Over the whole chain: sum H + lambda M g + sum F_x = 0, sum V - sum of the weights borne + sum F_z = 0."""
    found = pushed(case)
    for chain, name in zip(case.chains(), ("positive", "negative"), strict=True):
        own = [each for each in found if each.branch == name]
        ends = (own[0], *own[-1:] * (len(own) > 1))
        ties = [each for each in chain.loads if isinstance(each, Tie) and (each.both or taut(chain, each))]
        given = [each.force for each in chain.loads if isinstance(each, Force)] + [pull_at_rest(tie) for tie in ties]
        borne = sum(b.mass for b in chain.blocks)
        borne += sum(each.mass for each in chain.loads if isinstance(each, PointMass) and each.bearing)
        along = sum(each.horizontal for each in ends) + chain.mass * own[0].acceleration + sum(x for x, _ in given)
        up = sum(each.vertical for each in ends if not each.held) - g * borne + sum(z for _, z in given)
        assert (along, up) == pytest.approx((0.0, 0.0), abs=1e-9 * g * borne)


@EVERY
def test_forces_of_the_mirror_image_are_those_of_the_other_branch(case):
    two = {each.hinge: each for each in pushed(image(case))}
    for one in pushed(case):
        other = two[one.hinge.removesuffix("'") if "'" in one.hinge else f"{one.hinge}'"]
        expected = (other.horizontal, other.vertical, other.acceleration)
        assert (one.horizontal, one.vertical, one.acceleration) == pytest.approx(expected, rel=1e-9, abs=1e-6)
