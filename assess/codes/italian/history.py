"""Non-linear dynamic analysis by either edition: records on the mechanism, displacements against d0* and a share of it.

The displacements of the maxima are those of kinematic analysis, d*. None may pass d0*, where a* falls to zero, even if
the body comes back; their mean may not exceed 0.4 d0* at SLV, 0.6 d0* at SLC. Under seven records the largest takes
the place of the mean, under three nothing is claimed (NTC 7.3.5, from memory). FC is not in the equation of motion:
the records are run at FC times the PGA instead. A restoring moment over FC would be the same but for records that last
sqrt(FC) times less, which ask less.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isclose

import numpy as np
from scipy.constants import g

from assess.codes.check import Check, Outcome, PgaCurve, Reason, Step, because
from assess.codes.context import Context, Hazard, Suite
from assess.codes.governing import branch_named
from assess.codes.incremental import islands, pga_before_failure, pga_curve, uplift_multiplier
from assess.codes.italian.edition import Edition, Options
from assess.codes.italian.floor import judged
from assess.codes.italian.kinematic import collapse_step, displacement_at_collapse, rotation_at
from assess.codes.italian.limit_state import pga_step, share
from assess.message import Message, count
from assess.oscillator import Oscillator, displacement, participation_ratio
from spectra.spectrum import Spectrum

LEAST_RECORDS, FOR_THE_MEAN = 3, 7  # NTC 7.3.5
NUMBER_CLAUSE = "NTC 7.3.5"


@dataclass(frozen=True)
class Rule:
    """What an edition asks: its procedure and clause, and the share of d0* in each limit state."""

    procedure: str
    edition: Edition
    clause: str
    shares: Mapping[str, float]


@dataclass(frozen=True)
class Found:
    """What the records found at one level of one limit state.

    suite : run at FC times `pga`, the PGA of the limit state [m/s2]; displaced [n]: d*/d0* of each record, None where
    it overturned; largest : whether the largest of them is judged, not the mean
    """

    suite: Suite
    pga: float
    displaced: tuple[float | None, ...]

    @property
    def largest(self) -> bool:
        """Whether the largest is judged: few records, or one that passes d0*."""
        standing = [each for each in self.displaced if each is not None]
        return len(self.displaced) < FOR_THE_MEAN or max(standing, default=0.0) > 1.0

    @property
    def judged(self) -> float | None:
        """d*/d0* that is judged [-]; None where a record overturned."""
        standing = [each for each in self.displaced if each is not None]
        if len(standing) < len(self.displaced) or not standing:
            return None
        return max(standing) if self.largest else sum(standing) / len(standing)


def assess(oscillator: Oscillator, context: Context, *, rule: Rule, options: Options) -> tuple[Check, ...]:
    """One check for each limit state and level that has a suite of time histories."""
    checks, FC = [], options.confidence_factor
    for state in options.among(rule.shares):
        for level in context.levels:
            pga = level * share(context.hazard, context.spectrum, state)
            suite = suite_at(context, pga * FC)
            if suite is not None:
                found = Found(suite, pga, displaced(oscillator, suite))
                checks.append(_check(oscillator, context, rule, found, state=state, level=level, FC=FC))
    return tuple(checks)


def suite_at(context: Context, pga: float) -> Suite | None:
    """The suite that was run at a PGA [m/s2]; None where there is none."""
    suites = (*context.suites, *context.besides)
    return next((suite for suite in suites if isclose(suite.pga, pga, rel_tol=1e-9)), None)


def suites_needed(
    levels: Sequence[float],
    hazard: Hazard | None,
    spectrum: Spectrum,
    *,
    rule: Rule,
    options: Options,
) -> tuple[float, ...]:
    """PGA [m/s2] at which `assess` wants suites, besides those of the `levels`."""
    shares = [share(hazard, spectrum, state) * options.confidence_factor for state in options.among(rule.shares)]
    wanted = [level * each for each in shares for level in levels]
    return tuple(pga for pga in wanted if not any(isclose(pga, level, rel_tol=1e-9) for level in levels))


def rising(context: Context) -> tuple[Suite, ...]:
    """All suites at rising PGA, those that limit states of their own asked for among them; none without a scan."""
    if not context.incremental:
        return ()
    return tuple(sorted((*context.incremental, *context.besides), key=lambda suite: suite.pga))


def displaced(oscillator: Oscillator, suite: Suite) -> tuple[float | None, ...]:
    """d*/d0* of each record [-], each by the branch of its maximum; None where the body overturned."""
    names = suite.branches or (suite.branch,) * len(suite.ratio)
    share = np.zeros(len(names))
    for name in dict.fromkeys(names):
        branch, here = branch_named(oscillator, name), [place for place, each in enumerate(names) if each == name]
        rotation = np.array([(suite.ratio[place] or 0.0) * branch.overturning for place in here])
        *moved, collapse = displacement(branch, np.append(rotation, branch.unstable), mass=1.0)
        share[here] = moved / collapse
    return tuple(None if ratio is None else each for ratio, each in zip(suite.ratio, share.tolist(), strict=True))


def passes(found: Found, allowed: float) -> bool:
    """Whether all records leave the body standing short of d0* and what is judged stays within the share allowed."""
    return found.judged is not None and found.judged <= allowed


def _check(
    oscillator: Oscillator, context: Context, rule: Rule, found: Found, *, state: str, level: float, FC: float
) -> Check:
    branch, allowed = branch_named(oscillator, found.suite.branch), rule.shares[state]
    d0, e = displacement_at_collapse(branch, mass=oscillator.mass), participation_ratio(branch, mass=oscillator.mass)
    scanned = pga_before_failure(
        rising(context),
        lambda suite: passes(Found(suite, suite.pga, displaced(oscillator, suite)), allowed),
        least_records=LEAST_RECORDS,
    )
    lifts = uplift_multiplier(oscillator, linearised=context.linearised)
    at_collapse = None if scanned is None else scanned / FC
    verdict, reason = _verdict(found, allowed, state=state)
    value, allowable = found.judged, rotation_at(branch, allowed * d0 * e, mass=oscillator.mass) / branch.overturning
    moved = None if value is None else value * d0
    return Check(
        procedure=rule.procedure,
        edition=rule.edition.name,
        branch=found.suite.branch,
        limit_state=state,
        level_pga_g=level / g,
        input_at=context.histories_at,
        damping=None,
        quantity=f"{'largest' if found.largest else 'mean'} d*",
        unit="m",
        demand=moved,
        capacity=allowed * d0,
        ratio=None if value is None else value / allowed,
        verdict=verdict,
        reason=reason,
        remarks=islands(at_collapse, found.pga / g) if verdict == Outcome.PASS else (),
        capacity_pga_g=at_collapse,
        uplift_pga_g=None if lifts is None else lifts / context.amplification / FC,
        capacity_rotation_ratio=allowable,
        rotation_ratio=_rotation(found),
        pga_curve=_over(pga_curve(context.incremental), FC),
        steps=(
            pga_step(context, state=state, level=level, pga=found.pga),
            *_record_steps(found, rule, FC=FC),
            collapse_step(branch, rule.clause, mass=oscillator.mass),
            *_capacity_steps(found, rule, state=state, d0=d0),
        ),
        caveat=rule.edition.caveat,
    )


def _over(curve: PgaCurve, FC: float) -> PgaCurve:
    """The curve at the PGA that the records stand for."""
    return PgaCurve(curve.rotation_ratio, tuple(pga / FC for pga in curve.pga_g))


def _rotation(found: Found) -> float | None:
    """The rotation ratio that goes with what is judged; None where a record overturned."""
    standing = [ratio for ratio in found.suite.ratio if ratio is not None]
    if found.judged is None:
        return None
    return max(standing) if found.largest else found.suite.mean


def _verdict(found: Found, allowed: float, *, state: str) -> tuple[Outcome, Message]:
    n, fallen, passed = len(found.displaced), found.suite.overturned, _beyond_collapse(found)
    if n < LEAST_RECORDS:
        few = {"n": count(n), "fallen": count(fallen), "least": count(LEAST_RECORDS)}
        return Outcome.NOT_ANSWERED, because(Reason.TOO_FEW_RECORDS, clause=NUMBER_CLAUSE, **few)
    if fallen:
        return Outcome.FAIL, because(Reason.RECORDS_OVERTURN, fallen=count(fallen), n=count(n))
    if passed:
        return Outcome.FAIL, because(Reason.RECORDS_BEYOND_COLLAPSE, fallen=count(passed), n=count(n))
    value = found.judged or 0.0
    if value == 0.0:
        return Outcome.PASS, because(Reason.NO_ROCKING)
    verdict = judged(value / allowed)
    return verdict, because(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=f"d_{state}")


def _beyond_collapse(found: Found) -> int:
    return sum(1 for each in found.displaced if each is not None and each > 1.0)


def _record_steps(found: Found, rule: Rule, *, FC: float) -> tuple[Step, ...]:
    n, standing = len(found.displaced), [each for each in found.displaced if each is not None]
    at, run = f"{found.pga:.5g} · {FC:g}", found.suite.pga
    words = "PGA at which the records are run, as fitted to the site's spectrum; FC goes with the motion"
    all_of = " + ".join("overturned" if each is None else f"{each:.4g}" for each in found.displaced)
    formula, numbers = (
        ("max d*/d0*", f"of {all_of}".replace(" + ", ", "))
        if found.largest
        else (
            "Σ d*/d0* / n",
            f"({all_of}) / {n}",
        )
    )
    said = "largest of the maxima" if found.largest else "mean of the maxima"
    counted = f"records, both polarities; at least {LEAST_RECORDS}, {FOR_THE_MEAN} for the mean"
    largest, fallen = max(standing, default=None), found.suite.overturned
    collapse, top, over = "largest of those that stand; at most 1", "max d*/d0*", "records that overturn; none may"
    return (
        Step("FC · PGA", words, rule.clause, "PGA · FC", at, run, "m/s2"),
        Step("n", counted, NUMBER_CLAUSE, "count", str(n), float(n), "-"),
        Step("n_ov", over, rule.clause, "count", str(fallen), float(fallen), "-"),
        Step("d_max/d0*", collapse, rule.clause, top, f"{len(standing)} records", largest, "-"),
        Step("d/d0*", said, rule.clause, formula, numbers, found.judged, "-"),
    )


def _capacity_steps(found: Found, rule: Rule, *, state: str, d0: float) -> tuple[Step, ...]:
    allowed, clause = rule.shares[state], rule.clause
    steps = (Step(f"d_{state}", "capacity", clause, f"{allowed:g} d0*", f"{allowed:g} · {d0:.5g}", allowed * d0, "m"),)
    if found.judged is None:
        return steps
    numbers, ratio = f"{found.judged:.5g} / {allowed:g}", found.judged / allowed
    return *steps, Step(f"d / d_{state}", "ratio", clause, "demand / capacity", numbers, ratio, "-")
