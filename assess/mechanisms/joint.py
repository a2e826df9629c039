"""The joint under a hinge of a chain: the faces in contact, their stiffness and strength."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.interfaces.law import JointLaw
from assess.interfaces.section import Section

Model = Literal["rigid", "flexible", "semi-flexible", "flexible-thesis"]
Pair = tuple[int | None, int]

PAIRS: dict[int, tuple[Pair, ...]] = {
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
    section: Section
    law: JointLaw
    model: Model
