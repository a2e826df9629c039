"""The least works on a project: what is varied, how a layout becomes a study, and the project with the best of them.

Layouts are refused that rules of detailing exclude, whatever they reach: pretension above half of what yields the bar,
and anchors farther apart than allowed, 3 m unless the engineer has checked the wall between them. Where the anchorage
of ties is computed from their plates, the wall between them is a part of it, and three plates in one cone are refused.
"""

from __future__ import annotations

import glob
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from hashlib import sha256
from math import nan, prod
from pathlib import Path
from typing import Any

import numpy as np
import shapely

from assess.amplification import ModalFilter
from assess.codes.procedures import uses_histories
from assess.codes.question import find_limit_states, methods_of, missing_action
from assess.codes.verdict import Verdict
from assess.errors import AssessError, ProjectError
from assess.loads.anchorage import CLOSE
from assess.loads.load import Tie, TieLoad, share_ends
from assess.messages.message import Message, Quantity, escape_text, message, note, warning, whole_number
from assess.project import sections
from assess.project.build import BuiltProject, build_to_decide, build_with_cases
from assess.project.key_errors import key_text, value_text
from assess.project.keys import read_content
from assess.project.project_file import Project, load_tree, parse_toml
from assess.project.section import ProjectSection
from assess.project.toml_text import with_changes
from assess.project.units import to_si
from assess.project.works import Axis, Subject, Tables, at_height, axis_of, in_order, subject_of, ties_by_level
from assess.results.retrofit import Layout, Place, Reached, RetrofitResults, Target, TargetKind, Tolerance, VariedKey
from assess.study.retrofit import (
    AS_DRAWN,
    Found,
    Measure,
    find_least,
    measure_histories,
    measure_index,
    split_by_event,
    upper_share,
)
from assess.study.retrofit_search import FULL
from assess.study.run import find_outcome
from assess.study.study import Progress, ScaledRecord, Study, require_spectrum
from assess.study.suites import motions_of
from spectra.gravity import g

STEEL = 7850.0  # kg/m3
MOST_PRETENSION = 0.5  # of the yield force
MOST_IN_CONE = 2  # plates
MOST_LAYOUTS = 100_000
TOLERATED = {"area": "area", "stiffness": "area", "length": "length", "yield_stress": "yield_stress"}
"""Numbers of a tie by the tolerance that changes them; of a restraint without a bar its stiffness is as its area."""
SCHEMA = "#:schema "
TARGETS: tuple[TargetKind, ...] = ("index", "ratio", "probability")
PER_STEEL, PER_TIE = "steel", "tie"


@dataclass(frozen=True)
class RetrofitQuestion:
    """What is asked of works.

    target, reach : the measure and its value
    vary : ranges by keys of the file and by declared works
    limit_state : in place of that of the project
    price : by "steel" for each kg, "tie" for each, and by varied key for each unit of change; without any, steel counts
    spacing : between anchors, at most [m], or with its unit
    search_records : number of records on which layouts are searched, about; every second event where None
    """

    target: TargetKind
    reach: float
    vary: Mapping[str, str | Sequence[float | str]]
    limit_state: str | None = None
    price: Mapping[str, float] = field(default_factory=dict)
    spacing: float | str = CLOSE
    search_records: int | None = None

    @property
    def farthest(self) -> float:
        """The largest distance between anchors [m]."""
        return to_si(self.spacing, "length", key="spacing")


@dataclass(frozen=True)
class Retrofit:
    """The least works on a project.

    results : what was examined and found; project : as it was read; tables : of the project with the best works, None
    where none is proved
    """

    results: RetrofitResults
    project: Project
    tables: Tables | None

    def project_text(self, folder: Path) -> str:
        """Return the project with the best works as the text of a file in a folder.

        Paths are written anew; comments stay where the text around them does. None is written where none is proved.
        """
        assert self.tables is not None
        assert self.results.best is not None
        original = self.project.path.read_bytes().decode("utf-8-sig")
        text, _ = with_changes(original, _relocated(self.tables, self.project, folder))
        values = zip(self.results.varied, self.results.best.values, strict=True)
        lines = [escape_text(f"#   {each.key} = {value:.6g} {each.unit}".rstrip()) for each, value in values]
        head = [f"# Written by `assess retrofit` from {self.project.path.name!r}, with these works:", *lines]
        schema, rest = "", text
        if text.startswith(SCHEMA):  # by which editors find it beside the project
            line, _, rest = text.partition("\n")
            schema = SCHEMA + _seen_from(line.removeprefix(SCHEMA).strip(), self.project.folder, folder) + "\n"
        return schema + "\n".join(head) + "\n\n" + rest


def find_retrofit(project: Project, question: RetrofitQuestion, *, jobs: int, progress: Progress) -> Retrofit:
    """Find the least works with which a project reaches a target.

    Parameters
    ----------
    project : as read; its sweeps are ignored
    question : what is to be reached, by what
    jobs : threads, 0 for all cores
    progress : called as layouts are examined

    Raises
    ------
    AssessError : a key or range is wrong, the target cannot be measured, or no number of records could show it
    """
    _check_question(question)
    written = project.path.read_bytes()
    if sha256(written).hexdigest() != project.sha256:
        raise ProjectError(f"{project.path}: has changed since it was read; run the command again")
    tables = parse_toml(written.decode("utf-8-sig"))
    if question.limit_state is not None:
        tables = {**tables, "verdict": {**tables.get("verdict", {}), "limit_state": question.limit_state}}
        project = load_tree(tables, project.path, sha256=project.sha256)
    progress("mechanisms", 0, 1)
    built = build_with_cases(project)
    designs = _designs(built, question)
    study = built.study
    if fallen := [each.name for each in study.falling if each.name in designs.mechanisms]:
        raise ProjectError(
            f"mechanisms.{fallen[0]}: falls at rest; write works with which it stands into the project, and vary those"
        )
    target = Target(question.target, question.reach, _rises(study, question.target))
    seen: tuple[ScaledRecord, ...] = ()
    rest: tuple[ScaledRecord, ...] = ()
    pga = None
    search: Measure = measure_index
    glance = prove = search
    if question.target != "index":
        seen, rest, pga, site_pga = _ground_motions(study, question, designs, jobs=jobs)
        search, glance, prove = (
            measure_histories(target, motions, pga=pga, site_pga=site_pga, twins=twins, threads=jobs)
            for motions, twins in ((seen, False), (rest, False), (rest, True))
        )
    found = find_least(designs, target, search=search, glance=glance, prove=prove, progress=progress)
    warnings = [*designs.messages(), *_conditions(designs)]
    with_works: Tables | None = None
    outcome = ""
    if found.best is not None:
        with_works = designs.apply(tables, found.best.place)
        reread = load_tree(dict(with_works), project.path, sha256="")
        found, outcome, more = _as_written(found, reread, designs, target, jobs=jobs)
        warnings += more
    states, _ = find_limit_states(study.question)
    basis = study.question.basis
    report = project.content.report
    results = RetrofitResults(
        title=project.content.title or "",
        language=report.language,
        units=report.units,
        mechanisms=designs.mechanisms,
        target=target,
        limit_state=states[0].name if states else "",
        index=basis.index.value if basis is not None and question.target == "index" else "",
        pga_g=None if pga is None else pga / g,
        varied=tuple(VariedKey(each.key, each.unit, each.present) for each in designs.axes),
        priced=bool(question.price),
        layouts=found.layouts,
        whole=prod(designs.sizes) <= FULL,
        best=found.best,
        nearest=found.nearest,
        proofs=found.proofs,
        tried=found.tried,
        candidates=found.candidates,
        search_records=tuple(each.record.id for each in seen),
        proof_records=tuple(each.record.id for each in rest),
        verdict=outcome,
        warnings=tuple(warnings),
        failed=found.failed,
    )
    return Retrofit(results, project, with_works if found.best is not None else None)


def _check_question(question: RetrofitQuestion) -> None:
    """Raise ProjectError for a question that cannot be asked."""
    if question.target not in TARGETS:
        raise ProjectError(f"target = {value_text(question.target)}: choose one of {', '.join(TARGETS)}")
    most = 1.0 if question.target == "probability" else 1e6
    if not 0.0 < question.reach <= most or (question.target == "probability" and question.reach == 1.0):
        end = "below 1" if question.target == "probability" else "up to 1e6"
        raise ProjectError(f"reach = {question.reach:g}: write a number above 0 and {end}, in the target's measure")
    if not question.vary:
        raise ProjectError('vary: nothing; write keys with their ranges, such as "mechanisms.NAME.ties.count = 2..6"')
    if not 0.0 < question.farthest <= 100.0:
        raise ProjectError(f"spacing = {question.farthest:g} m: write a distance between anchors, such as 3 m")


class _Designs:
    """The layouts of works on a project (`assess.study.retrofit.Designs`)."""

    def __init__(
        self, built: BuiltProject, axes: Sequence[Axis], subjects: Mapping[str, Subject], question: RetrofitQuestion
    ) -> None:
        self.axes, self.question, self.farthest = tuple(axes), question, question.farthest
        self.mechanisms = tuple(
            name for name in built.project.content.mechanisms if any(name in axis.mechanisms for axis in axes)
        )
        self.built_mechanisms = built.study.mechanisms
        self._built, self._subjects, self._order = built, subjects, in_order(axes)

    @property
    def sizes(self) -> tuple[int, ...]:
        return tuple(len(axis.values) for axis in self.axes)

    @property
    def has_ties(self) -> bool:
        """Whether a mechanism that the works change has a tie."""
        return any(True for _ in _ties(self._built.project.content, self.mechanisms))

    @property
    def has_plates(self) -> bool:
        """Whether the anchorage of every tie is computed from its plate."""
        ties = _ties(self._built.project.content, self.mechanisms)
        return all(tie.plate is not None and tie.strength is None for _, _, tie in ties)

    def apply(self, tables: Tables, place: Place) -> Tables:
        """Return tables with the works of a layout."""
        for number in self._order:
            axis = self.axes[number]
            tables = axis.change(tables, axis.values[place[number]])
        return tables

    def layout(self, place: Place) -> Layout:
        values = tuple(axis.values[number] for axis, number in zip(self.axes, place, strict=True))
        try:
            content = self._content(self.apply(self._built.project.raw, place))
        except AssessError as error:
            return Layout(place, values, nan, nan, message("retrofit-not-built", {"error": str(error)}))
        ties = _bars(content, self.mechanisms)
        steel = sum(STEEL * tie.area * tie.length for tie in ties if tie.area and tie.length)
        refused = next(self._refusals(content), None)
        return Layout(place, values, steel, self._objective(values, steel, len(ties)), refused)

    def study(self, place: Place, tolerance: Tolerance) -> Study:
        tables = self.apply(self._built.project.raw, place)
        content = self._content(tables)
        if tolerance != AS_DRAWN:
            content = self._content(_with_tolerance(tables, content, self._subjects, self.mechanisms, tolerance))
        study = self._built.study_at(content, self.mechanisms)
        for each in study.mechanisms:
            if not each.rocks or each.variants.collapse is None:
                raise ProjectError(f"mechanisms.{each.name}: falls at rest without what is not shown to last")
            plates = [action.anchorage for chain in each.chains for action in chain.actions if isinstance(action, Tie)]
            if (most := max((plate.site.meeting for plate in plates if plate), default=0)) > MOST_IN_CONE:
                raise ProjectError(f"mechanisms.{each.name}: {most} plates punch one cone; {MOST_IN_CONE} at most may")
        return study

    def messages(self) -> Iterator[Message]:
        """Yield what ties lack to count up to collapse, and the mechanisms that count the same ties, as they were."""
        content = self._built.project.content
        if not any(axis.of_steel for axis in self.axes):
            return
        for name, place, tie in _ties(content, self.mechanisms):
            needed = ("strength",) * (not tie.plate) + ("length", "fracture_strain") * (tie.stiffness is None)
            lacks = [key for key in needed if getattr(tie, key) is None]
            lacks += [] if content.report.source_of(f"mechanisms.{name}.loads.{place}.until") else ["report.sources"]
            if lacks:
                yield warning(
                    "retrofit-tie-lacks", key_text(("mechanisms", name, "loads", place)), keys=", ".join(lacks)
                )

        others = [name for name in content.mechanisms if name not in self.mechanisms]
        changed = [tie for _, _, tie in _ties(content, self.mechanisms)]
        shared = {
            name: None for name, _, tie in _ties(content, others) if any(share_ends(tie, each) for each in changed)
        }
        if shared:
            yield warning("retrofit-tie-shared", "mechanisms", mechanisms=", ".join(shared))

    def _content(self, tables: Tables) -> sections.Content:
        return read_content(tables, self._built.project.folder)

    def _objective(self, values: Sequence[float], steel: float, ties: int) -> float:
        """Return the cost of a layout by the prices given; its steel [kg] without any."""
        price = self.question.price
        if not price:
            return steel
        changed = (
            price.get(axis.key, 0.0) * abs(value - (axis.present or 0.0))
            for axis, value in zip(self.axes, values, strict=True)
        )
        return price.get(PER_STEEL, 0.0) * steel + price.get(PER_TIE, 0.0) * ties + sum(changed)

    def _refusals(self, content: sections.Content) -> Iterator[Message]:
        """Yield why a layout may not be built."""
        anchors: dict[str, dict[int, TieLoad]] = {}
        for name, place, tie in _ties(content, self.mechanisms):
            anchors.setdefault(name, {})[place] = tie
            if tie.area is None or tie.yield_stress is None:
                continue
            most, pull = MOST_PRETENSION * tie.area * tie.yield_stress, tie.force or 0.0
            if pull > most * (1.0 + 1e-9):
                yield message(
                    "retrofit-pretension", {"force": Quantity(pull, "force"), "most": Quantity(most, "force")}
                )
        designed = {name for axis in self.axes if axis.of_steel for name in axis.mechanisms}
        for name in designed.intersection(anchors, self._subjects):
            ties = anchors[name]
            if all(tie.plate is not None and tie.strength is None for tie in ties.values()):
                continue  # the wall between them is a part of their anchorage
            levels = ties_by_level({place: tie.at[-1] for place, tie in ties.items()})
            apart = self._subjects[name].length / max(map(len, levels))
            if apart > self.farthest * (1.0 + 1e-9):
                yield message(
                    "retrofit-spacing",
                    {"spacing": Quantity(apart, "length", 3), "most": Quantity(self.farthest, "length", 3)},
                )


def _designs(built: BuiltProject, question: RetrofitQuestion) -> _Designs:
    """Return the layouts that a question asks for."""
    content = built.project.content
    subjects = {name: each for name in content.mechanisms if (each := subject_of(name, content, built.solids))}
    axes = [axis_of(key, given, subjects, content) for key, given in question.vary.items()]
    layouts = prod(len(axis.values) for axis in axes)
    if layouts > MOST_LAYOUTS:
        raise ProjectError(f"vary: {layouts} layouts; give fewer values, {MOST_LAYOUTS} layouts at most")
    priceable = {PER_STEEL, PER_TIE, *(axis.key for axis in axes)}
    for key, price in question.price.items():
        if key not in priceable or not 0.0 <= price < 1e12:
            known = ", ".join(priceable)
            raise ProjectError(f"price {value_text(key)} = {price:g}: write a price from 0 of one of {known}")
    for axis in axes:
        if not axis.mechanisms:
            raise ProjectError(f"vary {value_text(axis.key)}: no mechanism depends on it; name another key")
        shown = (
            axis.of_steel
            and not axis.priced
            and any(tie.area and tie.length for _, _, tie in _ties(content, axis.mechanisms))
        )
        shown |= axis.key.endswith(".ties.count") and PER_TIE in question.price
        if not shown and axis.key not in question.price:
            raise ProjectError(
                f"vary {value_text(axis.key)}: it shows in no steel, so nothing says how much of it is least; give its "
                f"price for each {axis.unit or 'unit'} of change, price {axis.key} = NUMBER"
            )
    return _Designs(built, axes, subjects, question)


def _ties(content: sections.Content, names: Sequence[str]) -> Iterator[tuple[str, int, TieLoad]]:
    """Yield every tie of mechanisms, with the name of its mechanism and its place among the loads."""
    for name in names:
        for place, load in enumerate(getattr(content.mechanisms[name], "loads", ())):
            if load.kind == "tie":
                yield name, place, load


def _bars(content: sections.Content, names: Sequence[str]) -> list[TieLoad]:
    """Return the ties of mechanisms, of those of several that are one bar the thickest alone."""
    found: list[tuple[str, TieLoad]] = []
    for name, _, tie in _ties(content, names):
        same = next((k for k, (other, each) in enumerate(found)
                     if other != name and len(tie.at) == 3 and share_ends(tie, each)), None)  # fmt: skip
        if same is None:
            found.append((name, tie))
        elif (tie.area or 0.0) > (found[same][1].area or 0.0):
            found[same] = name, tie
    return [tie for _, tie in found]


def _with_tolerance(
    tables: Tables,
    content: sections.Content,
    subjects: Mapping[str, Subject],
    names: Sequence[str],
    tolerance: Tolerance,
) -> Tables:
    """Return tables whose ties differ by a tolerance; none is raised to where its wall could not hold it."""
    mechanisms = dict(tables["mechanisms"])
    for name, place, tie in _ties(content, names):
        loads = list(mechanisms[name]["loads"])
        changed = dict(loads[place])
        for key, factor in TOLERATED.items():
            if (value := getattr(tie, key)) is not None:
                changed[key] = value * getattr(tolerance, factor)
        if subject := subjects.get(name):
            height = subject.hinge + (tie.at[-1] - subject.hinge) * tolerance.height
            changed = at_height(changed, tie, min(height, max(tie.at[-1], _highest(tie, subject))))
        loads[place] = changed
        mechanisms[name] = {**mechanisms[name], "loads": loads}
    return {**tables, "mechanisms": mechanisms}


def _highest(tie: TieLoad, subject: Subject) -> float:
    """Return the elevation up to which a tie may be raised: where its cone reaches the top of the wall above it [m].

    A plate nearer the edge punches a cone that the drawing does not have. A tie without a plate may be raised to the
    top, which is that of the hull of the bodies as seen along the direction.
    """
    plate = tie.plate
    width, height = ((plate and (getattr(plate, side) or plate.diameter)) or 0.0 for side in ("width", "height"))
    top = subject.top
    if len(tie.at) == 3:
        hull = shapely.MultiPoint(
            np.column_stack([subject.corners @ subject.across, subject.corners[:, 2]])
        ).convex_hull
        station = float(np.dot(tie.at, subject.across))
        for s in (station - width / 2.0, station + width / 2.0):
            above = shapely.intersection(hull, shapely.LineString([(s, subject.hinge - 1.0), (s, top + 1.0)]))
            top = top if above.is_empty else min(top, float(above.bounds[3]))
    if plate is None:
        return top
    leaf = plate.leaf or float(np.ptp(subject.corners @ subject.along))
    return top - height / 2.0 - leaf


def _rises(study: Study, kind: TargetKind) -> bool:
    """Return whether more of a measure is better; raise ProjectError for an index that cannot be searched."""
    if kind != "index":
        return False
    require_spectrum(study)
    basis = study.question.basis
    if basis is None:
        raise ProjectError('verdict.basis: missing; an index needs one, such as basis = "asce43-05"')
    _, missing = find_limit_states(study.question)
    if missing:
        raise ProjectError(f"{missing[0].key}: {missing[0].text}")
    if by_histories := [name for name in methods_of(study.question) if uses_histories(name)]:
        raise ProjectError(
            f"target index: it is found by {by_histories[0]}, and could not be proved on records that the search "
            "did not see; write --target ratio or probability, or name a static method in [verdict] procedures"
        )
    return basis.index.value != "D/C"


def _ground_motions(
    study: Study, question: RetrofitQuestion, designs: _Designs, *, jobs: int
) -> tuple[tuple[ScaledRecord, ...], tuple[ScaledRecord, ...], float, float]:
    """Return the records of the search and of the proof, and the PGA of the action and of the site [m/s2]."""
    spectrum = require_spectrum(study)
    for name in designs.mechanisms:
        if study.heights[name].above and not isinstance(study.amplified[name].amplification, ModalFilter):
            raise ProjectError(
                f"mechanisms.{name}: stands above the ground, whose motion can fail it and cannot pass it; write "
                'amplification = { method = "modal-filter" }'
            )
    motions = motions_of(study, spectrum, jobs=jobs)
    seen, left = split_by_event(motions, question.search_records)
    if question.target == "probability" and upper_share(0, len(left)) > question.reach:
        raise ProjectError(
            f"reach = {question.reach:g}: of {len(left)} records that prove it none may overturn and the upper end is "
            f"{upper_share(0, len(left)):.3f}, above it; give more records, or fewer to the search"
        )
    states, missing = find_limit_states(study.question)
    lacking = [*missing, *filter(None, (missing_action(each, study.question.action) for each in states[:1]))]
    if lacking:
        raise ProjectError(f"{lacking[0].key}: {lacking[0].text}")
    at_states = {} if study.hazard is None else study.hazard.spectra
    own = next((at_states[each.name] for each in states if each.name in at_states), spectrum)
    return tuple(motions[k] for k in seen), tuple(motions[k] for k in left), own.pga, spectrum.pga


def _conditions(designs: _Designs) -> Iterator[Message]:
    """Yield what the engineer has to see to, as no layout was refused for it."""
    if designs.has_ties and not designs.has_plates:
        yield note("retrofit-anchors", "mechanisms")
    if designs.farthest > CLOSE:
        yield warning("retrofit-spacing-allowed", "mechanisms", spacing=Quantity(designs.farthest, "length", 3))


def _as_written(
    found: Found, project: Project, designs: _Designs, target: Target, *, jobs: int
) -> tuple[Found, str, list[Message]]:
    """Return what was found, and verdict and messages of the project with the best works; none where it falls short.

    Values that no source vouches for are replaced there for an index, as in a run; of histories they are named.
    """
    study = build_to_decide(project)
    messages = []
    before = {each.name: each.direction for each in designs.built_mechanisms}
    for each in study.mechanisms:
        if each.name in designs.mechanisms and before.get(each.name) != each.direction:
            messages.append(warning("retrofit-direction", f"mechanisms.{each.name}.direction"))
    if target.kind != "index":
        typed = [each for each in study.replaceables if not each.source and {*each.mechanisms} & {*designs.mechanisms}]
        if typed:
            keys = ", ".join(dict.fromkeys(each.key for each in typed))
            messages.append(warning("retrofit-as-typed", "report.sources", keys=keys))
        if target.kind == "probability" and found.tried > 1:
            messages.append(warning("retrofit-tried", "records", number=whole_number(found.tried)))
        return found, "", messages
    verdict = find_outcome(study, jobs=jobs or 1)
    short = [each for each in _indices(verdict).items() if not target.holds(Reached(each[1]))]
    if others := [name for name, _ in short if name not in designs.mechanisms]:
        messages.append(warning("retrofit-others", "mechanisms", mechanisms=", ".join(others)))
    if any(name in designs.mechanisms for name, _ in short):
        lacking = [each.key for each in verdict.overrides if not each.source]
        messages.append(warning("retrofit-unsourced", "report.sources", keys=", ".join(lacking) or "report.sources"))
        return replace(found, best=None), verdict.outcome.value, messages
    return found, verdict.outcome.value, messages


def _indices(verdict: Verdict) -> dict[str, float | None]:
    """Return the worst index of each mechanism; None where one is not known."""
    found: dict[str, float | None] = {}
    for each in verdict.mechanisms:
        values = [None if answer.index is None else answer.index for answer in each.answers]
        known = [index for index in values if index is not None]
        least = bool(known) and known[0].name != "D/C"
        numbers = [index.value for index in known]
        found[each.mechanism] = None if len(known) < len(values) or not known else (min if least else max)(numbers)
    return found


def _relocated(tables: Tables, project: Project, folder: Path) -> Tables:
    """Return tables whose paths, which are relative to the project file, are relative to another folder."""
    changed: Any = tables
    for path in _path_keys((), project.content):
        changed = _with_paths(changed, path, project.folder, folder)
    return changed  # type: ignore[no-any-return]


def _path_keys(path: tuple[str | int, ...], value: Any) -> Iterator[tuple[str | int, ...]]:
    """Yield the keys at which content has a path or a list of paths."""
    if isinstance(value, Path) or (
        isinstance(value, tuple) and value and all(isinstance(each, Path) for each in value)
    ):
        yield path
    elif isinstance(value, ProjectSection | Mapping):
        entries = value.entries() if isinstance(value, ProjectSection) else value
        for key, each in entries.items():
            yield from _path_keys((*path, key), each)
    elif isinstance(value, tuple):
        for number, each in enumerate(value):
            yield from _path_keys((*path, number), each)


def _with_paths(node: Any, path: Sequence[str | int], old: Path, new: Path) -> Any:
    """Return tables with the paths at a key as seen from another folder; as they are where the key is not there."""
    if not path:
        if isinstance(node, list):
            return [_seen_from(each, old, new) for each in node]
        return _seen_from(node, old, new)
    step, rest = path[0], path[1:]
    if isinstance(node, Mapping) and step in node:
        return {**node, step: _with_paths(node[step], rest, old, new)}
    if isinstance(node, list) and isinstance(step, int) and step < len(node):
        return [*node[:step], _with_paths(node[step], rest, old, new), *node[step + 1 :]]
    return node


def _seen_from(text: Any, old: Path, new: Path) -> Any:
    """Return a path or pattern of a file in one folder as a file in another has it."""
    if not isinstance(text, str) or Path(text).is_absolute():
        return text
    try:
        between = Path(os.path.relpath(old.absolute(), new.absolute())).as_posix()
    except ValueError:  # on another drive
        between = old.absolute().as_posix()
    if between == ".":
        return text
    literal = (old / text).exists() or not glob.has_magic(text)
    return f"{between if literal else glob.escape(between)}/{text}"
