"""A record as it arrives at a height of a building that answers in its first mode."""

from __future__ import annotations

from dataclasses import replace
from math import ceil, log, pi

import numpy as np

from assess.messages.message import Quantity, note
from records.errors import RecordError
from records.kernel import relative_accelerations
from records.record import Record, with_step
from records.response import COARSEST

STEPS_PER_PERIOD = 100.0  # of the building: a sine through 100 points, lines between, is at most 0.05 % off
FADED = 0.01  # of the free vibration after the record is left when the motion ends


def floor_motion(record: Record, *, frequency: float, shape: float, damping: float = 0.05) -> Record:
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

    Raises
    ------
    RecordError : the frequency is not positive or far too high for the record's step, the damping is outside 0 <
        damping < 1, or the shape is not finite

    Source: equation of motion of the first mode; thesis 8.4.2 names the method.
    """
    _check(record, frequency=frequency, shape=shape, damping=damping)
    period = 1.0 / frequency
    parts = max(1, ceil(record.dt * STEPS_PER_PERIOD * frequency - 1e-9))
    tail = min(record.npts, ceil(log(1.0 / FADED) / (2.0 * pi * damping) * period / record.dt))
    ground = np.concatenate([record.acceleration, np.zeros(tail)])
    relative = relative_accelerations(ground, record.dt, parts, period, damping)
    at_height = shape * relative + between(ground, parts)
    at_height.flags.writeable = False
    step = note(
        "through-first-mode",
        frequency=Quantity(frequency, "frequency", 6),
        damping=Quantity(damping, figures=3),
        shape=Quantity(shape, figures=6),
    )
    return with_step(replace(record, acceleration=at_height, dt=record.dt / parts), step)


def between(
    acceleration: np.ndarray[tuple[int], np.dtype[np.float64]], parts: int
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return samples [n] with `parts` - 1 points on the line between every two [(n - 1) parts + 1]."""
    n = acceleration.size
    return np.interp(np.arange((n - 1) * parts + 1) / parts, np.arange(n), acceleration)


def _check(record: Record, *, frequency: float, shape: float, damping: float) -> None:
    where = f'record "{record.id}"'
    if not (np.isfinite(frequency) and frequency > 0.0):
        raise RecordError(f"{where}: natural frequency {frequency} Hz of the building; it must be positive")
    if frequency * record.dt > COARSEST:
        raise RecordError(f"{where}: its step of {record.dt:.6g} s is too coarse for a building of {frequency:.3g} Hz")
    if not 0.0 < damping < 1.0:
        raise RecordError(f"{where}: damping ratio {damping} of the building; it must lie between 0 and 1")
    if not np.isfinite(shape):
        raise RecordError(f"{where}: first mode counts {shape} at the height; it must be a finite number")
