"""Rocking parameters and capacity curves of a mechanism."""

from __future__ import annotations

from dataclasses import dataclass

from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class LinearisedResult(ShortRepr):
    """Kinematic constants of a branch linearised at critical_rad (thesis 3.4-3.12): I, K, B, M, phi_cr, phi_ov.

    uplift_multiplier: lambda of 3.11, to which thesis tables refer; the exact one is that of the oscillator.
    """

    inertia_kg_m2: float
    stiffness_n_m_per_rad: float
    excitation_kg_m: float
    moment_n_m: float
    critical_rad: float
    overturning_rad: float
    uplift_multiplier: float


@dataclass(frozen=True, repr=False)
class OscillatorResult(ShortRepr):
    """The rocking parameters of one branch."""

    mass_kg: float
    inertia_kg_m2: float
    radius_m: float
    slenderness_rad: float
    p_eq_per_s: float
    uplift_multiplier: float | None
    overturning_rad: float
    overturning_flexible_rad: float | None
    critical_rad: float
    equilibrium_rad: float
    elastic_frequency_hz: float | None
    restitution: float
    linearised: LinearisedResult


@dataclass(frozen=True, repr=False)
class BranchCurve(ShortRepr):
    """The capacity curve of one branch, all positive."""

    rotation_rad: Floats
    inertia_kg_m2: Floats
    restoring_n_m: Floats
    excitation_kg_m: Floats
    participating_mass_kg: Floats
    displacement_m: Floats


@dataclass(frozen=True, repr=False)
class Curve(ShortRepr):
    """Both branches of the capacity curve."""

    positive: BranchCurve
    negative: BranchCurve | None
