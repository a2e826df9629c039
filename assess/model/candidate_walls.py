"""The mechanisms of walls: overturning, with wedges, corners, bending, bays, gables and what stands free on top.

Nothing is taken to hold that a drawing cannot show: walls that meet are not bonded, ties do not pull, and a roof pushes
by its shape. What stands in the way of a mechanism is named, and the mechanism is listed as not examined.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Literal

import numpy as np

from assess.geometry.contact import find_contact
from assess.loads.load import OverburdenLoad
from assess.mechanisms.mechanism import Vector
from assess.messages.message import Message, Quantity, note
from assess.model.covering_paths import is_drawn_in_part
from assess.model.least_multipliers import (
    Alternative,
    Drawing,
    Found,
    arch_of_bay,
    distinct_levels,
    weakest_bend,
    weakest_corner,
    weakest_turn,
    weakest_wedges,
)
from assess.model.moving_parts import (
    HELD,
    LOW_STOREY,
    RuledOut,
    Seed,
    Seeds,
    Unexamined,
    all_of,
    bends,
    held_levels,
    levels_of,
    stacks_of,
    standing_above,
    walls_behind,
    ways_of,
)
from assess.model.part_kinds import LOW
from assess.model.part_shapes import UNEVEN
from assess.model.structure import CrossWall, Part, PartKind
from assess.model.turning import NEAR_LEVEL
from spectra.gravity import g

LOW_GABLE = 0.5  # m: less above the walls that meet a wall is no gable


def turning_walls(drawing: Drawing, *, storeys: Literal["one", "several"]) -> Seeds:
    """Find the walls that turn outwards above a level: the top storey alone, or with those below it."""
    for stack in stacks_of(drawing):
        levels = levels_of(stack, drawing)
        if not levels and storeys == "one":
            yield RuledOut(stack[0], note("no-storey", height=Quantity(LOW_STOREY, "length")))
        for number, low in enumerate(levels):
            if (storeys == "one") != (number == len(levels) - 1):
                continue
            parts = standing_above(stack, low, drawing)
            top = max(part.top for part in stack)
            free, stopping = _free_ways(parts, ways_of(stack), drawing, above=low + LOW_STOREY / 2.0)
            high = min([*levels[number + 1 : number + 2], low + 0.85 * (top - low)])
            if free:
                find = partial(_weakest_way, parts, free, drawing, low=low, high=high)
                yield Seed(parts, _why_free(stack, parts, low, drawing), find)
            else:
                yield Unexamined(parts[0], note("gap-stopped", z=Quantity(low, "length"), walls=stopping))


def _free_ways(
    parts: Sequence[Part], ways: Sequence[Vector], drawing: Drawing, *, above: float
) -> tuple[tuple[Vector, ...], str]:
    """Return the ways in which nothing stops parts above an elevation [m], and the names of what stops the others."""
    stopping = {way: drawing.stopped_by(parts, way, above=above) for way in ways}
    names = dict.fromkeys(name for each in stopping.values() for name in each)
    return tuple(way for way, each in stopping.items() if not each), ", ".join(names)


def walls_with_wedges(drawing: Drawing) -> Seeds:
    """Find the façades that can take a wedge of the walls behind them along."""
    for stack in stacks_of(drawing):
        behind, low = walls_behind(stack, drawing), stack[0].base
        parts = standing_above(stack, low, drawing)
        if not stack[0].outward:
            free, _ = _free_ways(parts, ways_of(stack), drawing, above=low + LOW_STOREY / 2.0)
            met = any(drawing.structure.cross_walls(part.name) for part in stack)
            shut = RuledOut(stack[0], note("no-wedge-between-rooms" if met else "no-side-wall"))
            yield Unexamined(stack[0], note("gap-inner-wedges")) if met and free else shut
            continue
        if not behind:
            yield RuledOut(stack[0], note("no-side-wall"))
            continue
        if stopping := drawing.stopped_by(parts, stack[0].normal, above=low + LOW_STOREY / 2.0):
            yield Unexamined(stack[0], note("gap-stopped", z=Quantity(low, "length"), walls=", ".join(stopping)))
            continue
        groups = [(wall, *(cap for cap in _caps_on((wall,), drawing) if cap not in parts)) for wall in behind]
        if whole := _compact_on(behind, drawing):
            yield Unexamined(stack[0], note("gap-caps", parts=whole))
        found = weakest_wedges(parts, stack[0].normal, drawing, groups, elevation=low)
        angle = found.parameters.get("angle")
        if angle is not None and angle.value == 0.0:
            yield Unexamined(stack[0], note("gap-no-wedge"), lists=("house",))
            continue
        walls = ", ".join(part.name for part in behind)
        reason = all_of([_why_free(stack, parts, low, drawing), note("reason-wedges", walls=walls)])
        yield Seed((*parts, *behind), reason, lambda found=found: found)  # type: ignore[misc]


RUNNING, COMPACT = ("gable", "parapet"), ("chimney", "pinnacle")


def _caps_on(walls: Sequence[Part], drawing: Drawing, *, kinds: tuple[str, ...] = RUNNING) -> tuple[Part, ...]:
    """Return what stands on walls; gables and parapets run along them, and a crack goes on through these."""
    above = standing_above(walls, min(part.base for part in walls), drawing)
    return tuple(part for part in above if part.kind in kinds)


def _compact_on(walls: Sequence[Part], drawing: Drawing) -> str:
    """Return the names of what stands on walls and falls as a whole or not at all, which no search carries yet."""
    return ", ".join(part.name for part in _caps_on(walls, drawing, kinds=COMPACT))


def corners(drawing: Drawing) -> Seeds:
    """Find the outer corners of two façades; those of the shaft of a tower are not looked for."""
    for tower in drawing.structure.of_kind("tower"):
        yield Unexamined(tower, note("gap-tower-corners"))
    stacks = {part.name: stack for stack in stacks_of(drawing) if stack[0].outward for part in stack}
    seen: set[frozenset[str]] = set()
    cornered: set[str] = set()
    for name, stack in stacks.items():
        wall = drawing.structure.part(name)
        for cross in drawing.structure.cross_walls(name):
            other = stacks.get(cross.part.name)
            way = np.array(wall.along) * (1.0 if cross.end == "end" else -1.0)
            if other is None or cross.end == "between" or float(np.array(cross.part.normal) @ way) < 0.7:
                continue
            pair = frozenset((stack[0].name, other[0].name))
            if pair in seen:
                continue
            seen.add(pair)
            cornered |= pair
            ways = (stack[0].normal, other[0].normal)
            foot = max(stack[0].base, other[0].base) + LOW_STOREY / 2.0
            if stopping := [
                tower for way in ways for tower in _towers_ahead((*stack, *other), way, drawing, above=foot)
            ]:
                yield Unexamined(stack[0], note("gap-stopped", z=Quantity(foot, "length"), walls=", ".join(stopping)))
                continue
            parts = tuple(part for part in (*stack, *other) if part.kind in ("wall", "pier"))
            sides = tuple(tuple(part for part in each if part.kind in ("wall", "pier")) for each in (stack, other))
            if whole := _compact_on(parts, drawing):
                yield Unexamined(stack[0], note("gap-caps", parts=whole))
            reason = note("reason-corner", one=stack[0].name, other=other[0].name)
            on = (_caps_on(sides[0], drawing), _caps_on(sides[1], drawing))
            yield Seed(parts, reason, partial(weakest_corner, (sides[0], sides[1]), drawing, on), beside=other[0])
    for stack in stacks_of(drawing):
        if stack[0].name not in cornered:
            yield RuledOut(stack[0], note("no-outer-corner"))


def spanning_walls(drawing: Drawing) -> Seeds:
    """Find the walls that two levels hold, where something presses on them from above."""
    for wall in drawing.structure.of_kind("wall", "pier"):
        held = distinct_levels([wall.base, *held_levels(wall, drawing)])
        spans = [(low, high) for low, high in pairwise(held) if high - low >= LOW_STOREY]
        if not spans:
            lone = note("no-span", height=Quantity(LOW_STOREY, "length")) if held[1:] else note("no-upper-hold")
            yield RuledOut(wall, lone)
        for low, high in spans:
            ways, stopping = _ways_clear_of_towers(wall, drawing, above=low)
            if not ways:
                yield Unexamined(wall, note("gap-stopped", z=Quantity(low, "length"), walls=stopping))
                continue
            levels = {"low": Quantity(low, "length"), "high": Quantity(high, "length")}
            load = _pressing(wall, high, drawing)
            if load is None:
                yield Unexamined(wall, note("gap-unpressed", **levels))
                continue
            find = partial(_weakest_bending, wall, ways, drawing, low=low, high=high, load=load)
            reason = note("reason-spans", **levels)
            yield Seed((wall,), reason, find)


def bays(drawing: Drawing) -> Seeds:
    """Find the bays of walls between two cross walls with masonry beyond both: without it an arch has no thrust."""
    for wall in drawing.structure.of_kind("wall"):
        spans = [(one, other, _span(one, other)) for one, other in pairwise(drawing.structure.cross_walls(wall.name))]
        spans = [each for each in spans if each[2] >= LOW_STOREY]
        ways, stopping = _ways_clear_of_towers(wall, drawing, above=wall.base)
        if not spans:
            yield RuledOut(wall, note("no-bay", span=Quantity(LOW_STOREY, "length")))
        elif not ways:
            yield Unexamined(wall, note("gap-stopped", z=Quantity(wall.base, "length"), walls=stopping))
            continue
        for one, other, span in spans:
            if one.end != "between" or one.end != other.end:
                yield Unexamined(wall, note("gap-bay-ends"))
                continue
            reason = note("reason-bay", span=Quantity(span, "length", 3), one=one.part.name, other=other.part.name)
            yield Seed((wall,), reason, partial(arch_of_bay, wall, (one.part, other.part), drawing, ways[0]))


def _span(one: CrossWall, other: CrossWall) -> float:
    """Return what is free of a wall between two that meet it [m]."""
    return other.at - one.at - (one.part.thickness + other.part.thickness) / 2.0


def _towers_ahead(parts: Sequence[Part], way: Vector, drawing: Drawing, *, above: float) -> tuple[str, ...]:
    """Return the towers that parts would move into above an elevation [m]."""
    stopping = drawing.stopped_by(parts, way, above=above)
    return tuple(name for name in stopping if drawing.structure.part(name).kind == "tower")


def _ways_clear_of_towers(wall: Part, drawing: Drawing, *, above: float) -> tuple[tuple[Vector, ...], str]:
    """Return the ways in which no tower stands against a wall above an elevation [m], and the names of those that do.

    Cross walls stop a wall as a whole, and what lies between them may move all the same.
    """
    stopping = {way: _towers_ahead((wall,), way, drawing, above=above) for way in ways_of((wall,))}
    names = dict.fromkeys(name for each in stopping.values() for name in each)
    return tuple(way for way, each in stopping.items() if not each), ", ".join(names)


def caps(drawing: Drawing, *, kinds: tuple[PartKind, ...]) -> Seeds:
    """Find what stands free on top of other parts: gables, parapets, chimneys, pinnacles."""
    for part in drawing.structure.of_kind(*kinds):
        parts = standing_above((part,), part.base, drawing)
        free, stopping = _free_ways(parts, ways_of((part,)), drawing, above=part.base + 0.1 * part.height)
        if free:
            high = part.base + 0.5 * part.height
            find = partial(_weakest_way, parts, free, drawing, low=part.base, high=high)
            yield Seed(parts, note("reason-cap", z=Quantity(part.base, "length")), find)
        else:
            yield Unexamined(part, note("gap-stopped", z=Quantity(part.base, "length"), walls=stopping))


def gables(drawing: Drawing) -> Seeds:
    """Find the gables: parts of their own, and what walls with a pitched top have above all that meet them."""
    yield from caps(drawing, kinds=("gable",))
    yield from upper_parts(drawing, shape="pitched")


def parapets(drawing: Drawing) -> Seeds:
    """Find the parapets: parts of their own, and what walls with a level top have above all that meet them, if low."""
    yield from caps(drawing, kinds=("parapet",))
    yield from upper_parts(drawing, shape="low")


def upper_parts(drawing: Drawing, *, shape: Literal["pitched", "low", "high"]) -> Seeds:
    """Find what walls have above all that meet them, with what stands on it: pitched, or level and low or high."""
    for wall in drawing.structure.of_kind("wall"):
        if bends(wall):
            continue
        meeting = [cross.part.top for cross in drawing.structure.cross_walls(wall.name)]
        eaves = max(meeting, default=wall.top) if wall.eaves is None else wall.eaves
        rise = wall.top - eaves
        own = "pitched" if not _has_level_top(wall) else "low" if rise <= LOW else "high"
        if own == shape and LOW_GABLE <= rise < wall.height:
            parts = standing_above((wall,), eaves, drawing)
            find = partial(_weakest_way, parts, ways_of((wall,)), drawing, low=eaves, high=eaves + 0.5 * rise)
            yield Seed(parts, note("reason-cap", z=Quantity(eaves, "length")), find)


def _has_level_top(wall: Part) -> bool:
    """Return whether the top of a wall is level over half of its length, so that what it has on top is no gable."""
    vertices = wall.solid.vertices
    along = vertices[vertices[:, 2] >= wall.top - UNEVEN] @ np.array(wall.along)
    return wall.eaves is None and float(np.ptp(along)) >= wall.length / 2.0


def _pressing(wall: Part, level: float, drawing: Drawing) -> OverburdenLoad | None:
    """Return what presses on a wall at a level: bodies on its top, or the weight above; None for nothing.

    A covering of which no more than one side is drawn is not counted: how much of it presses here is not known.
    """
    structure = drawing.structure
    contacts = [each for each in structure.contacts_of(wall.name) if each.second == wall.name]
    if level >= wall.top - NEAR_LEVEL:
        on_top = [each for each in contacts if each.relation in ("stands-on", "bears-on")]
        names = dict.fromkeys(
            each.first
            for each in on_top
            if each.elevation >= wall.top - HELD
            and find_contact(wall.solid, structure.part(each.first).solid)
            and not is_drawn_in_part(structure.part(each.first), structure)
        )
        return OverburdenLoad(bodies=tuple(names)) if names else None
    above = [part for part in standing_above((wall,), wall.base, drawing) if part is not wall]
    masonry = sum(part.mass for part in above) + wall.mass * (wall.top - level) / wall.height
    return OverburdenLoad(force=g * masonry) if masonry > 0.0 else None


def _weakest_way(
    parts: tuple[Part, ...], ways: tuple[Vector, ...], drawing: Drawing, *, low: float, high: float
) -> Found:
    return _weakest([weakest_turn(parts, way, drawing, low=low, high=high) for way in ways])


def _weakest_bending(
    wall: Part, ways: tuple[Vector, ...], drawing: Drawing, *, low: float, high: float, load: OverburdenLoad
) -> Found:
    return _weakest([weakest_bend(wall, way, drawing, low=low, high=high, load=load) for way in ways])


def _weakest(found: Sequence[Found]) -> Found:
    """Return the weakest of several directions, with the others as runners-up."""
    known = [each for each in found if each.multiplier is not None]
    if not known:
        return found[0]
    best = min(known, key=lambda each: each.multiplier or 0.0)
    beside = [
        Alternative(each.multiplier or 0.0, each.direction, each.parameters) for each in known if each is not best
    ]
    others = sorted((*best.others, *beside), key=lambda each: each.multiplier)
    return replace(best, others=tuple(others), evaluations=sum(each.evaluations for each in found))


def _why_free(stack: Sequence[Part], parts: Sequence[Part], low: float, drawing: Drawing) -> Message:
    """Say why walls can turn outwards: how long they are, what meets them, what bears on them, what may hold them."""
    structure, lead = drawing.structure, stack[0]
    key = "reason-facade" if any(part.outward for part in stack) else "reason-inner-wall"
    said = [note(key, length=Quantity(lead.length, "length", 3), z=Quantity(low, "length"))]
    meeting = dict.fromkeys(cross.part.name for part in parts for cross in structure.cross_walls(part.name))
    said.append(note("reason-meets", walls=", ".join(meeting)) if meeting else note("reason-no-return"))
    names = {part.name for part in parts}
    bearing = {
        contact.first: contact.elevation
        for part in parts
        for contact in structure.contacts_of(part.name)
        if contact.relation == "bears-on" and contact.second in names and contact.elevation > low
    }
    said += [note("reason-bears", body=body, z=Quantity(z, "length", 3)) for body, z in bearing.items()]
    ties = dict.fromkeys(tie.name for part in parts for tie in structure.ties_of(part.name))
    said += [note("reason-ties", ties=", ".join(ties))] if ties else []
    return all_of(said)
