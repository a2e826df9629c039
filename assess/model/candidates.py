"""The mechanisms that a building can have: what moves, what it carries, what stops it, and their least multipliers.

Which classes of mechanism a building is searched for is the table `CLASSES`. What a class can concern and is not looked
for is listed with the reason.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from assess.loads.load import BodyLoad, bodies_of
from assess.mechanisms.mechanism import BlockMechanism, CutAngle
from assess.mechanisms.single_block import SingleBlock
from assess.mechanisms.two_block import TwoBlock
from assess.messages.message import Message, Quantity, Term, note
from assess.model.candidate_frames import apses, arches, bell_cells, portals, shafts
from assess.model.candidate_walls import (
    bays,
    caps,
    corners,
    gables,
    parapets,
    spanning_walls,
    turning_walls,
    upper_parts,
    walls_with_wedges,
)
from assess.model.churches import Church
from assess.model.least_multipliers import Alternative, Drawing, Found, built
from assess.model.load_paths import by_worst_paths, resolve_thrusts
from assess.model.moving_parts import BEHIND, BuildingType, RuledOut, Seed, Seeds, Unexamined, all_of, opposite
from assess.model.structure import Part, PartKind, Structure
from assess.short_repr import ShortRepr

if TYPE_CHECKING:
    from pandas import DataFrame

TIE = 1.1  # multipliers up to this many times the least are as weak, as far as statics tell


UPRIGHT: tuple[PartKind, ...] = ("wall", "pier", "spandrel", "gable", "parapet", "tower", "chimney", "pinnacle", "arch")
"""Kinds of parts each of which must have a mechanism, or is named."""


@dataclass(frozen=True, kw_only=True, repr=False)
class Candidate(ShortRepr):
    """A mechanism that a building can have.

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


@dataclass(frozen=True)
class Gap:
    """What a class of mechanisms can concern and is not looked for.

    kind : of the table `CLASSES`
    part : its name
    what : it may do
    why : it is not looked for, or cannot form
    examines : the entry of the list of mechanisms of each type of building that stays open by it
    """

    kind: str
    part: str
    what: Term
    why: Message
    examines: Mapping[BuildingType, str]

    def __str__(self) -> str:
        return f"{note('candidate-title', part=self.part, what=self.what)}: {self.why}"


def texts_of(gaps: Sequence[Gap]) -> tuple[str, ...]:
    """Return a text for the parts of a class that are open for one reason."""
    alike: dict[tuple[Term, str], list[str]] = {}
    for each in gaps:
        alike.setdefault((each.what, str(each.why)), []).append(each.part)
    return tuple(f"{what}: {', '.join(dict.fromkeys(parts))}: {why}" for (what, why), parts in alike.items())


@dataclass(frozen=True)
class OpenEntry:
    """An entry of the list of a type of building that is possible and not examined in full.

    found : candidates of it that nothing stated is as weak as; gaps : what is not looked for
    """

    found: tuple[Candidate, ...]
    gaps: tuple[Gap, ...]


@dataclass(frozen=True, repr=False)
class Candidates(ShortRepr):
    """The mechanisms of a building, the weakest first, and the parts that have none.

    ranked : by multiplier; those without one last
    without : name of each upright part that no mechanism with a multiplier moves, and why
    gaps : what is possible and not looked for
    ruled_out : what cannot form, as the drawing says
    unread : what was left out of the building and may be a wall, for each entry that a wall can have
    """

    ranked: tuple[Candidate, ...]
    without: Mapping[str, Message]
    gaps: tuple[Gap, ...] = ()
    ruled_out: tuple[Gap, ...] = ()
    unread: tuple[Gap, ...] = ()

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

    def open_entries(self, building_type: BuildingType, *, stated: Collection[str]) -> dict[str, OpenEntry]:
        """Return the entries of the list of a type of building that are possible and not examined in full.

        A mechanism leaves its entry open unless one that is stated moves the same part at a multiplier no higher.

        Parameters
        ----------
        building_type : whose list it is
        stated : names of the candidates that are examined
        """
        found: dict[str, OpenEntry] = {}
        not_sought = (*self.gaps, *self.unread)
        possible = [*(each.examines for each in self.ranked), *(each.examines for each in not_sought)]
        for entry in dict.fromkeys(each[building_type] for each in possible if building_type in each):
            own = [each for each in self.ranked if each.examines.get(building_type) == entry]
            known = [each for each in own if each.name in stated]
            left = tuple(each for each in own if each.name not in stated and not _is_covered(each, known))
            gaps = tuple(each for each in not_sought if each.examines.get(building_type) == entry)
            if left or gaps:
                found[entry] = OpenEntry(left, gaps)
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


SAME_MULTIPLIER = 1e-3  # relative: multipliers nearer one another are one


def _is_covered(candidate: Candidate, stated: Sequence[Candidate]) -> bool:
    """Return whether one of the candidates that are stated moves the same leading part at no higher multiplier."""
    if candidate.multiplier is None:
        return False
    most = candidate.multiplier + SAME_MULTIPLIER * abs(candidate.multiplier)
    same = [each.multiplier for each in stated if each.parts[0] == candidate.parts[0]]
    return any(each is not None and each <= most for each in same)


@dataclass(frozen=True)
class MechanismClass:
    """A row of the table of classes.

    key : of the class; title : what it is called
    examines : entry of the list of each type of building (reference lists of the Italian survey forms); that of
        churches where its part is that of the entry
    seeds : finds what can move, in a drawing
    """

    key: str
    title: Term
    examines: Mapping[BuildingType, str]
    seeds: Callable[[Drawing], Seeds]


def find_candidates(structure: Structure) -> Candidates:
    """Return the mechanisms that a building can have, of every class, with the least multiplier of each."""
    drawing = resolve_thrusts(Drawing(structure))
    church = Church(drawing)
    found: list[Candidate] = []
    gaps: list[Gap] = []
    ruled_out: list[Gap] = []
    for row in CLASSES:
        for seed in row.seeds(drawing):
            if isinstance(seed, Seed):
                found.append(_candidate(row, seed, drawing, church, taken={each.name for each in found}))
            elif isinstance(seed, RuledOut):
                ruled_out.append(Gap(row.key, seed.part.name, row.title, seed.why, {}))
            else:
                entries = _examines(row, church, (seed.part,), seed.part.base)
                gaps.append(_gap(row, seed, {key: each for key, each in entries.items() if key in seed.lists}))
    tops = {name for each in found if each.examines.get("church") == "facade-top" for name in each.parts}
    rows = {row.key: row for row in CLASSES}
    gaps += [_gap(rows[key], each, {"church": entry}) for key, entry, each in church.open_elements(tops)]
    ranked = sorted(found, key=lambda each: (each.multiplier is None, each.multiplier or 0.0))
    return Candidates(
        tuple(ranked), _without(structure, ranked), tuple(gaps), tuple(ruled_out), tuple(_unread(structure))
    )


def _unread(structure: Structure) -> Iterator[Gap]:
    """Yield what was left out and may be a wall, for each entry of the lists that a wall can have."""
    for each in structure.left_out:
        if each.may_be_wall:
            for building_type, entries in ENTRIES_OF_WALLS.items():
                for entry in entries:
                    yield Gap("overturning", each.shown, LEFT_OUT, each.reason, {building_type: entry})


LEFT_OUT = Term("left out, and may be a wall")
ENTRIES_OF_WALLS: Mapping[BuildingType, tuple[str, ...]] = {
    "house": (
        "simple-overturning",
        "compound-overturning",
        "corner",
        "gable",
        "vertical-bending",
        "horizontal-bending",
        "two-way-bending",
    ),
    "church": ("facade", "facade-top", "nave-transverse", "transept-end", "apse", "bell-tower", "bell-cell"),
}
"""The entries of each list that a wall can have whose place in the building is not known."""


def _gap(row: MechanismClass, seed: Unexamined, examines: Mapping[BuildingType, str]) -> Gap:
    return Gap(row.key, seed.part.name, row.title, seed.why, examines)


def _examines(row: MechanismClass, church: Church, parts: Sequence[Part], low: float) -> Mapping[BuildingType, str]:
    """Return the entries of the lists that a mechanism of a class answers."""
    entry = church.entry(row.key, parts, low)
    if entry is None:
        return row.examines
    others: dict[BuildingType, str] = {key: each for key, each in row.examines.items() if key != "church"}
    return {**others, "church": entry} if entry else others


def _candidate(row: MechanismClass, seed: Seed, drawing: Drawing, church: Church, *, taken: set[str]) -> Candidate:
    structure = drawing.structure
    found, unsure = by_worst_paths(_on_free_sides(seed.find(), drawing), drawing)
    found = replace(found, tied=_tied_loads(found))
    stem = f"{_slug(seed.parts[0].name)}-{row.key}"
    name = next(each for each in (stem, *(f"{stem}-{i}" for i in range(2, 1000))) if each not in taken)
    loading = (
        set() if found.definition is None else {body for load in found.definition.loads for body in bodies_of(load)}
    )
    said = [
        note(key, bodies=", ".join(each))
        for key, each in (
            ("reason-tied", found.tied),
            ("reason-path", [body for body in unsure if body in loading]),
            ("reason-path-none", [body for body in unsure if body not in loading]),
        )
        if each
    ]
    low = found.parameters.get("hinge", Quantity(seed.parts[0].base)).value
    leads = seed.parts[0].name if seed.beside is None else f"{seed.parts[0].name}, {seed.beside.name}"
    return Candidate(
        name=name,
        kind=row.key,
        title=note("candidate-title", part=leads, what=row.title),
        parts=tuple(part.name for part in seed.parts),
        reason=all_of([seed.reason, *said]),
        carries=tuple(load.body for load in drawing.loads_on(seed.parts, above=low)),
        held_by=tuple(dict.fromkeys(tie.name for part in seed.parts for tie in structure.ties_of(part.name))),
        found=found,
        examines=_examines(row, church, seed.parts, low),
    )


def _tied_loads(found: Found) -> tuple[str, ...]:
    """Return the roofs and vaults that load a mechanism without their thrust."""
    loads = () if found.definition is None else found.definition.loads
    return tuple(dict.fromkeys(load.body for load in loads if isinstance(load, BodyLoad) and load.tied))


def _on_free_sides(found: Found, drawing: Drawing) -> Found:
    """Return a mechanism as rocking both ways where nothing stops it behind: no wall, and of a façade no floor."""
    definition = found.definition
    if not isinstance(definition, SingleBlock | TwoBlock) or isinstance(definition.cut, CutAngle):
        return found
    parts = [drawing.structure.part(body) for body in definition.bodies]
    low = definition.cut if isinstance(definition.cut, float) else min(part.base for part in parts)
    above = low + BEHIND * (max(part.top for part in parts) - low)
    roofed = any(part.outward for part in parts) and bool(drawing.loads_on(parts, above=low))
    if roofed or drawing.stopped_by(parts, opposite(definition.towards), above=above):
        return found
    both = built(replace(definition, sides="two"), drawing.around(definition), found.parameters)
    if both.multiplier is None or found.multiplier is None:
        return found
    return replace(found, definition=both.definition, multiplier=min(found.multiplier, both.multiplier))


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


CLASSES: tuple[MechanismClass, ...] = (
    MechanismClass(
        "overturning",
        Term("overturning of one storey"),
        {"house": "simple-overturning"},
        partial(turning_walls, storeys="one"),
    ),
    MechanismClass(
        "overturning-of-storeys",
        Term("overturning of several storeys"),
        {"house": "simple-overturning"},
        partial(turning_walls, storeys="several"),
    ),
    MechanismClass(
        "wedges",
        Term("overturning with wedges of the side walls"),
        {"house": "compound-overturning"},
        walls_with_wedges,
    ),
    MechanismClass("corner", Term("overturning of a corner"), {"house": "corner"}, corners),
    MechanismClass(
        "gable",
        Term("overturning of a gable"),
        {"house": "gable", "church": "facade-top"},
        gables,
    ),
    MechanismClass(
        "upper-part",
        Term("overturning of the upper part of a wall"),
        {"house": "simple-overturning", "church": "facade-top"},
        partial(upper_parts, shape="high"),
    ),
    MechanismClass("bending", Term("vertical bending between floors"), {"house": "vertical-bending"}, spanning_walls),
    MechanismClass("bay", Term("horizontal arch between cross walls"), {"house": "horizontal-bending"}, bays),
    MechanismClass(
        "parapet",
        Term("overturning of a parapet"),
        {"house": "parapet", "church": "projections"},
        parapets,
    ),
    MechanismClass(
        "chimney",
        Term("overturning of a chimney"),
        {"house": "chimney", "church": "projections"},
        partial(caps, kinds=("chimney",)),
    ),
    MechanismClass(
        "pinnacle", Term("overturning of a pinnacle"), {"church": "projections"}, partial(caps, kinds=("pinnacle",))
    ),
    MechanismClass("arch", Term("arch on four hinges"), {"church": "triumphal-arch"}, arches),
    MechanismClass("portal", Term("sway of a portal"), {"church": "porch"}, partial(portals, on_tower=False)),
    MechanismClass("belfry", Term("sway of a belfry"), {"church": "bell-cell"}, bell_cells),
    MechanismClass("apse", Term("fall of an apse above an inclined crack"), {"church": "apse"}, apses),
    MechanismClass(
        "tower", Term("fall above an inclined crack"), {"church": "bell-tower"}, partial(shafts, kinds=("tower",))
    ),
    MechanismClass(
        "spire",
        Term("fall of a spire above an inclined crack"),
        {"church": "projections"},
        partial(shafts, kinds=("pinnacle",)),
    ),
)
"""The classes of mechanism that a building is searched for, in the order of the lists of the survey forms."""
