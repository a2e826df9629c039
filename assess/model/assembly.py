"""Mechanisms from what an engineer states: bodies are cut into blocks, loads found, joints put under the hinges."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from assess.errors import CrackError, MechanismError
from assess.geometry.cut import Piece, Scene
from assess.mechanisms.assembly import MechanismPieces, hinges_in_plane
from assess.mechanisms.kinds import KINDS, Definition
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.mechanisms.two_block import TwoBlock
from assess.model.bodies import Bodies, pieces_of, scene_of
from assess.model.joint_planes import faces_of
from assess.model.joints import place_on_joints
from assess.model.loading import loads_of
from assess.model.walls import Crack, blocks_at, crack_of, require_as_found


@dataclass(frozen=True)
class Built:
    """A mechanism, and its bodies in space where it has any."""

    mechanism: Mechanism
    scene: Scene | None


def mechanism_of(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism of a definition."""
    if not isinstance(definition, BlockMechanism):
        mechanism, _ = KINDS[definition.kind].build(name, definition, (), loads=())
        return Built(mechanism, None)
    rigid, members = on_rigid_hinges(name, definition, bodies)
    jointed = place_on_joints(rigid, definition, members, bodies, restitution=definition.restitution.choices)
    faces = faces_of(jointed, definition, members, bodies)
    return Built(replace(jointed, faces=faces, direction=definition.towards), scene_of(members, definition.towards))


def on_rigid_hinges(name: str, definition: BlockMechanism, bodies: Bodies) -> MechanismPieces:
    """Build the mechanism on rigid hinges, before it is placed on its joints."""
    try:
        pieces, crack = cut_into_blocks(name, definition, bodies)
        load_set = loads_of(name, definition, pieces, bodies)
        require_as_found(crack, load_set.loads)
        mechanism, members = KINDS[definition.kind].build(name, definition, pieces, loads=load_set.loads)
    except CrackError as error:
        raise MechanismError(f'mechanism "{name}": {error}') from None
    warnings = mechanism.warnings if crack is None else (*crack.warnings, *mechanism.warnings)
    return replace(mechanism, warnings=(*warnings, *load_set.warnings)), members


def cut_into_blocks(name: str, definition: BlockMechanism, bodies: Bodies) -> tuple[Sequence[Piece], Crack | None]:
    """Cut the bodies into blocks; a wall of one body is cut at its crack, which is returned too."""
    pieces = pieces_of(name, definition, bodies)
    if not isinstance(definition, TwoBlock) or len(pieces) == 2:
        return pieces, None
    front = hinges_in_plane(definition.hinge_points, definition)
    found = crack_of(definition, pieces[0], bodies, lambda: loads_of(name, definition, pieces, bodies), front=front)
    return blocks_at(found.elevation, name, definition, pieces[0]), found
