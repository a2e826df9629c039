"""The equivalent oscillator of kinematic analysis, the same in both circulars: a* = alpha g / (e* FC) over d*.

alpha(d) is the curve of lambda = restoring / (g B) of the mechanism; displacements are those of the control point over
e*. Source: Circolare 617/2009, C8A.4.1-2; 7/2019, C8.7.1.1-C8.7.1.5.
"""

from __future__ import annotations

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.check import Step
from assess.codes.italian.edition import Edition
from assess.codes.italian.limit_state import Case
from assess.codes.worked import multiplier_worked
from assess.oscillator import (
    Branch,
    displacement,
    excitation_integral,
    excitation_spline,
    participation_ratio,
    resisted,
    restoring_spline,
    threshold,
)


def activation(branch: Branch, *, mass: float, confidence_factor: float) -> float:
    """a0* = alpha0 g / (e* FC) [m/s2]."""
    return resisted(branch) * g / (participation_ratio(branch, mass=mass) * confidence_factor)


def displacement_at_collapse(branch: Branch, *, mass: float) -> float:
    """d0* [m], where the multiplier of the model's own curve falls to zero."""
    moved = float(displacement(branch, np.array(branch.unstable), mass=mass))
    return moved / participation_ratio(branch, mass=mass)


def rotation_at(branch: Branch, moved: float, *, mass: float) -> float:
    """Rotation [rad] at which the control point has moved by `moved` [m], up to the overturning rotation."""
    integral = excitation_integral(branch)
    return float(brentq(lambda phi: float(integral(phi)) / mass - moved, 0.0, branch.unstable, xtol=1e-15))


def acceleration_at(branch: Branch, moved: float, *, mass: float, confidence_factor: float) -> float:
    """a* [m/s2] at a displacement d* = `moved` [m], on the model's own curve."""
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass)
    moment, excitation = restoring_spline(branch), excitation_spline(branch)
    return float(moment(rotation)) / float(excitation(rotation)) / (e * confidence_factor)


def uplift_pga(branch: Branch, *, confidence_factor: float, amplified: float) -> float | None:
    """PGA [m/s2] that lifts the mechanism off: lambda g / FC over what the floor amplifies the ground by [-].

    None on joints without a threshold of uplift.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / confidence_factor / max(1.0, amplified)


def activation_steps(case: Case, edition: Edition, *, confidence_factor: float) -> tuple[Step, ...]:
    """The PGA, alpha0, e*, FC and a0* as the calculation sheets print them."""
    branch, mass = case.branch, case.mass
    formula, start, alpha0 = multiplier_worked(branch)
    e, B0, participation = participation_ratio(branch, mass=mass), branch.excitation[0], branch.participation[0]
    a0 = activation(branch, mass=mass, confidence_factor=confidence_factor)
    shares = f"{B0:.5g}² / ({participation:.5g} · {mass:.5g})"
    divided = f"{alpha0:.5g} · 9.80665 / ({e:.5g} · {confidence_factor:g})"
    given, oscillator = f"{confidence_factor:g}", edition.oscillator
    return (
        case.pga_step,
        Step("α0", "multiplier that starts the mechanism", edition.multiplier, formula, start, alpha0, "-"),
        Step("e*", "fraction of participating mass", oscillator, "(Σ m δx)² / (M Σ m δx²)", shares, e, "-"),
        Step("FC", "confidence factor", edition.confidence, "given", given, confidence_factor, "-"),
        Step("a0*", "acceleration of activation", oscillator, "α0 g / (e* FC)", divided, a0, "m/s2"),
    )


def collapse_step(branch: Branch, clause: str, *, mass: float) -> Step:
    """d0* as the calculation sheets print it."""
    e, collapse = participation_ratio(branch, mass=mass), displacement_at_collapse(branch, mass=mass)
    words = f"displacement where a* = 0; B integrated to φ_ov = {branch.unstable:.5g} rad"
    numbers = f"{collapse * e * mass:.5g} / ({mass:.5g} · {e:.5g})"
    return Step("d0*", words, clause, "∫ B dφ / (M e*)", numbers, collapse, "m")


def curve_step(case: Case, clause: str, symbol: str, words: str, *, moved: float, confidence_factor: float) -> Step:
    """a* at the displacement d* = `moved` [m] as the calculation sheets print it: with lambda, and where it is read."""
    e = participation_ratio(case.branch, mass=case.mass)
    rotation = rotation_at(case.branch, moved * e, mass=case.mass)
    a = acceleration_at(case.branch, moved, mass=case.mass, confidence_factor=confidence_factor)
    said = f"{words}: λ at d* = {moved:.5g} m, φ = {rotation:.5g} rad"
    numbers = f"{a * e * confidence_factor / g:.5g} · {g} / ({e:.5g} · {confidence_factor:g})"
    return Step(symbol, said, clause, "λ(φ) g / (e* FC)", numbers, a, "m/s2")
