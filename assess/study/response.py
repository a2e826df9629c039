"""The rocking response of one oscillator to one record."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite

import numpy as np

from assess.dynamics.history import Jobs, peaks, trace
from assess.dynamics.packing import Equation
from assess.oscillator import Oscillator
from assess.short_repr import ShortRepr
from records.errors import RecordError
from records.record import Record
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class Motion(ShortRepr):
    """The rocking motion of one oscillator under one record.

    Attributes
    ----------
    overturned : whether the body can no longer return
    max_ratio : largest |rotation| / overturning rotation of its branch, with rigid interfaces [-]; inf if it overturned
    max_rotation : rotation of that ratio, signed [rad]; None if it overturned
    time_of_max : when it was reached [s]; None if it overturned, 0 if the body never moved
    impacts : number of impacts, until overturning or until the free motion after the record has peaked on each side
    overturning_time : last upward passage of the overturning rotation [s]; None if it did not overturn
    record, scale, equation : what was run
    time : instants of the record's samples, up to overturning [n] [s]
    rotation, velocity : at these instants, signed [n] [rad], [n] [rad/s]
    """

    overturned: bool
    max_ratio: float
    max_rotation: float | None
    time_of_max: float | None
    impacts: int
    overturning_time: float | None
    record: str
    scale: float
    equation: Equation
    time: FloatArray
    rotation: FloatArray
    velocity: FloatArray


def respond(oscillator: Oscillator, record: Record, *, scale: float = 1.0, equation: Equation = "exact") -> Motion:
    """Solve the rocking motion of an oscillator from rest under a scaled record.

    Parameters
    ----------
    oscillator : Oscillator
        The branches of the mechanism, or of a rigid block.
    record : Record
        Acceleration of the ground at the base of the mechanism [m/s2].
    scale : float
        Factor on the record [-]; a negative one reverses its polarity.
    equation : {"exact", "linearised"}
        The equation of motion: of the branch tables, or linearised at small rotations.

    Returns
    -------
    Motion
        The largest response and the history at the record's samples.

    Raises
    ------
    MechanismError
        If a branch cannot rock.
    RecordError
        If it is not one record of finite samples, or the scale is not finite.
    """
    check_record(record)
    if not isfinite(scale):
        raise RecordError(f'record "{record.id}": scale = {scale}: give a finite number')
    one = np.zeros(1, dtype=np.int64)
    found = peaks([oscillator], [record], Jobs(one, one, np.array([scale])), equation=equation, threads=1)
    path = trace(oscillator, record, scale=scale, equation=equation)
    overturned = bool(found.overturned[0])
    return Motion(
        overturned=overturned,
        max_ratio=inf if overturned else float(found.max_ratio[0]),
        max_rotation=None if overturned else float(found.max_rotation[0]),
        time_of_max=None if overturned else float(found.time_of_max[0]),
        impacts=int(found.impacts[0]),
        overturning_time=float(found.overturning_time[0]) if overturned else None,
        record=record.id,
        scale=scale,
        equation=equation,
        time=path.time,
        rotation=path.rotation,
        velocity=path.velocity,
    )


def check_record(record: Record) -> None:
    """Raise RecordError for what is no record of finite samples at a time step."""
    if not isinstance(record, Record):
        raise RecordError(f"record: {type(record).__name__} given; give one record, such as read_record(path)[0]")
    if record.npts < 2 or not np.isfinite(record.acceleration).all():
        raise RecordError(f'record "{record.id}": {record.npts} samples; give two or more finite accelerations [m/s2]')
    if not (isfinite(record.dt) and record.dt > 0.0):
        raise RecordError(f'record "{record.id}": time step {record.dt:g} s; give one greater than 0')
