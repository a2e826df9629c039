"""How the answers change with numbers of the project: in the cases of a sweep, and each number varied alone.

Every mechanism that a sweep changes is assessed in all its cases. The controlling case of a mechanism is the one with
the worst answer that decides: a failing case before an incomplete one, an incomplete one before one that passes. Of
equals it is the one with the least margin over the site's own action, then the one with the largest demand over
capacity (overturning before any ratio), then with the least PGA at capacity, then with the least multiplier at uplift;
then the first. If nothing decides, as without a basis, all checks by the letter of a code are used instead. Where no
case has the value that the file itself has, the mechanism as typed stands beside them, and counts where it is worse.

A case of a sensitivity is the mechanism alone with one number at its low or its high value. It goes through the
procedures that decide, at all levels, with its histories under all records as they are, but without the scan over
rising PGA: procedures by histories have no PGA at capacity and no numerical spread here. What is compared is demand
over capacity, which is that of the records as they are in a run, too.

The tolerance of the survey may take a share of the index of each mechanism: each surveyed number is varied alone, to
its unfavourable end, and the losses of index are added up. Answers by histories have a scatter of their own and are
left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import inf, isclose

from assess.codes.bases import Basis
from assess.codes.check import Check, Outcome
from assess.codes.procedures import uses_histories
from assess.codes.question import Question
from assess.codes.verdict import RANKS, Answer, Decision, MechanismVerdict, Verdict, find_deciding_check, index_of
from assess.errors import AssessError, locate_errors
from assess.messages.message import Message, Term, locate, message, note, whole_number
from assess.results import MechanismResult, OscillatorResult, SensitivityResult, SweepResult
from assess.study.assessment import assess_mechanisms, checks_without_twins
from assess.study.checks import decide, mark_result
from assess.study.study import (
    Progress,
    ScaledRecord,
    Study,
    Sweep,
    SweepCase,
    UnvariedNumber,
    Variable,
    case_value_text,
    no_progress,
)
from assess.study.suites import motions_of, suite_faults
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import Spectrum


def run_sweeps(
    study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismSweep, ...]:
    """Assess every mechanism that a sweep changes in all its cases, one sweep after the other."""
    total = sum(len(sweep.cases) for sweep in study.sweeps)
    swept: list[MechanismSweep] = []
    done = 0
    for sweep in study.sweeps:
        cases = []
        for case in sweep.cases:
            progress("cases of sweeps", done, total)
            with locate_errors(case.name):
                cases.append(_assess_case(case, study, motions, jobs=jobs))
            done += 1
        by_mechanism = zip(*cases, strict=True)  # mechanism by mechanism
        swept += [MechanismSweep(sweep, of_mechanism, controlling_index(of_mechanism)) for of_mechanism in by_mechanism]
    return tuple(swept)


def motions_of_case(
    changed: Study, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int
) -> tuple[ScaledRecord, ...]:
    """Return the motions of the study itself, or those of a case that changes them or the site."""
    assert changed.spectrum is not None  # no number takes the site away
    same = all(getattr(changed, key) == getattr(study, key) for key in ("artificial", "scale_to", "record_factor"))
    if same and changed.spectrum is study.spectrum and changed.records is study.records:
        return motions
    return motions_of(changed, changed.spectrum, jobs=jobs)


@dataclass(frozen=True)
class MechanismInCase:
    """One mechanism in one case, with its verdict."""

    result: MechanismResult
    verdict: MechanismVerdict


@dataclass(frozen=True)
class MechanismSweep:
    """One mechanism in all cases of one sweep.

    cases : the mechanism in each case, with its verdict [n]; controlling : the case that controls, counted from 0
    """

    sweep: Sweep
    cases: tuple[MechanismInCase, ...]
    controlling: int

    @property
    def results(self) -> tuple[MechanismResult, ...]:
        """The mechanism in each case."""
        return tuple(each.result for each in self.cases)

    @property
    def mechanism(self) -> str:
        """The name of the mechanism."""
        return self.results[0].name

    @property
    def controlling_result(self) -> MechanismResult:
        """The mechanism in the controlling case."""
        return self.results[self.controlling]

    @property
    def controlling_case(self) -> SweepCase:
        """The controlling case."""
        return self.sweep.cases[self.controlling]


def controlling_cases(
    sweeps: Sequence[MechanismSweep], as_typed: Mapping[str, MechanismInCase]
) -> dict[str, MechanismSweep]:
    """Return, for each mechanism, the sweep whose controlling case represents it: the most severe one.

    as_typed : the mechanisms of which no case has the value of the file; left out where they are more severe as typed
    """
    controlling: dict[str, MechanismSweep] = {}
    for swept in sweeps:
        before = controlling.get(swept.mechanism)
        if before is None or severity(swept.cases[swept.controlling]) > severity(before.cases[before.controlling]):
            controlling[swept.mechanism] = swept
    for name, typed in as_typed.items():
        swept = controlling[name]
        of_answer = slice(3)  # a PGA at capacity alone is no more severe: it goes with the site's action
        if severity(typed)[of_answer] > severity(swept.cases[swept.controlling])[of_answer]:
            del controlling[name]
    return controlling


def controlling_index(cases: Sequence[MechanismInCase]) -> int:
    """Return which of the cases controls, counted from 0: the first of the most severe."""
    return max(range(len(cases)), key=lambda place: (severity(cases[place]), -place))


def severity(case: MechanismInCase) -> tuple[float, ...]:
    """Return what the controlling case has the largest of: outcome, -margin, ratio, -PGA at capacity, -multiplier."""
    outcome, margin = case.verdict.outcome, case.verdict.margin
    checks = _deciding_checks(case.result)
    ratio, capacity = _worst_ratio(checks), _least_capacity(checks)
    uplift = _weaker_branch(case.result).uplift_multiplier
    unknown = 0.0 if outcome == Decision.FAIL else inf  # what fails at an unknown PGA may do so at any
    return (
        float(RANKS.index(outcome)),
        -(unknown if margin is None else _round_severity(margin)),
        -1.0 if ratio is None else _round_severity(ratio),
        -inf if capacity is None else -_round_severity(capacity),
        -inf if uplift is None else -_round_severity(uplift),
    )


def ratio_of(check: Check) -> float:
    """Return demand over capacity [-], inf where the body overturned."""
    if check.ratio is not None:
        return check.ratio
    return inf if check.verdict == Outcome.FAIL else 0.0


def sweep_results(
    sweeps: Sequence[MechanismSweep], controlling: Mapping[str, MechanismSweep]
) -> tuple[SweepResult, ...]:
    """Return the sweeps as results."""
    return tuple(_sweep_result(swept, governs=controlling.get(swept.mechanism) is swept) for swept in sweeps)


def mechanisms_beside_cases(sweeps: Sequence[Sweep]) -> set[str]:
    """Return the mechanisms that are swept, but in no case as the file itself has them."""
    swept, typed = (
        {each.name for sweep in some for each in sweep.cases[0].study.mechanisms}
        for some in (sweeps, [sweep for sweep in sweeps if sweep.has_typed])
    )
    return swept - typed


def in_case(study: Study, results: Sequence[MechanismResult]) -> Iterator[MechanismInCase]:
    """Yield the mechanisms of a study with the verdict of each, and their checks marked by it."""
    decided = decide(study, results)
    verdicts = {each.mechanism: each for each in decided.mechanisms}  # those of mechanisms that fall among them
    for result in results:
        yield MechanismInCase(mark_result(decided, study.question, result), verdicts[result.name])


def case_messages(swept: MechanismSweep) -> Iterator[Message]:
    """Yield which case represents the mechanism, and the messages on the mechanism in that case."""
    where, sweep = f"mechanisms.{swept.mechanism}", swept.sweep
    case = f"{sweep.key} = {case_value_text(sweep, swept.controlling_case)}"
    yield note("sweep", where, cases=whole_number(len(sweep.cases)), case=case)
    for mechanism in swept.controlling_case.study.mechanisms:
        if mechanism.name == swept.mechanism:
            yield from locate(mechanism.warnings, where)


def sensitivities(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    results: Sequence[MechanismResult],
    *,
    jobs: int,
    progress: Progress,
) -> tuple[SensitivityResult, ...]:
    """Assess every variable of the study at its low and its high value.

    Parameters
    ----------
    study : the study, with its variables
    spectrum : the site's elastic spectrum
    motions : the suite of records
    results : the mechanisms as assessed with the base values
    jobs : number of threads; 0 for all cores
    progress : called as variables are done

    Returns
    -------
    The rows of each variable, in the order of the study.
    """
    assessed = {result.name: result for result in results}
    check = partial(check_case, suite_faults=study.suite_faults, spectrum=spectrum, motions=motions, jobs=jobs)
    rows: list[SensitivityResult] = []
    for done, variable in enumerate(study.variables):
        progress("sensitivity", done, len(study.variables))
        if isinstance(variable, UnvariedNumber):
            rows.append(_unvaried_row(variable))
            continue
        deciding = tuple(each for each in assessed[variable.mechanism].checks if each.follows_code)
        procedures = [each.procedure for each in deciding]
        low, high = (check(partial(variable.study_at, value), procedures) for value in (variable.low, variable.high))
        rows += rows_of(variable, deciding, low, high, basis=study.question.basis)
    return tuple(rows)


CheckKey = tuple[str, str, float]
"""What distinguishes a check from the others of a mechanism: procedure, limit state, level [g]."""


@dataclass(frozen=True)
class CaseChecks:
    """The checks of a mechanism in one case and the study that they are of; or why it could not be assessed."""

    checks: tuple[Check, ...] = ()
    study: Study | None = None
    error: str = ""

    @property
    def by_key(self) -> dict[CheckKey, Check]:
        """The checks by what they answer."""
        return checks_by_key(self.checks)


def check_case(
    build: Callable[[], Study],
    procedures: Iterable[str],
    *,
    suite_faults: Mapping[str, tuple[Message, ...]],
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    jobs: int,
) -> CaseChecks:
    """Assess the one mechanism of a study by these procedures, without the scan over rising PGA.

    build : builds the study; suite_faults : of the motions, which are those of the whole study
    spectrum, motions : of the whole study; where the case has an action of its own, motions that are scaled to it are
        scaled by the ratio of the PGA, and checks at the site's own level have that of the whole study
    """
    try:
        study = replace(build(), procedures=tuple(dict.fromkeys(procedures)), suite_faults=suite_faults)
        own = study.spectrum
        if own is None or own is spectrum:
            return CaseChecks(checks_without_twins(study, spectrum, motions, jobs=jobs), study)
        if study.scale_to != "none":
            ratio = own.pga / spectrum.pga
            scalings = (replace(each.scaling, factor=ratio * each.scaling.factor) for each in motions)
            motions = tuple(map(ScaledRecord, (each.record for each in motions), scalings))
        checks = checks_without_twins(study, own, motions, jobs=jobs)
        level, level_of_site = own.pga / g, spectrum.pga / g
        return CaseChecks(
            tuple(
                replace(each, level_pga_g=level_of_site)
                if each.level_pga_g is not None and isclose(each.level_pga_g, level, rel_tol=1e-9)
                else each
                for each in checks
            ),
            study,
        )
    except (AssessError, SpectrumError) as error:
        return CaseChecks(error=str(error))


def checks_by_key(checks: Iterable[Check]) -> dict[CheckKey, Check]:
    """Return checks by what they answer; of several, the first."""
    found: dict[CheckKey, Check] = {}
    for check in checks:
        found.setdefault((check.procedure, check.limit_state, check.level_pga_g), check)
    return found


def rows_of(
    variable: Variable, deciding: Sequence[Check], low: CaseChecks, high: CaseChecks, *, basis: Basis | None
) -> Iterator[SensitivityResult]:
    """Yield the index that decides, demand over capacity of each check, and PGA at capacity of each limit state."""
    remarks = tuple(_remarks_on(variable, low, high))
    row = SensitivityResult(
        mechanism=variable.mechanism,
        parameter=variable.parameter,
        key=variable.key,
        unit=variable.unit,
        base=variable.base,
        low=variable.low,
        high=variable.high,
        remark="; ".join(map(str, remarks)),
        remarks=remarks,
    )
    with_capacities: set[tuple[str, str]] = set()
    at_low, at_high = low.by_key, high.by_key
    for key, check in checks_by_key(deciding).items():
        ends = (check, at_low.get(key), at_high.get(key))
        row = replace(row, procedure=check.procedure, limit_state=check.limit_state, role=check.role)
        verdicts = [None if each is None else each.verdict for each in ends]
        at_level = replace(
            row,
            level_pga_g=check.level_pga_g,
            verdict_base=verdicts[0],
            verdict_low=verdicts[1],
            verdict_high=verdicts[2],
        )
        if check.role == "deciding" and basis is not None:
            of_index = replace(at_level, quantity="index", index=basis.index.value)
            yield _at_ends(of_index, partial(_index_value, basis), ends)
        if key[:2] not in with_capacities and not uses_histories(check.procedure):
            with_capacities.add(key[:2])  # that of the first level is that of all
            yield _at_ends(replace(row, quantity="capacity_pga_g"), lambda each: each.capacity_pga_g, ends)
        yield _at_ends(replace(at_level, quantity="demand_capacity"), lambda each: each.ratio, ends)


NEAR_THRESHOLD = (
    0.5  # of the threshold: an index farther from it is not "at the limit", whatever the survey's tolerance
)
Survey = Callable[[str], tuple[Variable, ...]]


def survey_tolerances(
    survey: Survey,
    spectrum: Spectrum,
    question: Question,
    decided: Verdict,
    results: Sequence[MechanismResult],
) -> dict[str, float]:
    """Find the loss of index by the tolerance of the survey, for each mechanism whose index is near its threshold."""
    checks = {result.name: result.checks for result in results}
    losses: dict[str, float] = {}
    for mechanism_verdict in decided.mechanisms:
        near = [answer for answer in mechanism_verdict.answers if _is_near_threshold(answer, decided.target)]
        if near:
            mechanism_checks = checks[mechanism_verdict.mechanism]
            losses[mechanism_verdict.mechanism] = max(
                _loss_of_index(survey, spectrum, question, mechanism_verdict, answer, mechanism_checks)
                for answer in near
            )
    return losses


def _assess_case(
    case: SweepCase, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int
) -> tuple[MechanismInCase, ...]:
    """Assess the mechanisms of one case, under the motions of the study unless the case changes them."""
    spectrum = case.study.spectrum
    assert spectrum is not None  # no number takes the site away
    motions_there = motions_of_case(case.study, study, motions, jobs=jobs)
    faults = study.suite_faults if motions_there is motions else suite_faults(case.study, spectrum, motions_there)
    assessed = replace(case.study, suite_faults=faults)
    results = assess_mechanisms(assessed, spectrum, motions_there, jobs=jobs, progress=no_progress)
    return tuple(in_case(assessed, results))


def _round_severity(value: float) -> float:
    """Round to nine figures, so that cases that differ by rounding count as equal."""
    return float(f"{value:.9g}")


def _deciding_checks(result: MechanismResult) -> list[Check]:
    """Return the checks that decide; if none does, all by the letter of a code."""
    by_code = [check for check in result.checks if check.follows_code]
    return [check for check in by_code if check.role == "deciding"] or by_code


def _worst_ratio(checks: Sequence[Check]) -> float | None:
    """Return the largest demand over capacity of the checks that pass or fail; None if there are none."""
    return max((ratio_of(check) for check in checks if check.verdict in (Outcome.PASS, Outcome.FAIL)), default=None)


def _least_capacity(checks: Sequence[Check]) -> float | None:
    """Return the least PGA at capacity [g]; None if no check has one."""
    return min((check.capacity_pga_g for check in checks if check.capacity_pga_g is not None), default=None)


def _weaker_branch(result: MechanismResult) -> OscillatorResult:
    """Return the branch that uplifts first; of equals, the positive one."""
    branches = [result.oscillator, result.oscillator_negative]
    present = [branch for branch in branches if branch is not None]
    return min(present, key=lambda branch: inf if branch.uplift_multiplier is None else branch.uplift_multiplier)


def _sweep_result(swept: MechanismSweep, *, governs: bool) -> SweepResult:
    """Return one mechanism over the values of one sweep, by the branch that uplifts first in each case."""
    branches = [_weaker_branch(result) for result in swept.results]
    checks_by_case = [_deciding_checks(result) for result in swept.results]
    ratios = [_worst_ratio(checks_of_case) for checks_of_case in checks_by_case]
    return SweepResult(
        mechanism=swept.mechanism,
        key=swept.sweep.key,
        unit=swept.sweep.unit,
        value=tuple(case.value for case in swept.sweep.cases),
        p_eq_per_s=tuple(branch.p_eq_per_s for branch in branches),
        uplift_multiplier=tuple(branch.uplift_multiplier for branch in branches),
        overturning_rad=tuple(branch.overturning_rad for branch in branches),
        overturning_flexible_rad=tuple(branch.overturning_flexible_rad for branch in branches),
        elastic_frequency_hz=tuple(branch.elastic_frequency_hz for branch in branches),
        restitution=tuple(branch.restitution for branch in branches),
        demand_capacity=tuple(None if ratio == inf else ratio for ratio in ratios),
        overturned=tuple(
            any(check.unbounded == "overturned" for check in checks_of_case) for checks_of_case in checks_by_case
        ),
        capacity_pga_g=tuple(_least_capacity(checks_of_case) for checks_of_case in checks_by_case),
        outcome=tuple(case.verdict.outcome for case in swept.cases),
        controlling=swept.controlling,
        governs=governs,
    )


def _at_ends(
    row: SensitivityResult, value: Callable[[Check], float | None], ends: Sequence[Check | None]
) -> SensitivityResult:
    """Return a row with a value of the checks at base, low and high; None where there is no check."""
    base, low, high = (None if each is None else value(each) for each in ends)
    return replace(row, at_base=base, at_low=low, at_high=high)


def _index_value(basis: Basis, check: Check) -> float | None:
    """Return the index in which the basis measures a check."""
    index = index_of(check, basis)
    return None if index is None else index.value


def _remarks_on(variable: Variable, low: CaseChecks, high: CaseChecks) -> Iterator[Term | Message]:
    """Yield the remark on a variable, and why a case of it could not be assessed; that is an error, in English."""
    if variable.remark:
        yield Term(variable.remark)
    if low.error:
        yield message("not-assessed-low", {"value": f"{variable.low:.6g}", "why": low.error})
    if high.error:
        yield message("not-assessed-high", {"value": f"{variable.high:.6g}", "why": high.error})


def _unvaried_row(unvaried: UnvariedNumber) -> SensitivityResult:
    """Return the row of a number that is not varied."""
    remark = message("not-varied", {"why": Term(unvaried.why)})
    return SensitivityResult(
        mechanism=unvaried.mechanism, parameter=unvaried.parameter, remark=remark.text, remarks=(remark,)
    )


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
    mechanism_verdict: MechanismVerdict,
    answer: Answer,
    checks: Sequence[Check],
) -> float:
    """Return the share of the index that the tolerance takes, over all numbers."""
    base = find_deciding_check(checks, answer, question.basis, question.action)
    if base is None:
        return 0.0
    total = 0.0
    for variable in survey(mechanism_verdict.mechanism):
        worst = 1.0
        for value in (variable.low, variable.high):
            build = partial(_study_at_site, variable, value, spectrum)
            case = check_case(build, [answer.procedure], suite_faults={}, spectrum=spectrum, motions=(), jobs=1)
            end = find_deciding_check(case.checks, answer, question.basis, question.action)
            worst = min(worst, _share_of_base(end, base))
        total += 1.0 - worst
    return total


def _share_of_base(end: Check | None, base: Check) -> float:
    """Return capacity over demand of a case over that of the base; 0 if the case has no answer."""
    if end is None:
        return 0.0
    if end.capacity_pga_g is not None and base.capacity_pga_g:
        return end.capacity_pga_g / base.capacity_pga_g
    return base.ratio / end.ratio if base.ratio and end.ratio else 1.0


def _study_at_site(variable: Variable, value: float, spectrum: Spectrum) -> Study:
    """Return the study with another value of a number, at the site's own action alone."""
    return replace(variable.study_at(value), levels=(spectrum.pga,))
