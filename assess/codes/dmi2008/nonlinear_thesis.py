"""The thesis' reading of the non-linear procedure (8.3.2): it reproduces Tables 8.6 and 8.7; for comparison only.

Its period has d_u under the root where the clause has d_s, on the linearised rigid curve.
"""

from __future__ import annotations

import numpy as np
from scipy.constants import g

from assess.codes.calculation_step import Given
from assess.codes.check import BranchName, Check, Step, caveats_of, step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import DAMPING, EDITION, ULTIMATE
from assess.codes.equivalent_blocks import to_equivalent_blocks
from assess.codes.italian.edition import Options
from assess.codes.pga_rotation import PgaRotation, pga_rotation, rotation_demand, to_pga_curve
from assess.codes.rotation_verdict import rotation_verdict
from assess.codes.table_steps import excitation_column, instability_step, integral_step
from assess.codes.worst_branch import branch_of, check_worst_branch
from assess.oscillator import Branch, Oscillator, displacement, threshold
from spectra.arrays import FloatArray


def thesis_pga_rotation(branch: Branch, context: Context, *, mass: float) -> PgaRotation:
    """Return PGA(phi) of the thesis' reading: a_s = lambda g (1 - 0.4 x) at d_s = 0.4 d_u, T = 2 pi sqrt(d_u / a_s).

    x = phi / phi_ov, d_u = x d0; lambda and the curve are linearised and rigid. The clause has d_s, not d_u, under the
    root; with d_u the eight walls of Table 8.6 come out within rounding (the letter is higher by about 1.6).

    Parameters
    ----------
    branch : the direction of rocking
    context : its spectrum
    mass : total moved mass [kg]

    Returns
    -------
    PgaRotation
    """
    d0 = float(displacement(branch, np.array(branch.unstable), mass=mass))
    linear = branch.linearised

    def secant(rotation: FloatArray) -> FloatArray:
        return linear.multiplier * g * (1 - ULTIMATE * rotation / branch.unstable)

    def period_of(rotation: FloatArray) -> FloatArray:
        return np.asarray(2 * np.pi * np.sqrt(rotation / branch.unstable * d0 / secant(rotation)))

    def pga_of(rotation: FloatArray) -> FloatArray:
        ordinate = context.spectrum.acceleration(period_of(rotation), damping=DAMPING)
        return secant(rotation) * context.spectrum.pga / ordinate

    return pga_rotation(
        pga_of,
        overturning=branch.unstable,
        period_of=period_of,
        longest_period=context.spectrum.longest_period,
    )


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Return the checks of the thesis' reading (8.3.2): at the ground, FC = 1, no threshold of uplift."""
    like = to_equivalent_blocks(oscillator, lambda branch: ULTIMATE * branch.unstable)

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        curve = thesis_pga_rotation(branch, context, mass=oscillator.mass)
        allowable = ULTIMATE * branch.unstable
        rotation = rotation_demand(curve, level)
        lifts = threshold(branch_of(oscillator, name))
        answer = rotation_verdict(rotation, allowable, curve=curve, level=level, uplift=lifts, context=context)
        return Check(
            procedure="dmi2008-nonlinear-thesis",
            edition=EDITION.name,
            reading="thesis",
            branch=name,
            limit_state="SLV",
            level_pga_g=level / g,
            input_at="ground",
            damping=DAMPING,
            quantity="rotation",
            unit="rad",
            demand=rotation,
            capacity=allowable,
            ratio=None if rotation is None else rotation / allowable,
            verdict=answer.verdict,
            reason=answer.reason,
            capacity_pga_g=answer.capacity_pga_g,
            uplift_pga_g=lifts,
            capacity_rotation_ratio=allowable / branch.overturning,
            rotation_ratio=None if rotation is None else rotation / branch.overturning,
            pga_curve=to_pga_curve(curve, branch),
            steps=_steps(like, branch, context, level=level, rotation=rotation, at_collapse=answer.capacity_pga_g),
            **caveats_of(EDITION.caveat),
        )

    return check_worst_branch(like, context.levels, one)


def _steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    *,
    level: float,
    rotation: float | None,
    at_collapse: float | None,
) -> tuple[Step, ...]:
    linear, source = branch.linearised, "thesis 8.3.2"
    d0 = float(displacement(branch, np.array(branch.unstable), mass=oscillator.mass))
    a_s = linear.multiplier * g * (1 - ULTIMATE**2)
    period = float(2 * np.pi * np.sqrt(ULTIMATE * d0 / a_s))
    ratio = None if rotation is None else rotation / branch.overturning
    at_rest = {
        "K": (linear.stiffness, "N m/rad"),
        "φ_cr": (linear.critical, "rad"),
        "M": (linear.moment, "N m"),
        "B": (linear.excitation, "kg m"),
    }
    secant, moved = {"d0": (d0, "m"), "a_s": (a_s, "m/s2")}, d0 * oscillator.mass
    whole: Given = {"∫ B dφ": (moved, "kg m"), "M": (oscillator.mass, "kg")}
    falls, along = "rotation where the restoring moment falls to zero", "excitation over rotation"
    steps = (
        step("λ", "multiplier, linearised", "thesis 3.11", "(K φ_cr − M) / (g B)", linear.multiplier, given=at_rest),
        instability_step("φ_ov", falls, source, branch),
        integral_step("∫ B dφ", along, source, excitation_column(branch), branch.unstable, "kg m", upper="φ_ov"),
        step("d0", "displacement at overturning", source, "∫ B dφ / M", d0, "m", given=whole),
        step("a_s", "acceleration at 0.4 d_u, d_u = 0.4 d0", source, "λ g (1 − 0.4 · 0.4)", a_s, "m/s2",
             given={"λ": linear.multiplier}),
        step("T", "period, with d_u (the clause: d_s)", source, "2π √(0.4 d0 / a_s)", period, "s", given=secant),
        step("φ/φ_ov", "rotation at the level", source, "PGA(φ) = level", ratio, at={"level": (level / g, "g")}),
    )  # fmt: skip
    return steps if at_collapse is None else (*steps, *_collapse_steps(context, a_s, period, at_collapse))


def _collapse_steps(context: Context, a_s: float, period: float, at_collapse: float) -> tuple[Step, ...]:
    ordinate = float(context.spectrum.acceleration(period, damping=DAMPING)) / context.spectrum.pga
    clause, at = context.spectrum.clause, {"T": (period, "s"), "ξ": (DAMPING, "-")}
    given = {"a_s": (a_s, "m/s2"), "S_a/PGA": (ordinate, "-")}
    words = "largest PGA with φ ≤ 0.4 φ_ov"
    return (
        step("S_a/PGA", "spectrum over PGA, 5 %", clause, "S_a(T) / PGA", ordinate, at=at),
        step("PGA_c", words, "thesis 8.3.2", "a_s / (g S_a/PGA)", at_collapse, "g", given=given),
    )
