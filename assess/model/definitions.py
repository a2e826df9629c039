"""Mechanisms as an engineer states them: which bodies move, towards where, on what, under which loads.

Each becomes a mechanism by `assess.model.assembly`. A hinge is [x, y, z], or (distance along the direction, elevation).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

import numpy as np

from assess.interfaces.contact import Interface
from assess.loads.definitions import LoadDefinition, Place, direction_keys
from assess.loads.load import Point
from assess.mechanisms.mechanism import Sides, Vector
from assess.mechanisms.restitution import RestitutionChoice
from spectra.arrays import FloatArray

Line = tuple[Point, Point]
ALONG_X: Vector = (1.0, 0.0, 0.0)


@dataclass(frozen=True)
class Restitution:
    """Velocity after over velocity before the impact that ends a rotation [-], or a rule; None for the default."""

    positive: RestitutionChoice = None
    negative: RestitutionChoice = None


@dataclass(frozen=True)
class CutPlane:
    """An inclined crack: a point of its plane [3] [m], and the normal [3] to the side that moves."""

    point: Vector
    normal: Vector


@dataclass(frozen=True)
class CutAngle:
    """A crack inclined in the plane of motion by an angle [rad]; a positive one falls towards the direction."""

    point: Vector
    angle: float


@dataclass(frozen=True)
class RadialJoints:
    """Joints of an arch that all point to its centre (x, z) [m], evenly spaced between two angles [rad]."""

    centre: Point
    first: float
    last: float
    count: int


@dataclass(frozen=True, kw_only=True)
class BlockMechanism:
    """What all mechanisms of blocks share.

    blocks : names of the bodies of each block, from the base on
    direction : horizontal [3], positive rotation topples this way; None for the weakest, or "sweep"
    cut : only what lies above moves: an elevation [m], or an inclined crack
    sides : "one" where something behind stops negative rotation; None as bodies touch the mechanism
    interface : what the hinges press on; interfaces : what single hinges press on, by letter
    hinges, hinges_negative : of positive and of negative rotation, from A on; None as the geometry shows
    """

    moving: ClassVar[int] = 1
    blocks: tuple[tuple[str, ...], ...]
    label: str = ""
    direction: Vector | Literal["sweep"] | None = None
    cut: float | CutPlane | CutAngle | None = None
    sides: Sides | None = None
    loads: tuple[LoadDefinition, ...] = ()
    restitution: Restitution = field(default_factory=Restitution)
    interface: Interface = field(default_factory=Interface)
    interfaces: Mapping[str, Interface] = field(default_factory=dict)
    hinges: tuple[Place, ...] | Literal["minimum"] | None = None
    hinges_negative: tuple[Place, ...] | None = None

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of all bodies that move."""
        return tuple(body for block in self.blocks for body in block)

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

    def interface_at(self, letter: str) -> Interface:
        """Return what the hinge of this letter presses on."""
        return self.interfaces.get(letter, self.interface)

    def keys_along(self) -> Iterator[tuple[str | int, ...]]:
        """Name what is given in the plane of motion: two numbers of loads and hinges, and the joints of an arch."""
        yield from keys_along_direction(
            self, hinges={"hinges": self.hinge_points, "hinges_negative": self.hinges_negative}
        )


@dataclass(frozen=True, kw_only=True)
class SingleBlock(BlockMechanism):
    """One block that rocks about its base."""


@dataclass(frozen=True, kw_only=True)
class TwoBlock(BlockMechanism):
    """A wall held at its base and its top that opens at a crack between.

    crack : "sorrentino" (thesis eq. 3.27), "minimum" (least uplift multiplier), or an elevation [m]; hinge B's where
    None and hinges are given, else "sorrentino"
    """

    moving: ClassVar[int] = 2
    crack: float | Literal["sorrentino", "minimum"] | None = None


@dataclass(frozen=True, kw_only=True)
class FourHinge(BlockMechanism):
    """Three blocks between two fixed hinges, or one arch whose hinges are where it resists least.

    joints : where an arch may open, in order
    """

    moving: ClassVar[int] = 3
    joints: RadialJoints | tuple[Line, ...] | None = None


@dataclass(frozen=True, kw_only=True)
class EquivalentBlock:
    """A mechanism by its rocking parameters, as published tables give them.

    p : frequency parameter [1/s]; uplift : multiplier that starts rocking, taken as the slenderness [rad]
    radius [m]; mass [kg]; elevation : of its base [m]
    """

    p: float
    uplift: float
    radius: float
    label: str = ""
    sides: Sides = "two"
    restitution: Restitution = field(default_factory=Restitution)
    mass: float = 1.0
    elevation: float = 0.0


DirectionSought = SingleBlock | TwoBlock
"""The kinds whose weakest direction is sought if none is given; a four-hinge mechanism is drawn in its plane."""
Definition = SingleBlock | TwoBlock | FourHinge | EquivalentBlock
"""What an engineer states of a mechanism, of any kind."""


def keys_along_direction(
    chained: Any, *, hinges: Mapping[str, Sequence[Place] | None]
) -> Iterator[tuple[str | int, ...]]:
    """Name what of a mechanism of blocks is measured along its direction, with the way to it, entries from 0.

    Parameters
    ----------
    chained : a definition, or the table of a project file that has the same names
    hinges : its given hinges by key, from A on
    """
    for place, load in enumerate(chained.loads):
        yield from (("loads", place, name) for name in direction_keys(load))
    for key, given in hinges.items():
        yield from ((key, letter) for letter, at in zip("ABCD", given or (), strict=False) if len(at) == 2)
    if getattr(chained, "joints", None) is not None:
        yield ("joints",)
