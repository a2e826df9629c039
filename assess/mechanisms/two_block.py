"""A wall held at its base and its top that opens at a crack between them (thesis 3.2.3).

For positive rotation the lower block turns about the edge of its base in the direction of motion and the upper one back
about the edge of the crack behind; the top slides on the vertical at its edge in the direction of motion:

        +-----C            ξ = 0: the load acts at C, the edge support
        |     |            ξ = 1: at the opposite face
        |     |
        B-----+   crack
        |     |
        +-----A
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, get_args

from assess.declaration import Evidence, KeyFault, Name, Number, Safe
from assess.errors import MechanismError
from assess.geometry.cut import Piece
from assess.geometry.planar import PlanarBody, top_edge
from assess.loads.load import Load, Place, Point
from assess.mechanisms.assembly import (
    MechanismKind,
    MechanismPieces,
    assemble,
    common_arguments,
    hinge_warnings,
    hinges_in_plane,
    loose_hinges,
)
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain, point_text, point_values
from assess.mechanisms.mechanism import DRAWN_HINGES, BlockMechanism, Mechanism, Sides
from assess.mechanisms.restitution import (
    ImpactRules,
    RestitutionChoice,
    chain_rebound,
    conserve_about_base,
    conserve_momentum,
    conserve_with_loads,
)
from assess.messages.message import Message, Quantity, distinct, warning, whole_number

CrackRule = Literal["sorrentino", "minimum"]
CRACKS: tuple[str, ...] = get_args(CrackRule)
CRACK_ELEVATION = Number("length", form='not a crack; write an elevation, or one of "sorrentino", "minimum"')
Hinges = tuple[Point, Point, Point]


@dataclass(frozen=True, kw_only=True)
class TwoBlock(BlockMechanism):
    """A wall held at its base and its top that opens at a crack between."""

    kind: ClassVar[str] = "two-block"
    number_of_blocks: ClassVar[int] = 2
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """one body, cut at the crack, or two, the lower first"""
    hinges: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """hinges of positive rotation; the edges of base, crack and top if absent"""
    hinges_negative: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """hinges of negative rotation; the edges of base, crack and top if absent"""
    crack: Annotated[
        float | CrackRule | None,
        CRACK_ELEVATION,
        Evidence("chosen", "either", "the weakest height, where it is weaker by more than 10 %", safe=Safe.WEAKEST),
    ] = None
    """"sorrentino" (eq. 3.27), "minimum" (least uplift multiplier), or an elevation; hinge B's if hinges are given"""

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        if len(self.blocks) == 2 and self.crack is not None:
            yield "crack", "is for one body; two bodies part at their joint, so remove one of them"
        yield from super().faults()


def two_block(
    name: str,
    lower: PlanarBody,
    upper: PlanarBody,
    *,
    label: str = "",
    sides: Sides = "two",
    hinges: Hinges | None = None,
    hinges_negative: Hinges | None = None,
    loads: tuple[Load, ...] = (),
    restitution: tuple[RestitutionChoice, RestitutionChoice] = (None, None),
    warnings: tuple[Message, ...] = (),
) -> Mechanism:
    """Make the mechanism of a wall of two bodies, held at its base and its top.

    Parameters
    ----------
    name : of the mechanism
    lower, upper : the bodies below and above the crack
    label : for reports; empty: the name
    sides : "one" or "two"
    hinges, hinges_negative : A, B, C (x, z) of positive and of negative rotation [m]; absent: the edges of base, crack
        and top
    loads : on the blocks
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind
    warnings : on what was given

    Raises
    ------
    MechanismError : a body without geometry whose edge is needed, or hinges out of order
    """
    if sides == "one" and hinges_negative is not None:
        raise MechanismError(f'mechanism "{name}": hinges_negative: given with sides = "one"; remove one of them')
    outlines = (lower.outline, upper.outline)
    blocks = tuple(RigidBlock(body.mass, body.centroid, body.inertia) for body in (lower, upper))
    front = hinges or _edge_hinges(lower, upper, ahead=True, name=name)
    _require_order(front, name=name)
    negative = None
    if sides == "two":
        back = hinges_negative or _edge_hinges(lower, upper, ahead=False, name=name)
        _require_order(back, name=name)
        negative = mirror_chain(blocks, back, loads)
    return assemble(
        name,
        TWO_BLOCK,
        Chain(blocks, front, loads),
        negative,
        label=label,
        restitution=restitution,
        outlines=outlines,
        warnings=(
            *warnings,
            *_loads_across_crack(loads, front[1][1]),
            *loose_hinges(hinges or (), outlines),
            *loose_hinges(hinges_negative or (), outlines, mark="'"),
        ),
    )


def _build_two_block(
    name: str,
    definition: TwoBlock,
    pieces: Sequence[Piece],
    *,
    loads: tuple[Load, ...],
) -> MechanismPieces:
    """Build a wall held at its base and its top, of two bodies or of one that cracks."""
    front, back = (
        hinges_in_plane(definition.hinge_points, definition),
        hinges_in_plane(definition.hinges_negative, definition),
    )
    lower, upper = pieces
    warnings = () if front else [each for piece in pieces for each in hinge_warnings(piece, definition.towards)]
    mechanism = two_block(
        name,
        lower.body,
        upper.body,
        hinges=front,
        hinges_negative=back,
        loads=loads,
        warnings=distinct(warnings),
        **common_arguments(definition),
    )
    return mechanism, pieces


TWO_BLOCK = MechanismKind(
    definition=TwoBlock,
    build=_build_two_block,
    impacts=ImpactRules(
        two_sided={"thesis": conserve_about_base, "sorrentino": conserve_about_base, "momentum": conserve_momentum},
        one_sided={"thesis": chain_rebound},
        unnamed=conserve_with_loads,
    ),
    support="spanning",
    direction_sought=True,
)


def _edge_hinges(lower: PlanarBody, upper: PlanarBody, *, ahead: bool, name: str) -> Hinges:
    """Return hinges A, B, C at the edges of the base, of the joint and of the top, for motion ahead or back."""
    head = top_edge(upper)
    if lower.base is None or upper.base is None or head is None:
        raise MechanismError(
            f'mechanism "{name}": a body without geometry has no edges; give hinges = {{ A = [x, z], B = [x, z], '
            "C = [x, z] } and, for two-sided rocking, hinges_negative"
        )
    return (lower.base[ahead], upper.base[not ahead], head[ahead])


def _require_order(hinges: Hinges, *, name: str) -> None:
    """Raise MechanismError unless hinges A, B and C rise in this order."""
    a, b, c = hinges
    if not a[1] < b[1] < c[1]:
        raise MechanismError(
            f'mechanism "{name}": hinges: A {point_text(a)}, B {point_text(b)} and C {point_text(c)} must rise '
            "in this order: base, crack, top"
        )


def _loads_across_crack(loads: Sequence[Load], elevation: float) -> Iterator[Message]:
    """Yield a warning for each load of a wall of two blocks across the crack from its block."""
    for load in loads:
        side = int(load.at[1] >= elevation)
        if load.block != side:
            yield warning(
                "load-across-crack",
                load=load.name,
                block=whole_number(load.block),
                side=whole_number(side),
                crack=Quantity(elevation, "length"),
                **point_values(load.at),
            )
