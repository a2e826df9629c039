"""Which case of a sweep controls.

The controlling case of a mechanism is the one with the worst answer that decides: a failing case before an incomplete
one, an incomplete one before one that passes. Of equals it is the one with the least margin over the site's own action,
then the one with the largest demand over capacity (overturning before any ratio), then with the least PGA at capacity,
then with the least multiplier at uplift; then the first. If nothing decides, as without a basis, all checks by the
letter of a code are used instead.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from assess.codes.check import Check, Outcome
from assess.codes.verdict import Decision
from assess.results import MechanismResult, OscillatorResult
from assess.study.sweep_cases import CaseResult, MechanismSweep

RANKS = (Decision.PASS, Decision.INCOMPLETE, Decision.FAIL)


def controlling_cases(sweeps: Sequence[MechanismSweep]) -> dict[str, MechanismSweep]:
    """Return, for each mechanism, the sweep whose controlling case represents it: the most severe one."""
    found: dict[str, MechanismSweep] = {}
    for one in sweeps:
        before = found.get(one.mechanism)
        if before is None or severity(one.judged[one.controlling]) > severity(before.judged[before.controlling]):
            found[one.mechanism] = one
    return found


def controlling_index(cases: Sequence[CaseResult]) -> int:
    """Return which of the cases controls, counted from 0: the first of the most severe."""
    return max(range(len(cases)), key=lambda place: (severity(cases[place]), -place))


def severity(case: CaseResult) -> tuple[float, ...]:
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
