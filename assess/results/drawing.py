"""A mechanism drawn to scale in its plane of motion, at rest and displaced."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.results.values import Point, Ring
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class NamedPoint(ShortRepr):
    """A hinge or another named place in the plane of motion: distance along the direction, elevation [m]."""

    name: str
    at: Point


@dataclass(frozen=True, repr=False)
class DrawnLoad(ShortRepr):
    """A load in the plane of motion: where it acts [m], and the unit vector it pushes or pulls along.

    towards is None for a mass that is not bearing: it has no force at rest.
    """

    name: str
    at: Point
    kind: Literal["mass", "force", "tie"]
    towards: Point | None


@dataclass(frozen=True, repr=False)
class Displaced(ShortRepr):
    """The mechanism after a rotation of its leading block, as seen in the plane of motion, not mirrored [m].

    blocks, loads and centroids follow the order of the drawing at rest; hinges are those of the branch that turns, and
    block_of tells its blocks.
    """

    rotation_rad: float
    blocks: tuple[Ring, ...]
    block_of: tuple[int, ...]
    hinges: tuple[NamedPoint, ...]
    loads: tuple[DrawnLoad, ...]
    centroids: tuple[Point, ...]


@dataclass(frozen=True, repr=False)
class Drawing(ShortRepr):
    """The mechanism in its plane of motion, to scale [m]: closed outlines of the blocks, hinges, loads, centroid.

    block_of: the block of the positive branch that each outline belongs to, from 0 at the base, -1 where it does not
    move (an arch may join other voussoirs to blocks each way); centroids: of each block; displaced and
    displaced_negative: turned to either side, far enough to be seen and no farther than overturning; fixed: outlines of
    masonry that stays, as what lies under a cut.
    """

    blocks: tuple[Ring, ...]
    hinges: tuple[NamedPoint, ...]
    loads: tuple[DrawnLoad, ...]
    centroid: Point
    block_of: tuple[int, ...]
    centroids: tuple[Point, ...]
    displaced: Displaced
    displaced_negative: Displaced | None
    fixed: tuple[Ring, ...]
