"""The rows of a sensitivity: each answer of a mechanism at the base, the low and the high value of one number."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from assess.codes.basis import Basis
from assess.codes.check import Check
from assess.codes.families import uses_histories
from assess.codes.verdict.answer import index_of
from assess.messages.message import Message, Term, message
from assess.results import SensitivityResult
from assess.study.study import Unvaried, Variable

Answer = tuple[str, str, float]
"""What distinguishes a check from the others of a mechanism: procedure, limit state, level [g]."""


@dataclass(frozen=True)
class CaseAnswers:
    """The checks of one case, by what they answer; or why it could not be assessed."""

    checks: dict[Answer, Check]
    error: str = ""


def by_answer(checks: Sequence[Check]) -> dict[Answer, Check]:
    """Return checks by what they answer; of several, the first."""
    found: dict[Answer, Check] = {}
    for check in checks:
        found.setdefault((check.procedure, check.limit_state, check.level_pga_g), check)
    return found


def rows_of(
    variable: Variable, deciding: Sequence[Check], low: CaseAnswers, high: CaseAnswers, *, basis: Basis | None
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
    for key, check in by_answer(deciding).items():
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


def remarks_on(variable: Variable, low: CaseAnswers, high: CaseAnswers) -> Iterator[Term | Message]:
    """Yield the remark on a variable, and why a case of it could not be assessed; that is an error, in English."""
    if variable.remark:
        yield Term(variable.remark)
    if low.error:
        yield message("not-assessed-low", {"value": f"{variable.low:.6g}", "why": low.error})
    if high.error:
        yield message("not-assessed-high", {"value": f"{variable.high:.6g}", "why": high.error})


def unvaried_row(unvaried: Unvaried) -> SensitivityResult:
    """Return the row of a number that is not varied."""
    said = message("not-varied", {"why": Term(unvaried.why)})
    return SensitivityResult(
        mechanism=unvaried.mechanism, parameter=unvaried.parameter, remark=said.text, remarks=(said,)
    )
