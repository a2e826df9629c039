"""A mechanism drawn to scale in its plane of motion, at rest and displaced."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.results.values import Point, Ring
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class NamedPoint(ShortRepr):
    """A hinge or another named point in the plane of motion: distance along the direction, elevation [m]."""

    name: str
    at: Point


@dataclass(frozen=True, repr=False)
class DrawnLoad(ShortRepr):
    """A load in the plane of motion: where it acts [m], and the unit vector of its force.

    towards: None for a non-bearing mass, which has no force at rest.
    """

    name: str
    at: Point
    kind: Literal["mass", "force", "tie"]
    towards: Point | None


@dataclass(frozen=True, repr=False)
class Displaced(ShortRepr):
    """The mechanism after a rotation of its leading block, in the plane of motion, not mirrored [m].

    blocks, loads and centroids are in the order of the drawing at rest; hinges and block_of are of the branch that
    turns.
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

    block_of: block of the positive branch that each outline belongs to, from 0 at the base, -1 if it does not move (an
    arch may divide into other blocks each way); centroids: of each block; displaced, displaced_negative: turned to
    either side, far enough to be seen but not beyond overturning; fixed: outlines of masonry that does not move, as
    below a cut.
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
