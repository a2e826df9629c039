"""Italian procedure of NTC 2018 with Circolare 7/2019: local mechanisms (C8.7.1.2) and floor spectra (C7.2.3).

Formulas and numbers are those of a public transcription of the circular. Linear: the acceleration of activation a0*
against that of ground and floor, over q at SLV. Non-linear: displacement capacities d_SLV and d_SLC against the
displacement spectrum at T_SLV or T_SLC, with 8 % or 10 % damping. Above the ground a mechanism must stand the motion
of the floor by C7.2.5 to C7.2.8, with the first mode of the building, and besides it that of the ground, which the
circular does not ask for and which is on the safe side.

An element that vibrates before it lifts off (a parapet, a pinnacle, a mechanism on flexible joints) has a period T0 and
feels the spectrum at T0 where others feel the peak acceleration. One function for each formula.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from assess.codes.calculation_step import Given
from assess.codes.context import Context, FreePeriod
from assess.codes.italian.curves import Curves
from assess.codes.italian.edition import Edition
from assess.codes.italian.floor import Demands
from assess.codes.italian.kinematic import acceleration_at, activation, uplift_pga
from assess.codes.italian.thresholds import Rule, Threshold, threshold_of
from assess.codes.ntc2018.building import (
    ELASTIC_DAMPING,
    FirstModes,
    elastic_modes,
    floor_acceleration,
    floor_demand,
    ground_period,
    longest_period_used,
    peak_acceleration,
)
from assess.oscillator import Branch, elastic_frequency, participation_ratio

CLAUSE = "C8.7.1.2.1.6"
EDITION = Edition(
    code="ntc2018",
    name="NTC 2018, Circolare 7/2019",
    caveat="clauses by a public transcription of the circular, not checked against the printed standard",
    multiplier="C8.7.1.1",
    oscillator="C8.7.1.3, C8.7.1.5",
    confidence="C8.5.4, C8.7.1.2.1.3",
)
SUPPORTS: Mapping[str, float] = {"cantilever": 6.2, "supported": 2.2}  # kappa of C8.7.1.7 [-]


@dataclass(frozen=True)
class Ultimate:
    """Displacement capacity of a limit state: its rule, T = factor pi sqrt(d/a), damping of the demand [-]."""

    rule: Rule
    factor: float
    damping: float
    clause: str


ULTIMATE: Mapping[str, Ultimate] = {
    "SLV": Ultimate(Rule(0.4, breaks=True, clause=CLAUSE), 1.68, 0.08, "C8.7.1.10"),
    "SLC": Ultimate(Rule(0.6, breaks=False, clause=CLAUSE), 1.56, 0.10, "C8.7.1.11"),
}


@dataclass(frozen=True)
class Capacity:
    """The equivalent oscillator of one branch in a limit state: e* [-]; a0*, a [m/s2]; T0, T [s]; thresholds d0*, d."""

    e: float
    a0: float
    a: float
    T0: float
    T: float
    threshold: Threshold

    @property
    def d0(self) -> float:
        """d0* [m]."""
        return self.threshold.collapse

    @property
    def d(self) -> float:
        """d_SLV or d_SLC [m]."""
        return self.threshold.moved


def capacity_of(curves: Curves, *, state: str, confidence_factor: float, T0: float = 0.0) -> Capacity:
    """Return the capacity of one branch in a limit state: d_LS, a(d_LS), T = 1.68 or 1.56 pi sqrt(d / a(d)).

    d0* is that of the actions shown to last, a0* counts every action at rest, a(d) those that have not ended at d;
    a(d) is read on the model's own curve, or on its elastic branch where that is lower.
    Source: C8.7.1.2.1.6 with C8.7.1.6, C8.7.1.10, C8.7.1.11.

    Parameters
    ----------
    curves : the branch by the actions in it
    state : "SLV" or "SLC"
    confidence_factor : FC [-]
    T0 : period before uplift [s]; 0 for a rigid element

    Returns
    -------
    Capacity
    """
    ultimate, mass, FC = ULTIMATE[state], curves.mass, confidence_factor
    threshold = threshold_of(curves, ultimate.rule)
    d = threshold.moved
    on_curve = acceleration_at(curves.breaking, d, mass=mass, confidence_factor=FC)
    a = on_curve if T0 == 0.0 else min(on_curve, elastic_branch(d, T0=T0))
    return Capacity(
        e=participation_ratio(curves.lasting, mass=mass),
        a0=activation(curves.starting, mass=mass, confidence_factor=FC),
        a=a,
        T0=T0,
        T=float(ultimate.factor * np.pi * np.sqrt(d / a)),
        threshold=threshold,
    )


def elastic_branch(moved: float, *, T0: float) -> float:
    """Return a = 4 pi^2 d / T0^2 of a free element before it lifts off (C8.7.1.6).

    Parameters
    ----------
    moved : displacement d [m]
    T0 : period before uplift [s]

    Returns
    -------
    float [m/s2]
    """
    return 4 * np.pi**2 * moved / T0**2


def free_period(
    *, length: float, thickness: float, young_modulus: float, density: float, support: str = "cantilever"
) -> FreePeriod:
    """Return T0 = kappa (L/t) L sqrt(W / (E g)) of a wall that vibrates between its supports (C8.7.1.7).

    Parameters
    ----------
    length, thickness : L and t [m]
    young_modulus : E, reduced for cracks [Pa]
    density : W / g [kg/m3]
    support : "cantilever" (kappa = 6.2), or "supported" at both ends (2.2)

    Returns
    -------
    FreePeriod
    """
    kappa = SUPPORTS[support]
    value = float(kappa * length**2 / thickness * np.sqrt(density / young_modulus))
    inputs: Given = {
        "κ": kappa,
        "L": (length, "m"),
        "t": (thickness, "m"),
        "ρ": (density, "kg/m3"),
        "E": (young_modulus, "Pa"),
    }
    return FreePeriod(value, "κ L² / t √(ρ / E)", inputs, "ρ = W / g")


def period_of(branch: Branch, context: Context) -> float:
    """Return T0 [s]: given, or of small motions on flexible joints; 0 for mechanisms that are rigid until uplift."""
    if context.free_period is not None:
        return context.free_period.value
    frequency = elastic_frequency(branch)
    return 1.0 / frequency if frequency else 0.0


def acceleration_demands(context: Context, modes: FirstModes | None, *, T0: float) -> Demands | None:
    """Return the demands over PGA at 5 % damping: S_e(T0) of the ground, S_eZ(T0) of the floor; at T0 = 0 PGA and a_Z.

    Source: C8.7.1.8, C8.7.1.9 with C7.2.5 to C7.2.8.

    Parameters
    ----------
    context : its spectrum
    modes : first modes of the building, of which the most demanding counts; None at the ground
    T0 : period before uplift [s]

    Returns
    -------
    Demands or None
        Accelerations over PGA [-]; None where the spectrum ends too early.
    """
    spectrum = context.spectrum
    if max(T0, 0.0 if modes is None else modes.longest) > spectrum.longest_period:
        return None
    ground = float(spectrum.acceleration(T0, damping=ELASTIC_DAMPING)) / spectrum.pga
    floor = 0.0 if modes is None else floor_acceleration(context, modes, T0)[1] / spectrum.pga
    return Demands(ground, floor)


def displacement_demands(
    context: Context, modes: FirstModes | None, *, T0: float, T: float, damping: float
) -> Demands | None:
    """Return the displacements that ground and floor demand for each m/s2 of PGA.

    The ground's is the largest S_De between T0 and T: with spectra of codes that at T, which grows with the period.
    The floor's is S_eZ(T) (T / 2 pi)^2, for T > b T1 at least S_eZ(T1) (b T1 / 2 pi)^2, under the worst of the `modes`.
    Source: C8.7.1.2.1.8, C8.7.1.12.

    Parameters
    ----------
    context : its spectrum
    modes : first modes of the building; None at the ground
    T0 : period before uplift [s]
    T : secant period T_SLV or T_SLC [s]
    damping : of the mechanism [-]

    Returns
    -------
    Demands or None
        [s2]; None where the spectrum ends too early.
    """
    spectrum = context.spectrum
    if longest_period_used(modes, T) > spectrum.longest_period:
        return None
    ground = float(spectrum.displacement(ground_period(context, T0=T0, T=T, damping=damping), damping=damping))
    floor = 0.0 if modes is None else floor_demand(context, modes, T0=T0, T=T, damping=damping).largest
    return Demands(ground / spectrum.pga, floor / spectrum.pga)


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
    modes = elastic_modes(context)
    if modes is not None and modes.longest > context.spectrum.longest_period:
        return None
    peak = 0.0 if modes is None else peak_acceleration(context, modes, modes.shortest)
    return uplift_pga(branch, confidence_factor=confidence_factor, amplified=max(1.0, peak / context.spectrum.pga))


def activation_pga(capacity: float, demands: Demands) -> float:
    """Return a_g,SLD S, the PGA at which the demands reach the acceleration of activation (C8.7.1.8, C8.7.1.9).

    Parameters
    ----------
    capacity : a0* [m/s2]
    demands : over PGA [-]

    Returns
    -------
    float [m/s2]
    """
    return capacity / demands.largest
