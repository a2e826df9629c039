"""The building below a mechanism above the ground: its first mode, elastic or softened, and the motion of the floor.

At ultimate limit states masonry buildings have 1.5 to 2.0 times their elastic period and 10 % to 20 % of damping
(C8.7.1.2.1.4). Displacements are checked under the largest demand over that range, at 10 %: it need not lie at one of
the ends, as the floor spectrum is highest where the period of the mechanism is between 0.8 and 1.1 of the building's.
A first mode that the engineer states for the limit state replaces the range. Accelerations are checked on the elastic
building, whose floors shake harder.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.codes.context import Context
from assess.codes.italian.floor import Floor, floor_of
from spectra.arrays import FloatArray
from spectra.circolare2019 import PLATEAU, circolare2019_first_mode, first_mode_peak

SOFTENING = (1.5, 2.0)  # T_1' / T_1
SOFTENED_DAMPING, SHOWN_DAMPING = 0.10, 0.20
ELASTIC_DAMPING = 0.05  # largest of an elastic building, and of an element before it lifts off (C8.7.1.9)
GUARD = 401  # periods of the building tried besides those where the largest demand is expected
SAMPLES = 501  # periods of the mechanism at which the largest displacement of the ground is sought
OF_TABLE = 201  # the same of the floor
TABLE = "table"


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
        scan = np.linspace(self.shortest, self.longest, GUARD if self.longest > self.shortest else 1)
        return np.concatenate(([self.shortest, self.longest], peaks, scan))


@dataclass(frozen=True)
class FloorDemand:
    """The floor's displacement demand at the PGA of the spectrum, under the most demanding first mode.

    first : T_1' [s]; period : T of the mechanism at which it is largest [s]
    moved : d [m]; least : its lower bound beyond b T_1', 0 where there is none [m]
    """

    first: float
    period: float
    moved: float
    least: float

    @property
    def largest(self) -> float:
        """The demand [m]."""
        return max(self.moved, self.least)


def elastic_modes(context: Context) -> FirstModes | None:
    """Return the elastic first mode, for accelerations; None at the ground, or where the building is not known."""
    floor = floor_of(context)
    return None if floor is None else FirstModes(floor.T1, floor.T1, min(floor.damping, ELASTIC_DAMPING), floor)


def modes_at(context: Context, state: str, *, damping: float = SOFTENED_DAMPING) -> FirstModes | None:
    """Return the first modes at an ultimate limit state (C8.7.1.2.1.4).

    Parameters
    ----------
    context : building and height of the mechanism
    state : "SLV" or "SLC"
    damping : xi_1 of the softened building, where no first mode is stated [-]

    Returns
    -------
    FirstModes or None
        The mode that is stated, else 1.5 to 2.0 times the elastic period; None at the ground or without a building.
    """
    floor, building = floor_of(context), context.building
    if floor is None or building is None:
        return None
    stated = building.limit_states.get(state)
    if stated is not None:
        return FirstModes(stated.period, stated.period, stated.damping, floor, stated.reason)
    return FirstModes(SOFTENING[0] * floor.T1, SOFTENING[1] * floor.T1, damping, floor)


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


def ordinates(context: Context, modes: FirstModes, first: FloatArray, T: FloatArray, *, damping: float) -> FloatArray:
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


def ordinate(context: Context, modes: FirstModes, first: float, T: float, *, damping: float) -> float:
    """Return S_eZ(T, xi, z) [m/s2] under one first mode, as `ordinates` does."""
    return float(ordinates(context, modes, np.array(first), np.array(T), damping=damping))


def floor_acceleration(context: Context, modes: FirstModes, T0: float) -> tuple[float, float]:
    """Return the largest S_eZ(T_0) of the floor over the first modes, at 5 %; a_Z for T_0 = 0 (C8.7.1.8, C8.7.1.9).

    Parameters
    ----------
    context : its spectrum
    modes : first modes of the building
    T0 : period of the mechanism before uplift [s]

    Returns
    -------
    tuple of float
        T_1' at which it is largest [s], and the acceleration [m/s2].
    """
    first = modes.periods(T0)
    found = ordinates(context, modes, first, np.array(T0), damping=ELASTIC_DAMPING)
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
    at_T = _at(context, modes, T, damping=damping)
    if context.spectrum.code != TABLE:
        return at_T
    worst = _worst_period(context, modes, T0=T0, T=T, damping=damping)
    return max(at_T, _at(context, modes, worst, damping=damping), key=lambda each: each.largest)


def _worst_period(context: Context, modes: FirstModes, *, T0: float, T: float, damping: float) -> float:
    """Return the period from T_0 to T at which the floor moves most under any mode; the longest of equals [s]."""
    period, first = np.linspace(T, min(T0, T), OF_TABLE)[:-1, None], modes.periods(T)[None, :]
    moved = ordinates(context, modes, first, period, damping=damping) * (period / (2 * np.pi)) ** 2
    return float(period[np.argmax(moved.max(axis=1)), 0])


def _at(context: Context, modes: FirstModes, T: float, *, damping: float) -> FloorDemand:
    first = modes.periods(T)
    moved = ordinates(context, modes, first, np.array(T), damping=damping) * (T / (2 * np.pi)) ** 2
    edge = PLATEAU[1] * first
    resonant = ordinates(context, modes, first, first, damping=damping) * (edge / (2 * np.pi)) ** 2
    least = np.where(edge < T * (1.0 - 1e-12), resonant, 0.0)
    place = int(np.argmax(np.maximum(moved, least)))
    return FloorDemand(float(first[place]), T, float(moved[place]), float(least[place]))


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
    float
        The longest of equals [s].
    """
    period = np.linspace(T, min(T0, T), SAMPLES)
    moved = context.spectrum.displacement(period, damping=damping)
    return float(period[np.argmax(moved >= moved.max() * (1 - 1e-12))])


def longest_period_used(modes: FirstModes | None, T: float) -> float:
    """Return the longest period at which the spectrum is read [s]: T, and above the ground b times the building's."""
    return T if modes is None else max(T, PLATEAU[1] * modes.longest)
