"""Oscillators in the form that the kernel takes: branches and tables over a coordinate in which the inertia is
constant.

With s(phi) = sqrt(I(phi) / I(0)) and dy = s dphi / L, where y = 1 at overturning, the kinetic energy is
I(0) L^2 y'^2 / 2, and the rocking equation loses its velocity:

    I phi'' + 1/2 I' phi'^2 + R = -B a        becomes        y'' = -r(y) - b(y) a,     r, b = (R, B) / (I(0) L s)

Where I is constant, as for a rigid block, y is phi / phi_ov. Where it jumps, y' and so the energy is continuous.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from assess.dynamics.kernel import columns
from assess.errors import MechanismError
from assess.oscillator import Branch, Oscillator, elastic_frequency, energy, interpolant
from assess.short_repr import ShortRepr
from spectra.arrays import BoolArray, FloatArray, IntArray
from spectra.gravity import g

if TYPE_CHECKING:
    from scipy.interpolate import CubicHermiteSpline, PPoly

Equation = Literal["exact", "linearised"]
T = TypeVar("T")
S = TypeVar("S", bound=np.generic)
FASTEST = 1e5  # Hz: faster motions on joints would take minutes a record; masonry's are below 1000 Hz


@dataclass(frozen=True, repr=False)
class PackedOscillator(ShortRepr):
    """An oscillator for one equation.

    branches : the columns of `branch` in `kernel.columns` [2, 6]
    sides : the meaning of the kernel's y on each side, with the cubics of the exact equation
    """

    branches: FloatArray
    sides: tuple[CanonicalBranch, ...]


def pack(oscillator: Oscillator, equation: Equation) -> PackedOscillator:
    """Pack an oscillator for the kernel. Raises MechanismError for a branch that cannot rock."""
    if equation not in _PACKING:
        raise MechanismError(f'equation "{equation}" is not known; the equations are {", ".join(_PACKING)}')
    return _PACKING[equation](oscillator)


def pack_all(oscillators: Sequence[Oscillator], equation: Equation) -> list[PackedOscillator]:
    """Pack several oscillators; those that differ in their restitution alone share the cubics of the first."""
    known: dict[tuple[float, ...], PackedOscillator] = {}
    packed: list[PackedOscillator] = []
    for oscillator in oscillators:
        key = tuple(each for branch in oscillator.branches for each in _table_of(branch))
        first = known.get(key)
        packed.append(pack(oscillator, equation) if first is None else _with_restitution(first, oscillator))
        known.setdefault(key, packed[-1])
    return packed


def _table_of(branch: Branch) -> tuple[float, ...]:
    """Return what tells the table of a branch from others while both are held: which arrays, and where it falls."""
    arrays = (branch.rotation, branch.inertia, branch.restoring, branch.excitation)
    return (*map(id, arrays), branch.unstable, branch.critical)


def _with_restitution(packed: PackedOscillator, oscillator: Oscillator) -> PackedOscillator:
    """Return a packed oscillator with the restitution of another one that has the same tables."""
    for branch, following in zip(oscillator.branches, reversed(oscillator.branches), strict=True):
        _check_branch(branch, following=following)
    rows = packed.branches.copy()
    rows[:, columns.BOUNCE] = _rows(oscillator, packed.sides)[:, columns.BOUNCE]
    return replace(packed, branches=rows)


def branches_of(oscillators: Sequence[PackedOscillator]) -> FloatArray:
    """Return the branches of all oscillators [oscillators, 2, 6]."""
    return np.array([each.branches for each in oscillators]).reshape(-1, 2, 6)


def kernel_array(values: NDArray[S], dtype: type[S]) -> NDArray[S]:
    """Return values as the kernels take them: contiguous and writable, copied if they are not.

    numba compiles anew for read-only arrays, which takes as long as the first time and gives the same code.

    Parameters
    ----------
    values : numbers [n]
    dtype : of the result
    """
    return np.require(values, dtype=dtype, requirements=("C", "W"))


def check_jobs(indices: Mapping[str, tuple[IntArray, int]], *, name: str, number: FloatArray) -> None:
    """Raise ValueError for jobs [n] with an unknown index or a number that is not finite.

    indices : the index of each job into each sequence, and the length of that sequence
    name : of the `number` of each job
    """
    for of, (index, count) in indices.items():
        if not index.shape == number.shape == (number.size,):
            raise ValueError(f"jobs: {of} {index.shape} and {name} {number.shape}; give one of each for every job")
        bad = np.flatnonzero((index < 0) | (index >= count))
        if bad.size:
            raise ValueError(f"jobs[{bad[0]}]: {of} {index[bad[0]]}, but there are {count}; count them from 0")
    bad = np.flatnonzero(~np.isfinite(number))
    if bad.size:
        raise ValueError(f"jobs[{bad[0]}]: {name} {number[bad[0]]}; it must be a finite number")


def tables_of(oscillators: Sequence[PackedOscillator]) -> tuple[FloatArray, IntArray, IntArray]:
    """Return the cubics of all branches over y [segments, 11], and the segments of each smooth piece and branch."""
    rows, smooth, spans, start = [np.empty((0, 11))], [np.empty((0, 2), dtype=np.int64)], [], 0
    known: dict[int, tuple[int, int]] = {}
    for oscillator in oscillators:
        spans.append(np.zeros((2, 2), dtype=np.int64))
        for side, of in enumerate(oscillator.sides):
            if id(of) not in known:
                rows.append(np.vstack([of.y[:-1], of.y[1:], of.restoring, of.excitation, of.stored[:-1]]).T)
                smooth.append(start + of.smooth)
                known[id(of)] = start, start + of.y.size - 2
                start += of.y.size - 1
            spans[-1][side] = known[id(of)]
    return np.concatenate(rows), np.concatenate(smooth), np.array(spans, dtype=np.int64).reshape(-1, 2, 2)


NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)

SAME = 1e-10
"""Fraction of the largest value of a table below which a difference between two nodes at one rotation is rounding."""


@dataclass(frozen=True, repr=False)
class CanonicalBranch(ShortRepr):
    """A branch over y, on its n segments of nonzero width.

    turn : dphi / dy at rest, L [rad]
    y : ends of the segments [n + 1] [-]
    restoring, excitation : cubics of r [1/s2] and b [1/m] on each segment, highest power first [4, n]
    stored : integral of r up to each end [n + 1] [1/s2]
    smooth : first and last segment of the piece between jumps that each segment lies in [n, 2]
    back : phi [rad] over y
    inertia : I / I(0) over phi [-]
    """

    turn: float
    y: FloatArray
    restoring: FloatArray
    excitation: FloatArray
    stored: FloatArray
    smooth: IntArray
    back: CubicHermiteSpline
    inertia: PPoly

    def rotation(self, y: FloatArray) -> FloatArray:
        """Return phi [rad] at y (same shape)."""
        return np.asarray(self.back(y))

    def velocity(self, y: FloatArray, v: FloatArray) -> FloatArray:
        """Return phi' [rad/s] at y with y' (same shapes)."""
        return np.asarray(self.turn * v / np.sqrt(self.inertia(self.back(y))))

    def coordinate(self, rotation: float) -> float:
        """Return y at a rotation [rad], by Newton's method from the chord."""
        y = float(np.interp(rotation, self.back(self.y), self.y))
        for _ in range(4):
            y -= float((self.back(y) - rotation) / self.back(y, 1))
        return y


def linear_form(turn: float) -> CanonicalBranch:
    """Return the coordinate of the linearised equation, y = phi / turn: its inertia is constant and needs no table."""
    from scipy.interpolate import CubicHermiteSpline, PPoly

    ends, none = np.array([0.0, 1.0]), np.empty((4, 0))
    line, one = CubicHermiteSpline(ends, turn * ends, [turn, turn]), PPoly([[1.0]], turn * ends)
    return CanonicalBranch(turn, ends, none, none, np.empty(0), np.empty((0, 2), dtype=np.int64), line, one)


def canonical_form(branch: Branch) -> CanonicalBranch:
    """Return the branch over y: cubics with its values and slopes at the ends of each segment."""
    wide = np.diff(branch.rotation) > 0.0
    left, width = branch.rotation[:-1][wide], np.diff(branch.rotation)[wide]
    at_rest = float(branch.inertia[0])

    columns = np.stack([branch.inertia, branch.restoring, branch.excitation], axis=1)
    inertia, moment, push = np.moveaxis(interpolant(branch.rotation, columns).c[:, wide], 2, 0)
    length = _lengths(inertia / at_rest, width)
    over = int(np.clip(np.searchsorted(left, branch.unstable) - 1, 0, left.size - 1))
    rest_of_it = _lengths(inertia[:, over : over + 1] / at_rest, np.array([branch.unstable - left[over]]))
    turn = float(length[:over].sum() + rest_of_it[0])
    w, ends = length / turn, np.stack([np.zeros_like(width), width])
    s = np.sqrt(_values(inertia, ends) / at_rest)
    bend = _values(_slopes(inertia), ends) / (2.0 * at_rest * s)

    def over_y(cubics: FloatArray) -> FloatArray:
        value, slope = _values(cubics, ends), _values(_slopes(cubics), ends)
        return _hermite(value / s, (slope - value * bend / s) * turn / s**2, w) / (at_rest * turn)

    from scipy.interpolate import CubicHermiteSpline, PPoly

    restoring, y = over_y(moment), np.r_[0.0, np.cumsum(w)]
    work = w * (((restoring[0] * w / 4 + restoring[1] / 3) * w + restoring[2] / 2) * w + restoring[3])
    return CanonicalBranch(
        turn=turn,
        y=y,
        restoring=restoring,
        excitation=over_y(push),
        stored=np.r_[0.0, np.cumsum(work)],
        smooth=_smooth_pieces(branch, wide),
        back=CubicHermiteSpline(y, np.r_[left, left[-1] + width[-1]], turn / np.r_[s[0], s[1, -1]]),
        inertia=PPoly(inertia / at_rest, np.r_[left, left[-1] + width[-1]]),
    )


def _pack_exact(oscillator: Oscillator) -> PackedOscillator:
    """Pack an oscillator by its tables; a body at the end of a table has overturned."""
    for branch, following in zip(oscillator.branches, reversed(oscillator.branches), strict=True):
        _check_branch(branch, following=following)
        _check_pace(branch)
    sides = _for_each_branch(oscillator, canonical_form)
    rows = _rows(oscillator, sides)
    for row, branch, side in zip(rows, oscillator.branches, sides, strict=False):
        E = _require_positive(
            float(energy(branch, np.array(branch.unstable))), "work up to the overturning rotation", "J"
        )
        row[columns.THRESHOLD] = branch.restoring[0] / branch.excitation[0]
        row[columns.RATE] = math.sqrt(2.0 * E / branch.inertia[0]) / side.turn
        row[[columns.LIMIT, columns.TAIL_LIMIT]] = side.y[-1]
    return PackedOscillator(rows, sides)


def _pack_linearised(oscillator: Oscillator) -> PackedOscillator:
    """Pack an oscillator by its linearised form; LIMIT depends on the job."""
    forms = _for_each_branch(oscillator, lambda branch: branch.linearised)
    for form in forms:
        _require_positive(form.stiffness, "linearised stiffness K at phi_cr", "N m/rad")
        _require_positive(form.overturning, "linearised overturning rotation", "rad")
    for branch, following in zip(oscillator.branches, reversed(oscillator.branches), strict=True):
        _check_branch(branch, following=following)
    sides = tuple(linear_form(form.overturning) for form in forms)
    rows = _rows(oscillator, sides)
    for row, form in zip(rows, forms, strict=False):
        row[columns.THRESHOLD], row[columns.RATE] = g * form.multiplier, form.p
        row[[columns.LIMIT, columns.TAIL_LIMIT]] = 1.0
    return PackedOscillator(rows, sides)


_PACKING: dict[Equation, Callable[[Oscillator], PackedOscillator]] = {
    "exact": _pack_exact,
    "linearised": _pack_linearised,
}


def _for_each_branch(oscillator: Oscillator, make: Callable[[Branch], T]) -> tuple[T, ...]:
    """Return what `make` returns for each branch, made once where both are one branch."""
    first = make(oscillator.positive)
    if oscillator.negative is None:
        return (first,)
    return first, first if oscillator.negative is oscillator.positive else make(oscillator.negative)


def _rows(oscillator: Oscillator, sides: Sequence[CanonicalBranch]) -> FloatArray:
    """Return the columns that both equations share: restitution, and the branch that follows an impact [2, 6]."""
    rows = np.zeros((2, 6))
    rows[:, columns.THRESHOLD] = math.inf  # a missing side never lifts
    for side, branch in enumerate(oscillator.branches):
        partner = 1 - side if oscillator.negative is not None else side
        rows[side, columns.BOUNCE] = branch.restitution * sides[side].turn / sides[partner].turn
        rows[side, columns.PARTNER] = partner
    return rows


def _check_branch(branch: Branch, *, following: Branch) -> None:
    """Raise MechanismError for a branch that falls at rest, has no mass, or gains energy at impacts there and back."""
    _require_positive(float(branch.unstable), "overturning rotation", "rad")
    _require_positive(float(np.min(branch.inertia)), "least inertia", "kg m2")
    _require_positive(float(branch.excitation[0]), "excitation at rest", "kg m")
    if branch.restoring[0] < 0.0 and branch.overturning_flexible is None:  # on joints it may rest beside
        raise MechanismError(
            f"a branch has restoring moment {branch.restoring[0]:.6g} N m at rest, so it is already falling; "
            "look at its loads and hinges"
        )
    most = max(1.0, math.sqrt(branch.inertia[0] / following.inertia[0]))  # turning faster about a nearer hinge
    if not 0.0 <= branch.restitution <= most * (1.0 + 1e-9):
        raise MechanismError(f"a branch has restitution {branch.restitution:.6g}; it must be between 0 and {most:.6g}")
    if branch.restitution * following.restitution > 1.0 + 1e-9:
        raise MechanismError(
            f"the branches have restitutions {branch.restitution:.6g} and {following.restitution:.6g}, which together "
            "add energy; their product must be at most 1"
        )


def _check_pace(branch: Branch) -> None:
    """Raise MechanismError for a branch whose small motions are too fast to follow."""
    frequency = elastic_frequency(branch)
    if frequency is not None and frequency > FASTEST:
        raise MechanismError(
            f"a branch moves on its joints at {frequency:.3g} Hz, beyond the {FASTEST:.0e} Hz histories can follow; "
            'check sizes, density and stiffness, or write model = "rigid"'
        )


def _require_positive(value: float, name: str, unit: str) -> float:
    """Return the value, or raise MechanismError if it is not positive."""
    if not value > 0.0:
        raise MechanismError(
            f"a branch has {name} {value:.6g} {unit}, which must be positive for it to rock; "
            "look at its loads and hinges"
        )
    return value


def _lengths(inertia: FloatArray, width: FloatArray) -> FloatArray:
    """Integrate s over each segment [n] [rad] by Gauss; inertia: cubics of I / I(0) [4, n]."""
    return np.asarray(0.5 * width * (WEIGHTS @ np.sqrt(_values(inertia, 0.5 * width * (1.0 + NODES[:, None])))))


def _values(polynomials: FloatArray, d: FloatArray) -> FloatArray:
    """Return polynomials [k, n] at distances d [m, n] from the start of their segments [m, n]."""
    value: FloatArray = np.zeros_like(d)
    for row in polynomials:
        value = value * d + row
    return value


def _slopes(cubics: FloatArray) -> FloatArray:
    """Return the derivatives [3, n] of cubics [4, n]."""
    return np.asarray(cubics[:-1] * np.array([[3.0], [2.0], [1.0]]))


def _hermite(value: FloatArray, slope: FloatArray, width: FloatArray) -> FloatArray:
    """Return the cubics [4, n] with these values and slopes at both ends [2, n] of segments of these widths [n]."""
    rise = (value[1] - value[0]) / width
    third, second = slope[0] + slope[1] - 2.0 * rise, 3.0 * rise - 2.0 * slope[0] - slope[1]
    return np.stack([third / width**2, second / width, slope[0], value[0]])


def _smooth_pieces(branch: Branch, wide: BoolArray) -> IntArray:
    """Return the first and last segment of nonzero width between the jumps around each [n, 2].

    Two nodes at one rotation with equal values, but for rounding, are a kink and not a jump: steps may pass it.
    """
    columns = np.array([branch.restoring, branch.excitation, branch.inertia])
    leaps = (np.abs(np.diff(columns)) > SAME * np.abs(columns).max(axis=1, keepdims=True)).any(axis=0)
    jumps = np.cumsum(leaps & ~wide)[wide]  # the number before each segment
    first, beyond = np.searchsorted(jumps, jumps), np.searchsorted(jumps, jumps, side="right")
    return np.asarray(np.stack([first, beyond - 1], axis=1), dtype=np.int64)
