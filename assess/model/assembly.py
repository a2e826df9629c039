"""Mechanisms from their definitions: hinges and defaults of each kind."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from assess.errors import CrackError, MechanismError
from assess.geometry.cut import Piece, Scene
from assess.loads.load import Load, Place, Point, point_in_plane
from assess.mechanisms.four_hinge import FourHinge, arch_mechanism, four_hinge
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.mechanisms.single_block import EquivalentBlock, SingleBlock, equivalent_block, single_block
from assess.mechanisms.two_block import TwoBlock, two_block
from assess.messages.message import distinct
from assess.model.bodies import Bodies, hinge_warnings, pieces_of, scene_of
from assess.model.joint_planes import faces_of
from assess.model.joints import place_on_joints
from assess.model.loading import loads_of
from assess.model.walls import Crack, blocks_at, crack_of, require_as_found

MechanismPieces = tuple[Mechanism, Sequence[Piece]]  # a mechanism, and the piece of masonry of each of its outlines


@dataclass(frozen=True)
class Built:
    """A mechanism, and its bodies in space where it has any."""

    mechanism: Mechanism
    scene: Scene | None


def mechanism_of(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism of a definition."""
    if isinstance(definition, EquivalentBlock):
        return Built(build_equivalent_block(name, definition), None)
    rigid, members = on_rigid_hinges(name, definition, bodies)
    jointed = place_on_joints(rigid, definition, members, bodies, restitution=restitution_of(definition))
    faces = faces_of(jointed, definition, members, bodies)
    return Built(replace(jointed, faces=faces, direction=definition.towards), scene_of(members, definition.towards))


def build_equivalent_block(name: str, definition: EquivalentBlock) -> Mechanism:
    """Return the mechanism of published parameters."""
    return equivalent_block(
        name,
        p=definition.p,
        uplift=definition.uplift,
        radius=definition.radius,
        mass=definition.mass,
        label=definition.label,
        sides=definition.sides,
        elevation=definition.elevation,
        restitution=restitution_of(definition),
    )


def on_rigid_hinges(name: str, definition: BlockMechanism, bodies: Bodies) -> MechanismPieces:
    """Build the mechanism on rigid hinges, before it is placed on its joints."""
    try:
        pieces, crack = cut_into_blocks(name, definition, bodies)
        load_set = loads_of(name, definition, pieces, bodies)
        require_as_found(crack, load_set.loads)
        mechanism, members = BUILDERS[type(definition)](name, definition, pieces, bodies, loads=load_set.loads)
    except CrackError as error:
        raise MechanismError(f'mechanism "{name}": {error}') from None
    warnings = mechanism.warnings if crack is None else (*crack.warnings, *mechanism.warnings)
    return replace(mechanism, warnings=(*warnings, *load_set.warnings)), members


def cut_into_blocks(name: str, definition: BlockMechanism, bodies: Bodies) -> tuple[Sequence[Piece], Crack | None]:
    """Cut the bodies into blocks; a wall of one body is cut at its crack, which is returned too."""
    pieces = pieces_of(name, definition, bodies)
    if not isinstance(definition, TwoBlock) or len(pieces) == 2:
        return pieces, None
    front = hinges_of(definition.hinge_points, definition)
    found = crack_of(definition, pieces[0], bodies, lambda: loads_of(name, definition, pieces, bodies), front=front)
    return blocks_at(found.elevation, name, definition, pieces[0]), found


def build_single_block(
    name: str,
    definition: SingleBlock,
    pieces: Sequence[Piece],
    bodies: Bodies,
    *,
    loads: tuple[Load, ...],
) -> MechanismPieces:
    """Build a single block that rocks about the edges of its base."""
    front, back = hinges_of(definition.hinge_points, definition), hinges_of(definition.hinges_negative, definition)
    mechanism = single_block(
        name,
        pieces[0].body,
        hinge=front[0] if front else None,
        hinge_negative=back[0] if back else None,
        loads=loads,
        warnings=() if front else tuple(hinge_warnings(pieces[0], definition.towards)),
        **common_arguments(definition),
    )
    return mechanism, pieces


def build_two_block(
    name: str,
    definition: TwoBlock,
    pieces: Sequence[Piece],
    bodies: Bodies,
    *,
    loads: tuple[Load, ...],
) -> MechanismPieces:
    """Build a wall held at its base and its top, of two bodies or of one that cracks."""
    front, back = hinges_of(definition.hinge_points, definition), hinges_of(definition.hinges_negative, definition)
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


def build_four_hinge(
    name: str,
    definition: FourHinge,
    pieces: Sequence[Piece],
    bodies: Bodies,
    *,
    loads: tuple[Load, ...],
) -> MechanismPieces:
    """Build three blocks between given hinges, or an arch whose hinges are searched for."""
    if definition.hinges == "minimum":
        return arch_mechanism(name, definition, pieces[0], **common_arguments(definition))
    mechanism = four_hinge(
        name,
        [piece.body for piece in pieces],
        hinges=hinges_of(definition.hinge_points, definition),
        hinges_negative=hinges_of(definition.hinges_negative, definition),
        loads=loads,
        **common_arguments(definition),
    )
    return mechanism, pieces


BUILDERS: dict[type[BlockMechanism], Callable[..., MechanismPieces]] = {
    SingleBlock: build_single_block,
    TwoBlock: build_two_block,
    FourHinge: build_four_hinge,
}


def common_arguments(definition: BlockMechanism) -> dict[str, Any]:
    """Return what every kind of chain takes unchanged."""
    return {
        "label": definition.label,
        "sides": "two" if definition.two_sided else "one",
        "restitution": restitution_of(definition),
    }


def restitution_of(definition: BlockMechanism | EquivalentBlock) -> tuple[Any, Any]:
    """Return the choices for the impacts that end the positive and the negative branch."""
    return (definition.restitution.positive, definition.restitution.negative)


def hinges_of(hinges: Sequence[Place] | None, definition: BlockMechanism) -> Any:
    """Return hinges A, B, … as (distance along the direction from the origin, elevation) [m]; None if not given."""
    if hinges is None:
        return None
    points: tuple[Point, ...] = tuple(point_in_plane(at, definition.towards) for at in hinges)
    return points
