"""Italian procedure of NTC 2018 with Circolare 7/2019: local mechanisms (C8.7.1.2) and floor spectra (C7.2.3).

Formulas and numbers are those of a public transcription of the circular. Linear: the acceleration of activation a0*
against that of ground and floor, over q at SLV. Non-linear: displacement capacities 0.4 d0* (SLV) and 0.6 d0* (SLC)
against the displacement spectrum at T_SLV or T_SLC, with 8 % or 10 % damping. Above the ground both the motion of the
ground and that of the floor must be stood; the latter is by C7.2.5 to C7.2.8 with the first mode of the building.

An element that vibrates before it lifts off (a parapet, a pinnacle, a mechanism on flexible joints) has a period T0 and
feels the spectrum at T0 where others feel the peak acceleration. One function for each formula.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from assess.codes.context import Context, FreePeriod
from assess.codes.italian.edition import Edition
from assess.codes.italian.floor import Demands, floor_of
from assess.codes.italian.kinematic import acceleration_at, activation, displacement_at_collapse, uplift_pga
from assess.oscillator import Branch, elastic_frequency, participation_ratio
from spectra.floor_spectrum import PLATEAU, Mode, circolare2019, circolare2019_peak

EDITION = Edition(
    name="NTC 2018, Circolare 7/2019",
    caveat="clauses by a public transcription of the circular, not checked against the printed standard",
    multiplier="C8.7.1.1",
    oscillator="C8.7.1.3, C8.7.1.5",
    confidence="Table C8.5.IV",
)
ELASTIC_DAMPING = 0.05  # of an element before it lifts off (C8.7.1.9)
SUPPORTS: Mapping[str, float] = {"cantilever": 6.2, "supported": 2.2}  # kappa of C8.7.1.7 [-]
SAMPLES = 501  # periods at which the largest spectral displacement is sought


@dataclass(frozen=True)
class Ultimate:
    """Displacement capacity of a limit state: share of d0* [-], T = factor pi sqrt(d/a), damping of the demand [-]."""

    share: float
    factor: float
    damping: float
    clause: str


ULTIMATE: Mapping[str, Ultimate] = {
    "SLV": Ultimate(0.4, 1.68, 0.08, "C8.7.1.10"),
    "SLC": Ultimate(0.6, 1.56, 0.10, "C8.7.1.11"),
}


@dataclass(frozen=True)
class Capacity:
    """The equivalent oscillator of one branch in a limit state: e* [-]; d0*, d [m]; a0*, a [m/s2]; T0, T [s]."""

    e: float
    a0: float
    d0: float
    d: float
    a: float
    T0: float
    T: float


def capacity_of(branch: Branch, *, state: str, mass: float, confidence_factor: float, T0: float = 0.0) -> Capacity:
    """d = 0.4 or 0.6 d0*, a(d) on the model's own curve or its elastic branch, T = 1.68 or 1.56 pi sqrt(d / a(d)).

    Source: C8.7.1.2.1 with C8.7.1.6, C8.7.1.10, C8.7.1.11. Local limits (ties that break, beams that lose their
    support) are not modelled.
    """
    ultimate = ULTIMATE[state]
    d0 = displacement_at_collapse(branch, mass=mass)
    d = ultimate.share * d0
    on_curve = acceleration_at(branch, d, mass=mass, confidence_factor=confidence_factor)
    a = on_curve if T0 == 0.0 else min(on_curve, elastic_branch(d, T0=T0))
    return Capacity(
        e=participation_ratio(branch, mass=mass),
        a0=activation(branch, mass=mass, confidence_factor=confidence_factor),
        d0=d0,
        d=d,
        a=a,
        T0=T0,
        T=float(ultimate.factor * np.pi * np.sqrt(d / a)),
    )


def elastic_branch(moved: float, *, T0: float) -> float:
    """a = 4 pi^2 d / T0^2 [m/s2] of a free element before it lifts off (C8.7.1.6)."""
    return 4 * np.pi**2 * moved / T0**2


def free_period(
    *, length: float, thickness: float, young_modulus: float, density: float, support: str = "cantilever"
) -> FreePeriod:
    """T0 = kappa (L/t) L sqrt(W / (E g)) [s] of a wall that vibrates between its supports (C8.7.1.7).

    length L and thickness t [m], young_modulus E, reduced for cracks [Pa], density W / g [kg/m3]; support: "cantilever"
    or "supported" at both ends.
    """
    kappa = SUPPORTS[support]
    numbers = f"{kappa:g} · {length:.5g}² / {thickness:.5g} · √({density:.5g} / {young_modulus:.5g})"
    value = float(kappa * length**2 / thickness * np.sqrt(density / young_modulus))
    return FreePeriod(value, f"κ (L/t) L √(W / (E g)), {support}", numbers)


def period_of(branch: Branch, context: Context) -> float:
    """T0 [s]: given, or of small motions on flexible joints; 0 for mechanisms that are rigid until they lift off."""
    if context.free_period is not None:
        return context.free_period.value
    frequency = elastic_frequency(branch)
    return 1.0 / frequency if frequency else 0.0


def mode_of(context: Context) -> Mode | None:
    """The first mode of the building with its share gamma_1 psi_1(z), psi = Z/H (C7.2.10); None at the ground."""
    floor = floor_of(context)
    return None if floor is None else Mode(floor.T1, floor.damping, floor.gamma * floor.psi)


def floor_amplification(context: Context) -> float:
    """a_Z / PGA [-], at least 1, as no floor is taken to shake less than the ground (C7.2.7, C7.2.8)."""
    mode = mode_of(context)
    if mode is None:
        return 1.0
    return max(1.0, circolare2019_peak(context.spectrum, modes=[mode]) / context.spectrum.pga)


def acceleration_demands(context: Context, *, T0: float) -> Demands:
    """Over PGA [-]: S_e(T0) of the ground, S_eZ(T0) of the floor, 5 % damping; at T0 = 0 the PGA and a_Z.

    Source: C8.7.1.8, C8.7.1.9 with C7.2.5 to C7.2.8.
    """
    spectrum, mode = context.spectrum, mode_of(context)
    ground = float(spectrum.acceleration(T0, damping=ELASTIC_DAMPING)) / spectrum.pga
    if mode is None:
        return Demands(ground, 0.0)
    return Demands(ground, floor_ordinate(context, T0, damping=ELASTIC_DAMPING) / spectrum.pga)


def floor_ordinate(context: Context, period: float, *, damping: float) -> float:
    """S_eZ(T, xi, z) [m/s2] at the PGA of the spectrum (C7.2.5, C7.2.6). Only above the ground."""
    mode = mode_of(context)
    assert mode is not None  # asked above the ground alone
    return float(circolare2019(period, spectrum=context.spectrum, modes=[mode], damping=damping))


def displacement_demands(context: Context, *, T0: float, T: float, damping: float) -> Demands | None:
    """Displacement for each m/s2 of PGA [s2]: of the ground and of the floor; None where the spectrum ends too early.

    The ground's is the largest S_De between T0 and T: with spectra of codes that at T, which grows with the period.
    The floor's is S_eZ(T) (T / 2 pi)^2, for T > b T1 at least S_eZ(T1) (b T1 / 2 pi)^2.
    Source: C8.7.1.2.1, C8.7.1.12.
    """
    spectrum, mode = context.spectrum, mode_of(context)
    if max(T, 0.0 if mode is None else mode.period) > spectrum.longest_period:
        return None
    ground = float(spectrum.displacement(worst_period(context, T0=T0, T=T, damping=damping), damping=damping))
    return Demands(
        ground / spectrum.pga, 0.0 if mode is None else floor_displacement(context, T, damping=damping) / spectrum.pga
    )


def worst_period(context: Context, *, T0: float, T: float, damping: float) -> float:
    """Period between T0 and T of the largest spectral displacement, the longest of equals [s] (C8.7.1.2.1)."""
    period = np.linspace(T, min(T0, T), SAMPLES)
    moved = context.spectrum.displacement(period, damping=damping)
    return float(period[np.argmax(moved >= moved.max() * (1 - 1e-12))])


def floor_displacement(context: Context, T: float, *, damping: float) -> float:
    """d [m] of the floor's motion at the PGA of the spectrum (C8.7.1.12). Only above the ground."""
    moved = floor_ordinate(context, T, damping=damping) * (T / (2 * np.pi)) ** 2
    return max(moved, resonant_displacement(context, T, damping=damping))


def resonant_displacement(context: Context, T: float, *, damping: float) -> float:
    """S_eZ(T1) (b T1 / 2 pi)^2 [m] for T > b T1, else 0 (C8.7.1.12). Only above the ground."""
    mode = mode_of(context)
    assert mode is not None  # asked above the ground alone
    longest = PLATEAU[1] * mode.period
    if longest >= T:
        return 0.0
    return floor_ordinate(context, mode.period, damping=damping) * (longest / (2 * np.pi)) ** 2


def uplift(branch: Branch, context: Context, *, confidence_factor: float) -> float | None:
    """PGA [m/s2] that lifts the mechanism off, less where the floor amplifies the ground; None without a threshold."""
    return uplift_pga(branch, confidence_factor=confidence_factor, amplified=floor_amplification(context))


def activation_pga(capacity: float, demands: Demands) -> float:
    """a_g,SLD [m/s2]: PGA at which the `demands` over PGA [-] reach a0* = `capacity` [m/s2] (C8.7.1.8, C8.7.1.9)."""
    return capacity / demands.largest
