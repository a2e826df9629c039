"""The sweeps of a study in the results, and messages on them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import inf

from assess.messages.message import Message, locate, note, whole_number
from assess.results import SweepResult
from assess.study.case_severity import deciding_checks, least_capacity, weaker_branch, worst_ratio
from assess.study.study import Case, Sweep
from assess.study.sweep_cases import MechanismSweep


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


def case_text(sweep: Sweep, case: Case, mechanism: str) -> str:
    """Return a case in a few words: the key without its table, and the value."""
    key = sweep.key
    for table in (f"mechanisms.{mechanism}.", "bodies.", "materials."):
        key = key.removeprefix(table)
    return f"{key} = {value_text(sweep, case)}"


def value_text(sweep: Sweep, case: Case) -> str:
    """Return the value of a case with its unit."""
    return f"{case.value:.6g}" + ("" if sweep.unit == "-" else f" {sweep.unit}")
