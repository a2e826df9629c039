"""ASCE/SEI 43-05, response-history method: the mean of the largest rotations of at least five records.

The best estimate of the demand is the mean of the maxima; a factor of 2 on instability makes half the overturning
rotation the allowable (thesis 3.3.2 and 8.4.2, Table 8.10). A record that overturns the body fails the level.
"""

from __future__ import annotations

from collections.abc import Sequence

from scipy.constants import g

from assess.codes.asce43_05.clauses import EDITION, Options
from assess.codes.check import BranchName, Check, InputAt, PgaCurve, Step, Verdict
from assess.codes.context import Context, Suite
from assess.codes.governing import branch_named, least
from assess.oscillator import Oscillator, linearise, threshold

CLAUSE = "ASCE 43-05, response-history method"
CAVEAT = "the method was read in the thesis, not in the printed standard"
LEAST_RECORDS = 5


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """One check for each level that has a suite of time histories."""
    curve = pga_curve(context.incremental)
    allowable = options.allowable_ratio * min(branch.unstable / branch.overturning for branch in oscillator.branches)
    at_collapse = pga_at_collapse(context.incremental, allowable)
    lifts = uplift_multiplier(oscillator, linearised=context.linearised)
    return tuple(
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


def uplift_multiplier(oscillator: Oscillator, *, linearised: bool) -> float | None:
    """The least PGA [g] at which the equation of the histories lets the mechanism lift off; None without a threshold.

    The linearised equation has one, even on joints that answer to any motion.
    """
    if linearised:
        return min(linearise(branch).multiplier for branch in oscillator.branches)
    return least([threshold(branch) for branch in oscillator.branches])


def passes(suite: Suite, allowable_ratio: float) -> bool:
    """Whether every record left the body standing and the mean of the maxima stays within the allowable."""
    return suite.mean is not None and suite.mean <= allowable_ratio


def pga_curve(incremental: Sequence[Suite]) -> PgaCurve:
    """Mean of the maxima over PGA, up to the first suite with a record that overturned."""
    standing: list[tuple[float, float]] = []
    for suite in incremental:
        if suite.mean is None:
            break
        standing.append((suite.mean, suite.pga / g))
    return PgaCurve(tuple(ratio for ratio, _ in standing), tuple(pga for _, pga in standing))


def pga_at_collapse(incremental: Sequence[Suite], allowable_ratio: float) -> float | None:
    """PGA [g] of the last suite before the first that fails; None if none failed, too few records, or no scan.

    Responses are not monotone in PGA: a suite beyond the first failure may pass again, and does not count, so a level
    can pass above this PGA.
    """
    last: float | None = None
    for suite in incremental:
        if len(suite.ratio) < LEAST_RECORDS:
            return None
        if not passes(suite, allowable_ratio):
            return last
        last = suite.pga / g
    return None


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
        role="code",
        branch=branch_name,
        limit_state="no overturning",
        level_pga_g=suite.pga / g,
        input_at=input_at,
        damping=None,
        damping_rule="",
        quantity="mean rotation",
        unit="rad",
        demand=None if mean is None else mean * overturning,
        capacity=allowable_ratio * overturning,
        ratio=None if mean is None else mean / allowable_ratio,
        verdict=verdict,
        reason=reason + (_islands(at_collapse, suite.pga / g) if verdict == "pass" else ""),
        capacity_pga_g=at_collapse,
        uplift_pga_g=uplift,
        capacity_rotation_ratio=allowable_ratio,
        rotation_ratio=mean,
        pga_curve=curve,
        steps=_steps(suite, allowable_ratio, overturning),
        caveat=CAVEAT,
    )


def _verdict(suite: Suite, allowable_ratio: float) -> tuple[Verdict, str]:
    n = len(suite.ratio)
    if n < LEAST_RECORDS:
        fallen = f", {suite.overturned} of which overturn the body" if suite.overturned else ""
        return (
            "not-applicable",
            f"{n} records{fallen}; the method asks for at least {LEAST_RECORDS}: shown as information",
        )
    if suite.overturned:
        return "fail", f"{suite.overturned} of {n} records overturn the body"
    if suite.mean == 0.0:
        return "pass", "no rocking: no record lifts the body off its base"
    if passes(suite, allowable_ratio):
        return "pass", "mean of the maxima within the allowable"
    return "fail", "mean of the maxima beyond the allowable"


def _islands(at_collapse: float | None, level: float) -> str:
    """A remark where a level passes above the least PGA at which the scan fails."""
    if at_collapse is None or level <= at_collapse:
        return ""
    return f", yet the scan already fails just above {at_collapse:.3g} g: responses do not grow steadily with PGA"


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
