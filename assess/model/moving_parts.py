"""What of a building moves together: walls over one another, the ways they may fall, and the levels that part them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Literal, get_args

import numpy as np
import shapely

from assess.geometry.planar import hull_edge_normals
from assess.geometry.surface import areas_and_normals
from assess.mechanisms.directions import direction_at
from assess.mechanisms.mechanism import Vector
from assess.messages.message import Message, note
from assess.model.least_multipliers import Drawing, Found, distinct_levels
from assess.model.structure import Part
from assess.model.turning import NEAR_LEVEL

BuildingType = Literal["house", "church"]
LOW_STOREY = 1.0  # m: less between two levels is no storey
BEHIND = 0.1  # of what moves: a part that meets it no higher than this above its hinge stops nothing
HELD = 0.4  # m: a floor this near the top of a wall holds it there
MOSTLY = 0.49  # of its foot, by area: what stands so far on parts that move goes with them


@dataclass(frozen=True)
class Seed:
    """Parts that can move in one way: why, what finds their least multiplier, and a second part that names it."""

    parts: tuple[Part, ...]
    reason: Message
    find: Callable[[], Found]
    beside: Part | None = None


@dataclass(frozen=True)
class Unexamined:
    """A part that a class of mechanisms can concern, why it is not looked for, and whose lists it keeps open."""

    part: Part
    why: Message
    lists: tuple[BuildingType, ...] = get_args(BuildingType)


@dataclass(frozen=True)
class RuledOut:
    """A part in which a class of mechanisms cannot form, and what of the drawing says so."""

    part: Part
    why: Message


Seeds = Iterator[Seed | Unexamined | RuledOut]


def stacks_of(drawing: Drawing) -> tuple[tuple[Part, ...], ...]:
    """Return the walls that stand on one another in one plane, each stack once, from the ground up."""
    found: dict[frozenset[str], tuple[Part, ...]] = {}
    for wall in drawing.structure.of_kind("wall", "pier"):
        stack = drawing.structure.stack_of(wall.name)
        found.setdefault(frozenset(part.name for part in stack), stack)
    return tuple(found.values())


def ways_of(parts: Sequence[Part]) -> tuple[Vector, ...]:
    """Return the directions in which parts may fall: outwards, or both ways; all four of what is no plate."""
    lead = next((part for part in parts if part.outward), parts[0])
    ways = [lead.normal] if lead.outward else [lead.normal, opposite(lead.normal)]
    return (*ways,) if lead.is_plate else (*ways, lead.along, opposite(lead.along))


SIDEWAYS = -0.7  # cosine: a part that faces outwards may fall up to 135 degrees from there


def ways_to_fall(part: Part, drawing: Drawing) -> tuple[Vector, ...]:
    """Return the directions that the faces of a part have in plan, and the opposites, in which nothing stops it.

    Of a part that faces outwards those that turn back are left out: the building stands there.
    """
    facing = hull_edge_normals(part.solid.vertices)
    angles = np.unique(np.round(np.concatenate([facing, facing + 180.0]), 6) % 360.0)
    ways = [direction_at(float(angle)) for angle in angles]
    if part.outward:
        ways = [way for way in ways if float(np.dot(way, part.normal)) > SIDEWAYS]
    above = part.base + BEHIND * part.height
    return tuple(way for way in ways if not drawing.stopped_by((part,), way, above=above)) or ways_of((part,))


def opposite(way: Vector) -> Vector:
    return (-way[0] + 0.0, -way[1] + 0.0, 0.0)


OBLIQUE = (0.34, 0.94)  # cosine with a wall's normal: faces between 20 and 70 degrees from it are of a bend
BENT = 0.2  # of its upright faces: a wall with more oblique ones bends in plan, one with buttresses does not


def bends(part: Part) -> bool:
    """Return whether a wall bends in plan, as an apse: its faces turn from its normal."""
    area, normal = areas_and_normals(part.solid.vertices[part.solid.triangles])
    upright = np.abs(normal[:, 2]) < OBLIQUE[0]
    cosine = np.abs(normal @ np.array(part.normal))
    oblique = upright & (cosine > OBLIQUE[0]) & (cosine < OBLIQUE[1])
    return part.kind == "wall" and float(area[oblique].sum()) > BENT * float(area[upright].sum())


def stands_on_tower(stack: Sequence[Part], drawing: Drawing) -> bool:
    """Return whether all of some walls rise over a tower."""
    for tower in drawing.structure.of_kind("tower"):
        plan = shapely.MultiPoint(tower.solid.vertices[:, :2]).convex_hull
        over = [shapely.Point(part.solid.centroid[:2]).within(plan) for part in stack]
        if all(over) and min(part.base for part in stack) >= tower.top - NEAR_LEVEL:
            return True
    return False


def levels_of(stack: Sequence[Part], drawing: Drawing) -> tuple[float, ...]:
    """Return the levels above which walls can turn: their feet, and the floors that bear on them below the top."""
    top = max(part.top for part in stack)
    feet = [part.base for part in stack if part.kind in ("wall", "pier")]
    floors = [each for part in stack for each in drawing.bearing_elevations(part)]
    found: list[float] = []
    for level in distinct_levels([*feet, *floors]):
        if level <= top - LOW_STOREY + NEAR_LEVEL and (not found or level >= found[-1] + LOW_STOREY - NEAR_LEVEL):
            found.append(level)
    return tuple(found)


def standing_above(stack: Sequence[Part], level: float, drawing: Drawing) -> tuple[Part, ...]:
    """Return the parts of a stack above a level, and what stands on them with at least half of its foot.

    A gable that only ends on the corner of a façade stays where it is: taken along, it would widen the base.
    """
    moved = {part.name: part for part in stack if part.top > level + NEAR_LEVEL}
    new = list(moved.values())
    while new:
        on_top = [each for part in new for each in drawing.structure.standing_on(part.name)]
        new = [each for each in {part.name: part for part in on_top}.values() if each.name not in moved]
        new = [each for each in new if each.kind in ("gable", "parapet", "chimney", "pinnacle") or each in stack]
        new = [each for each in new if each in stack or _share_on(each, moved, drawing) >= MOSTLY]
        moved |= {part.name: part for part in new}
    return tuple(sorted(moved.values(), key=lambda part: (part.base, part.name)))


def _share_on(part: Part, carriers: Collection[str], drawing: Drawing) -> float:
    """Return how much of what a part stands on belongs to some others, by area [-]."""
    feet = [each for each in drawing.structure.contacts_of(part.name) if each.first == part.name]
    areas = {each.second: each.area for each in feet if each.relation == "stands-on"}
    return sum(area for name, area in areas.items() if name in carriers) / sum(areas.values())


def walls_behind(stack: Sequence[Part], drawing: Drawing) -> tuple[Part, ...]:
    """Return the cross walls that meet walls from behind, or stand beside their ends."""
    inwards = np.array(opposite(stack[0].normal))
    face = min(float((part.solid.vertices @ inwards).min()) for part in stack)
    found = {}
    for part in stack:
        for cross in drawing.structure.cross_walls(part.name):
            if float((cross.part.solid.vertices @ inwards).max()) > face + 2.0 * part.thickness:
                found[cross.part.name] = cross.part
    return tuple(found.values())


def held_levels(wall: Part, drawing: Drawing) -> tuple[float, ...]:
    """Return the elevations at which floors or roofs hold a wall; near its top also those on what it carries."""
    above = [each for part in drawing.structure.standing_on(wall.name) for each in drawing.bearing_elevations(part)]
    near_top = [wall.top for each in above if each <= wall.top + HELD]
    own = [wall.top if each >= wall.top - HELD else each for each in drawing.bearing_elevations(wall)]
    return distinct_levels([*own, *near_top])


def all_of(said: Sequence[Message]) -> Message:
    return reduce(lambda one, other: note("reason-and", one=one, other=other), said)
