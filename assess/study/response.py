"""Rocking of one oscillator under one record, as Python asks for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import inf, isfinite, nan

import numpy as np

from assess.dynamics.history import Jobs, peaks, trace
from assess.dynamics.packing import Equation
from assess.oscillator import Oscillator
from assess.short_repr import ShortRepr, html_table
from assess.study.level_peaks import rotation_of_ratio_one, with_restitution_factor
from records.errors import RecordError
from records.record import STRONGEST, Record
from spectra.arrays import FloatArray, is_number


@dataclass(frozen=True, repr=False)
class RockingResponse(ShortRepr):
    """The rocking motion of one oscillator under one record.

    overturned : whether the body can no longer return
    max_ratio : largest |rotation| / overturning rotation of its branch, with rigid interfaces [-]; nan if it overturned
    max_rotation : rotation of that ratio, signed [rad]; None if it overturned
    time_of_max : when it was reached [s]; None if it overturned, 0 if the body never moved
    impacts : number of impacts, until overturning or until the free motion after the record has peaked on each side
    overturning_time : last upward passage of the overturning rotation [s]; None if it did not overturn
    record, scale, equation : what was run
    rebound : factor on the restitution of one-sided rocking, of which the worst counts [-]; 1 for all other rocking
    time : instants of the record's samples, up to overturning [n] [s]
    rotation, velocity : at these instants, signed [n] [rad], [n] [rad/s]
    acceleration : of the ground at these instants, scaled [n] [m/s2]
    limits : rotations of ratio 1 of the positive and of the negative side [rad]; one where it rocks to one side
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
    acceleration: FloatArray
    limits: tuple[float, ...]
    rebound: float = 1.0

    def _repr_html_(self) -> str:
        return html_table(
            ("record", self.record),
            ("scale", self.scale),
            ("overturned", f"at {self.overturning_time:.4g} s" if self.overturning_time is not None else "no"),
            ("largest rotation / overturning", self.max_ratio),
            ("impacts", self.impacts),
        )


def respond(
    oscillator: Oscillator, record: Record, *, scale: float = 1.0, equation: Equation = "exact"
) -> RockingResponse:
    """Solve the rocking motion of an oscillator from rest under a scaled record.

    Parameters
    ----------
    oscillator : the branches of the mechanism, or of a rigid block
    record : acceleration of the ground at the base of the mechanism [m/s2]
    scale : factor on the record [-]; a negative one reverses its polarity
    equation : {"exact", "linearised"}
        The equation of motion: of the branch tables, or linearised at small rotations.

    Returns
    -------
    The largest response and the history at the record's samples.

    Raises
    ------
    MechanismError : if a branch cannot rock
    RecordError : if it is not one record of finite samples, or the scale is not finite
    """
    check_record(record)
    if not (is_number(scale) and isfinite(scale)):
        raise RecordError(f'record "{record.id}": scale = {scale}: give a finite number')
    if abs(scale) * record.pga > STRONGEST:
        raise RecordError(f'record "{record.id}": scale = {scale:g}: its peak is over {STRONGEST:g} m/s2; check it')
    first = np.zeros(1, dtype=np.int64)
    found = peaks([oscillator], [record], Jobs(first, first, np.array([scale])), equation=equation, threads=1)
    path = trace(oscillator, record, scale=scale, equation=equation)
    overturned = bool(found.overturned[0])
    acceleration = scale * record.acceleration[: path.time.size]
    acceleration.flags.writeable = False
    return RockingResponse(
        overturned=overturned,
        max_ratio=nan if overturned else float(found.max_ratio[0]),
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
        acceleration=acceleration,
        limits=tuple(rotation_of_ratio_one(branch, equation) for branch in oscillator.branches),
    )


def respond_at_worst_rebound(
    oscillator: Oscillator, record: Record, *, rebounds: Sequence[float], scale: float, equation: Equation
) -> RockingResponse:
    """Solve the rocking motion with every rebound of a range, and return the worst.

    Parameters
    ----------
    oscillator, record, scale, equation : as for `respond`
    rebounds : factors on the restitution [-]; of several that overturn, the first counts
    """
    motions = [
        replace(
            respond(with_restitution_factor(oscillator, factor), record, scale=scale, equation=equation), rebound=factor
        )
        for factor in rebounds
    ]
    return max(motions, key=lambda motion: inf if motion.overturned else motion.max_ratio)


def check_record(record: Record) -> None:
    """Raise RecordError for what is no record of finite samples at a time step."""
    if not isinstance(record, Record):
        raise RecordError(f"record: {type(record).__name__} given; give one record, such as read_records(path)[0]")
    samples = record.acceleration
    if not isinstance(samples, np.ndarray) or samples.ndim != 1 or samples.dtype.kind not in "iuf":
        raise RecordError(f'record "{record.id}": give its accelerations [m/s2] as an array of numbers [n]')
    if record.npts < 2 or not np.isfinite(samples).all():
        raise RecordError(f'record "{record.id}": {record.npts} samples; give two or more finite accelerations [m/s2]')
    if not (is_number(record.dt) and isfinite(record.dt) and record.dt > 0.0):
        raise RecordError(f'record "{record.id}": time step {record.dt} s; give one greater than 0')
