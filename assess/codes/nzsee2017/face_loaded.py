"""C8.8.5: the usable rotation of a face-loaded wall against the demand of NZS 1170.5, section 8, as %NBS."""

from __future__ import annotations

from dataclasses import replace

from scipy.constants import g

from assess.codes.check import (
    BranchName,
    Check,
    Outcome,
    PgaCurve,
    Reason,
    caveats_of,
    missing_ordinate,
    reason_message,
    step,
)
from assess.codes.context import Context
from assess.codes.families import TABLE_SPECTRUM, other_spectrum
from assess.codes.nzsee2017.clauses import CAVEAT, CAVEAT_FREE, EDITION, USABLE, Options
from assess.codes.nzsee2017.response import Response, is_overloaded, response
from assess.codes.nzsee2017.sheet import CLAUSE, sheet
from assess.codes.pga_rotation import pga_rotation, to_pga_curve
from assess.codes.worst_branch import check_worst_branch
from assess.messages.message import Message, Quantity, Term, message
from assess.oscillator import Branch, Oscillator
from spectra.arrays import FloatArray

NAME, SCORE = "nzsee2017-face-loaded", "%NBS"
DAMPING = 0.05


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Check phi_m against phi_D at C(0) = the level, on the worse branch of each level, with its %NBS (C8.8.5).

    Where a larger usable rotation than the Guidelines' is given, the checks by theirs come first, and those by the
    given one are for comparison.
    """
    most = USABLE.get(context.support)
    if most is None or options.usable is None or options.usable <= most:
        return _checks(oscillator, context, options)
    values = {"given": Quantity(options.usable), "deciding": Quantity(most)}
    beyond = message("larger-usable-rotation", values)
    shown = _checks(oscillator, context, options)
    return (
        *_checks(oscillator, context, replace(options, usable=None)),
        *(replace(check, informs=True, remarks=(*check.remarks, beyond)) for check in shown),
    )


def _checks(oscillator: Oscillator, context: Context, options: Options) -> tuple[Check, ...]:
    def one(branch: Branch, name: BranchName, level: float) -> Check:
        empty = _check(name, context, level)
        if context.support == "hinged":
            return empty
        if context.spectrum.code == TABLE_SPECTRUM and options.c_0 is None:
            why = missing_ordinate(CLAUSE, "C(0)", "procedures.nzsee2017.c_0")
            return replace(empty, verdict=Outcome.NOT_ANSWERED, reason=why)
        if is_overloaded(name, context):
            return replace(empty, verdict=Outcome.NOT_ANSWERED, reason=reason_message(Reason.OVERLOADED, clause=CLAUSE))
        return _answered(empty, branch, context, response(branch, name, context, options), level)

    return tuple(_scored(check) for check in check_worst_branch(oscillator, context.levels, one))


def _check(name: BranchName, context: Context, level: float) -> Check:
    return Check(
        procedure=NAME,
        edition=EDITION,
        branch=name,
        limit_state="ULS",
        level_pga_g=level / g,
        input_at="mechanism base" if context.above_ground else "ground",
        damping=DAMPING,
        quantity="rotation",
        unit="rad",
        verdict=Outcome.NOT_APPLICABLE,
        reason=reason_message(Reason.NOT_A_WALL, clause=CLAUSE),
        **caveats_of(
            CAVEAT, *([CAVEAT_FREE] if context.support == "free" else []), *other_spectrum(NAME, context.spectrum.code)
        ),
    )


def _answered(check: Check, branch: Branch, context: Context, found: Response, level: float) -> Check:
    demanded = 0.0 if level <= (found.uplift or 0.0) else found.per_pga * level
    ratio = demanded / found.usable_rotation
    verdict = Outcome.PASS if ratio <= 1.0 else Outcome.FAIL
    stands = demanded < found.instability
    return replace(
        check,
        demand=demanded,
        capacity=found.usable_rotation,
        ratio=ratio,
        verdict=verdict,
        reason=_reason(demanded, verdict),
        capacity_pga_g=found.capacity / g,
        uplift_pga_g=None if found.uplift is None else found.uplift / g,
        capacity_rotation_ratio=found.usable_rotation / branch.overturning,
        rotation_ratio=demanded / branch.overturning if stands else None,
        pga_curve=_curve(branch, found),
        steps=sheet(branch, context, found, level=level),
    )


def _reason(demanded: float, verdict: Outcome) -> Message:
    if demanded == 0.0:
        return reason_message(Reason.NO_ROCKING)
    return reason_message(
        Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=Term("the usable rotation")
    )


def _curve(branch: Branch, found: Response) -> PgaCurve:
    def pga_of(rotation: FloatArray) -> FloatArray:
        return rotation / found.per_pga

    return to_pga_curve(pga_rotation(pga_of, overturning=found.instability, uplift=found.uplift or 0.0), branch)


def _scored(check: Check) -> Check:
    """Return the check with its %NBS: PGA at capacity over the PGA of the level, no ratio of rotations below uplift."""
    if check.capacity_pga_g is None:
        return check
    score = 100.0 * check.capacity_pga_g / check.level_pga_g
    given = {"PGA_100": (check.capacity_pga_g, "g"), "PGA": (check.level_pga_g, "g")}
    line = step(SCORE, "share of the new building standard", CLAUSE, "100 PGA_100 / PGA", score, "%", given=given)
    return replace(check, score={SCORE: score}, steps=(*check.steps, line))
