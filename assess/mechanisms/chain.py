r"""A planar chain of rigid blocks with one degree of freedom: hinges, joints, motion, virtual work.

Signs, for the branch of positive rotation (a negative branch is a chain mirrored in z, with hinges of its own):

        z ^        direction -->  (x)
          |
          |      +-------+
          |      |   o   |  centroid, at (-b, h) from the hinge: b = R sin(alpha), h = R cos(alpha)
          |      |       |
          |      +-------A  )   phi > 0 turns the block about A towards the direction of motion (clockwise)
          +--------------------> x

A record is positive when the ground accelerates along the direction; inertia then pushes towards phi < 0.

    one block          two blocks                  three blocks

       +-----+            C  slides up and down        B------------C
       |     |           /|                           /|            |\
       |     |          / |  block 2 turns back        |  block 2   |
       |     |         B  |                            |            |
       |     |          \ |  block 1 turns on      block 1       block 3
       +-----A           \A                           A            D

In the complex plane x + iz a vector r of a block that has turned by theta is r exp(-i theta): a derivative is a factor
-i theta', and a second one makes -i theta'' - theta'^2. The arms are the vectors from hinge to hinge:

    slider     Re(arm 1 + arm 2) stays        sum Im(arm) theta' = 0       sum Im(arm) theta'' = sum Re(arm) theta'^2
    pinned     arm 1 + arm 2 + arm 3 stays    sum arm theta' = 0           sum arm theta'' = i sum arm theta'^2

Virtual work, with x', z' the derivatives of places with respect to phi, of masses m and forces F:

    I = sum m (x'^2 + z'^2) + J theta'^2      dV/dphi = sum m g z'      M = sum F.r'      B = sum m x'      C = sum m z'
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import hypot

import numpy as np

from assess.errors import FallingError, MechanismError
from assess.interfaces.contact import JointLaw, JointModel
from assess.interfaces.section import ContactSection
from assess.loads.load import (
    Force,
    ForceOrTie,
    Load,
    Point,
    PointMass,
    Tie,
    length_to_anchor,
    mirror_load,
    pull_at_rest,
    stretches,
)
from assess.messages.message import Value, lengths
from assess.short_repr import ShortRepr
from spectra.arrays import ComplexArray, FloatArray
from spectra.gravity import g

HINGES = {1: 1, 2: 3, 3: 4}  # of a chain by its number of blocks
ROUNDING = 1e-6  # m: files of models round coordinates to a tenth of it
STRAIGHT = 1e-6  # sine of an angle: three hinges this near one line are a dead point
APART = 1e4  # ratio of the largest distance between hinges to the least; beyond, rounding moves the corners of the loop
NEAR_TOP_HINGE = 1e-6  # of a wall's height: a load this near the hinge at the top acts through its joint
FLAT = 1e-6  # of the geometric limit, at which the rates of a loop grow without bound: a loop stays this far from it
TOUCH = 1e-12  # of a cosine: a portal of two equal columns just reaches its flat position, which rounding may hide


@dataclass(frozen=True)
class RigidBlock:
    """A rigid block in the plane of motion: mass [kg], centroid (x, z) [m], inertia about it [kg m2]."""

    mass: float
    centroid: Point
    inertia: float


@dataclass(frozen=True, repr=False)
class Chain:
    """Blocks from the base on, the hinges they turn about, and loads.

    One block has the hinge A at its base and a free end. Two blocks have A, B between them and C at the top, which
    slides on the vertical. Three blocks have A, B, C and D, which is fixed as A is.

    joints : the joint under each hinge, None for a rigid hinge; empty if all are rigid
    level : whether it moves in a level plane, seen from above (x, s): weights then do no work
    parts : the parts of the blocks, each with the number of its block, None for a part at rest; needed only for an
        impact between chains that divide the same masonry in different ways
    """

    blocks: tuple[RigidBlock, ...]
    hinges: tuple[Point, ...]
    loads: tuple[Load, ...] = ()
    parts: tuple[tuple[RigidBlock, int | None], ...] = ()
    joints: tuple[Joint | None, ...] = ()
    level: bool = False

    def __repr__(self) -> str:
        hinges = ", ".join(
            f"{hinge_name} ({x:.4g}, {z:.4g})"
            for hinge_name, (x, z) in zip(hinge_names(self), self.hinges, strict=True)
        )
        blocks, loads = len(self.blocks), len(self.loads)
        return f"Chain({blocks} block{'s'[: blocks != 1]}, hinges {hinges} m, {loads} load{'s'[: loads != 1]})"

    @property
    def mass(self) -> float:
        """Total moved mass, bearing or not [kg]."""
        carried = sum(load.mass for load in self.loads if isinstance(load, PointMass))
        return sum(block.mass for block in self.blocks) + carried

    @property
    def actions(self) -> tuple[ForceOrTie, ...]:
        """The forces and ties on the chain."""
        return tuple(load for load in self.loads if not isinstance(load, PointMass))


@dataclass(frozen=True, eq=False)
class ChainPair:
    """The chains of both directions of a mechanism with the restitution of their impacts: all that its motion needs.

    name : of the mechanism, for errors
    positive, negative : the chain of each branch, in that branch's own sign; negative None for one-sided rocking
    restitution : of the impacts that end the positive and the negative branch [-]
    """

    name: str
    positive: Chain
    negative: Chain | None
    restitution: tuple[float, float]

    @property
    def has_joints(self) -> bool:
        """Whether a hinge presses on a joint that deforms or crushes."""
        return any(joint is not None for joint in self.positive.joints)


FacingBlocks = tuple[int | None, int]

FACING_BLOCKS: dict[int, tuple[FacingBlocks, ...]] = {
    1: ((None, 0),),
    2: ((None, 0), (0, 1), (None, 1)),
    3: ((None, 0), (0, 1), (2, 1), (None, 2)),
}
"""By the number of blocks, for each hinge: the block whose face stays with the joint (None: ground, or the support at
the top of a wall), and the block whose corner presses on it. The block nearer to the ground holds the face."""


@dataclass(frozen=True)
class Joint:
    """The contact at a hinge, whose compressed edge is the hinge itself.

    inward : unit vector (x, z) from the hinge along the joint, in the plane of motion
    section : of the contact, seen in the direction in which it is compressed
    law : stiffness and strength
    model : "rigid" with a strength: the plastic block; "flexible"; "semi-flexible": inertia about a fixed hinge,
        a_SF inside the edge; "flexible-thesis": inertia about the resultant, where "flexible" takes it about the
        instantaneous centre of the faces
    """

    inward: tuple[float, float]
    section: ContactSection
    law: JointLaw
    model: JointModel


def hinge_names(chain: Chain) -> str:
    """Return the letters of the hinges, A at the base."""
    return "ABCD"[: len(chain.hinges)]


def top_loads(chain: Chain) -> tuple[Load, ...]:
    """Return the loads at the hinge at the top of a wall of two blocks, which act through its joint."""
    x, z = chain.hinges[2]
    near = NEAR_TOP_HINGE * (z - chain.hinges[0][1])
    return tuple(load for load in chain.loads if load.block == 1 and hypot(load.at[0] - x, load.at[1] - z) <= near)


def mirror_point(point: Point) -> Point:
    """Reflect a point in the vertical through the origin."""
    return (-point[0], point[1])


def mirror_chain(
    blocks: Sequence[RigidBlock],
    hinges: Sequence[Point],
    loads: Sequence[Load] = (),
    joints: Sequence[Joint | None] = (),
) -> Chain:
    """Return the chain of the negative branch in its own sign.

    Parameters
    ----------
    blocks, loads : as in the building
    hinges : of negative rotation, as in the building [m]
    joints : under these hinges, None for a rigid one
    """
    return Chain(
        tuple(RigidBlock(block.mass, mirror_point(block.centroid), block.inertia) for block in blocks),
        tuple(mirror_point(hinge) for hinge in hinges),
        tuple(mirror_load(load) for load in loads),
        joints=tuple(joint and replace(joint, inward=mirror_point(joint.inward)) for joint in joints),
    )


def require_movable(chain: Chain, *, name: str) -> None:
    """Raise MechanismError, with the hinges at fault, for a chain that cannot move with one degree of freedom."""
    count = len(chain.blocks)
    if len(chain.hinges) != HINGES.get(count):
        raise MechanismError(
            f'mechanism "{name}": {count} blocks with {len(chain.hinges)} hinges; that is no mechanism'
        )
    size = max((hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(chain.hinges)), default=1.0)
    for (first, a), (second, b) in pairwise(zip(hinge_names(chain), chain.hinges, strict=True)):
        if hypot(b[0] - a[0], b[1] - a[1]) <= STRAIGHT * size:
            raise MechanismError(
                f'mechanism "{name}": hinges {first} and {second} coincide at {point_text(a)}; move one'
            )
        if hypot(b[0] - a[0], b[1] - a[1]) * APART < size:
            raise MechanismError(
                f'mechanism "{name}": hinges {first} and {second} lie {hypot(b[0] - a[0], b[1] - a[1]):.4g} m apart, '
                f"others {size:.4g} m; is one of them in another unit?"
            )
    if count == 2 and abs(_rise(chain.hinges[1], chain.hinges[2])) <= STRAIGHT:
        raise MechanismError(
            f'mechanism "{name}": hinges B {point_text(chain.hinges[1])} and '
            f"C {point_text(chain.hinges[2])} lie at one elevation, so the block between them cannot turn while "
            "C slides on the vertical; move one"
        )
    if count == 3 and abs(_bend(*chain.hinges[1:])) <= STRAIGHT:
        places = ", ".join(
            f"{hinge_name} {point_text(at)}" for hinge_name, at in zip("BCD", chain.hinges[1:], strict=True)
        )
        raise MechanismError(
            f'mechanism "{name}": hinges {places} lie on one line, so the loop is locked; '
            "put them at opposite faces of the blocks"
        )


def point_text(point: Point) -> str:
    """Return a point as errors print it."""
    return f"({metres_text(point[0])}, {metres_text(point[1])}) m"


def point_values(point: Point) -> dict[str, Value]:
    """Return a point in the plane of motion as values x, z of a message.

    Parameters
    ----------
    point : (x, z) [m]
    """
    return lengths(x=point[0], z=point[1])


def metres_text(length: float) -> str:
    """Return a coordinate [m] to four figures; 0 for rounding about 0."""
    return f"{0.0 if abs(length) < ROUNDING else length:.4g}"


@dataclass(frozen=True, repr=False)
class ChainMotion(ShortRepr):
    """A chain at rotations of its leading block.

    rotation : phi [n] [rad]
    angle, rate : theta and theta' of each block with respect to phi [blocks, n]; clockwise
    turn : exp(-i theta) [blocks, n]
    hinges : of the chain at rest, x + iz [m]
    """

    rotation: FloatArray
    angle: FloatArray
    turn: ComplexArray
    rate: FloatArray
    hinges: ComplexArray


@dataclass(frozen=True, repr=False)
class PointPath(ShortRepr):
    """A point over rotation [n]: place x, z [m], and its derivatives with respect to phi [m]."""

    x: FloatArray
    z: FloatArray
    dx: FloatArray
    dz: FloatArray


def move(chain: Chain, rotation: FloatArray) -> ChainMotion:
    """Rotate a chain.

    Parameters
    ----------
    chain : at rest
    rotation : of its leading block, below `limit(chain)` [n] [rad]
    """
    hinges = np.array([complex(*hinge) for hinge in chain.hinges])
    arms = np.diff(hinges)[:, None]
    lead = np.exp(-1j * rotation)
    if len(chain.blocks) == 1:
        return ChainMotion(rotation, rotation[None, :], lead[None, :], np.ones((1, rotation.size)), hinges)
    turned = close_loop(arms, lead=arms[0] * lead, span=arms.sum(axis=0))
    rate = np.concatenate([np.ones((1, rotation.size)), solve_block_rates(turned, -turned[0])])
    angle = np.concatenate([rotation[None, :], -np.angle(turned[1:] / arms[1:])])
    return ChainMotion(rotation, angle, np.exp(-1j * angle), rate, hinges)


def trace_point(motion: ChainMotion, *, block: int, at: Point) -> PointPath:
    """Return the path of a point of a block.

    Parameters
    ----------
    motion : of the chain
    block : its number, 0 at the base
    at : the point (x, z) at rest [m]
    """
    here = np.full(motion.rotation.size, motion.hinges[0])
    derivative = np.zeros_like(here)
    for j in range(block + 1):
        end = motion.hinges[j + 1] if j < block else complex(*at)
        arm = (end - motion.hinges[j]) * motion.turn[j]
        here = here + arm
        derivative = derivative - 1j * motion.rate[j] * arm
    return PointPath(here.real, here.imag, derivative.real, derivative.imag)


def geometric_limit(chain: Chain) -> float:
    """Return the rotation at which the loop is stretched or folded flat and can move no further, at most pi [rad]."""
    hinges = [complex(*hinge) for hinge in chain.hinges]
    if len(chain.blocks) == 1:
        return np.pi
    arms = [b - a for a, b in pairwise(hinges)]
    lead, span = arms[0], sum(arms)
    start: float
    if len(chain.blocks) == 2:
        reached = [(span.real - side * abs(arms[1])) / abs(lead) for side in (1, -1)]
        start = -float(np.angle(lead))
    else:
        chords = (abs(arms[1]) + abs(arms[2]), abs(arms[1]) - abs(arms[2]))
        product = 2 * abs(span) * abs(lead)
        reached = [(abs(span) ** 2 + abs(lead) ** 2 - chord**2) / product for chord in chords] if product else []
        start = float(np.angle(span / lead)) if product else 0.0
    turns = [
        float(sign * np.arccos(min(max(k, -1.0), 1.0)) - start)
        for k in reached
        if abs(k) <= 1.0 + TOUCH
        for sign in (1, -1)
    ]
    return min([turn % (2 * np.pi) for turn in turns] + [np.pi])


def close_loop(arms: ComplexArray, *, lead: ComplexArray, span: ComplexArray) -> ComplexArray:
    """Rotate the arms of two or three blocks so that they close the loop [blocks, n] [m].

    arms : from hinge to hinge at rest [blocks, n or 1]; lead : the first one, rotated [n]; span : from the first
    hinge to the last one [n or 1]; of two blocks, on a slider, its horizontal part counts.
    """
    close = _close_on_slider if len(arms) == 2 else _close_pinned
    return np.concatenate([lead[None, :], close(arms, span - lead)])


def solve_block_rates(turned: ComplexArray, load: ComplexArray) -> FloatArray:
    """Solve sum(arm turning) = load [n] for the turnings of all blocks but the first [blocks - 1, n].

    Two blocks, on a slider, satisfy only its horizontal part, the imaginary one, since -i rotates an arm.
    """
    return (_slider_rates if len(turned) == 2 else _pinned_rates)(turned, load)


def cross(a: ComplexArray, b: ComplexArray) -> FloatArray:
    """Return the cross product of two vectors, or the anticlockwise moment about the origin of forces b at places a."""
    return np.asarray((np.conj(a) * b).imag)


FACES = {
    1: "A lies on the face ahead",
    2: "A and C lie on the face ahead, B on the one behind",
    3: "as a portal sways, A and D lie on the faces ahead of its posts, B and C on those behind",
}
"""Faces on which hinges must lie for the blocks to rise, by the number of blocks; ahead is the way of the branch."""


@dataclass(frozen=True, repr=False)
class Work(ShortRepr):
    """The sums of virtual work at rotations [n]: I, dV/dphi, M of the given forces, B, sum m x'^2, C."""

    inertia: FloatArray
    weight: FloatArray
    moment: FloatArray
    excitation: FloatArray
    participation: FloatArray
    lift: FloatArray

    @property
    def restoring(self) -> FloatArray:
        """dV/dphi - M [n] [N m]."""
        return self.weight - self.moment


def virtual_work(chain: Chain, rotation: FloatArray) -> Work:
    """Return the sums of virtual work over blocks and loads.

    A non-bearing mass adds horizontal inertia to I, B and sum m x'^2 only (thesis 3.21 leaves it out of I, though it
    moves with the wall).

    Parameters
    ----------
    chain : on rigid hinges
    rotation : of its leading block [n] [rad]
    """
    motion = move(chain, rotation)
    inertia, moment, excitation, participation, lift = (np.zeros_like(rotation) for _ in range(5))
    for rate, block in zip(motion.rate, chain.blocks, strict=True):
        inertia += block.inertia * rate**2
    blocks = [(block.mass, block.centroid, True, number) for number, block in enumerate(chain.blocks)]
    points = [(load.mass, load.at, load.bearing, load.block) for load in chain.loads if isinstance(load, PointMass)]
    for mass, at, bearing, number in (*blocks, *points):
        moved = trace_point(motion, block=number, at=at)
        excitation += mass * moved.dx
        participation += mass * moved.dx**2
        inertia += mass * (moved.dx**2 + moved.dz**2 if bearing else moved.dx**2)
        lift += mass * moved.dz if bearing and not chain.level else 0.0
    for load in chain.loads:
        if not isinstance(load, PointMass):
            moment += generalised_moment(load, trace_point(motion, block=load.block, at=load.at))
    return Work(inertia, g * lift, moment, excitation, participation, lift)


def uplift_multiplier(chain: Chain) -> float:
    """Return the uplift multiplier of a chain on rigid hinges [-]."""
    work = virtual_work(chain, np.zeros(1))
    return float(work.restoring[0] / (g * work.excitation[0]))


def generalised_moment(load: Force | Tie, moved: PointPath) -> FloatArray:
    """Return the generalised moment F.r' of a force or tie [n] [N m]; positive overturns."""
    if isinstance(load, Force):
        return load.force[0] * moved.dx + load.force[1] * moved.dz
    if load.anchor is None:
        along, up = load.direction or (0.0, 0.0)
        work = load.tension * (along * moved.dx + up * moved.dz)
    else:
        to_x, to_z = load.anchor[0] - moved.x, load.anchor[1] - moved.z
        far = length_to_anchor(load, to_x, to_z)
        if stretches(load):
            at_rest = hypot(load.anchor[0] - load.at[0], load.anchor[1] - load.at[1], load.aside)
            return load.pull_at(far - at_rest) * (to_x * moved.dx + to_z * moved.dz) / far
        work = load.tension * (to_x * moved.dx + to_z * moved.dz) / far
    slack = not load.both and work[0] > 0.0  # the point moves along the pull of the tie: the tie shortens
    return np.zeros_like(work) if slack else np.asarray(work)


def require_stable(chain: Chain, *, name: str, beside: str = "") -> None:
    """Raise MechanismError for a chain that falls by itself, or that a push along the direction does not start.

    beside : of the error, see `FallingError`
    """
    rest = virtual_work(chain, np.zeros(1))
    if rest.restoring[0] <= 0.0:
        raise FallingError(
            f'mechanism "{name}": already falling: its weights resist with {rest.weight[0]:.4g} N m at rest, '
            f"{_overturning_causes(chain, rest)}",
            rest.restoring[0] / (g * rest.excitation[0]) if rest.excitation[0] > 0.0 else None,
            beside=beside,
        )
    if rest.excitation[0] <= 0.0:
        raise MechanismError(
            f'mechanism "{name}": a push along the direction does not start it (sum m x\' = {rest.excitation[0]:.4g} '
            "kg m); its hinges move the masses the other way: check them"
        )


def _rise(a: Point, b: Point) -> float:
    """Return the sine of the slope of the line a b."""
    return (b[1] - a[1]) / hypot(b[0] - a[0], b[1] - a[1])


def _bend(a: Point, b: Point, c: Point) -> float:
    """Return the sine of the angle between a b and b c."""
    (ux, uz), (vx, vz) = (b[0] - a[0], b[1] - a[1]), (c[0] - b[0], c[1] - b[1])
    return (ux * vz - uz * vx) / (hypot(ux, uz) * hypot(vx, vz))


def _close_on_slider(arms: ComplexArray, chord: ComplexArray) -> ComplexArray:
    """Return the second arm [1, n] of a chain on a slider, whose horizontal part is that of the chord [n]."""
    level = chord.real
    return np.asarray(level + 1j * np.sign(arms[1].imag) * np.sqrt(np.maximum(np.abs(arms[1]) ** 2 - level**2, 0.0)))[
        None, :
    ]


def _close_pinned(arms: ComplexArray, chord: ComplexArray) -> ComplexArray:
    """Return the second and third arm [2, n] of a pinned chain: the triangle B C D over the chord from B to D."""
    b, c = np.abs(arms[1]), np.abs(arms[2])
    length = np.abs(chord)
    along = (length**2 + b**2 - c**2) / (2 * length)
    side = np.sign((arms[1] * np.conj(arms[1] + arms[2])).imag)
    second = chord / length * (along + 1j * side * np.sqrt(np.maximum(b**2 - along**2, 0.0)))
    return np.array([second, chord - second])


def _slider_rates(arms: ComplexArray, load: ComplexArray) -> FloatArray:
    """Return the turning [1, n] of the second block on a slider, from the horizontal part of `load` [n]."""
    return np.asarray(load.imag / arms[1].imag, dtype=np.float64)[None, :]


def _pinned_rates(arms: ComplexArray, load: ComplexArray) -> FloatArray:
    """Solve arm 2 turning 2 + arm 3 turning 3 = `load` [n] for the turnings of the second and third block [2, n]."""
    turnings = np.array([cross(load, arms[2]), cross(arms[1], load)])
    return np.asarray(turnings / cross(arms[1], arms[2]), dtype=np.float64)


def _overturning_causes(chain: Chain, rest: Work) -> str:
    """Name what makes a chain fall: the forces that overturn it, or else the faces on which its hinges lie."""
    moments = {load: _moment_at_rest(load, chain) for load in chain.loads if not isinstance(load, PointMass)}
    forces = sorted((load for load, moment in moments.items() if moment > 0.0), key=lambda load: -moments[load])
    if not forces:
        return f"and no given force overturns it; check its hinges: {FACES[len(chain.blocks)]}"
    named = "; ".join(_load_text(load) for load in forces[:3])
    return f"its given forces overturn with {rest.moment[0]:.4g} N m: {named}; check loads and hinges"


def _moment_at_rest(load: Force | Tie, chain: Chain) -> float:
    """Return the generalised moment of a force or tie at rest [N m]; positive overturns."""
    return float(generalised_moment(load, trace_point(move(chain, np.zeros(1)), block=load.block, at=load.at))[0])


def _load_text(load: Force | Tie) -> str:
    """Describe a force or tie by its name, its components at rest, and its source."""
    along, up = load.force if isinstance(load, Force) else pull_at_rest(load)
    found = f" ({load.source})" if load.source else ""
    return f'load "{load.name}" with H = {abs(along) / 1e3:.4g} kN, V = {up / 1e3:+.4g} kN up{found}'
