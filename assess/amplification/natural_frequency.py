"""The first natural frequency of a free-standing structure by Rayleigh's method on horizontal slices.

The structure is a cantilever of slices. Its own weight, applied sideways, bends and shears it; the deflected shape
approximates the first mode (Lord Rayleigh's principle, as in thesis 4.3.3):

    omega^2 = g sum m u / sum m u^2,   h_e = sum m u z / sum m u

Of a uniform cantilever in bending this is 3.530 sqrt(EI / (m L^4)), 0.4 % above the exact 3.516.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from scipy.constants import g

from assess.errors import GeometryError
from assess.geometry.section_moments import section_moments
from assess.geometry.solid import Solid
from spectra.arrays import FloatArray

SLICES = 100
SHEAR_MODULUS = 0.4  # of E: EN 1996-1-1:2005, 3.7.3
SHEAR_AREA = 5.0 / 6.0  # of the section: a rectangle's
ASSUMPTIONS = (
    "a cantilever clamped at its foot and free above, uncracked, on stiff ground; bending and shear; "
    "G = 0.4 E, shear area 5/6 of the section; floors and what stands beside it left out"
)


@dataclass(frozen=True)
class Slices:
    """A cantilever in slices, from its foot up, each uniform over its height.

    height : of each slice [n] [m]
    mass : of each slice [n] [kg]
    bending : E I of the section [n] [N m2]
    shear : G A_s of the section [n] [N]; infinite where shear is left out
    """

    height: FloatArray
    mass: FloatArray
    bending: FloatArray
    shear: FloatArray


@dataclass(frozen=True)
class Rayleigh:
    """First natural frequency [Hz] and effective (modal) height above the foot [m]."""

    frequency: float
    effective_height: float


def slice_cantilever(solids: Sequence[Solid], young_modulus: Sequence[float], *, direction: Sequence[float]) -> Slices:
    """Cut bodies that stand as one into SLICES level slices.

    A section of several bodies is one section, each part with its own modulus.

    Parameters
    ----------
    solids : the bodies
    young_modulus : E of each body [Pa]
    direction : of bending, horizontal [3]

    Returns
    -------
    Slices
    """
    low = min(float(solid.vertices[:, 2].min()) for solid in solids)
    high = max(float(solid.vertices[:, 2].max()) for solid in solids)
    h = (high - low) / SLICES
    z = low + h * (np.arange(SLICES) + 0.5)
    mass, stiff = np.zeros(SLICES), np.zeros((SLICES, 3))
    for solid, E in zip(solids, young_modulus, strict=True):
        moments = section_moments(solid, z, direction=direction)
        mass += solid.mass * moments[:, 0] / np.sum(moments[:, 0])
        stiff += E * moments
    EA, ES, EI = stiff.T
    bending = EI - ES**2 / np.where(EA > 0.0, EA, 1.0)
    return Slices(np.full(SLICES, h), mass, bending, SHEAR_MODULUS * SHEAR_AREA * EA)


def rayleigh_mode(slices: Slices, *, top_mass: float = 0.0) -> Rayleigh:
    """Return frequency and effective height of the first mode by Rayleigh's quotient.

    Parameters
    ----------
    slices : the structure
    top_mass : a point mass on top [kg]

    Returns
    -------
    Rayleigh

    Raises
    ------
    GeometryError
        Where a slice has no mass or no stiffness, so that nothing carries the slices above.
    """
    for name, values in (("mass", slices.mass), ("bending stiffness", slices.bending)):
        empty = np.flatnonzero(~(values > 0.0))
        if empty.size:
            at = float(np.sum(slices.height[: empty[0]]))
            raise GeometryError(f"natural frequency: no {name} at {at:.3g} m above the foot; give natural_frequency")
    z = np.append(np.cumsum(slices.height) - slices.height / 2.0, np.sum(slices.height))
    m = np.append(slices.mass, top_mass)
    u = deflection(slices, top_mass=top_mass)
    frequency = sqrt(g * float(m @ u) / float(m @ u**2)) / (2.0 * pi)
    return Rayleigh(frequency, float(m @ (u * z)) / float(m @ u))


def deflection(slices: Slices, *, top_mass: float = 0.0) -> FloatArray:
    """Return the sideways deflection under the own weight, at the middle of each slice and at the top [n + 1] [m]."""
    h, w = slices.height, g * slices.mass / slices.height
    V = g * top_mass + np.append(np.cumsum((w * h)[::-1])[::-1], 0.0)  # at the joints [n + 1]
    M = np.append(np.cumsum((h * (V[1:] + w * h / 2.0))[::-1])[::-1], 0.0)
    turn, shift = np.zeros(h.size + 1), np.zeros(h.size + 1)  # at the joints, from the foot up
    middle = np.empty(h.size)
    for i in range(h.size):
        middle[i] = shift[i] + _gained(slices, i, h[i] / 2.0, turn[i], V[i], M[i], w[i])[1]
        turned, gained = _gained(slices, i, h[i], turn[i], V[i], M[i], w[i])
        turn[i + 1], shift[i + 1] = turned, shift[i] + gained
    return np.append(middle, shift[-1])


def _gained(slices: Slices, i: int, s: float, turn: float, V: float, M: float, w: float) -> tuple[float, float]:
    """Return the rotation at `s` above the foot of slice i, and the deflection gained up to there.

    V, M act at its foot, w along it. The moment at s is M - V s + w s^2 / 2, exact for a uniform slice.
    """
    EI, GA = slices.bending[i], slices.shear[i]
    rotation = turn + (M * s - V * s**2 / 2.0 + w * s**3 / 6.0) / EI
    bent = turn * s + (M * s**2 / 2.0 - V * s**3 / 6.0 + w * s**4 / 24.0) / EI
    return rotation, bent + (V * s - w * s**2 / 2.0) / GA
