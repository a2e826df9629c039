"""The outcome of pulses of the ground: whether oscillators rock and overturn.

A pulse is one of `records.pulses`, exact but for 1e-12: its acceleration goes to the kernel as polynomials of the fifth
degree that have its value, slope and curvature at the ends of short pieces. A sine by the linearised equation has a
closed form between events (`kernel.sine`) and needs no pieces. The outcome follows at the end of the pulse from the
energy that is left (linearised: the body overturns if y + y' / p > 1), so no free motion is run.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from math import ceil, pi

import numpy as np
from scipy.interpolate import BPoly, PPoly

from assess.dynamics.kernel import columns, exact, linearised, sine
from assess.dynamics.packing import Equation, Packed, branches_of, check_jobs, kernel_array, pack, tables_of
from assess.oscillator import Oscillator
from assess.short_repr import ShortRepr
from records.pulses import Shape
from spectra.arrays import BoolArray, FloatArray, IntArray

Run = Callable[[IntArray, IntArray, FloatArray, FloatArray], None]

PIECES = 100
"""Number in one period: the error of a piece of a sine is (2 pi / 100)^6 / 46080 = 1e-12 of its peak."""
TOLERANCE = 1e-9
"""Error allowed in one step of the exact equation: the overturning amplitude is then right to 1e-7 or better."""
CHUNK_JOBS = 32
"""Jobs given to a thread at a time: few, because a bisection has one for each frequency."""


@dataclass(frozen=True, repr=False)
class PulseJobs(ShortRepr):
    """What to run, one entry per job [n].

    oscillator, frequency : indices into the oscillators and the frequencies given with the jobs
    amplitude : signed peak acceleration [m/s2]; negative for the reversed polarity
    """

    oscillator: IntArray
    frequency: IntArray
    amplitude: FloatArray


@dataclass(frozen=True, repr=False)
class Outcomes(ShortRepr):
    """Whether each job [n] rocked and overturned, and its impacts until the end of the pulse or overturning."""

    uplifted: BoolArray
    overturned: BoolArray
    impacts: IntArray


def outcomes(
    oscillators: Sequence[Oscillator],
    shape: Shape,
    frequency: FloatArray,
    jobs: PulseJobs,
    *,
    equation: Equation,
    threads: int = 0,
) -> Outcomes:
    """Return the outcome of every job.

    Parameters
    ----------
    oscillators : the oscillators that jobs name by their index
    shape : of the pulse, from `records.pulses`
    frequency : of the pulses that jobs name by their index [n] [Hz]
    jobs : which oscillator, frequency and amplitude to run
    equation : "exact" or "linearised"
    threads : number of threads, 0 for all cores; the outcomes do not depend on it

    Raises
    ------
    MechanismError : a branch that cannot rock
    ValueError : a frequency that is not positive, or jobs with an unknown index or no finite amplitude
    """
    return make_solver(oscillators, shape, frequency, equation=equation, threads=threads)(jobs)


def make_solver(
    oscillators: Sequence[Oscillator], shape: Shape, frequency: FloatArray, *, equation: Equation, threads: int = 0
) -> Callable[[PulseJobs], Outcomes]:
    """Return a solver for these oscillators, this shape and these frequencies [n] [Hz]; call it with PulseJobs.

    Jobs of one oscillator and one frequency are fastest one after the other.

    Parameters
    ----------
    oscillators : the oscillators that jobs name by their index
    shape : of the pulse, from `records.pulses`
    frequency : of the pulses that jobs name by their index [n] [Hz]
    equation : "exact" or "linearised"
    threads : number of threads, 0 for all cores; the outcomes do not depend on it

    Raises
    ------
    MechanismError : a branch that cannot rock
    ValueError : a frequency that is not positive
    """
    check_frequency(frequency)
    each = [pack(oscillator, equation) for oscillator in oscillators]
    if has_closed_form(shape, equation):
        run: Run = partial(sine.sine_outcomes, branches_of(each), shape.end, kernel_array(frequency, np.float64))
    else:
        run = _KERNELS[equation](each, (*pulse_polynomials(shape), kernel_array(frequency, np.float64)))

    def answer(jobs: PulseJobs) -> Outcomes:
        check_jobs(
            {"oscillator": (jobs.oscillator, len(oscillators)), "frequency": (jobs.frequency, frequency.size)},
            name="amplitude",
            number=jobs.amplitude,
        )
        found = np.empty((jobs.amplitude.size, columns.FOUND))
        each, of = kernel_array(jobs.oscillator, np.int64), kernel_array(jobs.frequency, np.int64)
        amplitude = kernel_array(jobs.amplitude, np.float64)

        def work(part: slice) -> None:
            run(each[part], of[part], amplitude[part], found[part])

        cuts = [*range(0, jobs.amplitude.size, CHUNK_JOBS), jobs.amplitude.size]
        with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
            list(pool.map(work, [slice(first, last) for first, last in pairwise(cuts)]))
        return Outcomes(
            found[:, columns.UPLIFTED] > 0.0,
            found[:, columns.OVERTURNED] > 0.0,
            found[:, columns.IMPACTS].astype(np.int64),
        )

    return answer


def check_frequency(frequency: FloatArray) -> None:
    """Raise ValueError for a frequency [n] that is not positive."""
    bad = np.flatnonzero(~(np.isfinite(frequency) & (frequency > 0.0)))
    if bad.size:
        raise ValueError(f"frequency[{bad[0]}] = {frequency[bad[0]]} Hz of a pulse; it must be a positive number")


def has_closed_form(shape: Shape, equation: Equation) -> bool:
    """Return whether the motion between two events has a closed form: a sine, whole or half, linearised."""
    return equation == "linearised" and shape.name in ("sine", "half-sine")


def _linearised(oscillators: Sequence[Packed], pulse: tuple[FloatArray, float, FloatArray]) -> Run:
    return partial(linearised.pulse_linearised, branches_of(oscillators), *pulse)


def _exact(oscillators: Sequence[Packed], pulse: tuple[FloatArray, float, FloatArray]) -> Run:
    return partial(exact.pulse_exact, branches_of(oscillators), *tables_of(oscillators), TOLERANCE, *pulse)


_KERNELS = {"linearised": _linearised, "exact": _exact}


def pulse_polynomials(shape: Shape) -> tuple[FloatArray, float]:
    """Return the shape as polynomials of phase over each piece [n, 6], lowest power first, and its phase [rad]."""
    n = max(ceil(PIECES * (shape.end - shape.start) / (2 * pi)), 2)
    return _fitted(shape, n), (shape.end - shape.start) / n


@lru_cache(maxsize=8)
def _fitted(shape: Shape, pieces: int) -> FloatArray:
    """Fit the polynomials [pieces, 6], once for all mechanisms: this takes longer than the histories of one."""
    theta = np.linspace(shape.start, shape.end, pieces + 1)
    fitted = PPoly.from_bernstein_basis(BPoly.from_derivatives(theta, shape.derivatives(theta)[:3].T))
    coefficients = np.ascontiguousarray(fitted.c[::-1].T)
    coefficients.flags.writeable = False
    return coefficients
