"""How a mechanism moves: where its blocks are at a rotation, and the history that governs it, played in time.

Blocks are rigid and turn about their hinges, also where their joints give.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from assess.errors import MechanismError
from assess.mechanisms.chain import geometric_limit, move, trace_point
from assess.mechanisms.mechanism import Mechanism
from assess.results import HistoryResult, HistoryTrace
from assess.short_repr import ShortRepr
from assess.study.assessment import check_mechanism
from assess.study.histories import further_levels, history_severity, run_levels, with_governing_trace
from assess.study.study import Study, require_spectrum
from assess.study.suites import motions_of
from records.record import Record
from spectra.arrays import FloatArray
from spectra.gravity import g

SHORT_OF_FLAT = 0.999  # of the rotation at which a chain locks: no drawing goes farther
UPSET = np.pi / 2.0  # rad: a block that has turned by so much lies on its side
SAME = 1e-6  # of the PGA: that at the base is that on the ground
QUIET = 10.0  # s after a record, in which what still rocks comes to rest


@dataclass(frozen=True, repr=False)
class BlockPlace(ShortRepr):
    """Where a rigid block is after a rotation: a point p of it at rest is then at `turn` p + `move`.

    turn : rotation matrix [3, 3]; move : [3] [m]
    """

    turn: FloatArray
    move: FloatArray

    @property
    def quaternion(self) -> tuple[float, float, float, float]:
        """The rotation (w, x, y, z), about a fixed axis by no more than half a turn."""
        w = np.sqrt(max(0.0, 1.0 + np.trace(self.turn))) / 2.0
        x, y, z = (self.turn[[2, 0, 1], [1, 2, 0]] - self.turn[[1, 2, 0], [2, 0, 1]]) / (4.0 * w)
        return (float(w), float(x), float(y), float(z))


def block_places(mechanism: Mechanism, rotation: float) -> tuple[BlockPlace, ...]:
    """Return where each block of the positive branch is at a rotation, base first.

    Parameters
    ----------
    mechanism : with a direction
    rotation : of the leading block, signed [rad]; one that the chain cannot reach counts as the last that it can

    Raises
    ------
    MechanismError : the mechanism has no direction, does not rock that way, or divides into other blocks there
    """
    sign = -1.0 if rotation < 0.0 else 1.0
    chain = mechanism.positive if sign > 0.0 else mechanism.negative
    if mechanism.direction is None or chain is None:
        raise MechanismError(
            f'mechanism "{mechanism.name}": its blocks have no place at a rotation of {rotation:g} rad'
        )
    if [number for _, number in chain.parts] != [number for _, number in mechanism.positive.parts]:
        raise MechanismError(
            f'mechanism "{mechanism.name}": it divides into other blocks where it rocks back, which are not drawn'
        )
    along = np.array(mechanism.direction) / np.linalg.norm(mechanism.direction)
    across, up = np.array([-along[1], along[0], 0.0]), np.array([0.0, 0.0, 1.0])
    second, axis = (across, up) if chain.level else (up, -across)
    reach = min(abs(rotation), UPSET, SHORT_OF_FLAT * geometric_limit(chain))
    motion = move(chain, np.array([reach]))
    places = []
    for number, angle in enumerate(motion.angle[:, 0]):
        origin = trace_point(motion, block=number, at=(0.0, 0.0))
        c, s = np.cos(angle), np.sin(sign * angle)
        turn = c * (np.outer(along, along) + np.outer(second, second)) + np.outer(axis, axis)
        turn += s * (np.outer(along, second) - np.outer(second, along))  # clockwise: `second` falls towards `along`
        places.append(BlockPlace(turn, sign * origin.x[0] * along + origin.z[0] * second))
    return tuple(places)


@dataclass(frozen=True, repr=False)
class RockingMotion(ShortRepr):
    """A mechanism under the record that governs, followed until it rests.

    history : as in the results of a run; record_end_s : when the ground stops [s]
    trace : up to overturning, or until `QUIET` after the record
    """

    mechanism: Mechanism
    history: HistoryResult
    trace: HistoryTrace
    record_end_s: float

    @property
    def title(self) -> str:
        """The record on the ground with its factor, and how many times its PGA is at the base of the mechanism."""
        found = self.history
        factor = found.polarity * found.scale_factor
        ground = f"{found.record} on the ground, x {factor:.3g}, PGA {found.level_pga_g:.3g} g"
        at_base = f" (x {found.amplification:.3g} at the base of the mechanism)"
        return ground + (at_base if abs(found.amplification - 1.0) > SAME else "")

    @property
    def duration(self) -> float:
        """When it is over [s]: overturned, at rest, or at the end of what was followed."""
        time, moves = np.array(self.trace.time_s), np.flatnonzero(self.trace.rotation_rad)
        if self.history.overturned:
            return float(time[-1])
        last = int(moves[-1]) + 1 if moves.size else 0
        return float(max(self.record_end_s, time[min(last, time.size - 1)]))

    @property
    def ending(self) -> str:
        """What it has come to when it is over."""
        if self.history.overturned:
            return "overturned after"
        if not any(self.trace.rotation_rad):
            return "does not rock in"
        return "at rest after" if self.rotation_at(self.duration) == 0.0 else "still moves after"

    def rotation_at(self, time: float) -> float:
        """Return the rotation at a time, signed [rad]."""
        return float(np.interp(time, self.trace.time_s, self.trace.rotation_rad))


def governing_motion(study: Study, *, jobs: int = 0) -> RockingMotion | None:
    """Return how the mechanism of a study moves under the record that overturns it or turns it most, at the site's PGA.

    The records as they are; of several states of the building that which decides.

    Parameters
    ----------
    study : a study of one mechanism
    jobs : number of threads; 0 for all cores

    Returns
    -------
    None where no history of it is answered.

    Raises
    ------
    ProjectError, MechanismError or RecordError : without a site, or where the motions cannot be had
    """
    (mechanism,), spectrum = study.mechanisms, require_spectrum(study)
    if not mechanism.rocks or mechanism.variants.depends_on:
        return None
    motions = motions_of(study, spectrum, jobs=jobs)
    if not motions:
        return None
    found = check_mechanism(
        study, spectrum, mechanism, motions,
        lambda there, case, _: run_levels(
            case, motions, levels=there.levels, further=further_levels(there, spectrum, mechanism),
            site_pga=spectrum.pga, threads=jobs, with_twins=False,
        ),
    )  # fmt: skip
    nearest = int(np.argmin([abs(level - study.question.action.pga_g * g) for level in study.levels]))
    worst = max(found.histories.histories[nearest], key=history_severity)
    followed = [replace(each, record=_with_quiet(each.record)) for each in motions]
    base = tuple(replace(each, record=_with_quiet(each.record)) for each in found.case.base)
    ((traced,),) = with_governing_trace(replace(found.case, base=base), [[worst]], followed)
    assert traced.trace is not None
    ends = {motion.record.id: float(motion.record.time[-1]) for motion in motions}
    return RockingMotion(mechanism, worst, traced.trace, ends[worst.record])


def _with_quiet(record: Record) -> Record:
    """Return a record with `QUIET` seconds of no motion after it."""
    still = np.zeros(round(QUIET / record.dt))
    return replace(record, acceleration=np.concatenate([record.acceleration, still]))
