r"""A panel that bulges out between two cross walls as an arch in plan, on upright hinges at its ends and its middle.

    s ^        .---C  H          x along the direction, s along the wall, seen from above. The arch presses on the outer
      |        |  /   |          edge at its ends and the inner one in the middle, so that B lies r behind A, C. As it
      |        | /    v          bulges, the ends move apart against the thrust H, which is lost where r is 0.
      |        B
      |        | \    ^          α_0 = 8 H r / (W L)         α(d) = 4 H (r - d) / (W sqrt(l^2 - (r - d)^2))
      |        |  \   |          l^2 = (L / 2)^2 + r^2       an end that yields by u lowers r by u L / (4 r)
      +--->x   '---A  H

The panel is a chain of two blocks that moves in a level plane, where weights do no work. What its impacts leave is not
known, and no history of it is answered. Source: virtual work; depth of the arch within a wall: EN 1996-1-1, 6.3.2.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

import numpy as np

from assess.declaration import UNCERTAIN, Evidence, KeyFault, MasonryStrength, Name, PositiveForce, Safe, Several
from assess.errors import MechanismError
from assess.geometry.cut import Piece
from assess.geometry.planar import Outline, projected_outline
from assess.geometry.solid import Solid
from assess.interfaces.contact import Interface
from assess.loads.load import Force, Load, Place, PointMass, Tie
from assess.mechanisms.assembly import MechanismKind, MechanismPieces, assemble
from assess.mechanisms.chain import Chain, RigidBlock
from assess.mechanisms.mechanism import DRAWN_HINGES, BlockMechanism
from assess.mechanisms.restitution import FALLS_OUTWARDS
from assess.mechanisms.wedged_block import outward_faults
from assess.messages.message import Term
from spectra.arrays import FloatArray

DEEPEST = 0.1  # of the thickness: depth of an arch within a wall (EN 1996-1-1 6.3.2)
THRUST = Term("the least of what its masonry and its ends hold")
LASTS = "held by the masonry of the wall"


@dataclass(frozen=True, kw_only=True)
class HorizontalArch(BlockMechanism):
    """A panel that bulges out between two cross walls as an arch in plan."""

    kind: ClassVar[str] = "horizontal-arch"
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """the wall, ["wall"], or bodies that are one wall, [["wall", "wall-above"]]"""
    between: Annotated[tuple[Name, ...], Several(2, 2, unlike="body"), Evidence("defines", "either", "as drawn")]
    """the cross walls between which it bulges out, ["left", "right"]"""
    ends: Annotated[
        tuple[PositiveForce, ...] | None,
        Several(2, 2),
        Evidence("measured", "up", "what the masonry of the wall beyond each of them holds", safe=Safe.ABSENT),
    ] = None
    """thrust that each end holds, like ["20 kN", "15 kN"], as of a tie; if absent what the masonry of the wall beyond
    each cross wall does before it rocks in its plane, or slides where its friction is known"""
    strength: Annotated[
        MasonryStrength | None, UNCERTAIN, Evidence("measured", "up", "1 MPa, the least", safe=Safe.ABSENT)
    ] = None
    """of the masonry in compression along the wall; 1 MPa, the least of rubble, if absent"""
    hinges: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """none: they are found"""
    hinges_negative: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """none: it bulges outwards alone"""

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        yield from super().faults()
        yield from outward_faults(self)
        if not isinstance(self.direction, tuple):
            yield "direction", "missing; give the one in which the wall bulges out, like [0, -1, 0]"
        if not isinstance(self.cut, float | int | None):
            yield "cut", "is the level from which the wall bulges out; give an elevation"
        if self.hinges is not None:
            yield "hinges", "they lie at the cross walls and in the middle; remove them"
        if self.interface != Interface() or self.interfaces:
            yield "interface", "an arch crushes by its strength; remove it, and give strength"
        for number, load in enumerate(self.loads):
            if load.kind not in ("mass", "body"):
                yield ("loads", number, "kind"), 'an arch takes masses and bodies; what holds its ends is in "ends"'
        for body in self.between:
            if body in self.bodies:
                yield "between", f'"{body}" is in `blocks` too; it moves, or it stays'

    @property
    def neighbours(self) -> tuple[str, ...]:
        """The cross walls."""
        return self.between

    @property
    def two_sided(self) -> bool:
        """It bulges outwards alone."""
        return False


def thrust_held_beyond(*, weight: float, length: float, lever: float, friction: float | None = None) -> float:
    """Return the thrust that the masonry beyond an end of an arch holds [N]: until it rocks in its plane, or slides.

    Parameters
    ----------
    weight : of the wall beyond the end and of what it carries [N]
    length : of that wall in plan [m]
    lever : of the thrust over its foot [m]
    friction : at its foot [-]; None where it is not known
    """
    rocking = weight * length / (2.0 * lever)
    return rocking if friction is None else min(rocking, friction * weight)


def along_wall(definition: BlockMechanism) -> FloatArray:
    """Return the horizontal unit vector along a wall that bulges out [3]."""
    x, y, _ = definition.along
    return np.array([-y, x, 0.0])


def build_horizontal_arch(
    name: str,
    definition: HorizontalArch,
    pieces: Sequence[Piece],
    *,
    loads: tuple[Load, ...],
    thrust: float,
    depth: float,
) -> MechanismPieces:
    """Build the arch of a panel.

    Parameters
    ----------
    name : of the mechanism
    definition : as an engineer states it
    pieces : both halves of the panel, in the order along the wall
    loads : in the vertical plane of motion; masses move with both halves alike, and pushes outwards drive both
    thrust : H that the arch is left with [N]; depth : of what it presses on [m]

    Raises
    ------
    MechanismError : the arch is as deep as the panel is thick
    """
    axes = np.array([definition.along, along_wall(definition)])
    solids = [solid for piece in pieces for solid in piece.solids]
    corners = np.concatenate([solid.vertices for solid in solids])
    (inner, start), (outer, end) = (corners @ axes.T).min(axis=0), (corners @ axes.T).max(axis=0)
    rise = outer - inner - depth
    if rise <= 0.0:
        raise MechanismError(
            f'mechanism "{name}": ends: an arch of {thrust / 1e3:.4g} kN needs a depth of {depth:.4g} m, and the wall '
            f"is {outer - inner:.4g} m thick; give a lower thrust, or a higher strength"
        )
    front = outer - depth / 2.0
    hinges = ((front, start), (inner + depth / 2.0, (start + end) / 2.0), (front, end))
    blocks = tuple(_block_in_plan(piece.solids, axes) for piece in pieces)
    held = Force("thrust", (0.0, -thrust), hinges[2], 1, (THRUST,), until="collapse", evidence=LASTS)
    chain = Chain(blocks, hinges, (*_spread(loads, blocks), held), level=True)
    made = assemble(
        name,
        HORIZONTAL_ARCH,
        chain,
        None,
        label=definition.label,
        restitution=definition.restitution.choices,
        outlines=tuple(_outline_in_plan(piece.solids, axes) for piece in pieces),
    )
    foot, top = float(corners[:, 2].min()), float(corners[:, 2].max())
    return replace(made, elevation=foot, panel_height=top - foot), pieces


def _block_in_plan(solids: Sequence[Solid], axes: FloatArray) -> RigidBlock:
    """Return masonry seen from above; axes : along the direction and along the wall [2, 3]."""
    mass = np.array([solid.mass for solid in solids])
    centroids = np.array([axes @ solid.centroid for solid in solids])
    middle = mass @ centroids / mass.sum()
    own = sum(float(solid.inertia[2, 2]) for solid in solids)
    inertia = own + float(mass @ ((centroids - middle) ** 2).sum(axis=1))
    return RigidBlock(float(mass.sum()), (float(middle[0]), float(middle[1])), inertia)


def _outline_in_plan(solids: Sequence[Solid], axes: FloatArray) -> Outline:
    return tuple(ring for solid in solids for ring in projected_outline(solid.vertices @ axes.T, solid.triangles))


def _spread(loads: Sequence[Load], blocks: Sequence[RigidBlock]) -> Iterator[Load]:
    """Yield loads as both halves take them: at their centroids, which move half as far as the middle does.

    So a seat is lost there at half its length.
    """
    for load in loads:
        for number, block in enumerate(blocks):
            if isinstance(load, PointMass):
                seat = None if load.seat is None else load.seat / 2.0
                yield replace(load, mass=load.mass / 2.0, at=block.centroid, block=number, seat=seat)
            elif not isinstance(load, Tie) and load.force[0] > 0.0:
                yield replace(load, force=(load.force[0] / 2.0, 0.0), at=block.centroid, block=number)


HORIZONTAL_ARCH = MechanismKind(
    definition=HorizontalArch, build=build_horizontal_arch, impacts=FALLS_OUTWARDS, support="hinged", rocks=False
)
