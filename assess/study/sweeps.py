"""The sweeps of a study: every mechanism that a sweep changes, assessed in all its cases, and which case controls.

The controlling case of a mechanism is the one with the worst answer that decides: a failing case before an incomplete
one, an incomplete one before one that passes. Of equals it is the one with the least margin over the site's own action,
then the one with the largest demand over capacity (overturning before any ratio), then with the least PGA at capacity,
then with the least multiplier at uplift; then the first. If nothing decides, as without a basis, all checks by the
letter of a code are used instead.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf

from assess.codes.check import Check, Outcome
from assess.codes.verdict import Decision, MechanismVerdict
from assess.errors import locate_errors
from assess.messages.message import Message, locate, note, whole_number
from assess.results import MechanismResult, OscillatorResult, SweepResult
from assess.study.checks import assess_mechanisms, decide, mark_result
from assess.study.record_set import motions_of
from assess.study.study import Progress, ScaledRecord, Study, Sweep, SweepCase, report_nothing, value_text
from assess.study.suite_rules import suite_faults


def run_sweeps(
    study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int, progress: Progress
) -> tuple[MechanismSweep, ...]:
    """Assess every mechanism that a sweep changes in all its cases, one sweep after the other."""
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


def assess_case(
    case: SweepCase, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int
) -> tuple[MechanismInCase, ...]:
    """Assess the mechanisms of one case, under the motions of the study unless the case changes them."""
    spectrum = case.study.spectrum
    assert spectrum is not None  # no number takes the site away
    moving = motions_of_case(case, study, motions, jobs=jobs)
    faults = study.suite_faults if moving is motions else suite_faults(case.study, spectrum, moving)
    judged = replace(case.study, suite_faults=faults)
    done = assess_mechanisms(judged, spectrum, moving, jobs=jobs, progress=report_nothing)
    found = decide(judged, done)
    each = zip(done, found.mechanisms, strict=True)
    return tuple(MechanismInCase(mark_result(found, judged.question, result), one) for result, one in each)


def motions_of_case(
    case: SweepCase, study: Study, motions: tuple[ScaledRecord, ...], *, jobs: int
) -> tuple[ScaledRecord, ...]:
    """Return the motions of the study itself, or those of a case that changes them or the site."""
    of = case.study
    assert of.spectrum is not None  # no number takes the site away
    same = all(getattr(of, key) == getattr(study, key) for key in ("artificial", "scale_to", "record_factor"))
    if same and of.spectrum is study.spectrum and of.records is study.records:
        return motions
    return motions_of(of, of.spectrum, jobs=jobs)


@dataclass(frozen=True)
class MechanismInCase:
    """One mechanism in one case, with its verdict."""

    result: MechanismResult
    verdict: MechanismVerdict


@dataclass(frozen=True)
class MechanismSweep:
    """One mechanism in all cases of one sweep.

    judged : the mechanism in each case, with its verdict [n]; controlling : the case that controls, counted from 0
    """

    sweep: Sweep
    judged: tuple[MechanismInCase, ...]
    controlling: int

    @property
    def results(self) -> tuple[MechanismResult, ...]:
        """The mechanism in each case."""
        return tuple(each.result for each in self.judged)

    @property
    def mechanism(self) -> str:
        """The name of the mechanism."""
        return self.results[0].name

    @property
    def worst(self) -> MechanismResult:
        """The mechanism in the controlling case."""
        return self.results[self.controlling]

    @property
    def case(self) -> SweepCase:
        """The controlling case."""
        return self.sweep.cases[self.controlling]


RANKS = (Decision.PASS, Decision.INCOMPLETE, Decision.FAIL)


def controlling_cases(sweeps: Sequence[MechanismSweep]) -> dict[str, MechanismSweep]:
    """Return, for each mechanism, the sweep whose controlling case represents it: the most severe one."""
    found: dict[str, MechanismSweep] = {}
    for one in sweeps:
        before = found.get(one.mechanism)
        if before is None or severity(one.judged[one.controlling]) > severity(before.judged[before.controlling]):
            found[one.mechanism] = one
    return found


def controlling_index(cases: Sequence[MechanismInCase]) -> int:
    """Return which of the cases controls, counted from 0: the first of the most severe."""
    return max(range(len(cases)), key=lambda place: (severity(cases[place]), -place))


def severity(case: MechanismInCase) -> tuple[float, ...]:
    """Return what the controlling case has the largest of: outcome, -margin, ratio, -PGA at capacity, -multiplier."""
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
    """Round to nine figures, so that cases that differ by rounding count as equal."""
    return float(f"{value:.9g}")


def deciding_checks(mechanism: MechanismResult) -> list[Check]:
    """Return the checks that decide; if none does, all by the letter of a code."""
    letters = [check for check in mechanism.checks if check.reading == "letter" and not check.informs]
    return [check for check in letters if check.role == "deciding"] or letters


def worst_ratio(checks: Sequence[Check]) -> float | None:
    """Return the largest demand over capacity of the checks that pass or fail; None if there are none."""
    return max((ratio_of(check) for check in checks if check.verdict in (Outcome.PASS, Outcome.FAIL)), default=None)


def least_capacity(checks: Sequence[Check]) -> float | None:
    """Return the least PGA at capacity [g]; None if no check has one."""
    return min((check.capacity_pga_g for check in checks if check.capacity_pga_g is not None), default=None)


def ratio_of(check: Check) -> float:
    """Return demand over capacity [-], inf where the body overturned."""
    if check.ratio is not None:
        return check.ratio
    return inf if check.verdict == Outcome.FAIL else 0.0


def weaker_branch(mechanism: MechanismResult) -> OscillatorResult:
    """Return the branch that uplifts first; of equals, the positive one."""
    branches = [mechanism.oscillator, mechanism.oscillator_negative]
    known = [branch for branch in branches if branch is not None]
    return min(known, key=lambda branch: inf if branch.uplift_multiplier is None else branch.uplift_multiplier)


def sweep_results(
    sweeps: Sequence[MechanismSweep], controlling: Mapping[str, MechanismSweep]
) -> tuple[SweepResult, ...]:
    """Return the sweeps as results."""
    return tuple(sweep_result(one, governs=controlling[one.mechanism] is one) for one in sweeps)


def sweep_result(found: MechanismSweep, *, governs: bool) -> SweepResult:
    """Return one mechanism over the values of one sweep, by the branch that uplifts first in each case."""
    branches = [weaker_branch(result) for result in found.results]
    checks = [deciding_checks(result) for result in found.results]
    ratios = [worst_ratio(each) for each in checks]
    return SweepResult(
        mechanism=found.mechanism,
        key=found.sweep.key,
        unit=found.sweep.unit,
        value=tuple(case.value for case in found.sweep.cases),
        p_eq_per_s=tuple(branch.p_eq_per_s for branch in branches),
        uplift_multiplier=tuple(branch.uplift_multiplier for branch in branches),
        overturning_rad=tuple(branch.overturning_rad for branch in branches),
        overturning_flexible_rad=tuple(branch.overturning_flexible_rad for branch in branches),
        elastic_frequency_hz=tuple(branch.elastic_frequency_hz for branch in branches),
        restitution=tuple(branch.restitution for branch in branches),
        demand_capacity=tuple(None if ratio == inf else ratio for ratio in ratios),
        overturned=tuple(any(check.unbounded == "overturned" for check in each) for each in checks),
        capacity_pga_g=tuple(least_capacity(each) for each in checks),
        outcome=tuple(each.verdict.outcome for each in found.judged),
        controlling=found.controlling,
        governs=governs,
    )


def case_messages(found: MechanismSweep) -> Iterator[Message]:
    """Yield which case represents the mechanism, and the messages on the mechanism in that case."""
    where, sweep = f"mechanisms.{found.mechanism}", found.sweep
    case = f"{sweep.key} = {value_text(sweep, found.case)}"
    yield note("sweep", where, cases=whole_number(len(sweep.cases)), case=case)
    for mechanism in found.case.study.mechanisms:
        if mechanism.name == found.mechanism:
            yield from locate(mechanism.warnings, where)
