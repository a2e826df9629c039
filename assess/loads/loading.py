"""The entries of `loads` as the field's loads, and what is doubtful of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from assess.errors import GeometryError
from assess.geometry.contact import TOLERANCE
from assess.geometry.outline import Outline, distance
from assess.loads.body_loads import Brought, Meet, Surroundings, body_loads, meeting, told_of
from assess.loads.load import Force, Load, PointMass, Tie
from assess.loads.loaded_blocks import Blocks, loaded_blocks
from assess.loads.overburden import overburden_of
from assess.loads.plane import point_in_plane, unit_in_plane
from assess.mechanisms.chain import written
from assess.model.overlaps import overlaps
from assess.model.pieces import Piece, Solids
from assess.project import sections
from assess.project.sources import shown_by

IN_THE_AIR = 0.05  # of the block's size: a load farther outside it is not on the block


def loads_of(
    name: str,
    section: sections.Chained,
    pieces: Sequence[Piece],
    content: sections.Content,
    solids: Solids,
    *,
    meet: Meet = meeting,
) -> Brought:
    """The loads of the mechanism `name`; pieces: its blocks, or all of them in one; meet: finds contacts of bodies.

    Raises GeometryError for a body that touches nothing of its block.
    """
    loads: list[Load] = []
    doubts: list[str] = []
    follows: list[bool] = []
    blocks = blocks_of(name, section, pieces)
    for number, load in enumerate(section.loads, start=1):
        if isinstance(load, sections.OverburdenLoad):
            loads.append(
                overburden_of(
                    number,
                    load,
                    piece=pieces[-1],
                    solids=solids,
                    moving=[body for block in section.blocks for body in block],
                    direction=section.towards,
                    where=f'mechanism "{name}"',
                )
            )
            follows.append(False)
            continue
        if isinstance(load, sections.BodyLoad):
            brought = of_body(load, blocks, section, content, solids, meet=meet)
        else:
            brought = Brought((load_of(number, load, section.towards, evidence=evidence_of(name, content)),), ())
        loads += brought.loads
        follows += [isinstance(load, sections.BodyLoad) and load.block is None] * len(brought.loads)
        doubts += (*brought.doubts, *in_the_air(brought.loads, blocks))
        doubts += moving_anchors(brought.loads, [each.body.outline for each in pieces])
    carried = dict.fromkeys(load.body for load in section.loads if isinstance(load, sections.BodyLoad))
    known = [solid for body in carried if (solid := solids[body]) is not None]
    doubts += (each.text for each in overlaps(known))
    return Brought(tuple(loads), tuple(dict.fromkeys(doubts)), tuple(follows))


def blocks_of(name: str, section: sections.Chained, pieces: Sequence[Piece]) -> Blocks:
    """The blocks of the mechanism `name` as its loads meet them; of two direct values they part at hinge B."""
    parted = len(section.blocks) == 1 and len(pieces) == 2
    foot, crack = pieces[-1].foot, None
    if parted and foot is not None:
        crack = float(foot[0, 2])
    elif len(pieces) == 2 and not any(piece.solids for piece in pieces) and isinstance(section, sections.TwoBlock):
        crack = None if section.hinges is None else section.hinges.B[-1]
    along = np.asarray(section.towards) / np.linalg.norm(section.towards)
    return Blocks(tuple(pieces), crack, parted, along, where=f'mechanism "{name}"')


def of_body(
    load: sections.BodyLoad,
    blocks: Blocks,
    section: sections.Chained,
    content: sections.Content,
    solids: Solids,
    *,
    meet: Meet,
) -> Brought:
    """What a body puts on each block that it loads; nothing where it rests below the cut.

    Raises GeometryError where it touches nothing of them, or it is not known which of them it loads.
    """
    body, mass = solids[load.body], mass_of(load.body, content, solids)
    taken = {each.block for each in section.loads if isinstance(each, sections.BodyLoad) and each.body == load.body}
    found, doubts = loaded_blocks(load, body, among=blocks, taken=taken)
    brought = [
        body_loads(
            load,
            block=each.block,
            body=body,
            mass=mass,
            around=surroundings(load, blocks, each.contact, solids),
            meet=meet,
        )
        for each in found
    ]
    loads = tuple(one for each in brought for one in each.loads)
    return Brought(loads, (*told_of(load, doubts), *(text for each in brought for text in each.doubts)))


def surroundings(load: sections.BodyLoad, blocks: Blocks, number: int, solids: Solids) -> Surroundings:
    """What stands around a body that loads a block: bodies as they are, those of the mechanism as cut."""
    pieces = blocks.pieces
    moving = {solid.name for piece in pieces for solid in piece.solids} | {load.body}
    others = [solid for key, solid in solids.items() if solid is not None and key not in moving]
    others += [solid for place, piece in enumerate(pieces) if place != number for solid in piece.solids]
    fixed = tuple(solid for piece in pieces for solid in piece.fixed)
    return Surroundings(pieces[number].solids, tuple(others), fixed, blocks.along, where=blocks.where)


def mass_of(name: str, content: sections.Content, solids: Solids) -> float:
    """The mass of a body by its volume or direct values [kg]."""
    body, solid = content.bodies[name], solids[name]
    if solid is not None:
        return solid.mass
    assert isinstance(body, sections.DirectBody)
    return body.mass


def evidence_of(name: str, content: sections.Content) -> str:
    """Where the loads of the mechanism `name` come from, by [report.sources]; empty where nobody shows it."""
    return shown_by(content, f"mechanisms.{name}.loads")


def load_of(
    number: int,
    load: sections.MassLoad | sections.ForceLoad | sections.TieLoad,
    direction: Sequence[float],
    *,
    evidence: str = "",
) -> Load:
    """One entry of `loads` in the plane of motion, named by its kind and number; evidence: the source of what it is."""
    name, at = f"{load.kind} {number}", point_in_plane(load.at, direction)
    if isinstance(load, sections.MassLoad):
        return PointMass(name, load.mass, at, load.bearing, load.block, seat=load.seat)
    way = None if load.direction is None else unit_in_plane(load.direction, direction)
    if isinstance(load, sections.TieLoad):
        anchor = None if load.anchor is None else point_in_plane(load.anchor, direction)
        if anchor == at:
            raise GeometryError(f'load "{name}": seen in the plane of motion its anchor is where it holds; move one')
        shown = load.model_dump(include={"both", "block", "until", "strength", "length", "fracture_strain"})
        return Tie(name, load.force, at, way, anchor, evidence=evidence, **shown)
    if isinstance(load.force, tuple):
        force = load.force
    else:
        assert way is not None  # the schema asks for it
        force = (load.force * way[0], load.force * way[1])
    return Force(name, force, at, load.block, until=load.until, evidence=evidence)


def moving_anchors(loads: Sequence[Load], outlines: Sequence[Outline]) -> Iterator[str]:
    """A sentence for each tie whose anchor lies on a block of the mechanism, seen in the plane of motion."""
    for load in loads:
        if not isinstance(load, Tie) or load.anchor is None:
            continue
        for block, outline in enumerate(outlines):
            if outline and distance(outline, load.anchor) <= TOLERANCE:
                yield (
                    f'load "{load.name}": its anchor at {written(load.anchor)} lies on block {block}, which '
                    "moves too, yet it is taken as fixed in space: check `anchor`"
                )


def in_the_air(loads: Sequence[Load], blocks: Blocks) -> Iterator[str]:
    """A sentence for each load that is not on or near its block, seen in the plane of motion; a crack parts nothing."""
    for load in loads:
        whole = blocks.pieces if blocks.parted else [blocks.pieces[min(load.block, len(blocks.pieces) - 1)]]
        outline = tuple(ring for piece in whole for ring in piece.body.outline)
        corners = [point for ring in outline for point in ring]
        size = float(np.ptp(corners, axis=0).max()) if corners else 0.0
        off = distance(outline, load.at) if corners else 0.0
        if off > IN_THE_AIR * size:
            yield (
                f'load "{load.name}" at {written(load.at)} is in the air, {off:.3g} m from the '
                "block as seen in the plane of motion; it moves with the block all the same: check `at`"
            )
