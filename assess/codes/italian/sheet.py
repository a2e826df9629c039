"""Lines of the calculation sheets that the checks of both editions share: multiplier, a0*, d0* and a(d)."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.calculation_step import Given
from assess.codes.check import Step, step
from assess.codes.italian.confidence import confidence_step
from assess.codes.italian.edition import Edition
from assess.codes.italian.kinematic import acceleration_at, activation, displacement_at_collapse, rotation_at
from assess.codes.italian.limit_state import Case
from assess.oscillator import Branch, linear_multiplier, multiplier, participation_ratio


def activation_steps(case: Case, edition: Edition) -> tuple[Step, ...]:
    """Write the PGA, alpha0, e*, FC and a0*."""
    branch, mass, FC = case.curves.starting, case.curves.mass, case.confidence.factor
    e, moved = participation_ratio(branch, mass=mass), "(Σ m δx)² / (M · Σ m δx²)"
    shares: Given = {
        "Σ m δx": (float(branch.excitation[0]), "kg m"),
        "M": (mass, "kg"),
        "Σ m δx²": (float(branch.participation[0]), "kg m2"),
    }
    a0, given = (
        activation(branch, mass=mass, confidence_factor=FC),
        {"α0": linear_multiplier(branch), "e*": e, "FC": FC},
    )
    return (
        case.pga_step,
        _multiplier_step(branch, edition.multiplier),
        step("e*", "fraction of participating mass", edition.oscillator, moved, e, given=shares),
        confidence_step(case.confidence, edition),
        step("a0*", "acceleration of activation", edition.oscillator, "α0 · g / (e* · FC)", a0, "m/s2", given=given),
    )


def _multiplier_step(branch: Branch, clause: str) -> Step:
    """Write alpha0: at rest, or on joints the largest of the curve."""
    alpha0, words = linear_multiplier(branch), "multiplier that starts the mechanism"
    if alpha0 > float(multiplier(branch)[0]):
        return step("α0", words, clause, "largest λ of the curve", alpha0, remark="joints that give way")
    given: Given = {"R0": (float(branch.restoring[0]), "N m"), "B0": (float(branch.excitation[0]), "kg m")}
    return step("α0", f"{words}; R0 = V'(0) − M", clause, "R0 / (g · B0)", alpha0, given=given)


def collapse_step(branch: Branch, clause: str, *, mass: float) -> Step:
    """Write d0*."""
    e, collapse = participation_ratio(branch, mass=mass), displacement_at_collapse(branch, mass=mass)
    words = (
        f"displacement where a* = 0, with only actions shown to last; B integrated to φ_ov = {branch.unstable:.5g} rad"
    )
    given: Given = {"∫ B dφ": (collapse * e * mass, "kg m"), "M": (mass, "kg"), "e*": e}
    return step("d0*", words, clause, "∫ B dφ / (M · e*)", collapse, "m", given=given)


def curve_step(case: Case, clause: str, symbol: str, words: str, *, moved: float) -> Step:
    """Write a* at the displacement d* = `moved` [m], with lambda, and where on the curve it is read."""
    branch, mass, FC = case.curves.breaking, case.curves.mass, case.confidence.factor
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass)
    a = acceleration_at(branch, moved, mass=mass, confidence_factor=FC)
    said = f"{words}: λ at d* = {moved:.5g} m, φ = {rotation:.5g} rad"
    given = {"λ": a * e * FC / g, "e*": e, "FC": FC}
    return step(symbol, said, clause, "λ · g / (e* · FC)", a, "m/s2", given=given)
