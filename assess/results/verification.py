"""Solved cases run again on this machine, beside the values published for them: `assess verify`.

Values stand in the unit of the source, as it prints them. What cases exercise and projects use is written in one table
of words, those of the project file where it has one; by these a case concerns a project.
"""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from statistics import median
from typing import Literal

from assess.loads.load import LOADS
from assess.messages.message import Term
from assess.results.provenance import NO_MATTER, Input, Program, ReportMatter, ResolvedValue
from assess.short_repr import ShortRepr

VERIFICATION_VERSION = 1

Standing = Literal["published", "derived", "own arithmetic", "indicative"]
"""Where an expected value comes from: read in the source; from the formulas of the source, computed here another way;
arithmetic of our own that no source prints; or read in the source, while sizes or a reading of it were chosen here so
that they suit the values: such a case shows an order of size and is no evidence."""
ValueOutcome = Literal["pass", "misprint", "fail"]
CaseOutcome = Literal["pass", "fail"]


@dataclass(frozen=True, repr=False)
class Source(ShortRepr):
    """Where the expected values of a case come from.

    citation : the work, so that a reader can find it
    standing : what the values are
    place : pages, tables, equations; where the values were read
    """

    citation: str
    standing: Standing
    place: str


@dataclass(frozen=True, repr=False)
class Tolerance(ShortRepr):
    """How far a value may be from the expected one; give one of `absolute` and `relative`, or both for the larger.

    absolute : in the unit of the quantity
    relative : of the expected value [-]
    reason : why so much, as a sentence
    """

    reason: str
    absolute: float = 0.0
    relative: float = 0.0

    def around(self, expected: float) -> float:
        """Return the largest difference allowed from an expected value."""
        return max(self.absolute, self.relative * abs(expected))


@dataclass(frozen=True, repr=False)
class ValueResult(ShortRepr):
    """One value: expected, found, and whether they agree.

    row : which of the quantity, such as the name of a wall; "" for a single value
    expected : as the source prints it; found : None where the program gives none
    reading : likeliest reading of a misprint, with which `found` is compared; misprint : why it is taken to be one
    """

    row: str
    expected: float
    found: float | None
    outcome: ValueOutcome
    reading: float | None = None
    misprint: str = ""

    @property
    def reference(self) -> float:
        """What it is compared with: the reading of a misprint, else the expected value."""
        return self.expected if self.reading is None else self.reading

    @property
    def difference(self) -> float | None:
        """Found less what it is compared with, in the unit of the quantity."""
        return None if self.found is None else self.found - self.reference


@dataclass(frozen=True)
class Spread:
    """Median and largest of differences [-], None where there are none."""

    median: float | None
    worst: float | None


@dataclass(frozen=True, repr=False)
class QuantityResult(ShortRepr):
    """A quantity of a case, with its values; unit : as printed, "" for a ratio."""

    name: str
    unit: str
    tolerance: Tolerance
    values: tuple[ValueResult, ...]

    @property
    def shares(self) -> tuple[float, ...]:
        """Difference of each value over what its tolerance allows [-]; without a tolerance there is none."""
        allowed = ((each.difference, self.tolerance.around(each.reference)) for each in self.values)
        return tuple(abs(difference) / most for difference, most in allowed if difference is not None and most > 0.0)

    @property
    def relative(self) -> tuple[float, ...]:
        """Difference of each value over the largest of the quantity [-], which is no zero by cancellation."""
        largest = max((abs(each.reference) for each in self.values), default=0.0)
        found = (each.difference for each in self.values if each.difference is not None and largest > 0.0)
        return tuple(abs(difference) / largest for difference in found)


@dataclass(frozen=True, repr=False)
class CaseResult(ShortRepr):
    """A solved case, run again.

    key : its place among the cases, such as "housner_1963/free_rocking"
    theory : the equations it shows; field : where they hold
    uses : mechanisms, joints, procedures and spectra that it exercises, in the words of `assess.results.verification`
    inputs : the files that a user runs again, relative to the folder of cases
    fault : why it could not be run; "" if it was
    departures : what the source prints and the program does not give, a sentence each; none of it is among the values
    """

    key: str
    title: str
    theory: str
    field: str
    source: Source
    uses: tuple[str, ...]
    inputs: tuple[Input, ...]
    quantities: tuple[QuantityResult, ...]
    fault: str = ""
    departures: tuple[str, ...] = ()

    @property
    def outcome(self) -> CaseOutcome:
        """Pass if it ran, and every value agrees, those taken to be misprints with their reading."""
        return "fail" if self.fault or not self.values or any(v.outcome == "fail" for v in self.values) else "pass"

    @property
    def is_indicative(self) -> bool:
        """Whether it is no evidence, such as one whose model stands in figures only."""
        return self.source.standing == "indicative"

    @property
    def values(self) -> tuple[ValueResult, ...]:
        """The values of all its quantities."""
        return tuple(value for each in self.quantities for value in each.values)

    @property
    def misprints(self) -> int:
        """Number of printed values that are taken to be misprints."""
        return sum(each.reading is not None for each in self.values)

    @property
    def shares(self) -> tuple[float, ...]:
        """Differences over what the tolerance of each allows [-]."""
        return tuple(share for each in self.quantities for share in each.shares)

    @property
    def line(self) -> SolvedCase:
        """The case in one line."""
        worst, source = max(self.shares, default=None), self.source
        return SolvedCase(self.key, self.title, source.citation, source.standing, len(self.values), worst, self.outcome)


@dataclass(frozen=True, repr=False)
class SolvedCase(ShortRepr):
    """A solved case in one line.

    citation, standing : of its source; values : their number
    worst : largest difference over what its tolerance allows [-], None where values are exact
    """

    key: str
    title: str
    citation: str
    standing: Standing
    values: int
    worst: float | None
    outcome: CaseOutcome


@dataclass(frozen=True, repr=False)
class Coverage(ShortRepr):
    """A thing that a project uses, and the keys of the cases that exercise it; none: it stands without a case."""

    use: str
    cases: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class VerificationResults(ShortRepr):
    """The cases that were run, whole.

    quick : whether only the quick cases were
    coverage : what the project uses for which the cases were chosen; empty for all cases
    inputs : that project file; project : its values that the report needs, by key; report : its front matter
    left_out : keys of the program's cases that were to be run, with what the project uses, and were not
    foreign : keys of the cases whose files are not those of the program
    pdf_sha256 : of the PDF that was written with these results, "" if there is none
    seal : SHA-256 of these results as written, without the seal
    """

    schema_version: int
    program: Program
    quick: bool
    cases: tuple[CaseResult, ...]
    coverage: tuple[Coverage, ...] = ()
    inputs: tuple[Input, ...] = ()
    project: dict[str, ResolvedValue] = field(default_factory=dict)
    report: ReportMatter = NO_MATTER
    left_out: tuple[str, ...] = ()
    foreign: tuple[str, ...] = ()
    pdf_sha256: str = ""
    seal: str = ""

    @property
    def failures(self) -> tuple[CaseResult, ...]:
        """The cases that fail."""
        return tuple(each for each in self.cases if each.outcome == "fail")

    @property
    def evidence(self) -> tuple[CaseResult, ...]:
        """The cases that are more than indicative."""
        return tuple(each for each in self.cases if not each.is_indicative)

    @property
    def passed_uses(self) -> frozenset[str]:
        """What at least one case exercises that passes and is not only indicative."""
        return frozenset(word for each in self.evidence if each.outcome == "pass" for word in each.uses)

    @property
    def quantities(self) -> tuple[QuantityResult, ...]:
        """The quantities of all cases."""
        return tuple(each for case in self.cases for each in case.quantities)

    @cached_property
    def shares(self) -> Spread:
        """Differences of the evidence over what the tolerance of each allows [-]; values without one are left out."""
        return _spread_of(share for case in self.evidence for share in case.shares)

    @cached_property
    def relative(self) -> Spread:
        """Differences of the evidence over the largest value of the quantity [-]."""
        found = (each for case in self.evidence for each in case.quantities)
        return _spread_of(difference for each in found for difference in each.relative)

    @property
    def farthest(self) -> tuple[str, str]:
        """Key of the case and name of the quantity with the largest of these differences; empty where there is none."""
        found = [
            (max(each.relative), case.key, each.name)
            for case in self.evidence
            for each in case.quantities
            if each.relative
        ]
        return max(found)[1:] if found else ("", "")


@dataclass(frozen=True, repr=False)
class AnnexResult(ShortRepr):
    """The annex of verification that a run names.

    path : of verification.json, relative to the project file; sha256 : of it; pdf_sha256 : of the PDF beside it, "" if
        there is none
    program : that made it; cases, failures : their numbers; quick : whether only the quick cases were run
    uncovered : what the project uses, in the words of `assess.results.verification`, and no case that passes exercises;
        cases that are only indicative are not counted
    left_out, foreign : numbers of cases, as in `VerificationResults`; solved : its cases, a line each
    pdf_as_written : whether the PDF is there and the one that was written with the results
    """

    path: str
    sha256: str
    pdf_sha256: str
    program: Program
    cases: int
    failures: int
    quick: bool
    uncovered: tuple[str, ...]
    left_out: int = 0
    foreign: int = 0
    pdf_as_written: bool = True
    solved: tuple[SolvedCase, ...] = ()


CASES = Path(__file__).parents[1] / "verification" / "cases"
"""The folder of the program's solved cases, one TOML file for each; project files stand beside them."""

OF_A_CASE = frozenset({"source", "solver", "quantities"})
"""Keys of which a case has one and a project file none."""
KINDS = frozenset(
    {
        "single-block",
        "two-block",
        "four-hinge",
        "arch",
        "facade-with-wedges",
        "corner",
        "horizontal-arch",
        "equivalent-block",
    }
)
JOINTS = frozenset({"rigid", "crushing", "flexible", "semi-flexible", "flexible-thesis"})

ORDINARY = KINDS - {"arch"} | JOINTS - {"flexible-thesis"} | {"box", "exact", "linearised", "free motion"}
"""What so many cases exercise that it says little to share it."""


@cache
def exercised_by_case() -> Mapping[str, frozenset[str]]:
    """Return what each of the program's cases exercises, by key, read once in a process."""
    found = {}
    for path in sorted(CASES.rglob("*.toml")):
        text = path.read_text(encoding="utf-8")
        if "quantities" in text:  # a third of the files are projects, and parsing takes long
            content = tomllib.loads(text)
            if OF_A_CASE & content.keys():
                found[path.relative_to(CASES).with_suffix("").as_posix()] = frozenset(content["uses"])
    return found


def keys_for(exercised: Mapping[str, Collection[str]], uses: Collection[str]) -> frozenset[str]:
    """Return the keys of the cases that concern a project.

    A case is chosen where it shares with the project anything but what is ordinary, such as a procedure, a spectrum, a
    motion or a load; where it exercises a kind of mechanism of the project with one of its kinds of joint, and nothing
    out of the ordinary that the project does not use; or where no case chosen so far exercises what it shares.

    Parameters
    ----------
    exercised : by each case, by key
    uses : of the project; both in the words of `assess.results.verification`
    """
    used = frozenset(uses)
    chosen = {key for key, words in exercised.items() if _concerns(frozenset(words), used)}
    bare = used.difference(*(exercised[key] for key in chosen))
    return frozenset(chosen | {key for key, words in exercised.items() if not bare.isdisjoint(words)})


def _spread_of(differences: Iterable[float]) -> Spread:
    """Return the spread of differences."""
    found = tuple(differences)
    return Spread(median(found), max(found)) if found else Spread(None, None)


def _concerns(exercised: frozenset[str], used: frozenset[str]) -> bool:
    both, particular = exercised & used, exercised - ORDINARY
    return bool(particular & used) or (bool(both & KINDS and both & JOINTS) and not particular)


USES: Mapping[str, Term] = {
    # mechanisms
    "single-block": Term("one block that rocks about its base"),
    "two-block": Term("a wall held at base and top that opens at a crack between"),
    "four-hinge": Term("three blocks between two fixed hinges"),
    "arch": Term("an arch whose hinges are where it resists least"),
    "facade-with-wedges": Term("a wall that overturns with wedges of the walls behind it"),
    "corner": Term("a corner of two walls that turns outwards about its foot"),
    "horizontal-arch": Term("a panel that bulges out between cross walls as an arch in plan"),
    "equivalent-block": Term("a mechanism by its rocking parameters"),
    "one-sided": Term("rocking in one direction only, with rebound"),
    "free motion": Term("free rocking and its impacts"),
    # geometry
    "mesh": Term("a body from a mesh"),
    "profile": Term("a body extruded from a polygon"),
    "box": Term("a body that is a box"),
    "cut": Term("a body cut at an elevation or along an inclined crack"),
    # where a wall cracks, and what an impact leaves
    "crack sorrentino": Term("the height of the crack by the rule of Sorrentino"),
    "crack minimum": Term("the height of the crack of the least multiplier"),
    "restitution housner": Term("Housner’s restitution of one block (Mehrotra 3.44)"),
    "restitution sorrentino": Term("restitution about the new base hinge of a cracked wall (Mehrotra 3.46)"),
    "restitution one-sided": Term("rebound of one-sided rocking (Mehrotra 3.45)"),
    "restitution momentum": Term("the restitution from the balance of momentum with all masses"),
    # joints
    "rigid": Term("rigid joints"),
    "crushing": Term("crushing of a joint at its strength"),
    "flexible": Term("flexible joints without tension"),
    "semi-flexible": Term("flexible joints, with the inertia about a fixed hinge"),
    "flexible-thesis": Term("flexible joints, with the inertia about the resultant"),
    "rectangle": Term("a rectangular contact"),
    "hollow_rectangle": Term("a hollow rectangular contact"),
    "circle": Term("a circular contact"),
    "annulus": Term("a contact that is a ring"),
    "polygon": Term("a polygonal contact"),
    "outline": Term("a contact with the outline of the mesh"),
    # loads
    **{kind: load.term for kind, load in LOADS.items()},
    # motion
    "exact": Term("the exact equation of motion"),
    "linearised": Term("the linearised equation of motion"),
    "pulses": Term("pulses and overturning envelopes"),
    "records": Term("records read from files"),
    "synthetic": Term("artificial records"),
    "scaling": Term("records scaled to a spectrum"),
    "selection": Term("records selected out of many"),
    "response spectrum": Term("response spectra of records"),
    "amplification srss": Term("the motion at height by the first mode, SRSS"),
    "amplification srss-relative": Term("the motion at height by the first mode, relative motion by SRSS"),
    "amplification modal-filter": Term("the motion at height through the first mode"),
    "amplification ec8": Term("the floor factor of EN 1998-1"),
    "amplification ec8-resonance": Term("the floor factor of EN 1998-1 in resonance"),
    "amplification ec8-printed": Term("the floor factor as Mehrotra prints it"),
    "amplification nzs1170.5": Term("the floor factor of NZS 1170.5"),
    # site
    "asce7-05": Term("spectrum of ASCE 7-05"),
    "asce7-10": Term("spectrum of ASCE 7-10"),
    "asce7-16": Term("spectrum of ASCE 7-16"),
    "asce7-22": Term("spectrum of ASCE 7-22"),
    "ec8": Term("spectrum of EN 1998-1"),
    "nzs1170.5": Term("spectrum of NZS 1170.5"),
    "ts1170.5": Term("spectrum of TS 1170.5"),
    "ntc2008": Term("spectrum of NTC 2008"),
    "ntc2018": Term("spectrum of NTC 2018"),
    "hazard over return periods": Term("the hazard of a site at the return period of a limit state"),
    "table": Term("a spectrum given as a table"),
    # procedures
    "asce43-05-spectrum": Term("ASCE 43-05, by spectrum"),
    "asce43-05-spectrum-thesis": Term("ASCE 43-05, by spectrum, as Mehrotra reads it"),
    "asce43-05-history": Term("ASCE 43-05, by histories"),
    "asce43-05-sliding": Term("ASCE 43-05, sliding"),
    "dmi2008-linear": Term("Italian Guidelines with NTC 2008, linear"),
    "dmi2008-nonlinear": Term("Italian Guidelines with NTC 2008, non-linear"),
    "dmi2008-nonlinear-thesis": Term("Italian Guidelines with NTC 2008, non-linear, as Mehrotra reads it"),
    "dmi2008-history": Term("Italian Guidelines with NTC 2008, by histories"),
    "ntc2018-linear": Term("NTC 2018, linear"),
    "ntc2018-nonlinear": Term("NTC 2018, non-linear"),
    "ntc2018-history": Term("NTC 2018, by histories"),
    "nzsee2017-face-loaded": Term("NZSEE 2017, face-loaded walls"),
    "asce41-13-ht": Term("ASCE 41-13, limits of slenderness"),
    "ec8-element": Term("EN 1998-1, non-structural elements"),
    "sliding": Term("sliding by friction"),
    # beyond one answer
    "uncertainty": Term("answers under uncertain numbers"),
    "sensitivity": Term("answers under one number that varies"),
    "fragility": Term("fragility curves"),
    "risk": Term("annual rates from fragility and hazard"),
}
"""Each word with what it is."""
