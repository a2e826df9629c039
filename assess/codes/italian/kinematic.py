"""The equivalent oscillator of kinematic analysis, the same in both circulars: a* = alpha g / (e* FC) over d*.

alpha(d) is the curve of lambda = restoring / (g B) of the mechanism; displacements are those of the control point over
e*. Source: Circolare 617/2009, C8A.4.1-2; 7/2019, C8.7.1.1-C8.7.1.5.
"""

from __future__ import annotations

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.calculation_step import Given
from assess.codes.check import Step, step
from assess.codes.italian.confidence import confidence_step
from assess.codes.italian.edition import Edition
from assess.codes.italian.limit_state import Case
from assess.oscillator import (
    Branch,
    displacement,
    multiplier,
    participation_ratio,
    resisted,
    threshold,
)

BEFORE = 1e-9
"""Of a rotation at which an action ends: just before it, where the curve has a jump."""


def activation(branch: Branch, *, mass: float, confidence_factor: float) -> float:
    """a0* = alpha0 g / (e* FC) [m/s2]."""
    return resisted(branch) * g / (participation_ratio(branch, mass=mass) * confidence_factor)


def displacement_at_collapse(branch: Branch, *, mass: float) -> float:
    """d0* [m], where the multiplier of the model's own curve falls to zero."""
    return displacement_at(branch, branch.unstable, mass=mass)


def displacement_at(branch: Branch, rotation: float, *, mass: float) -> float:
    """Spectral displacement d* [m] at a rotation [rad] (C8.7.1.4)."""
    moved = float(displacement(branch, np.array(rotation), mass=mass))
    return moved / participation_ratio(branch, mass=mass)


def rotation_at(branch: Branch, moved: float, *, mass: float) -> float:
    """Rotation [rad] at which the control point has moved by `moved` [m], up to the overturning rotation."""
    integral = branch.excitation_integral
    return float(brentq(lambda phi: float(integral(phi)) / mass - moved, 0.0, branch.unstable, xtol=1e-15))


def multiplier_at(branch: Branch, rotation: float) -> float:
    """lambda [-] of the model's own curve at a rotation [rad]."""
    return float(branch.restoring_spline(rotation)) / float(branch.excitation_spline(rotation)) / g


def acceleration_at(branch: Branch, moved: float, *, mass: float, confidence_factor: float) -> float:
    """a* [m/s2] at a displacement d* = `moved` [m], on the model's own curve, before an action that ends there."""
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass) * (1.0 - BEFORE)
    return multiplier_at(branch, rotation) * g / (e * confidence_factor)


def uplift_pga(branch: Branch, *, confidence_factor: float, amplified: float) -> float | None:
    """PGA [m/s2] that lifts the mechanism off: lambda g / FC over what the floor amplifies the ground by [-].

    None on joints without a threshold of uplift.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / confidence_factor / max(1.0, amplified)


def activation_steps(case: Case, edition: Edition) -> tuple[Step, ...]:
    """The PGA, alpha0, e*, FC and a0* as the calculation sheets print them."""
    branch, mass, FC = case.curves.starting, case.curves.mass, case.confidence.factor
    e, moved = participation_ratio(branch, mass=mass), "(Σ m δx)² / (M · Σ m δx²)"
    shares: Given = {
        "Σ m δx": (float(branch.excitation[0]), "kg m"),
        "M": (mass, "kg"),
        "Σ m δx²": (float(branch.participation[0]), "kg m2"),
    }
    a0, given = activation(branch, mass=mass, confidence_factor=FC), {"α0": resisted(branch), "e*": e, "FC": FC}
    return (
        case.pga_step,
        _multiplier_step(branch, edition.multiplier),
        step("e*", "fraction of participating mass", edition.oscillator, moved, e, given=shares),
        confidence_step(case.confidence, edition),
        step("a0*", "acceleration of activation", edition.oscillator, "α0 · g / (e* · FC)", a0, "m/s2", given=given),
    )


def _multiplier_step(branch: Branch, clause: str) -> Step:
    """alpha0: at rest, or on joints the largest of the curve."""
    alpha0, words = resisted(branch), "multiplier that starts the mechanism"
    if alpha0 > float(multiplier(branch)[0]):
        return step("α0", words, clause, "largest λ of the curve", alpha0, remark="joints that give way")
    given: Given = {"R0": (float(branch.restoring[0]), "N m"), "B0": (float(branch.excitation[0]), "kg m")}
    return step("α0", f"{words}; R0 = V'(0) − M", clause, "R0 / (g · B0)", alpha0, given=given)


def collapse_step(branch: Branch, clause: str, *, mass: float) -> Step:
    """d0* as the calculation sheets print it."""
    e, collapse = participation_ratio(branch, mass=mass), displacement_at_collapse(branch, mass=mass)
    words = f"displacement where a* = 0, actions shown to last alone; B integrated to φ_ov = {branch.unstable:.5g} rad"
    given: Given = {"∫ B dφ": (collapse * e * mass, "kg m"), "M": (mass, "kg"), "e*": e}
    return step("d0*", words, clause, "∫ B dφ / (M · e*)", collapse, "m", given=given)


def curve_step(case: Case, clause: str, symbol: str, words: str, *, moved: float) -> Step:
    """a* at the displacement d* = `moved` [m] as the calculation sheets print it: with lambda, and where it is read."""
    branch, mass, FC = case.curves.breaking, case.curves.mass, case.confidence.factor
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass)
    a = acceleration_at(branch, moved, mass=mass, confidence_factor=FC)
    said = f"{words}: λ at d* = {moved:.5g} m, φ = {rotation:.5g} rad"
    given = {"λ": a * e * FC / g, "e*": e, "FC": FC}
    return step(symbol, said, clause, "λ · g / (e* · FC)", a, "m/s2", given=given)
