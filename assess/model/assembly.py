"""The tables [mechanisms.NAME] as mechanisms: hinges and defaults of each kind."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from assess.errors import CrackError, MechanismError
from assess.geometry.scene import Scene
from assess.loads.load import Load
from assess.loads.loading import loads_of
from assess.loads.plane import point_in_plane
from assess.mechanisms.chain import Point
from assess.mechanisms.equivalent_block import equivalent_block
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.model.arches import hinged_arch
from assess.model.faces import faces_of
from assess.model.joints import put_on_joints
from assess.model.pieces import Piece, Solids, doubts_of, pieces_of, scene_of
from assess.model.walls import Crack, blocks_at, crack_of, require_as_found
from assess.project import sections

Parted = tuple[Mechanism, Sequence[Piece]]  # a mechanism, and the piece of masonry of each of its outlines


@dataclass(frozen=True)
class Built:
    """A mechanism, and its bodies in space where it has any."""

    mechanism: Mechanism
    scene: Scene | None


def mechanism_of(name: str, section: sections.Mechanism, content: sections.Content, solids: Solids) -> Built:
    """The mechanism of one table [mechanisms.NAME]."""
    if isinstance(section, sections.EquivalentBlock):
        own = section.model_dump(include={"p", "uplift", "radius", "mass", "elevation", "label", "sides"})
        return Built(equivalent_block(name, **own, restitution=restitution_of(section)), None)
    rigid, members = on_rigid_hinges(name, section, content, solids)
    told = put_on_joints(rigid, section, members, content, restitution=restitution_of(section))
    told = replace(told, faces=faces_of(told, section, members, content), direction=section.towards)
    return Built(told, scene_of(members, section.towards))


def on_rigid_hinges(name: str, section: sections.Chained, content: sections.Content, solids: Solids) -> Parted:
    """The mechanism of one table before it is put on its joints."""
    try:
        pieces, told = parted(name, section, content, solids)
        brought = loads_of(name, section, pieces, content, solids)
        require_as_found(told, brought.loads)
        mechanism, members = BUILDERS[type(section)](name, section, pieces, content, loads=brought.loads)
    except CrackError as error:
        raise MechanismError(f'mechanism "{name}": {error}') from None
    notices = mechanism.notices if told is None else (*told.notices, *mechanism.notices)
    return replace(mechanism, notices=(*notices, *brought.doubts)), members


def parted(
    name: str, section: sections.Chained, content: sections.Content, solids: Solids
) -> tuple[Sequence[Piece], Crack | None]:
    """The blocks of one table, and the crack of a wall of one body, which parts it in two."""
    pieces = pieces_of(name, section, content, solids)
    if not isinstance(section, sections.TwoBlock) or len(pieces) == 2:
        return pieces, None
    front = hinges_of(section.hinges, section)
    found = crack_of(section, pieces[0], content, lambda: loads_of(name, section, pieces, content, solids), front=front)
    return blocks_at(found.elevation, name, section, pieces[0]), found


def of_one_block(
    name: str,
    section: sections.SingleBlock,
    pieces: Sequence[Piece],
    content: sections.Content,
    *,
    loads: tuple[Load, ...],
) -> Parted:
    """A single block about the edges of its base."""
    front, back = hinges_of(section.hinges, section), hinges_of(section.hinges_negative, section)
    mechanism = single_block(
        name,
        pieces[0].body,
        hinge=front[0] if front else None,
        hinge_negative=back[0] if back else None,
        loads=loads,
        notices=() if front else tuple(doubts_of(pieces[0], section.towards)),
        **common(section),
    )
    return mechanism, pieces


def of_two_blocks(
    name: str,
    section: sections.TwoBlock,
    pieces: Sequence[Piece],
    content: sections.Content,
    *,
    loads: tuple[Load, ...],
) -> Parted:
    """A wall held at base and top, of two bodies or of one that is cracked."""
    front, back = hinges_of(section.hinges, section), hinges_of(section.hinges_negative, section)
    lower, upper = pieces
    doubts = () if front else tuple(text for piece in pieces for text in doubts_of(piece, section.towards))
    mechanism = two_block(
        name,
        lower.body,
        upper.body,
        hinges=front,
        hinges_negative=back,
        loads=loads,
        notices=tuple(dict.fromkeys(doubts)),
        **common(section),
    )
    return mechanism, pieces


def of_four_hinges(
    name: str,
    section: sections.FourHinge,
    pieces: Sequence[Piece],
    content: sections.Content,
    *,
    loads: tuple[Load, ...],
) -> Parted:
    """Three blocks between four hinges that are given, or an arch whose hinges are looked for."""
    if not isinstance(section.hinges, sections.FourHinges):
        return hinged_arch(name, section, pieces[0], **common(section))
    mechanism = four_hinge(
        name,
        [piece.body for piece in pieces],
        hinges=hinges_of(section.hinges, section),
        hinges_negative=hinges_of(section.hinges_negative, section),
        loads=loads,
        **common(section),
    )
    return mechanism, pieces


BUILDERS: dict[type[sections.Chained], Callable[..., Parted]] = {
    sections.SingleBlock: of_one_block,
    sections.TwoBlock: of_two_blocks,
    sections.FourHinge: of_four_hinges,
}


def common(section: sections.Chained) -> dict[str, Any]:
    """What every kind of chain takes as it is."""
    return {
        "label": section.label,
        "sides": "two" if section.two_sided else "one",
        "restitution": restitution_of(section),
    }


def restitution_of(section: sections.Chained | sections.EquivalentBlock) -> tuple[Any, Any]:
    """The choices for the impacts that end the positive and the negative branch."""
    return (section.restitution.positive, section.restitution.negative)


def hinges_of(hinges: sections.Hinges | None, section: sections.Chained) -> Any:
    """Hinges A, B, ... as (distance along `direction` from the origin, elevation) [m]; None where not given."""
    if hinges is None:
        return None
    points: tuple[Point, ...] = tuple(point_in_plane(at, section.towards) for _, at in hinges)
    return points
