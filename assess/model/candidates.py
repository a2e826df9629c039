"""The mechanisms that a building can have: what moves, what it carries, what stops it, and their least multipliers.

Which classes of mechanism a building is searched for is the table `CLASSES`. Nothing is taken to hold that a drawing
cannot show: walls that meet are not bonded, ties do not pull, and a roof pushes by its shape.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from itertools import pairwise
from typing import TYPE_CHECKING, Literal

import numpy as np
import shapely

from assess.geometry.contact import find_contact
from assess.loads.load import OverburdenLoad
from assess.mechanisms.mechanism import BlockMechanism, Vector
from assess.mechanisms.partial_walls import horizontal_arch, thrust_held_beyond
from assess.messages.message import Message, Quantity, Term, note
from assess.model.bodies import LEAST_STRENGTH
from assess.model.least_multipliers import (
    NEAR_LEVEL,
    Alternative,
    Drawing,
    Found,
    Parameters,
    distinct_levels,
    weakest_arch,
    weakest_bend,
    weakest_corner,
    weakest_crack,
    weakest_portal,
    weakest_turn,
    weakest_wedges,
)
from assess.model.structure import IN_LINE, Part, PartKind, Structure
from assess.short_repr import ShortRepr
from spectra.gravity import g

if TYPE_CHECKING:
    from pandas import DataFrame

BuildingType = Literal["house", "church"]
TIE = 1.1  # multipliers up to this many times the least are as weak, as far as statics tell
LOW_STOREY = 1.0  # m: less between two levels is no storey
LOW_GABLE = 0.5  # m: less above the walls that meet a wall is no gable
HELD = 0.4  # m: a floor this near the top of a wall holds it there
MOSTLY = 0.49  # of its foot, by area: what stands so far on parts that move goes with them
UPRIGHT: tuple[PartKind, ...] = ("wall", "pier", "spandrel", "gable", "parapet", "tower", "chimney", "pinnacle", "arch")
"""Kinds of parts each of which must have a mechanism, or is named."""


@dataclass(frozen=True, kw_only=True, repr=False)
class Candidate(ShortRepr):
    """A mechanism that a building can have.

    Attributes
    ----------
    name : unique, such as a project file names its tables
    kind : of the table `CLASSES`
    title : what it is
    parts : that move, from the ground up
    reason : why it can form: what is free, what meets it, what bears on it
    carries : floors, roofs and vaults that bear on it
    held_by : ties that may hold it, which are left out
    found : the least multiplier, with its direction and parameters
    examines : the entry of the list of mechanisms of each type of building that it answers
    """

    name: str
    kind: str
    title: Message
    parts: tuple[str, ...]
    reason: Message
    carries: tuple[str, ...]
    held_by: tuple[str, ...]
    found: Found
    examines: Mapping[BuildingType, str]

    @property
    def multiplier(self) -> float | None:
        """The least static multiplier [-]; None where there is none."""
        return self.found.multiplier

    @property
    def definition(self) -> BlockMechanism | None:
        """The mechanism as a project file states it; None where it states none of its kind."""
        return self.found.definition

    @property
    def ties(self) -> tuple[Alternative, ...]:
        """The runners-up within 10 % of the least."""
        least = self.multiplier
        return () if least is None else tuple(each for each in self.found.others if each.multiplier <= TIE * abs(least))


@dataclass(frozen=True, repr=False)
class Candidates(ShortRepr):
    """The mechanisms of a building, the weakest first, and the parts that have none.

    Attributes
    ----------
    ranked : by multiplier; those without one last
    without : name of each upright part that no mechanism with a multiplier moves, and why
    """

    ranked: tuple[Candidate, ...]
    without: Mapping[str, Message]

    def __iter__(self) -> Iterator[Candidate]:
        return iter(self.ranked)

    def __len__(self) -> int:
        return len(self.ranked)

    @property
    def weakest(self) -> tuple[Candidate, ...]:
        """The candidates within 10 % of the least multiplier."""
        known = [each for each in self.ranked if each.multiplier is not None]
        return tuple(each for each in known if (each.multiplier or 0.0) <= TIE * abs(known[0].multiplier or 0.0))

    def by_entry(self, building_type: BuildingType) -> dict[str, tuple[str, ...]]:
        """Return the candidates that answer each entry of the list of a type of building, by name."""
        found: dict[str, tuple[str, ...]] = {}
        for each in self.ranked:
            if building_type in each.examines:
                entry = each.examines[building_type]
                found[entry] = (*found.get(entry, ()), each.name)
        return found

    def table(self) -> DataFrame:
        """Return a row for each mechanism, the weakest first."""
        import pandas as pd  # late: it takes a third of a second

        rows = [
            {
                "name": each.name,
                "class": each.kind,
                "parts": ", ".join(each.parts),
                "multiplier": each.multiplier,
                "direction_x": each.found.direction[0],
                "direction_y": each.found.direction[1],
                "parameters": ", ".join(f"{name} {value}" for name, value in each.found.parameters.items()),
                "carries": ", ".join(each.carries),
                "held_by": ", ".join(each.held_by),
                "examines_house": each.examines.get("house", ""),
                "examines_church": each.examines.get("church", ""),
                "in_project_file": each.definition is not None,
                "reason": str(each.reason),
                "why_not": each.found.why_not,
            }
            for each in self.ranked
        ]
        return pd.DataFrame(rows)


@dataclass(frozen=True)
class MechanismClass:
    """A row of the table of classes.

    key : of the class; title : what it is called
    examines : entry of the list of each type of building (reference lists of the Italian survey forms)
    seeds : finds what can move, in a drawing
    """

    key: str
    title: Term
    examines: Mapping[BuildingType, str]
    seeds: Callable[[Drawing], Iterator[Seed]]


@dataclass(frozen=True)
class Seed:
    """Parts that can move in one way: why, what finds their least multiplier, and what of a church they are."""

    parts: tuple[Part, ...]
    reason: Message
    find: Callable[[], Found]
    of_church: str = ""


def find_candidates(structure: Structure) -> Candidates:
    """Return the mechanisms that a building can have, of every class, with the least multiplier of each."""
    drawing = Drawing(structure)
    found: list[Candidate] = []
    for row in CLASSES:
        for seed in row.seeds(drawing):
            found.append(_candidate(row, seed, drawing, taken={each.name for each in found}))
    ranked = sorted(found, key=lambda each: (each.multiplier is None, each.multiplier or 0.0))
    return Candidates(tuple(ranked), _without(structure, ranked))


def _candidate(row: MechanismClass, seed: Seed, drawing: Drawing, *, taken: set[str]) -> Candidate:
    structure, found = drawing.structure, seed.find()
    stem = f"{_slug(seed.parts[0].name)}-{row.key}"
    name = next(each for each in (stem, *(f"{stem}-{i}" for i in range(2, 1000))) if each not in taken)
    bodies = ", ".join(found.tied)
    reason = _all_of([seed.reason, note("reason-tied", bodies=bodies)]) if bodies else seed.reason
    low = found.parameters.get("hinge", Quantity(seed.parts[0].base)).value
    return Candidate(
        name=name,
        kind=row.key,
        title=note("candidate-title", part=seed.parts[0].name, what=row.title),
        parts=tuple(part.name for part in seed.parts),
        reason=reason,
        carries=tuple(load.body for load in drawing.loads_on(seed.parts, above=low)),
        held_by=tuple(dict.fromkeys(tie.name for part in seed.parts for tie in structure.ties_of(part.name))),
        found=found,
        examines={**row.examines, "church": seed.of_church} if seed.of_church else row.examines,
    )


def _without(structure: Structure, found: Sequence[Candidate]) -> dict[str, Message]:
    """Return the upright parts that nothing with a multiplier moves, each with the reason."""
    moved = {name for each in found if each.multiplier is not None for name in each.parts}
    missing: dict[str, Message] = {}
    for part in structure.of_kind(*UPRIGHT):
        if part.name in moved:
            continue
        tried = [each.found.why_not for each in found if part.name in each.parts and each.found.why_not]
        missing[part.name] = (
            note("no-mechanism-built", part=part.name, why=tried[0]) if tried else note("no-mechanism", part=part.name)
        )
    return missing


def _slug(name: str) -> str:
    kept = "".join(letter.lower() if letter.isascii() and letter.isalnum() else "-" for letter in name)
    return "-".join(filter(None, kept.split("-"))) or "part"


def _overturning(drawing: Drawing, *, storeys: Literal["one", "several"]) -> Iterator[Seed]:
    """Find the walls that turn outwards above a level: the top storey alone, or with those below it."""
    for stack in _stacks(drawing):
        levels = _levels(stack, drawing)
        for number, low in enumerate(levels):
            if (storeys == "one") != (number == len(levels) - 1):
                continue
            parts = _standing_above(stack, low, drawing)
            top = max(part.top for part in stack)
            ways = [way for way in _ways(stack) if not drawing.stopped_by(parts, way, above=low + LOW_STOREY / 2.0)]
            high = min([*levels[number + 1 : number + 2], low + 0.85 * (top - low)])
            if ways:
                find = partial(_weakest_way, parts, tuple(ways), drawing, low=low, high=high)
                yield Seed(parts, _why_free(stack, parts, low, drawing), find, _part_of_church(stack, low, drawing))


def _with_wedges(drawing: Drawing) -> Iterator[Seed]:
    """Find the façades that can take a wedge of the walls behind them along."""
    for stack in _stacks(drawing):
        behind = _walls_behind(stack, drawing)
        if not stack[0].outward or not behind:
            continue
        low = stack[0].base
        parts = _standing_above(stack, low, drawing)
        if drawing.stopped_by(parts, stack[0].normal, above=low + LOW_STOREY / 2.0):
            continue
        walls = ", ".join(part.name for part in behind)
        reason = _all_of([_why_free(stack, parts, low, drawing), note("reason-wedges", walls=walls)])
        yield Seed(
            (*parts, *behind),
            reason,
            partial(weakest_wedges, parts, stack[0].normal, drawing, behind, elevation=low),
            _part_of_church(stack, low, drawing),
        )


def _corners(drawing: Drawing) -> Iterator[Seed]:
    """Find the outer corners of two façades."""
    stacks = {part.name: stack for stack in _stacks(drawing) if stack[0].outward for part in stack}
    seen: set[frozenset[str]] = set()
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
            parts = tuple(part for part in (*stack, *other) if part.kind in ("wall", "pier"))
            sides = tuple(tuple(part for part in each if part.kind in ("wall", "pier")) for each in (stack, other))
            reason = note("reason-corner", one=stack[0].name, other=other[0].name)
            cell = _stands_on_tower(stack, drawing) and _stands_on_tower(other, drawing)
            yield Seed(
                parts, reason, partial(weakest_corner, (sides[0], sides[1]), drawing), "bell-cell" if cell else ""
            )


def _bending(drawing: Drawing) -> Iterator[Seed]:
    """Find the walls that two levels hold, where something presses on them from above."""
    for wall in drawing.structure.of_kind("wall", "pier"):
        held = _held_levels(wall, drawing)
        for low, high in pairwise(distinct_levels([wall.base, *held])):
            if high - low < LOW_STOREY:
                continue
            load = _pressing(wall, high, drawing)
            if load is None:
                continue
            ways = tuple(_ways((wall,)))
            find = partial(_weakest_bending, wall, ways, drawing, low=low, high=high, load=load)
            reason = note("reason-spans", low=Quantity(low, "length"), high=Quantity(high, "length"))
            yield Seed((wall,), reason, find)


def _bays(drawing: Drawing) -> Iterator[Seed]:
    """Find the bays of walls between two cross walls with masonry beyond both: without it an arch has no thrust."""
    for wall in drawing.structure.of_kind("wall"):
        inner = [each for each in drawing.structure.cross_walls(wall.name) if each.end == "between"]
        for one, other in pairwise(inner):
            span = other.at - one.at - (one.part.thickness + other.part.thickness) / 2.0
            if span < LOW_STOREY:
                continue
            beyond = (one.at - one.part.thickness / 2.0, wall.length - other.at - other.part.thickness / 2.0)
            reason = note("reason-bay", span=Quantity(span, "length", 3), one=one.part.name, other=other.part.name)
            yield Seed((wall,), reason, partial(_arch_of_bay, wall, span, beyond, drawing))


def _caps(drawing: Drawing, *, kinds: tuple[PartKind, ...]) -> Iterator[Seed]:
    """Find what stands free on top of other parts: gables, parapets, chimneys, pinnacles."""
    for part in drawing.structure.of_kind(*kinds):
        parts = _standing_above((part,), part.base, drawing)
        ways = [
            way for way in _ways((part,)) if not drawing.stopped_by(parts, way, above=part.base + 0.1 * part.height)
        ]
        if ways:
            high = part.base + 0.5 * part.height
            find = partial(_weakest_way, parts, tuple(ways), drawing, low=part.base, high=high)
            yield Seed(parts, note("reason-cap", z=Quantity(part.base, "length")), find)


def _gables(drawing: Drawing) -> Iterator[Seed]:
    """Find the gables: parts of their own, and what walls have above all that meet them."""
    yield from _caps(drawing, kinds=("gable",))
    for wall in drawing.structure.of_kind("wall"):
        if _bends(wall):
            continue
        meeting = [cross.part.top for cross in drawing.structure.cross_walls(wall.name)]
        eaves = max(meeting, default=wall.top) if wall.eaves is None else wall.eaves
        ways = tuple(_ways((wall,)))
        if LOW_GABLE <= wall.top - eaves < wall.height:
            high = eaves + 0.5 * (wall.top - eaves)
            find = partial(_weakest_way, (wall,), ways, drawing, low=eaves, high=high)
            yield Seed((wall,), note("reason-cap", z=Quantity(eaves, "length")), find)


def _shafts(drawing: Drawing, *, kinds: tuple[PartKind, ...]) -> Iterator[Seed]:
    """Find the towers and spires that can fall above an inclined crack."""
    for part in drawing.structure.of_kind(*kinds):
        ways = tuple(_ways((part,)))
        low, high = part.base, part.base + 0.6 * part.height
        find = partial(weakest_crack, part, ways, drawing, low=low, high=high)
        yield Seed((part,), note("reason-shaft", height=Quantity(part.height, "length", 3)), find)


def _arches(drawing: Drawing) -> Iterator[Seed]:
    """Find the arches on two feet."""
    for part in drawing.structure.of_kind("arch"):
        reason = note("reason-arch", span=Quantity(part.length, "length", 3))
        yield Seed((part,), reason, partial(weakest_arch, part, drawing))


def _portals(drawing: Drawing, *, on_tower: bool) -> Iterator[Seed]:
    """Find two piers that carry the same spandrel or arch: a portal, or a belfry where the piers stand on a tower."""
    structure = drawing.structure
    for over in structure.of_kind("spandrel", "arch"):
        piers = [part for part in structure.below(over.name) if part.kind in ("pier", "tower")]
        below = {part.kind for pier in piers for part in structure.below(pier.name)}
        if len(piers) != 2 or ("tower" in below) != on_tower:
            continue
        top = _standing_above((over,), over.base, drawing)
        reason = note("reason-portal", over=over.name, one=piers[0].name, other=piers[1].name)
        yield Seed((*piers, *top), reason, partial(weakest_portal, (piers[0], piers[1]), top, drawing))


def _bell_cells(drawing: Drawing) -> Iterator[Seed]:
    """Find the bell cells: a portal on a tower, or two of its walls that carry all walls above them, drawn bonded."""
    yield from _portals(drawing, on_tower=True)
    structure = drawing.structure
    for tower in structure.of_kind("tower"):
        piers = [part for part in structure.standing_on(tower.name) if part.kind in ("pier", "wall")]
        if len(piers) != 2 or abs(float(np.dot(piers[0].normal, piers[1].normal))) < IN_LINE:
            continue
        over = {part.name: part for part in structure.standing_on(piers[0].name)}
        new = list(over.values())
        while new:
            bonded = [(each, part) for part in new for each in structure.contacts_of(part.name)]
            near = {each.other(part.name) for each, part in bonded if each.relation == "bonded-to"}
            new = [structure.part(name) for name in sorted(near - {*over, *(pier.name for pier in piers)})]
            over |= {part.name: part for part in new}
        first, other = ({part.name for part in structure.standing_on(pier.name)} for pier in piers)
        if over and first <= set(over) and other and other <= set(over):
            top = tuple(over.values())
            names = ", ".join(over)
            reason = note("reason-portal", over=names, one=piers[0].name, other=piers[1].name)
            yield Seed((*piers, *top), reason, partial(weakest_portal, (piers[0], piers[1]), top, drawing))


def _apses(drawing: Drawing) -> Iterator[Seed]:
    """Find the walls that bend in plan, which break outwards above an inclined crack."""
    for wall in drawing.structure.of_kind("wall"):
        if _bends(wall):
            low, high = wall.base, wall.base + 0.6 * wall.height
            find = partial(weakest_crack, wall, (wall.normal,), drawing, low=low, high=high)
            yield Seed((wall,), note("reason-apse", length=Quantity(wall.length, "length", 3)), find)


CLASSES: tuple[MechanismClass, ...] = (
    MechanismClass(
        "overturning",
        Term("overturning of one storey"),
        {"house": "simple-overturning"},
        partial(_overturning, storeys="one"),
    ),
    MechanismClass(
        "overturning-of-storeys",
        Term("overturning of several storeys"),
        {"house": "simple-overturning"},
        partial(_overturning, storeys="several"),
    ),
    MechanismClass(
        "wedges", Term("overturning with wedges of the side walls"), {"house": "compound-overturning"}, _with_wedges
    ),
    MechanismClass("corner", Term("overturning of a corner"), {"house": "corner"}, _corners),
    MechanismClass(
        "gable",
        Term("overturning of a gable"),
        {"house": "gable", "church": "facade-top"},
        _gables,
    ),
    MechanismClass("bending", Term("vertical bending between floors"), {"house": "vertical-bending"}, _bending),
    MechanismClass("bay", Term("horizontal arch between cross walls"), {"house": "horizontal-bending"}, _bays),
    MechanismClass(
        "parapet",
        Term("overturning of a parapet"),
        {"house": "parapet", "church": "projections"},
        partial(_caps, kinds=("parapet",)),
    ),
    MechanismClass(
        "chimney",
        Term("overturning of a chimney"),
        {"house": "chimney", "church": "projections"},
        partial(_caps, kinds=("chimney",)),
    ),
    MechanismClass(
        "pinnacle", Term("overturning of a pinnacle"), {"church": "projections"}, partial(_caps, kinds=("pinnacle",))
    ),
    MechanismClass("arch", Term("arch on four hinges"), {"church": "triumphal-arch"}, _arches),
    MechanismClass("portal", Term("sway of a portal"), {"church": "porch"}, partial(_portals, on_tower=False)),
    MechanismClass("belfry", Term("sway of a belfry"), {"church": "bell-cell"}, _bell_cells),
    MechanismClass("apse", Term("fall of an apse above an inclined crack"), {"church": "apse"}, _apses),
    MechanismClass(
        "tower", Term("fall above an inclined crack"), {"church": "bell-tower"}, partial(_shafts, kinds=("tower",))
    ),
    MechanismClass(
        "spire",
        Term("fall of a spire above an inclined crack"),
        {"church": "projections"},
        partial(_shafts, kinds=("pinnacle",)),
    ),
)
"""The classes of mechanism that a building is searched for, in the order of the lists of the survey forms."""


def _stacks(drawing: Drawing) -> tuple[tuple[Part, ...], ...]:
    """Return the walls that stand on one another in one plane, each stack once, from the ground up."""
    found: dict[frozenset[str], tuple[Part, ...]] = {}
    for wall in drawing.structure.of_kind("wall", "pier"):
        stack = drawing.structure.stack_of(wall.name)
        found.setdefault(frozenset(part.name for part in stack), stack)
    return tuple(found.values())


def _ways(parts: Sequence[Part]) -> Iterator[Vector]:
    """Return the directions in which parts may fall: outwards, or both ways; all four of what is no plate."""
    lead = next((part for part in parts if part.outward), parts[0])
    yield lead.normal
    if not lead.outward:
        yield _opposite(lead.normal)
    if not lead.is_plate:
        yield lead.along
        yield _opposite(lead.along)


def _part_of_church(stack: Sequence[Part], low: float, drawing: Drawing) -> str:
    """Return the entry of the list of churches that walls which turn above a level answer; empty where none is plain.

    The façade is the outer wall with a pitched top; what faces away from it, and a wall that bends, is the apse.
    """
    lead = next((part for part in stack if part.outward), stack[0])
    if _stands_on_tower(stack, drawing):
        return "bell-cell"
    if any(_bends(part) for part in stack):
        return "apse"
    fronts = [part for part in drawing.structure.of_kind("wall", "gable") if part.eaves is not None and part.outward]
    if not lead.outward or not fronts:
        return ""
    if any(part in stack for part in fronts):
        return "facade" if low <= min(part.base for part in stack) + NEAR_LEVEL else "facade-top"
    same_way = [float(np.dot(lead.normal, front.normal)) for front in fronts]
    if min(same_way) < -IN_LINE:
        return "apse"
    return "nave-transverse" if max(map(abs, same_way)) < ACROSS else ""


BENT = 1.15  # of thickness, length and height: a wall with more volume bends in plan
ACROSS = 0.34  # cosine: walls whose normals are more than 70 degrees apart are across one another


def _bends(part: Part) -> bool:
    return part.kind == "wall" and part.volume > BENT * part.thickness * part.length * part.height


def _stands_on_tower(stack: Sequence[Part], drawing: Drawing) -> bool:
    """Return whether all of some walls rise over a tower."""
    for tower in drawing.structure.of_kind("tower"):
        plan = shapely.MultiPoint(tower.solid.vertices[:, :2]).convex_hull
        over = [shapely.Point(part.solid.centroid[:2]).within(plan) for part in stack]
        if all(over) and min(part.base for part in stack) >= tower.top - NEAR_LEVEL:
            return True
    return False


def _opposite(way: Vector) -> Vector:
    return (-way[0] + 0.0, -way[1] + 0.0, 0.0)


def _levels(stack: Sequence[Part], drawing: Drawing) -> tuple[float, ...]:
    """Return the levels above which walls can turn: their feet, and the floors that bear on them below the top."""
    top = max(part.top for part in stack)
    feet = [part.base for part in stack if part.kind in ("wall", "pier")]
    floors = [each for part in stack for each in drawing.bearing_elevations(part)]
    found: list[float] = []
    for level in distinct_levels([*feet, *floors]):
        if level <= top - LOW_STOREY + NEAR_LEVEL and (not found or level >= found[-1] + LOW_STOREY - NEAR_LEVEL):
            found.append(level)
    return tuple(found)


def _standing_above(stack: Sequence[Part], level: float, drawing: Drawing) -> tuple[Part, ...]:
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


def _walls_behind(stack: Sequence[Part], drawing: Drawing) -> tuple[Part, ...]:
    """Return the cross walls that meet walls from behind, or stand beside their ends."""
    inwards = np.array(_opposite(stack[0].normal))
    face = min(float((part.solid.vertices @ inwards).min()) for part in stack)
    found = {}
    for part in stack:
        for cross in drawing.structure.cross_walls(part.name):
            if float((cross.part.solid.vertices @ inwards).max()) > face + 2.0 * part.thickness:
                found[cross.part.name] = cross.part
    return tuple(found.values())


def _held_levels(wall: Part, drawing: Drawing) -> tuple[float, ...]:
    """Return the elevations at which floors or roofs hold a wall; near its top also those on what it carries."""
    above = [each for part in drawing.structure.standing_on(wall.name) for each in drawing.bearing_elevations(part)]
    near_top = [wall.top for each in above if each <= wall.top + HELD]
    own = [wall.top if each >= wall.top - HELD else each for each in drawing.bearing_elevations(wall)]
    return distinct_levels([*own, *near_top])


def _pressing(wall: Part, level: float, drawing: Drawing) -> OverburdenLoad | None:
    """Return what presses on a wall at a level: bodies on its top, or the weight above; None for nothing."""
    structure = drawing.structure
    contacts = [each for each in structure.contacts_of(wall.name) if each.second == wall.name]
    if level >= wall.top - NEAR_LEVEL:
        on_top = [each for each in contacts if each.relation in ("stands-on", "bears-on")]
        names = dict.fromkeys(
            each.first
            for each in on_top
            if each.elevation >= wall.top - HELD and find_contact(wall.solid, structure.part(each.first).solid)
        )
        return OverburdenLoad(bodies=tuple(names)) if names else None
    above = [part for part in _standing_above((wall,), wall.base, drawing) if part is not wall]
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


def _arch_of_bay(wall: Part, span: float, beyond: tuple[float, float], drawing: Drawing) -> Found:
    """Return the arch of a bay between what its wall has beyond the cross walls, of the weakest masonry."""
    area = g * wall.density * wall.thickness * wall.height
    ends = [thrust_held_beyond(weight=area * each, length=each, lever=wall.height) for each in beyond]
    arch = horizontal_arch(
        weight=area * span,
        span=span,
        thickness=wall.thickness,
        height=wall.height,
        ends=(ends[0], ends[1]),
        strength=LEAST_STRENGTH,
    )
    parameters: Parameters = {"thrust": Quantity(arch.thrust, "force"), "rise": Quantity(arch.rise, "length")}
    return Found(arch.multiplier, wall.normal, parameters, None, evaluations=1)


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
    return _all_of(said)


def _all_of(said: Sequence[Message]) -> Message:
    return reduce(lambda one, other: note("reason-and", one=one, other=other), said)
