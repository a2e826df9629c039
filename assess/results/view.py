"""The bodies of a mechanism in space."""

from __future__ import annotations

from dataclasses import dataclass

from assess.results.values import Place
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class Axis(ShortRepr):
    """The axis of rotation at a hinge: its two ends [m]."""

    name: str
    ends: tuple[Place, Place]


@dataclass(frozen=True, repr=False)
class View(ShortRepr):
    """The bodies of a mechanism in space [m], simplified and rounded for drawing; not for calculation.

    triangles: indices into vertices, anticlockwise seen from outside; block_of: the block that each triangle belongs
    to, from 0 at the base, -1 if it does not move. sections: closed rings where cuts pass through the masonry.
    size: of the bounding box along x, y, z. given: number of triangles of the bodies before simplification.
    """

    vertices: tuple[Place, ...]
    triangles: tuple[tuple[int, int, int], ...]
    block_of: tuple[int, ...]
    axes: tuple[Axis, ...]
    sections: tuple[tuple[Place, ...], ...]
    direction: Place
    size: Place
    given: int
