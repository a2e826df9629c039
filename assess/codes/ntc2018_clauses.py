"""Formulas of NTC 2018 with Circolare 7/2019: local mechanisms (C8.7.1.2) and floor spectra (C7.2.3).

Formulas and numbers are those of a public transcription of the circular. Linear: the acceleration of activation a0*
against that of ground and floor, over q at SLV. Non-linear: displacement capacities d_SLV and d_SLC against the
displacement spectrum at T_SLV or T_SLC, with 8 % or 10 % damping. Above the ground a mechanism must stand the motion
of the floor by C7.2.5 to C7.2.8, with the first mode of the building, and besides it that of the ground, which the
circular does not ask for and which is on the safe side. One function for each formula.

An element that vibrates before it lifts off (a parapet, a pinnacle, a mechanism on flexible joints) has a period T0 and
feels the spectrum at T0 where others feel the peak acceleration.

At ultimate limit states masonry buildings have 1.5 to 2.0 times their elastic period and 10 % to 20 % of damping
(C8.7.1.2.1.4). Displacements are checked under the largest demand over that range, at 10 %: it need not lie at one of
the ends, as the floor spectrum is highest where the period of the mechanism is between 0.8 and 1.1 of the building's.
A first mode that the engineer states for the limit state replaces the range. Accelerations are checked on the elastic
building; those at which a mechanism begins to move also on the building as it softens, and the larger counts.

The friction of side walls toothed into a wall that overturns (C8.7.1.2) is that of `assess.codes.toothing`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from assess.codes.calculation_sheet import Given
from assess.codes.check import TABLE_SPECTRUM
from assess.codes.context import Context, FreePeriod
from assess.codes.italian_kinematic import (
    DisplacementCapacity,
    DisplacementLimit,
    acceleration_at,
    activation,
    displacement_capacity,
    uplift_pga,
)
from assess.codes.italian_limit_states import BranchCurves, Demands, Floor, ItalianEdition, floor_of
from assess.declaration import Evidence, PositiveDensity, PositiveLength, PositiveStress
from assess.oscillator import Branch, elastic_frequency, participation_ratio
from spectra.arrays import FloatArray
from spectra.floor import PLATEAU, circolare2019_first_mode, first_mode_peak

CLAUSE = "C8.7.1.2.1.6"

EDITION = ItalianEdition(
    code="ntc2018",
    name="NTC 2018, Circolare 7/2019",
    caveat="clauses by a public transcription of the circular, not checked against the printed standard",
    multiplier="C8.7.1.1",
    oscillator="C8.7.1.3, C8.7.1.5",
    confidence="C8.5.4, C8.7.1.2.1.3",
)
KAPPA: Mapping[str, float] = {"cantilever": 6.2, "supported": 2.2}  # kappa of C8.7.1.7 [-]


@dataclass(frozen=True)
class UltimateState:
    """Displacement capacity of a limit state: its rule, T = factor pi sqrt(d/a), damping of the demand [-]."""

    rule: DisplacementLimit
    factor: float
    damping: float
    clause: str


ULTIMATE: Mapping[str, UltimateState] = {
    "SLV": UltimateState(DisplacementLimit(0.4, breaks=True, clause=CLAUSE), 1.68, 0.08, "C8.7.1.10"),
    "SLC": UltimateState(DisplacementLimit(0.6, breaks=False, clause=CLAUSE), 1.56, 0.10, "C8.7.1.11"),
}


OF_SECANT = 2.0
"""T = 2 pi sqrt(d / a): the period of the secant itself."""


@dataclass(frozen=True)
class Ntc2018Capacity:
    """The equivalent oscillator of one branch in a limit state: e* [-]; a0*, a [m/s2]; T0, T [s]; thresholds d0*, d.

    factor : of the period, T = factor pi sqrt(d / a)
    """

    e: float
    a0: float
    a: float
    T0: float
    T: float
    factor: float
    displacements: DisplacementCapacity

    @property
    def d0(self) -> float:
        """d0* [m]."""
        return self.displacements.collapse

    @property
    def d(self) -> float:
        """d_SLV or d_SLC [m]."""
        return self.displacements.displacement


def capacity_of(curves: BranchCurves, *, state: str, confidence_factor: float, T0: float = 0.0) -> Ntc2018Capacity:
    """Return the capacity of one branch in a limit state: d_LS, a(d_LS), T = 1.68 or 1.56 pi sqrt(d / a(d)).

    Where a tie that breaks ends d_LS, the period is that of the secant itself, 2 pi sqrt(d / a(d)): the factors of the
    clause are those of a wall that softens up to 0.4 or 0.6 d0*, and would allow what breaks at a 1.42 times that
    acceleration. That is our reading, on the safe side.

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
    Ntc2018Capacity
    """
    ultimate, mass, FC = ULTIMATE[state], curves.mass, confidence_factor
    displacements = displacement_capacity(curves, ultimate.rule)
    d = displacements.displacement
    on_curve = acceleration_at(curves.breaking, d, mass=mass, confidence_factor=FC)
    a = on_curve if T0 == 0.0 else min(on_curve, elastic_branch(d, T0=T0))
    breaks = any(each.limit.kind == "break" and each.displacement <= d for each in displacements.local_limits)
    factor = OF_SECANT if breaks else ultimate.factor
    return Ntc2018Capacity(
        e=participation_ratio(curves.lasting, mass=mass),
        a0=activation(curves.starting, mass=mass, confidence_factor=FC),
        a=a,
        T0=T0,
        T=float(factor * np.pi * np.sqrt(d / a)),
        factor=factor,
        displacements=displacements,
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


AS_DRAWN = Evidence("drawn", "either", "as drawn")
CRACKED_MODULUS = Evidence("measured", "either", "as its table, which gives a period before uplift")


@dataclass(frozen=True)
class FreeElement:
    """A wall that vibrates between its supports before it lifts off: its period follows by C8.7.1.7."""

    length: Annotated[PositiveLength, AS_DRAWN]
    """height of the wall that is free, like "2 m\""""
    thickness: Annotated[PositiveLength, AS_DRAWN]
    """thickness of the wall"""
    young_modulus: Annotated[PositiveStress, CRACKED_MODULUS]
    """Young's modulus, reduced for cracks, like "0.8 GPa\""""
    density: Annotated[PositiveDensity, Evidence("defines", "either", "that of its material")]
    """density of the masonry"""
    support: Annotated[Literal["cantilever", "supported"], AS_DRAWN] = "cantilever"
    """"cantilever", or "supported" at both ends"""


def free_period(element: FreeElement) -> FreePeriod:
    """Return T0 = kappa (L/t) L sqrt(W / (E g)) of a wall that vibrates between its supports (C8.7.1.7).

    kappa is 6.2 for a cantilever, 2.2 where it is supported at both ends.
    """
    kappa, L, t = KAPPA[element.support], element.length, element.thickness
    value = float(kappa * L**2 / t * np.sqrt(element.density / element.young_modulus))
    inputs: Given = {
        "κ": kappa,
        "L": (L, "m"),
        "t": (t, "m"),
        "ρ": (element.density, "kg/m3"),
        "E": (element.young_modulus, "Pa"),
    }
    return FreePeriod(value, "κ L² / t √(ρ / E)", inputs, "ρ = W / g")


def period_before_uplift(branch: Branch, context: Context) -> float:
    """Return T0 [s]: given, or of small motions on flexible joints; 0 for mechanisms that are rigid until uplift."""
    if context.free_period is not None:
        return context.free_period.value
    frequency = elastic_frequency(branch)
    return 1.0 / frequency if frequency else 0.0


def acceleration_demands(context: Context, modes: Sequence[FirstModes], *, T0: float) -> Demands | None:
    """Return the demands over PGA at 5 % damping: S_e(T0) of the ground, S_eZ(T0) of the floor; at T0 = 0 PGA and a_Z.

    Source: C8.7.1.8, C8.7.1.9 with C7.2.5 to C7.2.8.

    Parameters
    ----------
    context : its spectrum
    modes : first modes of the building, of which the most demanding counts; none at the ground
    T0 : period before uplift [s]

    Returns
    -------
    Accelerations over PGA [-]; None where the spectrum ends too early.
    """
    spectrum = context.spectrum
    if max(T0, *(each.longest for each in modes), 0.0) > spectrum.longest_period:
        return None
    ground = float(spectrum.acceleration(T0, damping=ELASTIC_DAMPING)) / spectrum.pga
    return Demands(
        ground, max((floor_acceleration(context, each, T0)[1] / spectrum.pga for each in modes), default=0.0)
    )


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


def uplift_on_floor(branch: Branch, context: Context, *, confidence_factor: float) -> float | None:
    """Return the PGA at uplift, less where the floor amplifies the ground.

    Parameters
    ----------
    branch : with every action at rest
    context : site and building
    confidence_factor : FC [-]

    Returns
    -------
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


SOFTENING = (1.5, 2.0)  # T_1' / T_1
SOFTENED_DAMPING, COMPARISON_DAMPING = 0.10, 0.20
ELASTIC_DAMPING = 0.05  # largest of an elastic building, and of an element before it lifts off (C8.7.1.9)
SCANNED_FIRST_PERIODS = 401  # periods of the building tried besides those where the largest demand is expected
GROUND_PERIODS = 501  # periods of the mechanism at which the largest displacement of the ground is sought
FLOOR_PERIODS = 201  # the same of the floor


@dataclass(frozen=True)
class FirstModes:
    """First modes that the building may have.

    shortest, longest : period T_1' [s]; damping : xi_1 [-]; floor : psi, gamma, elastic T_1
    reason : why the engineer states one; empty where the range of the code is used
    """

    shortest: float
    longest: float
    damping: float
    floor: Floor
    reason: str = ""

    @property
    def share(self) -> float:
        """gamma_1 psi_1(z), psi = Z/H (C7.2.10) [-]."""
        return self.floor.gamma * self.floor.psi

    def periods(self, period: float) -> FloatArray:
        """Return the T_1' to try for a mechanism of `period` T [s]: the ends, T/b and T/a between them, and a scan."""
        peaks = [period / factor for factor in PLATEAU if self.shortest < period / factor < self.longest]
        scan = np.linspace(self.shortest, self.longest, SCANNED_FIRST_PERIODS if self.longest > self.shortest else 1)
        return np.concatenate(([self.shortest, self.longest], peaks, scan))


@dataclass(frozen=True)
class FloorDemand:
    """The floor's displacement demand at the PGA of the spectrum, under the most demanding first mode.

    first : T_1' [s]; period : T of the mechanism at which it is largest [s]
    displacement : d [m]; least : its lower bound beyond b T_1', 0 where there is none [m]
    """

    first: float
    period: float
    displacement: float
    least: float

    @property
    def largest(self) -> float:
        """The demand [m]."""
        return max(self.displacement, self.least)


def elastic_modes(context: Context) -> FirstModes | None:
    """Return the elastic first mode, for accelerations; None at the ground, or where the building is not known."""
    floor = floor_of(context)
    return None if floor is None else FirstModes(floor.T1, floor.T1, min(floor.damping, ELASTIC_DAMPING), floor)


def ultimate_modes(context: Context, state: str, *, damping: float = SOFTENED_DAMPING) -> FirstModes | None:
    """Return the first modes at an ultimate limit state (C8.7.1.2.1.4).

    Parameters
    ----------
    context : building and height of the mechanism
    state : "SLV" or "SLC"
    damping : xi_1 of the softened building, where no first mode is stated [-]

    Returns
    -------
    The mode that is stated, else 1.5 to 2.0 times the elastic period; None at the ground or without a building.
    """
    floor, building = floor_of(context), context.building
    if floor is None or building is None:
        return None
    stated = building.limit_states.get(state)
    if stated is not None:
        return FirstModes(stated.period, stated.period, stated.damping, floor, stated.reason)
    return FirstModes(SOFTENING[0] * floor.T1, SOFTENING[1] * floor.T1, damping, floor)


def activation_modes(context: Context, state: str) -> tuple[FirstModes, ...]:
    """Return the first modes under which a mechanism may begin to move before it reaches an ultimate limit state.

    The building is elastic in the first shakes and softens in the later ones: T_1 with its elastic damping, and what
    lies between T_1 and the longest period at the limit state with the damping there. Judged on the softened building
    alone, low floors show 0.19 to 0.62 of the ground's acceleration, and a stiff body seems never to move.
    Source: C8.7.1.8 and C8.7.1.9 with C8.7.1.2.1.4; the range is on the safe side.

    Parameters
    ----------
    context : building and height of the mechanism
    state : "SLV" or "SLC"

    Returns
    -------
    None at the ground or without a building.
    """
    elastic, ultimate = elastic_modes(context), ultimate_modes(context, state)
    if elastic is None or ultimate is None:
        return ()
    return elastic, FirstModes(elastic.longest, ultimate.longest, ultimate.damping, ultimate.floor)


def peak_acceleration(context: Context, modes: FirstModes, first: float) -> float:
    """Return a_Z of the floor at the PGA of the spectrum (C7.2.7, C7.2.8).

    Parameters
    ----------
    context : its spectrum
    modes : damping, gamma and psi of the first mode
    first : T_1' [s]

    Returns
    -------
    float [m/s2]
    """
    found = first_mode_peak(first, spectrum=context.spectrum, mode_damping=modes.damping, share=modes.share)
    return float(found)


def floor_ordinates(
    context: Context, modes: FirstModes, first: FloatArray, T: FloatArray, *, damping: float
) -> FloatArray:
    """Return S_eZ(T, xi, z) of the floor at the PGA of the spectrum (C7.2.5, C7.2.6).

    Parameters
    ----------
    context : its spectrum
    modes : damping, gamma and psi of the first mode
    first : T_1', broadcast with T [s]
    T : period of the mechanism [s]
    damping : xi of the mechanism [-]

    Returns
    -------
    array, as `first` and T broadcast [m/s2]
    """
    own = {"mode_damping": modes.damping, "share": modes.share, "damping": damping}
    return circolare2019_first_mode(T, spectrum=context.spectrum, first=first, **own)


def floor_ordinate(context: Context, modes: FirstModes, first: float, T: float, *, damping: float) -> float:
    """Return S_eZ(T, xi, z) [m/s2] under one first mode, as `ordinates` does."""
    return float(floor_ordinates(context, modes, np.array(first), np.array(T), damping=damping))


def floor_acceleration(context: Context, modes: FirstModes, T0: float) -> tuple[float, float]:
    """Return the largest S_eZ(T_0) of the floor over the first modes, at 5 %; a_Z for T_0 = 0 (C8.7.1.8, C8.7.1.9).

    Parameters
    ----------
    context : its spectrum
    modes : first modes of the building
    T0 : period of the mechanism before uplift [s]

    Returns
    -------
    T_1' at which it is largest [s], and the acceleration [m/s2].
    """
    first = modes.periods(T0)
    found = floor_ordinates(context, modes, first, np.array(T0), damping=ELASTIC_DAMPING)
    place = int(np.argmax(found))
    return float(first[place]), float(found[place])


def floor_demand(context: Context, modes: FirstModes, *, T0: float, T: float, damping: float) -> FloorDemand:
    """Return the largest displacement that the floor demands over the first modes (C8.7.1.12).

    Spectra of codes are read at T. Of a table, whose displacements need not grow with the period, the largest from
    T_0 to T counts (C8.7.1.2.1.8).

    Parameters
    ----------
    context : its spectrum
    modes : first modes of the building
    T0, T : period before uplift and secant period [s]
    damping : of the mechanism [-]

    Returns
    -------
    FloorDemand
    """
    at_T = _floor_demand_at(context, modes, T, damping=damping)
    if context.spectrum.code != TABLE_SPECTRUM:
        return at_T
    worst = _worst_period(context, modes, T0=T0, T=T, damping=damping)
    return max(at_T, _floor_demand_at(context, modes, worst, damping=damping), key=lambda each: each.largest)


def ground_period(context: Context, *, T0: float, T: float, damping: float) -> float:
    """Return the period from T_0 to T of the largest displacement of the ground (C8.7.1.2.1.8).

    With spectra of codes it is T, unless the displacement falls beyond T_F.

    Parameters
    ----------
    context : its spectrum
    T0, T : period before uplift and secant period [s]
    damping : of the mechanism [-]

    Returns
    -------
    The longest of equals [s].
    """
    period = np.linspace(T, min(T0, T), GROUND_PERIODS)
    moved = context.spectrum.displacement(period, damping=damping)
    return float(period[np.argmax(moved >= moved.max() * (1 - 1e-12))])


def longest_period_used(modes: FirstModes | None, T: float) -> float:
    """Return the longest period at which the spectrum is read [s]: T, and above the ground b times the building's."""
    return T if modes is None else max(T, PLATEAU[1] * modes.longest)


def _worst_period(context: Context, modes: FirstModes, *, T0: float, T: float, damping: float) -> float:
    """Return the period from T_0 to T at which the floor moves most under any mode; the longest of equals [s]."""
    period, first = np.linspace(T, min(T0, T), FLOOR_PERIODS)[:-1, None], modes.periods(T)[None, :]
    moved = floor_ordinates(context, modes, first, period, damping=damping) * (period / (2 * np.pi)) ** 2
    return float(period[np.argmax(moved.max(axis=1)), 0])


def _floor_demand_at(context: Context, modes: FirstModes, T: float, *, damping: float) -> FloorDemand:
    first = modes.periods(T)
    moved = floor_ordinates(context, modes, first, np.array(T), damping=damping) * (T / (2 * np.pi)) ** 2
    edge = PLATEAU[1] * first
    resonant = floor_ordinates(context, modes, first, first, damping=damping) * (edge / (2 * np.pi)) ** 2
    least = np.where(edge < T * (1.0 - 1e-12), resonant, 0.0)
    place = int(np.argmax(np.maximum(moved, least)))
    return FloorDemand(float(first[place]), T, float(moved[place]), float(least[place]))
