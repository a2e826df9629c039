"""Which of many results decide: the worst check of a procedure, the worst history, the verdict of a mechanism."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from math import inf
from typing import Literal

from assess.codes.check import Check
from assess.codes.family import of_histories
from assess.results import ComparisonRow, HistoryResult, MechanismResult, Results, Trace

DAMAGE = "SLD"
Outcome = Literal["pass", "fail", "incomplete", "not-applicable"]


def fell(check: Check) -> bool:
    """Whether the check failed because the body overturned."""
    return check.unbounded == "overturned"


def severity(check: Check) -> float:
    """Demand over allowable [-]: infinite where there is no finite demand, negative where the check does not apply."""
    if check.verdict in ("not-answered", "not-applicable"):
        return -1.0
    if check.ratio is not None:
        return check.ratio
    return inf if check.verdict == "fail" else 0.0


def worst(checks: tuple[Check, ...]) -> Check | None:
    """The failing check with the largest severity, else the passing one; of equals the lowest level."""
    ranked = sorted(checks, key=lambda check: (check.verdict != "fail", -severity(check), check.level_pga_g))
    return ranked[0] if ranked else None


def of_code(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """The checks that decide: readings of a code, not informative ones."""
    return tuple(check for check in checks if check.reading == "letter" and not check.informs)


def at_level(checks: tuple[Check, ...], level_pga_g: float) -> tuple[Check, ...]:
    """The checks at one level [g]."""
    return tuple(check for check in checks if check.level_pga_g == level_pga_g)


def verdict(checks: tuple[Check, ...]) -> Outcome:
    """One verdict of several checks that decide: fail if any fails, pass if all pass, incomplete if only some do."""
    found = {check.verdict for check in of_code(checks)}
    if "fail" in found:
        return "fail"
    if "pass" not in found:
        return "not-applicable"
    return "incomplete" if found & {"not-answered", "not-applicable"} else "pass"


def of_all(results: Results) -> tuple[Check, ...]:
    """The checks of every mechanism that decide."""
    return tuple(check for mechanism in results.mechanisms for check in of_code(mechanism.checks))


def unanswered(checks: tuple[Check, ...]) -> str:
    """How many of the checks that decide could not be answered, of how many; empty where all were."""
    deciding = of_code(checks)
    silent = sum(check.verdict == "not-answered" for check in deciding)
    return f"{silent} of {len(deciding)} checks could not be answered" if silent else ""


def reasons(checks: tuple[Check, ...]) -> tuple[str, ...]:
    """Why checks that decide could not be answered, each reason once: procedure, reason, and how many they are."""
    silent = [check for check in of_code(checks) if check.verdict == "not-answered"]
    counts = Counter((check.procedure, check.reason.text) for check in silent)
    return tuple(
        f"{procedure}: {reason}" + (f" ({number} checks)" if number > 1 else "")
        for (procedure, reason), number in counts.items()
    )


def levels(checks: tuple[Check, ...]) -> tuple[float, ...]:
    """The levels of the checks [g], rising."""
    return tuple(sorted({check.level_pga_g for check in checks}))


def procedures(results: Results) -> tuple[str, ...]:
    """Every procedure that was asked, in order of appearance."""
    return tuple(dict.fromkeys(check.procedure for mechanism in results.mechanisms for check in mechanism.checks))


def worst_per_procedure(mechanism: MechanismResult) -> tuple[Check, ...]:
    """For each procedure and limit state the check that governs, in order of appearance."""
    keys = dict.fromkeys((check.procedure, check.limit_state) for check in mechanism.checks)
    groups = (tuple(c for c in mechanism.checks if (c.procedure, c.limit_state) == key) for key in keys)
    return tuple(check for check in map(worst, groups) if check is not None)


def named(check: Check, among: tuple[Check, ...]) -> str:
    """The procedure of a check, with its limit state where `among` has others of the same procedure."""
    states = {other.limit_state for other in among if other.procedure == check.procedure}
    return f"{check.procedure} {check.limit_state}".strip() if len(states) > 1 else check.procedure


def history(mechanism: MechanismResult) -> tuple[HistoryResult, Trace] | None:
    """The worst history with a trace: overturned before standing, then the largest rotation; None without traces."""
    traced = [(history, history.trace) for history in mechanism.histories if history.trace is not None]
    if not traced:
        return None
    return max(traced, key=lambda pair: (pair[0].overturned, abs(pair[0].max_rotation_ratio or 0.0)))


def allowable(mechanism: MechanismResult, level_pga_g: float) -> float | None:
    """Allowable rotation / phi_ov [-] of the mechanism's history procedure at a level; None without one."""
    checks = at_level(mechanism.checks, level_pga_g)
    found = (check.capacity_rotation_ratio for check in checks if of_histories(check.procedure))
    return next((ratio for ratio in found if ratio is not None), None)


def check_of(results: Results, row: ComparisonRow) -> Check | None:
    """The worst check behind a row of the comparison."""
    mechanism = next((m for m in results.mechanisms if m.name == row.mechanism), None)
    checks = () if mechanism is None else at_level(mechanism.checks, row.level_pga_g)
    return worst(tuple(check for check in checks if check.procedure == row.procedure))


def overturned(results: Results) -> frozenset[ComparisonRow]:
    """The rows of the comparison where the body overturned."""
    pairs = ((row, check_of(results, row)) for row in results.comparison)
    return frozenset(row for row, check in pairs if check is not None and fell(check))


def drawn(results: Results) -> tuple[ComparisonRow, ...]:
    """The rows of the comparison, those whose demand lies beyond the end of the spectrum with an infinite one."""
    pairs = ((row, check_of(results, row)) for row in results.comparison)
    beyond = [check is not None and check.unbounded == "beyond the spectrum" for _, check in pairs]
    return tuple(
        replace(row, demand_capacity=inf) if far else row for row, far in zip(results.comparison, beyond, strict=True)
    )


def outcome(results: Results) -> Outcome:
    """One verdict of the whole run."""
    return verdict(of_all(results))


def of_collapse(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """The checks of each procedure but those of damage, where it has others: SLD comes before collapse."""
    ultimate = {check.procedure for check in checks if check.limit_state != DAMAGE}
    return tuple(check for check in checks if check.limit_state != DAMAGE or check.procedure not in ultimate)


def weakest(checks: tuple[Check, ...]) -> Check | None:
    """The check of collapse with the least known PGA at capacity; the first of equals."""
    answered = (check for check in of_collapse(checks) if check.verdict in ("pass", "fail"))
    known = [check for check in answered if check.capacity_pga_g is not None]
    return min(known, key=lambda check: check.capacity_pga_g or 0.0, default=None)


def capacities(checks: tuple[Check, ...]) -> dict[str, float]:
    """The least PGA at capacity of each procedure that knows one [g], of its limit states of collapse."""
    found: dict[str, float] = {}
    for check in of_collapse(checks):
        if check.capacity_pga_g is not None:
            found[check.procedure] = min(check.capacity_pga_g, found.get(check.procedure, inf))
    return found


def by_procedure(checks: tuple[Check, ...]) -> dict[str, tuple[Check, ...]]:
    """The checks of each procedure, in order of appearance."""
    names = dict.fromkeys(check.procedure for check in checks)
    return {name: tuple(check for check in checks if check.procedure == name) for name in names}
