"""Rocking time histories: oscillators under ground motions.

A job is one oscillator under one motion times one signed scale, whose sign is the polarity. `peaks` runs many jobs on
all cores, `trace` returns one history sample by sample, `trace_with_events` also what happens between samples, and
`free_rocking` releases a body from rest. The equation is
"exact" (the branch tables) or "linearised" (thesis 3.9). The ground acceleration is linear between samples; after the
record the free motion is followed until no later peak can be larger, and that peak counts.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike

from assess.dynamics.kernel import columns
from assess.dynamics.packing import (
    Equation,
    PackedOscillator,
    branches_of,
    check_jobs,
    kernel_array,
    pack,
    pack_all,
    tables_of,
)
from assess.errors import MechanismError
from assess.oscillator import Memory, Oscillator
from assess.short_repr import ShortRepr
from records.record import Record, make_record
from spectra.arrays import BoolArray, FloatArray, IntArray

Array = TypeVar("Array", FloatArray, IntArray, BoolArray)
RunHistory = Callable[[IntArray, IntArray, FloatArray, float, FloatArray, FloatArray, FloatArray], int]

TOLERANCE = 1e-10
"""Error allowed in one step of the exact equation, of phi / phi_ov and of its rate over the rate of the branch."""
FREE_TOLERANCE = 1e-14
"""Error allowed in one step of `free_rocking`: errors of one sign add up; this keeps the energy of an hour to 1e-8."""
CHUNK_STEPS = 7_000
"""Record steps given to a thread at a time, at least: few, because the batches of a scan are small."""
CHUNKS = 32
"""Slices of a large batch for each thread."""
MOST_EVENTS = 100_000
"""Events that `free_rocking` keeps."""


@dataclass(frozen=True, repr=False)
class Jobs(ShortRepr):
    """What to run, one entry per job.

    oscillator, motion : indices into the sequences given with the jobs [n]
    scale : factor on the motion; negative for the reversed polarity [n] [-]
    """

    oscillator: IntArray
    motion: IntArray
    scale: FloatArray


@dataclass(frozen=True, repr=False)
class Peaks(ShortRepr):
    """Largest response of each job [n].

    max_rotation : rotation of largest |rotation| / phi_ov, signed [rad]; if overturned, the rotation reached when
        the run ended, which is not a maximum
    max_ratio : |rotation| / phi_ov of its branch [-]; phi_ov is that of the equation used, and of rigid interfaces
    time_of_max : [s]; 0 if the body never moved
    impacts : until overturning, or until the free motion after the record has peaked on each side or come to rest
    overturned : whether it can no longer return; having passed phi_ov is not enough
    overturning_time : last upward passage of phi_ov [s]; nan where not overturned
    uplifted : whether it rocked at all
    """

    max_rotation: FloatArray
    max_ratio: FloatArray
    time_of_max: FloatArray
    impacts: IntArray
    overturned: BoolArray
    overturning_time: FloatArray
    uplifted: BoolArray


@dataclass(frozen=True, repr=False)
class Trace(ShortRepr):
    """A history at the samples of the record, up to overturning.

    time [s], rotation [rad], velocity [rad/s], signed.
    """

    time: FloatArray
    rotation: FloatArray
    velocity: FloatArray


@dataclass(frozen=True, repr=False)
class Events(ShortRepr):
    """The uplifts and impacts of a history, in their order [n].

    time [s]; impact : whether it is an impact, else an uplift
    velocity : before an impact, signed [rad/s], 0 at an uplift
    side : of the branch that ends at an impact or begins at an uplift: 0 positive, 1 negative
    """

    time: FloatArray
    impact: BoolArray
    velocity: FloatArray
    side: IntArray


@dataclass(frozen=True, repr=False)
class FreeRocking(ShortRepr):
    """Free motion after a release: instants of impacts and peaks [s], velocity before each impact [rad/s], peaks [rad].

    Signed by the side on which they occur. The release itself is not a peak.
    """

    impact_time: FloatArray
    impact_velocity: FloatArray
    peak_time: FloatArray
    peak_rotation: FloatArray


def product(oscillators: int, motions: int, scales: ArrayLike) -> Jobs:
    """Return jobs for every oscillator, motion and scale.

    Parameters
    ----------
    oscillators : how many
    motions : how many
    scales : factors of the motions [-]

    Returns
    -------
    Scales vary fastest, oscillators slowest.
    """
    factors = np.atleast_1d(np.asarray(scales, dtype=np.float64))
    o, m, s = np.meshgrid(np.arange(oscillators), np.arange(motions), np.arange(factors.size), indexing="ij")
    return Jobs(_frozen(o.ravel()), _frozen(m.ravel()), _frozen(factors[s.ravel()]))


def peaks(
    oscillators: Sequence[Oscillator],
    motions: Sequence[Record],
    jobs: Jobs,
    *,
    equation: Equation,
    threads: int = 0,
    tolerance: float = TOLERANCE,
) -> Peaks:
    """Return the largest response of every job.

    Parameters
    ----------
    oscillators, motions : what jobs name by their indices
    jobs : which oscillator, motion and scale to run
    equation : "exact" or "linearised"
    threads : number of threads, 0 for all cores; the result does not depend on it
    tolerance : error allowed in a step of the exact equation [-]; the linearised one has none

    Raises
    ------
    MechanismError : a branch that cannot rock
    ValueError : jobs with an unknown index or a scale that is not finite
    """
    return make_solver(oscillators, motions, equation=equation, threads=threads, tolerance=tolerance)(jobs)


def make_solver(
    oscillators: Sequence[Oscillator],
    motions: Sequence[Record],
    *,
    equation: Equation,
    threads: int = 0,
    tolerance: float = TOLERANCE,
) -> Callable[[Jobs], Peaks]:
    """Return a solver for these oscillators and motions; call it with Jobs to get Peaks.

    Parameters
    ----------
    oscillators, motions : what jobs name by their indices
    equation : "exact" or "linearised"
    threads : number of threads, 0 for all cores; the result does not depend on it
    tolerance : error allowed in a step of the exact equation [-]; the linearised one has none

    Raises
    ------
    MechanismError : a branch that cannot rock
    """
    if any(one.memory for one in oscillators):
        _require_exact(equation)
        from assess.dynamics.ties import make_tied_solver  # which builds on this file

        memories = [one.memory or Memory(one) for one in oscillators]
        solve = make_tied_solver(memories, motions, threads=threads, tolerance=tolerance)
        return lambda jobs: solve(jobs).peaks
    each = pack_all(oscillators, equation)
    run = _RUNS[equation](each, motions, tolerance)

    def answer(jobs: Jobs) -> Peaks:
        checked = checked_jobs(jobs, oscillators=len(oscillators), motions=len(motions))
        found = np.empty((checked.scale.size, columns.FOUND))

        def work(part: slice) -> None:
            path, events = np.empty((0, 3)), np.zeros((1, 4))
            run(checked.oscillator[part], checked.motion[part], checked.scale[part], 0.0, found[part], path, events)

        share_out(work, checked, motions, threads=threads)
        return peaks_found(found, checked, oscillators, each)

    return answer


def share_out(work: Callable[[slice], None], jobs: Jobs, motions: Sequence[Record], *, threads: int) -> None:
    """Run `work` on slices of jobs, on a number of threads, 0 for all cores."""
    if threads == 1:
        work(slice(0, jobs.scale.size))
        return
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        list(pool.map(work, _job_slices(jobs, motions, threads=threads or os.cpu_count() or 1)))


def trace(
    oscillator: Oscillator,
    motion: Record,
    *,
    scale: float,
    equation: Equation,
    release: float = 0.0,
    tolerance: float = TOLERANCE,
) -> Trace:
    """Return the history of one oscillator under one motion at its samples, up to overturning.

    Parameters
    ----------
    oscillator, motion : the mechanism and the ground motion
    scale : factor on the motion, negative for the reversed polarity [-]
    equation : "exact" or "linearised"
    release : rotation of the positive branch from which it is released without velocity [rad]; 0: from rest
    tolerance : error allowed in a step of the exact equation [-]
    """
    return _trace(oscillator, motion, scale, equation, tolerance, release=release, capacity=0)[0]


def trace_with_events(
    oscillator: Oscillator, motion: Record, *, scale: float, equation: Equation, tolerance: float = TOLERANCE
) -> tuple[Trace, Events]:
    """Return the history of one oscillator from rest at its samples, with the uplifts and impacts between them.

    Parameters
    ----------
    oscillator, motion : the mechanism and the ground motion
    scale : factor on the motion, negative for the reversed polarity [-]
    equation : "exact" or "linearised"
    tolerance : error allowed in a step of the exact equation [-]
    """
    return _trace(oscillator, motion, scale, equation, tolerance, release=0.0, capacity=MOST_EVENTS)


def free_rocking(
    oscillator: Oscillator,
    *,
    rotation: float,
    duration: float,
    equation: Equation = "exact",
    tolerance: float = FREE_TOLERANCE,
) -> FreeRocking:
    """Return the free motion on still ground after a release without velocity.

    Parameters
    ----------
    oscillator : the mechanism
    rotation : of the positive branch at the release [rad]
    duration : of the motion [s]
    equation : "exact" or "linearised"
    tolerance : error allowed in a step of the exact equation [-]
    """
    one = pack(oscillator, equation)
    samples = 2 + math.ceil(4.0 * one.branches[0, columns.RATE] * duration)
    still = make_record("still ground", np.zeros(samples), duration / (samples - 1))
    run = _RUNS[equation]([one], [still], tolerance)
    first, events = np.zeros(1, dtype=np.int64), np.zeros((MOST_EVENTS + 1, 4))
    run(
        first,
        first,
        np.ones(1),
        _release_coordinate(one, rotation),
        np.empty((1, columns.FOUND)),
        np.empty((0, 3)),
        events,
    )
    happened = events[1 : 1 + int(events[0, 0])]
    time, kind, value, on = happened[happened[:, columns.HAPPENED] <= duration].T  # the last swing goes to its peak
    impact, peak = kind == columns.IMPACT, kind == columns.PEAK
    signed = value.copy()
    for side, coordinate in enumerate(one.sides):
        sign = 1.0 - 2.0 * side
        signed[peak & (on == side)] = sign * coordinate.rotation(value[peak & (on == side)])
        signed[impact & (on == side)] = sign * coordinate.turn * value[impact & (on == side)]
    return FreeRocking(_frozen(time[impact]), _frozen(signed[impact]), _frozen(time[peak]), _frozen(signed[peak]))


def _trace(
    oscillator: Oscillator,
    motion: Record,
    scale: float,
    equation: Equation,
    tolerance: float,
    *,
    release: float,
    capacity: int,
) -> tuple[Trace, Events]:
    """Run one job and return its samples, and as many of its events as there is room for."""
    if oscillator.memory is not None:
        _require_exact(equation)
        if release:
            raise MechanismError("a mechanism with ties that stretch is released from rest only")
        from assess.dynamics.ties import tied_trace  # which builds on this file

        found, _, happened = tied_trace(oscillator.memory, motion, scale=scale, tolerance=tolerance, capacity=capacity)
        return found, happened
    one = pack(oscillator, equation)
    run = _RUNS[equation]([one], [motion], tolerance)
    path, events = np.zeros((motion.npts, 3)), np.zeros((capacity + 1, 4))
    first = np.zeros(1, dtype=np.int64)
    start = _release_coordinate(one, release) if release else 0.0
    samples = run(first, first, np.array([scale]), start, np.empty((1, columns.FOUND)), path, events)
    traced = trace_found(motion, one, path[:samples])
    return traced, events_found(events[1 : 1 + int(events[0, 0])], one)


def _require_exact(equation: Equation) -> None:
    """Raise MechanismError for the linearised equation, which knows no tie that stretches."""
    if equation != "exact":
        raise MechanismError('ties that stretch need the exact equation; write [analysis] equation = "exact"')


def trace_found(motion: Record, one: PackedOscillator, path: FloatArray) -> Trace:
    """Return the samples of the kernel as a history; path: y, y' and the side at each [n, 3]."""
    y, v, on = path.T
    rotation, velocity = np.zeros(y.size), np.zeros(y.size)
    for side, coordinate in enumerate(one.sides):
        here, sign = on == side, 1.0 - 2.0 * side
        rotation[here], velocity[here] = (
            sign * coordinate.rotation(y[here]),
            sign * coordinate.velocity(y[here], v[here]),
        )
    return Trace(_frozen(motion.time[: y.size]), _frozen(rotation), _frozen(velocity))


def events_found(happened: FloatArray, one: PackedOscillator) -> Events:
    """Return the uplifts and impacts among the events of the kernel [n, 4]."""
    time, kind, value, on = happened[happened[:, columns.KIND] != columns.PEAK].T
    velocity = np.zeros(time.size)
    for side, coordinate in enumerate(one.sides):
        here = (on == side) & (kind == columns.IMPACT)
        velocity[here] = (1.0 - 2.0 * side) * coordinate.turn * value[here]
    return Events(
        _frozen(time.copy()), _frozen(kind == columns.IMPACT), _frozen(velocity), _frozen(on.astype(np.int64))
    )


def motion_arrays(motions: Sequence[Record]) -> tuple[FloatArray, IntArray, FloatArray, IntArray, FloatArray]:
    """Return all accelerations end to end and where each starts (the last ends), the same of their extremes, and dt."""
    offset = np.cumsum([0, *(motion.npts for motion in motions)], dtype=np.int64)
    ground = np.concatenate([np.empty(0), *(motion.acceleration for motion in motions)])
    each = [_extremes(motion.acceleration) for motion in motions]
    block_offset = np.cumsum([0, *map(len, each)], dtype=np.int64)
    return ground, offset, np.concatenate([np.empty((0, 2)), *each]), block_offset, np.array([m.dt for m in motions])


def _extremes(acceleration: FloatArray) -> FloatArray:
    """Return the least and the largest sample, both ends included, of every whole block of intervals [blocks, 2]."""
    n, size = (acceleration.size - 1) // columns.BLOCK, columns.BLOCK
    inner, end = acceleration[: n * size].reshape(n, size), acceleration[size : n * size + 1 : size]
    return np.stack([np.minimum(inner.min(axis=1), end), np.maximum(inner.max(axis=1), end)], axis=1)


def _release_coordinate(one: PackedOscillator, rotation: float) -> float:
    """Return the y of the kernel at a rotation of the positive branch [rad], which must be positive."""
    if not 0.0 < rotation < math.inf:
        raise ValueError(f"release at {rotation} rad; it must be a positive rotation of the positive branch")
    return one.sides[0].coordinate(rotation)


def _linearised(oscillators: Sequence[PackedOscillator], motions: Sequence[Record], tolerance: float) -> RunHistory:
    """Return the linearised kernel with oscillators and motions filled in; it has no error to tolerate."""
    from assess.dynamics.kernel import linearised  # brings numba

    return partial(
        linearised.rock_linearised,
        branches_of(oscillators),
        *motion_arrays(motions),
        np.array([m.pga for m in motions]),
    )


def _exact(oscillators: Sequence[PackedOscillator], motions: Sequence[Record], tolerance: float) -> RunHistory:
    """Return the exact kernel with oscillators and motions filled in."""
    from assess.dynamics.kernel import exact  # brings numba

    tables = tables_of(oscillators)
    ground, offset, blocks, block_offset, dt = motion_arrays(motions)
    return partial(
        exact.rock_exact, branches_of(oscillators), *tables, tolerance, ground, offset, blocks, block_offset, dt
    )


_RUNS: dict[Equation, Callable[[Sequence[PackedOscillator], Sequence[Record], float], RunHistory]] = {
    "exact": _exact,
    "linearised": _linearised,
}


def checked_jobs(jobs: Jobs, *, oscillators: int, motions: int) -> Jobs:
    """Return the jobs as arrays of the kernel's types, checked for unknown indices and scales that are not finite."""
    checked = Jobs(
        kernel_array(jobs.oscillator, np.int64),
        kernel_array(jobs.motion, np.int64),
        kernel_array(jobs.scale, np.float64),
    )
    check_jobs(
        {"oscillator": (checked.oscillator, oscillators), "motion": (checked.motion, motions)},
        name="scale",
        number=checked.scale,
    )
    return checked


def _job_slices(jobs: Jobs, motions: Sequence[Record], *, threads: int) -> list[slice]:
    """Return slices of consecutive jobs of about CHUNK_STEPS record steps; of many jobs CHUNKS for each thread.

    After each slice a thread waits for the interpreter's lock, which another may keep while it builds what comes next.
    """
    steps = np.cumsum(np.array([motion.npts for motion in motions], dtype=np.int64)[jobs.motion])
    chunk = steps // max(CHUNK_STEPS, int(steps[-1:].sum()) // (CHUNKS * threads))
    cuts = [0, *(np.flatnonzero(np.diff(chunk)) + 1).tolist(), jobs.scale.size]
    return [slice(first, last) for first, last in pairwise(cuts) if last > first]


def peaks_found(
    found: FloatArray, jobs: Jobs, oscillators: Sequence[Oscillator], each: Sequence[PackedOscillator]
) -> Peaks:
    """Return the rows of the kernel as named columns, of the side with the larger ratio."""
    ratio, rotation, time = np.zeros((3, jobs.scale.size))
    for number in np.unique(jobs.oscillator):
        here = np.flatnonzero(jobs.oscillator == number)
        for side, (branch, of) in enumerate(zip(oscillators[number].branches, each[number].sides, strict=True)):
            reached = of.rotation(found[here, columns.LARGEST + side])
            share = reached / (of.rotation(np.ones(1)) * branch.overturning / branch.unstable)
            larger = share > ratio[here]
            at = here[larger]
            ratio[at], rotation[at] = share[larger], (1 - 2 * side) * reached[larger]
            time[at] = found[at, columns.WHEN + side]
    overturned = found[:, columns.OVERTURNED] > 0.0
    return Peaks(
        _frozen(rotation),
        _frozen(ratio),
        _frozen(time),
        _frozen(found[:, columns.IMPACTS].astype(np.int64)),
        _frozen(overturned),
        _frozen(np.where(overturned, found[:, columns.PASSED], np.nan)),
        _frozen(found[:, columns.UPLIFTED] > 0.0),
    )


def _frozen(array: Array) -> Array:
    """Return the array, read-only."""
    array.flags.writeable = False
    return array
