"""Rocking parameters and capacity curves of oscillators as results."""

from __future__ import annotations

from dataclasses import replace

from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.table import branch
from assess.oscillator import (
    Branch,
    Linearised,
    Oscillator,
    displacement,
    elastic_frequency,
    equivalent_block,
    participating_mass,
    threshold,
)
from assess.results import BranchCurve, Curve, LinearisedResult, OscillatorResult
from spectra.arrays import FloatArray


def floats(values: FloatArray) -> tuple[float, ...]:
    """Return an array as plain numbers."""
    return tuple(values.tolist())


def oscillator_result(branch: Branch, *, mass: float, rigid: Branch, equilibrium: float) -> OscillatorResult:
    """Return the rocking parameters of one branch.

    Parameters
    ----------
    branch : Branch
        The branch.
    mass : float
        Total mass [kg].
    rigid : Branch
        The branch with rigid interfaces.
    equilibrium : float
        Rotation at rest phi_e, in the sign of the branch [rad].

    Returns
    -------
    OscillatorResult
        The parameters, some of the equivalent block of the rigid branch.
    """
    block, linear = equivalent_block(rigid, mass=mass), branch.linearised
    return OscillatorResult(
        mass_kg=mass,
        inertia_kg_m2=block.inertia,
        radius_m=block.radius,
        slenderness_rad=block.slenderness,
        p_eq_per_s=linear.p,
        uplift_multiplier=threshold(branch),
        overturning_rad=branch.overturning,
        overturning_flexible_rad=branch.overturning_flexible,
        critical_rad=branch.critical,
        equilibrium_rad=equilibrium + 0.0,
        elastic_frequency_hz=elastic_frequency(branch),
        restitution=branch.restitution,
        linearised=linearised_result(linear),
    )


def linearised_result(linear: Linearised) -> LinearisedResult:
    """Return the kinematic constants of the linearised branch."""
    rounding = 1e-9 * linear.stiffness * linear.critical  # of the table at phi_cr, where without forces M = 0
    return LinearisedResult(
        inertia_kg_m2=linear.inertia,
        stiffness_n_m_per_rad=linear.stiffness,
        excitation_kg_m=linear.excitation,
        moment_n_m=0.0 if abs(linear.moment) <= rounding else linear.moment,
        critical_rad=linear.critical,
        overturning_rad=linear.overturning,
        uplift_multiplier=linear.multiplier,
    )


def branch_curve(branch: Branch, *, mass: float) -> BranchCurve:
    """Return the capacity curve of one branch."""
    return BranchCurve(
        rotation_rad=floats(branch.rotation),
        inertia_kg_m2=floats(branch.inertia),
        restoring_n_m=floats(branch.restoring),
        excitation_kg_m=floats(branch.excitation),
        participating_mass_kg=floats(participating_mass(branch)),
        displacement_m=floats(displacement(branch, branch.rotation, mass=mass)),
    )


def curve_of(oscillator: Oscillator) -> Curve:
    """Return the capacity curves of both branches."""
    positive, negative, mass = oscillator.positive, oscillator.negative, oscillator.mass
    return Curve(branch_curve(positive, mass=mass), None if negative is None else branch_curve(negative, mass=mass))


def overturning_rotations(oscillator: Oscillator) -> tuple[float, float | None]:
    """Return the overturning rotations of both branches with rigid joints [rad]."""
    return oscillator.positive.overturning, None if oscillator.negative is None else oscillator.negative.overturning


def rigid_branches(mechanism: Mechanism, oscillator: Oscillator) -> tuple[Branch, ...]:
    """Return the branches of the mechanism with rigid interfaces."""
    if not mechanism.flexible:
        return oscillator.branches
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    return tuple(branch(replace(chain, joints=()), restitution=1.0, name=mechanism.name) for chain in chains)
