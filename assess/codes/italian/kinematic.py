"""The equivalent oscillator of kinematic analysis, the same in both circulars: a* = alpha g / (e* FC) over d*.

alpha(d) is the curve of lambda = restoring / (g B) of the mechanism; displacements are those of the control point over
e*. Source: Circolare 617/2009, C8A.4.1-2; 7/2019, C8.7.1.1-C8.7.1.5.
"""

from __future__ import annotations

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

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
    integral = excitation_integral(branch)
    return float(brentq(lambda phi: float(integral(phi)) / mass - moved, 0.0, branch.unstable, xtol=1e-15))


def multiplier_at(branch: Branch, rotation: float) -> float:
    """lambda [-] of the model's own curve at a rotation [rad]."""
    return float(restoring_spline(branch)(rotation)) / float(excitation_spline(branch)(rotation)) / g


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
