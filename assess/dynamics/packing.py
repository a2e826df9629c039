"""Oscillators in the form that the kernel takes: branches, tables, and the meaning of its coordinate."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.dynamics.canonical import Canonical, canonical_form, linear_form
from assess.dynamics.kernel import columns
from assess.errors import MechanismError
from assess.oscillator import Branch, Oscillator, elastic_frequency, energy
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray

Equation = Literal["exact", "linearised"]
T = TypeVar("T")
S = TypeVar("S", bound=np.generic)
FASTEST = 1e5  # Hz: faster motions on joints would take minutes a record; masonry's are below 1000 Hz


@dataclass(frozen=True, repr=False)
class Packed(ShortRepr):
    """An oscillator for one equation.

    branches : the columns of `branch` in `kernel.columns` [2, 6]
    sides : the meaning of the kernel's y on each side, with the cubics of the exact equation
    """

    branches: FloatArray
    sides: tuple[Canonical, ...]


def pack(oscillator: Oscillator, equation: Equation) -> Packed:
    """Pack an oscillator for the kernel. Raises MechanismError for a branch that cannot rock."""
    if equation not in _PACKING:
        raise MechanismError(f'equation "{equation}" is not known; the equations are {", ".join(_PACKING)}')
    return _PACKING[equation](oscillator)


def _exact(oscillator: Oscillator) -> Packed:
    """Pack an oscillator by its tables; a body at the end of a table has overturned."""
    for branch, following in zip(oscillator.branches, reversed(oscillator.branches), strict=True):
        _check_branch(branch, following=following)
        _check_pace(branch)
    sides = _of_each(oscillator, canonical_form)
    rows = _rows(oscillator, sides)
    for row, branch, side in zip(rows, oscillator.branches, sides, strict=False):
        E = _positive(float(energy(branch, np.array(branch.unstable))), "work up to the overturning rotation", "J")
        row[columns.THRESHOLD] = branch.restoring[0] / branch.excitation[0]
        row[columns.RATE] = math.sqrt(2.0 * E / branch.inertia[0]) / side.turn
        row[[columns.LIMIT, columns.TAIL_LIMIT]] = side.y[-1]
    return Packed(rows, sides)


def _linearised(oscillator: Oscillator) -> Packed:
    """Pack an oscillator by its linearised form; LIMIT depends on the job."""
    forms = _of_each(oscillator, lambda branch: branch.linearised)
    for form in forms:
        _positive(form.stiffness, "linearised stiffness K at phi_cr", "N m/rad")
        _positive(form.overturning, "linearised overturning rotation", "rad")
    for branch, following in zip(oscillator.branches, reversed(oscillator.branches), strict=True):
        _check_branch(branch, following=following)
    sides = tuple(linear_form(form.overturning) for form in forms)
    rows = _rows(oscillator, sides)
    for row, form in zip(rows, forms, strict=False):
        row[columns.THRESHOLD], row[columns.RATE] = g * form.multiplier, form.p
        row[[columns.LIMIT, columns.TAIL_LIMIT]] = 1.0
    return Packed(rows, sides)


_PACKING: dict[Equation, Callable[[Oscillator], Packed]] = {"exact": _exact, "linearised": _linearised}


def _of_each(oscillator: Oscillator, make: Callable[[Branch], T]) -> tuple[T, ...]:
    """Return what `make` returns for each branch, made once where both are one branch."""
    first = make(oscillator.positive)
    if oscillator.negative is None:
        return (first,)
    return first, first if oscillator.negative is oscillator.positive else make(oscillator.negative)


def branches_of(oscillators: Sequence[Packed]) -> FloatArray:
    """Return the branches of all oscillators [oscillators, 2, 6]."""
    return np.array([each.branches for each in oscillators]).reshape(-1, 2, 6)


def _rows(oscillator: Oscillator, sides: Sequence[Canonical]) -> FloatArray:
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


def _positive(value: float, name: str, unit: str) -> float:
    """Return the value, or raise MechanismError if it is not positive."""
    if not value > 0.0:
        raise MechanismError(
            f"a branch has {name} {value:.6g} {unit}, which must be positive for it to rock; "
            "look at its loads and hinges"
        )
    return value


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


def tables_of(oscillators: Sequence[Packed]) -> tuple[FloatArray, IntArray, IntArray]:
    """Return the cubics of all branches over y [segments, 11], and the segments of each smooth piece and branch."""
    rows, smooth, spans, start = [np.empty((0, 11))], [np.empty((0, 2), dtype=np.int64)], [], 0
    for oscillator in oscillators:
        spans.append(np.zeros((2, 2), dtype=np.int64))
        for side, of in enumerate(oscillator.sides):
            rows.append(np.vstack([of.y[:-1], of.y[1:], of.restoring, of.excitation, of.stored[:-1]]).T)
            smooth.append(start + of.smooth)
            spans[-1][side] = start, start + of.y.size - 2
            start += of.y.size - 1
    return np.concatenate(rows), np.concatenate(smooth), np.array(spans, dtype=np.int64).reshape(-1, 2, 2)
