"""A collapse mechanism: a chain for each direction of rotation, the restitution of its impacts, and its drawing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Literal

from assess.geometry.outline import Outline
from assess.mechanisms.actions import ChainActions, find_actions
from assess.mechanisms.chain import Chain, ChainPair
from assess.mechanisms.directions import Candidate, Directions, Vector
from assess.mechanisms.face import Face
from assess.mechanisms.joint import Joint
from assess.mechanisms.oscillation import oscillator_at_start
from assess.mechanisms.variants import Variants, find_variants
from assess.messages.message import Message, Term
from assess.oscillator import Oscillator

Sides = Literal["one", "two"]


@dataclass(frozen=True, eq=False, repr=False)
class Mechanism:
    """One way in which masonry can collapse.

    Equal to itself only, so that its oscillator can be made once.

    Attributes
    ----------
    name, label, kind : as in the project file
    sides : "one" (positive rotation only) or "two"
    positive, negative : the chain of each branch in that branch's own mirrored sign; negative None if one-sided
    restitution : of the impacts that end the positive and the negative branch [-]
    restitution_source : its formula, or "given", the English of `restitution_said`
    rebounds : factors on the restitution in histories, 1 first; the worst result counts [-]
    stopped : the negative restitution by the rule, if an impact brings the mechanism to rest; else None [-]
    elevation : of the base hinge above the origin of the project [m]
    outlines : of each block (of each part, where the chains have parts), its closed polygons in the plane of motion
        [m], not mirrored
    warnings : what the engineer must read, such as a rule that did not hold
    faces : at the hinges of the positive and of the negative branch, in its own sign; none for an equivalent block
    directions : the resistance towards each direction if the weakest of a circle was searched, else None
    direction : of positive rotation, a horizontal vector; None for an equivalent block
    beside : the bodies in contact with it that would stop its motion one way or another
    messages : further messages for the engineer
    candidates : the directions among which the weakest was found, or with which a given one was compared
    """

    name: str
    label: str
    kind: str
    sides: Sides
    positive: Chain
    negative: Chain | None
    restitution: tuple[float, float]
    restitution_source: str
    elevation: float
    outlines: tuple[Outline, ...]
    warnings: tuple[Message, ...] = ()
    directions: Directions | None = None
    faces: tuple[tuple[Face, ...], ...] = ()
    stopped: float | None = None
    rebounds: tuple[float, ...] = (1.0,)
    direction: Vector | None = None
    candidates: tuple[Candidate, ...] = ()
    beside: tuple[str, ...] = ()
    messages: tuple[Message, ...] = ()
    restitution_said: tuple[Term | Message, ...] = ()

    def __repr__(self) -> str:
        return f"Mechanism({self.name!r}, {self.kind}, {self.sides}-sided, {self.positive.mass:.4g} kg)"

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
        return find_actions(self.pair, self.oscillator)

    @cached_property
    def variants(self) -> Variants:
        """The oscillators of the mechanism as it starts, as its actions end, and as it collapses."""
        return find_variants(self.pair, self.oscillator, self.actions)

    @property
    def rise(self) -> float:
        """Height of the far support above the base hinge [m]; 0 where the far end is free."""
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
        return all(chain.joints and all(map(_crushes, _pressing(chain))) for chain in chains)


def _pressing(chain: Chain) -> tuple[Joint | None, ...]:
    return chain.joints[:2] if len(chain.blocks) == 2 and chain.joints[2] is None else chain.joints


def _crushes(joint: Joint | None) -> bool:
    return joint is not None and joint.law.strength < inf
