"""Italian procedure of DM 14.01.2008 with Circolare 617/2009: kinematic analysis of local mechanisms (C8A.4).

Clause and equation numbers of C8A.4 are from memory, not checked against the printed circular; formulas were
re-derived. Linear: acceleration that starts the mechanism against the demand over q. Non-linear: ultimate
displacement d_u* = 0.4 d_0* against the spectral displacement at the secant period T_s; a mechanism above ground
must also pass the check on the floor's motion. One function for each formula.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.check import Step, Verdict
from assess.codes.context import ON_GROUND, Context
from assess.codes.worked import multiplier_worked
from assess.oscillator import Branch, displacement, interpolant, participation_ratio, resisted, threshold
from spectra.floor_spectrum import first_mode_factor

EDITION = "DM 14.01.2008, Circolare 617/2009"
CAVEAT = "clause numbers of C8A.4 not checked against the printed circular"
ULTIMATE = 0.4  # d_u* / d_0*, and d_s* / d_u* (C8A.4.2.2)
DAMPING = 0.05  # of every ordinate: the clauses know no other


@dataclass(frozen=True)
class Options:
    """confidence_factor FC [-] of the knowledge level (LC1 1.35, LC2 1.20, LC3 1.00); behaviour factor q [-];
    limit_states of the linear check, each at the PGA of the level."""

    confidence_factor: float = 1.0
    limit_states: tuple[str, ...] = ("SLV",)
    behaviour_factor: float = 2.0


@dataclass(frozen=True)
class Capacity:
    """The equivalent oscillator of one branch (C8A.4.2.2), all starred quantities: e* [-], a [m/s2], d [m], T [s]."""

    e: float
    a0: float
    d0: float
    du: float
    ds: float
    as_: float
    Ts: float


@dataclass(frozen=True)
class Floor:
    """What the clause needs of the building: psi = Z/H, gamma = 3N/(2N+1), T1 [s]."""

    psi: float
    gamma: float
    T1: float


def activation(branch: Branch, *, mass: float, confidence_factor: float) -> float:
    """a0* = alpha0 g / (e* FC) [m/s2] (C8A.4.1.2)."""
    return resisted(branch) * g / (participation_ratio(branch, mass=mass) * confidence_factor)


def capacity_of(branch: Branch, *, mass: float, confidence_factor: float) -> Capacity:
    """e*, a0*, d0*, du* = 0.4 d0*, ds* = 0.4 du*, as* on the model's own curve, Ts = 2 pi sqrt(ds*/as*) (C8A.4.2.2)."""
    e = participation_ratio(branch, mass=mass)
    d0 = float(displacement(branch, np.array(branch.unstable), mass=mass)) / e
    ds = ULTIMATE * ULTIMATE * d0
    rotation = rotation_at(branch, ds * e, mass=mass)
    as_ = float(_multiplier_at(branch, rotation)) * g / (e * confidence_factor)
    a0 = activation(branch, mass=mass, confidence_factor=confidence_factor)
    return Capacity(e, a0, d0, ULTIMATE * d0, ds, as_, float(2 * np.pi * np.sqrt(ds / as_)))


def rotation_at(branch: Branch, moved: float, *, mass: float) -> float:
    """Rotation [rad] at which the control point has moved by `moved` [m], up to the overturning rotation."""
    integral = interpolant(branch.rotation, branch.excitation).antiderivative()
    return float(brentq(lambda phi: float(integral(phi)) / mass - moved, 0.0, branch.unstable, xtol=1e-15))


def _multiplier_at(branch: Branch, rotation: float) -> float:
    moment = interpolant(branch.rotation, branch.restoring)
    excitation = interpolant(branch.rotation, branch.excitation)
    return float(moment(rotation)) / (g * float(excitation(rotation)))


def floor_of(context: Context) -> Floor | None:
    """psi, gamma, T1 of a mechanism above ground (C8A.4.2.3); None at the ground, or where the building is unknown."""
    building = context.building
    if context.elevation <= ON_GROUND or building is None or building.storeys is None:
        return None
    gamma = first_mode_factor(building.storeys)
    return Floor(psi=context.elevation / building.height, gamma=gamma, T1=building.period)


def unanswerable(context: Context) -> str:
    """Why the clause cannot pass the mechanism ("" when it can): above ground it also asks for the floor's motion."""
    floor = floor_of(context)
    if context.elevation <= ON_GROUND or (floor is not None and floor.psi <= 1.0):
        return ""
    stands = f"the mechanism stands {context.elevation:.4g} m above ground"
    if floor is not None:
        return f"{stands}, higher than the building: check [building] height and ground_elevation"
    return (
        f"{stands}, where the clause also asks for the floor's motion: give [building] height and storeys, and "
        "ground_elevation where the ground is not at 0; the figures here are for the ground's motion alone"
    )


def judged(ratio: float, context: Context, *, passed: str, failed: str) -> tuple[Verdict, str]:
    """Verdict and reason of a ratio of demand to capacity: the ground alone can fail a mechanism, not pass it."""
    missing = unanswerable(context)
    if ratio > 1.0:
        return "fail", failed
    return ("not-applicable", missing) if missing else ("pass", passed)


def ground_displacement(context: Context, Ts: float) -> float:
    """S_De(Ts) [m] at the site's own PGA: S_e(Ts) (Ts / 2 pi)^2, or what the code itself gives for long periods."""
    return float(context.spectrum.displacement(Ts, damping=DAMPING))


def floor_displacement(context: Context, floor: Floor, Ts: float) -> float:
    """S_De(T1) psi gamma (Ts/T1)^2 / sqrt((1 - Ts/T1)^2 + 0.02 Ts/T1) [m] at the site's own PGA (C8A.4.2.3)."""
    r = Ts / floor.T1
    at_first_mode = ground_displacement(context, floor.T1) * floor.psi * floor.gamma
    return float(at_first_mode * r**2 / np.sqrt((1 - r) ** 2 + 0.02 * r))


def floor_acceleration(context: Context, floor: Floor) -> float:
    """S_e(T1) psi gamma [m/s2] at the site's own PGA (C8A.4.2.3)."""
    return float(context.spectrum.acceleration(floor.T1, damping=DAMPING)) * floor.psi * floor.gamma


def uplift_pga(branch: Branch, context: Context, *, confidence_factor: float) -> float | None:
    """PGA [m/s2] that lifts the mechanism off: lambda g / FC, less where the floor amplifies the ground.

    None on joints without a threshold of uplift.
    """
    at_rest = threshold(branch)
    if at_rest is None:
        return None
    floor = floor_of(context)
    amplified = 1.0 if floor is None else max(1.0, floor_acceleration(context, floor) / context.spectrum.pga)
    return at_rest * g / confidence_factor / amplified


def activation_steps(branch: Branch, *, mass: float, confidence_factor: float) -> tuple[Step, ...]:
    """alpha0, e*, FC and a0* as the calculation sheets print them."""
    formula, start, alpha0 = multiplier_worked(branch)
    e, B0, participation = participation_ratio(branch, mass=mass), branch.excitation[0], branch.participation[0]
    a0 = activation(branch, mass=mass, confidence_factor=confidence_factor)
    shares = f"{B0:.5g}² / ({participation:.5g} · {mass:.5g})"
    divided = f"{alpha0:.5g} · 9.80665 / ({e:.5g} · {confidence_factor:g})"
    return (
        Step("α0", "multiplier that starts the mechanism", "C8A.4.1", formula, start, alpha0, "-"),
        Step("e*", "fraction of participating mass", "C8A.4.1.2", "(Σ m δx)² / (M Σ m δx²)", shares, e, "-"),
        Step("FC", "confidence factor", "C8A.1.1", "given", f"{confidence_factor:g}", confidence_factor, "-"),
        Step("a0*", "acceleration of activation", "C8A.4.1.2", "α0 g / (e* FC)", divided, a0, "m/s2"),
    )
