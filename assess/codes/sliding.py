"""Sliding: does a hinge slide before the mechanism rocks, and how far does a body slide (ASCE/SEI 43-05, A.1)?

The first is equilibrium of the blocks with Coulomb's friction, no clause of a code: the ground acceleration pushes on
the mechanism at rest, and each hinge needs friction |T| / N (`assess.oscillator`). Where that reaches the coefficient
of the joint before the mechanism starts to rock, it slides, and the checks by rocking do not represent it. Vertical
motion is left out.

Appendix A.1 estimates the distance of an unanchored rigid body by an equivalent linear oscillator:

    mu_e = mu (1 - 0.4 A_v / g)      c_s = 2 mu_e g      delta_s = c_s / (2 pi f_es)^2            (A-1, A-2, A-3)

f_es is the lowest frequency at which the horizontal spectrum of 10 % damping reaches c_s. Not checked against the
printed standard: A-3 is from memory. One function for each formula. The clause combines two horizontal directions in a
vector; here the motion is in one vertical plane, and its ordinate is that of the spectrum. Its body presses with all
its weight: where masses move whose weight is carried elsewhere, mu N / (M g) takes the place of mu. Ties and applied
forces are not covered.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf, pi

import numpy as np

from assess.codes.asce43_05 import EDITION, Asce4305Options, warn_at_height
from assess.codes.calculation_sheet import UNANSWERED, Given, Step, step
from assess.codes.check import (
    CaveatFields,
    Check,
    CodeProcedure,
    DefaultRun,
    Family,
    Outcome,
    Reason,
    caveats_of,
    least_if_all_known,
    reason_message,
)
from assess.codes.context import Context
from assess.messages.message import Message, Quantity, Severity, Term, message
from assess.oscillator import HingeForces, Oscillator, threshold
from spectra.gravity import g

FRICTION_EDITION = "equilibrium; Coulomb"
CHAIN = (
    "before it rocks a chain of blocks is statically indeterminate: N is taken as when it starts to rock, T in "
    "proportion to the acceleration"
)
EQUILIBRIUM, FORCES_TABLE = "equilibrium of each block at a_r", "the table of forces at the hinges"
HELD = "the top of a wall is taken as held; the sheet gives the force needed"


def assess_sliding(oscillator: Oscillator, context: Context) -> tuple[Check, ...]:
    """Return one check for each level, of the hinge that uses the largest share of its friction, of both branches.

    It is answered only where the friction of every hinge is known, and every hinge presses.
    """
    unanswerable = _reason_friction_unknown(context.hinges)
    checks = [
        _friction_unanswered(level, context, unanswerable) if unanswerable else _friction_check_at_level(level, context)
        for level in context.levels
    ]
    lifts = least_if_all_known([threshold(branch) for branch in oscillator.branches])
    return tuple(replace(check, uplift_pga_g=lifts and lifts / context.amplification) for check in checks)


def friction_utilisation(hinge: HingeForces, acceleration: float) -> float:
    """Return the friction needed up to a ground acceleration over that of the joint.

    Parameters
    ----------
    hinge : its forces and friction
    acceleration : of the ground [m/s2]

    Returns
    -------
    float [-]
    """
    mobilised = hinge.mobilised_friction(acceleration)
    if mobilised is None:
        return inf
    if hinge.friction:
        return mobilised / hinge.friction
    return inf if mobilised > 0.0 else 0.0


def sliding_pga(context: Context) -> float | None:
    """Return the least PGA [m/s2] at which a hinge slides before the mechanism rocks; None where none does."""
    found = [
        each.sliding_acceleration
        for each in _resting_on_friction(context.hinges)
        if each.sliding_acceleration is not None
    ]
    return min(found) / context.amplification if found else None


A1 = "ASCE 43-05 A.1"
A1_CAVEAT = "Appendix A.1 was not checked against the printed standard: equation A-3 is from memory"
A1_DAMPING = 0.1
SHORTEST, MOST = 0.01, 1e4  # s: periods between which the spectrum is looked at
HIGHEST, HALVINGS = 100.0 * g, 60  # PGA [m/s2] up to which its capacity is looked for, and how finely
LEVEL_FACE = 1e-6  # of a unit normal: faces less inclined are level


def assess_sliding_distance(oscillator: Oscillator, context: Context, *, options: Asce4305Options) -> tuple[Check, ...]:
    """Return one check for each level, against `options.allowable_sliding`; without that, for information only."""
    lifts = least_if_all_known([threshold(branch) for branch in oscillator.branches])
    checks = tuple(
        _distance_check_at_level(level, context, oscillator.mass, options.allowable_sliding) for level in context.levels
    )
    return tuple(replace(check, uplift_pga_g=lifts) for check in warn_at_height(checks, context=context))


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
    Period [s]; 0 where no ordinate reaches c_s, None where the spectrum ends before it falls below c_s.
    """
    spectrum, scale = context.spectrum, level / context.spectrum.pga

    def excess(period: float) -> float:
        return scale * float(spectrum.acceleration(period, damping=A1_DAMPING)) - coefficient

    periods = np.geomspace(SHORTEST, min(spectrum.longest_period, MOST), 400)
    above = np.flatnonzero(scale * spectrum.acceleration(periods, damping=A1_DAMPING) >= coefficient)
    if not above.size:
        return 0.0
    last = int(above[-1])
    from scipy.optimize import brentq

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
    PGA [m/s2]; None where the spectrum ends too early to tell.
    """
    low, high = 0.0, HIGHEST
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        found = sliding_estimate(context, middle, mu)
        low, high = (middle, high) if found is not None and found <= allowable else (low, middle)
    return None if sliding_estimate(context, high, mu) is None else low


SLIDING = CodeProcedure(
    name="sliding",
    family=Family.FRICTION,
    assess=assess_sliding,
    title=Term("Sliding, equilibrium"),
    short_title=Term("Sliding"),
    default_run=DefaultRun(needs_friction=True),
)


def _reason_friction_unknown(hinges: Sequence[HingeForces]) -> Message | None:
    """Return why sliding cannot be checked, with the remedy; None where it can."""
    if not hinges:
        return reason_message(Reason.NO_HINGE_FORCES)
    for each in _resting_on_friction(hinges):
        if each.friction is None:
            return reason_message(Reason.FRICTION_UNKNOWN, hinge=each.hinge, remedy=each.remedy)
        pull = -min(each.starting.normal, each.resting.normal)
        if pull >= 0.0:
            return reason_message(Reason.HINGE_PULLS, hinge=each.hinge, pull=Quantity(pull, "force"))
    return None


def _resting_on_friction(hinges: Sequence[HingeForces]) -> tuple[HingeForces, ...]:
    return tuple(each for each in hinges if not each.held)


def _friction_check_at_level(level: float, context: Context) -> Check:
    acceleration = level * context.amplification
    hinge = max(_resting_on_friction(context.hinges), key=lambda each: friction_utilisation(each, acceleration))
    ratio, slides_at = friction_utilisation(hinge, acceleration), sliding_pga(context)
    verdict = Outcome.PASS if ratio <= 1.0 else Outcome.FAIL
    return _friction_check(
        level,
        context,
        hinge,
        demand=hinge.mobilised_friction(acceleration),
        ratio=ratio if ratio < inf else None,
        verdict=verdict,
        reason=_friction_reason(hinge, slides_at, verdict),
        slides_at=slides_at,
        steps=_friction_steps(hinge, level, context, slides_at),
    )


def _friction_reason(hinge: HingeForces, slides_at: float | None, verdict: Outcome) -> Message:
    if verdict == Outcome.FAIL:
        return reason_message(Reason.SLIDES_FIRST, hinge=hinge.hinge)
    if slides_at is not None:
        return reason_message(Reason.SLIDES_LATER, pga=Quantity(slides_at / g, "ground acceleration", 3))
    return reason_message(Reason.ROCKS_FIRST, hinge=hinge.hinge)


def _friction_unanswered(level: float, context: Context, reason: Message) -> Check:
    return _friction_check(
        level,
        context,
        context.hinges[0] if context.hinges else None,
        demand=None,
        ratio=None,
        verdict=Outcome.NOT_ANSWERED,
        reason=reason,
        slides_at=None,
        steps=(step("|T| / N", "friction needed at the hinges", FRICTION_EDITION, "-", None, remark=UNANSWERED),),
    )


def _friction_check(
    level: float,
    context: Context,
    hinge: HingeForces | None,
    *,
    demand: float | None,
    ratio: float | None,
    verdict: Outcome,
    reason: Message,
    slides_at: float | None,
    steps: tuple[Step, ...],
) -> Check:
    return Check(
        procedure=SLIDING.name,
        edition=FRICTION_EDITION,
        branch="positive" if hinge is None else hinge.branch,
        limit_state="no sliding",
        level_pga_g=level / g,
        input_at=context.histories_at,
        damping=None,
        quantity="coefficient of friction",
        unit="-",
        demand=demand,
        capacity=None if hinge is None or verdict == Outcome.NOT_ANSWERED else hinge.friction,
        ratio=ratio,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None if slides_at is None else slides_at / g,
        steps=steps,
        **_friction_caveats(hinge, context),
    )


def _friction_caveats(hinge: HingeForces | None, context: Context) -> CaveatFields:
    if hinge is None or hinge.single:
        return caveats_of()
    return caveats_of(CHAIN, *([HELD] if any(each.held for each in context.hinges) else []))


def _friction_steps(hinge: HingeForces, level: float, context: Context, slides_at: float | None) -> tuple[Step, ...]:
    """Write the sheet of the governing hinge, from its forces on."""
    held = [each for each in context.hinges if each.held and each.branch == hinge.branch]
    return (
        *_incipient_motion_steps(hinge),
        *_level_steps(hinge, level, context),
        *_sliding_steps(hinge, context, slides_at),
        *(step for each in held for step in _held_steps(each)),
    )


def _held_steps(top: HingeForces) -> tuple[Step, ...]:
    """Write the force on the support at the top of a wall, and the friction it needs without an anchorage."""
    N, name = top.starting.normal, top.hinge
    words = "friction needed without an anchorage; none where nothing rests on the top"
    friction = (
        _friction_step(f"μ_{name}", words, top)
        if N > 0.0
        else step(f"μ_{name}", words, FRICTION_EDITION, "|T| / N", None)
    )
    return (
        step(
            f"H_{name}",
            "force on the support at the top, at a_r",
            FRICTION_EDITION,
            EQUILIBRIUM,
            top.horizontal,
            "N",
            remark=FORCES_TABLE,
        ),
        friction,
    )


def _friction_step(symbol: str, words: str, hinge: HingeForces) -> Step:
    """Write the friction a hinge needs when the mechanism starts to rock."""
    pressed = {"T": (hinge.starting.shear, "N"), "N": (hinge.starting.normal, "N")}
    return step(symbol, words, FRICTION_EDITION, "|T| / N", hinge.required_friction, given=pressed)


def _incipient_motion_steps(hinge: HingeForces) -> tuple[Step, ...]:
    """Write H, V, N and T of a hinge when the mechanism starts to rock, and the friction they need."""
    H, V, (n_x, n_z), name = hinge.horizontal, hinge.vertical, hinge.face, hinge.hinge
    N, T = hinge.starting.normal, hinge.starting.shear
    faces = "square to the faces, which lie on the geometry"
    faces = faces if hinge.found else "square to the faces, taken level as none were found"
    forces = {"H": (H, "N"), "V": (V, "N"), "n_x": (n_x, "-"), "n_z": (n_z, "-")}
    return (
        step("a_r", "acceleration that starts rocking", FRICTION_EDITION, "λ g", hinge.acceleration, "m/s2",
             given={"λ": hinge.acceleration / g}),
        _horizontal_step(hinge),
        step(f"V_{name}", "on the block that presses, up", FRICTION_EDITION, EQUILIBRIUM, V, "N", remark=FORCES_TABLE),
        step(f"N_{name}", faces, FRICTION_EDITION, "H n_x + V n_z", N, "N", given=forces),
        step(f"T_{name}", "along the faces", FRICTION_EDITION, "H n_z − V n_x", T, "N", given=forces),
        _friction_step("μ_req", "friction needed to rock without sliding", hinge),
    )  # fmt: skip


def _horizontal_step(hinge: HingeForces) -> Step:
    """Write H; of a single block it is H at rest less the push on the moved mass."""
    symbol, words, H = f"H_{hinge.hinge}", "on the block that presses, along the motion", hinge.horizontal
    if not hinge.single:
        return step(symbol, words, FRICTION_EDITION, EQUILIBRIUM, H, "N", remark=FORCES_TABLE)
    (n_x, n_z), a = hinge.face, hinge.acceleration
    at_rest = hinge.resting.normal * n_x + hinge.resting.shear * n_z + 0.0
    given = {"H_0": (at_rest, "N"), "a_r": (a, "m/s2"), "M": ((at_rest - H) / a, "kg")}
    return step(symbol, words, FRICTION_EDITION, "H_0 − a_r M", H, "N", given=given)


def _level_steps(hinge: HingeForces, level: float, context: Context) -> tuple[Step, ...]:
    """Write N, T and friction at the acceleration of the level, or at incipient motion where that is less."""
    a = min(level * context.amplification, hinge.acceleration)
    now, rest, start, name = hinge.pressure_at(a), hinge.resting, hinge.starting, hinge.hinge
    reached = {"a": (a, "m/s2"), "a_r": (hinge.acceleration, "m/s2")}
    pushed = {"PGA": (level, "m/s2"), "f": (context.amplification, "-"), "a_r": (hinge.acceleration, "m/s2")}
    pressed = {"N_0": (rest.normal, "N"), f"N_{name}": (start.normal, "N"), **reached}
    sheared = {"T_0": (rest.shear, "N"), f"T_{name}": (start.shear, "N"), **reached}
    needed = {
        "T_0": (rest.shear, "N"),
        "N_0": (rest.normal, "N"),
        "T_a": (now.shear, "N"),
        "N_a": (now.normal, "N"),
    }
    words, formula = "friction needed up to a: at rest or at a", "max(|T_0| / N_0, |T_a| / N_a)"
    return (
        step("a", "acceleration at the hinges, f the amplification", FRICTION_EDITION, "min(f PGA, a_r)", a, "m/s2",
             given=pushed),
        step("N_a", "square to the faces at a", FRICTION_EDITION, f"N_0 + (N_{name} − N_0) a / a_r", now.normal, "N",
             given=pressed),
        step("T_a", "along the faces at a", FRICTION_EDITION, f"T_0 + (T_{name} − T_0) a / a_r", now.shear, "N",
             given=sheared),
        step("μ_d", words, FRICTION_EDITION, formula, hinge.mobilised_friction(a), given=needed),
    )  # fmt: skip


def _sliding_steps(hinge: HingeForces, context: Context, slides_at: float | None) -> tuple[Step, ...]:
    return (
        step("μ", "coefficient of friction of the joint", FRICTION_EDITION, "given", hinge.friction),
        _least_pga_step(context, slides_at),
    )


def _least_pga_step(context: Context, slides_at: float | None) -> Step:
    """Write the least PGA at which any hinge slides: where |T| reaches mu N between rest and incipient motion."""
    words, symbol = "least PGA that slides a hinge before it rocks; none where it rocks first", "PGA_s"
    sliding = [each for each in _resting_on_friction(context.hinges) if each.sliding_acceleration is not None]
    if slides_at is None or not sliding:
        return step(symbol, words, FRICTION_EDITION, "|T| = μ N, over the amplification", None, "g")
    first = min(sliding, key=lambda each: each.sliding_acceleration or 0.0)
    if not slides_at:
        remark = "a hinge slides at rest"
        return step(symbol, words, FRICTION_EDITION, "|T| = μ N, over the amplification", 0.0, "g", remark=remark)
    side = -1.0 if first.starting.shear < 0.0 else 1.0
    given: Given = {
        "μ": first.friction or 0.0,
        "N_0": (first.resting.normal, "N"),
        "T_0": (side * first.resting.shear + 0.0, "N"),
        "N_r": (first.starting.normal, "N"),
        "T_r": (side * first.starting.shear, "N"),
        "a_r": (first.acceleration, "m/s2"),
        "f": context.amplification,
    }
    formula = "(μ N_0 − T_0) / (T_r − T_0 − μ (N_r − N_0)) a_r / (f g)"
    remark = "the least of all hinges"
    return step(symbol, words, FRICTION_EDITION, formula, slides_at / g, "g", given=given, remark=remark)


ASCE43_05_SLIDING = CodeProcedure(
    name="asce43-05-sliding",
    family=Family.SLIDING,
    assess=assess_sliding_distance,
    title=Term("ASCE 43-05, sliding"),
    short_title=Term("ASCE 43-05 sliding"),
    work="asce43-05",
    options="asce43_05",
    default_run=DefaultRun(needs_friction=True),
)


def _exclusion_reason(context: Context) -> tuple[Outcome, Message] | None:
    """Return why A.1 excludes this mechanism, with the remedy; None where it covers it."""
    if not context.hinges:
        return Outcome.NOT_ANSWERED, reason_message(Reason.NO_HINGE_FORCES)
    first = context.hinges[0]
    if not first.single:
        return Outcome.NOT_APPLICABLE, reason_message(Reason.ONE_BLOCK_ONLY, clause=A1)
    if context.actions:
        return Outcome.NOT_APPLICABLE, reason_message(Reason.WEIGHT_ONLY, clause=A1, loads=", ".join(context.actions))
    if any(abs(each.face[0]) > LEVEL_FACE for each in context.hinges):
        return Outcome.NOT_APPLICABLE, reason_message(Reason.LEVEL_BASE_ONLY, clause=A1)
    if first.friction is None:
        return Outcome.NOT_ANSWERED, reason_message(Reason.FRICTION_UNKNOWN, hinge=first.hinge, remedy=first.remedy)
    return None


def _distance_check_at_level(level: float, context: Context, mass: float, allowable: float | None) -> Check:
    not_covered = _exclusion_reason(context)
    if not_covered is not None:
        verdict, reason = not_covered
        steps = (step("δ_s", "best estimate of sliding", A1, "-", None, "m", remark=UNANSWERED),)
        return _distance_check(level, context, verdict=verdict, reason=reason, steps=steps)
    first = context.hinges[0]
    mu = friction_of_all(first.friction or 0.0, normal=first.resting.normal, mass=mass)
    found = sliding_estimate(context, level, mu)
    at_capacity = None if allowable is None else capacity_pga(context, mu, allowable)
    verdict, reason = _distance_outcome(found, allowable, at_capacity)
    rocks_first = bool(found) and sliding_pga(context) is None
    answer = _distance_check(
        level,
        context,
        demand=found,
        allowable=allowable,
        at_capacity=at_capacity,
        verdict=verdict,
        reason=reason,
        steps=(_weight_friction_step(first, mass, mu), *_distance_steps(level, context, mu, found, allowable)),
    )
    return (
        replace(answer, remarks=(message("rocks-before-sliding", severity=Severity.WARNING),))
        if rocks_first
        else answer
    )


def _distance_outcome(
    found: float | None, allowable: float | None, at_capacity: float | None
) -> tuple[Outcome, Message]:
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


def _distance_check(
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
        procedure=ASCE43_05_SLIDING.name,
        edition=EDITION,
        branch="positive",
        limit_state="sliding",
        level_pga_g=level / g,
        input_at="ground",
        damping=A1_DAMPING,
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
        **caveats_of(A1_CAVEAT),
    )


def _weight_friction_step(hinge: HingeForces, mass: float, mu: float) -> Step:
    given = {"μ": (hinge.friction or 0.0, "-"), "N": (hinge.resting.normal, "N"), "M": (mass, "kg")}
    return step("μ_M", "friction over the weight of all that slides", A1, "μ N / (M g)", mu, given=given)


def _distance_steps(
    level: float, context: Context, mu: float, found: float | None, allowable: float | None
) -> tuple[Step, ...]:
    vertical = context.vertical_ratio * level
    mu_e = effective_friction(mu, vertical=vertical)
    c_s = sliding_coefficient(mu_e)
    period = longest_sliding_period(context, level, c_s) if c_s > 0.0 else None
    f_es = 1.0 / period if period else None
    none = "the spectrum does not reach c_s" if period == 0.0 else "no such frequency"
    remark = none if f_es is None else ""
    at = {"S_aV/S_aH": (context.vertical_ratio, "-"), "PGA": (level, "m/s2")}
    slid = {"c_s": (c_s, "m/s2"), "f_es": (f_es or 0.0, "Hz")}
    at_f = "lowest frequency at which the spectrum of 10 % damping reaches c_s"
    estimate, formula = "best estimate of sliding (A-3, from memory)", "c_s / (2π f_es)²"
    steps = (
        step("A_v", "peak vertical acceleration", A1, "S_aV/S_aH PGA", vertical, "m/s2", given=at),
        step("μ_e", "effective coefficient of friction (A-1)", A1, "max(0, μ_M (1 − 0.4 A_v / g))", mu_e,
             given={"μ_M": (mu, "-"), "A_v": (vertical, "m/s2")}),
        step("c_s", "sliding coefficient (A-2)", A1, "2 μ_e g", c_s, "m/s2", given={"μ_e": mu_e}),
        step("f_es", at_f, A1, "S_A(f_es, 10 %) = c_s", f_es, "Hz", remark=remark,
             at={"c_s": (c_s, "m/s2"), "ξ": (A1_DAMPING, "-"), "PGA": (level, "m/s2")}),
        step("δ_s", estimate, A1, formula, found, "m", remark=remark)
        if f_es is None
        else step("δ_s", estimate, A1, formula, found, "m", given=slid),
    )  # fmt: skip
    if allowable is None:
        return steps
    return (*steps, step("δ_all", "allowable sliding", A1, "given", allowable, "m"))
