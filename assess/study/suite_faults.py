"""What a suite of records misses of the rules of a code, each with the change of the project that would do."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import ceil, floor

from assess.codes.families import SUITE_CODES
from assess.codes.verdict import methods_of
from assess.messages.message import Message, Quantity, Severity, Value, message, whole_number
from assess.study.motions import ScaledRecord
from assess.study.study import Artificial, Study
from assess.study.suite_rules import HELD, RULES, spectrum_of_rules
from records.compliance.requirement import Requirement, Rule, factor_that_does
from records.compliance.suite import Suite, suite_of
from records.spectral_fit import STATIONARY
from spectra.spectrum import Spectrum

DIGITS = 1000.0  # a factor is proposed to three decimals, rounded to the side that does
WHOLE = (Rule.COUNT, Rule.RUN_BELOW)
DIMENSIONS: Mapping[str, str] = {"s": "time", "-": "ratio"}
FILES = 'files = ["records/*.AT2"]'


@dataclass(frozen=True)
class Remedy:
    """A change that would do: its key in the project file, in words, and as a line of TOML, empty where none can be."""

    key: str
    text: str
    toml: str = ""


@dataclass(frozen=True)
class SuiteReview:
    """A suite with the project that it is of, and all that its code asks."""

    study: Study
    suite: Suite
    found: tuple[Requirement, ...]

    @property
    def unmet(self) -> tuple[Requirement, ...]:
        """What it misses."""
        return tuple(one for one in self.found if one.verdict == "not met")


def suite_faults(
    study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]
) -> Mapping[str, tuple[Message, ...]]:
    """Find by code the rules for suites that the records miss; an empty tuple where they meet them all.

    Also of codes whose histories nobody asks for: a floor spectrum is made of the same suite.
    """
    return {code: tuple(_faults(code, study, spectrum, motions)) for code in RULES}


def _faults(code: str, study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    if not motions:
        yield _message("suite-empty", {}, Remedy("records.files", "give records", FILES))
        return
    rules, target = RULES[code], spectrum_of_rules(code, study, spectrum)
    suite = suite_on(motions, spectrum, target)
    shortest, longest = rules.periods(study)
    judged = SuiteReview(study, suite, rules.requirements(suite, shortest=shortest, longest=longest))
    yield from _not_named(code, judged)
    yield from (_unmet_message(one, REMEDIES[one.rule](one, judged)) for one in judged.unmet)
    yield from (_out_of_reach(one, judged) for one in judged.found if one.verdict == "not answered")


def suite_on(motions: Sequence[ScaledRecord], spectrum: Spectrum, target: Spectrum) -> Suite:
    """The suite as it is run for the limit state of `target`, at the PGA of that, not at the site's."""
    share = target.pga / spectrum.pga
    return suite_of([m.record for m in motions], [m.scaling.factor * share for m in motions], target)


def _not_named(code: str, judged: SuiteReview) -> Iterator[Message]:
    """Artificial records decide only where the project names the method."""
    question = judged.study.question
    deciding = [name for name in methods_of(question) if SUITE_CODES.get(name) == code]
    silent = [name for name in deciding if name not in (question.procedures or ())]
    if judged.suite.artificial.any() and silent:
        line = f'procedures = ["{silent[0]}"]'
        yield _message("suite-not-named", {"procedure": silent[0]}, Remedy("verdict.procedures", "name it there", line))


def _unmet_message(one: Requirement, remedy: Remedy) -> Message:
    """A rule that is not met."""
    low, high = one.periods or (0.0, 0.0)
    values: dict[str, Value] = {
        "code": one.code,
        "clause": one.clause,
        "found": _number(one, one.value or 0.0),
        "limit": _number(one, one.limit),
        "low": Quantity(low, "time", 3),
        "high": Quantity(high, "time", 3),
    }
    return _message(f"suite-{one.rule}", values, remedy)


def _out_of_reach(one: Requirement, judged: SuiteReview) -> Message:
    """A rule over periods that the target or what is compared does not reach."""
    assert one.periods is not None
    low, high = (Quantity(period, "time", 3) for period in one.periods)
    ends = Quantity(judged.suite.period_range[1], "time", 3)
    values: dict[str, Value] = {"code": one.code, "clause": one.clause, "low": low, "high": high, "end": ends}
    return _message("suite-out-of-reach", values, Remedy("site.spectrum", "extend its table"))


def _message(key: str, values: Mapping[str, Value], remedy: Remedy) -> Message:
    said = {**values, "remedy": remedy.text, "toml": remedy.toml}
    return message(key, said, severity=Severity.WARNING, where=remedy.key)


def _number(one: Requirement, value: float) -> Quantity:
    return whole_number(round(value)) if one.rule in WHOLE else Quantity(value, DIMENSIONS[one.unit], 3)


def more_records(one: Requirement, judged: SuiteReview) -> Remedy:
    """As many more as are missing."""
    missing = round(one.limit - (one.value or 0.0))
    text = f"give {missing} more record{'s' if missing > 1 else ''}"
    return _remake(text, judged) or Remedy("records.files", text, FILES)


def longer_records(one: Requirement, judged: SuiteReview) -> Remedy:
    """Artificial records of another duration."""
    text = f"records must last {_duration(one, judged):g} s"
    return _remake(text, judged) or Remedy("records.files", text)


def finer_records(one: Requirement, judged: SuiteReview) -> Remedy:
    """Records of a smaller step."""
    return Remedy("records.files", f"give artificial records at {one.limit:g} s or less")


def other_records(one: Requirement, judged: SuiteReview) -> Remedy:
    """Records that hold longer periods."""
    return Remedy("records.files", "give records whose processing kept longer periods")


def another_factor(one: Requirement, judged: SuiteReview) -> Remedy:
    """One further factor on every record, beside that which the project has; where none does, other records.

    Artificial records that are too short for the periods asked are made longer instead.
    """
    if _duration(one, judged):
        return longer_records(one, judged)
    factor = factor_that_does(judged.found)
    if factor is None:
        return Remedy("records.files", "no one factor does: choose records whose mean has the shape of the target")
    rounded = ceil(factor * DIGITS) / DIGITS if factor > 1.0 else floor(factor * DIGITS) / DIGITS
    whole = judged.study.record_factor * rounded
    return Remedy("records.factor", f"scale every record by {rounded:g}", f"factor = {whole:.6g}")


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


def _remake(text: str, judged: SuiteReview) -> Remedy | None:
    """The line that makes the artificial records as all rules ask; None where records come from files."""
    made = judged.study.artificial
    if made is None:
        return None
    wanted = improve_artificial(made, judged)
    line = f'synthetic = {{ count = {wanted.count}, seed = {wanted.seed}, duration = "{wanted.duration:g} s" }}'
    return Remedy("records.synthetic", text, line)


def improve_artificial(made: Artificial, judged: SuiteReview) -> Artificial:
    """The artificial records with the number and the duration that the rules ask for."""
    few = [round(one.limit - (one.value or 0.0)) for one in judged.unmet if one.rule == Rule.COUNT]
    long = [_duration(one, judged) for one in judged.unmet]
    return replace(made, count=made.count + max(few, default=0), duration=max([made.duration, *long]))


def _duration(one: Requirement, judged: SuiteReview) -> float:
    """Duration that a rule asks of artificial records: on itself, on its level part, on periods to be held; else 0."""
    if one.rule == Rule.DURATION:
        return one.limit
    if one.rule == Rule.STATIONARY:
        return one.limit / STATIONARY
    made, end = judged.study.artificial, 0.0 if one.periods is None else one.periods[1]
    return 0.0 if made is None or end * HELD <= made.duration else float(ceil(end * HELD))
