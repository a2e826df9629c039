"""The results that represent many others: the worst check of a procedure, the worst history."""

from __future__ import annotations

from dataclasses import replace
from math import inf, isclose

from assess.codes.bases import BASES
from assess.codes.check import Check, Outcome
from assess.codes.procedures import PROCEDURES, uses_histories
from assess.codes.verdict import Decision, MechanismVerdict
from assess.results import ComparisonRow, HistoryResult, HistoryTrace, MechanismResult, Results

DAMAGE = "SLD"
SAME_LEVEL = 1e-9  # relative difference of levels that are one
UNANSWERED = (Outcome.NOT_ANSWERED, Outcome.NOT_APPLICABLE)


def is_overturned(check: Check) -> bool:
    """Return whether the check failed because the body overturned."""
    return check.unbounded == "overturned"


def severity(check: Check) -> float:
    """Return demand over allowable [-]: infinite without a finite demand, negative without an answer."""
    if check.verdict in UNANSWERED:
        return -1.0
    if check.ratio is not None:
        return check.ratio
    return inf if check.verdict == Outcome.FAIL else 0.0


def worst_check(checks: tuple[Check, ...]) -> Check | None:
    """Return the failing check with the largest severity, else the passing one; of equals the lowest level."""
    ranked = sorted(checks, key=lambda check: (check.verdict != Outcome.FAIL, -severity(check), check.level_pga_g))
    return ranked[0] if ranked else None


def code_checks(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the checks by the letter of a code: no readings of the thesis, none that only inform."""
    return tuple(check for check in checks if check.follows_code)


def by_own_code(results: Results) -> Results:
    """Return the results without procedures of other codes than the one that decides, as the signed pages show them.

    They are kept where the project lists its procedures, where no code decides, and where the one that does leaves a
    mechanism without an answer.
    """
    verdict, listed = results.verdict, results.project.get("analysis.procedures")
    if verdict is None or verdict.basis not in BASES or (listed is not None and listed.given):
        return results
    if any(answer.outcome == Decision.INCOMPLETE for each in verdict.mechanisms for answer in each.answers):
        return results
    codes = {PROCEDURES[name].options for name in BASES[verdict.basis].methods} | {""}
    others = {each.name for each in PROCEDURES.values() if each.options not in codes or each.reading == "thesis"}
    return replace(
        results,
        mechanisms=tuple(
            replace(each, checks=tuple(check for check in each.checks if check.procedure not in others))
            for each in results.mechanisms
        ),
        comparison=tuple(row for row in results.comparison if row.procedure not in others),
    )


def answered_checks(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the checks that pass or fail: what one that is not answered finds may be on the unsafe side."""
    return tuple(check for check in checks if check.verdict not in UNANSWERED)


def checks_at_level(checks: tuple[Check, ...], level_pga_g: float) -> tuple[Check, ...]:
    """Return the checks at one level [g]."""
    return tuple(check for check in checks if isclose(check.level_pga_g, level_pga_g, rel_tol=SAME_LEVEL))


def site_pga(results: Results) -> float | None:
    """Return the site's own peak ground acceleration [g], that of the verdict; None without a verdict."""
    return None if results.verdict is None else results.verdict.action.pga_g


def verdict_of(results: Results, mechanism: MechanismResult) -> MechanismVerdict | None:
    """Return the verdict of a mechanism; None in results without one."""
    verdicts = () if results.verdict is None else results.verdict.mechanisms
    return next((one for one in verdicts if one.mechanism == mechanism.name), None)


def checks_at_site(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    """Return the checks of a mechanism at the site's own action; all of them without a verdict."""
    own = site_pga(results)
    return mechanism.checks if own is None else checks_at_level(mechanism.checks, own)


def code_checks_at_site(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    """Return the checks of a mechanism by the letter of a code at the site's own action."""
    return code_checks(checks_at_site(results, mechanism))


def other_levels(results: Results) -> tuple[float, ...]:
    """Return the levels of the study besides the site's own [g], rising."""
    own, every = site_pga(results), (check for mechanism in results.mechanisms for check in mechanism.checks)
    return tuple(x for x in pga_levels(tuple(every)) if own is None or not isclose(x, own, rel_tol=SAME_LEVEL))


def pga_levels(checks: tuple[Check, ...]) -> tuple[float, ...]:
    """Return the levels of the checks [g], rising."""
    return tuple(sorted({check.level_pga_g for check in checks}))


def worst_per_procedure(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the worst check of each procedure and limit state, in order of appearance."""
    keys = dict.fromkeys((check.procedure, check.limit_state) for check in checks)
    groups = (tuple(c for c in checks if (c.procedure, c.limit_state) == key) for key in keys)
    return tuple(check for check in map(worst_check, groups) if check is not None)


def governing_history(mechanism: MechanismResult) -> tuple[HistoryResult, HistoryTrace] | None:
    """Return the worst history with a trace: overturned first, then the largest rotation; None without traces."""
    traced = [(history, history.trace) for history in mechanism.histories if history.trace is not None]
    if not traced:
        return None
    return max(traced, key=lambda pair: (pair[0].overturned, abs(pair[0].max_rotation_ratio or 0.0)))


def allowable_rotation(mechanism: MechanismResult, level_pga_g: float) -> float | None:
    """Return the allowable rotation / phi_ov [-] of the mechanism's history procedure at a level; None without one."""
    checks = checks_at_level(mechanism.checks, level_pga_g)
    found = (check.capacity_rotation_ratio for check in checks if uses_histories(check.procedure))
    return next((ratio for ratio in found if ratio is not None), None)


def check_of(results: Results, row: ComparisonRow) -> Check | None:
    """Return the worst check behind a row of the comparison."""
    mechanism = next((m for m in results.mechanisms if m.name == row.mechanism), None)
    checks = () if mechanism is None else checks_at_level(mechanism.checks, row.level_pga_g)
    return worst_check(tuple(check for check in checks if check.procedure == row.procedure))


def capacities(checks: tuple[Check, ...]) -> dict[str, float]:
    """Return the least PGA at capacity [g] of each procedure that applies, of its limit states of collapse."""
    found: dict[str, float] = {}
    for check in _collapse_checks(checks):
        if check.capacity_pga_g is not None and check.verdict != Outcome.NOT_APPLICABLE:
            found[check.procedure] = min(check.capacity_pga_g, found.get(check.procedure, inf))
    return found


def group_by_procedure(checks: tuple[Check, ...]) -> dict[str, tuple[Check, ...]]:
    """Group the checks by procedure, in order of appearance."""
    names = dict.fromkeys(check.procedure for check in checks)
    return {name: tuple(check for check in checks if check.procedure == name) for name in names}


def _collapse_checks(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    """Return the checks without those of damage (SLD), which comes before collapse, where a procedure has others."""
    ultimate = {check.procedure for check in checks if check.limit_state != DAMAGE}
    return tuple(check for check in checks if check.limit_state != DAMAGE or check.procedure not in ultimate)
