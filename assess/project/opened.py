"""A project that is open: its parts and mechanisms, what is tried on it, and what the program says of both.

Every number is found by the functions that a run calls, of what would be in the file.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from assess.codes.procedures import uses_histories
from assess.codes.question import SOURCES, Missing, methods_of
from assess.codes.verdict import RANKS, Override, State, Verdict
from assess.errors import AssessError
from assess.geometry.solid import Solid
from assess.model.candidates import Candidate
from assess.model.weakest_crack import WeakestCrack
from assess.project.build import BuiltProject, build_with_cases
from assess.project.dragged import Crack, crack_entry, crack_of, end_value, tie_ends
from assess.project.drawn_project import remarks_of_model
from assess.project.edited import EditedProject, Number
from assess.project.found_mechanisms import FoundMechanisms, find_mechanisms
from assess.project.key_errors import KeyPath, key_text
from assess.project.project_file import Project
from assess.project.site_and_structure import definitions_of
from assess.project.trials import Decider, Decision, ShownMechanism, try_mechanism, weakest_crack
from assess.results import EnvelopeResult, Place
from assess.study.envelopes import envelope_of
from assess.study.mechanism_results import parameters
from assess.study.rocking_motion import RockingMotion, governing_motion
from assess.study.study import Study
from records.errors import RecordError
from spectra.errors import SpectrumError

SITE = Missing(
    "site.spectrum",
    "without an action there are multipliers alone; here by the hazard of NTC 2018, whose dots are to be filled in",
    """\
[site.spectrum]
code = "ntc2018"
nominal_life = 50
use_class = "II"
soil = "…"
hazard = [
  { return_period = 50, a_g = "… g", f_0 = "…", t_c_star = "… s" },
  { return_period = 475, a_g = "… g", f_0 = "…", t_c_star = "… s" },
  { return_period = 975, a_g = "… g", f_0 = "…", t_c_star = "… s" },
]
[procedures.ntc2018]
knowledge_level = "LC1\"""",
)
NOT_VOUCHED = "the verdict is of what holds without these values; say who vouches for each, and delete the other lines"


@dataclass(frozen=True)
class ShownPart:
    """A part of the building: its name, what it is ("body" where that is not known), its surface."""

    name: str
    kind: str
    solid: Solid


class OpenedProject:
    """A project, the values that are tried on it, and what is known of both.

    edited : the file and what is tried
    decision : what a run decides, of the file and what was tried at the revision `decided_of`; None if not known
    found : the parts of the building and what they can do, once `is_searched`
    remarks : what the reading of the model warned of and left out, of a project that was drawn from one
    """

    def __init__(self, path: Path) -> None:
        self.edited = EditedProject(path)
        self.refresh()

    def read(self) -> str:
        """Read the project anew, and forget what was tried.

        Raises
        ------
        AssessError, SpectrumError or RecordError : it cannot be assessed
        """
        self.edited.read()
        self.refresh()
        return "read again"

    def refresh(self) -> None:
        """Build the project as its file was read, and forget what is known of what it was before."""
        self._built: BuiltProject = build_with_cases(self.edited.project)
        self._decider = Decider(self._built)
        self.built_of: Project = self.edited.project
        self.decision: Decision | None = None
        self.decided_of: int | None = None
        self._refused: tuple[int, str] = (-1, "")
        self.found: FoundMechanisms | None = None
        self.is_searched = False
        self.remarks = remarks_of_model(self.built_of.path.read_text(encoding="utf-8-sig"))
        self._results = {each.name: each for each in parameters(self._built.study)}

    @property
    def is_decided(self) -> bool:
        """Whether the decision that is known is of what is tried now."""
        return self.decided_of == self.edited.revision

    @property
    def why_undecided(self) -> str:
        """Why what is tried now cannot be decided; empty as long as that is not known."""
        revision, why = self._refused
        return why if revision == self.edited.revision else ""

    @property
    def title(self) -> str:
        """The title of the project, or the name of its folder."""
        return self.edited.project.content.title or self.edited.project.folder.name

    @property
    def study(self) -> Study:
        """The study of the project as its file has it."""
        return self._built.study

    @property
    def has_site(self) -> bool:
        """Whether there is an action to decide on."""
        return self.study.spectrum is not None

    @property
    def verdict(self) -> Verdict | None:
        """The verdict that is known."""
        return None if self.decision is None else self.decision.verdict

    @property
    def missing(self) -> tuple[Missing, ...]:
        """What the verdict lacks, and sources of what it replaces, those with a line first; without a site that."""
        if not self.has_site:
            return (SITE,)
        found = self.verdict
        if found is None:
            return ()
        keys = {f'"{each.key}"' for each in found.missing}  # whose source is stated beside them
        lacking = [each for each in found.missing if each.toml.partition(" = ")[0] not in keys]
        if self.replacements():
            lines = "\n".join(f'"{each.key}" = "measured: …"' for each in self.replacements())
            lacking.append(Missing(SOURCES, NOT_VOUCHED, lines))
        return tuple(sorted(lacking, key=lambda each: not each.toml))

    def replacements(self, name: str = "") -> list[Override]:
        """Return the values that the verdict replaces as no source vouches for them; of a mechanism, not of others."""
        found = self.verdict
        if found is None or found.state != State.REPLACED:
            return []
        others = [each for each in self.built_of.content.mechanisms if name not in ("", each)]
        tables = tuple(key_text(("mechanisms", each)) + "." for each in others)
        return [each for each in found.overrides if not each.source and not each.key.startswith(tables)]

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
        """The mechanisms that were found on the bodies and are not in the file, the weakest first."""
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

        def badness(name: str) -> tuple[float, ...]:
            shown = self.outline(name)
            multiplier = None if shown.result is None else shown.result.oscillator.uplift_multiplier
            least = float("inf") if multiplier is None else multiplier
            if shown.verdict is None:
                return (-float(bool(shown.fault)), 0.0, least)
            margin = float("inf") if shown.verdict.margin is None else shown.verdict.margin
            return (-float(RANKS.index(shown.verdict.outcome)), margin, least)

        return tuple(sorted(self.built_of.content.mechanisms, key=badness))

    def outline(self, name: str) -> ShownMechanism:
        """Return a mechanism as it was decided last, or else as the file has it, without its checks."""
        if self.decision is not None and name in self.decision.shown:
            return self.decision.shown[name]
        falls = next((f"falls at rest: {each.reason}" for each in self.study.falling if each.name == name), "")
        built = next((each for each in self.study.mechanisms if each.name == name), None)
        return ShownMechanism(name, self._results.get(name), fault=falls, mechanism=built)

    def heading(self, name: str) -> str:
        """Return the label of a mechanism after the number that it has in the report once what is tried is written."""
        if self.is_decided and self.decision is not None:
            results = self.decision.results
            names = [*(each.name for each in results.mechanisms), *(each.name for each in results.falling)]
        else:
            struck = self.edited.tried_value(("report", "struck_out")) or ()
            falling = {each.name for each in self.study.falling}
            kept = (each for each in self.built_of.content.mechanisms if each not in struck)
            names = sorted(kept, key=lambda each: each in falling)
        label = self.built_of.content.mechanisms[name].label or name
        return f"M{names.index(name) + 1} {label}" if name in names else f"{label} (struck out)"

    def find_others(self) -> None:
        """Find what the parts of the building are, and the mechanisms that they can have beside those of the file."""
        project = self.built_of
        try:
            found = find_mechanisms(project)
        except (AssessError, SpectrumError):  # nothing in it is drawn as a building is
            found = None
        if self.built_of is project:
            self.found, self.is_searched = found, True

    def find_outcome(self) -> Verdict | None:
        """Find what a run decides once what is tried is written, and keep it; None without a site.

        Raises
        ------
        AssessError, SpectrumError or RecordError : as a run of it
        """
        revision, decider = self.edited.revision, self._decider
        if self.has_site and not self.is_decided:
            try:
                found = decider.decide(self.edited.tried_project() if self.edited.changes else self.built_of)
            except (AssessError, SpectrumError, RecordError) as error:
                self._refused = revision, str(error)
                raise
            if self.edited.revision == revision and self._decider is decider:
                self.decision, self.decided_of = found, revision
        return self.verdict

    def examine(self, name: str) -> ShownMechanism:
        """Return a mechanism with what is tried: as a run decides where that is known, else as typed."""
        if self.is_decided and self.decision is not None and name in self.decision.shown:
            return self.decision.shown[name]
        if not self.edited.changes and self.outline(name).fault:
            return self.outline(name)
        try:
            content = self.edited.content(self._built.project)
        except AssessError as error:
            return ShownMechanism(name, None, fault=str(error))
        if name in content.report.struck_out:
            return replace(self.outline(name), fault=f"struck out: {content.report.struck_out[name]}", verdict=None)
        return try_mechanism(self._built, content, name)

    def numbers(self, name: str) -> tuple[Number, ...]:
        """Return the numbers that the file gives and a mechanism depends on, as they are tried, but for places.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        return self.edited.numbers(name, self._built.project)

    def cut_of(self, name: str) -> Crack | None:
        """Return the crack of a mechanism, as it is tried; None where none can be moved.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        return crack_of(self._definition_of(name), self._results.get(name))

    def move_cut(self, name: str, point: Sequence[float], angle: float, *, goes_on: bool = False) -> None:
        """Try another crack: a point of it [x, y, z] [m], and its angle as `Crack` has it [rad]."""
        before, (x, y, z) = self.cut_of(name), point
        if before is not None:
            key, value = crack_entry(
                name,
                before,
                replace(before, point=(x, y, z), angle=angle),
                written=self.edited.tried_value(("mechanisms", name)),
                along=self._direction_of(name),
            )
            self.edited.change({key: value}, goes_on=goes_on)

    def tie_ends(self, name: str) -> dict[KeyPath, Place]:
        """Return the ends of the ties of a mechanism in space [m], as they are tried, by their keys.

        Raises
        ------
        ProjectError : what is tried cannot be read
        """
        return tie_ends(name, self._definition_of(name), self._results.get(name))

    def move_end(self, key: KeyPath, at: Sequence[float], *, goes_on: bool = False) -> None:
        """Try another end of a tie: its key, and where it is to be [x, y, z] [m]."""
        value = end_value(at, self.edited.tried_value(key), self._direction_of(str(key[1])))
        self.edited.change({key: value}, goes_on=goes_on)

    def _definition_of(self, name: str) -> object:
        return definitions_of(self.edited.content(self._built.project)).get(name)

    def _direction_of(self, name: str) -> Place:
        view = self._results[name].view if name in self._results else None
        return (1.0, 0.0, 0.0) if view is None else view.direction

    def find_weakest_crack(self, name: str, progress: Callable[[int], object]) -> WeakestCrack:
        """Find the weakest crack of a mechanism of one block with what is tried; progress: as of the search."""
        return weakest_crack(self._built, self.edited.content(self._built.project), name, progress)

    def envelope(self, name: str) -> EnvelopeResult | None:
        """Return the overturning envelope of a mechanism with what is tried; None where it has none."""
        return None if self.examine(name).fault else envelope_of(self._study_of(name))

    def motion(self, name: str) -> RockingMotion | None:
        """Return how a mechanism moves under the record that governs, with what is tried; None where none is answered.

        Raises
        ------
        AssessError, SpectrumError or RecordError : it cannot be followed
        """
        return None if self.examine(name).fault else governing_motion(self._study_of(name))

    def _study_of(self, name: str) -> Study:
        """Return the study of one mechanism with what is tried, in the state that decides where that is known."""
        known = self.decision if self.is_decided else None
        if known is not None and name in known.decided.of:
            return known.decided.of[name].study
        return self._built.study_at(self.edited.content(self._built.project), (name,))

    def state_front(self, key: str, text: str) -> None:
        """Try a text of the report's front matter, as `EditedProject.state_front`; what is decided stays so."""
        known = self.is_decided
        try:
            self.edited.state_front(key, text)
        finally:
            self.decided_of = self.edited.revision if known else self.decided_of

    def write(self) -> str:
        """Write what is tried into the file, as long as the project can then be assessed; return what was done.

        Raises
        ------
        AssessError, SpectrumError or RecordError : it cannot, or the file has changed; nothing is written then
        """
        if self.edited.changes and not self.is_decided:
            self._built.study_to_decide(self.edited.tried_project())
        return self.edited.write()

    def add_found(self) -> str:
        """Write the mechanisms that were found and are not in the file at its end; return what was done."""
        return self.edited.add_found(self.found)
