"""NZSEE/MBIE Guidelines 2017, C8.8.5 and Appendix C8B: a cracked wall loaded on its face, by displacement.

The Guidelines write the equation of motion of the leading block, J phi'' + b - a phi = ..., with displacements at
mid-height; here it is that of the oscillator, in rotations, for any mechanism of walls:

    b, a    the straight line of the restoring moment: at rest, and its slope down to phi_i, where it is zero
    phi_m = usable phi_i                               the largest usable rotation
    T_p = 4.07 sqrt(J / a)                             J = I at rest; four times the way back from 0.6 phi_m
    phi_D = (B / J) (T_p / 2 pi)^2 C_p(T_p) g R_p      gamma = B h / (2 J) of the Guidelines is that of mid-height
    %NBS = 100 phi_m / phi_D

A wall that spans counts with its effective thickness, t_eff = k t, k = 0.975 - 0.025 P/W: the corners of its joints
are not sharp. The arms of b are shares of t, and the wall's weight W goes with t, while the load P stays; so

    b = k^2 b_W + k b_P        a = k a_W + a_P        J = k J_W + k^2 J_P        B = k B_W + B_P        phi_i = b / a

with W what is the wall's own and P what presses on it; moments of ties and of horizontal forces, whose arms are
heights, stay. (The wall's share of J is W h^2 / 12 g but for terms of (t/h)^2, that of P an arm in t squared.) Of the
uniform walls of C8B, case 0 has b_W = W t/2, b_P = P t, a_W = W h/2, a_P = P h: Delta_i = k t/2; T_p hardly moves.

The factor of T_p is 4 arcosh(1 / (1 - r)), r the rotation let go over phi_i: r = 0.6 x 0.6 gives 4.07. The period that
the Guidelines print for walls that stand free, sqrt(0.65 h (1 + (t/h)^2)), is 3.10 sqrt(J / a), which is r = 0.8 x 0.3:
so it belongs to a usable 0.3. Formulas are from memory and re-derived; numbers of clauses are unsure. One function for
each.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.codes.context import Context, Gravity, Support
from assess.oscillator import Branch, energy
from spectra.floor import NZS_LOW, nzs1170_5
from spectra.floor_spectrum import part_shape

EDITION = "NZSEE/MBIE Guidelines 2017, C8"
CAVEAT = "formulas from memory, re-derived, not checked against the printed Guidelines; numbers of clauses unsure"
CAVEAT_FREE = (
    "the usable 0.3 of walls that stand free is unsure (0.6 in 2006); whether this is a wall, the engineer must judge"
)

USABLE: dict[Support, float] = {"spanning": 0.6, "free": 0.3}  # phi_m / phi_i
THICKNESS = (0.975, 0.025)  # t_eff / t without overburden, and what each P/W takes off
LET_GO: dict[Support, float] = {"spanning": 0.6, "free": 0.8}  # rotation from which T_p is counted, over phi_m
LARGEST_FLOOR_FACTOR = 3.0  # C_Hi, NZS 1170.5, 8.3


@dataclass(frozen=True)
class Options:
    """Options of face-loaded walls.

    usable : phi_m / phi_i [-], None for 0.6 (spanning) and 0.3 (free); risk_factor : R_p, NZS 1170.5 Table 8.1 [-]
    c_0 : C(0) at the site's own PGA [g]; None where the spectrum is that of NZS 1170.5, which begins with it
    """

    usable: float | None = None
    risk_factor: float = 1.0
    c_0: float | None = None


@dataclass(frozen=True)
class Line:
    """The restoring moment as a straight line: b at rest [N m], slope a [N m/rad], b = a phi_i."""

    b: float
    a: float

    @property
    def instability(self) -> float:
        """phi_i [rad]."""
        return self.b / self.a


@dataclass(frozen=True)
class Part:
    """One branch as the clause sees it: its line, J [kg m2] and B [kg m] at rest."""

    line: Line
    J: float
    B: float


def thickness_factor(overburden_ratio: float) -> float:
    """Return k = t_eff / t = 0.975 - 0.025 P/W [-]; 0 from P = 39 W on, where no effective thickness is left."""
    whole, taken = THICKNESS
    return max(whole - taken * max(overburden_ratio, 0.0), 0.0)


def nominal(branch: Branch) -> Part:
    """Return the branch with its own thickness."""
    return Part(straight_line(branch), float(branch.inertia[0]), float(branch.excitation[0]))


def with_effective_thickness(part: Part, gravity: Gravity) -> Part:
    """Return the wall with its effective thickness, by the formulas at the top of this file.

    Parameters
    ----------
    part : the wall with its own thickness
    gravity : what its own weight and the overburden give to it

    Returns
    -------
    Part
    """
    k = thickness_factor(gravity.overburden_ratio)
    b = part.line.b - (1.0 - k**2) * gravity.own_moment - (1.0 - k) * gravity.moment
    a = part.line.a - (1.0 - k) * gravity.own_slope
    J = part.J - (1.0 - k) * gravity.own_inertia - (1.0 - k**2) * gravity.inertia
    return Part(Line(b, a), J, part.B - (1.0 - k) * gravity.own_excitation)


def straight_line(branch: Branch) -> Line:
    """Return the line from the restoring moment at rest down to phi_i.

    On flexible joints the moment at rest is zero: there the line does the same work up to phi_i as the curve.
    """
    phi_i = branch.unstable
    if branch.overturning_flexible is None:
        b = float(branch.restoring[0])
    else:
        b = 2.0 * float(energy(branch, np.array(phi_i))) / phi_i
    return Line(b, b / phi_i)


def period_factor(support: Support) -> float:
    """Return 4 arcosh(1 / (1 - r)) [-]: 4.07 for a wall that spans, 3.10 for one that stands free."""
    r = USABLE[support] * LET_GO[support]
    return float(4.0 * np.arccosh(1.0 / (1.0 - r)))


def period(part: Part, *, support: Support) -> float:
    """Return T_p = factor sqrt(J / a).

    Parameters
    ----------
    part : the wall
    support : how it is held

    Returns
    -------
    float [s]
    """
    return period_factor(support) * float(np.sqrt(part.J / part.line.a))


def floor_factor(context: Context) -> float:
    """Return C_Hi at the height of the supports [-] (NZS 1170.5, 8.3).

    Without a building it is the largest that this height can have; supports above the building count as at its top.
    """
    height = context.support_height
    if height <= 0.0:
        return 1.0
    if context.building is not None:
        return nzs1170_5(min(height, context.building.height), building_height=context.building.height)
    return min(1.0 + height / 6.0, LARGEST_FLOOR_FACTOR) if height < NZS_LOW else LARGEST_FLOOR_FACTOR


def part_coefficient(Tp: float, *, floor: float) -> float:
    """Return C_p(T_p) / C(0) = C_Hi C_i(T_p) (NZS 1170.5, 8.2).

    Parameters
    ----------
    Tp : period of the part [s]
    floor : C_Hi [-]

    Returns
    -------
    float [-]
    """
    return floor * float(part_shape(Tp))


def demand_per_pga(part: Part, Tp: float, *, floor: float, risk_factor: float) -> float:
    """Return phi_D over C(0) g: (B / J) (T_p / 2 pi)^2 C_Hi C_i(T_p) R_p.

    Parameters
    ----------
    part : the wall
    Tp : its period [s]
    floor : C_Hi [-]
    risk_factor : R_p [-]

    Returns
    -------
    float [rad s2/m]
    """
    return part.B / part.J * (Tp / (2.0 * np.pi)) ** 2 * part_coefficient(Tp, floor=floor) * risk_factor


def uplift_pga(multiplier: float | None, *, floor: float, risk_factor: float) -> float | None:
    """Return the PGA at which the part coefficient of a rigid body, C_p(0) R_p, reaches the multiplier at rest.

    C_i(0) = 2 is that of parts stiffer than 0.75 s, so this is half of what lifts a rigid wall off a rigid floor.

    Parameters
    ----------
    multiplier : at rest [-]; None on joints without a threshold
    floor : C_Hi [-]
    risk_factor : R_p [-]

    Returns
    -------
    float or None
        PGA [m/s2]; None without a threshold.
    """
    return None if multiplier is None else multiplier * g / (part_coefficient(0.0, floor=floor) * risk_factor)
