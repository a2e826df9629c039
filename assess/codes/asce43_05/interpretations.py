"""The two readings of A.2, the clause and the thesis: each choice with its lines of the calculation sheet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.codes.asce43_05.clauses import (
    HALF,
    THIRD,
    effective_damping,
    floor_spectral_pga_rotation,
    inertia_ratio,
    spectral_pga_rotation,
    thesis_limit_ratio,
)
from assess.codes.check import InputAt, Step, step
from assess.codes.check import Reading as Kind
from assess.codes.context import Context
from assess.codes.pga_rotation import PgaRotation, pga_capacity
from assess.codes.table_steps import instability_step
from assess.oscillator import Branch, equivalent_block, threshold
from spectra.spectrum import Spectrum

THESIS_DAMPING = 0.05
A2, LIMIT, THESIS = "ASCE 43-05 A.2", "ASCE 43-05 A.2, limit of 7.1 not read", "thesis 8.3.2"


@dataclass(frozen=True)
class Reading:
    """How the clause is read for one branch.

    damping : of the demand [-]; damping_steps : where it comes from
    spectrum : of the motion at the base, which has these ordinates at `pga` of the ground [m/s2]; input_at : where
    curve : PGA over rotation; limit : the allowable rotation [rad]; limit_steps : where it comes from
    in_range : whether the limit holds for such a body
    """

    procedure: str
    kind: Kind
    damping: float
    damping_steps: tuple[Step, ...]
    spectrum: Spectrum
    pga: float
    input_at: InputAt
    curve: PgaRotation
    limit: float
    limit_steps: tuple[Step, ...]
    in_range: bool = True


def clause_interpretation(branch: Branch, context: Context, *, f_v: float) -> Reading:
    """Read the clause to the letter: demand at f_e and beta_e from uplift on, a third of overturning allowed.

    Parameters
    ----------
    branch : the direction of rocking
    context : the site, and the floor's spectrum where the mechanism is above the ground
    f_v : factor of vertical motion [-]

    Returns
    -------
    Reading
    """
    damping, uplift = effective_damping(branch.restitution), (threshold(branch) or 0.0) * g
    floor, pga = context.floor_spectrum if context.above_ground else None, context.spectrum.pga
    if floor is None:
        curve = spectral_pga_rotation(branch, context.spectrum, damping=damping, f_v=f_v, uplift=uplift)
    else:
        curve = floor_spectral_pga_rotation(branch, floor, damping=damping, f_v=f_v, uplift=uplift, pga=pga)
    return Reading(
        procedure="asce43-05-spectrum",
        kind="letter",
        damping=damping,
        damping_steps=_effective(branch.restitution, damping),
        spectrum=floor or context.spectrum,
        pga=pga,
        input_at="ground" if floor is None else "mechanism base",
        curve=curve,
        limit=THIRD * branch.unstable,
        limit_steps=_third(branch, curve),
    )


def thesis_interpretation(branch: Branch, context: Context, *, f_v: float, mass: float) -> Reading:
    """Read the clause as the thesis does (8.3.2): 5 % damping, limit k alpha / sin 2 alpha, no threshold of uplift.

    Parameters
    ----------
    branch : the direction of rocking
    context : the site
    f_v : factor of vertical motion [-]
    mass : total moved mass [kg]

    Returns
    -------
    Reading
    """
    block = equivalent_block(branch, mass=mass)
    ratio, k, alpha = thesis_limit_ratio(block), inertia_ratio(block), block.slenderness
    limit, words = ratio * branch.unstable, "empirical: fits the thesis' Table 8.5, no derivation known"
    given = {"φ_ov": (branch.unstable, "rad"), "k": (k, "-"), "α": (alpha, "rad")}
    parts = {"I_O": (block.inertia, "kg m2"), "M": (mass, "kg"), "R": (block.radius, "m")}
    return Reading(
        procedure="asce43-05-spectrum-thesis",
        kind="thesis",
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


def _effective(restitution: float, damping: float) -> tuple[Step, ...]:
    if restitution == 0.0:
        return (step("β_e", "effective damping", A2, "1", damping, remark="no rebound", at={"C_R": restitution}),)
    gamma = -2.0 * float(np.log(min(restitution, 1.0)))
    return (
        step("γ", "of two impacts in a cycle", A2, "−2 ln(min(C_R, 1))", gamma, given={"C_R": restitution}),
        step("β_e", "effective damping", A2, "γ / √(4π² + γ²)", damping, given={"γ": gamma}),
    )


def _third(branch: Branch, curve: PgaRotation) -> tuple[Step, ...]:
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
