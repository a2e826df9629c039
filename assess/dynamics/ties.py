"""Rocking histories of mechanisms with memory: ties that yield, slacken and break, and friction of side walls.

A tie of elongation e (phi) pulls with N = k (e - e_p), between zero and its yield force, where e_p is its plastic
elongation so far; at `gone` it breaks, or its anchor fails, for good. By virtual work it adds N de/dphi to the
restoring moment. Friction adds its moment where the mechanism opens farther than ever before, and nothing elsewhere: a
mechanism that has stopped there is held until the ground overcomes it, or the mechanism alone would turn back.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from assess.dynamics import history
from assess.dynamics.history import TOLERANCE, Events, Jobs, Peaks, Trace
from assess.dynamics.kernel import columns
from assess.dynamics.packing import PackedOscillator, branches_of, pack_all, tables_of
from assess.oscillator import Memory
from assess.short_repr import ShortRepr
from records.record import Record
from spectra.arrays import BoolArray, FloatArray, IntArray

if TYPE_CHECKING:
    from scipy.interpolate import CubicHermiteSpline, CubicSpline

FIRST_TIE = 5  # column of the kernel's path
RunTied = Callable[[IntArray, IntArray, FloatArray, FloatArray, FloatArray, FloatArray, FloatArray], int]


@dataclass(frozen=True, repr=False)
class TiedPeaks(ShortRepr):
    """Largest responses, ratios of the bare overturning rotation, and what is left of each tie.

    plastic : plastic elongation [jobs, ties] [m]; broken : whether it is gone [jobs, ties]
    """

    peaks: Peaks
    plastic: FloatArray
    broken: BoolArray


@dataclass(frozen=True, repr=False)
class Traces(ShortRepr):
    """What a history has left behind it, at the samples of its record.

    plastic : elongation of each tie [n, ties] [m], infinite once it is gone; of one that yields that of the last peak
    reached : largest rotation of each side at its peaks so far [n, sides] [rad]
    """

    plastic: FloatArray
    reached: FloatArray


def tied_peaks(
    oscillators: Sequence[Memory], motions: Sequence[Record], jobs: Jobs, *, tolerance: float = TOLERANCE
) -> TiedPeaks:
    """Return the largest response of every job, by the exact equation, with what is left of the ties.

    Parameters
    ----------
    oscillators, motions : what jobs name by their indices
    jobs : which oscillator, motion and scale to run
    tolerance : error allowed in a step [-]

    Raises
    ------
    MechanismError : a branch that cannot rock
    """
    return make_tied_solver(oscillators, motions, threads=1, tolerance=tolerance)(jobs)


def make_tied_solver(
    oscillators: Sequence[Memory], motions: Sequence[Record], *, threads: int, tolerance: float = TOLERANCE
) -> Callable[[Jobs], TiedPeaks]:
    """Return a solver for these oscillators and motions; call it with Jobs.

    Parameters
    ----------
    oscillators, motions : what jobs name by their indices
    threads : number of threads, 0 for all cores; the result does not depend on it
    tolerance : error allowed in a step [-]
    """
    each = _packed(oscillators)
    run = _solver(oscillators, each, motions, tolerance)

    def answer(jobs: Jobs) -> TiedPeaks:
        checked = history.checked_jobs(jobs, oscillators=len(oscillators), motions=len(motions))
        found = np.empty((checked.scale.size, columns.FOUND))
        plastic = np.zeros((checked.scale.size, _most_ties(oscillators)))

        def work(part: slice) -> None:
            path, events = np.empty((0, FIRST_TIE + plastic.shape[1])), np.zeros((1, 4))
            which = checked.oscillator[part], checked.motion[part], checked.scale[part]
            run(*which, found[part], plastic[part], path, events)

        history.share_out(work, checked, motions, threads=threads)
        return TiedPeaks(
            history.peaks_found(found, checked, [one.bare for one in oscillators], each),
            np.where(np.isfinite(plastic), plastic, np.nan),
            np.isinf(plastic),
        )

    return answer


def tied_trace(
    oscillator: Memory, motion: Record, *, scale: float, tolerance: float = TOLERANCE, capacity: int = 0
) -> tuple[Trace, Traces, Events]:
    """Return the history at the samples of the record, what it has left there, and its events.

    Parameters
    ----------
    oscillator, motion : the mechanism and the ground motion
    scale : factor on the motion, negative for the reversed polarity [-]
    tolerance : error allowed in a step [-]
    capacity : most events that are kept
    """
    (one,) = _packed([oscillator])
    run = _solver([oscillator], [one], [motion], tolerance)
    first, ties = np.zeros(1, dtype=np.int64), _most_ties([oscillator])
    path, events = np.zeros((motion.npts, FIRST_TIE + ties)), np.zeros((capacity + 1, 4))
    path[0, 2] = -1.0
    found, plastic = np.empty((1, columns.FOUND)), np.zeros((1, ties))
    samples = run(first, first, np.array([scale]), found, plastic, path, events)
    happened = history.events_found(events[1 : 1 + int(events[0, 0])], one)
    reached = np.stack([side.rotation(path[:samples, 3 + k]) for k, side in enumerate(one.sides)], axis=1)
    left = Traces(path[:samples, FIRST_TIE:], reached)
    return history.trace_found(motion, one, path[:samples, :3]), left, happened


def memory_energy(oscillator: Memory, path: Trace, left: Traces) -> FloatArray:
    """Return what ties and friction have taken up since rest, for good or not, at the samples of a history [n] [J].

    Parameters
    ----------
    oscillator, path : the mechanism and its history
    left : what it has left at its samples, as `tied_trace` gives it
    """
    total = np.zeros(path.time.size)
    sides = [path.rotation < 0.0 if side else path.rotation >= 0.0 for side in range(len(oscillator.bare.branches))]
    for number, tie in enumerate(oscillator.ties):
        e = np.empty(path.time.size)
        for side, (here, branch) in enumerate(zip(sides, oscillator.bare.branches, strict=True)):
            shape = _cubic_spline(branch.rotation, tie.elongation[side], tie.rate[side])
            e[here] = shape(np.abs(path.rotation[here]))
        k, most, plastic = tie.stiffness, tie.strength, left.plastic[:, number]
        gone = np.isinf(plastic) | (e >= tie.gone)
        kept = np.where(gone, max(tie.gone - most / k, 0.0), np.maximum(plastic, e - most / k))
        pull = np.where(gone, min(most, k * tie.gone), np.clip(k * (e - kept), 0.0, most))
        total += pull**2 / (2 * k) + most * kept - tie.energy_at_rest
    for side, moment in enumerate(oscillator.friction):
        rotation = oscillator.bare.branches[side].rotation
        rubbed = _spline_of(rotation, moment).antiderivative()
        total += rubbed(np.maximum(left.reached[:, side], np.where(sides[side], np.abs(path.rotation), 0.0)))
    return total


def _packed(oscillators: Sequence[Memory]) -> list[PackedOscillator]:
    """Pack the bare oscillators; each side has a table of its own, as ties differ where the body is alike."""
    found = pack_all([one.bare for one in oscillators], "exact")
    return [replace(one, sides=tuple(replace(side) for side in one.sides)) for one in found]


def _most_ties(oscillators: Sequence[Memory]) -> int:
    return max((len(one.ties) for one in oscillators), default=0)


def _solver(
    oscillators: Sequence[Memory],
    each: Sequence[PackedOscillator],
    motions: Sequence[Record],
    tolerance: float,
) -> RunTied:
    """Return the kernel with oscillators and motions filled in."""
    from assess.dynamics.kernel import ties  # brings numba

    table, smooth, spans = tables_of(each)
    most = _most_ties(oscillators)
    laws = np.zeros((len(each), 2, most, ties.LAW))
    laws[..., ties.YIELD], laws[..., ties.GONE] = 1.0, math.inf
    elongation, friction = np.zeros((most, len(table), 4)), np.zeros((len(table), 4))
    elongation[:, :, 3] = -1.0  # of ties that others have more of: always slack
    for number, (of, packed) in enumerate(zip(oscillators, each, strict=True)):
        for side, (branch, canonical) in enumerate(zip(of.bare.branches, packed.sides, strict=True)):
            first, last = spans[number, side]
            keep = np.r_[True, np.diff(branch.rotation) > 0.0]
            over_y = canonical.back(canonical.y, 1)  # dphi / dy
            scale = branch.inertia[0] * canonical.turn**2
            for k, tie in enumerate(of.ties):
                laws[number, side, k] = tie.stiffness / scale, tie.strength / tie.stiffness, tie.gone
                e, rate = tie.elongation[side][keep], tie.rate[side][keep] * over_y
                elongation[k, first : last + 1] = _cubics(canonical.y, e, rate)
            if of.friction:
                moment = of.friction[side][keep] * over_y / scale
                friction[first : last + 1] = _spline_of(canonical.y, moment).c.T
    return partial(
        ties.rock_with_memory, branches_of(each), table, smooth, spans, laws, elongation, friction, tolerance,
        *history.motion_arrays(motions),
    )  # fmt: skip


def _cubics(y: FloatArray, value: FloatArray, slope: FloatArray) -> FloatArray:
    """Return the cubics through values and slopes at y [n], highest power first [n - 1, 4]."""
    return np.ascontiguousarray(_cubic_spline(y, value, slope).c.T)


def _spline_of(x: FloatArray, value: FloatArray) -> CubicSpline:
    """Return the smooth spline through values at x [n], of which two alike are one."""
    from scipy.interpolate import CubicSpline

    keep = np.r_[True, np.diff(x) > 0.0]
    return CubicSpline(x[keep], value[keep])


def _cubic_spline(x: FloatArray, value: FloatArray, slope: FloatArray) -> CubicHermiteSpline:
    """Return the spline through values and slopes at x [n], of which two alike are one."""
    from scipy.interpolate import CubicHermiteSpline

    keep = np.r_[True, np.diff(x) > 0.0]
    return CubicHermiteSpline(x[keep], value[keep], slope[keep])
