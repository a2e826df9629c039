"""ASCE/SEI 43-05, response-history method: the mean of the largest rotations of at least five records.

The best estimate of the demand is the mean of the maxima; a factor of 2 on instability makes half the overturning
rotation the allowable (thesis 3.3.2 and 8.4.2, Table 8.10). A record that overturns the body fails the level.
"""

from __future__ import annotations

from scipy.constants import g

from assess.codes.asce43_05.clauses import EDITION, Options
from assess.codes.asce43_05.height import with_height
from assess.codes.check import BranchName, Check, InputAt, Outcome, PgaCurve, Reason, Step, because
from assess.codes.context import Context, Suite
from assess.codes.governing import branch_named
from assess.codes.incremental import islands, pga_before_failure, pga_curve, uplift_multiplier
from assess.message import Message, count
from assess.oscillator import Oscillator

CLAUSE = "ASCE 43-05, response-history method"
CAVEAT = "the method was read in the thesis, not in the printed standard"
LEAST_RECORDS = 5


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """One check for each level that has a suite of time histories."""
    curve = pga_curve(context.incremental)
    allowable = options.allowable_ratio * min(branch.unstable / branch.overturning for branch in oscillator.branches)
    at_collapse = pga_before_failure(
        context.incremental, lambda suite: passes(suite, allowable), least_records=LEAST_RECORDS
    )
    lifts = uplift_multiplier(oscillator, linearised=context.linearised)
    checks = (
        _check(
            oscillator,
            suite,
            allowable,
            curve=curve,
            at_collapse=at_collapse,
            uplift=None if lifts is None else lifts / context.amplification,
            input_at=context.histories_at,
        )
        for suite in context.suites
    )
    return with_height(tuple(checks), context=context)


def passes(suite: Suite, allowable_ratio: float) -> bool:
    """Whether every record left the body standing and the mean of the maxima stays within the allowable."""
    return suite.mean is not None and suite.mean <= allowable_ratio


def _check(
    oscillator: Oscillator,
    suite: Suite,
    allowable_ratio: float,
    *,
    curve: PgaCurve,
    at_collapse: float | None,
    uplift: float | None,
    input_at: InputAt,
) -> Check:
    branch_name: BranchName = suite.branch
    branch = branch_named(oscillator, branch_name)
    overturning = branch.overturning
    mean = suite.mean
    verdict, reason = _verdict(suite, allowable_ratio)
    return Check(
        procedure="asce43-05-history",
        edition=EDITION,
        branch=branch_name,
        limit_state="no overturning",
        level_pga_g=suite.pga / g,
        input_at=input_at,
        damping=None,
        quantity="mean rotation",
        unit="rad",
        demand=None if mean is None else mean * overturning,
        capacity=allowable_ratio * overturning,
        ratio=None if mean is None else mean / allowable_ratio,
        verdict=verdict,
        reason=reason,
        remarks=islands(at_collapse, suite.pga / g) if verdict == Outcome.PASS else (),
        capacity_pga_g=at_collapse,
        uplift_pga_g=uplift,
        capacity_rotation_ratio=allowable_ratio,
        rotation_ratio=mean,
        pga_curve=curve,
        steps=_steps(suite, allowable_ratio, overturning),
        caveat=CAVEAT,
    )


def _verdict(suite: Suite, allowable_ratio: float) -> tuple[Outcome, Message]:
    n = len(suite.ratio)
    if n < LEAST_RECORDS:
        few = {"n": count(n), "fallen": count(suite.overturned), "least": count(LEAST_RECORDS)}
        return Outcome.NOT_ANSWERED, because(Reason.TOO_FEW_RECORDS, clause="the method", **few)
    if suite.overturned:
        return Outcome.FAIL, because(Reason.RECORDS_OVERTURN, fallen=count(suite.overturned), n=count(n))
    if suite.mean == 0.0:
        return Outcome.PASS, because(Reason.NO_ROCKING)
    if passes(suite, allowable_ratio):
        return Outcome.PASS, because(Reason.WITHIN, capacity="the allowable mean of the maxima")
    return Outcome.FAIL, because(Reason.BEYOND, capacity="the allowable mean of the maxima")


def _steps(suite: Suite, allowable_ratio: float, overturning: float) -> tuple[Step, ...]:
    standing = [ratio for ratio in suite.ratio if ratio is not None]
    n, mean = len(suite.ratio), suite.mean
    sum_of = " + ".join("overturned" if ratio is None else f"{ratio:.4g}" for ratio in suite.ratio)
    return (
        Step(
            "n",
            f"records run, both polarities; at least {LEAST_RECORDS}",
            CLAUSE,
            "count",
            str(n),
            float(n),
            "-",
        ),
        Step(
            "n_ov",
            "records that overturn the body; none may",
            CLAUSE,
            "count",
            str(suite.overturned),
            float(suite.overturned),
            "-",
        ),
        Step(
            "max φ/φ_ov",
            "largest of those that stand",
            CLAUSE,
            "max |φ(t)| / φ_ov",
            f"{len(standing)} records",
            max(standing, default=None),
            "-",
        ),
        Step("φ/φ_ov", "mean of the maxima", CLAUSE, "Σ max |φ(t)| / φ_ov / n", f"({sum_of}) / {n}", mean, "-"),
        Step(
            "φ_all",
            "allowable: a factor of 2 on instability",
            CLAUSE,
            "ratio · φ_ov",
            f"{allowable_ratio:g} · {overturning:.5g}",
            allowable_ratio * overturning,
            "rad",
        ),
        Step("φ_all/φ_ov", "allowable ratio", CLAUSE, "given", f"{allowable_ratio:g}", allowable_ratio, "-"),
    )
