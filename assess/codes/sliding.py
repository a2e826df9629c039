"""Does a hinge slide before the mechanism rocks? Equilibrium of the blocks and Coulomb's friction; no clause of a code.

The ground acceleration pushes on the mechanism at rest; each hinge needs friction |T| / N (`assess.hinge_forces`).
Where that reaches the coefficient of the joint before the mechanism starts to rock, it slides, and the checks by
rocking do not represent it. Vertical motion is left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

from scipy.constants import g

from assess.codes.calculation_sheet import UNANSWERED, Given
from assess.codes.check import (
    CaveatFields,
    Check,
    Outcome,
    Reason,
    Step,
    caveats_of,
    least_if_all_known,
    reason_message,
    step,
)
from assess.codes.context import Context
from assess.hinge_forces import HingeForces
from assess.messages.message import Message, Quantity
from assess.oscillator import Oscillator, threshold

EDITION = "equilibrium; Coulomb"
SLIDING = "sliding"
CHAIN = (
    "before it rocks a chain of blocks is statically indeterminate: N is taken as when it starts to rock, T in "
    "proportion to the acceleration"
)
EQUILIBRIUM, TABLE = "equilibrium of each block at a_r", "the table of forces at the hinges"
HELD = "the top of a wall is taken as held; the sheet gives the force needed"


def assess_sliding(oscillator: Oscillator, context: Context) -> tuple[Check, ...]:
    """Return one check for each level, of the hinge that uses the largest share of its friction, of both branches.

    It is answered only where the friction of every hinge is known, and every hinge presses.
    """
    silent = reason_unanswerable(context.hinges)
    checks = [
        _unanswered(level, context, silent) if silent else _check_at_level(level, context) for level in context.levels
    ]
    lifts = least_if_all_known([threshold(branch) for branch in oscillator.branches])
    return tuple(replace(check, uplift_pga_g=lifts and lifts / context.amplification) for check in checks)


def reason_unanswerable(hinges: Sequence[HingeForces]) -> Message | None:
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


def _check_at_level(level: float, context: Context) -> Check:
    acceleration = level * context.amplification
    hinge = max(_resting_on_friction(context.hinges), key=lambda each: friction_utilisation(each, acceleration))
    ratio, slides_at = friction_utilisation(hinge, acceleration), sliding_pga(context)
    verdict = Outcome.PASS if ratio <= 1.0 else Outcome.FAIL
    return _check(
        level,
        context,
        hinge,
        demand=hinge.mobilised_friction(acceleration),
        ratio=ratio if ratio < inf else None,
        verdict=verdict,
        reason=_reason(hinge, slides_at, verdict),
        slides_at=slides_at,
        steps=_steps(hinge, level, context, slides_at),
    )


def _reason(hinge: HingeForces, slides_at: float | None, verdict: Outcome) -> Message:
    if verdict == Outcome.FAIL:
        return reason_message(Reason.SLIDES_FIRST, hinge=hinge.hinge)
    if slides_at is not None:
        return reason_message(Reason.SLIDES_LATER, pga=Quantity(slides_at / g, "ground acceleration", 3))
    return reason_message(Reason.ROCKS_FIRST, hinge=hinge.hinge)


def _unanswered(level: float, context: Context, reason: Message) -> Check:
    return _check(
        level,
        context,
        context.hinges[0] if context.hinges else None,
        demand=None,
        ratio=None,
        verdict=Outcome.NOT_ANSWERED,
        reason=reason,
        slides_at=None,
        steps=(step("|T| / N", "friction needed at the hinges", EDITION, "-", None, remark=UNANSWERED),),
    )


def _check(
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
        procedure=SLIDING,
        edition=EDITION,
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
        **_caveats(hinge, context),
    )


def _caveats(hinge: HingeForces | None, context: Context) -> CaveatFields:
    if hinge is None or hinge.single:
        return caveats_of()
    return caveats_of(CHAIN, *([HELD] if any(each.held for each in context.hinges) else []))


def _steps(hinge: HingeForces, level: float, context: Context, slides_at: float | None) -> tuple[Step, ...]:
    """Write the sheet of the governing hinge, from its forces on."""
    held = [each for each in context.hinges if each.held and each.branch == hinge.branch]
    return (
        *incipient_motion_steps(hinge),
        *_level_steps(hinge, level, context),
        *_sliding_steps(hinge, context, slides_at),
        *(step for each in held for step in _held_steps(each)),
    )


def _held_steps(top: HingeForces) -> tuple[Step, ...]:
    """Write the force on the support at the top of a wall, and the friction it needs without an anchorage."""
    N, name = top.starting.normal, top.hinge
    said = "friction needed without an anchorage; none where nothing rests on the top"
    friction = _friction_step(f"μ_{name}", said, top) if N > 0.0 else step(f"μ_{name}", said, EDITION, "|T| / N", None)
    return (
        step(
            f"H_{name}",
            "force on the support at the top, at a_r",
            EDITION,
            EQUILIBRIUM,
            top.horizontal,
            "N",
            remark=TABLE,
        ),
        friction,
    )


def _friction_step(symbol: str, words: str, hinge: HingeForces) -> Step:
    """Write the friction a hinge needs when the mechanism starts to rock."""
    pressed = {"T": (hinge.starting.shear, "N"), "N": (hinge.starting.normal, "N")}
    return step(symbol, words, EDITION, "|T| / N", hinge.required_friction, given=pressed)


def incipient_motion_steps(hinge: HingeForces) -> tuple[Step, ...]:
    """Write H, V, N and T of a hinge when the mechanism starts to rock, and the friction they need."""
    H, V, (n_x, n_z), name = hinge.horizontal, hinge.vertical, hinge.face, hinge.hinge
    N, T = hinge.starting.normal, hinge.starting.shear
    faces = "square to the faces, which lie on the geometry"
    faces = faces if hinge.found else "square to the faces, taken level as none were found"
    forces = {"H": (H, "N"), "V": (V, "N"), "n_x": (n_x, "-"), "n_z": (n_z, "-")}
    return (
        step("a_r", "acceleration that starts rocking", EDITION, "λ g", hinge.acceleration, "m/s2",
             given={"λ": hinge.acceleration / g}),
        _horizontal_step(hinge),
        step(f"V_{name}", "on the block that presses, up", EDITION, EQUILIBRIUM, V, "N", remark=TABLE),
        step(f"N_{name}", faces, EDITION, "H n_x + V n_z", N, "N", given=forces),
        step(f"T_{name}", "along the faces", EDITION, "H n_z − V n_x", T, "N", given=forces),
        _friction_step("μ_req", "friction needed to rock without sliding", hinge),
    )  # fmt: skip


def _horizontal_step(hinge: HingeForces) -> Step:
    """Write H; of a single block it is H at rest less the push on the moved mass."""
    symbol, words, H = f"H_{hinge.hinge}", "on the block that presses, along the motion", hinge.horizontal
    if not hinge.single:
        return step(symbol, words, EDITION, EQUILIBRIUM, H, "N", remark=TABLE)
    (n_x, n_z), a = hinge.face, hinge.acceleration
    at_rest = hinge.resting.normal * n_x + hinge.resting.shear * n_z + 0.0
    given = {"H_0": (at_rest, "N"), "a_r": (a, "m/s2"), "M": ((at_rest - H) / a, "kg")}
    return step(symbol, words, EDITION, "H_0 − a_r M", H, "N", given=given)


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
        step("a", "acceleration at the hinges, f the amplification", EDITION, "min(f PGA, a_r)", a, "m/s2",
             given=pushed),
        step("N_a", "square to the faces at a", EDITION, f"N_0 + (N_{name} − N_0) a / a_r", now.normal, "N",
             given=pressed),
        step("T_a", "along the faces at a", EDITION, f"T_0 + (T_{name} − T_0) a / a_r", now.shear, "N", given=sheared),
        step("μ_d", words, EDITION, formula, hinge.mobilised_friction(a), given=needed),
    )  # fmt: skip


def _sliding_steps(hinge: HingeForces, context: Context, slides_at: float | None) -> tuple[Step, ...]:
    return (
        step("μ", "coefficient of friction of the joint", EDITION, "given", hinge.friction),
        _least_pga_step(context, slides_at),
    )


def _least_pga_step(context: Context, slides_at: float | None) -> Step:
    """Write the least PGA at which any hinge slides: where |T| reaches mu N between rest and incipient motion."""
    words, symbol = "least PGA that slides a hinge before it rocks; none where it rocks first", "PGA_s"
    sliding = [each for each in _resting_on_friction(context.hinges) if each.sliding_acceleration is not None]
    if slides_at is None or not sliding:
        return step(symbol, words, EDITION, "|T| = μ N, over the amplification", None, "g")
    first = min(sliding, key=lambda each: each.sliding_acceleration or 0.0)
    if not slides_at:
        remark = "a hinge slides at rest"
        return step(symbol, words, EDITION, "|T| = μ N, over the amplification", 0.0, "g", remark=remark)
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
    return step(symbol, words, EDITION, formula, slides_at / g, "g", given=given, remark=remark)
