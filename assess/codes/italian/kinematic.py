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
    linear_multiplier,
    participation_ratio,
    threshold,
)

BEFORE = 1e-9
"""Of a rotation at which an action ends: just before it, where the curve has a jump."""


def activation(branch: Branch, *, mass: float, confidence_factor: float) -> float:
    """Return the acceleration of activation a0* = alpha0 g / (e* FC) (C8.7.1.3).

    Parameters
    ----------
    branch : with every action at rest
    mass : total moved mass [kg]
    confidence_factor : FC [-]

    Returns
    -------
    float [m/s2]
    """
    return linear_multiplier(branch) * g / (participation_ratio(branch, mass=mass) * confidence_factor)


def displacement_at_collapse(branch: Branch, *, mass: float) -> float:
    """Return d0* [m], where the multiplier of the model's own curve falls to zero."""
    return displacement_at(branch, branch.unstable, mass=mass)


def displacement_at(branch: Branch, rotation: float, *, mass: float) -> float:
    """Return the spectral displacement d* at a rotation (C8.7.1.4).

    Parameters
    ----------
    branch : the direction of rocking
    rotation : phi [rad]
    mass : total moved mass [kg]

    Returns
    -------
    float [m]
    """
    moved = float(displacement(branch, np.array(rotation), mass=mass))
    return moved / participation_ratio(branch, mass=mass)


def rotation_at(branch: Branch, moved: float, *, mass: float) -> float:
    """Return the rotation at which the control point has moved by a displacement, up to the overturning rotation.

    Parameters
    ----------
    branch : the direction of rocking
    moved : displacement of the control point, e* d* [m]
    mass : total moved mass [kg]

    Returns
    -------
    float [rad]
    """
    integral = branch.excitation_integral
    return float(brentq(lambda phi: float(integral(phi)) / mass - moved, 0.0, branch.unstable, xtol=1e-15))


def multiplier_at(branch: Branch, rotation: float) -> float:
    """Return lambda [-] of the model's own curve at a rotation [rad]."""
    return float(branch.restoring_spline(rotation)) / float(branch.excitation_spline(rotation)) / g


def acceleration_at(branch: Branch, moved: float, *, mass: float, confidence_factor: float) -> float:
    """Return a* at a displacement d*, on the model's own curve, just before an action that ends there (C8.7.1.3).

    Parameters
    ----------
    branch : with the actions that have not ended
    moved : d* [m]
    mass : total moved mass [kg]
    confidence_factor : FC [-]

    Returns
    -------
    float [m/s2]
    """
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass) * (1.0 - BEFORE)
    return multiplier_at(branch, rotation) * g / (e * confidence_factor)


def uplift_pga(branch: Branch, *, confidence_factor: float, amplified: float) -> float | None:
    """Return the PGA at uplift: lambda g / FC over the amplification of the ground by the floor.

    Parameters
    ----------
    branch : with every action at rest
    confidence_factor : FC [-]
    amplified : floor over ground [-]; counts from 1 on

    Returns
    -------
    float or None
        PGA [m/s2]; None on joints without a threshold of uplift.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / confidence_factor / max(1.0, amplified)
