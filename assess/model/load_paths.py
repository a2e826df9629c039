"""What the drawing leaves open of which walls carry a floor or roof, taken for each mechanism as it is worse."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import inf, tan

import numpy as np

from assess.loads.load import BodyLoad, LoadDefinition, OverburdenLoad, PointMass
from assess.mechanisms.arch_in_plan import HorizontalArch
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.wedged_block import Corner, WedgedBlock
from assess.model.assembly import on_rigid_hinges
from assess.model.covering_paths import NO_SHARE
from assess.model.least_multipliers import NAME, THRUSTING, Drawing, Found, built, weakest_turn
from assess.model.moving_parts import levels_of, stacks_of, standing_above, ways_of


def by_worst_paths(found: Found, drawing: Drawing) -> tuple[Found, tuple[str, ...]]:
    """Return a mechanism with each covering on it by the path of its weight that is worst, and the coverings left open.

    Shares are stated, and those of two mechanisms may count one covering twice; one that puts nothing on it is no load.
    The multiplier is a quotient of sums in which each share counts once, so that it is least at one end of its range.
    What presses on a wall that bends stays as drawn: where nothing does, the wall turns as a cantilever instead. A wall
    that the thrust of its share would push over stands today, so that something takes the thrust. Of a wall that moves
    in part, as in a wedge or a bay, as much of its share counts as of its length moves.
    """
    definition = found.definition
    if definition is None or found.multiplier is None:
        return found, ()
    loads = [load for load in definition.loads if isinstance(load, BodyLoad)]
    pressing = [body for load in definition.loads if isinstance(load, OverburdenLoad) for body in load.bodies]
    bodies = dict.fromkeys((*(load.body for load in loads), *pressing))
    paths = {body: drawing.paths[body] for body in bodies}
    unsure = tuple(body for body, each in paths.items() if len(each) > 1)
    moved = _share_that_moves(definition, drawing)
    ranges = {load.body: sorted(path.on(moved) for path in paths[load.body]) for load in loads}
    if not any(body in ranges for body in unsure):
        return found, unsure
    alone = {name: drawing.bodies[name] for name in (*definition.bodies, *definition.neighbours, *ranges)}
    chosen = {body: each[-1] for body, each in ranges.items() if each}
    for body in (each for each in unsure if each in ranges):
        tried = {
            share: built(_with_shares(definition, {**chosen, body: share}), alone, {}).multiplier
            for share in (ranges[body][0], ranges[body][-1])
        }
        chosen[body] = min(tried, key=lambda share: inf if tried[share] is None else tried[share] or 0.0)
    stated = _with_shares(definition, {body: share for body, share in chosen.items() if body in unsure})
    worst = built(stated, drawing.around(definition), found.parameters)
    pushing = tuple(load.body for load in loads if load.role in THRUSTING and not load.tied)
    if worst.multiplier is not None and worst.multiplier <= 0.0 and pushing:
        worst = built(
            replace(stated, loads=tuple(map(_tied, stated.loads))), drawing.around(definition), found.parameters
        )
        worst = replace(worst, tied=tuple(dict.fromkeys((*found.tied, *pushing))))
    else:
        worst = replace(worst, tied=found.tied)
    if worst.multiplier is None or 0.0 < found.multiplier < worst.multiplier:
        shares = _shares_by_statics(definition, drawing)  # with all of the thrust
        stated = _with_shares(definition, {body: shares[body] for body in unsure if body in shares})
        worst = replace(built(stated, drawing.around(definition), found.parameters), tied=found.tied)
        if worst.multiplier is None or worst.multiplier <= 0.0:
            return found, unsure  # by a share that is not rounded it stands
    return replace(found, definition=worst.definition, multiplier=worst.multiplier, tied=worst.tied), unsure


def _shares_by_statics(definition: BlockMechanism, drawing: Drawing) -> Mapping[str, float]:
    """Return the share of each covering that a mechanism carries by statics, as it is built, by name."""
    mechanism, _ = on_rigid_hinges(NAME, definition, drawing.around(definition))
    return {
        load.name: load.mass / drawing.structure.part(load.name).mass
        for load in mechanism.positive.loads
        if isinstance(load, PointMass) and load.name in drawing.bodies
    }


def _share_that_moves(definition: BlockMechanism, drawing: Drawing) -> Mapping[str, float]:
    """Return how much of the length of each body of a mechanism moves at its top [-]: not all of wedges and bays."""
    found = dict.fromkeys(definition.bodies, 1.0)
    if not isinstance(definition, WedgedBlock | HorizontalArch):
        return found  # a wall that is taken in slices is no part
    parts = {body: drawing.structure.part(body) for body in definition.bodies}
    if isinstance(definition, WedgedBlock):
        foot = min(part.base for part in parts.values())
        low = definition.cut if isinstance(definition.cut, float) else foot
        front = max(part.thickness for part in parts.values())  # of what a corner's walls share
        for wedge in definition.wedges:
            for wall in wedge.walls:
                reach = (parts[wall].top - low) * tan(wedge.angle) + front * isinstance(definition, Corner)
                found[wall] = min(reach / parts[wall].length, 1.0)
    if isinstance(definition, HorizontalArch):
        (panel,) = parts.values()
        crossing = [drawing.structure.part(name).solid.vertices @ np.array(panel.along) for name in definition.between]
        one, other = sorted((float(each.min()), float(each.max())) for each in crossing)
        found[panel.name] = min((other[0] - one[1]) / panel.length, 1.0)
    return found


def resolve_thrusts(drawing: Drawing) -> Drawing:
    """Return a drawing that knows which roofs and vaults would push each of its walls over, as it turns alone.

    Whatever takes their thrust is there for all mechanisms of the wall: with wedges, as a corner, of its gable.
    """
    taken: dict[str, frozenset[str]] = {}
    for stack in stacks_of(drawing):
        found: set[str] = set()
        if not any(load.role in THRUSTING for load in drawing.loads_on(stack, above=stack[0].base)):
            continue
        for low in levels_of(stack, drawing):
            parts = standing_above(stack, low, drawing)
            for way in ways_of(stack):
                turned, _ = by_worst_paths(weakest_turn(parts, way, drawing, low=low, high=low), drawing)
                found |= set(turned.tied)
        taken |= {part.name: frozenset(found) for part in stack}
    return replace(drawing, thrusts_taken=taken)


def _tied(load: LoadDefinition) -> LoadDefinition:
    """Return a load without its thrust."""
    return replace(load, tied=True) if isinstance(load, BodyLoad) and load.role in THRUSTING else load


def _with_shares(definition: BlockMechanism, chosen: Mapping[str, float]) -> BlockMechanism:
    """Return a mechanism with the shares of coverings on it; without those of which it carries nothing."""
    loads: list[LoadDefinition] = []
    for load in definition.loads:
        if isinstance(load, BodyLoad) and load.body in chosen:
            share = round(chosen[load.body], 3)
            loads += [replace(load, share=min(share, 1.0))] if share >= NO_SHARE else []
        else:
            loads.append(load)
    return replace(definition, loads=tuple(loads))
