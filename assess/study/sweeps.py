"""The cases of the sweeps of a study, and which of them controls.

The controlling case of a mechanism is the one with the worst answer that decides: a failing case before an incomplete
one, that before one that passes; of equals the one that holds the least over the site's own action, then the one with
the largest demand over capacity (overturning before any ratio), then with the least PGA at capacity, then with the
least multiplier at uplift; then the first. Where nothing decides, as without a basis, all checks by the letter of a
code stand for what decides. Where several sweeps change one mechanism, the worst of their controlling cases stands for
it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf

from assess.codes.check import Check, Outcome
from assess.codes.verdict import Decision, MechanismVerdict
from assess.errors import locate_errors
from assess.messages.message import Message, note, warning, whole_number
from assess.results import MechanismResult, OscillatorResult, SweepResult
from assess.study.mechanisms import assess_mechanisms
from assess.study.motions import ScaledRecord, motions_of
from assess.study.progress import Progress, silent
from assess.study.study import Case, Study, Sweep
from assess.study.suite_faults import suite_faults
from assess.study.verdict import decide, mark_result

RANKS = (Decision.PASS, Decision.INCOMPLETE, Decision.FAIL)


@dataclass(frozen=True)
class CaseResult:
    """One mechanism in one case, with its verdict."""

    result: MechanismResult
    verdict: MechanismVerdict


@dataclass(frozen=True)
class MechanismSweep:
    """One mechanism in all cases of one sweep [n]: what was found, and the case that controls, from 0."""

    sweep: Sweep
    judged: tuple[CaseResult, ...]
    controlling: int

    @property
    def results(self) -> tuple[MechanismResult, ...]:
        """The mechanism in each case."""
        return tuple(each.result for each in self.judged)

    @property
    def mechanism(self) -> str:
        """Its name."""
        return self.results[0].name

    @property
    def worst(self) -> MechanismResult:
        """The mechanism in the controlling case."""
        return self.results[self.controlling]

    @property
    def case(self) -> Case:
        """The controlling case."""
        return self.sweep.cases[self.controlling]


def run_sweeps(
    study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismSweep, ...]:
    """Every mechanism that a sweep changes, in all its cases, sweep after sweep."""
    total = sum(len(sweep.cases) for sweep in study.sweeps)
    found: list[MechanismSweep] = []
    done = 0
    for sweep in study.sweeps:
        cases = []
        for case in sweep.cases:
            progress("cases of sweeps", done, total)
            with locate_errors(case.name):
                cases.append(assess_case(case, study, motions, jobs=jobs))
            done += 1
        each = zip(*cases, strict=True)  # mechanism by mechanism
        found += [MechanismSweep(sweep, judged, controlling_index(judged)) for judged in each]
    return tuple(found)


def assess_case(case: Case, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int) -> tuple[CaseResult, ...]:
    """The mechanisms of one case under its motions, those of the study where the case does not change them."""
    spectrum = case.study.spectrum
    assert spectrum is not None  # no number takes the site away
    same = all(getattr(case.study, key) == getattr(study, key) for key in ("artificial", "scale_to", "record_factor"))
    shared = same and spectrum is study.spectrum and case.study.records is study.records
    moving = motions if shared else motions_of(case.study, spectrum, jobs=jobs)
    faults = study.suite_faults if shared else suite_faults(case.study, spectrum, moving)
    judged = replace(case.study, suite_faults=faults)
    done = assess_mechanisms(judged, spectrum, moving, jobs=jobs, progress=silent)
    found = decide(judged, done)
    each = zip(done, found.mechanisms, strict=True)
    return tuple(CaseResult(mark_result(found, judged.question, result), one) for result, one in each)


def controlling_index(cases: Sequence[CaseResult]) -> int:
    """Which of the cases controls, from 0: the first of the most severe."""
    return max(range(len(cases)), key=lambda place: (severity(cases[place]), -place))


def severity(case: CaseResult) -> tuple[float, ...]:
    """What the controlling case has the largest of: outcome, then less margin, ratio, less PGA, less multiplier."""
    outcome, margin = case.verdict.outcome, case.verdict.margin
    checks = deciding_checks(case.result)
    ratio, capacity = worst_ratio(checks), least_capacity(checks)
    uplift = weaker_branch(case.result).uplift_multiplier
    unknown = 0.0 if outcome == Decision.FAIL else inf  # what fails at an unknown PGA may do so at any
    return (
        float(RANKS.index(outcome)),
        -(unknown if margin is None else round_figures(margin)),
        -1.0 if ratio is None else round_figures(ratio),
        -inf if capacity is None else -round_figures(capacity),
        -inf if uplift is None else -round_figures(uplift),
    )


def round_figures(value: float) -> float:
    """To nine figures, so that cases that differ by rounding are equals."""
    return float(f"{value:.9g}")


def deciding_checks(mechanism: MechanismResult) -> list[Check]:
    """The checks that decide; where none does, all by the letter of a code."""
    letters = [check for check in mechanism.checks if check.reading == "letter" and not check.informs]
    return [check for check in letters if check.role == "deciding"] or letters


def worst_ratio(checks: Sequence[Check]) -> float | None:
    """The largest demand over capacity of the checks that are answered; None where none is."""
    return max((ratio_of(check) for check in checks if check.verdict in (Outcome.PASS, Outcome.FAIL)), default=None)


def least_capacity(checks: Sequence[Check]) -> float | None:
    """The least PGA at capacity [g]; None where no check knows one."""
    return min((check.capacity_pga_g for check in checks if check.capacity_pga_g is not None), default=None)


def ratio_of(check: Check) -> float:
    """Demand over capacity [-], infinite where the body overturned."""
    if check.ratio is not None:
        return check.ratio
    return inf if check.verdict == Outcome.FAIL else 0.0


def weaker_branch(mechanism: MechanismResult) -> OscillatorResult:
    """The branch that uplifts first, the positive one of equals."""
    branches = [mechanism.oscillator, mechanism.oscillator_negative]
    known = [branch for branch in branches if branch is not None]
    return min(known, key=lambda branch: inf if branch.uplift_multiplier is None else branch.uplift_multiplier)


def controlling_cases(sweeps: Sequence[MechanismSweep]) -> dict[str, MechanismSweep]:
    """By mechanism the sweep whose controlling case stands for it: the most severe, the first of equals."""
    standing: dict[str, MechanismSweep] = {}
    for one in sweeps:
        before = standing.get(one.mechanism)
        if before is None or severity(one.judged[one.controlling]) > severity(before.judged[before.controlling]):
            standing[one.mechanism] = one
    return standing


def case_messages(swept: MechanismSweep) -> Iterator[Message]:
    """Which case stands for the mechanism, and the notices of that case."""
    where, sweep = f"mechanisms.{swept.mechanism}", swept.sweep
    case = f"{sweep.key} = {value_text(sweep, swept.case)}"
    yield note("sweep", where, cases=whole_number(len(sweep.cases)), case=case)
    for mechanism in swept.case.study.mechanisms:
        if mechanism.name == swept.mechanism:
            yield from (warning("mechanism", where, text=notice) for notice in mechanism.notices)


def case_text(sweep: Sweep, case: Case, mechanism: str) -> str:
    """A case in a few words: the key below its table or the mechanism's own, and the value."""
    key = sweep.key
    for table in (f"mechanisms.{mechanism}.", "bodies.", "materials."):
        key = key.removeprefix(table)
    return f"{key} = {value_text(sweep, case)}"


def value_text(sweep: Sweep, case: Case) -> str:
    """The value of a case with its unit."""
    return f"{case.value:.6g}" + ("" if sweep.unit == "-" else f" {sweep.unit}")


def sweep_results(sweeps: Sequence[MechanismSweep], standing: Mapping[str, MechanismSweep]) -> tuple[SweepResult, ...]:
    """The sweeps as the results hold them."""
    return tuple(sweep_result(one, governs=standing[one.mechanism] is one) for one in sweeps)


def sweep_result(swept: MechanismSweep, *, governs: bool) -> SweepResult:
    """One mechanism over the values of one sweep, by the branch that uplifts first in each case."""
    branches = [weaker_branch(result) for result in swept.results]
    checks = [deciding_checks(result) for result in swept.results]
    ratios = [worst_ratio(each) for each in checks]
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
        overturned=tuple(any(check.unbounded == "overturned" for check in each) for each in checks),
        capacity_pga_g=tuple(least_capacity(each) for each in checks),
        outcome=tuple(each.verdict.outcome for each in swept.judged),
        controlling=swept.controlling,
        governs=governs,
    )
