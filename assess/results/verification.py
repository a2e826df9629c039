"""Solved cases run again on this machine, beside the values published for them: `assess verify`.

Values stand in the unit of the source, as it prints them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from statistics import median
from typing import Literal

from assess.results.inputs import Input, Program, ResolvedValue
from assess.results.report_matter import NO_MATTER, ReportMatter
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


def spread_of(differences: Iterable[float]) -> Spread:
    """Return the spread of differences."""
    found = tuple(differences)
    return Spread(median(found), max(found)) if found else Spread(None, None)


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
    uses : mechanisms, joints, procedures and spectra that it exercises, in the words of `assess.results.solved_cases`
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
        return spread_of(share for case in self.evidence for share in case.shares)

    @cached_property
    def relative(self) -> Spread:
        """Differences of the evidence over the largest value of the quantity [-]."""
        found = (each for case in self.evidence for each in case.quantities)
        return spread_of(difference for each in found for difference in each.relative)

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
    uncovered : what the project uses, in the words of `assess.results.solved_cases`, and no case that passes exercises;
        cases that are only indicative are not counted
    left_out, foreign : numbers of cases, as in `VerificationResults`
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
