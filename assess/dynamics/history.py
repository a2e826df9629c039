"""Rocking time histories: oscillators under ground motions.

A job is one oscillator under one motion times one signed scale, whose sign is the polarity. `peaks` answers many jobs
on all cores, `trace` gives one history sample by sample, `free_rocking` releases a body from rest. The equation is
"exact" (the branch tables) or "linearised" (thesis 3.9). Between samples the ground acceleration is linear; after the
record the body goes on in free motion until no later peak can be larger, and that peak counts.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Literal, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.constants import g

from assess.dynamics import kernel
from assess.errors import MechanismError
from assess.oscillator import Branch, Oscillator, energy, interpolant, linearise
from records.record import Record, make_record

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
Array = TypeVar("Array", FloatArray, IntArray, BoolArray)
Equation = Literal["exact", "linearised"]
Run = Callable[[IntArray, IntArray, FloatArray, float, FloatArray, FloatArray, FloatArray], int]

TOLERANCE = 1e-11
"""Error allowed to one step of the exact equation, of phi / phi_ov and of its rate over the branch's own rate."""
SAME = 1e-10
"""Of the largest value of a table: less than this between two nodes at one rotation is rounding, and no jump."""
CHUNK_STEPS = 500_000
"""Record steps given to a thread at a time."""
MOST_EVENTS = 100_000
"""Events that `free_rocking` keeps."""


@dataclass(frozen=True)
class Jobs:
    """What to run, one entry per job.

    oscillator, motion : indices into the sequences given beside [n]
    scale : factor on the motion; negative for the reversed polarity [n] [-]
    """

    oscillator: IntArray
    motion: IntArray
    scale: FloatArray


@dataclass(frozen=True)
class Peaks:
    """Largest response of each job [n].

    Attributes
    ----------
    max_rotation : rotation of largest |rotation| / phi_ov, signed [rad]; where overturned, what was reached before
        the run ended (meaningless as a maximum)
    max_ratio : |rotation| / phi_ov of its branch [-]; phi_ov is that of the equation used, and of rigid interfaces
    time_of_max : [s]; 0 where the body never moved
    impacts : until overturning, or until the free motion after the record has peaked on each side or come to rest
    overturned : it can no longer return; having been beyond phi_ov is not enough
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


@dataclass(frozen=True)
class Trace:
    """A history at the record's samples, as far as overturning.

    time [s], rotation [rad], velocity [rad/s], signed.
    """

    time: FloatArray
    rotation: FloatArray
    velocity: FloatArray


@dataclass(frozen=True)
class FreeRocking:
    """Free motion after a release: instants of impacts and peaks [s], velocity before each impact [rad/s], peaks [rad].

    Signed by the side they happen on. The release itself is no peak.
    """

    impact_time: FloatArray
    impact_velocity: FloatArray
    peak_time: FloatArray
    peak_rotation: FloatArray


def product(oscillators: int, motions: int, scales: ArrayLike) -> Jobs:
    """Every oscillator under every motion at every scale: scales vary fastest, oscillators slowest."""
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
    progress: Callable[[int], None] | None = None,
) -> Peaks:
    """Largest response of every job; the same whatever the number of `threads` (0: all cores).

    tolerance : error allowed to a step of the exact equation [-]; the linearised one has none
    progress : called with the number of jobs done so far, from this thread

    Raises ValueError for jobs that name no oscillator or motion, MechanismError for a branch that cannot rock.
    """
    checked = _checked(jobs, oscillators=len(oscillators), motions=len(motions))
    run = _run(oscillators, motions, equation=equation, tolerance=tolerance)
    found = np.empty((checked.scale.size, 7))

    def work(part: slice) -> int:
        path, events = np.empty((0, 2)), np.zeros((1, 3))
        run(checked.oscillator[part], checked.motion[part], checked.scale[part], 0.0, found[part], path, events)
        return int(part.stop)

    parts = _parts(checked, motions)
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        for done in pool.map(work, parts):
            if progress is not None:
                progress(done)
    return _peaks(
        found, checked, _overturning(oscillators, equation=equation), _reference(oscillators, equation=equation)
    )


def trace(
    oscillator: Oscillator, motion: Record, *, scale: float, equation: Equation, tolerance: float = TOLERANCE
) -> Trace:
    """History of one oscillator under `scale` times one motion, at the samples; it ends with overturning."""
    run = _run([oscillator], [motion], equation=equation, tolerance=tolerance)
    path = np.zeros((motion.npts, 2))
    first = np.zeros(1, dtype=np.int64)
    samples = run(first, first, np.array([scale]), 0.0, np.empty((1, 7)), path, np.zeros((1, 3)))
    return Trace(_frozen(motion.time[:samples]), _frozen(path[:samples, 0].copy()), _frozen(path[:samples, 1].copy()))


def free_rocking(
    oscillator: Oscillator,
    *,
    rotation: float,
    duration: float,
    equation: Equation = "exact",
    tolerance: float = TOLERANCE,
) -> FreeRocking:
    """Released from rest at `rotation` [rad] of the positive branch, for `duration` [s] on still ground."""
    branch = _BRANCHES[equation](oscillator)[0]
    samples = 2 + math.ceil(4.0 * branch[kernel.RATE] * duration)
    still = make_record("still ground", np.zeros(samples), duration / (samples - 1))
    run = _run([oscillator], [still], equation=equation, tolerance=tolerance)
    first, events = np.zeros(1, dtype=np.int64), np.zeros((MOST_EVENTS + 1, 3))
    run(first, first, np.ones(1), rotation / branch[kernel.OVERTURNING], np.empty((1, 7)), np.empty((0, 2)), events)
    happened = events[1 : 1 + int(events[0, 0])]
    happened = happened[happened[:, 0] <= duration]  # the kernel follows the last swing to its peak
    impact, peak = happened[:, 1] == kernel.IMPACT, happened[:, 1] == kernel.PEAK
    return FreeRocking(
        _frozen(happened[impact, 0]),
        _frozen(happened[impact, 2]),
        _frozen(happened[peak, 0]),
        _frozen(happened[peak, 2]),
    )


def _exact_branches(oscillator: Oscillator) -> FloatArray:
    """The columns of `kernel.branch` [2, 7] by the tables; the end of a table means overturned."""
    rows = _rows(oscillator, [branch.unstable for branch in oscillator.branches])
    for row, branch in zip(rows, oscillator.branches, strict=False):
        phi_ov, E = branch.unstable, float(energy(branch, np.array(branch.unstable)))
        row[kernel.THRESHOLD] = branch.restoring[0] / branch.excitation[0]
        row[kernel.RATE] = (
            math.sqrt(2.0 * _positive(E, "work up to the overturning rotation", "J") / branch.inertia[0]) / phi_ov
        )
        row[[kernel.LIMIT, kernel.TAIL_LIMIT]] = branch.rotation[-1] / phi_ov
    return rows


def _linearised_branches(oscillator: Oscillator) -> FloatArray:
    """The columns of `kernel.branch` [2, 7] by the linearised equation; LIMIT depends on the job."""
    forms = [linearise(branch) for branch in oscillator.branches]
    for form in forms:
        _positive(form.stiffness, "linearised stiffness K at phi_cr", "N m/rad")
        _positive(form.overturning, "linearised overturning rotation", "rad")
    rows = _rows(oscillator, [form.overturning for form in forms])
    for row, form in zip(rows, forms, strict=False):
        row[kernel.THRESHOLD], row[kernel.RATE] = g * form.multiplier, form.p
        row[[kernel.LIMIT, kernel.TAIL_LIMIT]] = 1.0
    return rows


_BRANCHES: dict[Equation, Callable[[Oscillator], FloatArray]] = {
    "exact": _exact_branches,
    "linearised": _linearised_branches,
}


def _rows(oscillator: Oscillator, overturning: list[float]) -> FloatArray:
    """What the two equations share: phi_ov, restitution, and the branch that follows an impact."""
    rows = np.zeros((2, 7))
    rows[:, kernel.THRESHOLD] = math.inf  # a side that is not there never lifts
    for side, branch in enumerate(oscillator.branches):
        partner = 1 - side if oscillator.negative is not None else side
        _check_branch(branch, following=oscillator.branches[partner])
        rows[side, kernel.OVERTURNING] = overturning[side]
        rows[side, kernel.BOUNCE] = branch.restitution * overturning[side] / overturning[partner]
        rows[side, kernel.PARTNER] = partner
    return rows


def _check_branch(branch: Branch, *, following: Branch) -> None:
    """A branch that can rock: it rests on still ground, has mass, and an impact adds no energy."""
    _positive(float(branch.unstable), "overturning rotation", "rad")
    _positive(float(np.min(branch.inertia)), "least inertia", "kg m2")
    _positive(float(branch.excitation[0]), "excitation at rest", "kg m")
    if branch.restoring[0] < 0.0:
        raise MechanismError(
            f"a branch has restoring moment {branch.restoring[0]:.6g} N m at rest, so it is already falling; "
            "look at its loads and hinges"
        )
    most = max(1.0, math.sqrt(branch.inertia[0] / following.inertia[0]))  # turning faster about a nearer hinge
    if not 0.0 <= branch.restitution <= most * (1.0 + 1e-9):
        raise MechanismError(f"a branch has restitution {branch.restitution:.6g}; it must be between 0 and {most:.6g}")


def _positive(value: float, name: str, unit: str) -> float:
    """The value, if it is a positive number."""
    if not value > 0.0:
        raise MechanismError(
            f"a branch has {name} {value:.6g} {unit}, which must be positive for it to rock; "
            "look at its loads and hinges"
        )
    return value


def _overturning(oscillators: Sequence[Oscillator], *, equation: Equation) -> FloatArray:
    """phi_ov of both sides by the equation used [oscillators, 2] [rad]; 0 for a side that is not there."""
    return np.array([_BRANCHES[equation](o)[:, kernel.OVERTURNING] for o in oscillators]).reshape(-1, 2)


def _reference(oscillators: Sequence[Oscillator], *, equation: Equation) -> FloatArray:
    """phi_ov that ratios are given by [oscillators, 2] [rad]: that of the equation as it is with rigid interfaces."""
    rigid = [[b.overturning / b.unstable for b in o.branches] + [0.0] * (2 - len(o.branches)) for o in oscillators]
    return np.asarray(_overturning(oscillators, equation=equation) * np.reshape(rigid, (-1, 2)))


def _motions(motions: Sequence[Record]) -> tuple[FloatArray, IntArray, FloatArray, FloatArray]:
    """All accelerations end to end, where each starts (and the last ends), their steps and peaks."""
    offset = np.cumsum([0, *(motion.npts for motion in motions)], dtype=np.int64)
    ground = np.concatenate([np.empty(0), *(motion.acceleration for motion in motions)])
    return ground, offset, np.array([m.dt for m in motions]), np.array([m.pga for m in motions])


def _linearised_run(oscillators: Sequence[Oscillator], motions: Sequence[Record], tolerance: float) -> Run:
    """The linearised kernel with oscillators and motions filled in; it makes no error to tolerate."""
    branches = np.array([_linearised_branches(o) for o in oscillators]).reshape(-1, 2, 7)
    return partial(kernel.rock_linearised, branches, *_motions(motions))


def _exact_run(oscillators: Sequence[Oscillator], motions: Sequence[Record], tolerance: float) -> Run:
    """The exact kernel with oscillators and motions filled in."""
    branches = np.array([_exact_branches(o) for o in oscillators]).reshape(-1, 2, 7)
    table, smooth, spans = _tables(oscillators)
    ground, offset, dt, _ = _motions(motions)
    return partial(kernel.rock_exact, branches, table, smooth, spans, tolerance, ground, offset, dt)


_EQUATIONS: dict[Equation, Callable[[Sequence[Oscillator], Sequence[Record], float], Run]] = {
    "exact": _exact_run,
    "linearised": _linearised_run,
}


def _run(oscillators: Sequence[Oscillator], motions: Sequence[Record], *, equation: Equation, tolerance: float) -> Run:
    """The kernel of `equation`, ready for jobs."""
    if equation not in _EQUATIONS:
        raise ValueError(f'equation "{equation}" is not known; the equations are {", ".join(_EQUATIONS)}')
    return _EQUATIONS[equation](oscillators, motions, tolerance)


def _tables(oscillators: Sequence[Oscillator]) -> tuple[FloatArray, IntArray, IntArray]:
    """The cubics of all branches [segments, 14] over phi / phi_ov, and the segments of each smooth piece and branch."""
    rows, smooth, spans, start = [], [], np.zeros((len(oscillators), 2, 2), dtype=np.int64), 0
    for o, oscillator in enumerate(oscillators):
        for side, branch in enumerate(oscillator.branches):
            rows.append(_segments(branch))
            smooth.append(start + _smooth(branch))
            spans[o, side] = start, start + branch.rotation.size - 2
            start += branch.rotation.size - 1
    empty = np.empty((0, 14)), np.empty((0, 2), dtype=np.int64)
    return np.concatenate([empty[0], *rows]), np.concatenate([empty[1], *smooth]), spans


def _segments(branch: Branch) -> FloatArray:
    """Ends and cubics of each segment [segments, 14], for y = phi / phi_ov.

    I y'' + 1/2 I' y'^2 + R / phi_ov = -B / phi_ov a
    """
    phi_ov = branch.unstable
    rows = np.empty((branch.rotation.size - 1, 14))
    rows[:, kernel.LEFT], rows[:, kernel.RIGHT] = branch.rotation[:-1] / phi_ov, branch.rotation[1:] / phi_ov
    powers = phi_ov ** np.arange(3.0, -1.0, -1.0)[:, None]
    for first, values, factor in (
        (kernel.R3, branch.restoring, 1.0 / phi_ov),
        (kernel.B3, branch.excitation, 1.0 / phi_ov),
        (kernel.I3, branch.inertia, 1.0),
    ):
        rows[:, first : first + 4] = (interpolant(branch.rotation, values).c * powers * factor).T
    return rows


def _smooth(branch: Branch) -> IntArray:
    """First and last segment of the piece between jumps that each segment lies in [segments, 2].

    Where two nodes at one rotation have the same values, but for rounding, there is a kink and no jump: steps may pass.
    """
    width = np.diff(branch.rotation)
    index = np.arange(width.size)
    columns = np.array([branch.restoring, branch.excitation, branch.inertia])
    leaps = np.abs(np.diff(columns)) > SAME * np.abs(columns).max(axis=1, keepdims=True)
    jumps = np.flatnonzero((width == 0.0) & leaps.any(axis=0))
    before, after = np.searchsorted(jumps, index, side="right") - 1, np.searchsorted(jumps, index)
    first = np.where(before >= 0, np.r_[jumps, 0][before] + 1, 0)
    last = np.where(after < jumps.size, np.r_[jumps, 0][after] - 1, width.size - 1)
    return np.stack([first, last], axis=1).astype(np.int64)


def _checked(jobs: Jobs, *, oscillators: int, motions: int) -> Jobs:
    """The jobs as arrays of the kernel's types, if every index names something and every scale is a number."""
    checked = Jobs(
        np.ascontiguousarray(jobs.oscillator, dtype=np.int64),
        np.ascontiguousarray(jobs.motion, dtype=np.int64),
        np.ascontiguousarray(jobs.scale, dtype=np.float64),
    )
    if not checked.oscillator.shape == checked.motion.shape == checked.scale.shape == (checked.scale.size,):
        raise ValueError(
            f"jobs: {checked.oscillator.shape} oscillators, {checked.motion.shape} motions and {checked.scale.shape} "
            "scales; give one of each for every job"
        )
    for name, index, count in (("oscillator", checked.oscillator, oscillators), ("motion", checked.motion, motions)):
        bad = np.flatnonzero((index < 0) | (index >= count))
        if bad.size:
            raise ValueError(f"jobs[{bad[0]}]: {name} {index[bad[0]]}, but there are {count}; count them from 0")
    bad = np.flatnonzero(~np.isfinite(checked.scale))
    if bad.size:
        raise ValueError(f"jobs[{bad[0]}]: scale {checked.scale[bad[0]]}; it must be a finite number")
    return checked


def _parts(jobs: Jobs, motions: Sequence[Record]) -> list[slice]:
    """Slices of consecutive jobs of about CHUNK_STEPS record steps."""
    steps = np.array([motion.npts for motion in motions])[jobs.motion]
    chunk = np.cumsum(steps) // CHUNK_STEPS
    cuts = [0, *(np.flatnonzero(np.diff(chunk)) + 1).tolist(), jobs.scale.size]
    return [slice(first, last) for first, last in pairwise(cuts) if last > first]


def _peaks(found: FloatArray, jobs: Jobs, overturning: FloatArray, reference: FloatArray) -> Peaks:
    """The kernel's rows as named columns."""
    side = found[:, kernel.SIDE].astype(np.int64)
    overturned = found[:, kernel.OVERTURNED] > 0.0
    rotation = found[:, kernel.RATIO] * overturning[jobs.oscillator, side]
    return Peaks(
        _frozen((1 - 2 * side) * rotation),
        _frozen(rotation / reference[jobs.oscillator, side]),
        _frozen(found[:, kernel.TIME].copy()),
        _frozen(found[:, kernel.IMPACTS].astype(np.int64)),
        _frozen(overturned),
        _frozen(np.where(overturned, found[:, kernel.PASSED], np.nan)),
        _frozen(found[:, kernel.UPLIFTED] > 0.0),
    )


def _frozen(array: Array) -> Array:
    """The array, read-only."""
    array.flags.writeable = False
    return array
