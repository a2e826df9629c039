"""Non-linear dynamic analysis by either edition: records on the mechanism, displacements against d0* and d_LS.

The displacements of the maxima are those of kinematic analysis, d*. None may pass d0*, where a* falls to zero, even if
the body comes back; their mean may not exceed d_SLV or d_SLC, the least of a share of d0*, of breaks and of seats.
With fewer than seven records the largest takes the place of the mean, with fewer than three the check is not answered
(NTC 7.3.5). FC is not in the equation of motion: the records are run at FC times the PGA instead. A restoring moment
over FC would be the same but for records that last sqrt(FC) times less, which demand less. A pass needs the rule to
hold in 84 % of the draws among the runs of each record, too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from math import inf, isclose, isinf

import numpy as np

from assess.codes.calculation_sheet import Given, Step, step
from assess.codes.check import (
    ELASTIC,
    BuildingState,
    Check,
    NumericalSpread,
    Outcome,
    PgaCurve,
    Reason,
    caveats_of,
    reason_message,
)
from assess.codes.context import Context, SiteHazard
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
from assess.codes.italian_kinematic import (
    DisplacementCapacity,
    DisplacementLimit,
    displacement_capacity,
    displacement_capacity_steps,
    rotation_at,
    seat_conditions,
)
from assess.codes.italian_limit_states import (
    BranchCurves,
    ConfidenceFactor,
    ItalianEdition,
    ItalianOptions,
    add_safety_index,
    branch_curves,
    confidence_factors,
    confidence_step,
    mark_for_comparison,
    outcome_of,
    pga_ratio,
    pga_step,
)
from assess.messages.message import Message, Quantity, whole_number
from assess.oscillator import BRANCH_NAMES, Branch, BranchName, Oscillator, displacement, participation_ratio
from spectra.arrays import FloatArray
from spectra.gravity import g
from spectra.spectrum import Spectrum

LEAST_RECORDS = 3  # NTC 7.3.5
SOFTENED_DAMPING, SOFTENING_CLAUSE = 0.10, "C8.7.1.2.1.4"
SOFTENING_BUILDING = (ELASTIC, *(BuildingState(ratio, SOFTENED_DAMPING) for ratio in (1.25, 1.5, 1.75, 2.0)))
"""The building from its first shakes, elastic, to the ultimate limit states: C8.7.1.2.1.4 has T +50 to +100 %, and
damping of 10 to 20 %. What overturns upstairs is resonance, so that no end of the range is worst for every body."""
NUMBER_CLAUSE = "NTC 7.3.5"

DEMAND_AT: Mapping[BranchName, str] = {
    "positive": "demand, at the limit of the positive branch",
    "negative": "demand, at the limit of the negative branch",
}


@dataclass(frozen=True)
class HistoryRule:
    """The rule of an edition: its procedure and clause, and what limits the displacement in each limit state."""

    procedure: str
    edition: ItalianEdition
    clause: str
    limits: Mapping[str, DisplacementLimit]


def assess_histories(
    oscillator: Oscillator, context: Context, *, rule: HistoryRule, options: ItalianOptions
) -> tuple[Check, ...]:
    """Return one check, with its safety index, for each limit state and level that has a suite of time histories."""
    checks: list[Check] = []
    known = context.knowledge.get(rule.edition.code)
    requested = options.requested_states(rule.limits)
    ratios = {state: run_ratios(oscillator, context, rule.limits[state]) for state in requested}
    scanned = _scan_suites(context)
    holds_to = {state: capacities_by_share(scanned, _suite_rule(ratios[state])) for state in requested}
    for confidence in confidence_factors(options, crushing=context.crushing, level=known):
        for state, capacity in holds_to.items():
            for level in context.levels:
                pga = level * pga_ratio(context.hazard, context.spectrum, state)
                suite = _suite_at(context, pga * confidence.factor)
                if suite is not None:
                    found = SuiteDisplacements(suite, pga, _displacement_ratios(ratios[state], suite))
                    spread = numerical_spread(suite, _suite_rule(ratios[state]).measure, capacity, FC=confidence.factor)
                    made = _check(
                        oscillator, context, rule, found, capacity, spread,
                        state=state, level=level, confidence=confidence,
                    )  # fmt: skip
                    checks.append(mark_for_comparison(made, confidence))
    return tuple(add_safety_index(check, context) for check in checks)


def required_pga(
    levels: Sequence[float],
    hazard: SiteHazard | None,
    spectrum: Spectrum,
    *,
    rule: HistoryRule,
    options: ItalianOptions,
    crushing: bool,
    knowledge: Mapping[str, str],
) -> tuple[float, ...]:
    """Return the PGA at which `assess` needs suites, some of which may be those of the levels.

    Parameters
    ----------
    levels : PGA of the levels [m/s2]
    hazard : of the site over return periods; None where it has one spectrum
    spectrum : the site's
    rule : of the edition
    options : the limit states requested, and the confidence factor FC given, if any
    crushing : whether the mechanism models crushing of the masonry
    knowledge : its level of knowledge by code, where given

    Returns
    -------
    tuple of float [m/s2]
    """
    states = options.requested_states(rule.limits)
    factors = confidence_factors(options, crushing=crushing, level=knowledge.get(rule.edition.code))
    shares = [pga_ratio(hazard, spectrum, state) * each.factor for each in factors for state in states]
    return tuple(level * each for each in shares for level in levels)


RECORDS_FOR_MEAN = 7  # NTC 7.3.5


@dataclass(frozen=True)
class DisplacementRatios:
    """One record: d*/d0* and d*/d_LS [-] of the branch of its maximum; None where the body overturned."""

    of_collapse: float | None
    of_limit: float | None


@dataclass(frozen=True)
class SuiteDisplacements:
    """The results of the records at one level of one limit state.

    suite : run at FC times `pga`, the PGA of the limit state [m/s2]; displacements [n]: of each record
    """

    suite: SuiteResponse
    pga: float
    displacements: tuple[DisplacementRatios, ...]

    @property
    def limit_ratios(self) -> tuple[float, ...]:
        """d*/d_LS of the records that leave the body standing [-]."""
        return tuple(each.of_limit for each in self.displacements if each.of_limit is not None)

    @property
    def largest_collapse_ratio(self) -> float | None:
        """The largest d*/d0* of those [-]; None where all overturn it."""
        return max((each.of_collapse for each in self.displacements if each.of_collapse is not None), default=None)

    @property
    def uses_largest(self) -> bool:
        """Whether the largest is compared, not the mean: few records, or one that passes d0*."""
        return len(self.displacements) < RECORDS_FOR_MEAN or (self.largest_collapse_ratio or 0.0) > 1.0

    @property
    def governing_ratio(self) -> float | None:
        """The d*/d_LS that is compared with 1 [-]; None where a record overturned."""
        if len(self.limit_ratios) < len(self.displacements) or not self.limit_ratios:
            return None
        return max(self.limit_ratios) if self.uses_largest else sum(self.limit_ratios) / len(self.limit_ratios)


RunRatios = Callable[[SuiteResponse], tuple[FloatArray, FloatArray]]
"""Gives d*/d0* and d*/d_LS of every run of each record [runs, records] [-]; inf where it overturned."""


def history_rules(
    oscillator: Oscillator, context: Context, *, rule: HistoryRule, options: ItalianOptions
) -> tuple[SuiteRule, ...]:
    """Return the rule that a suite is held to in each limit state requested."""
    states = options.requested_states(rule.limits)
    return tuple(_suite_rule(run_ratios(oscillator, context, rule.limits[state])) for state in states)


def run_ratios(oscillator: Oscillator, context: Context, limit: DisplacementLimit) -> RunRatios:
    """Return what gives the displacements of the runs of a suite, each by the branch of its maximum."""

    @cache
    def of_branch(name: BranchName) -> tuple[Branch, DisplacementCapacity]:
        curves = branch_curves(oscillator, context, name)
        return curves.lasting, displacement_capacity(curves, limit)

    def ratios(suite: SuiteResponse) -> tuple[FloatArray, FloatArray]:
        runs = suite.runs
        of_collapse, of_limit = np.full(runs.ratio.shape, inf), np.full(runs.ratio.shape, inf)
        for name in BRANCH_NAMES:
            here = (runs.negative == (name == "negative")) & np.isfinite(runs.ratio)
            if not here.any():
                continue
            branch, capacity = of_branch(name)
            rotation = np.append(runs.ratio[here] * branch.overturning, branch.unstable)
            moved = displacement(branch, rotation, mass=1.0)
            of_collapse[here] = moved[:-1] / moved[-1]
            of_limit[here] = of_collapse[here] * capacity.collapse / capacity.displacement
        return of_collapse, of_limit

    return ratios


def _suite_rule(ratios: RunRatios) -> SuiteRule:
    """Return the rule of a limit state by the displacements of its runs."""

    def measure(suite: SuiteResponse) -> RuleShares:
        of_collapse, of_limit = ratios(suite)
        return rule_shares(of_limit, of_collapse <= 1.0, largest=of_limit.shape[1] < RECORDS_FOR_MEAN)

    def passes(suite: SuiteResponse) -> bool:
        return _passes_rule(SuiteDisplacements(suite, suite.pga, _displacement_ratios(ratios, suite)))

    return SuiteRule(measure, passes, LEAST_RECORDS)


def _suite_at(context: Context, pga: float) -> SuiteResponse | None:
    """Return the suite that was run at a PGA [m/s2]; None where there is none."""
    suites = (*context.suites, *context.extra_suites)
    return next((suite for suite in suites if isclose(suite.pga, pga, rel_tol=1e-9)), None)


def _scan_suites(context: Context) -> tuple[SuiteResponse, ...]:
    """Return all suites at rising PGA, those at the PGA of limit states among them; none without a scan."""
    if not context.incremental:
        return ()
    return tuple(sorted((*context.incremental, *context.extra_suites), key=lambda suite: suite.pga))


def _check(
    oscillator: Oscillator,
    context: Context,
    rule: HistoryRule,
    found: SuiteDisplacements,
    holds_to: Capacities,
    spread: NumericalSpread | None,
    *,
    state: str,
    level: float,
    confidence: ConfidenceFactor,
) -> Check:
    curves, limit, FC = branch_curves(oscillator, context, found.suite.branch), rule.limits[state], confidence.factor
    capacity, branch = displacement_capacity(curves, limit), curves.lasting
    lifts = uplift_multiplier(context.starting or oscillator, linearised=context.linearised)
    at_collapse = None if holds_to.sure is None else holds_to.sure / FC
    verdict, reason, remarks = with_spread(*_history_outcome(found, state=state), spread)
    moved = capacity.displacement * participation_ratio(branch, mass=curves.mass)
    return Check(
        procedure=rule.procedure,
        edition=rule.edition.name,
        branch=found.suite.branch,
        limit_state=state,
        level_pga_g=level / g,
        input_at=context.histories_at,
        damping=None,
        quantity="largest d*" if found.uses_largest else "mean d*",
        unit="m",
        demand=None if found.governing_ratio is None else found.governing_ratio * capacity.displacement,
        capacity=capacity.displacement,
        ratio=found.governing_ratio,
        verdict=verdict,
        reason=reason,
        remarks=fails_below(at_collapse, found.pga / g) if verdict == Outcome.PASS else remarks,
        conditions=(
            *scan_conditions(context.incremental),
            *(seat_conditions(context, curves, state, capacity.displacement) if state == "SLV" else ()),
        ),
        capacity_pga_g=at_collapse,
        uplift_pga_g=None if lifts is None else lifts / context.amplification / FC,
        capacity_rotation_ratio=rotation_at(branch, moved, mass=curves.mass) / branch.overturning,
        rotation_ratio=_rotation_ratio(found),
        pga_curve=_scale_curve(pga_curve(context.incremental), FC),
        steps=(
            pga_step(context, state=state, level=level, pga=found.pga),
            confidence_step(confidence, rule.edition),
            *displacement_capacity_steps(curves, capacity, limit, f"d_{state}", "displacement capacity"),
            *_record_steps(found, rule, FC=FC),
            *_ratio_steps(found, rule, curves, capacity, state=state),
            *spread_steps(spread, at_collapse),
        ),
        numerical=spread,
        **caveats_of(rule.edition.caveat),
    )


def _scale_curve(curve: PgaCurve, FC: float) -> PgaCurve:
    """Return the curve at the PGA that the records represent."""
    return PgaCurve(curve.rotation_ratio, tuple(pga / FC for pga in curve.pga_g))


def _rotation_ratio(found: SuiteDisplacements) -> float | None:
    """Return the rotation ratio that goes with the governing one; None where a record overturned."""
    standing = [ratio for ratio in found.suite.ratio if ratio is not None]
    if found.governing_ratio is None:
        return None
    return max(standing) if found.uses_largest else found.suite.mean


def _history_outcome(found: SuiteDisplacements, *, state: str) -> tuple[Outcome, Message]:
    n, fallen, passed = len(found.displacements), found.suite.overturned, _beyond_collapse(found)
    if n < LEAST_RECORDS:
        few = {"n": whole_number(n), "fallen": whole_number(fallen), "least": whole_number(LEAST_RECORDS)}
        return Outcome.NOT_ANSWERED, reason_message(Reason.TOO_FEW_RECORDS, clause=NUMBER_CLAUSE, **few)
    if fallen:
        counted = {"fallen": whole_number(fallen), "n": whole_number(n)}
        if isclose(found.suite.pga, found.pga, rel_tol=1e-9):
            return Outcome.FAIL, reason_message(Reason.RECORDS_OVERTURN, **counted)
        factor, pga = found.suite.pga / found.pga, Quantity(found.suite.pga / g, "ground acceleration", 3)
        return Outcome.FAIL, reason_message(
            Reason.RECORDS_OVERTURN_FACTORED, **counted, factor=Quantity(factor, "ratio", 3), pga=pga
        )
    if passed:
        return Outcome.FAIL, reason_message(
            Reason.RECORDS_BEYOND_COLLAPSE, fallen=whole_number(passed), n=whole_number(n)
        )
    value = found.governing_ratio or 0.0
    if value == 0.0:
        return Outcome.PASS, reason_message(Reason.NO_ROCKING)
    verdict = outcome_of(value)
    return verdict, reason_message(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=f"d_{state}")


def _record_steps(found: SuiteDisplacements, rule: HistoryRule, *, FC: float) -> tuple[Step, ...]:
    n, fallen, run = float(len(found.displacements)), float(found.suite.overturned), found.suite.pga
    words = "PGA at which the records are run, scaled to the site's spectrum; FC multiplies the motion"
    counted = "records, both polarities; at least 3, and 7 for the mean"
    over = "records that overturn; none is allowed"
    given: Given = {"PGA": (found.pga, "m/s2"), "FC": FC}
    return (
        step("FC · PGA", words, rule.clause, "FC · PGA", run, "m/s2", given=given),
        step("n", counted, NUMBER_CLAUSE, "count", n),
        step("n_ov", over, rule.clause, "count", fallen),
        _farthest_step(found, rule),
    )


def _farthest_step(found: SuiteDisplacements, rule: HistoryRule) -> Step:
    """Write the largest d*/d0* of the records that leave the body standing."""
    symbol, words = "d_max / d0*", "largest without overturning, each by its branch; at most 1"
    far = {f"c_{n}": each.of_collapse for n, each in enumerate(found.displacements, 1) if each.of_collapse is not None}
    if not far:
        return step(symbol, words, rule.clause, "largest d* / d0*", None, remark="every record overturns")
    return step(symbol, words, rule.clause, f"max({', '.join(far)})", found.largest_collapse_ratio, given=far)


def _ratio_steps(
    found: SuiteDisplacements, rule: HistoryRule, curves: BranchCurves, capacity: DisplacementCapacity, *, state: str
) -> tuple[Step, ...]:
    """Write the governing ratio: each record by the d_LS of its branch."""
    ratio = _governing_step(found, rule, f"d / d_{state}")
    if found.governing_ratio is None:
        return (ratio,)
    given: Given = {f"d / d_{state}": found.governing_ratio, f"d_{state}": (capacity.displacement, "m")}
    words, value = DEMAND_AT[curves.name], found.governing_ratio * capacity.displacement
    return ratio, step("d", words, rule.clause, f"d / d_{state} · d_{state}", value, "m", given=given)


def _governing_step(found: SuiteDisplacements, rule: HistoryRule, symbol: str) -> Step:
    """Write the mean, or the largest, of the records' shares of the limit."""
    largest, mean = "largest of the records, each by its branch", "mean of the records, each by its branch"
    words, n = largest if found.uses_largest else mean, len(found.displacements)
    near = {f"r_{i}": each.of_limit for i, each in enumerate(found.displacements, 1) if each.of_limit is not None}
    if found.governing_ratio is None:
        return step(symbol, words, rule.clause, "d* / d_LS", None, remark="a record overturned")
    formula = f"max({', '.join(near)})" if found.uses_largest else f"({' + '.join(near)}) / {n}"
    return step(symbol, words, rule.clause, formula, found.governing_ratio, given=near)


def _displacement_ratios(ratios: RunRatios, suite: SuiteResponse) -> tuple[DisplacementRatios, ...]:
    """Return d*/d0* and d*/d_LS of each record as it is [-]."""
    of_collapse, of_limit = ratios(suite)
    return tuple(
        DisplacementRatios(None, None) if isinf(far) else DisplacementRatios(far, near)
        for far, near in zip(of_collapse[0].tolist(), of_limit[0].tolist(), strict=True)
    )


def _passes_rule(found: SuiteDisplacements) -> bool:
    """Return whether all records leave the body short of d0*, and the governing ratio is within 1."""
    return found.governing_ratio is not None and found.governing_ratio <= 1.0 and not _beyond_collapse(found)


def _beyond_collapse(found: SuiteDisplacements) -> int:
    """Return how many records move beyond d0* without overturning."""
    return sum(1 for each in found.displacements if each.of_collapse is not None and each.of_collapse > 1.0)
