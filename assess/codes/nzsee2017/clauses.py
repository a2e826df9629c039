"""NZSEE/MBIE Guidelines 2017, C8.8.5 and Appendix C8B: a cracked wall loaded on its face, by displacement.

The Guidelines write the equation of motion of the leading block, J phi'' + b - a phi = ..., with displacements at
mid-height; here it is that of the oscillator, in rotations, for any mechanism of walls:

    b, a    the straight line of the restoring moment: at rest, and its slope down to phi_i, where it is zero
    phi_m = usable phi_i                               the largest usable rotation
    T_p = 4.07 sqrt(J / a)                             J = I at rest; four times the way back from 0.6 phi_m
    phi_D = (B / J) (T_p / 2 pi)^2 C_p(T_p) g R_p      gamma = B h / (2 J) of the Guidelines is that of mid-height
    %NBS = 100 phi_m / phi_D

The factor of T_p is 4 arcosh(1 / (1 - r)), r the rotation let go over phi_i: r = 0.6 x 0.6 gives 4.07. The period that
the Guidelines print for walls that stand free, sqrt(0.65 h (1 + (t/h)^2)), is 3.10 sqrt(J / a), which is r = 0.8 x 0.3:
so it belongs to a usable 0.3. Formulas are from memory and re-derived; numbers of clauses are unsure. One function for
each.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.codes.context import Context, Support
from assess.oscillator import Branch, energy, threshold
from spectra.floor import NZS_LOW, nzs1170_5
from spectra.floor_spectrum import part_shape

EDITION = "NZSEE/MBIE Guidelines 2017, C8"
CAVEAT = (
    "formulas from memory, re-derived, not checked against the printed Guidelines; numbers of clauses unsure; C8's "
    "reduced thickness is not applied: give the joints a strength, or the wall less thickness"
)
CAVEAT_FREE = (
    "; the usable 0.3 of walls that stand free is unsure (0.6 in 2006); whether this is a wall, the engineer must judge"
)

USABLE: dict[Support, float] = {"spanning": 0.6, "free": 0.3}  # phi_m / phi_i
LET_GO: dict[Support, float] = {"spanning": 0.6, "free": 0.8}  # rotation from which T_p is counted, over phi_m
LARGEST_FLOOR_FACTOR = 3.0  # C_Hi, NZS 1170.5, 8.3


@dataclass(frozen=True)
class Options:
    """usable: phi_m / phi_i [-], None for 0.6 (spanning) and 0.3 (free); risk_factor: R_p, NZS 1170.5 Table 8.1 [-]."""

    usable: float | None = None
    risk_factor: float = 1.0


@dataclass(frozen=True)
class Line:
    """The restoring moment as a straight line: b at rest [N m], slope a [N m/rad], b = a phi_i."""

    b: float
    a: float

    @property
    def instability(self) -> float:
        """phi_i [rad]."""
        return self.b / self.a


def straight_line(branch: Branch) -> Line:
    """The line from the restoring moment at rest to phi_i.

    On joints that give way, the moment at rest is none: there the line has the same work up to phi_i as the curve.
    """
    phi_i = branch.unstable
    if branch.overturning_flexible is None:
        b = float(branch.restoring[0])
    else:
        b = 2.0 * float(energy(branch, np.array(phi_i))) / phi_i
    return Line(b, b / phi_i)


def period_factor(support: Support) -> float:
    """4 arcosh(1 / (1 - r)) [-]: 4.07 for a wall that spans, 3.10 for one that stands free."""
    r = USABLE[support] * LET_GO[support]
    return float(4.0 * np.arccosh(1.0 / (1.0 - r)))


def period(branch: Branch, line: Line, *, support: Support) -> float:
    """T_p = factor sqrt(J / a) [s]."""
    return period_factor(support) * float(np.sqrt(branch.inertia[0] / line.a))


def floor_factor(context: Context) -> float:
    """C_Hi [-] at the height of the supports (NZS 1170.5, 8.3); without a building the largest that height can have.

    Raises SpectrumError for supports above the building.
    """
    height = context.support_height
    if height <= 0.0:
        return 1.0
    if context.building is not None:
        return nzs1170_5(height, building_height=context.building.height)
    return min(1.0 + height / 6.0, LARGEST_FLOOR_FACTOR) if height < NZS_LOW else LARGEST_FLOOR_FACTOR


def part_coefficient(Tp: float, *, floor: float) -> float:
    """C_p(T_p) / C(0) = C_Hi C_i(T_p) [-] (NZS 1170.5, 8.2)."""
    return floor * float(part_shape(Tp))


def demand_per_pga(branch: Branch, Tp: float, *, floor: float, risk_factor: float) -> float:
    """phi_D over C(0) g [rad s2/m]: (B / J) (T_p / 2 pi)^2 C_Hi C_i(T_p) R_p."""
    participation = float(branch.excitation[0] / branch.inertia[0])
    return participation * (Tp / (2.0 * np.pi)) ** 2 * part_coefficient(Tp, floor=floor) * risk_factor


def uplift_pga(branch: Branch, *, floor: float, risk_factor: float) -> float | None:
    """PGA [m/s2] at which the part coefficient of a rigid body, C_p(0) R_p, reaches the multiplier at rest.

    C_i(0) = 2 stands for parts stiffer than 0.75 s, so this is half of what lifts a rigid wall off a rigid floor. None
    on joints without a threshold.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / (part_coefficient(0.0, floor=floor) * risk_factor)
