"""Rocking histories of mechanisms with memory: ties that yield, slacken and break, and friction of side walls.

A tie of elongation e (phi) pulls with N = k (e - e_p), between zero and its yield force, where e_p is its plastic
elongation so far; at `gone` it breaks, or its anchor fails, for good. By virtual work it adds N de/dphi to the
restoring moment. Friction adds its moment where the mechanism opens farther than ever before, and nothing elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from assess.dynamics import history
from assess.dynamics.history import TOLERANCE, Jobs, Peaks, Trace
from assess.dynamics.kernel import columns
from assess.dynamics.packing import PackedOscillator, branches_of, pack_all, tables_of
from assess.errors import MechanismError
from assess.oscillator import Oscillator
from assess.short_repr import ShortRepr
from records.record import Record
from spectra.arrays import BoolArray, FloatArray, IntArray

RunTied = Callable[[IntArray, IntArray, FloatArray, FloatArray, FloatArray, FloatArray], int]


@dataclass(frozen=True, repr=False)
class TieLaw(ShortRepr):
    """A tie on an oscillator.

    Attributes
    ----------
    stiffness : k, of bar and anchorage [N/m]
    strength : force at yield [N]
    gone : elongation at which it breaks or its anchor fails [m]; below strength / stiffness it never yields
    elongation, rate : e [m] and de/dphi [m] at the rotations of each branch, at rest what its pretension gives;
        the positive branch first [branches][n]
    """

    stiffness: float
    strength: float
    gone: float
    elongation: tuple[FloatArray, ...]
    rate: tuple[FloatArray, ...]

    def __post_init__(self) -> None:
        """Refuse what is no tie, or one that shortens again after it has yielded."""
        for name in ("stiffness", "strength"):
            if not 0.0 < getattr(self, name) < math.inf:
                raise MechanismError(f"a tie has {name} {getattr(self, name):.6g}; it must be positive and finite")
        for e, rate in zip(self.elongation, self.rate, strict=True):
            if (rate[e > self.strength / self.stiffness] <= 0.0).any():
                raise MechanismError(
                    "a tie yields and then shortens again before the mechanism overturns, which histories do not "
                    "follow: look at its anchor"
                )


@dataclass(frozen=True, repr=False)
class TiedOscillator(ShortRepr):
    """A mechanism with memory.

    bare : without ties and friction
    ties : on it
    friction : moment of the side walls as the mechanism opens, at the rotations of each branch [branches][n] [N m];
        empty if there is none
    """

    bare: Oscillator
    ties: tuple[TieLaw, ...] = ()
    friction: tuple[FloatArray, ...] = ()


@dataclass(frozen=True, repr=False)
class TiedPeaks(ShortRepr):
    """Largest responses, ratios of the bare overturning rotation, and what is left of each tie.

    plastic : plastic elongation [jobs, ties] [m]; broken : whether it is gone [jobs, ties]
    """

    peaks: Peaks
    plastic: FloatArray
    broken: BoolArray


def tied_peaks(
    oscillators: Sequence[TiedOscillator], motions: Sequence[Record], jobs: Jobs, *, tolerance: float = TOLERANCE
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
    each = _packed(oscillators)
    run = _solver(oscillators, each, motions, tolerance)
    checked = history.checked_jobs(jobs, oscillators=len(oscillators), motions=len(motions))
    found = np.empty((checked.scale.size, columns.FOUND))
    plastic = np.zeros((checked.scale.size, _most_ties(oscillators)))
    run(checked.oscillator, checked.motion, checked.scale, found, plastic, np.empty((0, 3 + plastic.shape[1])))
    return TiedPeaks(
        history.peaks_found(found, checked, [one.bare for one in oscillators], each),
        np.where(np.isfinite(plastic), plastic, np.nan),
        np.isinf(plastic),
    )


def tied_trace(
    oscillator: TiedOscillator, motion: Record, *, scale: float, tolerance: float = TOLERANCE
) -> tuple[Trace, FloatArray]:
    """Return the history at the samples of the record, and the plastic elongation of each tie there [n, ties] [m].

    A tie that is gone has an infinite one.

    Parameters
    ----------
    oscillator, motion : the mechanism and the ground motion
    scale : factor on the motion, negative for the reversed polarity [-]
    tolerance : error allowed in a step [-]
    """
    (one,) = _packed([oscillator])
    run = _solver([oscillator], [one], [motion], tolerance)
    first, ties = np.zeros(1, dtype=np.int64), _most_ties([oscillator])
    path = np.zeros((motion.npts, 3 + ties))
    path[0, 2] = -1.0
    samples = run(first, first, np.array([scale]), np.empty((1, columns.FOUND)), np.zeros((1, ties)), path)
    return history.trace_found(motion, one, path[:samples, :3]), path[:samples, 3:]


def _packed(oscillators: Sequence[TiedOscillator]) -> list[PackedOscillator]:
    """Pack the bare oscillators; each side has a table of its own, as ties differ where the body is alike."""
    found = pack_all([one.bare for one in oscillators], "exact")
    return [replace(one, sides=tuple(replace(side) for side in one.sides)) for one in found]


def _most_ties(oscillators: Sequence[TiedOscillator]) -> int:
    return max((len(one.ties) for one in oscillators), default=0)


def _solver(
    oscillators: Sequence[TiedOscillator],
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
                friction[first : last + 1] = _cubics(canonical.y, moment, np.gradient(moment, canonical.y))
    return partial(
        ties.rock_with_memory, branches_of(each), table, smooth, spans, laws, elongation, friction, tolerance,
        *history.motion_arrays(motions),
    )  # fmt: skip


def _cubics(y: FloatArray, value: FloatArray, slope: FloatArray) -> FloatArray:
    """Return the cubics through values and slopes at y [n], highest power first [n - 1, 4]."""
    from scipy.interpolate import CubicHermiteSpline

    return np.ascontiguousarray(CubicHermiteSpline(y, value, slope).c.T)
