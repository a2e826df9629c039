"""A planar chain of rigid blocks, and how it moves.

Signs, for the branch of positive rotation (a negative branch is a chain mirrored in z, with hinges of its own):

        z ^        direction -->  (x)
          |
          |      +-------+
          |      |   o   |  centroid, at (-b, h) from the hinge: b = R sin(alpha), h = R cos(alpha)
          |      |       |
          |      +-------A  )   phi > 0 turns the block about A towards the direction of motion (clockwise)
          +--------------------> x

A record is positive when the ground accelerates along the direction; inertia then pushes towards phi < 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assess.loads import Load, PointMass

FloatArray = NDArray[np.float64]
Point = tuple[float, float]


@dataclass(frozen=True)
class Block:
    """A rigid block in the plane of motion: mass [kg], centroid (x, z) [m], inertia about it [kg m2]."""

    mass: float
    centroid: Point
    inertia: float


@dataclass(frozen=True)
class Chain:
    """Blocks from the base upwards, the hinges between them (the base hinge first, one for each block), and loads."""

    blocks: tuple[Block, ...]
    hinges: tuple[Point, ...]
    loads: tuple[Load, ...] = ()

    @property
    def mass(self) -> float:
        """Total moved mass, bearing or not [kg]."""
        carried = sum(load.mass for load in self.loads if isinstance(load, PointMass))
        return sum(block.mass for block in self.blocks) + carried


@dataclass(frozen=True)
class Path:
    """A point of a block over rotation [n]: place x, z [m], and their rates x', z' with respect to phi [m]."""

    x: FloatArray
    z: FloatArray
    dx: FloatArray
    dz: FloatArray


def path(chain: Chain, *, block: int, at: Point, rotation: FloatArray) -> Path:
    """The path of the point `at` of `block` at `rotation` [n] [rad], exact.

    A chain of one block, its far end free, turns as a whole: x' is the point's height above the hinge and z' its
    distance behind it.
    """
    hinge = chain.hinges[block]
    behind, height = hinge[0] - at[0], at[1] - hinge[1]
    sine, cosine = np.sin(rotation), np.cos(rotation)
    above, back = height * cosine + behind * sine, behind * cosine - height * sine
    return Path(x=hinge[0] - back, z=hinge[1] + above, dx=above, dz=back)


def turning(chain: Chain, *, block: int, rotation: FloatArray) -> FloatArray:
    """theta' of `block` at `rotation` [n]: 1 for the leading block."""
    return np.ones_like(rotation)


def mirrored(point: Point) -> Point:
    """The point reflected in the vertical through the origin."""
    return (-point[0], point[1])


def mirrored_blocks(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """The blocks as the negative branch sees them."""
    return tuple(Block(block.mass, mirrored(block.centroid), block.inertia) for block in blocks)
