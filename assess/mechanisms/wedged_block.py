r"""Façades and corners that take a wedge of the walls behind them along, in front of a crack from foot to top.

        +----------+---+
         \  wedge  |   |
          \        |   |  -->      the crack rises from the inner face at an angle β from the vertical;
           \  β    |   |           what is in front of it turns as one about the outer edge of the foot, A
            \      |   |
             +----+---A

Nothing holds along the cracks: a bond that was seen belongs to `side_walls` of a single block. Both fall outwards and
cannot rock, as the wedge closes on its crack: what is lost there is not known, and no history of them is answered.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi
from typing import Annotated, ClassVar

from assess.declaration import Evidence, KeyFault, Name, Number, PositiveLength, Several
from assess.errors import FallingError
from assess.geometry.cut import Piece
from assess.loads.load import Load, Place
from assess.mechanisms.assembly import MechanismKind, MechanismPieces, assemble, hinges_in_plane
from assess.mechanisms.chain import Chain, RigidBlock, uplift_multiplier
from assess.mechanisms.mechanism import AS_CRACKED, DRAWN_HINGES, BlockMechanism
from assess.mechanisms.restitution import FALLS_OUTWARDS, Restitution

AS_MEASURED = "measure the crack from the vertical, 0 deg to less than 60 deg"
WedgeAngle = Annotated[float, Number("angle", least=0.0, below=pi / 3.0, beyond=f"not such a crack; {AS_MEASURED}")]


@dataclass(frozen=True, kw_only=True)
class Wedge:
    """What moves of a wall that runs back: all that lies in front of a crack."""

    walls: Annotated[tuple[Name, ...], Several(1, unlike="body"), Evidence("defines", "either", "as drawn")]
    """the bodies of the wall, of those in `blocks`, like ["side-wall"]"""
    angle: Annotated[WedgeAngle, AS_CRACKED]
    """of the crack from the vertical, like "20 deg"; it begins at the foot, where the other wall ends"""
    reach: Annotated[PositiveLength | None, Evidence("drawn", "either", "the whole wall")] = None
    """how far back from there the wedge goes at most, as to an opening or a cross wall; the whole wall if absent"""


@dataclass(frozen=True, kw_only=True)
class WedgedBlock(BlockMechanism):
    """A block with wedges of the walls behind it."""

    wedges: Annotated[tuple[Wedge, ...], Several(1)]
    """[ { walls = ["side-wall"], angle = "20 deg" }, … ]: the walls of `blocks` that crack, and how"""
    hinges: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """hinge at the foot; the outer edge of the foot, or its outermost corner, if absent"""
    hinges_negative: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """none: it falls outwards alone"""

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        yield from super().faults()
        yield from outward_faults(self)
        if not isinstance(self.cut, float | int | None):
            yield "cut", "is the level of its foot; give an elevation, and the cracks in `wedges`"
        named: list[str] = []
        for number, wedge in enumerate(self.wedges):
            for wall in wedge.walls:
                if wall not in self.bodies:
                    reason = f'"{wall}" is not in `blocks`; known there: {", ".join(self.bodies)}'
                    yield ("wedges", number, "walls"), reason
                if wall in named:
                    yield ("wedges", number, "walls"), f'"{wall}" stands in two wedges; remove one'
                named.append(wall)

    @property
    def two_sided(self) -> bool:
        """It falls outwards alone."""
        return False

    @property
    def in_front(self) -> tuple[str, ...]:
        """The bodies that no crack parts."""
        return tuple(body for body in self.bodies if not any(body in wedge.walls for wedge in self.wedges))


@dataclass(frozen=True, kw_only=True)
class FacadeWithWedges(WedgedBlock):
    """A wall that overturns with wedges of the walls behind it."""

    kind: ClassVar[str] = "facade-with-wedges"
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """the wall with those behind it, [["front", "left", "right"]]"""

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        yield from super().faults()
        if not isinstance(self.direction, tuple):
            yield "direction", "missing; give the one in which the wall falls outwards, like [0, -1, 0]"
        if not self.in_front:
            yield "blocks", "all its bodies stand in `wedges`; name the wall that overturns too"


@dataclass(frozen=True, kw_only=True)
class Corner(WedgedBlock):
    """The corner of two walls, which turns about its foot in any direction between their outward ones."""

    kind: ClassVar[str] = "corner"
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """the two walls, of one body or more each, [["north", "east"]]; the weakest outward direction if none is given"""

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        yield from super().faults()
        if len(self.wedges) != 2:
            yield "wedges", f"{len(self.wedges)} of them; a corner is of two walls, and has one in each"
        if self.direction == "sweep":
            yield "direction", "is sought between the outward ones of its walls; remove it, or give one of these"
        if self.direction is None:
            for key in self.keys_along():
                yield key, "two numbers depend on the direction, which is sought; give three numbers, or the direction"


def outward_faults(definition: BlockMechanism) -> Iterator[KeyFault]:
    """Yield the keys of a mechanism without histories, of one side, that have nothing to say."""
    if definition.sides == "two":
        yield "sides", 'it falls outwards alone; remove it, or write "one"'
    if definition.hinges_negative is not None:
        yield "hinges_negative", "it falls outwards alone; remove it"
    if definition.restitution != Restitution():
        yield "restitution", "histories of this class are not answered; remove it"


def _build_wedged_block(
    name: str, definition: WedgedBlock, pieces: Sequence[Piece], *, loads: tuple[Load, ...]
) -> MechanismPieces:
    """Build a block with its wedges, cut from the bodies, that turns about the outer edge of its foot."""
    (piece,) = pieces
    assert piece.body.base is not None  # it has geometry
    front = hinges_in_plane(definition.hinge_points, definition)
    block = RigidBlock(piece.body.mass, piece.body.centroid, piece.body.inertia)
    chain = Chain((block,), front or (piece.body.base[1],), loads)
    if block.centroid[0] >= chain.hinges[0][0]:
        behind = chain.hinges[0][0] - block.centroid[0]
        raise FallingError(
            f'mechanism "{name}": already falling: the centroid lies {-behind:.4g} m beyond the hinge; check the '
            "geometry, the direction and the wedges",
            uplift_multiplier(chain),
        )
    mechanism = assemble(
        name,
        WEDGED_KINDS[definition.kind],
        chain,
        None,
        label=definition.label,
        restitution=definition.restitution.choices,
        outlines=(piece.body.outline,),
    )
    return mechanism, pieces


FACADE_WITH_WEDGES = MechanismKind(
    definition=FacadeWithWedges, build=_build_wedged_block, impacts=FALLS_OUTWARDS, support="free", rocks=False
)
CORNER = MechanismKind(
    definition=Corner, build=_build_wedged_block, impacts=FALLS_OUTWARDS, support="free", rocks=False
)
WEDGED_KINDS = {kind.name: kind for kind in (FACADE_WITH_WEDGES, CORNER)}
