"""Amplification of the ground motion on its way up a structure to the base of a mechanism (thesis 3.4.1).

    none          the ground's motion as it is
    srss           thesis 3.48: the motion times one factor from the first mode, records and pulses alike
    srss-relative  the same for records; pulses by 3.47 as it is worded
    floor factor   the motion times the factor of a code for the height (spectra.floor)
    modal filter   the record through the first mode, absolute acceleration at the height

`base_motion` gives a record at the base of the mechanism, `pulse_factor` the factor on a pulse of one full sine.

An elastic oscillator under one acceleration pulse of a full sine:

    u'' + 2 xi w u' + w^2 u = -sin(w_p t)  while t <= 1 / f_p, and 0 after

The steady part is a sine and a cosine of the pulse's frequency, the transient part decays with the oscillator's own:
both are in closed form, during the pulse and after it. The largest value is found on points and by a parabola through
the largest point and its neighbours.

The first natural frequency of a free-standing structure is Rayleigh's, on horizontal slices of a cantilever. Its own
weight, applied sideways, bends and shears it; the deflected shape approximates the first mode (Lord Rayleigh's
principle, as in thesis 4.3.3):

    omega^2 = g sum m u / sum m u^2,   h_e = sum m u z / sum m u

Of a uniform cantilever in bending this is 3.530 sqrt(EI / (m L^4)), 0.4 % above the exact 3.516.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import ceil, log, pi, sqrt
from typing import assert_never

import numpy as np
from numpy.typing import ArrayLike

from assess.errors import GeometryError, MechanismError
from assess.geometry.cut import section_moments
from assess.geometry.solid import Solid
from assess.messages.message import Quantity, note
from records.errors import RecordError
from records.record import Record, scale, with_step
from records.response import COARSEST, response_spectrum
from spectra.arrays import FloatArray
from spectra.gravity import g


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
    fastest : frequency by which the motion is sampled [Hz]; that of the mode where None
    """

    mode: FirstMode
    height: float
    fastest: float | None = None


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
    RecordError : for a record without motion, or with a time step too coarse for the period of the structure
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
            filtered = floor_motion(
                record,
                frequency=mode.frequency,
                shape=mode.shape(height),
                damping=mode.damping,
                fastest=amplification.fastest,
            )
            return BaseMotion(filtered, filtered.pga / _peak_of_motion(record))
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
    return float(np.hypot(S_a / _peak_of_motion(record) * mode.shape(height), 1.0))


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
    MechanismError : for values that no structure has
    """
    for name, value, unit in (("frequency", frequency, "Hz"), ("effective height", effective_height, "m")):
        if not (np.isfinite(value) and value > 0.0):
            raise MechanismError(f"first mode: {name} {value} {unit}; it must be positive")
    if not 0.0 < damping < 1.0:
        raise MechanismError(f"first mode: damping ratio {damping}; it must lie between 0 and 1")
    return FirstMode(frequency, effective_height, damping)


STEPS_PER_PERIOD = 100.0  # of the building: a sine through 100 points, lines between, is at most 0.05 % off
# Of 5,040 runs that rock hard 1.0 % overturn otherwise than at 300 steps; with 20, displacements kept exact, 3.0 %.
FADED = 0.01  # of the free vibration after the record is left when the motion ends


def floor_motion(
    record: Record, *, frequency: float, shape: float, damping: float = 0.05, fastest: float | None = None
) -> Record:
    """Return the absolute acceleration a_g + shape * u'' at a height of a building that responds in its first mode.

    u'' is the acceleration relative to the ground of an oscillator, exact for ground acceleration that is linear
    between samples. The step is divided to a hundredth of the period. The motion continues after the record until the
    free vibration has faded to a hundredth, or for as long again as the record lasts.

    Parameters
    ----------
    record : motion of the ground
    frequency : of the first mode [Hz]
    shape : participation factor times mode shape at the height [-]
    damping : damping ratio of the mode [-]
    fastest : frequency by whose period the step is divided [Hz], so that several modes share a step; else `frequency`

    Raises
    ------
    RecordError : the frequency is not positive or far too high for the record's step, the damping is outside 0 <
        damping < 1, or the shape is not finite

    Source: equation of motion of the first mode; thesis 8.4.2 names the method.
    """
    _check_first_mode(record, frequency=frequency, shape=shape, damping=damping)
    period = 1.0 / frequency
    parts = max(1, ceil(record.dt * STEPS_PER_PERIOD * (fastest or frequency) - 1e-9))
    tail = min(record.npts, ceil(log(1.0 / FADED) / (2.0 * pi * damping) * period / record.dt))
    ground_acceleration = np.concatenate([record.acceleration, np.zeros(tail)])
    from records.kernel import relative_accelerations  # brings numba

    relative = relative_accelerations(ground_acceleration, record.dt, parts, period, damping)
    acceleration = shape * relative + subdivide(ground_acceleration, parts)
    acceleration.flags.writeable = False
    step = note(
        "through-first-mode",
        frequency=Quantity(frequency, "frequency", 6),
        damping=Quantity(damping, figures=3),
        shape=Quantity(shape, figures=6),
    )
    return with_step(replace(record, acceleration=acceleration, dt=record.dt / parts), step)


def subdivide(
    acceleration: np.ndarray[tuple[int], np.dtype[np.float64]], parts: int
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return samples [n] with `parts` - 1 points on the line between every two [(n - 1) parts + 1]."""
    n = acceleration.size
    return np.interp(np.arange((n - 1) * parts + 1) / parts, np.arange(n), acceleration)


ResponseQuantity = Callable[[FloatArray, FloatArray, FloatArray], FloatArray]
"""A quantity from a_g, u and u' of the oscillator [n] each."""
POINTS_PER_PERIOD = 400  # in a period of the pulse or of the oscillator, whichever is shorter


def largest_relative(ratio: ArrayLike, *, damping: float = 0.05) -> FloatArray:
    """Return the largest |u''|, relative to the ground, over the pulse's amplitude (thesis 3.4.1.1, as worded).

    Parameters
    ----------
    ratio : f_p / f_n [n] [-]
    damping : [-]

    Returns
    -------
    array [n] [-]
    """
    return _largest_response(ratio, lambda pulse, u, v: _relative_acceleration(pulse, u, v, damping), damping=damping)


def largest_pseudo(ratio: ArrayLike, *, damping: float = 0.05) -> FloatArray:
    """Return the largest w^2 |u|, the pseudo-acceleration S_a, over the pulse's amplitude (thesis 3.4.1.2).

    The scaled envelopes of 8.3.1 turn out to use it.

    Parameters
    ----------
    ratio : f_p / f_n [n] [-]
    damping : [-]

    Returns
    -------
    array [n] [-]
    """
    return _largest_response(ratio, lambda pulse, u, v: u, damping=damping)


def largest_total(ratio: ArrayLike, *, shape: float, damping: float = 0.05) -> FloatArray:
    """Return the largest |a_g + shape u''| over the pulse's amplitude.

    Parameters
    ----------
    ratio : f_p / f_n [n] [-]
    shape : of the first mode times its participation factor, 1 at the effective height, 0 at the ground [-]
    damping : [-]

    Returns
    -------
    array [n] [-]
    """
    return _largest_response(
        ratio, lambda pulse, u, v: pulse + shape * _relative_acceleration(pulse, u, v, damping), damping=damping
    )


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
class RayleighMode:
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


def rayleigh_mode(slices: Slices, *, top_mass: float = 0.0) -> RayleighMode:
    """Return frequency and effective height of the first mode by Rayleigh's quotient.

    Parameters
    ----------
    slices : the structure
    top_mass : a point mass on top [kg]

    Returns
    -------
    RayleighMode

    Raises
    ------
    GeometryError : where a slice has no mass or no stiffness, so that nothing carries the slices above
    """
    for name, values in (("mass", slices.mass), ("bending stiffness", slices.bending)):
        empty = np.flatnonzero(~(values > 0.0))
        if empty.size:
            at = float(np.sum(slices.height[: empty[0]]))
            raise GeometryError(f"natural frequency: no {name} at {at:.3g} m above the foot; give natural_frequency")
    z = np.append(np.cumsum(slices.height) - slices.height / 2.0, np.sum(slices.height))
    m = np.append(slices.mass, top_mass)
    u = self_weight_deflection(slices, top_mass=top_mass)
    frequency = sqrt(g * float(m @ u) / float(m @ u**2)) / (2.0 * pi)
    return RayleighMode(frequency, float(m @ (u * z)) / float(m @ u))


def self_weight_deflection(slices: Slices, *, top_mass: float = 0.0) -> FloatArray:
    """Return the sideways deflection under the own weight, at the middle of each slice and at the top [n + 1] [m]."""
    h, w = slices.height, g * slices.mass / slices.height
    V = g * top_mass + np.append(np.cumsum((w * h)[::-1])[::-1], 0.0)  # at the joints [n + 1]
    M = np.append(np.cumsum((h * (V[1:] + w * h / 2.0))[::-1])[::-1], 0.0)
    rotation, u = np.zeros(h.size + 1), np.zeros(h.size + 1)  # at the joints, from the foot up
    middle = np.empty(h.size)
    for i in range(h.size):
        middle[i] = u[i] + _slice_deflection(slices, i, h[i] / 2.0, rotation[i], V[i], M[i], w[i])[1]
        rotation[i + 1], gained = _slice_deflection(slices, i, h[i], rotation[i], V[i], M[i], w[i])
        u[i + 1] = u[i] + gained
    return np.append(middle, u[-1])


def _peak_of_motion(record: Record) -> float:
    """Return the record's peak acceleration [m/s2]; refuse a record without motion."""
    if not record.pga > 0.0:
        raise RecordError(f'record "{record.id}": no motion; it cannot be carried up a structure')
    return record.pga


def _check_first_mode(record: Record, *, frequency: float, shape: float, damping: float) -> None:
    where = f'record "{record.id}"'
    if not (np.isfinite(frequency) and frequency > 0.0):
        raise RecordError(f"{where}: natural frequency {frequency} Hz of the building; it must be positive")
    if frequency * record.dt > COARSEST:
        raise RecordError(f"{where}: its step of {record.dt:.6g} s is too coarse for a building of {frequency:.3g} Hz")
    if not 0.0 < damping < 1.0:
        raise RecordError(f"{where}: damping ratio {damping} of the building; it must lie between 0 and 1")
    if not np.isfinite(shape):
        raise RecordError(f"{where}: first mode counts {shape} at the height; it must be a finite number")


def _largest_response(ratio: ArrayLike, quantity: ResponseQuantity, *, damping: float) -> FloatArray:
    """Return the largest |quantity| at each f_p / f_n, during the pulse and after it."""
    r = np.asarray(ratio, dtype=np.float64)
    bad = r[~(np.isfinite(r) & (r > 0.0))]
    if bad.size:
        raise ValueError(f"pulse frequency over natural frequency {bad.flat[0]}; it must be positive and finite")
    if not 0.0 < damping < 1.0:
        raise ValueError(f"damping ratio {damping}; it must lie between 0 and 1")
    largest = [
        max(_parabola_peak(quantity(*response)) for response in _responses(float(each), damping)) for each in r.ravel()
    ]
    return np.array(largest).reshape(r.shape)


def _responses(r: float, damping: float) -> tuple[tuple[FloatArray, FloatArray, FloatArray], ...]:
    """Return a_g, u and u' during the pulse, and for two periods after; time in units of 1 / w, so w_p = r."""
    during = np.linspace(0.0, 2.0 * np.pi / r, int(np.ceil(POINTS_PER_PERIOD * max(1.0, 1.0 / r))) + 1)
    after = np.linspace(0.0, 4.0 * np.pi, 2 * POINTS_PER_PERIOD + 1)
    u, v = _forced_vibration(during, r, damping)
    return (np.sin(r * during), u, v), (np.zeros(after.size), *_free_vibration(after, u[-1], v[-1], damping))


def _relative_acceleration(pulse: FloatArray, u: FloatArray, v: FloatArray, damping: float) -> FloatArray:
    """Return u'', by the equation of motion."""
    return -pulse - 2.0 * damping * v - u


def _forced_vibration(t: FloatArray, r: float, damping: float) -> tuple[FloatArray, FloatArray]:
    """Return u and u' from rest under -sin(r t): the steady motion, and the free vibration that cancels its start."""
    D = (1.0 - r**2) ** 2 + (2.0 * damping * r) ** 2
    S, C = -(1.0 - r**2) / D, 2.0 * damping * r / D
    u, v = _free_vibration(t, -C, -S * r, damping)
    return u + S * np.sin(r * t) + C * np.cos(r * t), v + r * (S * np.cos(r * t) - C * np.sin(r * t))


def _free_vibration(t: FloatArray, u: float, v: float, damping: float) -> tuple[FloatArray, FloatArray]:
    """Return the free vibration u and u' from u, v at t = 0."""
    w_d = np.sqrt(1.0 - damping**2)
    decay, cosine, sine = np.exp(-damping * t), np.cos(w_d * t), np.sin(w_d * t) / w_d
    return decay * (u * cosine + (v + damping * u) * sine), decay * (v * cosine - (u + damping * v) * sine)


def _parabola_peak(values: FloatArray) -> float:
    """Return the largest |value| of a smooth curve: the top of the parabola through its largest point."""
    size = np.abs(values)
    at = int(np.argmax(size))
    if not 0 < at < size.size - 1:
        return float(size[at])
    before, top, after = size[at - 1 : at + 2]
    bend = 2.0 * top - before - after
    return float(top if bend <= 0.0 else top + (after - before) ** 2 / (8.0 * bend))


def _slice_deflection(
    slices: Slices, i: int, s: float, rotation: float, V: float, M: float, w: float
) -> tuple[float, float]:
    """Return the rotation at `s` above the foot of slice i, and the deflection gained up to there.

    V, M act at its foot, w along it. The moment at s is M - V s + w s^2 / 2, exact for a uniform slice.
    """
    EI, GA = slices.bending[i], slices.shear[i]
    rotation_at_s = rotation + (M * s - V * s**2 / 2.0 + w * s**3 / 6.0) / EI
    bending = rotation * s + (M * s**2 / 2.0 - V * s**3 / 6.0 + w * s**4 / 24.0) / EI
    return rotation_at_s, bending + (V * s - w * s**2 / 2.0) / GA
