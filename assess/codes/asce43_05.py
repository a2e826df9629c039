"""ASCE/SEI 43-05, Appendix A.2: rocking of an unanchored rigid body by a spectrum, as an equivalent linear oscillator.

The method stands in two readings: the clause's, and the thesis' that reproduces its Tables 8.5-8.6. Above the ground
the clause's reading uses the floor's own spectrum where there is one. The formulas are written for any rocking
oscillator: E(phi) is the work stored, B0 and I0 are excitation and inertia at rest. For a block of half-width b and
centroid height h, a = b/h, these give the clause's own quantities: h = B0/M, C1 = I0/(M h^2),
f1 = E/(M g h) = cos(theta) + a sin(theta) - 1.

Not checked against the printed standard: the equations were seen in excerpts and re-derived from energy. The clause's
limit of rotation (7.1) could not be read: one third of the rotation that overturns is allowed, and one half, the limit
of the response-history method of the same standard, is shown beside it. One function for each formula.

Vertical motion is S_aV/S_aH = 1 at the ground where nothing is stated; the thesis' reading has none. On a floor its
ratio is that of the floor's spectra, and a pass needs it. A body that stands free rocks under both horizontal
components: 100 % of one with 40 % of the other are 1.08 times the action, and a pass without that has a condition.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np

from assess.codes.calculation_sheet import (
    Given,
    Step,
    instability_step,
    integral_step,
    moment_column,
    multiplier_step,
    step,
)
from assess.codes.check import (
    Check,
    CodeProcedure,
    DefaultRun,
    Family,
    InputAt,
    Outcome,
    Reason,
    branch_of,
    caveats_of,
    check_worst_branch,
    reason_message,
)
from assess.codes.context import Context
from assess.codes.pga_rotation import (
    PgaOf,
    PgaRotation,
    RotationOutcome,
    floor_pga_rotation,
    pga_capacity,
    pga_rotation,
    rotation_demand,
    rotation_verdict,
    to_equivalent_blocks,
    to_pga_curve,
)
from assess.declaration import Evidence, NotNegativeRatio, PositiveLength, Safe
from assess.messages.message import Quantity, Severity, Term, message
from assess.oscillator import (
    Branch,
    BranchName,
    Oscillator,
    RockingBlock,
    block_at,
    energy,
    equivalent_block,
    linear_multiplier,
    multiplier,
    threshold,
)
from spectra.arrays import FloatArray
from spectra.gravity import g
from spectra.spectrum import Spectrum

EDITION = "ASCE/SEI 43-05"
A2_CAVEAT = "Appendix A.2 was not checked against the printed standard: its equations were re-derived from energy"
A2, LIMIT, THESIS = "ASCE 43-05 A.2", "ASCE 43-05 A.2, limit of 7.1 not read", "Mehrotra 8.3.2"
HALF = 0.5  # of the rotation that overturns: allowed to the mean of the maxima of response histories
THIRD = 1.0 / 3.0  # of the same: allowed by A.2
THESIS_DAMPING = 0.05


VERTICAL_RATIO = 1.0  # S_aV / S_aH at the ground where the project states none
OTHER_COMPONENT = 0.4  # of the horizontal component at right angles, beside the whole of the one in the plane
COMBINATION = "ASCE 4, 100-40 rule"
FLOOR_KEY = "procedures.asce43-05.floor_vertical_ratio"

ALLOWABLE = Evidence("chosen", "up", "absent: sliding is for information", safe=Safe.ABSENT)
FLOOR_SPECTRUM_KEY = "procedures.asce43-05.floor_spectrum"
FLOOR_SPECTRUM = Evidence(
    "chosen", ("circolare-7-2019",), "absent: a pass by it is not answered", judged="a condition names it"
)
OF_CIRCOLARE = "Circolare 7/2019, C7.2.5, first mode"  # `clause` of a floor spectrum of another country's code
FLOOR_RATIO = Evidence("code", "down", "absent: not answered on a floor", safe=Safe.ABSENT)


@dataclass(frozen=True)
class Asce4305Options:
    """Options of ASCE/SEI 43-05."""

    allowable_sliding: Annotated[PositiveLength | None, ALLOWABLE] = None
    """how far a body may slide on its base (A.1), like "0.05 m"; if absent its sliding is shown for information"""
    floor_vertical_ratio: Annotated[NotNegativeRatio | None, FLOOR_RATIO] = None
    """vertical over horizontal spectral acceleration of the floor below a mechanism above the ground, by its vertical
    floor spectrum; if absent a check above the ground may fail and cannot pass"""
    floor_spectrum: Annotated[Literal["circolare-7-2019"] | None, FLOOR_SPECTRUM] = None
    """"circolare-7-2019": the Italian floor spectrum, C7.2.5, may decide A.2 where no histories give the floor's own"""


def assess_spectrum(oscillator: Oscillator, context: Context, *, options: Asce4305Options) -> tuple[Check, ...]:
    """Return the checks of A.2 with the demand at f_e and beta_e from uplift on, one for each level."""

    shaken = with_floor_ratio(context, options)

    def reading(branch: Branch, f_v: float) -> SpectrumReading:
        return clause_reading(branch, shaken, f_v=f_v)

    return tuple(
        _by_floor_of_other_code(
            _without_vertical_floor(_with_second_component(check, shaken), context, options), context, options
        )
        for check in _spectrum_checks(oscillator, shaken, reading, own=oscillator)
    )


ASCE43_05_SPECTRUM = CodeProcedure(
    name="asce43-05-spectrum",
    family=Family.ENERGY,
    assess=assess_spectrum,
    title=Term("ASCE 43-05, approximate method"),
    short_title=Term("ASCE 43-05 approximate"),
    work="asce43-05",
    options="asce43_05",
    default_run=DefaultRun(),
    floor_suite_rules="asce43-05",
    damped_by_impacts=True,
)


def _assess_spectrum_thesis(oscillator: Oscillator, context: Context, *, options: Asce4305Options) -> tuple[Check, ...]:
    """Return the checks of the thesis' reading (8.3.2): 5 % damping, limit k alpha / sin 2 alpha, no uplift.

    The thesis has no vertical motion.
    """
    shaken = replace(context, vertical_ratio=0.0)

    def reading(branch: Branch, f_v: float) -> SpectrumReading:
        return thesis_reading(branch, shaken, f_v=f_v, mass=oscillator.mass)

    like = to_equivalent_blocks(oscillator, lambda branch: thesis_limit(branch, mass=oscillator.mass))
    return _spectrum_checks(like, shaken, reading, own=oscillator)


ASCE43_05_SPECTRUM_THESIS = CodeProcedure(
    name="asce43-05-spectrum-thesis",
    family=Family.ENERGY,
    assess=_assess_spectrum_thesis,
    title=Term("ASCE 43-05, approximate method, Mehrotra"),
    short_title=Term("ASCE 43-05 appr., Mehrotra"),
    work="asce43-05",
    options="asce43_05",
    reading="thesis",
    default_run=DefaultRun(),
    floor_suite_rules="asce43-05",
)


@dataclass(frozen=True)
class SpectrumReading:
    """How the clause is read for one branch.

    damping : of the demand [-]; damping_steps : where it comes from
    spectrum : of the motion at the base, which has these ordinates at `pga` of the ground [m/s2]; input_at : where
    curve : PGA over rotation; limit : the allowable rotation [rad]; limit_steps : where it comes from
    in_range : whether the limit holds for such a body
    """

    procedure: CodeProcedure
    damping: float
    damping_steps: tuple[Step, ...]
    spectrum: Spectrum
    pga: float
    input_at: InputAt
    curve: PgaRotation
    limit: float
    limit_steps: tuple[Step, ...]
    in_range: bool = True


ReadingOf = Callable[[Branch, float], SpectrumReading]


def clause_reading(branch: Branch, context: Context, *, f_v: float) -> SpectrumReading:
    """Read the clause to the letter: demand at f_e and beta_e from uplift on, a third of overturning allowed.

    Parameters
    ----------
    branch : the direction of rocking
    context : the site, and the floor's spectrum where the mechanism is above the ground
    f_v : factor of vertical motion [-]

    Returns
    -------
    SpectrumReading
    """
    damping, uplift = effective_damping(branch.restitution), (threshold(branch) or 0.0) * g
    floor, pga = context.floor_spectrum if context.above_ground else None, context.spectrum.pga
    if floor is None:
        curve = spectral_pga_rotation(branch, context.spectrum, damping=damping, f_v=f_v, uplift=uplift)
    else:
        curve = floor_spectral_pga_rotation(branch, floor, damping=damping, f_v=f_v, uplift=uplift, pga=pga)
    return SpectrumReading(
        procedure=ASCE43_05_SPECTRUM,
        damping=damping,
        damping_steps=_effective_damping_steps(branch.restitution, damping),
        spectrum=floor or context.spectrum,
        pga=pga,
        input_at="ground" if floor is None else "mechanism base",
        curve=curve,
        limit=THIRD * branch.unstable,
        limit_steps=_limit_steps(branch, curve),
    )


def thesis_reading(branch: Branch, context: Context, *, f_v: float, mass: float) -> SpectrumReading:
    """Read the clause as the thesis does (8.3.2): 5 % damping, limit k alpha / sin 2 alpha, no threshold of uplift.

    Parameters
    ----------
    branch : the direction of rocking
    context : the site
    f_v : factor of vertical motion [-]
    mass : total moved mass [kg]

    Returns
    -------
    SpectrumReading
    """
    block = equivalent_block(branch, mass=mass)
    ratio, k, alpha = thesis_limit_ratio(block), inertia_ratio(block), block.slenderness
    limit, words = ratio * branch.unstable, "empirical: fits Mehrotra’s Table 8.5, no derivation known"
    given = {"φ_ov": (branch.unstable, "rad"), "k": (k, "-"), "α": (alpha, "rad")}
    parts = {"I_O": (block.inertia, "kg m2"), "M": (mass, "kg"), "R": (block.radius, "m")}
    return SpectrumReading(
        procedure=ASCE43_05_SPECTRUM_THESIS,
        damping=THESIS_DAMPING,
        damping_steps=(step("β_e", "damping of the demand", THESIS, "5 %", THESIS_DAMPING),),
        spectrum=context.spectrum,
        pga=context.spectrum.pga,
        input_at="ground",
        curve=spectral_pga_rotation(branch, context.spectrum, damping=THESIS_DAMPING, f_v=f_v, uplift=0.0),
        limit=limit,
        limit_steps=(
            step("k", "inertia ratio of the equivalent block", THESIS, "I_O / (M R²)", k, given=parts),
            step("θ_lim", words, THESIS, "φ_ov k α / sin(2 α)", limit, "rad", given=given),
        ),
        in_range=ratio <= 1.0,
    )


def warn_at_height(checks: tuple[Check, ...], *, context: Context) -> tuple[Check, ...]:
    """Add a warning and a line of the sheet to checks by the ground's motion of a mechanism above the ground."""
    return tuple(_with_height(check, context.support_height) for check in checks) if context.above_ground else checks


def with_floor_ratio(context: Context, options: Asce4305Options) -> Context:
    """Return the context with the vertical ratio of the floor where the mechanism stands on one and it is given."""
    given = options.floor_vertical_ratio
    return context if given is None or not context.above_ground else replace(context, vertical_ratio=given)


def lacks_vertical_floor(context: Context, options: Asce4305Options) -> bool:
    """Return whether the mechanism is above the ground and nothing is known of the vertical motion there."""
    return context.above_ground and options.floor_vertical_ratio is None


def component_factor(context: Context) -> float:
    """Return the action of both horizontal components over that of one: sqrt(1 + 0.4^2) for what stands free, else 1.

    Parameters
    ----------
    context : how the body is held

    Returns
    -------
    float [-]
    """
    return float(np.hypot(1.0, OTHER_COMPONENT)) if context.support == "free" else 1.0


def component_step(context: Context) -> tuple[Step, ...]:
    """Write the line of `component_factor`; none for what does not stand free."""
    if context.support != "free":
        return ()
    words = "both horizontal components on a body that stands free, over one"
    given = {"c": OTHER_COMPONENT}
    return (step("k_h", words, COMBINATION, "√(1 + c²)", component_factor(context), given=given),)


def falls_short(check: Check, factor: float) -> bool:
    """Return whether a pass is not shown to hold at a factor on the action."""
    bears = check.capacity_pga_g is not None and check.capacity_pga_g >= factor * check.level_pga_g
    return check.verdict == Outcome.PASS and not bears


def vertical_factor(a: float, ratio: float) -> float:
    """Return F_V = sqrt(1 + (a S_aV/S_aH)^2), the probabilistic combination with vertical motion (Eq. A-5(b)).

    Parameters
    ----------
    a : multiplier at uplift, tan(alpha) of a block [-]
    ratio : S_aV / S_aH [-]

    Returns
    -------
    F_V, at least 1 [-].
    """
    return float(np.hypot(1.0, a * ratio))


def stored_work(branch: Branch, rotation: FloatArray) -> FloatArray:
    """Return f1(theta) = E(theta) / (g B0); cos(theta) + a sin(theta) - 1 of a block (Eq. A-5(a)).

    Parameters
    ----------
    branch : the direction of rocking
    rotation : theta [n] [rad]

    Returns
    -------
    array [n] [-]
    """
    return energy(branch, rotation) / float(g * branch.excitation[0])


def capacity_acceleration(branch: Branch, rotation: FloatArray, *, f_v: float) -> FloatArray:
    """Return SA_H,CAP = 2 g f1 / (F_V F_H theta) (Eq. A-5); F_H = 1, because B0 counts every mass that shakes.

    Parameters
    ----------
    branch : the direction of rocking
    rotation : theta > 0 [n] [rad]
    f_v : factor of vertical motion [-]

    Returns
    -------
    array [n] [m/s2]
    """
    return 2 * g * stored_work(branch, rotation) / (f_v * rotation)


def effective_frequency(branch: Branch, rotation: FloatArray) -> FloatArray:
    """Return f_e of the linear oscillator that stores the same work: omega_e^2 = 2 E / (I0 theta^2) (A.2, step 2).

    Parameters
    ----------
    branch : the direction of rocking
    rotation : theta > 0 [n] [rad]

    Returns
    -------
    array [n] [Hz]
    """
    omega = np.sqrt(2 * energy(branch, rotation) / float(branch.inertia[0])) / rotation
    return np.asarray(omega / (2 * np.pi))


def effective_damping(restitution: float) -> float:
    """Return beta_e = gamma / sqrt(4 pi^2 + gamma^2), gamma = -2 ln C_R, of two impacts in a cycle (A.2, step 2).

    An impact onto a nearer hinge may leave more velocity, though never more energy: C_R >= 1 then gives no damping.

    Parameters
    ----------
    restitution : C_R, velocity after over velocity before an impact [-]

    Returns
    -------
    float
        beta_e, 1 without rebound [-].
    """
    if restitution == 0.0:
        return 1.0
    gamma = -2 * np.log(min(restitution, 1.0))
    return float(gamma / np.hypot(2 * np.pi, gamma))


def thesis_limit_ratio(block: RockingBlock) -> float:
    """Return theta_lim / alpha = k alpha / sin(2 alpha) [-], the limit of rotation in the thesis (8.3.2).

    Empirical: no derivation is known; it fits the thesis' Table 8.5 within rounding for all eight walls.
    """
    return float(inertia_ratio(block) * block.slenderness / np.sin(2 * block.slenderness))


def inertia_ratio(block: RockingBlock) -> float:
    """Return k = I_O / (M R^2) = g / (p^2 R) [-]."""
    return block.inertia / (block.mass * block.radius**2)


def thesis_limit(branch: Branch, *, mass: float) -> float:
    """Return the limit of rotation theta_lim on a flexible joint.

    It is where theta equals the ratio of `thesis_limit_ratio` times alpha, both of the equivalent block at theta.

    Parameters
    ----------
    branch : the direction of rocking
    mass : total moved mass [kg]

    Returns
    -------
    float
        theta_lim [rad]; the overturning rotation where no such theta exists, because the formula is out of its range.
    """

    def excess(rotation: float) -> float:
        block = block_at(branch, rotation, mass=mass)
        return rotation - thesis_limit_ratio(block) * block.slenderness

    low, high = 1e-3 * branch.unstable, branch.unstable
    from scipy.optimize import brentq

    return float(brentq(excess, low, high, xtol=1e-12)) if excess(low) < 0.0 < excess(high) else high


def spectral_pga_rotation(
    branch: Branch, spectrum: Spectrum, *, damping: float, f_v: float, uplift: float
) -> PgaRotation:
    """Return PGA(theta), at which SA_H,CAP equals the spectrum's ordinate at f_e, the spectrum scaled with its PGA.

    Parameters
    ----------
    branch : the direction of rocking
    spectrum : of the ground
    damping : of the demand [-]
    f_v : factor of vertical motion [-]
    uplift : PGA below which nothing rocks [m/s2]

    Returns
    -------
    PgaRotation
    """
    return pga_rotation(
        _pga_of(branch, spectrum, damping=damping, f_v=f_v, pga=spectrum.pga),
        overturning=branch.unstable,
        uplift=uplift,
        period_of=_period_of(branch),
        longest_period=spectrum.longest_period,
    )


def floor_spectral_pga_rotation(
    branch: Branch, floor: Spectrum, *, damping: float, f_v: float, uplift: float, pga: float
) -> PgaRotation:
    """Return PGA(theta) of the ground where the demand is the spectrum of a floor.

    Parameters
    ----------
    branch : the direction of rocking
    floor : spectrum of the floor
    damping : of the demand [-]
    f_v : factor of vertical motion [-]
    uplift : peak acceleration of the floor below which nothing rocks [m/s2]
    pga : peak acceleration of the ground that belongs to `floor` [m/s2]

    Returns
    -------
    PgaRotation
    """
    return floor_pga_rotation(
        _pga_of(branch, floor, damping=damping, f_v=f_v, pga=pga),
        overturning=branch.unstable,
        uplift=uplift * pga / floor.pga,
        period_of=_period_of(branch),
        longest_period=floor.longest_period,
    )


def _effective_damping_steps(restitution: float, damping: float) -> tuple[Step, ...]:
    if restitution == 0.0:
        return (step("β_e", "effective damping", A2, "1", damping, remark="no rebound", at={"C_R": restitution}),)
    gamma = -2.0 * float(np.log(min(restitution, 1.0)))
    return (
        step("γ", "of two impacts in a cycle", A2, "−2 ln(min(C_R, 1))", gamma, given={"C_R": restitution}),
        step("β_e", "effective damping", A2, "γ / √(4π² + γ²)", damping, given={"γ": gamma}),
    )


def _limit_steps(branch: Branch, curve: PgaRotation) -> tuple[Step, ...]:
    """Write the allowable rotation and, beside it, half of what overturns, with the PGA that takes the body there."""
    overturns, half = {"φ_ov": (branch.unstable, "rad")}, HALF * branch.unstable
    third = "allowed: one third of the rotation that overturns"
    beside = "one half, the limit of response histories, for comparison"
    at_half = pga_capacity(curve, half)
    return (
        instability_step("φ_ov", "rotation that overturns the body, joints included", A2, branch),
        step("θ_lim", third, LIMIT, "φ_ov / 3", THIRD * branch.unstable, "rad", given=overturns),
        step("θ_1/2", beside, LIMIT, "φ_ov / 2", half, "rad", given=overturns),
        step("PGA(θ_1/2)", "PGA at capacity if one half were allowed", LIMIT, "largest PGA with θ ≤ θ_1/2",
             None if at_half is None else at_half / g, "g", at={"θ_1/2": (half, "rad")},
             remark="on the curve of PGA over rotation of this method"),
    )  # fmt: skip


def _spectrum_checks(
    oscillator: Oscillator, context: Context, reading_of: ReadingOf, *, own: Oscillator
) -> tuple[Check, ...]:
    """Return the checks of an oscillator as it is read; `own` is the mechanism's, whose threshold of uplift counts."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        lifts = threshold(branch_of(own, name))
        f_v = vertical_factor(linear_multiplier(branch), context.vertical_ratio)
        return _spectrum_check(oscillator, branch, name, context, reading_of(branch, f_v), level, f_v=f_v, lifts=lifts)

    return warn_at_height(check_worst_branch(oscillator, context.levels, one), context=context)


def _with_second_component(check: Check, context: Context) -> Check:
    """Add the line of both horizontal components, and the condition of a pass that does not hold with them."""
    factor = component_factor(context)
    check = replace(check, steps=(*check.steps, *component_step(context)))
    if not falls_short(check, factor):
        return check
    condition = message("one-component", {"factor": Quantity(factor, "ratio", 2)}, severity=Severity.WARNING)
    return replace(check, conditions=(*check.conditions, condition))


def _without_vertical_floor(check: Check, context: Context, options: Asce4305Options) -> Check:
    """Return the check of a floor; one that passes is not answered where nothing is known of its vertical motion."""
    unknown = check.input_at == "mechanism base" and lacks_vertical_floor(context, options)
    if check.verdict != Outcome.PASS or not unknown:
        return check
    return _unanswered(check, Reason.VERTICAL_UNKNOWN, key=FLOOR_KEY, line="floor_vertical_ratio = 1.0")


def _by_floor_of_other_code(check: Check, context: Context, options: Asce4305Options) -> Check:
    """Return the check of a floor; one that passes by another code's floor spectrum needs that to be named."""
    floor = context.floor_spectrum if check.input_at == "mechanism base" else None
    if check.verdict != Outcome.PASS or floor is None or floor.clause != OF_CIRCOLARE:
        return check
    if options.floor_spectrum is None:
        line = 'floor_spectrum = "circolare-7-2019"'
        return _unanswered(check, Reason.FLOOR_SPECTRUM_UNNAMED, key=FLOOR_SPECTRUM_KEY, line=line)
    condition = message("floor-spectrum-of-other-code", {"clause": floor.clause}, severity=Severity.WARNING)
    return replace(check, conditions=(*check.conditions, condition))


def _unanswered(check: Check, reason: Reason, *, key: str, line: str) -> Check:
    """Return a check that passes as not answered, for want of a key; line: of the project file, to begin with."""
    why = message(reason, {"key": key, "toml": line}, severity=Severity.NOTE, where=key)
    return replace(check, verdict=Outcome.NOT_ANSWERED, provisional=Outcome.PASS, may_pass=False, reason=why)


def _spectrum_check(
    oscillator: Oscillator,
    branch: Branch,
    name: BranchName,
    context: Context,
    reading: SpectrumReading,
    level: float,
    *,
    f_v: float,
    lifts: float | None,
) -> Check:
    curve, allowable, spectrum = reading.curve, reading.limit, reading.spectrum
    rotation = rotation_demand(curve, level)
    uplift = None if lifts is None else lifts * reading.pga / spectrum.pga
    answer = rotation_verdict(rotation, allowable, curve=curve, level=level, uplift=uplift, context=context)
    if not reading.in_range:
        answer = RotationOutcome(Outcome.NOT_APPLICABLE, reason_message(Reason.LIMIT_BEYOND_OVERTURNING), None)
    return Check(
        procedure=reading.procedure.name,
        edition=EDITION,
        reading=reading.procedure.reading,
        branch=name,
        limit_state="no overturning",
        level_pga_g=level / g,
        input_at=reading.input_at,
        damping=reading.damping,
        damping_rule=spectrum.damping_rule if reading.damping != spectrum.damping else "",
        quantity="rotation",
        unit="rad",
        demand=rotation,
        capacity=allowable,
        ratio=None if rotation is None else rotation / allowable,
        verdict=answer.verdict,
        reason=answer.reason,
        capacity_pga_g=answer.capacity_pga_g,
        uplift_pga_g=uplift,
        capacity_rotation_ratio=allowable / branch.overturning,
        rotation_ratio=None if rotation is None else rotation / branch.overturning,
        pga_curve=to_pga_curve(curve, branch),
        steps=_spectrum_steps(oscillator, branch, context, reading, level=level, f_v=f_v, rotation=rotation),
        **caveats_of(A2_CAVEAT),
    )


def _spectrum_steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    reading: SpectrumReading,
    *,
    level: float,
    f_v: float,
    rotation: float | None,
) -> tuple[Step, ...]:
    """Write the sheet, with spectral values at the demand, or at the allowable rotation where nothing rocks.

    Where the spectrum ends before that, they are taken where it ends; a sheet without a known ordinate ends with theta.
    """
    body, curve = _body_steps(oscillator, branch, context, f_v=f_v), reading.curve
    block = (*body, *reading.damping_steps, *reading.limit_steps)
    if not curve.rotation.size:
        return block
    at = rotation if rotation else min(reading.limit, float(curve.rotation[-1]))
    where: Where = "demand" if rotation else "limit" if at == reading.limit else "end"
    worked = _rotation_steps(oscillator, branch, reading, at=at, where=where, level=level, f_v=f_v)
    return (*block, *(_resting_steps(curve, level) if rotation == 0.0 else ()), *worked)


def _body_steps(oscillator: Oscillator, branch: Branch, context: Context, *, f_v: float) -> tuple[Step, ...]:
    """Write what the clause asks of the body."""
    mass, I0, B0, a = oscillator.mass, float(branch.inertia[0]), float(branch.excitation[0]), linear_multiplier(branch)
    h = B0 / mass
    meant = "tan α, multiplier at rest; uplift at a g" if a == multiplier(branch)[0] else "largest multiplier"
    moved = {"B0": (B0, "kg m"), "M": (mass, "kg")}
    turned = {"I_O": (I0, "kg m2"), "M": (mass, "kg"), "h": (h, "m")}
    vertical = {"a": a, "S_aV/S_aH": context.vertical_ratio}
    return (
        step("h", "height of the centroid", A2, "B0 / M", h, "m", given=moved),
        multiplier_step("a", meant, A2, branch),
        step("C1", "inertia ratio", A2, "I_O / (M h²)", I0 / (mass * h**2), given=turned),
        step("F_V", "vertical ground motion", "Eq. A-5(b)", "√(1 + (a S_aV/S_aH)²)", f_v, given=vertical),
        step("F_H", "inertia beyond the body's mass", "Eq. A-5(c)", "counted in B0", 1.0),
    )


def _resting_steps(curve: PgaRotation, level: float) -> tuple[Step, ...]:
    """Write why the demand is no rotation: the PGA is less than takes the body to any."""
    words = "no rotation: the PGA does not exceed the least that gives a lasting θ"
    at = {"PGA": (level / g, "g"), "least PGA(θ)": (float(curve.least[0]) / g, "g")}
    return (step("θ_dem", words, A2, "PGA ≤ least PGA(θ)", 0.0, "rad", at=at),)


Where = Literal["demand", "limit", "end"]
ROTATION: Mapping[Where, str] = {
    "demand": "rotation at the demand",
    "limit": "the allowable rotation",
    "end": "rotation where the curve ends, as the spectrum does",
}
PGA_THERE: Mapping[Where, str] = {
    "demand": "PGA that takes the body to θ, at the demand",
    "limit": "PGA that takes the body to θ, at the allowable rotation",
    "end": "PGA that takes the body to θ, where the curve ends",
}


def _rotation_steps(
    oscillator: Oscillator,
    branch: Branch,
    reading: SpectrumReading,
    *,
    at: float,
    where: Where,
    level: float,
    f_v: float,
) -> tuple[Step, ...]:
    """Write the steps from a rotation to the PGA that takes the body there."""
    theta, B0 = np.array([at]), float(branch.excitation[0])
    f1, stored = float(stored_work(branch, theta)[0]), float(energy(branch, theta)[0])
    cap = float(capacity_acceleration(branch, theta, f_v=f_v)[0])
    f_e = float(effective_frequency(branch, theta)[0])
    ordinate = float(reading.spectrum.acceleration(1 / f_e, damping=reading.damping)) / reading.pga
    h = B0 / oscillator.mass
    turned, C1 = {"θ": (at, "rad"), "h": (h, "m")}, float(branch.inertia[0]) / (oscillator.mass * h**2)
    solved: Given = {"PGA": (level / g, "g")}
    formula, given = (
        ("SA_H,DEM(θ) = SA_H,CAP(θ)", solved) if where == "demand" else ("θ_lim, or where the curve ends", {})
    )
    ordinate_at: Given = {"f_e": (f_e, "Hz"), "T": (1 / f_e, "s"), "β_e": reading.damping}
    work = {"E": (stored, "J"), "B0": (B0, "kg m")}
    capable = {"f1": (f1, "-"), "F_V": (f_v, "-"), "F_H": (1.0, "-"), "θ": (at, "rad")}
    demanded = {"SA_H,CAP": (cap, "m/s2"), "S_a/PGA": (ordinate, "-")}
    rocking = "work stored over M g h; rigid block: cos θ + a sin θ − 1"
    words = "work stored up to θ: the restoring moment over rotation"
    return (
        step("θ", ROTATION[where], A2, formula, at, "rad", at=given),
        integral_step("E", words, A2, moment_column(branch), at, "J", upper="θ"),
        step("f1", rocking, "Eq. A-5(a)", "E / (g B0)", f1, given=work),
        step("SA_H,CAP", "spectral acceleration capacity", "Eq. A-5", "2 g f1 / (F_V F_H θ)", cap, "m/s2",
             given=capable),
        step("f_e", "effective frequency", A2, "√(2 f1 g / (C1 h θ²)) / 2π", f_e, "Hz",
             given={"f1": (f1, "-"), "C1": (C1, "-"), **turned}),
        step("S_a/PGA", "spectrum at f_e, β_e over PGA", reading.spectrum.clause, "S_a(1/f_e, β_e) / PGA", ordinate,
             at=ordinate_at),
        step("PGA(θ)", PGA_THERE[where], A2, "SA_H,CAP / (S_a/PGA)", cap / ordinate, "m/s2", given=demanded),
    )  # fmt: skip


def _with_height(check: Check, height: float) -> Check:
    if check.input_at != "ground":
        return check
    words = "height of what holds the mechanism; the motion is that of the ground, not amplified"
    line = step("z", words, "geometry", "z_base − z_ground", height, "m")
    remark = message("ground-motion", severity=Severity.WARNING)
    return replace(check, remarks=(*check.remarks, remark), steps=(line, *check.steps))


def _period_of(branch: Branch) -> PgaOf:
    return lambda rotation: 1 / effective_frequency(branch, rotation)


def _pga_of(branch: Branch, spectrum: Spectrum, *, damping: float, f_v: float, pga: float) -> PgaOf:
    period_of = _period_of(branch)

    def pga_of(rotation: FloatArray) -> FloatArray:
        amplified = spectrum.acceleration(period_of(rotation), damping=damping) / pga
        return capacity_acceleration(branch, rotation, f_v=f_v) / amplified

    return pga_of
