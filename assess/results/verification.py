"""Solved cases run again on this machine, beside the values published for them: `assess verify`.

Values stand in the unit of the source, as it prints them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from statistics import median
from typing import Any, ClassVar, Literal

from assess.results.inputs import Input, Program
from assess.short_repr import ShortRepr

VERIFICATION_VERSION = 1
STRICT: Any = {"extra": "forbid", "strict": True, "allow_inf_nan": False}
"""How the tables of a case are read: no unknown key, no text for a number, no number that is not finite."""
Standing = Literal["published", "derived", "own arithmetic"]
"""Where an expected value comes from: read in the source; from the formulas of the source, computed here another way;
or arithmetic of our own that no source prints."""
ValueOutcome = Literal["pass", "misprint", "fail"]
CaseOutcome = Literal["pass", "fail"]


@dataclass(frozen=True, repr=False)
class Source(ShortRepr):
    """Where the expected values of a case come from.

    citation : the work, so that a reader can find it
    standing : what the values are
    place : pages, tables, equations; where the values were read
    """

    __pydantic_config__: ClassVar = STRICT
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

    __pydantic_config__: ClassVar = STRICT
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
    reading : likeliest reading of a misprint, with which `found` is compared; misprint : why it is held for one
    """

    row: str
    expected: float
    found: float | None
    outcome: ValueOutcome
    reading: float | None = None
    misprint: str = ""

    @property
    def difference(self) -> float | None:
        """Found less what it is compared with, in the unit of the quantity."""
        reference = self.expected if self.reading is None else self.reading
        return None if self.found is None else self.found - reference


@dataclass(frozen=True, repr=False)
class QuantityResult(ShortRepr):
    """A quantity of a case, with its values; unit : as printed, "" for a ratio."""

    name: str
    unit: str
    tolerance: Tolerance
    values: tuple[ValueResult, ...]


@dataclass(frozen=True, repr=False)
class CaseResult(ShortRepr):
    """A solved case, run again.

    key : its place among the cases, such as "housner_1963/free_rocking"
    theory : the equations it shows; field : where they hold
    uses : mechanisms, joints, procedures and spectra that it exercises, in the words of `assess.results.uses`
    inputs : the files that a user runs again, relative to the folder of cases
    fault : why it could not be run; "" if it was
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

    @property
    def outcome(self) -> CaseOutcome:
        """Pass if it ran, and every value agrees, those held for misprints with their reading."""
        values = [value for each in self.quantities for value in each.values]
        return "fail" if self.fault or not values or any(each.outcome == "fail" for each in values) else "pass"


@dataclass(frozen=True, repr=False)
class Coverage(ShortRepr):
    """A thing that a project uses, and the keys of the cases that exercise it; none: it stands without a case."""

    use: str
    cases: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class VerificationResults(ShortRepr):
    """The cases that were run, whole.

    quick : whether only the quick cases were
    project : title of the project whose cases these are, "" for all; coverage : of what that project uses
    """

    schema_version: int
    program: Program
    quick: bool
    cases: tuple[CaseResult, ...]
    project: str = ""
    coverage: tuple[Coverage, ...] = ()

    @property
    def failures(self) -> tuple[CaseResult, ...]:
        """The cases that fail."""
        return tuple(each for each in self.cases if each.outcome == "fail")

    @cached_property
    def differences(self) -> tuple[float, ...]:
        """Difference of each value over what its tolerance allows [-]; exact values are left out."""
        return tuple(
            abs(value.difference) / allowed
            for case in self.cases
            for each in case.quantities
            for value in each.values
            if value.difference is not None
            and (allowed := each.tolerance.around(value.expected if value.reading is None else value.reading)) > 0
        )

    @property
    def median_difference(self) -> float | None:
        """Median of `differences` [-]; None if there are none."""
        return median(self.differences) if self.differences else None

    @property
    def worst_difference(self) -> float | None:
        """Largest of `differences` [-]; None if there are none."""
        return max(self.differences, default=None)
