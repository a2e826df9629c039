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

from assess.errors import MechanismError

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
    """Blocks from the base upwards and the hinges between them, the base hinge first: one for each block."""

    blocks: tuple[Block, ...]
    hinges: tuple[Point, ...]


@dataclass(frozen=True)
class Motion:
    """Rates of every block's centroid and rotation with respect to phi, each [blocks, n] ([m], [m], [-])."""

    dx: FloatArray
    dz: FloatArray
    dtheta: FloatArray


def moved(chain: Chain, rotation: FloatArray) -> Motion:
    """Rates of the chain's blocks at `rotation` [n] [rad], exact.

    A chain of one block, its far end free, turns as a whole: x' is the centroid's height above the hinge and
    z' its distance behind it.
    """
    (block,), (hinge,) = chain.blocks, chain.hinges
    behind, height = hinge[0] - block.centroid[0], block.centroid[1] - hinge[1]
    sine, cosine = np.sin(rotation)[None, :], np.cos(rotation)[None, :]
    return Motion(
        dx=height * cosine + behind * sine,
        dz=behind * cosine - height * sine,
        dtheta=np.ones_like(sine),
    )


def mirrored(point: Point) -> Point:
    """The point reflected in the vertical through the origin."""
    return (-point[0], point[1])


def mirrored_blocks(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """The blocks as the negative branch sees them."""
    return tuple(Block(block.mass, mirrored(block.centroid), block.inertia) for block in blocks)


def require_stable(chain: Chain, *, name: str, towards: str) -> None:
    """Raise MechanismError unless the chain stands: each centroid above its hinge and behind it.

    `towards` names the direction of rotation in the message ("positive" or "negative").
    """
    for block, hinge in zip(chain.blocks, chain.hinges, strict=True):
        behind, height = hinge[0] - block.centroid[0], block.centroid[1] - hinge[1]
        if height <= 0:
            raise MechanismError(
                f'mechanism "{name}": the centroid lies {-height:.4g} m below the hinge of {towards} rotation; '
                "a rocking block has its centroid above the hinge: check hinges and cut"
            )
        if behind <= 0:
            raise MechanismError(
                f'mechanism "{name}": already falling in {towards} rotation: the centroid lies {-behind:.4g} m beyond '
                "the hinge; check the geometry, the direction and the hinges"
            )
