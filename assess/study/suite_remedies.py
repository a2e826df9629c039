"""The changes of a project with which a suite of records would meet the rules of a code."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import ceil, floor

from assess.messages.message import Message, Quantity, Term, message, whole_number
from assess.study.study import Artificial, Study
from assess.study.suite_rules import HELD
from records.compliance.requirement import Requirement, Rule, factor_that_does
from records.compliance.suite import Suite
from records.spectral_fit import STATIONARY

DIGITS = 1000.0  # a factor is proposed to three decimals, rounded to the side that meets the rule
FILES = 'files = ["records/*.AT2"]'


NO_FACTOR = Term("no one factor does: choose records whose mean has the shape of the target")


@dataclass(frozen=True)
class Remedy:
    """A change of the project: its key, in words, and as a line of TOML, empty if there is none."""

    key: str
    text: Term | Message
    toml: str = ""


@dataclass(frozen=True)
class SuiteReview:
    """A suite with its study and the requirements of a code on it."""

    study: Study
    suite: Suite
    found: tuple[Requirement, ...]

    @property
    def unmet(self) -> tuple[Requirement, ...]:
        """The requirements that are not met."""
        return tuple(one for one in self.found if one.verdict == "not met")


def more_records(one: Requirement, review: SuiteReview) -> Remedy:
    """Propose as many more records as are missing."""
    missing = round(one.limit - (one.value or 0.0))
    number = {"number": whole_number(missing)}
    text = message("remedy-records", number) if missing > 1 else Term("give 1 more record")
    return _remake(text, review) or Remedy("records.files", text, FILES)


def longer_records(one: Requirement, review: SuiteReview) -> Remedy:
    """Propose artificial records of a longer duration."""
    text = message("remedy-longer", {"duration": Quantity(_duration(one, review), "time", 6)})
    return _remake(text, review) or Remedy("records.files", text)


def finer_records(one: Requirement, review: SuiteReview) -> Remedy:
    """Propose records of a smaller time step."""
    return Remedy("records.files", message("remedy-finer", {"step": Quantity(one.limit, "time", 6)}))


def other_records(one: Requirement, review: SuiteReview) -> Remedy:
    """Propose records that contain longer periods."""
    return Remedy("records.files", Term("give records whose processing kept longer periods"))


def another_factor(one: Requirement, review: SuiteReview) -> Remedy:
    """Propose one further factor on every record, times the one of the project; other records if no factor helps.

    Artificial records that are too short for the required periods are made longer instead.
    """
    if _duration(one, review):
        return longer_records(one, review)
    factor = factor_that_does(review.found)
    if factor is None:
        return Remedy("records.files", NO_FACTOR)
    rounded = ceil(factor * DIGITS) / DIGITS if factor > 1.0 else floor(factor * DIGITS) / DIGITS
    whole = review.study.record_factor * rounded
    text = message("remedy-factor", {"factor": Quantity(rounded, "ratio", 6)})
    return Remedy("records.factor", text, f"factor = {whole:.6g}")


REMEDIES: Mapping[Rule, Callable[[Requirement, SuiteReview], Remedy]] = {
    Rule.COUNT: more_records,
    Rule.STEP: finer_records,
    Rule.DURATION: longer_records,
    Rule.STATIONARY: longer_records,
    Rule.USABLE: other_records,
    Rule.MEAN_LOW: another_factor,
    Rule.MEAN_HIGH: another_factor,
    Rule.RUN_BELOW: another_factor,
}


def _remake(text: Term | Message, review: SuiteReview) -> Remedy | None:
    """Return the line that makes artificial records as all rules require; None if records come from files."""
    made = review.study.artificial
    if made is None:
        return None
    wanted = improve_artificial(made, review)
    line = f'synthetic = {{ count = {wanted.count}, seed = {wanted.seed}, duration = "{wanted.duration:g} s" }}'
    return Remedy("records.synthetic", text, line)


def improve_artificial(made: Artificial, review: SuiteReview) -> Artificial:
    """Return the artificial records with the number and the duration that the rules require."""
    few = [round(one.limit - (one.value or 0.0)) for one in review.unmet if one.rule == Rule.COUNT]
    long = [_duration(one, review) for one in review.unmet]
    return replace(made, count=made.count + max(few, default=0), duration=max([made.duration, *long]))


def _duration(one: Requirement, review: SuiteReview) -> float:
    """Return the duration [s] that a rule requires of artificial records, directly, by level part or by periods."""
    if one.rule == Rule.DURATION:
        return one.limit
    if one.rule == Rule.STATIONARY:
        return one.limit / STATIONARY
    made, end = review.study.artificial, 0.0 if one.periods is None else one.periods[1]
    return 0.0 if made is None or end * HELD <= made.duration else float(ceil(end * HELD))
