"""A collapse mechanism: as an engineer states one of blocks, and as it is built, with the limits of its motion.

A hinge or another place that is stated is [x, y, z], or (distance along the direction, elevation).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf
from typing import Annotated, ClassVar, Literal

import numpy as np

from assess.declaration import (
    FREE,
    Component,
    Evidence,
    Inclination,
    IsHorizontal,
    KeyFault,
    Length,
    Name,
    Safe,
    SpacePoint,
)
from assess.geometry.planar import Outline
from assess.interfaces.contact import Interface
from assess.loads.load import (
    LoadDefinition,
    Place,
    PointMass,
    SourceParts,
    Tie,
    block_faults,
    direction_keys,
    lasts,
    source_phrase,
)
from assess.mechanisms.branch_table import scan_rotations, travel_on_seat, unseating_rotation
from assess.mechanisms.chain import HINGES, Chain, ChainPair, Joint
from assess.mechanisms.directions import DirectionCandidate, DirectionSweep
from assess.mechanisms.oscillators import ChainActions, Variants, find_variants, mechanism_actions, oscillator_at_start
from assess.mechanisms.restitution import ImpactRules, Restitution
from assess.mechanisms.side_walls import ToothedBlock, toothing_of
from assess.messages.message import Message, Term
from assess.oscillator import BRANCH_NAMES, BranchName, LocalLimit, OpenSeat, Oscillator, Toothing
from spectra.arrays import FloatArray
from spectra.gravity import g

Sides = Literal["one", "two"]
Vector = tuple[Component, Component, Component]
ALONG_X: Vector = (1.0, 0.0, 0.0)
WEAKEST = Evidence("chosen", "either", "the weakest direction, where it is weaker by more than 10 %", safe=Safe.WEAKEST)
DRAWN_HINGES = Evidence("drawn", "either", "the edges as drawn, inside the outline of the contact")
AS_CRACKED = Evidence("drawn", "either", "as the crack is surveyed; the weakest cut computed")


@dataclass(frozen=True, kw_only=True)
class BlockMechanism:
    """What an engineer states of any mechanism of blocks; in a project file hinges stand by their names.

    kind : of mechanism, as project files write it; number_of_blocks : of its blocks
    """

    kind: ClassVar[str]
    number_of_blocks: ClassVar[int] = 1
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """bodies from the base on; an entry may join several that move as one, [["wall", "buttress"]]"""
    label: Annotated[str, FREE] = ""
    """what the report calls it; the name of the table if absent"""
    direction: Annotated[Vector | Literal["sweep"] | None, IsHorizontal(), WEAKEST] = None
    """horizontal, positive rotation topples this way; the weakest if absent (four-hinge: +x); or "sweep\""""
    cut: Annotated[Length | CutPlane | CutAngle | None, Evidence("drawn", "either", "the weakest cut computed")] = None
    """only what lies above moves: an elevation like "4.77 m", or a crack, { point, normal } or { point, angle }"""
    sides: Annotated[
        Sides | None,
        Evidence(
            "chosen",
            "either",
            "as bodies touch it",
            judged="a wall behind stops rocking and takes its energy",
        ),
    ] = None
    """"two", or "one": positive rotation only, the building behind stops the other; if absent, as bodies touch it"""
    loads: tuple[LoadDefinition, ...] = ()
    """[ { kind = "mass", … }, … ]: what it carries, or is pulled by"""
    restitution: Restitution = field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""
    interface: Interface = field(default_factory=Interface)
    """what the hinges press on: { model = "flexible", stiffness = "10 GPa/m", strength, shape }"""
    interfaces: Mapping[str, Interface] = field(default_factory=dict)
    """the same for single hinges of a chain, { A = { … }, B = { … } }"""
    hinges: tuple[Place, ...] | Literal["minimum"] | None = None
    hinges_negative: tuple[Place, ...] | None = None

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        known = "ABCD"[: HINGES[self.number_of_blocks]]
        for hinge_name in self.interfaces:
            if hinge_name not in known:
                yield ("interfaces", hinge_name), f"no such hinge; known: {', '.join(known)}"
        if self.direction == "sweep":
            for path in self.keys_along():
                of = "an eccentricity depends" if path[-1] == "eccentricity" else "two numbers depend"
                yield path, f'{of} on the direction, which is "sweep"; give three numbers, or the direction'
        for number, key, reason in block_faults(self.loads, self.kind, number_of_blocks=self.number_of_blocks):
            yield ("loads", number, key), reason

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of all bodies that move."""
        return tuple(body for block in self.blocks for body in block)

    @property
    def neighbours(self) -> tuple[str, ...]:
        """The names of bodies that do not move and between which it stands."""
        return ()

    @property
    def towards(self) -> Vector:
        """The direction as a vector, +x where it is absent; where it is sought, it is put in its place beforehand."""
        assert self.direction != "sweep"
        return ALONG_X if self.direction is None else self.direction

    @property
    def along(self) -> FloatArray:
        """The direction as a unit vector [3]."""
        towards = np.asarray(self.towards)
        return towards / float(np.linalg.norm(towards))

    @property
    def two_sided(self) -> bool:
        """Whether it rocks both ways; where `sides` is sought, it is put in its place beforehand."""
        return self.sides != "one"

    @property
    def hinge_points(self) -> tuple[Place, ...] | None:
        """The hinges of positive rotation where they are given as points."""
        return None if self.hinges == "minimum" else self.hinges

    def interface_at(self, hinge_name: str) -> Interface:
        """Return what the hinge of this name presses on."""
        return self.interfaces.get(hinge_name, self.interface)

    def keys_along(self) -> Iterator[tuple[str | int, ...]]:
        """Name what is given in the plane of motion: two numbers of loads and hinges, and the joints of an arch."""
        for number, load in enumerate(self.loads):
            yield from (("loads", number, name) for name in direction_keys(load))
        for key, given in (("hinges", self.hinge_points), ("hinges_negative", self.hinges_negative)):
            yield from ((key, hinge_name) for hinge_name, at in zip("ABCD", given or (), strict=False) if len(at) == 2)


@dataclass(frozen=True)
class CutPlane:
    """An inclined crack."""

    other_keys: ClassVar[Mapping[str, str]] = {"angle": "beside normal; remove one of them"}
    point: Annotated[SpacePoint, AS_CRACKED]
    """a point of the plane [x, y, z]"""
    normal: Annotated[Vector, AS_CRACKED]
    """square to the plane, to the side that moves: [nx, ny, nz] with nz > 0; or give angle"""


@dataclass(frozen=True)
class CutAngle:
    """A crack inclined in the plane of motion."""

    point: Annotated[SpacePoint, AS_CRACKED]
    """a point of the plane [x, y, z]"""
    angle: Annotated[Inclination, AS_CRACKED]
    """from the horizontal, like "60 deg": where positive, the crack falls towards the direction"""


@dataclass(frozen=True, eq=False, repr=False)
class Mechanism:
    """One way in which masonry can collapse.

    Equal to itself only, so that its oscillator can be made once.

    name, label, kind : as in the project file
    sides : "one" (positive rotation only) or "two"
    positive, negative : the chain of each branch in that branch's own mirrored sign; negative None if one-sided
    restitution : of the impacts that end the positive and the negative branch [-]
    restitution_source_parts : its formula, or "given", and what other rules would give
    rebounds : factors on the restitution in histories, 1 first; the worst result counts [-]
    stopped : the negative restitution by the rule, if an impact brings the mechanism to rest; else None [-]
    elevation : of the base hinge above the origin of the project [m]
    outlines : of each block (of each part, where the chains have parts), its closed polygons in the plane of motion
        [m], not mirrored
    rules : of restitution, that its kind offers
    warnings : what the engineer must read, such as a rule that did not hold
    faces : at the hinges of the positive and of the negative branch, in its own sign; none for an equivalent block
    directions : the resistance towards each direction if the weakest of a circle was searched, else None
    direction : of positive rotation, a horizontal vector; None for an equivalent block
    adjacent_bodies : the bodies in contact with it that would stop its motion one way or another
    messages : further messages for the engineer
    toothed : the block with the side walls toothed into it; None where there are none
    candidates : the directions among which the weakest was found, or with which a given one was compared
    weaker : the weakest free direction, where the given one has a multiplier more than 10 % above it; else None
    weaker_crack : where an inclined crack begins towards `weaker` [m]; None of others
    rocks : whether it comes back and what its impacts leave is known; else no history of it is answered
    panel_height : of a panel that bulges out in a level plane [m]; None of all others
    """

    name: str
    label: str
    kind: str
    sides: Sides
    positive: Chain
    negative: Chain | None
    restitution: tuple[float, float]
    restitution_source_parts: SourceParts
    elevation: float
    outlines: tuple[Outline, ...]
    rules: ImpactRules
    warnings: tuple[Message, ...] = ()
    directions: DirectionSweep | None = None
    faces: tuple[tuple[Face, ...], ...] = ()
    stopped: float | None = None
    rebounds: tuple[float, ...] = (1.0,)
    direction: Vector | None = None
    candidates: tuple[DirectionCandidate, ...] = ()
    weaker: Vector | None = None
    weaker_crack: Vector | None = None
    adjacent_bodies: tuple[str, ...] = ()
    messages: tuple[Message, ...] = ()
    toothed: ToothedBlock | None = None
    rocks: bool = True
    panel_height: float | None = None

    def __repr__(self) -> str:
        return f"Mechanism({self.name!r}, {self.kind}, {self.sides}-sided, {self.positive.mass:.4g} kg)"

    @property
    def chains(self) -> tuple[Chain, ...]:
        """The chains that rock: of the positive branch, and of the negative one where there is one."""
        return (self.positive,) if self.negative is None else (self.positive, self.negative)

    @property
    def restitution_source(self) -> str:
        """The source of the restitution, in English."""
        return source_phrase(self.restitution_source_parts)

    @property
    def pair(self) -> ChainPair:
        """The chains of both directions with their restitution."""
        return ChainPair(self.name, self.positive, self.negative, self.restitution)

    @cached_property
    def oscillator(self) -> Oscillator:
        """The mechanism as the dynamics and the codes see it, with every action that is there at rest."""
        return oscillator_at_start(self.pair)

    @cached_property
    def actions(self) -> tuple[ChainActions, ...]:
        """The forces and ties on each chain, the positive one first."""
        return mechanism_actions(self.pair, self.oscillator)

    @cached_property
    def variants(self) -> Variants:
        """The oscillators of the mechanism as it starts, as its actions end, and as it collapses."""
        return find_variants(self.pair, self.oscillator, self.actions)

    @cached_property
    def toothing(self) -> Toothing | None:
        """The side walls toothed into it, and what of it may turn with them; None where there are none."""
        return None if self.toothed is None else toothing_of(self.toothed, self.positive)

    @property
    def rise(self) -> float:
        """Height of the far support above the base hinge, or of a panel [m]; 0 where the far end is free."""
        if self.panel_height is not None:
            return self.panel_height
        hinges = self.positive.hinges
        return hinges[-1][1] - hinges[0][1]

    @property
    def flexible(self) -> bool:
        """Whether a hinge presses on a joint that deforms or crushes."""
        return any(joint is not None for joint in self.positive.joints)

    @property
    def yielding(self) -> bool:
        """Whether a hinge presses on a joint that deforms under any motion, so that there is no threshold of uplift."""
        return any(joint is not None and joint.model != "rigid" for joint in self.positive.joints)

    @property
    def crushing(self) -> bool:
        """Whether every hinge presses on a joint of finite strength; the top of a wall may carry nothing."""
        chains = [chain for chain in (self.positive, self.negative) if chain is not None]
        return all(
            chain.joints and all(joint is not None and joint.law.strength < inf for joint in _pressing_joints(chain))
            for chain in chains
        )


LEVEL = (0.0, 1.0)
NO_FRICTION = Term("give blocks with geometry and a material with friction")


@dataclass(frozen=True)
class Face:
    """The orientation and friction of the faces at a hinge.

    normal : unit vector (x, z) in the sign of the branch, to the block that presses
    on_geometry : whether the geometry has such faces; if not, they are taken as horizontal
    friction : coefficient [-], None if not known; remedy : what to add to the project
    """

    normal: tuple[float, float] = LEVEL
    on_geometry: bool = False
    friction: float | None = None
    remedy: Term | Message = NO_FRICTION


AT_JUMP = 1e-9  # of a rotation: a jump of a table this near an end is that end


def limits(mechanism: Mechanism) -> tuple[LocalLimit, ...]:
    """Return where resisting actions end and loads lose their seats, on the branches of the breaking variant."""
    rocker = mechanism.variants.breaking
    return () if rocker is None else tuple(_limits(rocker, mechanism.actions))


def open_seats(mechanism: Mechanism) -> tuple[OpenSeat, ...]:
    """Return the movement of each bearing mass (floor, beam) whose length of seat is not given, in each branch."""
    return tuple(_open_seats(mechanism))


def height_of_support(mechanism: Mechanism) -> float:
    """Return the height of the far support or of a lasting tie above the base [m]; 0 without either."""
    return height_of_highest_tie(mechanism) if len(mechanism.positive.blocks) == 1 else mechanism.rise


def height_of_highest_tie(mechanism: Mechanism) -> float:
    """Return the height of the highest tie that holds the mechanism above the base hinge [m]; 0 without ties."""
    return max(
        (
            max((one.actions[number].at[1] for number in _holding_ties(one, _end_is_known)), default=foot) - foot
            for one in mechanism.actions
            for foot in (one.chain.hinges[0][1],)
        ),
        default=0.0,
    )


def multipliers_of_ties(mechanism: Mechanism) -> dict[BranchName, float]:
    """Return the multiplier that ties resist alone which are shown to last and hold a single block above its middle.

    By branch, where there is such a tie at or above the centre of mass: their moment at rest over g B [-].
    """
    found: dict[BranchName, float] = {}
    for name, one, branch in zip(BRANCH_NAMES, mechanism.actions, mechanism.oscillator.branches, strict=False):
        if len(one.chain.blocks) != 1:
            continue
        middle = one.chain.blocks[0].centroid[1]
        holding = [number for number in _holding_ties(one, lasts) if one.actions[number].at[1] >= middle]
        if holding:
            moments = one.moments.at_rotations(np.zeros(1))[holding, 0]
            found[name] = -float(moments.sum()) / (g * float(branch.excitation[0]))
    return found


def _holding_ties(one: ChainActions, counts: Callable[[Tie], bool]) -> list[int]:
    """Return the ties that count and resist at rest, by their numbers among the actions."""
    return [
        number
        for number, action in enumerate(one.actions)
        if isinstance(action, Tie) and counts(action) and one.resists_at(number, 0.0)
    ]


def _end_is_known(tie: Tie) -> bool:
    """Return whether a tie is shown to last or its end is given: it stiffens the curve up to there."""
    return lasts(tie) or isinstance(tie.until, float)


def _pressing_joints(chain: Chain) -> tuple[Joint | None, ...]:
    return chain.joints[:2] if len(chain.blocks) == 2 and chain.joints[2] is None else chain.joints


def _limits(rocker: Oscillator, acting: Sequence[ChainActions]) -> Iterator[LocalLimit]:
    """Yield the limits of each branch of an oscillator."""
    sides = zip(acting, rocker.branches, BRANCH_NAMES, rocker.equilibria, strict=False)
    for one, branch, name, rest in sides:
        jumps = branch.rotation[1:][np.diff(branch.rotation) == 0.0]
        ends = [(k, end - rest) for k, end in enumerate(one.ends) if 0.0 < end < inf and one.resists_at(k, end)]
        found = [LocalLimit("break", one.actions[k].name, name, end) for k, end in ends if _is_jump(end, jumps)]
        masses = [load for load in one.chain.loads if isinstance(load, PointMass) and load.bearing]
        found += [LocalLimit("seat", mass.name, name, unseating_rotation(one.chain, mass) - rest) for mass in masses]
        yield from (limit for limit in found if limit.rotation <= branch.rotation[-1])


def _is_jump(rotation: float, jumps: FloatArray) -> bool:
    """Return whether a table jumps at a rotation [rad]; jumps : of the table [n]."""
    return bool(np.isclose(jumps, rotation, rtol=AT_JUMP, atol=0.0).any())


def _open_seats(mechanism: Mechanism) -> Iterator[OpenSeat]:
    rocker = mechanism.variants.deciding
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    for chain, name, rest in zip(chains, BRANCH_NAMES, rocker.equilibria, strict=False):
        for mass in (each for each in chain.loads if isinstance(each, PointMass) and each.bearing):
            if mass.seat is None:
                rotation = scan_rotations(chain)
                most = 2.0 if chain.level else 1.0  # the middle of a panel moves twice as far as its halves' centroids
                yield OpenSeat(mass.name, name, rotation - rest, most * travel_on_seat(chain, mass, rotation))
