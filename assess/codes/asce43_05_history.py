"""ASCE/SEI 43-05, response-history method: the mean of the largest rotations of at least five records.

The best estimate of the demand is the mean of the maxima; a factor of 2 on instability makes half the rotation that
overturns the allowable one (thesis 3.3.2 and 8.4.2, Table 8.10). Each maximum is divided by the rotation that really
overturns the mechanism in the branch where it happened, joints included. A record that overturns the body fails the
level. A pass needs the rule to hold in 84 % of the draws among the runs of each record, too.

The histories have one horizontal component and no vertical motion. A pass has a condition where the scan does not reach
F_V (Eq. A-5(b)) times the action, and 1.08 times that for a body that stands free, or where the motion of a floor has
no vertical ratio.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from assess.codes.asce43_05 import (
    A2,
    EDITION,
    FLOOR_KEY,
    HALF,
    Asce4305Options,
    component_factor,
    component_step,
    falls_short,
    lacks_vertical_floor,
    vertical_factor,
    warn_at_height,
    with_floor_ratio,
)
from assess.codes.calculation_sheet import Step, instability_step, multiplier_step, step
from assess.codes.check import (
    ELASTIC,
    BuildingState,
    Check,
    CodeProcedure,
    DefaultRun,
    Family,
    NumericalSpread,
    Outcome,
    PgaCurve,
    Reason,
    branch_of,
    caveats_of,
    reason_message,
)
from assess.codes.context import Context
from assess.codes.histories import (
    Capacities,
    RuleShares,
    SuiteResponse,
    SuiteRule,
    capacities_by_share,
    fails_below,
    numerical_spread,
    pga_curve,
    rule_shares,
    scan_conditions,
    spread_steps,
    uplift_multiplier,
    with_spread,
)
from assess.messages.message import Message, Quantity, Severity, Term, message, whole_number
from assess.oscillator import Branch, Oscillator, linear_multiplier
from spectra.arrays import FloatArray
from spectra.gravity import g

CLAUSE = "ASCE 43-05, response-history method"
CAVEAT = "the method was read in Mehrotra, not in the printed standard"
LEAST_RECORDS = 5


PERIOD_UNCERTAINTY = 1.15
BUILDINGS = (ELASTIC, BuildingState(PERIOD_UNCERTAINTY), BuildingState(1.0 / PERIOD_UNCERTAINTY))
"""The elastic building with the uncertainty of its frequency, by which peaks of floor spectra are broadened too."""


def assess_history(oscillator: Oscillator, context: Context, *, options: Asce4305Options) -> tuple[Check, ...]:
    """Return one check for each level that has a suite of time histories."""
    (rule,) = history_rules(oscillator, context, options=options)
    lifts = uplift_multiplier(oscillator, linearised=context.linearised)
    scanned = ScanResult(
        pga_curve(context.incremental),
        capacities_by_share(context.incremental, rule),
        None if lifts is None else lifts / context.amplification,
    )
    checks = (
        _check(oscillator, suite, context, scanned, numerical_spread(suite, rule.measure, scanned.holds_to))
        for suite in context.suites
    )
    complete = (_with_all_components(check, oscillator, context, options) for check in checks)
    return warn_at_height(tuple(complete), context=context)


def history_rules(oscillator: Oscillator, context: Context, *, options: Asce4305Options) -> tuple[SuiteRule, ...]:
    """Return the rule that a suite is held to: no record overturns, and the mean is within half the instability."""

    def passes(suite: SuiteResponse) -> bool:
        share = mean_share(suite, oscillator)
        return share is not None and share <= HALF

    def measure(suite: SuiteResponse) -> RuleShares:
        ratios = _run_shares(suite, oscillator) / HALF
        return rule_shares(ratios, np.isfinite(ratios))

    return (SuiteRule(measure, passes, LEAST_RECORDS),)


ASCE43_05_HISTORY = CodeProcedure(
    name="asce43-05-history",
    family=Family.HISTORY,
    assess=assess_history,
    title=Term("ASCE 43-05, response history"),
    short_title=Term("ASCE 43-05 history"),
    work="asce43-05",
    options="asce43_05",
    default_run=DefaultRun(),
    suite_rules="asce43-05",
    history_rules=history_rules,
    buildings=BUILDINGS,
    building_clause="ASCE 43-05",
)


@dataclass(frozen=True)
class ScanResult:
    """What suites at rising PGA give: their curve, the PGA up to which the rule holds, and that at uplift [g]."""

    curve: PgaCurve
    holds_to: Capacities
    uplift: float | None


def mean_share(suite: SuiteResponse, oscillator: Oscillator) -> float | None:
    """Return the mean of the shares [-]; None where a record overturned, or where there is none."""
    found = _rotation_shares(suite, oscillator)
    standing = [share for share in found if share is not None]
    return sum(standing) / len(standing) if len(standing) == len(found) > 0 else None


def _check(
    oscillator: Oscillator, suite: SuiteResponse, context: Context, scanned: ScanResult, spread: NumericalSpread | None
) -> Check:
    """Make the check; demand and capacity are rotations of the branch of the worst record."""
    branch, share = branch_of(oscillator, suite.branch), mean_share(suite, oscillator)
    verdict, reason, remarks = with_spread(*_outcome(suite, share), spread)
    at_collapse = scanned.holds_to.sure
    demand, capacity = None if share is None else share * branch.unstable, HALF * branch.unstable
    return Check(
        procedure=ASCE43_05_HISTORY.name,
        edition=EDITION,
        branch=suite.branch,
        limit_state="no overturning",
        level_pga_g=suite.pga / g,
        input_at=context.histories_at,
        damping=None,
        quantity="mean rotation",
        unit="rad",
        demand=demand,
        capacity=capacity,
        ratio=None if share is None else share / HALF,
        verdict=verdict,
        reason=reason,
        remarks=fails_below(at_collapse, suite.pga / g) if verdict == Outcome.PASS else remarks,
        conditions=scan_conditions(context.incremental),
        capacity_pga_g=at_collapse,
        uplift_pga_g=scanned.uplift,
        capacity_rotation_ratio=capacity / branch.overturning,
        rotation_ratio=None if demand is None else demand / branch.overturning,
        pga_curve=scanned.curve,
        steps=(
            *_steps(suite, _rotation_shares(suite, oscillator), share, branch),
            *spread_steps(spread, at_collapse),
        ),
        numerical=spread,
        **caveats_of(CAVEAT),
    )


def _with_all_components(check: Check, oscillator: Oscillator, context: Context, options: Asce4305Options) -> Check:
    """Add what the components that the histories do not have would ask, and the condition of a pass without them."""
    shaken, branch = with_floor_ratio(context, options), branch_of(oscillator, check.branch)
    a, ratio = linear_multiplier(branch), shaken.vertical_ratio
    f_v = vertical_factor(a, ratio)
    factor = f_v * component_factor(context)
    vertical = {"a": a, "S_aV/S_aH": ratio}
    lines = (
        multiplier_step("a", "multiplier at rest", A2, branch),
        step("F_V", "vertical ground motion, which the histories do not have", "Eq. A-5(b)", "√(1 + (a S_aV/S_aH)²)",
             f_v, given=vertical),
        *component_step(context),
    )  # fmt: skip
    check = replace(check, steps=(*check.steps, *lines))
    if check.verdict == Outcome.PASS and lacks_vertical_floor(context, options):
        condition = message("no-vertical-on-floor", {"key": FLOOR_KEY}, severity=Severity.WARNING)
    elif falls_short(check, factor):
        condition = message("one-component", {"factor": Quantity(factor, "ratio", 2)}, severity=Severity.WARNING)
    else:
        return check
    return replace(check, conditions=(*check.conditions, condition))


def _outcome(suite: SuiteResponse, share: float | None) -> tuple[Outcome, Message]:
    n, fallen = len(suite.ratio), suite.overturned
    if n < LEAST_RECORDS:
        few = {"n": whole_number(n), "fallen": whole_number(fallen), "least": whole_number(LEAST_RECORDS)}
        return Outcome.NOT_ANSWERED, reason_message(Reason.TOO_FEW_RECORDS, clause=Term("the method"), **few)
    if share is None:
        return Outcome.FAIL, reason_message(Reason.RECORDS_OVERTURN, fallen=whole_number(fallen), n=whole_number(n))
    if share == 0.0:
        return Outcome.PASS, reason_message(Reason.NO_ROCKING)
    if share <= HALF:
        return Outcome.PASS, reason_message(Reason.WITHIN, capacity=Term("the allowable mean of the maxima"))
    return Outcome.FAIL, reason_message(Reason.BEYOND, capacity=Term("the allowable mean of the maxima"))


def _run_shares(suite: SuiteResponse, oscillator: Oscillator) -> FloatArray:
    """Return the shares of every run of each record [runs, records] [-]; inf where it overturned."""
    runs = suite.runs
    scale = [each.overturning / each.unstable for each in oscillator.branches]
    return runs.ratio * np.where(runs.negative, scale[-1], scale[0])


def _rotation_shares(suite: SuiteResponse, oscillator: Oscillator) -> tuple[float | None, ...]:
    """Return the largest rotation of each record over what overturns the mechanism in its branch [-].

    Parameters
    ----------
    suite : the maxima of the records
    oscillator : the mechanism

    Returns
    -------
    None for a record that overturned the mechanism.
    """
    names = suite.branches or (suite.branch,) * len(suite.ratio)
    branches = [branch_of(oscillator, name) for name in names]
    return tuple(
        None if ratio is None else ratio * branch.overturning / branch.unstable
        for ratio, branch in zip(suite.ratio, branches, strict=True)
    )


def _steps(
    suite: SuiteResponse, found: tuple[float | None, ...], share: float | None, branch: Branch
) -> tuple[Step, ...]:
    n = len(found)
    at_least = "records run, both polarities; at least 5"
    overturns = {"φ_u": (branch.unstable, "rad")}
    lines = [
        step("n", at_least, CLAUSE, "count", float(n)),
        step("n_ov", "records that overturn the body; none is allowed", CLAUSE, "count",
             float(suite.overturned)),
        instability_step("φ_u", "rotation that overturns it, joints included", CLAUSE, branch),
        _largest_step(found),
        _mean_step(found, share),
        step("φ_all", "allowable: a factor of 2 on instability", CLAUSE, "φ_u / 2", HALF * branch.unstable,
             "rad", given=overturns),
    ]  # fmt: skip
    if share is not None:
        lines.append(step("D/C", "ratio", CLAUSE, "φ/φ_u / 0.5", share / HALF, given={"φ/φ_u": share}))
    return tuple(lines)


def _largest_step(found: tuple[float | None, ...]) -> Step:
    symbol, words, each = (
        "max φ/φ_u",
        "largest without overturning, each by its branch",
        _shares_without_overturning(found),
    )
    if not each:
        return step(symbol, words, CLAUSE, "max |φ(t)| / φ_u", None, remark="every record overturns")
    return step(symbol, words, CLAUSE, f"max({', '.join(each)})", max(each.values()), given=each)


def _mean_step(found: tuple[float | None, ...], share: float | None) -> Step:
    """Write the line of the mean, from the maxima of all records."""
    symbol, words, n = "φ/φ_u", "mean of the maxima, each by its branch", len(found)
    if share is None:
        return step(symbol, words, CLAUSE, "Σ max |φ(t)| / φ_u / n", None, remark="a record overturned")
    each = _shares_without_overturning(found)
    return step(symbol, words, CLAUSE, f"({' + '.join(each)}) / {n}", share, given=each)


def _shares_without_overturning(found: tuple[float | None, ...]) -> dict[str, float]:
    """Return the maxima of the records that left the body standing, by number."""
    return {f"r_{i}": ratio for i, ratio in enumerate(found, start=1) if ratio is not None}
