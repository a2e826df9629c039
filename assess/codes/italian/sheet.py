"""Lines of the calculation sheets that the checks of both editions share: multiplier, a0*, d0* and a(d)."""

from __future__ import annotations

from dataclasses import replace

from scipy.constants import g

from assess.codes.calculation_step import Given
from assess.codes.check import Step, step
from assess.codes.italian.confidence import confidence_step
from assess.codes.italian.edition import Edition
from assess.codes.italian.kinematic import BEFORE, acceleration_at, activation, displacement_at, rotation_at
from assess.codes.italian.limit_state import Case
from assess.codes.multiplier_step import multiplier_step
from assess.codes.table_steps import (
    excitation_column,
    instability_step,
    integral_step,
    moment_column,
    reading_step,
)
from assess.oscillator import Branch, linear_multiplier, participation_ratio


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
        multiplier_step("α0", "multiplier that starts the mechanism", edition.multiplier, branch),
        step("e*", "fraction of participating mass", edition.oscillator, moved, e, given=shares),
        confidence_step(case.confidence, edition),
        step("a0*", "acceleration of activation", edition.oscillator, "α0 · g / (e* · FC)", a0, "m/s2", given=given),
    )


def collapse_steps(branch: Branch, clause: str, *, mass: float) -> tuple[Step, ...]:
    """Write phi_ov, the integral of B up to there, and d0*."""
    falls = "rotation where the restoring moment falls to zero, with only actions shown to last"
    words, end = "displacement where a* = 0, with only actions shown to last", branch.unstable
    return (
        instability_step("φ_ov", falls, clause, branch),
        *displacement_steps("d0*", words, clause, branch, mass=mass, rotation=end, upper="φ_ov"),
    )


def displacement_steps(
    symbol: str,
    words: str,
    clause: str,
    branch: Branch,
    *,
    mass: float,
    rotation: float,
    upper: str = "φ",
    subject: str = "",
) -> tuple[Step, ...]:
    """Write the spectral displacement d* at a rotation, with the integral of B up to there.

    Parameters
    ----------
    symbol, words, clause : of d*
    branch : the direction of rocking
    mass : total moved mass [kg]
    rotation : [rad], written `upper`
    subject : the load that ends there
    """
    e, moved = participation_ratio(branch, mass=mass), displacement_at(branch, rotation, mass=mass)
    integral = moved * e * mass
    given: Given = {"∫ B dφ": (integral, "kg m"), "M": (mass, "kg"), "e*": e}
    along = integral_step(
        "∫ B dφ", "excitation over rotation", clause, excitation_column(branch), rotation, "kg m", upper=upper
    )
    return (
        replace(along, value=integral, subject=subject),
        step(symbol, words, clause, "∫ B dφ / (M · e*)", moved, "m", given=given, subject=subject),
    )


def curve_steps(case: Case, clause: str, symbol: str, words: str, *, moved: float, argument: str) -> tuple[Step, ...]:
    """Write a* at the displacement d* = `moved` [m], named `argument`, with phi and lambda where the curve is read."""
    branch, mass, FC = case.curves.breaking, case.curves.mass, case.confidence.factor
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass)
    a = acceleration_at(branch, moved, mass=mass, confidence_factor=FC)
    phi, lam = f"φ({argument})", a * e * FC / g
    at: Given = {argument: (moved, "m"), "M": (mass, "kg"), "e*": e}
    before = rotation * (1.0 - BEFORE)
    moment = reading_step("R", "restoring moment there", clause, moment_column(branch), before, argument=phi)
    shaken = reading_step("B", "excitation there", clause, excitation_column(branch), before, argument=phi)
    ratio: Given = {"R": (moment.value or 0.0, "N m"), "B": (shaken.value or 0.0, "kg m")}
    given = {"λ": lam, "e*": e, "FC": FC}
    return (
        step(phi, "rotation at which d* is reached", clause, "∫ B dφ = d* M e*", rotation, "rad", at=at),
        moment,
        shaken,
        step("λ", "multiplier there", clause, "R / (g · B)", lam, given=ratio),
        step(symbol, words, clause, "λ · g / (e* · FC)", a, "m/s2", given=given),
    )
