"""The entries of `loads` as the field's loads, and warnings about them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import assert_never, cast

import numpy as np

from assess.errors import GeometryError, MechanismError
from assess.geometry.boolean import count_once, mass_within, overlap_warnings
from assess.geometry.contact import CONTACT_TOLERANCE
from assess.geometry.cut import Piece
from assess.geometry.planar import Outline, distance_to_outline
from assess.geometry.solid import Solid
from assess.loads.bearing import overburden_force
from assess.loads.body_loads import (
    FindContact,
    LoadSet,
    MechanismBlocks,
    Surroundings,
    body_loads,
    find_block_contact,
    loaded_blocks,
)
from assess.loads.far_wall import FarEnd, FarWall
from assess.loads.load import (
    SAME_END,
    BodyLoad,
    Force,
    ForceLoad,
    Load,
    LoadDefinition,
    MassLoad,
    OverburdenLoad,
    Point,
    PointMass,
    Tie,
    TieLoad,
    out_of_plane,
    point_in_plane,
    share_ends,
    unit_in_plane,
)
from assess.mechanisms.chain import point_values
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.single_block import SingleBlock
from assess.messages.message import Message, Quantity, distinct, warning, whole_number
from assess.model.bodies import Bodies, pieces_of, solids_of
from assess.model.far_walls import far_wall_of
from assess.model.plates import anchorages_of

IN_THE_AIR = 0.05  # of the block's size: a load farther outside it is not on the block


def loads_of(
    name: str,
    definition: BlockMechanism,
    pieces: Sequence[Piece],
    bodies: Bodies,
    *,
    find: FindContact = find_block_contact,
) -> LoadSet:
    """Find the loads of a mechanism; pieces: its blocks, or all in one; find: the contacts of bodies.

    Raises GeometryError for a body that touches nothing of its block.
    """
    blocks = _blocks_of(name, definition, pieces)
    _require_places_of_ties(definition.loads, pieces, blocks)
    carried = dict.fromkeys(load.body for load in definition.loads if isinstance(load, BodyLoad) and load.mass is None)
    known = [solid for body in carried if (solid := bodies[body].solid) is not None]
    remainders = {solid.name: None for solid in known} | {solid.name: solid for solid in count_once(known)}
    parts = [
        _loads_of_entry(number, load, _at_load(number, blocks), definition, bodies, remainders, find=find)
        for number, load in enumerate(definition.loads, start=1)
    ]
    for place, held in anchorages_of(definition.loads, pieces, where=blocks.where).items():
        wall, end = _far_wall(place, definition, bodies, where=blocks.where)
        anchorage = replace(held, far_wall=wall, far_end=end)
        tie = replace(cast(Tie, parts[place].loads[0]), anchorage=anchorage, strength=anchorage.strength)
        borne = tie.tension if anchorage.far_wall_holds else 0.0
        if borne < tie.pull:
            least = anchorage.governing or "as stated"
            if wall is not None and not anchorage.far_wall_holds:
                raise MechanismError(
                    f"{blocks.where}: loads[{place + 1}].force: a pretension of {tie.pull / 1e3:.4g} kN, where "
                    f'the wall "{wall.body}" at its far end turns inwards by itself at {wall.multiplier:.3g} g, '
                    f"and is to hold the tie at {wall.action:.3g} g (far wall); hold that wall from "
                    "within, or draw what holds it"
                )
            raise MechanismError(
                f"{blocks.where}: loads[{place + 1}].force: a pretension of {tie.pull / 1e3:.4g} kN, above what its "
                f"anchorage bears, {borne / 1e3:.4g} kN ({least}); lower it, or strengthen the anchorage"
            )
        parts[place] = replace(parts[place], loads=(tie,))
    moving = [solid for piece in pieces for solid in piece.solids]
    warnings = [each for part in parts for each in part.warnings] + list(overlap_warnings(known, built_into=moving))
    return LoadSet(
        loads=tuple(load for part in parts for load in part.loads),
        warnings=distinct(warnings),
        block_by_place=tuple(each for part in parts for each in part.block_by_place),
    )


def _far_wall(place: int, definition: BlockMechanism, bodies: Bodies, *, where: str) -> tuple[FarWall | None, FarEnd]:
    """Return the wall at the far end of the tie at a place among the loads, as a mechanism and what is known of it."""

    def loads_on(far: SingleBlock) -> tuple[Load, ...]:
        return loads_of("far wall", far, pieces_of("far wall", far, bodies), bodies).loads

    return far_wall_of(
        cast(TieLoad, definition.loads[place]),
        definition.loads,
        bodies,
        moving=definition.bodies,
        loads_on=loads_on,
        where=f"{where}: loads[{place + 1}].plate",
    )


def _require_places_of_ties(loads: Sequence[LoadDefinition], pieces: Sequence[Piece], blocks: MechanismBlocks) -> None:
    """Raise MechanismError for a tie that is stated twice, or holds beside its block, seen along the direction."""
    across = np.array([-blocks.along[1], blocks.along[0], 0.0])
    known: list[tuple[int, TieLoad]] = []
    for number, load in enumerate(loads, start=1):
        if not isinstance(load, TieLoad) or len(load.at) != 3 or load.plate is not None:  # plates look for themselves
            continue
        for earlier, other in known:
            if share_ends(load, other):
                raise MechanismError(
                    f"{blocks.where}: loads[{number}].at: a tie with the ends of loads[{earlier}], which would count "
                    "twice; remove one, and give the other the section of both"
                )
        known.append((number, load))
        solids = pieces[min(load.block, len(pieces) - 1)].solids
        if solids:
            reach = np.concatenate([solid.vertices @ across for solid in solids])
            low, high, at = float(reach.min()), float(reach.max()), float(np.array(load.at) @ across)
            if not low - SAME_END <= at <= high + SAME_END:
                beside = max(low - at, at - high)
                raise MechanismError(
                    f"{blocks.where}: loads[{number}].at: {beside:.3g} m beside the block that it holds, which is "
                    f"{high - low:.4g} m long across the direction; give the place where it holds"
                )


def surroundings(load: BodyLoad, blocks: MechanismBlocks, number: int, bodies: Bodies) -> Surroundings:
    """Return what stands around a body that loads a block; bodies of the mechanism as they are cut."""
    pieces = blocks.pieces
    moving = {solid.name for piece in pieces for solid in piece.solids} | {load.body}
    others = [each.solid for key, each in bodies.items() if each.solid is not None and key not in moving]
    others += [solid for place, piece in enumerate(pieces) if place != number for solid in piece.solids]
    fixed = tuple(solid for piece in pieces for solid in piece.fixed)
    return Surroundings(pieces[number].solids, tuple(others), fixed, blocks.along, where=blocks.where)


def _at_load(number: int, blocks: MechanismBlocks) -> MechanismBlocks:
    """Return blocks with the load in the place that errors name."""
    return replace(blocks, where=f"{blocks.where}: loads[{number}]")


def _loads_of_entry(
    number: int,
    load: LoadDefinition,
    blocks: MechanismBlocks,
    definition: BlockMechanism,
    bodies: Bodies,
    remainders: Mapping[str, Solid | None],
    *,
    find: FindContact,
) -> LoadSet:
    """Find the loads of one entry of `loads`, its number counted from 1.

    remainders : of each body that counts by its volume, what no load before it counts; None where nothing is left
    """
    if isinstance(load, OverburdenLoad):
        force, warnings = overburden_force(
            number,
            load,
            piece=blocks.pieces[-1],
            solids=solids_of(bodies),
            moving=definition.bodies,
            direction=definition.towards,
            where=blocks.where,
        )
        return LoadSet((force,), warnings, (False,))
    if isinstance(load, BodyLoad):
        remainder = remainders.get(load.body, bodies[load.body].solid)
        if remainder is None and load.body in remainders and load.role == "floor":
            return LoadSet((), ())  # it lies wholly in the bodies of loads before it, and pushes nothing
        part = _loads_of_body(load, blocks, definition, bodies, remainder, find=find)
    else:
        part = LoadSet((_load_in_plane(number, load, definition.towards, where=blocks.where),), ())
    outlines = [piece.body.outline for piece in blocks.pieces]
    _require_end_within_height(part.loads, outlines, where=blocks.where)
    warnings = (
        *part.warnings,
        *_misplaced_load_warnings(part.loads, blocks),
        *_moving_anchor_warnings(part.loads, outlines),
    )
    return LoadSet(part.loads, warnings, (isinstance(load, BodyLoad) and load.block is None,) * len(part.loads))


def _blocks_of(name: str, definition: BlockMechanism, pieces: Sequence[Piece]) -> MechanismBlocks:
    """Return the blocks as loads meet them; two blocks without geometry part at hinge B."""
    cracked = len(definition.blocks) == 1 and len(pieces) == 2
    foot, crack = pieces[-1].foot, None
    if cracked and foot is not None:
        crack = float(foot[0, 2])
    elif len(pieces) == 2 and not any(piece.solids for piece in pieces):
        crack = None if (hinges := definition.hinge_points) is None else hinges[1][-1]
    return MechanismBlocks(tuple(pieces), crack, cracked, definition.along, where=f'mechanism "{name}"')


def _loads_of_body(
    load: BodyLoad,
    blocks: MechanismBlocks,
    definition: BlockMechanism,
    bodies: Bodies,
    remainder: Solid | None,
    *,
    find: FindContact,
) -> LoadSet:
    """Find what a body puts on each block that it loads; nothing if it rests below the cut.

    remainder : what no load before it counts; None for nothing, and without geometry

    Raises GeometryError where it touches nothing of them, or it is not known which of them it loads.
    """
    body, counts_volume = bodies[load.body].solid, load.mass is None
    once = 1.0 if body is None or not counts_volume else 0.0 if remainder is None else remainder.mass / body.mass
    taken = {each.block for each in definition.loads if isinstance(each, BodyLoad) and each.body == load.body}
    found, warnings = loaded_blocks(load, body, among=blocks, taken=taken)
    parts = [
        body_loads(
            load,
            block=each.block,
            body=body,
            mass=bodies[load.body].mass,
            once=once,
            within=_mass_in_masonry(remainder, blocks.pieces_at(each.contact)) if counts_volume else 0.0,
            around=surroundings(load, blocks, each.contact, bodies),
            find=find,
        )
        for each in found
    ]
    loads = tuple(one for part in parts for one in part.loads)
    return LoadSet(loads, (*warnings, *(each for part in parts for each in part.warnings)))


def _mass_in_masonry(body: Solid | None, pieces: Sequence[Piece]) -> float:
    """Return the mass of a body that lies in the masonry of a block [kg]."""
    return 0.0 if body is None else mass_within([solid for piece in pieces for solid in piece.solids], body)


def _load_in_plane(
    number: int,
    load: MassLoad | ForceLoad | TieLoad,
    direction: Sequence[float],
    *,
    where: str,
) -> Load:
    """Return a load in the plane of motion, named by its kind and number."""
    name, at = f"{load.kind} {number}", point_in_plane(load.at, direction)
    match load:
        case MassLoad():
            return PointMass(name, load.mass, at, load.bearing, load.block, seat=load.seat)
        case ForceLoad():
            force = _force_in_plane(load, direction)
            return Force(name, force, at, load.block, until=load.until, evidence=load.evidence)
        case TieLoad():
            return _tie_in_plane(name, load, at, direction, where=where)
        case _:
            assert_never(load)


def _force_in_plane(load: ForceLoad, direction: Sequence[float]) -> Point:
    """Return the components of a force in the plane of motion [N]."""
    if isinstance(load.force, tuple):
        return load.force
    assert load.direction is not None  # a force given by its size has a direction
    along, up = unit_in_plane(load.direction, direction)
    return (load.force * along, load.force * up)


def _tie_in_plane(name: str, load: TieLoad, at: Point, direction: Sequence[float], *, where: str) -> Tie:
    """Return a tie in the plane of motion; raise GeometryError if its anchor is then where it holds the block."""
    way = None if load.direction is None else unit_in_plane(load.direction, direction)
    anchor = None if load.anchor is None else point_in_plane(load.anchor, direction)
    aside = 0.0
    if load.anchor is not None and len(load.anchor) == len(load.at):
        aside = out_of_plane(np.subtract(load.anchor, load.at).tolist(), direction)
    length, stiffness, pull = load.length, load.stiffness, load.force or 0.0
    bar = None if load.area is None else load.area * (load.yield_stress or 0.0)
    if load.area is not None and length is not None:
        EA = (load.young_modulus or 0.0) * load.area
        length = length / (1.0 + pull / EA) + load.slack  # free of stress, as it stretches from there
        stiffness = EA / length
    if anchor == at:
        raise GeometryError(f"{where}.anchor: seen in the plane of motion it is where the tie holds; move one")
    return Tie(
        name,
        pull,
        at,
        way,
        anchor,
        both=load.both,
        block=load.block,
        until=load.until,
        strength=load.strength,
        length=length,
        fracture_strain=load.fracture_strain,
        evidence=load.evidence,
        stiffness=stiffness,
        yield_force=load.strength if load.stiffness is not None else bar,
        slack=load.slack,
        aside=aside,
    )


def _require_end_within_height(loads: Sequence[Load], outlines: Sequence[Outline], *, where: str) -> None:
    """Raise MechanismError for a force or tie that is to end at a displacement longer than its point is high."""
    levels = [point[1] for outline in outlines for ring in outline for point in ring]
    for load in loads:
        end = getattr(load, "until", None)
        height = load.at[1] - min(levels) if levels else inf
        if isinstance(end, float) and end > height > 0.0:
            raise MechanismError(
                f"{where}.until = {end:.4g} m: longer than its point is high above the base of "
                f"what moves, {height:.4g} m; give the displacement at which it ends"
            )


def _moving_anchor_warnings(loads: Sequence[Load], outlines: Sequence[Outline]) -> Iterator[Message]:
    """Warn of each tie whose anchor lies on a block of the mechanism, seen in the plane of motion."""
    for load in loads:
        if not isinstance(load, Tie) or load.anchor is None:
            continue
        for block, outline in enumerate(outlines):
            if outline and distance_to_outline(outline, load.anchor) <= CONTACT_TOLERANCE:
                anchor = point_values(load.anchor)
                yield warning("load-anchor-moves", load=load.name, block=whole_number(block), **anchor)


def _misplaced_load_warnings(loads: Sequence[Load], blocks: MechanismBlocks) -> Iterator[Message]:
    """Warn of each load that is not on or near its block, seen in the plane of motion, ignoring the crack."""
    for load in loads:
        whole = blocks.pieces_at(min(load.block, len(blocks.pieces) - 1))
        outline = tuple(ring for piece in whole for ring in piece.body.outline)
        corners = [point for ring in outline for point in ring]
        size = float(np.ptp(corners, axis=0).max()) if corners else 0.0
        off = distance_to_outline(outline, load.at) if corners else 0.0
        if off > IN_THE_AIR * size:
            away = Quantity(off, "length", 3)
            yield warning("load-in-the-air", load=load.name, distance=away, **point_values(load.at))
