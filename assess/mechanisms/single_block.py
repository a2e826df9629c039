"""One block: rocking about the edges of its base (thesis 3.2.1 and 3.2.2), or given by its rocking parameters alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from math import cos, hypot, inf, sin, sqrt
from typing import Annotated, ClassVar, Literal

from assess.declaration import (
    FREE,
    UNCERTAIN,
    UNCERTAIN_UPLIFT,
    Evidence,
    Fault,
    KeyFault,
    Length,
    Name,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    Safe,
    Uplift,
)
from assess.errors import FallingError, MechanismError
from assess.geometry.cut import Piece
from assess.geometry.planar import PlanarBody
from assess.loads.load import Load, Place, Point
from assess.mechanisms.assembly import (
    OUTSIDE,
    HingeBeside,
    MechanismKind,
    MechanismPieces,
    assemble,
    common_arguments,
    hinge_beside,
    hinge_warnings,
    hinges_in_plane,
)
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain, point_values
from assess.mechanisms.mechanism import DRAWN_HINGES, BlockMechanism, Mechanism, Sides
from assess.mechanisms.restitution import (
    ImpactRules,
    Restitution,
    RestitutionChoice,
    conserve_momentum,
    housner_rule,
    plain_block,
    single_block_rule,
    sorrentino_rebound,
)
from assess.mechanisms.side_walls import NONE_COUNTED, SideWalls, toothed_block
from assess.messages.message import Message, Quantity, lengths, note, warning
from spectra.gravity import g

INERTIA_RATIOS = (1e-4, 1e4)  # I_O / (M R^2) = g / (p^2 R): 4/3 of a slender block, less of a wall that spans
TINIEST = 1e-150  # of a frequency parameter: its square is a number


@dataclass(frozen=True, kw_only=True)
class SingleBlock(BlockMechanism):
    """One block that rocks about its base."""

    kind: ClassVar[str] = "single-block"
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """the body that rocks, ["wall"], or several that move as one, [["wall", "buttress"]]"""
    hinges: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """hinge of positive rotation; the extreme line of the base (of the cut) if absent"""
    hinges_negative: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """hinge of negative rotation; the extreme line of the base (of the cut) if absent"""
    side_walls: Annotated[SideWalls | None, Evidence("measured", "up", NONE_COUNTED, safe=Safe.ABSENT)] = None
    """{ bond = "toothed", course, overlap, thickness, friction, count }: cross walls behind it, whose friction the
    linear and the non-linear check of NTC 2018 count; no friction if absent"""

    def faults(self) -> Iterator[KeyFault]:
        """Yield the keys that do not go together."""
        yield from super().faults()
        if self.side_walls is not None and not isinstance(self.direction, tuple):
            yield "direction", "missing, and side_walls stand behind the wall as seen along it; give the direction"


def single_block(
    name: str,
    body: PlanarBody,
    *,
    label: str = "",
    sides: Sides = "two",
    hinge: Point | None = None,
    hinge_negative: Point | None = None,
    loads: tuple[Load, ...] = (),
    restitution: tuple[RestitutionChoice, RestitutionChoice] = (None, None),
    warnings: tuple[Message, ...] = (),
) -> Mechanism:
    """Make the mechanism of one body rocking about the edges of its base.

    Parameters
    ----------
    name : of the mechanism
    body : in the plane of motion
    label : for reports; empty: the name
    sides : "one" or "two"
    hinge, hinge_negative : (x, z) of positive and of negative rotation [m]; absent: the edges of the base
    loads : on the block
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind
    warnings : on what was given

    Raises
    ------
    MechanismError : no base, a base of no width, or a block that is already falling
    """
    if sides == "one" and hinge_negative is not None:
        raise MechanismError(f'mechanism "{name}": hinges_negative: given with sides = "one"; remove one of them')
    off_base = (
        *_off_base_warnings(body, hinge, "A"),
        *_off_base_warnings(body, hinge_negative, "A'"),
    )
    block = RigidBlock(body.mass, body.centroid, body.inertia)
    positive = Chain((block,), (hinge or _edge_hinge(body, "positive", name=name),), loads)
    _require_stable(positive, name=name, towards="positive", beside=hinge_beside(off_base))
    negative = None
    if sides == "two":
        other = hinge_negative or _edge_hinge(body, "negative", name=name)
        negative = mirror_chain((block,), (other,), loads)
        _require_stable(negative, name=name, towards="negative", beside=hinge_beside(off_base))
    return assemble(
        name,
        SINGLE_BLOCK,
        positive,
        negative,
        label=label,
        restitution=restitution,
        outlines=(body.outline,),
        warnings=(*off_base, *warnings),
    )


def build_single_block(
    name: str,
    definition: SingleBlock,
    pieces: Sequence[Piece],
    *,
    loads: tuple[Load, ...],
) -> MechanismPieces:
    """Build a single block that rocks about the edges of its base.

    Parameters
    ----------
    name : of the mechanism
    definition : as an engineer states it, with its direction
    pieces : the one block, cut from the bodies
    loads : in the plane of motion
    """
    front, back = (
        hinges_in_plane(definition.hinge_points, definition),
        hinges_in_plane(definition.hinges_negative, definition),
    )
    mechanism = single_block(
        name,
        pieces[0].body,
        hinge=front[0] if front else None,
        hinge_negative=back[0] if back else None,
        loads=loads,
        warnings=() if front else tuple(hinge_warnings(pieces[0], definition.towards)),
        **common_arguments(definition),
    )
    if definition.side_walls is None or definition.side_walls.bond == "detached":
        return mechanism, pieces
    where = f'mechanism "{name}"'
    toothed = toothed_block(where, definition.side_walls, pieces[0], definition.along, foot=mechanism.elevation)
    return replace(mechanism, toothed=toothed, warnings=(*mechanism.warnings, note("side-walls-where-counted"))), pieces


@dataclass(frozen=True, kw_only=True)
class EquivalentBlock:
    """A mechanism by its rocking parameters, as published tables give them."""

    kind: ClassVar[str] = "equivalent-block"
    p: Annotated[PositiveRate, UNCERTAIN, Evidence("defines", "down", "as published")]
    """frequency parameter, like "1.60 1/s\""""
    uplift: Annotated[Uplift, UNCERTAIN_UPLIFT, Evidence("defines", "up", "as published")]
    """multiplier that starts rocking, taken as the slenderness [rad], like 0.14"""
    radius: Annotated[PositiveLength, Evidence("defines", "up", "as published")]
    """distance from hinge to centre of mass, like "2.84 m\""""
    label: Annotated[str, FREE] = ""
    """what the report calls it; the name of the table if absent"""
    sides: Annotated[Sides, Evidence("chosen", "either", "two, unless the drawing shows what stops it")] = "two"
    """"two", or "one": positive rotation only, the building behind stops the other"""
    restitution: Restitution = field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""
    mass: Annotated[PositiveMass, Evidence("defines", "none", "any", judged="rocking does not depend on it")] = 1.0
    """mass of the mechanism"""
    elevation: Annotated[Length, Evidence("drawn", "down", "as drawn")] = 0.0
    """of the mechanism's base, in the coordinates of the bodies"""

    def faults(self) -> Iterator[Fault]:
        """Yield a frequency parameter that no mechanism of this radius has."""
        least, most = INERTIA_RATIOS
        ratio = inf if self.p < TINIEST else g / (self.p * self.p * self.radius)
        if not least <= ratio <= most:
            low, high = (sqrt(g / (each * self.radius)) for each in (most, least))
            yield (
                "p",
                f"with a radius of {self.radius:.4g} m the inertia about the hinge is {ratio:.3g} M R^2, which no "
                f"mechanism has; give {low:.3g} to {high:.3g} 1/s (a slender block has sqrt(3 g / (4 R)) = "
                f"{sqrt(0.75 * g / self.radius):.3g} 1/s), or another radius",
            )


def equivalent_block(
    name: str,
    *,
    p: float,
    uplift: float,
    radius: float,
    mass: float = 1.0,
    label: str = "",
    sides: Sides = "two",
    elevation: float = 0.0,
    restitution: tuple[RestitutionChoice, RestitutionChoice] = (None, None),
) -> Mechanism:
    """Make a single block from its rocking parameters.

    Its inertia about the hinge is M g R / p^2. It is symmetric, with its base centred on the origin, and drawn as the
    rectangle with the same slenderness and radius.

    Parameters
    ----------
    name : of the mechanism
    p : frequency parameter [1/s]
    uplift : slenderness [rad]
    radius : from hinge to centroid [m]
    mass : [kg]
    label : for reports; empty: the name
    sides : "one" or "two"
    elevation : of the base [m]
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind
    """
    half, height = radius * sin(uplift), radius * cos(uplift)
    block = RigidBlock(mass, (0.0, elevation + height), mass * g * radius / p**2 - mass * radius**2)
    chain = Chain((block,), ((half, elevation),))
    top = elevation + 2 * height
    k = g / (p**2 * radius)
    impossible = warning("no-such-body", ratio=Quantity(k, figures=3))
    outline: tuple[Point, ...] = ((-half, elevation), (half, elevation), (half, top), (-half, top))
    return assemble(
        name,
        EQUIVALENT_BLOCK,
        chain,
        chain if sides == "two" else None,
        label=label,
        restitution=restitution,
        outlines=((outline,),),
        warnings=(impossible,) if k < 1.0 else (),
    )


def _require_stable(chain: Chain, *, name: str, towards: str, beside: str) -> None:
    """Raise MechanismError unless the centroid of the block with its loads is above its hinge and behind it."""
    block = plain_block(chain)
    behind, height = block.radius * sin(block.slenderness), block.radius * cos(block.slenderness)
    if height <= 0:
        raise MechanismError(
            f'mechanism "{name}": the centroid lies {-height:.4g} m below the hinge of {towards} rotation; '
            "a rocking block has its centroid above the hinge: check hinges and cut"
        )
    if behind <= 0:
        raise FallingError(
            f'mechanism "{name}": already falling in {towards} rotation: the centroid lies {-behind:.4g} m beyond '
            "the hinge; check the geometry, the direction, the hinges and the loads",
            behind / height,
            beside=beside,
        )


def _off_base_warnings(body: PlanarBody, hinge: Point | None, label: str) -> list[Message]:
    """Return a warning if a given hinge lies beside, above or below the base of the body."""
    if hinge is None or body.base is None:
        return []
    low, high = body.base
    width = high[0] - low[0]
    tolerance = 0.01 * width
    elevation = low[1] + (hinge[0] - low[0]) * (high[1] - low[1]) / (width or 1.0)
    if low[0] - tolerance <= hinge[0] <= high[0] + tolerance and abs(hinge[1] - elevation) <= tolerance:
        return []
    beside = not low[0] - OUTSIDE * width <= hinge[0] <= high[0] + OUTSIDE * width
    ends = lengths(low_x=low[0], low_z=low[1], high_x=high[0], high_z=high[1])
    return [warning(HingeBeside.BASE if beside else "hinge-off-base", hinge=label, **point_values(hinge), **ends)]


def _edge_hinge(body: PlanarBody, towards: Literal["positive", "negative"], *, name: str) -> Point:
    """Return the edge of the base about which the body rocks."""
    if body.base is None:
        raise MechanismError(
            f'mechanism "{name}": its body has no geometry, so its base is not known; '
            "give hinges = { A = [x, z] } and, for two-sided rocking, hinges_negative = { A = [x, z] }"
        )
    low, high = body.base
    width = high[0] - low[0]
    if width <= 1e-6 * hypot(body.centroid[0] - low[0], body.centroid[1] - low[1]):
        raise MechanismError(
            f'mechanism "{name}": the body touches the ground on an edge or a point (width {width:.3g} m), '
            "so it has no base to rock on; give hinges, a cut just above, or mend the geometry"
        )
    return high if towards == "positive" else low


def _build_equivalent_block(
    name: str, definition: EquivalentBlock, pieces: Sequence[Piece], *, loads: tuple[Load, ...]
) -> MechanismPieces:
    """Build the mechanism of published parameters, which has no masonry and no loads."""
    mechanism = equivalent_block(
        name,
        p=definition.p,
        uplift=definition.uplift,
        radius=definition.radius,
        mass=definition.mass,
        label=definition.label,
        sides=definition.sides,
        elevation=definition.elevation,
        restitution=definition.restitution.choices,
    )
    return mechanism, pieces


BLOCK_RULES = ImpactRules(
    two_sided={"thesis": single_block_rule, "housner": housner_rule, "momentum": conserve_momentum},
    one_sided={"thesis": sorrentino_rebound, "sorrentino": sorrentino_rebound},
)
SINGLE_BLOCK = MechanismKind(
    definition=SingleBlock,
    build=build_single_block,
    impacts=BLOCK_RULES,
    support="free",
    direction_sought=True,
    turns_on_base=True,
)
EQUIVALENT_BLOCK = MechanismKind(
    definition=EquivalentBlock, build=_build_equivalent_block, impacts=BLOCK_RULES, support="free"
)
