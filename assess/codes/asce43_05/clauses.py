"""ASCE/SEI 43-05, Appendix A.2: rocking of an unanchored rigid body by an equivalent linear oscillator.

The formulas are written for any rocking oscillator: E(phi) is the work stored, B0 and I0 are excitation and inertia at
rest. For a block of half-width b and centroid height h, a = b/h, these give the clause's own quantities: h = B0/M,
C1 = I0/(M h^2), f1 = E/(M g h) = cos(theta) + a sin(theta) - 1.

Not checked against the printed standard: the equations were seen in excerpts and re-derived from energy. The clause's
limit of rotation (7.1) could not be read: one third of the rotation that overturns is allowed, and one half, the limit
of the response-history method of the same standard, is shown beside it. One function for each formula.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g
from scipy.optimize import brentq

from assess.codes.pga_rotation import PgaOf, PgaRotation, floor_pga_rotation, pga_rotation
from assess.oscillator import Branch, SingleBlock, block_at, energy
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

EDITION = "ASCE/SEI 43-05"
HALF = 0.5  # of the rotation that overturns: allowed to the mean of the maxima of response histories
THIRD = 1.0 / 3.0  # of the same: allowed by A.2
CAVEAT = "Appendix A.2 was not checked against the printed standard: its equations were re-derived from energy"


@dataclass(frozen=True)
class Options:
    """Options of ASCE 43-05.

    allowable_sliding : of a rigid body on its base [m]; None: sliding is given for information
    """

    allowable_sliding: float | None = None


def vertical_factor(a: float, ratio: float) -> float:
    """Return F_V = sqrt(1 + (a S_aV/S_aH)^2), the probabilistic combination with vertical motion (Eq. A-5(b)).

    Parameters
    ----------
    a : multiplier at uplift, tan(alpha) of a block [-]
    ratio : S_aV / S_aH [-]

    Returns
    -------
    float
        F_V, at least 1 [-].
    """
    return float(np.hypot(1.0, a * ratio))


def stored_work(branch: Branch, rotation: FloatArray) -> FloatArray:
    """Return f1(theta) = E(theta) / (g B0); cos(theta) + a sin(theta) - 1 of a block (Eq. A-5(a)).

    Parameters
    ----------
    branch : the direction of rocking
    rotation : theta [n] [rad]

    Returns
    -------
    array [n] [-]
    """
    return energy(branch, rotation) / float(g * branch.excitation[0])


def capacity_acceleration(branch: Branch, rotation: FloatArray, *, f_v: float) -> FloatArray:
    """Return SA_H,CAP = 2 g f1 / (F_V F_H theta) (Eq. A-5); F_H = 1, because B0 counts every mass that shakes.

    Parameters
    ----------
    branch : the direction of rocking
    rotation : theta > 0 [n] [rad]
    f_v : factor of vertical motion [-]

    Returns
    -------
    array [n] [m/s2]
    """
    return 2 * g * stored_work(branch, rotation) / (f_v * rotation)


def effective_frequency(branch: Branch, rotation: FloatArray) -> FloatArray:
    """Return f_e of the linear oscillator that stores the same work: omega_e^2 = 2 E / (I0 theta^2) (A.2, step 2).

    Parameters
    ----------
    branch : the direction of rocking
    rotation : theta > 0 [n] [rad]

    Returns
    -------
    array [n] [Hz]
    """
    omega = np.sqrt(2 * energy(branch, rotation) / float(branch.inertia[0])) / rotation
    return np.asarray(omega / (2 * np.pi))


def effective_damping(restitution: float) -> float:
    """Return beta_e = gamma / sqrt(4 pi^2 + gamma^2), gamma = -2 ln C_R, of two impacts in a cycle (A.2, step 2).

    An impact onto a nearer hinge may leave more velocity, though never more energy: C_R >= 1 then gives no damping.

    Parameters
    ----------
    restitution : C_R, velocity after over velocity before an impact [-]

    Returns
    -------
    float
        beta_e, 1 without rebound [-].
    """
    if restitution == 0.0:
        return 1.0
    gamma = -2 * np.log(min(restitution, 1.0))
    return float(gamma / np.hypot(2 * np.pi, gamma))


def thesis_limit_ratio(block: SingleBlock) -> float:
    """Return theta_lim / alpha = k alpha / sin(2 alpha) [-], the limit of rotation in the thesis (8.3.2).

    Empirical: no derivation is known; it fits the thesis' Table 8.5 within rounding for all eight walls.
    """
    return float(inertia_ratio(block) * block.slenderness / np.sin(2 * block.slenderness))


def inertia_ratio(block: SingleBlock) -> float:
    """Return k = I_O / (M R^2) = g / (p^2 R) [-]."""
    return block.inertia / (block.mass * block.radius**2)


def thesis_limit(branch: Branch, *, mass: float) -> float:
    """Return the limit of rotation theta_lim on a flexible joint.

    It is where theta equals the ratio of `thesis_limit_ratio` times alpha, both of the equivalent block at theta.

    Parameters
    ----------
    branch : the direction of rocking
    mass : total moved mass [kg]

    Returns
    -------
    float
        theta_lim [rad]; the overturning rotation where no such theta exists, because the formula is out of its range.
    """

    def excess(rotation: float) -> float:
        block = block_at(branch, rotation, mass=mass)
        return rotation - thesis_limit_ratio(block) * block.slenderness

    low, high = 1e-3 * branch.unstable, branch.unstable
    return float(brentq(excess, low, high, xtol=1e-12)) if excess(low) < 0.0 < excess(high) else high


def spectral_pga_rotation(
    branch: Branch, spectrum: Spectrum, *, damping: float, f_v: float, uplift: float
) -> PgaRotation:
    """Return PGA(theta), at which SA_H,CAP equals the spectrum's ordinate at f_e, the spectrum scaled with its PGA.

    Parameters
    ----------
    branch : the direction of rocking
    spectrum : of the ground
    damping : of the demand [-]
    f_v : factor of vertical motion [-]
    uplift : PGA below which nothing rocks [m/s2]

    Returns
    -------
    PgaRotation
    """
    return pga_rotation(
        _pga_of(branch, spectrum, damping=damping, f_v=f_v, pga=spectrum.pga),
        overturning=branch.unstable,
        uplift=uplift,
        period_of=_period_of(branch),
        longest_period=spectrum.longest_period,
    )


def floor_spectral_pga_rotation(
    branch: Branch, floor: Spectrum, *, damping: float, f_v: float, uplift: float, pga: float
) -> PgaRotation:
    """Return PGA(theta) of the ground where the demand is the spectrum of a floor.

    Parameters
    ----------
    branch : the direction of rocking
    floor : spectrum of the floor
    damping : of the demand [-]
    f_v : factor of vertical motion [-]
    uplift : peak acceleration of the floor below which nothing rocks [m/s2]
    pga : peak acceleration of the ground that belongs to `floor` [m/s2]

    Returns
    -------
    PgaRotation
    """
    return floor_pga_rotation(
        _pga_of(branch, floor, damping=damping, f_v=f_v, pga=pga),
        overturning=branch.unstable,
        uplift=uplift * pga / floor.pga,
        period_of=_period_of(branch),
        longest_period=floor.longest_period,
    )


def _period_of(branch: Branch) -> PgaOf:
    return lambda rotation: 1 / effective_frequency(branch, rotation)


def _pga_of(branch: Branch, spectrum: Spectrum, *, damping: float, f_v: float, pga: float) -> PgaOf:
    period_of = _period_of(branch)

    def pga_of(rotation: FloatArray) -> FloatArray:
        amplified = spectrum.acceleration(period_of(rotation), damping=damping) / pga
        return capacity_acceleration(branch, rotation, f_v=f_v) / amplified

    return pga_of
