"""The spectrum method of A.2 in two readings: the clause's, and the thesis' that reproduces its Tables 8.5-8.6.

Above the ground the clause's reading uses the floor's own spectrum where there is one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Literal

import numpy as np
from scipy.constants import g

from assess.codes.asce43_05.at_height import warn_at_height
from assess.codes.asce43_05.clauses import (
    CAVEAT,
    EDITION,
    Options,
    capacity_acceleration,
    effective_frequency,
    stored_work,
    thesis_limit,
    vertical_factor,
)
from assess.codes.asce43_05.interpretations import A2, Reading, clause_interpretation, thesis_interpretation
from assess.codes.calculation_step import Given
from assess.codes.check import BranchName, Check, Outcome, Reason, Step, caveats_of, reason_message, step
from assess.codes.context import Context
from assess.codes.equivalent_blocks import to_equivalent_blocks
from assess.codes.multiplier_step import multiplier_step
from assess.codes.pga_rotation import PgaRotation, rotation_demand, to_pga_curve
from assess.codes.rotation_verdict import Answer, rotation_verdict
from assess.codes.table_steps import integral_step, moment_column
from assess.codes.worst_branch import branch_of, check_worst_branch
from assess.oscillator import Branch, Oscillator, energy, linear_multiplier, multiplier, threshold

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
ReadingOf = Callable[[Branch, float], Reading]


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Return the checks of A.2 with the demand at f_e and beta_e from uplift on, one for each level."""

    def reading(branch: Branch, f_v: float) -> Reading:
        return clause_interpretation(branch, context, f_v=f_v)

    return _checks(oscillator, context, reading, own=oscillator)


def assess_thesis(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Return the checks of the thesis' reading (8.3.2): 5 % damping, limit k alpha / sin 2 alpha, no uplift."""

    def reading(branch: Branch, f_v: float) -> Reading:
        return thesis_interpretation(branch, context, f_v=f_v, mass=oscillator.mass)

    like = to_equivalent_blocks(oscillator, lambda branch: thesis_limit(branch, mass=oscillator.mass))
    return _checks(like, context, reading, own=oscillator)


def _checks(oscillator: Oscillator, context: Context, reading_of: ReadingOf, *, own: Oscillator) -> tuple[Check, ...]:
    """Return the checks of an oscillator as it is read; `own` is the mechanism's, whose threshold of uplift counts."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        lifts = threshold(branch_of(own, name))
        f_v = vertical_factor(linear_multiplier(branch), context.vertical_ratio)
        return _check(oscillator, branch, name, context, reading_of(branch, f_v), level, f_v=f_v, lifts=lifts)

    return warn_at_height(check_worst_branch(oscillator, context.levels, one), context=context)


def _check(
    oscillator: Oscillator,
    branch: Branch,
    name: BranchName,
    context: Context,
    reading: Reading,
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
        answer = Answer(Outcome.NOT_APPLICABLE, reason_message(Reason.LIMIT_BEYOND_OVERTURNING), None)
    return Check(
        procedure=reading.procedure,
        edition=EDITION,
        reading=reading.kind,
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
        steps=_steps(oscillator, branch, context, reading, level=level, f_v=f_v, rotation=rotation),
        **caveats_of(CAVEAT),
    )


def _steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    reading: Reading,
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


def _rotation_steps(
    oscillator: Oscillator, branch: Branch, reading: Reading, *, at: float, where: Where, level: float, f_v: float
) -> tuple[Step, ...]:
    """Write the way from a rotation to the PGA that takes the body there."""
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
