"""Italian procedure of DM 14.01.2008 with Circolare 617/2009: kinematic analysis of local mechanisms (C8A.4).

Clause and equation numbers of C8A.4 are from memory, not checked against the printed circular; formulas were
re-derived. Linear: the acceleration that starts the mechanism against the demand over q. Non-linear: the ultimate
displacement d_u* = 0.4 d_0*, or less where a floor loses its seat before, against the spectral displacement at the
secant period T_s; a mechanism above ground must also pass the check on the floor's motion. One function for each
formula; those that Circolare 7/2019 has too are in `assess.codes.italian`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.codes.context import Context
from assess.codes.italian.curves import Curves
from assess.codes.italian.edition import Edition
from assess.codes.italian.floor import Floor, floor_of
from assess.codes.italian.kinematic import acceleration_at, activation, uplift_pga
from assess.codes.italian.thresholds import Rule, Threshold, threshold_of
from assess.oscillator import Branch, participation_ratio

EDITION = Edition(
    code="dmi2008",
    name="DM 14.01.2008, Circolare 617/2009",
    caveat="clause numbers of C8A.4 not checked against the printed circular",
    multiplier="C8A.4.1",
    oscillator="C8A.4.1.2",
    confidence="C8A.1.1, C8A.4.1",
)
ULTIMATE = 0.4  # d_u* / d_0*, and d_s* / d_u* (C8A.4.2.2)
RULE = Rule(ULTIMATE, breaks=False, clause="C8A.4.2.2")
DAMPING = 0.05  # of every ordinate: the clauses know no other


@dataclass(frozen=True)
class Capacity:
    """The equivalent oscillator of one branch (C8A.4.2.2), all starred quantities: e* [-], a [m/s2], d [m], T [s]."""

    e: float
    a0: float
    ds: float
    as_: float
    Ts: float
    threshold: Threshold

    @property
    def d0(self) -> float:
        """d0* [m], of the actions shown to last."""
        return self.threshold.collapse

    @property
    def du(self) -> float:
        """du* [m]."""
        return self.threshold.moved


def capacity_of(curves: Curves, *, confidence_factor: float) -> Capacity:
    """Return the capacity of one branch: e*, a0*, d0*, du*, ds*, as* and Ts (C8A.4.2.2).

    du* = 0.4 d0*, or less where a seat is lost; ds* = 0.4 du*; as* is read on the model's own curve; Ts = 2 pi
    sqrt(ds* / as*).

    Parameters
    ----------
    curves : the branch by the actions in it
    confidence_factor : FC [-]

    Returns
    -------
    Capacity
    """
    mass, FC, threshold = curves.mass, confidence_factor, threshold_of(curves, RULE)
    ds = ULTIMATE * threshold.moved
    as_ = acceleration_at(curves.breaking, ds, mass=mass, confidence_factor=FC)
    a0 = activation(curves.starting, mass=mass, confidence_factor=FC)
    e = participation_ratio(curves.lasting, mass=mass)
    return Capacity(e, a0, ds, as_, float(2 * np.pi * np.sqrt(ds / as_)), threshold)


def ground_displacement(context: Context, Ts: float) -> float:
    """Return S_De(Ts) at the site's own PGA (C8A.4.2.3): S_e(Ts) (Ts / 2 pi)^2, or the code's own at long periods.

    Parameters
    ----------
    context : its spectrum
    Ts : secant period [s]

    Returns
    -------
    float [m]
    """
    return float(context.spectrum.displacement(Ts, damping=DAMPING))


def floor_displacement(context: Context, floor: Floor, Ts: float) -> float:
    """Return S_De(T1) psi gamma (Ts/T1)^2 / sqrt((1 - Ts/T1)^2 + 0.02 Ts/T1) at the site's own PGA (C8A.4.2.3).

    Parameters
    ----------
    context : its spectrum
    floor : psi, gamma and T1 of the building
    Ts : secant period [s]

    Returns
    -------
    float [m]
    """
    r = Ts / floor.T1
    at_first_mode = ground_displacement(context, floor.T1) * floor.psi * floor.gamma
    return float(at_first_mode * r**2 / np.sqrt((1 - r) ** 2 + 0.02 * r))


def floor_acceleration(context: Context, floor: Floor) -> float:
    """Return S_e(T1) psi gamma at the site's own PGA (C8A.4.2.3).

    Parameters
    ----------
    context : its spectrum
    floor : psi, gamma and T1 of the building

    Returns
    -------
    float [m/s2]
    """
    return float(context.spectrum.acceleration(floor.T1, damping=DAMPING)) * floor.psi * floor.gamma


def uplift(branch: Branch, context: Context, *, confidence_factor: float) -> float | None:
    """Return the PGA at uplift, less where the floor amplifies the ground.

    Parameters
    ----------
    branch : with every action at rest
    context : site and building
    confidence_factor : FC [-]

    Returns
    -------
    float or None
        PGA [m/s2]; None without a threshold, and where the spectrum ends before the period of the building.
    """
    floor = floor_of(context)
    if floor is not None and context.spectrum.longest_period < floor.T1:
        return None
    amplified = 1.0 if floor is None else floor_acceleration(context, floor) / context.spectrum.pga
    return uplift_pga(branch, confidence_factor=confidence_factor, amplified=amplified)
