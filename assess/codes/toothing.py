"""The friction of side walls toothed into a wall that overturns (Circolare 7/2019, C8.7.1.2).

    F = 0.4 n (n + 1) Φ μ l² t_s w       of each side wall, at h / 3;  n = h / h_b courses in the crack,  Φ = h_b / l

The bed under i courses carries their weight i h_b l t_s w; 0.8 μ times it, summed over n courses, is F. Course by
course the resultant lies at (h - h_b) / 3; the clause puts it at h / 3, as a triangle does that grows from the top.

The height is the one of the least multiplier (C8.7.1.2). A wall may also take wedges of its side walls with it, in
front of cracks at an angle β from the vertical, at most β_b along the steps of the bond, tan β_b = l / h_b. What rubs
is then F (1 - tan β / tan β_b) (Szabó et al. 2023, PSI 44:1342). With W = w t_s h² / 2, the weight of a wedge for each
unit of its slope τ = tan β, weights and loads above a level and about its front edge, R and B, and N side walls:

    α = [R + N (W τ (a + h τ / 3) + F (1 - τ / τ_b) h / 3)] / [g B + N W τ 2 h / 3]

a from the front edge to the side walls. No more friction counts than gives the wall as a whole the least α of all parts
and slopes. A joint at the height z opens by z sin φ, and its overlap is lost at l: the triangle of friction becomes
q(z) (1 - z sin φ / l), where that is above 0. It resists on the way out alone and is not shown to last up to collapse:
it counts in α0 and in a(d), and in no displacement at collapse. Histories have it as memory, where the wall opens
farther than ever before (`assess.dynamics.ties`). Loads on the side walls are not in it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from assess.codes.calculation_sheet import Given, Step, step
from assess.codes.check import Check, Outcome
from assess.codes.context import Context
from assess.errors import ProcedureError
from assess.messages.message import Quantity, Severity, message
from assess.oscillator import Oscillator, Toothing
from spectra.arrays import FloatArray
from spectra.gravity import g

CLAUSE = "C8.7.1.2"
TOOTHING_FRICTION = 0.577  # mu of reference [-]
TOOTHING_LEVER = 1.0 / 3.0  # height of the resultant over the foot of the turning part, of the height of the crack
NEARLY_WHOLE = 0.98  # of the height: what turns first is then the wall itself


def toothing_friction(
    *,
    height: float,
    unit_height: float,
    overlap: float,
    thickness: float,
    unit_weight: float,
    friction: float = TOOTHING_FRICTION,
) -> float:
    """Return F = 0.4 n (n + 1) Phi mu l^2 t_s w of one side wall, with n = h / h_b and Phi = h_b / l (C8.7.1.2).

    It acts at a third of the height of the crack above the foot of the part that turns.

    Parameters
    ----------
    height : of the crack, h [m]
    unit_height : mean height of the units, h_b [m]
    overlap : length of one friction joint, l [m]
    thickness : of the side wall, t_s [m]
    unit_weight : of the side wall, w [N/m3]
    friction : mu [-]

    Returns
    -------
    float [N]

    Raises
    ------
    ProcedureError : for a crack lower than one course
    """
    n, Phi = height / unit_height, unit_height / overlap
    if n < 1.0:
        raise ProcedureError(f"toothed crack of {height:.4g} m: C8.7.1.2 needs at least one course, {unit_height:.4g}")
    return 0.4 * n * (n + 1.0) * Phi * friction * overlap**2 * thickness * unit_weight


@dataclass(frozen=True)
class LeastPart:
    """What turns first: alpha [-], its height [m] and place among the heights, the slope tan(beta) of the cracks."""

    multiplier: float
    height: float
    place: int
    slope: float


def least_part(toothing: Toothing) -> LeastPart:
    """Return the part and the slope of the cracks of least multiplier.

    The multiplier of a height is a quotient of a parabola and a line in the slope, so that its least is at an end or
    where its derivative is zero.
    """
    h, a, N, steepest = toothing.height, toothing.depth, toothing.walls, steepest_slope(toothing)
    W, F = _wedge(toothing, h), np.array([_friction_of(toothing, each) for each in h])
    p0, p1, p2 = (
        toothing.restoring + N * F * h / 3.0,
        N * (W * a - F * h / (3.0 * steepest)),
        N * W * h / 3.0,
    )
    q0, q1 = g * toothing.excitation, 2.0 * N * W * h / 3.0
    # (p1 + 2 p2 τ)(q0 + q1 τ) = q1 (p0 + p1 τ + p2 τ²)
    centre, constant = q0 / q1, (p1 * q0 - p0 * q1) / (p2 * q1)
    stationary = np.sqrt(np.maximum(centre**2 - constant, 0.0)) - centre
    slopes = np.stack([np.zeros_like(h), np.full_like(h, steepest), np.clip(stationary, 0.0, steepest)])
    found = (p0 + p1 * slopes + p2 * slopes**2) / (q0 + q1 * slopes)
    which, place = np.unravel_index(int(np.argmin(found)), found.shape)
    return LeastPart(float(found[which, place]), float(h[place]), int(place), float(slopes[which, place]))


def steepest_slope(toothing: Toothing) -> float:
    """Return tan(beta_b) = l / h_b, of a crack along the steps of the bond [-]."""
    return toothing.overlap / toothing.course


def counted_moment(toothing: Toothing) -> float:
    """Return the moment at rest of the friction that counts [N m]: it brings the wall to the least multiplier."""
    height, restoring, excitation = (
        float(each[-1]) for each in (toothing.height, toothing.restoring, toothing.excitation)
    )
    full = toothing.walls * _friction_of(toothing, height) * height * TOOTHING_LEVER
    return min(full, max(least_part(toothing).multiplier * g * excitation - restoring, 0.0))


def friction_left(toothing: Toothing, rotation: FloatArray) -> FloatArray:
    """Return the moment of the friction over that at rest [n] [-], as the wall turns and loses the overlaps.

    6 / h³ ∫ (h - z) (1 - z sin φ / l) z dz cos φ, from the hinge to where the overlap is lost, or to the top.

    Parameters
    ----------
    toothing : of the wall
    rotation : phi [n] [rad]
    """
    h, s = float(toothing.height[-1]), np.sin(rotation) / toothing.overlap
    end = np.minimum(h, 1.0 / np.maximum(s, 1.0 / (2.0 * h)))
    area = h * end**2 / 2.0 - end**3 / 3.0 - s * (h * end**3 / 3.0 - end**4 / 4.0)
    return np.asarray(6.0 / h**3 * area * np.cos(rotation))


def count_side_walls(oscillator: Oscillator, context: Context) -> Context:
    """Return the context of a check that counts the friction of side walls: in alpha0 and in a(d), outwards alone."""
    toothing = context.toothing
    if toothing is None:
        return context
    moment = counted_moment(toothing)

    def held(each: Oscillator | None) -> Oscillator:
        made = each or oscillator
        more = moment * friction_left(toothing, made.positive.rotation)
        return replace(made, positive=replace(made.positive, restoring=made.positive.restoring + more))

    return replace(context, starting=held(context.starting), breaking=held(context.breaking))


def with_side_wall_messages(check: Check, context: Context) -> Check:
    """Return a check of the way outwards with what its pass depends on, and what turns before the whole wall."""
    toothing = context.toothing
    if toothing is None or check.branch != "positive" or counted_moment(toothing) <= 0.0:
        return check
    least, whole = least_part(toothing), float(toothing.height[-1])
    if check.verdict == Outcome.PASS:
        hold = message("side-walls-hold", severity=Severity.WARNING)
        check = replace(check, conditions=(*check.conditions, hold))
    if least.height > NEARLY_WHOLE * whole and least.slope == 0.0:
        return check
    values = {
        "height": Quantity(least.height, "length", 3),
        "slope": Quantity(least.slope, figures=3),
        "multiplier": Quantity(least.multiplier),
    }
    return replace(check, remarks=(*check.remarks, message("side-walls-part", values)))


def toothing_steps(toothing: Toothing) -> tuple[Step, ...]:
    """Write F of the whole crack, the least multiplier over heights and slopes, and the moment that counts."""
    least, whole = least_part(toothing), float(toothing.height[-1])
    h, N, place, steepest = least.height, float(toothing.walls), least.place, steepest_slope(toothing)
    density: Given = {"ρ": (toothing.density, "kg/m3")}
    of_friction: Given = {
        "n": whole / toothing.course,
        "Φ": toothing.course / toothing.overlap,
        "μ": toothing.friction,
        "l": (toothing.overlap, "m"),
        "t_s": (toothing.thickness, "m"),
        **density,
    }
    F = _friction_of(toothing, whole)
    of_least: Given = {
        "R_h": (float(toothing.restoring[place]), "N m"),
        "N": N,
        "W_h": (float(_wedge(toothing, least.height)), "N"),
        "τ": least.slope,
        "a_h": (float(toothing.depth[place]), "m"),
        "h": (h, "m"),
        "F_h": (_friction_of(toothing, h), "N"),
        "τ_b": steepest,
        "B_h": (float(toothing.excitation[place]), "kg m"),
    }
    of_moment: Given = {
        "N": N,
        "F": (F, "N"),
        "H": (whole, "m"),
        "α_h": least.multiplier,
        "B": (float(toothing.excitation[-1]), "kg m"),
        "R": (float(toothing.restoring[-1]), "N m"),
    }
    resisting = "R_h + N · (W_h · τ · (a_h + h · τ / 3) + F_h · (1 − τ / τ_b) · h / 3)"
    return (
        step(
            "F",
            "friction of the toothed crack of each side wall, over its whole height",
            CLAUSE,
            "0.4 · n · (n + 1) · Φ · μ · l² · t_s · ρ · g",
            F,
            "N",
            given=of_friction,
        ),
        step(
            "α_h",
            "least multiplier over the height h of what turns and the slope τ of cracks in the side walls",
            CLAUSE,
            f"({resisting}) / (g · B_h + N · W_h · τ · 2 · h / 3)",
            least.multiplier,
            given=of_least,
        ),
        step(
            "M_F",
            "moment of the friction that counts, no more than gives the wall that multiplier",
            CLAUSE,
            "min(N · F · H / 3, max(α_h · g · B − R, 0))",
            counted_moment(toothing),
            "N m",
            given=of_moment,
        ),
    )


def left_step(toothing: Toothing, rotation: float, *, argument: str) -> Step:
    """Write what is left of the moment of the friction at a rotation [rad], named `argument`."""
    moment, left = counted_moment(toothing), float(friction_left(toothing, np.array([rotation]))[0])
    words = "moment of that friction, part of R: c of it is left where overlaps are not yet lost"
    given: Given = {"M_F": (moment, "N m"), "c": left}
    at: Given = {argument: (rotation, "rad")}
    return step(f"M_F({argument})", words, CLAUSE, "M_F · c", moment * left, "N m", given=given, at=at)


def _friction_of(toothing: Toothing, height: float) -> float:
    return toothing_friction(
        height=height,
        unit_height=toothing.course,
        overlap=toothing.overlap,
        thickness=toothing.thickness,
        unit_weight=g * toothing.density,
        friction=toothing.friction,
    )


def _wedge(toothing: Toothing, height: FloatArray | float) -> FloatArray:
    """Return the weight of a wedge for each unit of the slope of its crack [n] [N]."""
    return np.asarray(g * toothing.density * toothing.thickness * np.square(height) / 2.0)
