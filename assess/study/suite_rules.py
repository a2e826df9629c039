"""The rules of codes for suites of records: which the records do not meet, and a change of the project that would.

One suite serves the whole building, so the range of periods reaches the slowest of all its mechanisms. A rocking body
has no period of its own. Where codes refer to the period of a structure, it is that of the linear oscillator with the
same work at the allowable rotation of histories, half the overturning rotation: 1/f_e of ASCE 43-05 A.2 (the secant in
energy).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import ceil, floor
from typing import Protocol

import numpy as np

from assess.codes.asce43_05 import HALF, effective_frequency
from assess.codes.italian_limit_states import curves_of_all_actions
from assess.codes.ntc2018_clauses import ULTIMATE, capacity_of
from assess.codes.procedures import SUITE_RULES, uses_histories
from assess.codes.question import methods_of
from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, Severity, Term, Value, message, whole_number
from assess.oscillator import Branch
from assess.study.study import ArtificialRecords, ScaledRecord, Study, deciding_limit_states
from records.compliance import Requirements, asce43_05, ntc2018
from records.compliance.suite import FINE, Requirement, RequirementKind, Suite, common_factor, suite_of
from records.synthetic import MATCHED_PERIODS, STATIONARY
from spectra.spectrum import Spectrum

COUNTED_RULES = (RequirementKind.COUNT, RequirementKind.RUN_BELOW)
DIMENSIONS: Mapping[str, str] = {"s": "time", "-": "ratio"}


def suite_faults(
    study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]
) -> Mapping[str, tuple[Message, ...]]:
    """Find the rules for suites that the records do not meet, by code.

    Codes whose histories are not requested are included: a floor spectrum is made of the same suite.

    Parameters
    ----------
    study : Study
        The study, with its question.
    spectrum : Spectrum
        The site's elastic spectrum.
    motions : sequence of ScaledRecord
        The suite.

    Returns
    -------
    mapping of str to tuple of Message
        By code; an empty tuple where all rules are met.
    """
    return {code: tuple(_faults_by_code(code, study, spectrum, motions)) for code in RULES}


def _faults_by_code(code: str, study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    if not motions:
        yield _message_with_remedy("suite-empty", {}, Remedy("records.files", Term("give records"), FILES_LINE))
        return
    rules, target = RULES[code], spectrum_of_rules(code, study, spectrum)
    suite = suite_on(motions, spectrum, target)
    shortest, longest = rules.periods(study)
    review = SuiteReview(study, suite, rules.requirements(suite, shortest=shortest, longest=longest))
    yield from _not_named(code, review)
    yield from (_unmet_message(one, REMEDIES[one.rule](one, review)) for one in review.unmet)
    yield from (_out_of_reach(one, review) for one in review.found if one.verdict == "not answered")


def suite_on(motions: Sequence[ScaledRecord], spectrum: Spectrum, target: Spectrum) -> Suite:
    """Return the suite as run for the limit state of `target`: at the PGA of `target`, not at the site's."""
    share = target.pga / spectrum.pga
    return suite_of([m.record for m in motions], [m.scaling.factor * share for m in motions], target)


def _not_named(code: str, review: SuiteReview) -> Iterator[Message]:
    """Yield a message if artificial records would decide without the project naming the method."""
    question = review.study.question
    deciding = [name for name in methods_of(question) if SUITE_RULES.get(name) == code]
    silent = [name for name in deciding if name not in (question.procedures or ())]
    if review.suite.artificial.any() and silent:
        line = f'procedures = ["{silent[0]}"]'
        remedy = Remedy("verdict.procedures", Term("name it there"), line)
        yield _message_with_remedy("suite-not-named", {"procedure": silent[0]}, remedy)


def _unmet_message(one: Requirement, remedy: Remedy) -> Message:
    """Return the message on a rule that is not met."""
    low, high = one.periods or (0.0, 0.0)
    values: dict[str, Value] = {
        "code": one.code,
        "clause": one.clause,
        "found": _quantity_of(one, one.value or 0.0),
        "limit": _quantity_of(one, one.limit),
        "low": Quantity(low, "time", 3),
        "high": Quantity(high, "time", 3),
    }
    return _message_with_remedy(f"suite-{one.rule}", values, remedy)


def _out_of_reach(one: Requirement, review: SuiteReview) -> Message:
    """Return the message on a rule over periods beyond the target or the records."""
    assert one.periods is not None
    low, high = (Quantity(period, "time", 3) for period in one.periods)
    ends = Quantity(review.suite.period_range[1], "time", 3)
    values: dict[str, Value] = {"code": one.code, "clause": one.clause, "low": low, "high": high, "end": ends}
    return _message_with_remedy("suite-out-of-reach", values, Remedy("site.spectrum", Term("extend its table")))


def _message_with_remedy(key: str, values: Mapping[str, Value], remedy: Remedy) -> Message:
    said: dict[str, Value] = {**values, "remedy": remedy.text, "toml": remedy.toml}
    return message(key, said, severity=Severity.WARNING, where=remedy.key)


def _quantity_of(one: Requirement, value: float) -> Quantity:
    return whole_number(round(value)) if one.rule in COUNTED_RULES else Quantity(value, DIMENSIONS[one.unit], 3)


FACTOR_STEPS = 1000.0  # a factor is proposed to three decimals, rounded to the side that meets the rule
FILES_LINE = 'files = ["records/*.AT2"]'
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
    return _remake(text, review) or Remedy("records.files", text, FILES_LINE)


def longer_records(one: Requirement, review: SuiteReview) -> Remedy:
    """Propose artificial records of a longer duration."""
    text = message("remedy-longer", {"duration": Quantity(_required_duration(one, review), "time", 6)})
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
    if _required_duration(one, review):
        return longer_records(one, review)
    factor = common_factor(review.found)
    if factor is None:
        return Remedy("records.files", NO_FACTOR)
    rounded = (
        ceil(factor * FACTOR_STEPS) / FACTOR_STEPS if factor > 1.0 else floor(factor * FACTOR_STEPS) / FACTOR_STEPS
    )
    whole = review.study.record_factor * rounded
    text = message("remedy-factor", {"factor": Quantity(rounded, "ratio", 6)})
    return Remedy("records.factor", text, f"factor = {whole:.6g}")


REMEDIES: Mapping[RequirementKind, Callable[[Requirement, SuiteReview], Remedy]] = {
    RequirementKind.COUNT: more_records,
    RequirementKind.STEP: finer_records,
    RequirementKind.DURATION: longer_records,
    RequirementKind.STATIONARY: longer_records,
    RequirementKind.USABLE: other_records,
    RequirementKind.MEAN_LOW: another_factor,
    RequirementKind.MEAN_HIGH: another_factor,
    RequirementKind.RUN_BELOW: another_factor,
}


def _remake(text: Term | Message, review: SuiteReview) -> Remedy | None:
    """Return the line that makes artificial records as all rules require; None if records come from files."""
    made = review.study.artificial
    if made is None:
        return None
    wanted = improve_artificial(made, review)
    line = f'synthetic = {{ count = {wanted.count}, seed = {wanted.seed}, duration = "{wanted.duration:g} s" }}'
    return Remedy("records.synthetic", text, line)


def improve_artificial(made: ArtificialRecords, review: SuiteReview) -> ArtificialRecords:
    """Return the artificial records with the number and the duration that the rules require."""
    few = [round(one.limit - (one.value or 0.0)) for one in review.unmet if one.rule == RequirementKind.COUNT]
    long = [_required_duration(one, review) for one in review.unmet]
    return replace(made, count=made.count + max(few, default=0), duration=max([made.duration, *long]))


def _required_duration(one: Requirement, review: SuiteReview) -> float:
    """Return the duration [s] that a rule requires of artificial records, directly, by level part or by periods."""
    if one.rule == RequirementKind.DURATION:
        return one.limit
    if one.rule == RequirementKind.STATIONARY:
        return one.limit / STATIONARY
    made, end = review.study.artificial, 0.0 if one.periods is None else one.periods[1]
    return (
        0.0 if made is None or end * LONGEST_PERIOD_SHARE <= made.duration else float(ceil(end * LONGEST_PERIOD_SHARE))
    )


Range = tuple[float, float]
LONGEST_PERIOD_SHARE = (
    3.0  # artificial records hold periods up to their duration over this, well within what can be fitted
)


class FittedRange(Protocol):
    """The range of periods over which artificial records have to fit the target [s]."""

    def __call__(self, *, longest: float) -> Range:
        """Return the range for the longest period of the mechanisms [s]."""


class PeriodsOf(Protocol):
    """The periods at the limit state, used as T_1 in the clauses of a code [s]."""

    def __call__(self, study: Study) -> Range:
        """Return the shortest and the longest of all mechanisms."""


@dataclass(frozen=True)
class SuiteRules:
    """The rules of one code: its requirements, the range of periods to be fitted, and the periods of the mechanisms."""

    code: str
    requirements: Requirements
    fitted: FittedRange
    periods: PeriodsOf


def periods_at_allowable_rotation(study: Study) -> Range:
    """Return the periods of equal work at half the overturning rotation [s], for ASCE 43-05."""
    return extreme_periods(equivalent_periods(study.mechanisms))


def periods_at_limit_state(study: Study) -> Range:
    """Return T_SLV or T_SLC, and the building's T_1 if a mechanism is above the ground [s], for NTC 2018."""
    state = deciding_state(study)
    low, high = extreme_periods(limit_state_periods(study.mechanisms, state=state))
    if study.building is None or not any(_base_above_ground(each, study) for each in study.mechanisms):
        return low, high
    return min(low, study.building.period), max(high, study.building.period)


def _base_above_ground(mechanism: Mechanism, study: Study) -> bool:
    """Return whether the base of a mechanism is above the ground, even if only on a plinth."""
    return study.grounded[mechanism.name].base > 0.0


def deciding_state(study: Study) -> str:
    """Return the ultimate limit state that decides by the Italian code; SLV if another code decides."""
    return next((state for state in deciding_limit_states(study.question) if state in ULTIMATE), "SLV")


RULES: Mapping[str, SuiteRules] = {
    "asce43-05": SuiteRules(
        asce43_05.CODE, asce43_05.requirements, asce43_05.fit_periods, periods_at_allowable_rotation
    ),
    "ntc2018": SuiteRules(ntc2018.CODE, ntc2018.requirements, ntc2018.fit_periods, periods_at_limit_state),
}
"""By the code of a procedure, as `assess.codes.procedures.CODES` names it."""


def codes_of_histories(study: Study) -> tuple[str, ...]:
    """Return the codes whose procedures by histories are requested."""
    return tuple(dict.fromkeys(SUITE_RULES[name] for name in study.procedures if uses_histories(name)))


def codes_that_decide(study: Study) -> tuple[str, ...]:
    """Return the codes whose procedures by histories may decide; if none may, those requested."""
    deciding = [SUITE_RULES[name] for name in methods_of(study.question) if uses_histories(name)]
    return tuple(dict.fromkeys(deciding)) or codes_of_histories(study)


def spectrum_of_rules(code: str, study: Study, spectrum: Spectrum) -> Spectrum:
    """Return the target of a suite: for the Italian code, the spectrum of the limit state that decides, if known.

    Parameters
    ----------
    code : str
        Of a procedure, as in `RULES`.
    study : Study
        The hazard and what decides.
    spectrum : Spectrum
        The site's.
    """
    if code != "ntc2018" or study.hazard is None:
        return spectrum
    return study.hazard.spectra.get(deciding_state(study), spectrum)


def made_band(study: Study, spectrum: Spectrum, *, duration: float) -> Range:
    """Return the range of periods over which artificial records are made to fit [s]: as the rules require, if possible.

    A record holds periods up to a share of its duration; further than the target or 10 s nothing is compared.

    Parameters
    ----------
    study : Study
        The mechanisms, and the codes that decide.
    spectrum : Spectrum
        The target.
    duration : float
        Of the records [s].
    """
    ranges = [RULES[code].fitted(longest=RULES[code].periods(study)[1]) for code in codes_that_decide(study)]
    longest = max([MATCHED_PERIODS[1], *(high for _, high in ranges)])
    return MATCHED_PERIODS[0], min(longest, duration / LONGEST_PERIOD_SHARE, float(FINE[-1]), spectrum.longest_period)


LARGEST_FC = 1.35  # of LC1, which makes the longest periods
BELOW, ABOVE = 0.2, 1.2  # of the least and the largest equivalent period: range that spectra are fitted over
FITTED_OVER = "0.2 times the least to 1.2 times the largest equivalent period of the mechanisms"


def equivalent_period(branch: Branch) -> float:
    """Return the equivalent period [s] of a branch at the allowable rotation."""
    return float(1.0 / effective_frequency(branch, np.array([HALF * branch.unstable]))[0])


def equivalent_periods(mechanisms: Iterable[Mechanism]) -> dict[str, tuple[float, float]]:
    """Return the shortest and the longest equivalent period [s] of the branches of each mechanism, by name."""
    found = {}
    for mechanism in mechanisms:
        periods = [equivalent_period(branch) for branch in mechanism.variants.deciding.branches]
        found[mechanism.name] = (min(periods), max(periods))
    return found


def limit_state_periods(mechanisms: Iterable[Mechanism], *, state: str) -> dict[str, tuple[float, float]]:
    """Return the shortest and the longest T_SLV or T_SLC [s] of each mechanism (NTC 2018, C8.7.1.10, 11), by name."""
    found = {}
    for mechanism in mechanisms:
        alone = curves_of_all_actions(mechanism.variants.deciding)
        periods = [capacity_of(curves, state=state, confidence_factor=LARGEST_FC).T for curves in alone]
        found[mechanism.name] = (min(periods), max(periods))
    return found


def extreme_periods(periods: dict[str, tuple[float, float]]) -> tuple[float, float]:
    """Return the least and the largest of all periods [s]; raise ProjectError if there are none."""
    if not periods:
        raise ProjectError("mechanisms: none to take periods from; add one, or give records.select periods")
    return min(low for low, _ in periods.values()), max(high for _, high in periods.values())
