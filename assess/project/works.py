"""What works on a building can change: numbers of its project file over a range, and works that are declared here.

`mechanisms.NAME.WORK.PARAMETER` names a declared work; anything else is a key of the file, and `loads.tie` in it stands
for all ties of the mechanism. A declared work changes the tables of the project; those it takes as a template are the
ties that the file already has.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np

from assess.declaration import Safe
from assess.errors import ProjectError
from assess.geometry.solid import Solid
from assess.loads.load import LOADS, TieLoad
from assess.project import sections
from assess.project.bars import Bar, StatedTie, bars_of, with_bars
from assess.project.key_errors import KeyPath, key_text, value_text
from assess.project.keys import KeyedValue, dependents, keyed_values, swept_value, value_at, with_value, with_values
from assess.project.ranges import unit_size, values_of, written_value
from assess.project.units import KINDS, QuantityKind, si_value
from assess.results.provenance import count_from_0
from spectra.arrays import FloatArray, is_number

Tables = Mapping[str, Any]
_WORK = re.compile(r"mechanisms\.(.+)\.([a-z_]+)\.([a-z_]+)")
_KIND = re.compile(rf"(mechanisms\..+\.loads)\.({'|'.join(LOADS)})\.(.+)")
SAME_LEVEL = 0.1  # m
STEEPNESS = 2.0  # height over width of masonry that widens a base: a load spreads in it at 27 degrees from the vertical


@dataclass(frozen=True)
class Subject:
    """A mechanism that works change.

    corners : of all its bodies [n, 3] [m]; along : its direction [3]; hinge : elevation of its base [m]
    """

    name: str
    content: sections.Content
    corners: FloatArray
    along: FloatArray
    hinge: float

    @property
    def loads(self) -> tuple[Any, ...]:
        """The loads as they were read."""
        return getattr(self.content.mechanisms[self.name], "loads", ())

    @cached_property
    def bars(self) -> tuple[Bar, ...]:
        """Its ties, each with the mechanisms that it holds besides."""
        return tuple(bars_of(self.content, (self.name,)))

    @property
    def stated_ties(self) -> tuple[StatedTie, ...]:
        """Its ties, as it and as other mechanisms state them."""
        return tuple(tie for bar in self.bars for tie in bar)

    @property
    def across(self) -> FloatArray:
        """The horizontal unit vector across its direction [3]."""
        return np.array([-self.along[1], self.along[0], 0.0])

    @property
    def length(self) -> float:
        """Its extent across its direction [m]."""
        return float(np.ptp(self.corners @ self.across))

    @property
    def top(self) -> float:
        """The elevation of its top [m]."""
        return float(self.corners[:, 2].max())

    def path(self, *steps: str | int) -> KeyPath:
        """Return a key of its table."""
        return ("mechanisms", self.name, *steps)


Change = Callable[[Tables, Subject, float], Tables]
"""Returns tables with a work of a size [SI] on a mechanism."""


@dataclass(frozen=True)
class Work:
    """A declared work, or one of its numbers.

    kind : what it measures, a key of `units.KINDS`; words : what it does; change : does it
    of_ties : whether it needs ties in the file as a template, and shows in their steel
    whole : whether it is a count
    """

    kind: str
    words: str
    change: Change
    of_ties: bool = False
    whole: bool = False


@dataclass(frozen=True)
class Axis:
    """One number that works vary.

    key : as it was typed; unit : of the values, "" for none; kind : what they measure
    values : in that unit, rising as typed; present : that of the file, 0 of a declared work that it lacks
    of_steel : whether it is of ties; priced : whether it takes what their steel does not show
    mechanisms : that it changes, with those that its ties hold besides; change : returns tables with a value of it
    """

    key: str
    unit: str
    kind: QuantityKind
    values: tuple[float, ...]
    present: float | None
    of_steel: bool
    mechanisms: tuple[str, ...]
    change: Callable[[Tables, float], Tables]
    priced: bool = False


def axis_of(key: str, given: str | Sequence[float | str], subjects: Mapping[str, Subject], content: Any) -> Axis:
    """Return the axis of a key and its range.

    Parameters
    ----------
    key : of the file, or of a declared work
    given : "100..800 mm^2", "100..800 mm^2 by 50", "2..6" or "200, 314 mm^2"; or a list of values
    subjects : the mechanisms of the project with geometry, by name
    content : of the project

    Raises
    ------
    ProjectError : the key is unknown, or a value cannot stand there
    """
    where = f"vary {value_text(key)}"
    found = _WORK.fullmatch(key)
    if found and found[1] in content.mechanisms and found[2] in {name for name, _ in WORKS}:
        return _axis_of_work(key, given, found[1], (found[2], found[3]), subjects, content, where)
    return _axis_of_key(key, given, content, where)


def may_vary(key: str, content: sections.Content) -> bool:
    """Return whether a key is one that works could vary in a project: a declared work, or a key of the file."""
    found = _WORK.fullmatch(key)
    if found and found[1] in content.mechanisms and (found[2], found[3]) in WORKS:
        return True
    of_kind = _KIND.fullmatch(count_from_0(key))
    return (of_kind[1] if of_kind else count_from_0(key)) in keyed_values(content)


def _axis_of_work(
    key: str,
    given: Any,
    name: str,
    work: tuple[str, str],
    subjects: Mapping[str, Subject],
    content: sections.Content,
    where: str,
) -> Axis:
    if work not in WORKS:
        raise ProjectError(f"{where}: no such number of a work; known are {', '.join(map('.'.join, WORKS))}")
    declared, subject = WORKS[work], subjects.get(name)
    if subject is None:
        raise ProjectError(f"{where}: mechanism {value_text(name)} has no bodies with geometry; vary keys of its table")
    if declared.of_ties and not subject.bars:
        raise ProjectError(
            f'{where}: no tie in mechanisms.{name}.loads to take as a template; write one, {{ kind = "tie", … }}'
        )
    values, unit = values_of(given, KINDS[declared.kind], where=where, whole=declared.whole)
    if declared.of_ties:
        like = keyed_values(content).get(".".join(map(str, (*subject.bars[0][0].path, work[1]))))
        _check_bare_numbers(values, unit, like, where)
    factor = unit_size(unit, KINDS[declared.kind])

    def change(tables: Tables, value: float) -> Tables:
        return declared.change(tables, subject, value * factor)

    nothing = 1.0 if work == ("roof", "factor") else 0.0
    stating = {tie.mechanism for tie in subject.stated_ties if declared.of_ties} | {name}
    changed = tuple(each for each in content.mechanisms if each in stating)
    return Axis(key, unit, KINDS[declared.kind], values, nothing, declared.of_ties, changed, change)


def _axis_of_key(key: str, given: Any, content: sections.Content, where: str) -> Axis:
    by_key, keys, of_kind = keyed_values(content), [key], _KIND.fullmatch(count_from_0(key))
    if of_kind:
        loads = by_key[of_kind[1]].value if of_kind[1] in by_key else ()
        keys = [f"{of_kind[1]}.{place}.{of_kind[3]}" for place, load in enumerate(loads) if load.kind == of_kind[2]]
        if not keys:
            raise ProjectError(f"{where}: {of_kind[1]} has no load of kind {value_text(of_kind[2])}; write one first")
    try:
        works = [".".join(("mechanisms", name, *work)) for name in content.mechanisms for work in WORKS]
        entries = [swept_value(each, by_key, where=where, others=works) for each in keys]
    except ProjectError as error:
        raise ProjectError(f"vary {str(error).removeprefix(f'{where}.key: ')}") from None
    first, paths = entries[0], [path for each in entries for path in with_bars({each.path: None}, content)]
    if first.of_works is None:
        raise ProjectError(
            f"{where}: no works change it, as it belongs to what stands or to what shakes it; vary a size, a place or "
            "the steel of a tie or its plate, the thickness of a box, or a declared work, "
            f"{', '.join('.'.join(work) for work in WORKS)}"
        )
    kind = first.kind or KINDS["ratio"]
    values, unit = values_of(given, kind, where=where)
    _check_bare_numbers(values, unit, first, where)
    typed = value_at(content, first.path)
    present = typed / unit_size(unit, kind) if is_number(typed) else None

    def change(tables: Tables, value: float) -> Tables:
        for path in paths:
            tables = with_value(tables, path, written_value(value, unit), content)
        return tables

    of_tie = len(first.path) > 3 and first.path[2] == "loads" and _load_at(content, first.path).kind == "tie"
    changed = {name for each in entries for name in dependents(content, each.path)}
    mechanisms = tuple(name for name in content.mechanisms if name in changed)
    return Axis(key, unit, kind, values, present, of_tie, mechanisms, change, first.of_works.priced)


def _check_bare_numbers(values: Sequence[float], unit: str, entry: KeyedValue | None, where: str) -> None:
    """Raise ProjectError for values without a unit that a file may not have at a key, as it reads them in SI.

    None of a thing is 0 of it. What is beyond with its unit is a layout that is refused.
    """
    if unit or entry is None or entry.number is None:
        return
    for value in filter(None, values):
        if fault := entry.number.fault(value):
            raise ProjectError(f"{where}: {value:.6g}: {fault}")


def _load_at(content: sections.Content, path: KeyPath) -> Any:
    return value_at(content, path[:4])


def _loads(tables: Tables, name: str) -> list[Any]:
    return deepcopy(list(tables["mechanisms"][name].get("loads", [])))


def _with_loads(tables: Tables, name: str, loads: Sequence[Any], copies: Mapping[int, int] | None = None) -> Tables:
    """Return tables with other loads of a mechanism; copies: of loads by their places, which have the same sources."""
    mechanisms = tables["mechanisms"]
    changed = {**tables, "mechanisms": {**mechanisms, name: {**mechanisms[name], "loads": list(loads)}}}
    report = tables.get("report", {})
    sources = dict(report.get("sources", {}))
    for copy, place in (copies or {}).items():
        own = f"mechanisms.{name}.loads.{place}"
        for key, text in [(count_from_0(given), text) for given, text in sources.items()]:
            if key == own or key.startswith(f"{own}."):
                sources[f"mechanisms.{name}.loads[{copy + 1}]{key.removeprefix(own)}"] = text
    return {**changed, "report": {**report, "sources": sources}} if sources else changed


def _with_tie(tables: Tables, tie: StatedTie, change: Callable[[dict[str, Any]], dict[str, Any]]) -> Tables:
    """Return tables with a change of the table of a tie."""
    loads = _loads(tables, tie.mechanism)
    loads[tie.place] = change(loads[tie.place])
    return _with_loads(tables, tie.mechanism, loads)


def _with_copy(tables: Tables, tie: StatedTie, change: Callable[[dict[str, Any]], dict[str, Any]]) -> Tables:
    """Return tables with a changed copy of a tie behind the loads of its mechanism, with its sources."""
    loads = _loads(tables, tie.mechanism)
    return _with_loads(tables, tie.mechanism, [*loads, change(loads[tie.place])], {len(loads): tie.place})


FILE_UNITS = {"area": ("mm^2", 1e-6), "force": ("kN", 1e3), "mass": ("kg", 1.0)}
"""Units in which declared works are written, with their size in SI."""


def _in_file(kind: str, value: float) -> str:
    unit, size = FILE_UNITS[kind]
    return f"{value / size:.12g} {unit}"


def _set_of_ties(key: str, tables: Tables, subject: Subject, value: float) -> Tables:
    """Set a number of all ties of the file."""
    for tie in subject.stated_ties:
        tables = _with_tie(tables, tie, lambda table: {**table, key: _in_file(key, value)})
    return tables


def at_height(tie: Mapping[str, Any], load: TieLoad, height: float) -> dict[str, Any]:
    """Return the table of a tie raised to an elevation [m], its anchor with it.

    Parameters
    ----------
    tie : its table; load : as it was read
    """
    rise = height - load.at[-1]
    moved = {key: [*place[:-1], place[-1] + rise] for key in ("at", "anchor") if (place := getattr(load, key))}
    return {**tie, **moved}


def _raise_ties(tables: Tables, subject: Subject, height: float) -> Tables:
    for tie in subject.stated_ties:
        tables = _with_tie(tables, tie, partial(at_height, load=tie.load, height=height))
    return tables


def _spread_ties(tables: Tables, subject: Subject, count: float) -> Tables:
    """Put a number of ties at each level where the file has some, in the middle of equal parts of the wall's length.

    Those of the file are moved there; what they lack of the number are copies of the first, and those beyond it go.
    """
    bars, number = {bar[0].place: bar for bar in subject.bars}, round(count)
    middle = float((subject.corners @ subject.across).min()) + subject.length / 2.0
    stations = [middle + subject.length * ((each + 0.5) / number - 0.5) for each in range(number)]
    loads = tables["mechanisms"][subject.name]["loads"]
    gone: dict[KeyPath, Any] = {}
    for level in ties_by_level({place: si_value(loads[place]["at"][-1], KINDS["length"]) for place in bars}):
        gone |= {tie.path: Safe.ABSENT for place in level[number:] for tie in bars[place]}
        for rank, station in enumerate(stations):
            put, place = (_with_tie, level[rank]) if rank < len(level) else (_with_copy, level[0])
            for tie in bars[place]:
                tables = put(tables, tie, partial(_at_station, subject=subject, station=station))
    return with_values(tables, gone, subject.content)


def ties_by_level(elevations: Mapping[int, float]) -> list[list[int]]:
    """Return places of ties in groups at one level, to SAME_LEVEL.

    elevations : of each place [m]
    """
    levels: list[list[int]] = []
    for place in sorted(elevations, key=lambda place: elevations[place]):
        if levels and elevations[place] - elevations[levels[-1][0]] <= SAME_LEVEL:
            levels[-1].append(place)
        else:
            levels.append([place])
    return [sorted(level) for level in levels]


def _at_station(tie: Mapping[str, Any], subject: Subject, station: float) -> dict[str, Any]:
    """Return the table of a tie moved along the wall [m], with its anchor; one in the plane of motion stays."""
    if len(tie["at"]) != 3:
        return dict(tie)
    now = float(np.array([si_value(each, KINDS["length"]) for each in tie["at"]]) @ subject.across)
    return _shifted(tie, (station - now) * subject.across)


def _shifted(tie: Mapping[str, Any], shift: FloatArray) -> dict[str, Any]:
    """Return the table of a tie moved in space by a shift [3] [m], with its anchor; a direction stays."""
    moved = {
        key: [
            round(si_value(each, KINDS["length"]) + by, 12) + 0.0
            for each, by in zip(tie[key], shift.tolist(), strict=True)
        ]
        for key in ("at", "anchor")
        if key in tie
    }
    return {**tie, **moved}


def _add_top_mass(tables: Tables, subject: Subject, mass: float) -> Tables:
    """Add a beam on the top of the wall as a mass in the middle of it."""
    if mass == 0.0:
        return tables
    top = subject.corners[subject.corners[:, 2] > subject.top - 1e-6]
    at = [*((top.min(axis=0) + top.max(axis=0))[:2] / 2.0).tolist(), subject.top]
    beam = {"kind": "mass", "mass": _in_file("mass", mass), "at": at, "bearing": True}
    return _with_loads(tables, subject.name, [*_loads(tables, subject.name), beam])


def _add_top_tie(tables: Tables, subject: Subject, area: float) -> Tables:
    """Add the tie that a ring beam gives: one like the first of the file, at the top of the wall."""
    if area == 0.0:
        return tables

    def raised(table: dict[str, Any], load: TieLoad) -> dict[str, Any]:
        return {**at_height(table, load, subject.top), "area": _in_file("area", area)}

    for tie in subject.bars[0]:
        tables = _with_copy(tables, tie, partial(raised, load=tie.load))
    return tables


def _lighten_roof(tables: Tables, subject: Subject, factor: float) -> Tables:
    """Multiply the mass of the bodies that are its roof; of the highest point mass where there is none."""
    loads = _loads(tables, subject.name)
    roofs = [place for place, load in enumerate(subject.loads) if load.kind == "body" and load.role == "roof"]
    masses = [place for place, load in enumerate(subject.loads) if load.kind == "mass"]
    if not roofs and not masses:
        raise ProjectError(f"mechanisms.{subject.name}.loads: no roof and no mass to lighten; write its load first")
    for place in roofs or [max(masses, key=lambda place: subject.loads[place].at[-1])]:
        mass = subject.loads[place].mass
        if mass is None:
            raise ProjectError(
                f"{key_text(subject.path('loads', place, 'mass'))}: missing; give the mass that is to be lessened"
            )
        loads[place]["mass"] = _in_file("mass", mass * factor)
    return _with_loads(tables, subject.name, loads)


def _widen_base(tables: Tables, subject: Subject, width: float) -> Tables:
    """Add masonry before the foot of the wall, of the material of its first body, twice as high as it is wide."""
    if width == 0.0:
        return tables
    content, section = subject.content, subject.content.mechanisms[subject.name]
    along_x = abs(subject.along[0]) > abs(subject.along[1])
    if min(abs(subject.along[0]), abs(subject.along[1])) > 1e-6 or getattr(section, "hinges", None) is not None:
        raise ProjectError(
            f"mechanisms.{subject.name}: its base can be widened where it turns along x or y and its hinges follow its "
            "bodies; draw the wider base as a box and vary its thickness"
        )
    blocks: tuple[tuple[str, ...], ...] = getattr(section, "blocks", ())
    material = getattr(content.bodies[blocks[0][0]], "material", None)
    low, high = subject.corners.min(axis=0), subject.corners.max(axis=0)
    foot = subject.corners[subject.corners[:, 2] < subject.hinge + 1e-6]
    face = float((foot @ subject.along).max())
    centre = subject.along * (face + width / 2.0) + subject.across * (subject.across @ (low + high)) / 2.0
    sizes = {"thickness": width if along_x else high[0] - low[0], "length": high[1] - low[1] if along_x else width}
    name = next(each for each in (f"{subject.name}-base", *(f"{subject.name}-base-{n}" for n in range(2, 99)))
                if each not in content.bodies)  # fmt: skip
    body = {
        "material": material,
        "box": {
            **{key: float(size) for key, size in sizes.items()},
            "height": STEEPNESS * width,
            "base": [round(float(centre[0]), 9), round(float(centre[1]), 9), subject.hinge],
        },
    }
    others = tables["mechanisms"][subject.name]["blocks"][1:] if len(blocks) > 1 else []
    mechanism = {**tables["mechanisms"][subject.name], "blocks": [[*blocks[0], name], *others]}
    return {
        **tables,
        "bodies": {**tables["bodies"], name: body},
        "mechanisms": {**tables["mechanisms"], subject.name: mechanism},
    }


WORKS: Mapping[tuple[str, str], Work] = {
    ("ties", "area"): Work("area", "section of each tie of the file", partial(_set_of_ties, "area"), of_ties=True),
    ("ties", "force"): Work("force", "pretension of each tie", partial(_set_of_ties, "force"), of_ties=True),
    ("ties", "height"): Work("length", "elevation of all ties, with their anchors", _raise_ties, of_ties=True),
    ("ring_beam", "mass"): Work("mass", "mass of a beam along the top of the wall", _add_top_mass),
    ("ring_beam", "area"): Work("area", "section of the tie that it gives at the top", _add_top_tie, of_ties=True),
    ("roof", "factor"): Work("ratio", "factor on the mass of the roof", _lighten_roof),
    ("base", "width"): Work("length", "masonry before the foot, twice as high as wide", _widen_base),
    ("ties", "count"): Work(
        "ratio", "ties at each level where the file has some", _spread_ties, of_ties=True, whole=True
    ),
}
"""The declared works, in the order in which they are done, after all keys of the file; ties are removed last."""


def in_order(axes: Sequence[Axis]) -> list[int]:
    """Return the places of axes in the order in which their changes are made."""
    order = [".".join(work) for work in WORKS]

    def rank(place: int) -> int:
        return next((order.index(each) + 1 for each in order if axes[place].key.endswith(f".{each}")), 0)

    return sorted(range(len(axes)), key=rank)


def subject_of(name: str, content: sections.Content, solids: Mapping[str, Solid | None]) -> Subject | None:
    """Return a mechanism with its geometry; None where a body of it has none."""
    section = content.mechanisms[name]
    if not isinstance(section, sections.ChainSection):
        return None
    bodies = [solids.get(body) for block in section.blocks for body in block]
    known = [each for each in bodies if each is not None]
    if len(known) < len(bodies) or not known:
        return None
    corners = np.concatenate([each.vertices for each in known])
    cut = getattr(section, "cut", None)
    hinge = float(cut) if is_number(cut) else float(corners[:, 2].min())
    above = corners[corners[:, 2] >= hinge - 1e-9]
    along = np.asarray(section.plain.towards, dtype=float)
    return Subject(name, content, above, along / np.linalg.norm(along), hinge)
