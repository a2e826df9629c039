"""How the answers of each mechanism change with numbers that are not well known, each varied alone.

A case is the mechanism alone with one number at its low or its high value. It goes through the procedures that decide,
at all levels, with its histories under all records as they are, but without the scan over rising PGA: procedures by
histories have no PGA at capacity and no numerical spread here. What is compared is demand over capacity, which is that
of the records as they are in a run, too.

The tolerance of the survey may take a share of the index of each mechanism: each surveyed number is varied alone, to
its unfavourable end, and the losses of index are added up. Answers by histories have a scatter of their own and are
left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from assess.codes.bases import Basis
from assess.codes.check import Check
from assess.codes.procedures import uses_histories
from assess.codes.question import Question
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict, find_deciding_check, index_of
from assess.errors import AssessError
from assess.messages.message import Message, Term, message
from assess.results import MechanismResult, SensitivityResult
from assess.study.checks import checks_without_scan
from assess.study.study import Progress, ScaledRecord, Study, UnvariedNumber, Variable
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum


def sensitivities(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanisms: Sequence[MechanismResult],
    *,
    jobs: int,
    progress: Progress,
) -> tuple[SensitivityResult, ...]:
    """Assess every variable of the study at its low and its high value.

    Parameters
    ----------
    study : Study
        The study, with its variables.
    spectrum : Spectrum
        The site's elastic spectrum.
    motions : tuple of ScaledRecord
        The suite of records.
    mechanisms : sequence of MechanismResult
        The mechanisms as assessed with the base values.
    jobs : int
        Number of threads; 0 for all cores.
    progress : Progress
        Called as variables are done.

    Returns
    -------
    tuple of SensitivityResult
        The rows of each variable, in the order of the study.
    """
    assessed = {mechanism.name: mechanism for mechanism in mechanisms}
    rows: list[SensitivityResult] = []
    for done, variable in enumerate(study.variables):
        progress("sensitivity", done, len(study.variables))
        if isinstance(variable, UnvariedNumber):
            rows.append(unvaried_row(variable))
            continue
        deciding = tuple(
            check for check in assessed[variable.mechanism].checks if check.reading == "letter" and not check.informs
        )
        procedures = tuple(dict.fromkeys(check.procedure for check in deciding))
        low, high = (
            assess_at_value(variable, value, study, procedures, spectrum, motions, jobs=jobs)
            for value in (variable.low, variable.high)
        )
        rows += rows_of(variable, deciding, low, high, basis=study.question.basis)
    return tuple(rows)


def assess_at_value(
    variable: Variable,
    value: float,
    whole: Study,
    procedures: tuple[str, ...],
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    *,
    jobs: int,
) -> CaseChecks:
    """Assess the mechanism with one value of the variable, by the procedures, under the suite of the whole study."""
    try:
        study = replace(variable.study_at(value), procedures=procedures, suite_faults=whole.suite_faults)
        return CaseChecks(checks_by_key(checks_without_scan(study, spectrum, motions, jobs=jobs)))
    except (AssessError, SpectrumError) as error:
        return CaseChecks({}, str(error))


CheckKey = tuple[str, str, float]
"""What distinguishes a check from the others of a mechanism: procedure, limit state, level [g]."""


@dataclass(frozen=True)
class CaseChecks:
    """The checks of one case, by what they answer; or why it could not be assessed."""

    checks: dict[CheckKey, Check]
    error: str = ""


def checks_by_key(checks: Sequence[Check]) -> dict[CheckKey, Check]:
    """Return checks by what they answer; of several, the first."""
    found: dict[CheckKey, Check] = {}
    for check in checks:
        found.setdefault((check.procedure, check.limit_state, check.level_pga_g), check)
    return found


def rows_of(
    variable: Variable, deciding: Sequence[Check], low: CaseChecks, high: CaseChecks, *, basis: Basis | None
) -> Iterator[SensitivityResult]:
    """Yield the index that decides, demand over capacity of each check, and PGA at capacity of each limit state."""
    said = tuple(remarks_on(variable, low, high))
    row = SensitivityResult(
        mechanism=variable.mechanism,
        parameter=variable.parameter,
        key=variable.key,
        unit=variable.unit,
        base=variable.base,
        low=variable.low,
        high=variable.high,
        remark="; ".join(map(str, said)),
        remarks=said,
    )
    with_capacities: set[tuple[str, str]] = set()
    for key, check in checks_by_key(deciding).items():
        row = replace(row, procedure=check.procedure, limit_state=check.limit_state, role=check.role)
        sides = low.checks.get(key), high.checks.get(key)
        if check.role == "deciding" and basis is not None:
            yield with_index(row, basis, check, *sides)
        if key[:2] not in with_capacities and not uses_histories(check.procedure):
            with_capacities.add(key[:2])
            yield with_capacity(row, check, *sides)
        yield with_ratio(row, check, *sides)


def with_index(
    row: SensitivityResult, basis: Basis, check: Check, low: Check | None, high: Check | None
) -> SensitivityResult:
    """Return the row of the index in which the basis measures a deciding check."""
    base, *ends = (None if each is None else index_of(each, basis) for each in (check, low, high))
    at_low, at_high = (None if end is None else end.value for end in ends)
    return replace(
        with_ratio(row, check, low, high),
        quantity="index",
        index=basis.index.value,
        at_base=None if base is None else base.value,
        at_low=at_low,
        at_high=at_high,
    )


def with_capacity(row: SensitivityResult, check: Check, low: Check | None, high: Check | None) -> SensitivityResult:
    """Return the row of the PGA at capacity [g], which does not depend on the level."""
    return replace(
        row,
        quantity="capacity_pga_g",
        level_pga_g=None,
        at_base=check.capacity_pga_g,
        at_low=None if low is None else low.capacity_pga_g,
        at_high=None if high is None else high.capacity_pga_g,
    )


def with_ratio(row: SensitivityResult, check: Check, low: Check | None, high: Check | None) -> SensitivityResult:
    """Return the row of demand over capacity at the level of a check; None where the body overturns."""
    return replace(
        row,
        quantity="demand_capacity",
        level_pga_g=check.level_pga_g,
        at_base=check.ratio,
        at_low=None if low is None else low.ratio,
        at_high=None if high is None else high.ratio,
        verdict_base=check.verdict,
        verdict_low=None if low is None else low.verdict,
        verdict_high=None if high is None else high.verdict,
    )


def remarks_on(variable: Variable, low: CaseChecks, high: CaseChecks) -> Iterator[Term | Message]:
    """Yield the remark on a variable, and why a case of it could not be assessed; that is an error, in English."""
    if variable.remark:
        yield Term(variable.remark)
    if low.error:
        yield message("not-assessed-low", {"value": f"{variable.low:.6g}", "why": low.error})
    if high.error:
        yield message("not-assessed-high", {"value": f"{variable.high:.6g}", "why": high.error})


def unvaried_row(unvaried: UnvariedNumber) -> SensitivityResult:
    """Return the row of a number that is not varied."""
    said = message("not-varied", {"why": Term(unvaried.why)})
    return SensitivityResult(
        mechanism=unvaried.mechanism, parameter=unvaried.parameter, remark=said.text, remarks=(said,)
    )


NEAR_THRESHOLD = (
    0.5  # of the threshold: an index farther from it is not "at the limit", whatever the survey's tolerance
)
Survey = Callable[[str], tuple[Variable, ...]]


def survey_tolerances(
    survey: Survey,
    spectrum: Spectrum,
    question: Question,
    found: Verdict,
    mechanisms: Sequence[MechanismResult],
) -> dict[str, float]:
    """Find the loss of index by the tolerance of the survey, for each mechanism whose index is near its threshold."""
    checks = {mechanism.name: mechanism.checks for mechanism in mechanisms}
    falls: dict[str, float] = {}
    for one in found.mechanisms:
        near = [answer for answer in one.answers if _is_near_threshold(answer, found.target)]
        if near:
            known = checks[one.mechanism]
            falls[one.mechanism] = max(
                _loss_of_index(survey, spectrum, question, one, answer, known) for answer in near
            )
    return falls


def _is_near_threshold(answer: Answer, target: float | None) -> bool:
    if answer.outcome == Decision.INCOMPLETE or uses_histories(answer.procedure) or target is None:
        return False
    good = _capacity_over_demand(answer)
    return good is not None and abs(good / target - 1.0) <= NEAR_THRESHOLD


def _capacity_over_demand(answer: Answer) -> float | None:
    """Return capacity over demand: the index, or its inverse."""
    if answer.index is None or answer.index.value == 0.0:
        return None
    return 1.0 / answer.index.value if answer.index.name == "D/C" else answer.index.value


def _loss_of_index(
    survey: Survey,
    spectrum: Spectrum,
    question: Question,
    one: MechanismVerdict,
    answer: Answer,
    checks: Sequence[Check],
) -> float:
    """Return the share of the index that the tolerance takes, over all numbers."""
    base = find_deciding_check(checks, answer, question.basis, question.action)
    if base is None:
        return 0.0
    total = 0.0
    for variable in survey(one.mechanism):
        ends = [
            _deciding_check_at(variable, value, spectrum, question, answer) for value in (variable.low, variable.high)
        ]
        worst = min((_share_of_base(end, base) for end in ends), default=1.0)
        total += max(0.0, 1.0 - worst)
    return total


def _share_of_base(end: Check | None, base: Check) -> float:
    """Return capacity over demand of a case over that of the base; 0 if the case has no answer."""
    if end is None:
        return 0.0
    if end.capacity_pga_g is not None and base.capacity_pga_g:
        return end.capacity_pga_g / base.capacity_pga_g
    return base.ratio / end.ratio if base.ratio and end.ratio else 1.0


def _deciding_check_at(
    variable: Variable, value: float, spectrum: Spectrum, question: Question, answer: Answer
) -> Check | None:
    """Return the deciding check with one value of a number; None if the mechanism cannot be assessed there."""
    try:
        study = replace(variable.study_at(value), procedures=(answer.procedure,), levels=(spectrum.pga,))
        found = checks_without_scan(study, spectrum, (), jobs=1)
    except (AssessError, SpectrumError):
        return None
    return find_deciding_check(found, answer, question.basis, question.action)
