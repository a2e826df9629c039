"""A planar chain of rigid blocks with one degree of freedom: its blocks, its hinges, and the joints under them.

Its motion and the virtual work of its weights and loads are in `virtual_work`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import hypot

from assess.errors import MechanismError
from assess.interfaces.contact import JointLaw, JointModel
from assess.interfaces.section import ContactSection
from assess.loads.load import Load, Point, PointMass, mirror_load
from assess.messages.message import Value, lengths

HINGES = {1: 1, 2: 3, 3: 4}  # of a chain by its number of blocks; the far end is described in motion.py
ROUNDING = 1e-9  # m: accuracy of coordinates
STRAIGHT = 1e-6  # sine of an angle: three hinges this near one line are a dead point
APART = 1e4  # ratio of the largest distance between hinges to the least; beyond, rounding moves the corners of the loop


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
    parts : the parts of the blocks, each with the number of its block, None for a part at rest; needed only for an
        impact between chains that divide the same masonry in different ways
    """

    blocks: tuple[RigidBlock, ...]
    hinges: tuple[Point, ...]
    loads: tuple[Load, ...] = ()
    parts: tuple[tuple[RigidBlock, int | None], ...] = ()
    joints: tuple[Joint | None, ...] = ()

    def __repr__(self) -> str:
        hinges = ", ".join(
            f"{letter} ({x:.4g}, {z:.4g})" for letter, (x, z) in zip(hinge_names(self), self.hinges, strict=True)
        )
        blocks, loads = len(self.blocks), len(self.loads)
        return f"Chain({blocks} block{'s'[: blocks != 1]}, hinges {hinges} m, {loads} load{'s'[: loads != 1]})"

    @property
    def mass(self) -> float:
        """Total moved mass, bearing or not [kg]."""
        carried = sum(load.mass for load in self.loads if isinstance(load, PointMass))
        return sum(block.mass for block in self.blocks) + carried


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


def hinge_names(chain: Chain) -> str:
    """Return the letters of the hinges, A at the base."""
    return "ABCD"[: len(chain.hinges)]


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
        places = ", ".join(f"{letter} {point_text(at)}" for letter, at in zip("BCD", chain.hinges[1:], strict=True))
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


def _rise(a: Point, b: Point) -> float:
    """Return the sine of the slope of the line a b."""
    return (b[1] - a[1]) / hypot(b[0] - a[0], b[1] - a[1])


def _bend(a: Point, b: Point, c: Point) -> float:
    """Return the sine of the angle between a b and b c."""
    (ux, uz), (vx, vz) = (b[0] - a[0], b[1] - a[1]), (c[0] - b[0], c[1] - b[1])
    return (ux * vz - uz * vx) / (hypot(ux, uz) * hypot(vx, vz))


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

    Attributes
    ----------
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
