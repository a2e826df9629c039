"""A project that is open: its parts and mechanisms, what the program says of them, and other values that are tried.

Every number is one that a run has too, found by the same functions of what would be in the file. While a value moves,
a mechanism is asked for its statics and for the checks by spectra; time histories follow when it rests.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from math import degrees
from pathlib import Path
from typing import Any

from assess.codes.check import Check
from assess.codes.procedures import uses_histories
from assess.codes.question import Missing, methods_of, toml_lines
from assess.codes.verdict import RANKS, MechanismVerdict, Verdict, at_action
from assess.errors import AssessError, OutputError, ProjectError
from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import CutAngle, CutPlane, Mechanism
from assess.mechanisms.single_block import SingleBlock
from assess.model.candidates import Candidate
from assess.outputs.writing import replace_file
from assess.project import sections
from assess.project.bars import with_bars
from assess.project.build import BuiltProject, build_to_decide, build_with_cases
from assess.project.found_mechanisms import FoundMechanisms, add_mechanisms, find_mechanisms
from assess.project.key_errors import KeyPath, key_text, look_up
from assess.project.keys import Setting, dependents, keyed_values, read_content, with_values
from assess.project.project_file import Project, load, load_tree, parse_toml
from assess.project.site_and_structure import definitions_of
from assess.project.toml_text import with_changes
from assess.results import MechanismResult
from assess.study.assessment import checks_without_twins
from assess.study.checks import decide
from assess.study.mechanism_results import parameters
from assess.study.rocking_motion import RockingMotion, governing_motion
from assess.study.run import CheckedMechanism, find_outcome
from assess.study.study import Study
from spectra.arrays import is_number
from spectra.errors import SpectrumError

LEVEL = 0.0005  # rad: a crack less inclined than this is written as an elevation
PLACES = frozenset({"direction", "cut", "crack", "profile", "base", "at", "anchor", "hinges", "point", "centroid"})
"""Keys of places and directions, which are not numbers to be varied one by one."""
CHANGED = "has changed since the page read it; nothing was written: reload it on the page"

PURE = frozenset({"ratio", "number"})
"""Kinds of quantities without a unit."""


@dataclass(frozen=True)
class ShownPart:
    """A part of the building: its name, what it is ("body" where that is not known), its surface."""

    name: str
    kind: str
    solid: Solid


@dataclass(frozen=True)
class ShownMechanism:
    """What is known of a mechanism.

    result : its parameters; None where it falls at rest or cannot be built
    checks : its answers by spectra; empty without a site
    verdict : its outcome as far as it is known
    fault : why it falls or cannot be built; empty otherwise
    mechanism : as it is built; None where it is not
    """

    name: str
    result: MechanismResult | None
    checks: tuple[Check, ...] = ()
    verdict: MechanismVerdict | None = None
    fault: str = ""
    mechanism: Mechanism | None = None


@dataclass(frozen=True)
class Number:
    """A number of the file on which a mechanism depends: its key, its value in SI and the unit, empty for none."""

    path: KeyPath
    value: float
    unit: str

    @property
    def text(self) -> str:
        """The key as users write it."""
        return key_text(self.path)

    def file_value(self, value: float) -> Any:
        """Return another value of it as the project file writes it."""
        return f"{value:.6g} {self.unit}" if self.unit else float(f"{value:.6g}")


class OpenedProject:
    """A project and the values that are tried on it."""

    def __init__(self, path: Path) -> None:
        self.changes: tuple[Setting, ...] = ()
        self._written: list[tuple[bytes, bytes]] = []
        self.read(path)

    def read(self, path: Path | None = None) -> None:
        """Read the project anew, and forget what was tried.

        Raises
        ------
        AssessError, SpectrumError or RecordError : it cannot be assessed
        """
        self.project: Project = load(path or self.project.path)
        self._built: BuiltProject = build_with_cases(self.project)
        self.changes = ()
        self.verdict: Verdict | None = None
        self.found: FoundMechanisms | None = None
        self.is_searched = False
        self._results = {each.name: each for each in parameters(self._built.study)}

    @property
    def title(self) -> str:
        """The title of the project, or the name of its folder."""
        return self.project.content.title or self.project.folder.name

    @property
    def study(self) -> Study:
        """The study of the project as its file has it."""
        return self._built.study

    @property
    def methods(self) -> tuple[str, ...]:
        """The procedures that may decide."""
        return methods_of(self.study.question)

    @property
    def by_histories(self) -> bool:
        """Whether one of the procedures that may decide follows time histories."""
        return any(map(uses_histories, self.methods))

    @property
    def proposed(self) -> Sequence[Candidate]:
        """The mechanisms that were found on the bodies and are not in the file."""
        return () if self.found is None else self.found.new

    def parts(self) -> Iterator[ShownPart]:
        """Yield every part of the building."""
        known: set[str] = set()
        if self.found is not None:
            for part in self.found.structure.parts:
                known.add(part.name)
                yield ShownPart(part.name, part.kind, part.solid)
        for name, solid in self._built.solids.items():
            if solid is not None and not any(each == name or each.startswith(f"{name} ") for each in known):
                yield ShownPart(name, "body", solid)

    def rank(self) -> tuple[str, ...]:
        """Return the mechanisms of the file, the worst first: by outcome and margin, then by multiplier."""
        falling = {each.name for each in self.study.falling}

        def badness(name: str) -> tuple[float, ...]:
            found, result = self._verdict_of(name), self._results.get(name)
            multiplier = None if result is None else result.oscillator.uplift_multiplier
            least = float("inf") if multiplier is None else multiplier
            if found is None:
                return (-float(name in falling), 0.0, least)
            margin = float("inf") if found.margin is None else found.margin
            return (-float(RANKS.index(found.outcome)), margin, least)

        return tuple(sorted(self.project.content.mechanisms, key=badness))

    def outline(self, name: str) -> ShownMechanism:
        """Return a mechanism as the file has it, without its checks."""
        falls = next((f"falls at rest: {each.reason}" for each in self.study.falling if each.name == name), "")
        built = next((each for each in self.study.mechanisms if each.name == name), None)
        return ShownMechanism(name, self._results.get(name), (), self._verdict_of(name), falls, built)

    def find_others(self) -> None:
        """Find what the parts of the building are, and the mechanisms that they can have beside those of the file."""
        project = self.project
        found = _found(project)
        if self.project is project:
            self.found, self.is_searched = found, True

    def find_outcome(self) -> Verdict | None:
        """Find the verdict of the project as its file has it, and keep it; None without a site."""
        project = self.project
        if self.study.spectrum is not None:
            found = find_outcome(build_to_decide(project), jobs=0)
            self.verdict = found if self.project is project else None
        return self.verdict

    def examine(self, name: str, *, histories: bool = False) -> ShownMechanism:
        """Return a mechanism with the values that are tried.

        Parameters
        ----------
        name : of the mechanism
        histories : whether its outcome is found too, by time histories where these decide
        """
        if not self.changes:
            mechanisms = tuple(each for each in self.study.mechanisms if each.name == name)
            return replace(self.outline(name), checks=_checks_by_spectra(replace(self.study, mechanisms=mechanisms)))
        try:
            study = self._built.study_at(self._content(), (name,))
            (result,) = parameters(study)
            checks = _checks_by_spectra(study)
            verdict = None
            if study.spectrum is not None and (histories or not self.by_histories):
                found = find_outcome(study, jobs=0) if histories else decide(study, [CheckedMechanism(name, checks)])
                verdict = next(each for each in found.mechanisms if each.mechanism == name)
        except (AssessError, SpectrumError) as error:
            return ShownMechanism(name, None, fault=str(error))
        return ShownMechanism(name, result, checks, verdict, mechanism=study.mechanisms[0])

    def motion(self, name: str) -> RockingMotion | None:
        """Return how a mechanism moves under the record that governs, with what is tried; None where none is answered.

        Raises
        ------
        AssessError, SpectrumError or RecordError : it cannot be followed
        """
        return governing_motion(self._built.study_at(self._content(), (name,)))

    def numbers(self, name: str) -> tuple[Number, ...]:
        """Return the numbers that the file gives and a mechanism depends on, as they are tried, but for places.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        content = self._content()
        return tuple(
            Number(
                each.path, float(each.value), "" if each.kind is None or each.kind.name in PURE else each.kind.symbol
            )
            for each in keyed_values(content).values()
            if each.path[0] in ("materials", "bodies", "mechanisms")
            and is_number(each.value)
            and PLACES.isdisjoint(each.path)
            and look_up(self.project.raw, each.path)[0]
            and name in dependents(content, each.path[:2])
        )

    def cut_of(self, name: str) -> CutAngle | None:
        """Return the crack of a mechanism of one block, as it is tried, by point and angle; None where none moves it.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        definition, result = definitions_of(self._content()).get(name), self._results.get(name)
        if not isinstance(definition, SingleBlock) or result is None or result.view is None:
            return None
        cut = definition.cut
        if isinstance(cut, CutPlane):
            return None
        if isinstance(cut, CutAngle):
            return cut
        x, y, z = ((a + b) / 2.0 for a, b in zip(*result.view.axes[0].ends, strict=True))
        return CutAngle((x, y, z if cut is None else cut), 0.0)

    def move_cut(self, name: str, point: Sequence[float], angle: float) -> None:
        """Try another crack.

        Parameters
        ----------
        name : of the mechanism
        point : of the crack [x, y, z] [m]
        angle : from the horizontal, positive where it falls towards the direction [rad]
        """
        at = [round(float(each), 4) + 0.0 for each in point]
        cut: Any = f"{at[2]:.6g} m"
        if abs(angle) > LEVEL:
            cut = {"point": at, "angle": f"{degrees(angle):.2f} deg"}
        self.change({("mechanisms", name, "cut"): cut})

    def change(self, setting: Setting) -> None:
        """Try other values at some keys; the same keys again take the place of those tried last."""
        setting = with_bars(setting, self.project.content)
        kept = self.changes[:-1] if self.changes and self.changes[-1].keys() == setting.keys() else self.changes
        self.changes = (*kept, setting)

    def add_lines(self, missing: Missing, text: str) -> None:
        """Try a line for what is missing.

        Raises
        ------
        ProjectError : it is no TOML
        """
        heading = next(iter(toml_lines([missing], ())), "")
        try:
            tables = tomllib.loads(f"{heading}\n{text}\n")
        except tomllib.TOMLDecodeError as error:
            raise ProjectError(f"{missing.key}: {text!r:.60}: {error}; write it as the example shows") from None
        self.change(dict(_leaves((), tables)))

    def undo(self) -> str:
        """Take back what was tried last, or else what was written last; return what was done.

        Raises
        ------
        ProjectError : the file has changed since it was written
        """
        if self.changes:
            self.changes = self.changes[:-1]
            return "taken back"
        if not self._written:
            return "nothing to take back"
        before, after = self._written[-1]
        self._replace(after, before)
        self._written.pop()
        self.read()
        return "the file is as it was before"

    def write(self) -> str:
        """Write what is tried into the project file, whose comments stay; return what was done.

        Raises
        ------
        ProjectError : the file has changed since it was read, or would no longer be read; nothing is written then
        """
        if not self.changes:
            return "nothing to write"
        before = self._unchanged_bytes()
        text = before.decode("utf-8-sig")
        tables = parse_toml(text)
        for setting in self.changes:
            tables = dict(with_values(tables, setting, self.project.content))
        load_tree(dict(tables), self.project.path, sha256="")
        made, kept = with_changes(text, tables)
        after = made.encode()
        self._replace(before, after)
        self._written.append((before, after))
        self.read()
        return f"written into {self.project.path.name}" + ("" if kept else ", without its comments")

    def add_found(self) -> str:
        """Write the mechanisms that were found and are not in the file at its end; return what was done."""
        if self.found is None or not self.found.new:
            return "nothing to add"
        before = self._unchanged_bytes()
        names = add_mechanisms(self.project, self.found)
        self._written.append((before, self.project.path.read_bytes()))
        self.read()
        return f"{len(names)} added to {self.project.path.name}"

    def _content(self) -> sections.Content:
        """Return the project with what is tried, and with the directions that its mechanisms have."""
        directed, raw = self._built.project, self._built.project.raw
        for setting in self.changes:
            raw = with_values(raw, setting, directed.content)
        return read_content(raw, directed.folder)

    def _verdict_of(self, name: str) -> MechanismVerdict | None:
        found = () if self.verdict is None else self.verdict.mechanisms
        return next((each for each in found if each.mechanism == name), None)

    def _unchanged_bytes(self) -> bytes:
        found = self.project.path.read_bytes()
        if sha256(found).hexdigest() != self.project.sha256:
            raise ProjectError(f"{self.project.path}: {CHANGED}")
        return found

    def _replace(self, before: bytes, after: bytes) -> None:
        path = self.project.path
        try:
            with replace_file(
                path, command="assess serve", is_replaceable=lambda there: there.read_bytes() == before
            ) as made:
                made.write_bytes(after)
        except OutputError:
            if path.exists() and path.read_bytes() != before:
                raise ProjectError(f"{path}: {CHANGED}") from None
            raise


def deciding_checks(checks: Sequence[Check], study: Study) -> tuple[Check, ...]:
    """Return the checks by the methods that may decide, at the action of the site."""
    methods, action = methods_of(study.question), study.question.action
    return tuple(each for each in checks if each.procedure in methods and at_action(each, action))


def _found(project: Project) -> FoundMechanisms | None:
    """Find what the bodies of a project can do; None where nothing in it is drawn as a building is."""
    try:
        return find_mechanisms(project)
    except (AssessError, SpectrumError):
        return None


def _checks_by_spectra(study: Study) -> tuple[Check, ...]:
    """Return the checks of a study of one mechanism without time histories; none without a site."""
    if study.spectrum is None or not study.mechanisms:
        return ()
    asked = tuple(each for each in study.procedures if not uses_histories(each))
    return checks_without_twins(replace(study, procedures=asked), study.spectrum, (), jobs=1)


def _leaves(path: KeyPath, tables: Mapping[str, Any]) -> Iterator[tuple[KeyPath, Any]]:
    for name, value in tables.items():
        below = [*_leaves((*path, name), value)] if isinstance(value, dict) else []
        yield from below or [((*path, name), value)]
