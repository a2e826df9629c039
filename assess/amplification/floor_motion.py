"""Amplification of the ground motion on its way up a structure to the base of a mechanism (thesis 3.4.1).

    none          the ground's motion as it is
    srss           thesis 3.48: the motion times one factor from the first mode, records and pulses alike
    srss-relative  the same for records; pulses by 3.47 as it is worded
    floor factor   the motion times the factor of a code for the height (spectra.floor)
    modal filter   the record through the first mode, absolute acceleration at the height

`base_motion` gives a record at the base of the mechanism, `pulse_factor` the factor on a pulse of one full sine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

import numpy as np
from numpy.typing import ArrayLike

from assess.amplification.pulse_spectrum import largest_pseudo, largest_relative, largest_total
from assess.errors import MechanismError
from records.errors import RecordError
from records.floor_motion import floor_motion
from records.record import Record, scale
from records.response import response_spectrum
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class FirstMode:
    """The first mode of the structure below a mechanism, with a linear mode shape.

    frequency : f_n [Hz]
    effective_height : h_e, of the resultant of its inertia forces above the base [m]
    damping : [-]
    """

    frequency: float
    effective_height: float
    damping: float = 0.05

    def shape(self, height: float) -> float:
        """Return participation factor times mode shape at `height` [m] above the base: h / h_e [-].

        For a shape linear in height this holds for any distribution of mass: Gamma phi(h) = h sum m z / sum m z^2.
        """
        return height / self.effective_height


@dataclass(frozen=True)
class Unamplified:
    """The ground's motion acts at the base of the mechanism as it is."""


@dataclass(frozen=True)
class FloorFactor:
    """The whole motion is multiplied by a factor of a code [-], by its clause."""

    factor: float
    clause: str


@dataclass(frozen=True)
class Srss:
    """Thesis 3.48: first mode S_a h / h_e and ground by the square root of the sum of squares, at `height` [m].

    For pulses S_a is that of the pulse: so the envelopes that 8.3.1 scales are made, though its text says 3.47
    (test_walls_of_casa_grande). Known limits: S_a is (nearly) absolute, so the ground counts twice, sqrt(2) at h_e of
    a rigid structure, where 1 is right; the frequency content stays that of the ground.
    """

    mode: FirstMode
    height: float


@dataclass(frozen=True)
class SrssRelative:
    """Thesis 3.47 as worded, with the response relative to the ground, for pulses; 3.48 for records; at `height` [m].

    Known limits: up to a fifth low at f_p / f_n = 0.5 to 0.8 (unsafe), far too high above 1.5.
    """

    mode: FirstMode
    height: float


@dataclass(frozen=True)
class ModalFilter:
    """The motion through the first mode, absolute acceleration at `height` [m]: ground and mode added in time.

    Higher modes are left out; above the first natural frequency they would carry what this filter takes away.
    """

    mode: FirstMode
    height: float


Amplification = Unamplified | FloorFactor | Srss | SrssRelative | ModalFilter


@dataclass(frozen=True)
class BaseMotion:
    """A ground motion as it acts at the base of a mechanism; factor: its peak there over its peak at the ground [-]."""

    record: Record
    factor: float


def base_motion(amplification: Amplification, record: Record) -> BaseMotion:
    """Return a ground motion at the base of the mechanism.

    Parameters
    ----------
    amplification : how the structure changes the motion
    record : of the ground

    Returns
    -------
    BaseMotion

    Raises
    ------
    RecordError
        For a record without motion, or with a time step too coarse for the period of the structure.
    """
    match amplification:
        case Unamplified():
            return BaseMotion(record, 1.0)
        case FloorFactor(factor=factor):
            return BaseMotion(scale(record, factor), factor)
        case Srss(mode=mode, height=height) | SrssRelative(mode=mode, height=height):
            factor = srss_factor(mode, record, height=height)
            return BaseMotion(scale(record, factor), factor)
        case ModalFilter(mode=mode, height=height):
            at = floor_motion(record, frequency=mode.frequency, shape=mode.shape(height), damping=mode.damping)
            return BaseMotion(at, at.pga / _moving(record))
    assert_never(amplification)


def srss_factor(mode: FirstMode, record: Record, *, height: float) -> float:
    """Return SF = sqrt((S_a(T_n) / a_g h / h_e)^2 + 1), of the record's pseudo-acceleration and peak (thesis eq. 3.48).

    Parameters
    ----------
    mode : first mode of the structure
    record : of the ground
    height : of the mechanism's base [m]

    Returns
    -------
    float [-]
    """
    S_a = float(response_spectrum(record, 1.0 / mode.frequency, damping=mode.damping))
    return float(np.hypot(S_a / _moving(record) * mode.shape(height), 1.0))


def srss_relative_factor(response: FloatArray, *, shape: float) -> FloatArray:
    """Return a_sc / a_g = sqrt((a_r / a_g h / h_e)^2 + 1) (thesis eq. 3.47).

    Parameters
    ----------
    response : largest responses a_r / a_g [n] [-]
    shape : h / h_e [-]

    Returns
    -------
    array [n] [-]
    """
    return np.hypot(response * shape, 1.0)


def pulse_factor(amplification: Amplification, frequency: ArrayLike) -> FloatArray:
    """Return the factor on the amplitude of pulses of one full sine.

    For the modal filter it is the ratio of the peaks alone: the motion of the structure after the pulse is left out.
    Below 1 it reduces the amplitude, as of a pulse much faster than the structure.

    Parameters
    ----------
    amplification : how the structure changes the motion
    frequency : of the pulses [n] [Hz]

    Returns
    -------
    array [n] [-]
    """
    f = np.asarray(frequency, dtype=np.float64)
    match amplification:
        case Unamplified():
            return np.ones(f.shape)
        case FloorFactor(factor=factor):
            return np.full(f.shape, factor)
        case Srss(mode=mode, height=height):
            return srss_relative_factor(
                largest_pseudo(f / mode.frequency, damping=mode.damping), shape=mode.shape(height)
            )
        case SrssRelative(mode=mode, height=height):
            return srss_relative_factor(
                largest_relative(f / mode.frequency, damping=mode.damping), shape=mode.shape(height)
            )
        case ModalFilter(mode=mode, height=height):
            return largest_total(f / mode.frequency, shape=mode.shape(height), damping=mode.damping)
    assert_never(amplification)


def first_mode(*, frequency: float, effective_height: float, damping: float = 0.05) -> FirstMode:
    """Return a first mode with checked values.

    Parameters
    ----------
    frequency : f_n [Hz]
    effective_height : h_e [m]
    damping : [-]

    Returns
    -------
    FirstMode

    Raises
    ------
    MechanismError
        For values that no structure has.
    """
    for name, value, unit in (("frequency", frequency, "Hz"), ("effective height", effective_height, "m")):
        if not (np.isfinite(value) and value > 0.0):
            raise MechanismError(f"first mode: {name} {value} {unit}; it must be positive")
    if not 0.0 < damping < 1.0:
        raise MechanismError(f"first mode: damping ratio {damping}; it must lie between 0 and 1")
    return FirstMode(frequency, effective_height, damping)


def _moving(record: Record) -> float:
    """The record's peak acceleration [m/s2], if it has motion."""
    if not record.pga > 0.0:
        raise RecordError(f'record "{record.id}": no motion; it cannot be carried up a structure')
    return record.pga
