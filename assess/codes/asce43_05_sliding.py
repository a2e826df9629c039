"""ASCE/SEI 43-05, Appendix A.1: how far an unanchored rigid body slides, by an equivalent linear oscillator.

    mu_e = mu (1 - 0.4 A_v / g)      c_s = 2 mu_e g      delta_s = c_s / (2 pi f_es)^2            (A-1, A-2, A-3)

f_es is the lowest frequency at which the horizontal spectrum of 10 % damping reaches c_s. Not checked against the
printed standard: A-3 is from memory. One function for each formula.

The clause combines two horizontal directions in a vector; here the motion is in one vertical plane, and its ordinate is
that of the spectrum. Its body presses with all its weight: where masses move whose weight is carried elsewhere,
mu N / (M g) takes the place of mu. Ties and applied forces are not covered.
"""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.asce43_05 import EDITION, Asce43Options, warn_at_height
from assess.codes.calculation_sheet import UNANSWERED
from assess.codes.check import Check, Outcome, Reason, Step, caveats_of, least_if_all_known, reason_message, step
from assess.codes.context import Context
from assess.codes.sliding import sliding_pga
from assess.hinge_forces import HingeForces
from assess.messages.message import Message, Severity, Term, message
from assess.oscillator import Oscillator, threshold

SLIDING = "asce43-05-sliding"
CLAUSE = "ASCE 43-05 A.1"
CAVEAT = "Appendix A.1 was not checked against the printed standard: equation A-3 is from memory"
LEVEL = 1e-6  # of a unit normal: faces less inclined are level


def assess_sliding(oscillator: Oscillator, context: Context, *, options: Asce43Options) -> tuple[Check, ...]:
    """Return one check for each level, against `options.allowable_sliding`; without that, for information only."""
    lifts = least_if_all_known([threshold(branch) for branch in oscillator.branches])
    checks = tuple(
        _check_at_level(level, context, oscillator.mass, options.allowable_sliding) for level in context.levels
    )
    return tuple(replace(check, uplift_pga_g=lifts) for check in warn_at_height(checks, context=context))


def reason_unanswerable(context: Context) -> tuple[Outcome, Message] | None:
    """Return why A.1 does not cover this mechanism, with the remedy; None where it does."""
    if not context.hinges:
        return Outcome.NOT_ANSWERED, reason_message(Reason.NO_HINGE_FORCES)
    first = context.hinges[0]
    if not first.single:
        return Outcome.NOT_APPLICABLE, reason_message(Reason.ONE_BLOCK_ONLY, clause=CLAUSE)
    if context.actions:
        return Outcome.NOT_APPLICABLE, reason_message(
            Reason.WEIGHT_ONLY, clause=CLAUSE, loads=", ".join(context.actions)
        )
    if any(abs(each.face[0]) > LEVEL for each in context.hinges):
        return Outcome.NOT_APPLICABLE, reason_message(Reason.LEVEL_BASE_ONLY, clause=CLAUSE)
    if first.friction is None:
        return Outcome.NOT_ANSWERED, reason_message(Reason.FRICTION_UNKNOWN, hinge=first.hinge, remedy=first.remedy)
    return None


def _check_at_level(level: float, context: Context, mass: float, allowable: float | None) -> Check:
    silent = reason_unanswerable(context)
    if silent is not None:
        verdict, reason = silent
        steps = (step("δ_s", "best estimate of sliding", CLAUSE, "-", None, "m", remark=UNANSWERED),)
        return _sliding_check(level, context, verdict=verdict, reason=reason, steps=steps)
    first = context.hinges[0]
    mu = friction_of_all(first.friction or 0.0, normal=first.resting.normal, mass=mass)
    found = sliding_estimate(context, level, mu)
    at_capacity = None if allowable is None else capacity_pga(context, mu, allowable)
    verdict, reason = _verdict(found, allowable, at_capacity)
    rocks_first = bool(found) and sliding_pga(context) is None
    answer = _sliding_check(
        level,
        context,
        demand=found,
        allowable=allowable,
        at_capacity=at_capacity,
        verdict=verdict,
        reason=reason,
        steps=(_friction_step(first, mass, mu), *_steps(level, context, mu, found, allowable)),
    )
    return (
        replace(answer, remarks=(message("rocks-before-sliding", severity=Severity.WARNING),))
        if rocks_first
        else answer
    )


def _verdict(found: float | None, allowable: float | None, at_capacity: float | None) -> tuple[Outcome, Message]:
    """Return outcome and reason; where the estimate is not known, a smaller PGA may show that it is too much."""
    if found is None and at_capacity is None:
        return Outcome.NOT_ANSWERED, reason_message(Reason.SLIDING_UNBOUNDED)
    if found is None:
        return Outcome.FAIL, reason_message(Reason.SLIDING_BEYOND_BEFORE)
    if allowable is None:
        return Outcome.NOT_ANSWERED, reason_message(Reason.NO_ALLOWABLE_SLIDING)
    if found == 0.0:
        return Outcome.PASS, reason_message(Reason.NO_SLIDING)
    verdict = Outcome.PASS if found <= allowable else Outcome.FAIL
    within = Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND
    return verdict, reason_message(within, capacity=Term("the allowable sliding"))


def _sliding_check(
    level: float,
    context: Context,
    *,
    verdict: Outcome,
    reason: Message,
    steps: tuple[Step, ...],
    demand: float | None = None,
    allowable: float | None = None,
    at_capacity: float | None = None,
) -> Check:
    return Check(
        procedure=SLIDING,
        edition=EDITION,
        branch="positive",
        limit_state="sliding",
        level_pga_g=level / g,
        input_at="ground",
        damping=DAMPING,
        damping_rule=context.spectrum.damping_rule,
        quantity="sliding",
        unit="m",
        demand=demand,
        capacity=allowable,
        ratio=None if demand is None or allowable is None else demand / allowable,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None if at_capacity is None else at_capacity / g,
        steps=steps,
        **caveats_of(CAVEAT),
    )


def _friction_step(hinge: HingeForces, mass: float, mu: float) -> Step:
    given = {"μ": (hinge.friction or 0.0, "-"), "N": (hinge.resting.normal, "N"), "M": (mass, "kg")}
    return step("μ_M", "friction over the weight of all that slides", CLAUSE, "μ N / (M g)", mu, given=given)


def _steps(level: float, context: Context, mu: float, found: float | None, allowable: float | None) -> tuple[Step, ...]:
    vertical = context.vertical_ratio * level
    mu_e = effective_friction(mu, vertical=vertical)
    c_s = sliding_coefficient(mu_e)
    period = longest_sliding_period(context, level, c_s) if c_s > 0.0 else None
    f_es = 1.0 / period if period else None
    none = "the spectrum does not reach c_s" if period == 0.0 else "no such frequency"
    said = none if f_es is None else ""
    shaken = {"S_aV/S_aH": (context.vertical_ratio, "-"), "PGA": (level, "m/s2")}
    slid = {"c_s": (c_s, "m/s2"), "f_es": (f_es or 0.0, "Hz")}
    at_f = "lowest frequency at which the spectrum of 10 % damping reaches c_s"
    estimate, formula = "best estimate of sliding (A-3, from memory)", "c_s / (2π f_es)²"
    steps = (
        step("A_v", "peak vertical acceleration", CLAUSE, "S_aV/S_aH PGA", vertical, "m/s2", given=shaken),
        step("μ_e", "effective coefficient of friction (A-1)", CLAUSE, "max(0, μ_M (1 − 0.4 A_v / g))", mu_e,
             given={"μ_M": (mu, "-"), "A_v": (vertical, "m/s2")}),
        step("c_s", "sliding coefficient (A-2)", CLAUSE, "2 μ_e g", c_s, "m/s2", given={"μ_e": mu_e}),
        step("f_es", at_f, CLAUSE, "S_A(f_es, 10 %) = c_s", f_es, "Hz", remark=said,
             at={"c_s": (c_s, "m/s2"), "ξ": (DAMPING, "-"), "PGA": (level, "m/s2")}),
        step("δ_s", estimate, CLAUSE, formula, found, "m", remark=said)
        if f_es is None
        else step("δ_s", estimate, CLAUSE, formula, found, "m", given=slid),
    )  # fmt: skip
    if allowable is None:
        return steps
    return (*steps, step("δ_all", "allowable sliding", CLAUSE, "given", allowable, "m"))


DAMPING = 0.1
SHORTEST, MOST = 0.01, 1e4  # s: periods between which the spectrum is looked at
HIGHEST, HALVINGS = 100.0 * g, 60  # PGA [m/s2] up to which its capacity is looked for, and how finely


def effective_friction(mu: float, *, vertical: float) -> float:
    """Return mu_e = mu (1 - 0.4 A_v / g), not below 0 (A-1).

    Parameters
    ----------
    mu : coefficient of friction [-]
    vertical : peak vertical acceleration A_v [m/s2]

    Returns
    -------
    float
        mu_e [-].
    """
    return max(mu * (1.0 - 0.4 * vertical / g), 0.0)


def friction_of_all(mu: float, *, normal: float, mass: float) -> float:
    """Return mu N / (M g), the friction over the weight of all that slides.

    Parameters
    ----------
    mu : coefficient of friction [-]
    normal : N that presses on the base at rest [N]
    mass : M of all that slides [kg]

    Returns
    -------
    float [-]
    """
    return mu * normal / (mass * g)


def sliding_coefficient(friction: float) -> float:
    """Return c_s = 2 mu_e g [m/s2] of an effective friction [-] (A-2)."""
    return 2.0 * friction * g


def sliding_distance(coefficient: float, *, frequency: float) -> float:
    """Return delta_s = c_s / (2 pi f_es)^2 (A-3).

    Parameters
    ----------
    coefficient : c_s [m/s2]
    frequency : f_es [Hz]

    Returns
    -------
    float [m]
    """
    return coefficient / (2.0 * pi * frequency) ** 2


def longest_sliding_period(context: Context, level: float, coefficient: float) -> float | None:
    """Return the longest period at which the spectrum reaches c_s, 1 / f_es.

    Parameters
    ----------
    context : its spectrum is scaled to `level`
    level : PGA [m/s2]
    coefficient : c_s [m/s2]

    Returns
    -------
    float or None
        Period [s]; 0 where no ordinate reaches c_s, None where the spectrum ends before it falls below c_s.
    """
    spectrum, scale = context.spectrum, level / context.spectrum.pga

    def excess(period: float) -> float:
        return scale * float(spectrum.acceleration(period, damping=DAMPING)) - coefficient

    periods = np.geomspace(SHORTEST, min(spectrum.longest_period, MOST), 400)
    above = np.flatnonzero(scale * spectrum.acceleration(periods, damping=DAMPING) >= coefficient)
    if not above.size:
        return 0.0
    last = int(above[-1])
    return None if last == periods.size - 1 else float(brentq(excess, periods[last], periods[last + 1], xtol=1e-12))


def sliding_estimate(context: Context, level: float, mu: float) -> float | None:
    """Return the best estimate of sliding, delta_s.

    Parameters
    ----------
    context : spectrum and vertical motion
    level : PGA [m/s2]
    mu : coefficient of friction [-]

    Returns
    -------
    float or None
        delta_s [m], 0 without sliding; None where the spectrum ends too early, or without friction.
    """
    c_s = sliding_coefficient(effective_friction(mu, vertical=context.vertical_ratio * level))
    period = longest_sliding_period(context, level, c_s) if c_s > 0.0 else None
    if period is None:
        return None
    return sliding_distance(c_s, frequency=1.0 / period) if period > 0.0 else 0.0


def capacity_pga(context: Context, mu: float, allowable: float) -> float | None:
    """Return the largest PGA whose sliding stays within the allowable one.

    Found by bisection, as more shaking never slides less.

    Parameters
    ----------
    context : spectrum and vertical motion
    mu : coefficient of friction [-]
    allowable : delta_s allowed [m]

    Returns
    -------
    float or None
        PGA [m/s2]; None where the spectrum ends too early to tell.
    """
    low, high = 0.0, HIGHEST
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        found = sliding_estimate(context, middle, mu)
        low, high = (middle, high) if found is not None and found <= allowable else (low, middle)
    return None if sliding_estimate(context, high, mu) is None else low
