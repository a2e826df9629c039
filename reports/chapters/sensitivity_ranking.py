"""The varied numbers of a mechanism, ranked by their effect on its answers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, log
from typing import Literal

from assess.codes.check import Outcome
from assess.codes.families import uses_histories
from assess.results import SensitivityResult
from reports.governing import DAMAGE

Case = Literal["base", "low", "high"]
"""The value of a number: as assessed, low or high."""

Side = Literal["low", "high"]
SIDES: tuple[Side, Side] = ("low", "high")
CASES: tuple[Case, ...] = ("base", *SIDES)
NEGLIGIBLE = 2e-3  # of its value: no history repeats better than this when all masses are multiplied by a number


@dataclass(frozen=True)
class VariedInput:
    """One number of a mechanism.

    rows : all its answers; shown : those that represent them, in one order for all numbers of the mechanism: the PGA at
    capacity and the ratio of the procedure that governs, as far as they are known, and the ratio of the histories
    """

    rows: tuple[SensitivityResult, ...]
    shown: tuple[SensitivityResult, ...]

    @property
    def decisive(self) -> tuple[SensitivityResult, ...]:
        """The rows of the deciding procedures; all rows where none decides."""
        return tuple(row for row in self.rows if row.role == "deciding") or self.rows

    @property
    def number(self) -> SensitivityResult:
        """Any of its rows, for what all share: parameter, key, unit, base, low, high, remark."""
        return self.rows[0]


def rank_inputs(rows: Sequence[SensitivityResult]) -> tuple[VariedInput, ...]:
    """Return every varied number of a mechanism, the one with the largest effect on the answers shown first."""
    numbers: dict[tuple[str, str], list[SensitivityResult]] = {}
    for row in rows:
        if row.quantity:
            numbers.setdefault((row.parameter, row.key), []).append(row)
    if not numbers:
        return ()
    wanted = [answer_key(row) for row in representative_answers(next(iter(numbers.values())))]
    found = [_varied_input(each, wanted) for each in numbers.values()]
    return tuple(sorted(found, key=lambda each: [0.0 if is_negligible(row) else -span(row) for row in each.shown]))


def _varied_input(
    rows: Sequence[SensitivityResult], wanted: Sequence[tuple[str, str, str, float | None]]
) -> VariedInput:
    by_identity = {answer_key(row): row for row in reversed(rows)}
    return VariedInput(tuple(rows), tuple(by_identity[each] for each in wanted))


def answer_key(row: SensitivityResult) -> tuple[str, str, str, float | None]:
    """Return quantity, procedure, limit state and level of an answer."""
    return row.quantity, row.procedure, row.limit_state, row.level_pga_g


def representative_answers(rows: Sequence[SensitivityResult]) -> list[SensitivityResult]:
    """Choose, among the answers of one number, those that represent all.

    These are the index of the deciding answer, and the PGA at capacity of its procedure. Where none decides, they are
    those of the procedure with the least PGA at capacity, at the level nearest to it, and of the histories at this
    level; where no PGA at capacity is known, of the check with the worst ratio. Damage comes before collapse and
    replaces it only where a procedure has nothing else.
    """
    index = [row for row in rows if row.quantity == "index"]
    if index:
        decide = {(row.procedure, row.limit_state) for row in index}
        return [*index, *(r for r in rows if r.quantity == "capacity_pga_g" and (r.procedure, r.limit_state) in decide)]
    ultimate = {row.procedure for row in rows if row.limit_state != DAMAGE}
    rows = [row for row in rows if row.limit_state != DAMAGE or row.procedure not in ultimate]
    ratios = [row for row in rows if row.quantity == "demand_capacity"]
    known = [row for row in rows if row.quantity == "capacity_pga_g" and row.at_base]
    if not known:
        return sorted(ratios, key=lambda row: answer_value(row, "base") or 0.0)[-1:]
    least = min(known, key=lambda row: row.at_base or inf)
    levels = sorted({row.level_pga_g or 0.0 for row in ratios})
    near = min(levels, key=lambda level: abs(log(level / (least.at_base or level))), default=None)
    there = [row for row in ratios if row.level_pga_g == near]
    own = [row for row in there if (row.procedure, row.limit_state) == (least.procedure, least.limit_state)]
    return [least, *own[:1], *[row for row in there if uses_histories(row.procedure)][:1]]


def answer_value(row: SensitivityResult, at: Case) -> float | None:
    """Return the answer in a case: infinite where the body overturns, None where it is not known."""
    found = {"base": row.at_base, "low": row.at_low, "high": row.at_high}[at]
    return inf if found is None and verdict_at(row, at) == Outcome.FAIL else found


def verdict_at(row: SensitivityResult, at: Case) -> Outcome | None:
    """Return the verdict in a case; None where it was not assessed."""
    return {"base": row.verdict_base, "low": row.verdict_low, "high": row.verdict_high}[at]


def span(row: SensitivityResult) -> float:
    """Return the width of the range of an answer; 0 where it is not known, or overturns in all cases."""
    known = [found for at in CASES if (found := answer_value(row, at)) is not None]
    return max(known) - min(known) if known and min(known) < inf else 0.0


def is_negligible(row: SensitivityResult) -> bool:
    """Return whether an answer hardly changes."""
    return span(row) <= NEGLIGIBLE * (row.at_base or 0.0)


def flips(row: SensitivityResult, side: Side) -> bool:
    """Return whether a verdict changes from pass to fail or back."""
    return {row.verdict_base, verdict_at(row, side)} == {Outcome.PASS, Outcome.FAIL}


def fails(rows: Sequence[SensitivityResult], at: Case) -> bool:
    """Return whether any check fails in a case."""
    return any(verdict_at(row, at) == Outcome.FAIL for row in rows)
