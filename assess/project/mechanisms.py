"""The tables [mechanisms.NAME] as mechanisms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from assess.geometry.solid import Solid
from assess.mechanisms.chain import Point
from assess.mechanisms.equivalent_block import equivalent_block
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.single_block import single_block
from assess.project import sections
from assess.project.bodies import block_in_plane, doubts_of
from assess.project.loading import load_of
from assess.project.plane import point_in_plane


def mechanism_of(
    name: str,
    section: sections.Mechanism,
    content: sections.Content,
    solids: Mapping[str, Solid | None],
) -> Mechanism:
    """The mechanism of one table [mechanisms.NAME]."""
    restitution = (section.restitution.positive, section.restitution.negative)
    if isinstance(section, sections.EquivalentBlock):
        own = section.model_dump(include={"p", "uplift", "radius", "mass", "elevation"})
        return equivalent_block(name, **own, label=section.label, sides=section.sides, restitution=restitution)
    body, foot = block_in_plane(name, section, content, solids)
    mechanism = single_block(
        name,
        body,
        hinge=in_plane(section.hinges, section.direction),
        hinge_negative=in_plane(section.hinges_negative, section.direction),
        label=section.label,
        sides=section.sides,
        loads=tuple(load_of(i, load, section.direction) for i, load in enumerate(section.loads, start=1)),
        restitution=restitution,
    )
    return replace(mechanism, notices=(*mechanism.notices, *doubts_of(section, foot)))


def in_plane(hinges: sections.Hinges | None, direction: Sequence[float]) -> Point | None:
    """Hinge A as (distance along `direction` from the origin, elevation) [m]."""
    return None if hinges is None else point_in_plane(hinges.A, direction)
