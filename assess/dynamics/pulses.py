"""Pulses of the ground: which of them, by frequency and amplitude, overturn a mechanism, and which mechanism first.

A pulse is one of `records.pulses`, exact but for 1e-12: its acceleration goes to the kernel as polynomials of the fifth
degree that have its value, slope and curvature at the ends of short pieces. A sine by the linearised equation has a
closed form between events (`kernel.sine`) and needs no pieces. The outcome follows at the end of the pulse from the
energy that is left (linearised: the body overturns if y + y' / p > 1), so no free motion is run.

Overturning envelopes (thesis 3.3.1, 3.4.1): the outcome is not monotone in amplitude; above the weakest overturning
pulse there can be safe islands, which the map shows. The lower bound is found by a scan in steps of 1 % (exact
equation: 2 %) and on the map, then by bisection between the last pulse that the mechanism survives and the first that
overturns it; a band of overturning thinner than a step can be missed. The critical mechanism at each frequency is the
one with the least lower bound (thesis 3.4.2).

Both polarities are run and the worse one counts: in one-sided rocking the polarity that first presses the body against
its support needs up to 2.5 times less than the other, and the thesis plots only the other. A symmetric mechanism needs
one polarity.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from math import ceil, log, pi, sqrt

import numpy as np
from numpy.typing import NDArray

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
from assess.oscillator import Branch, Oscillator, energy
from assess.short_repr import ShortRepr, html_table
from records.pulses import PulseShape
from spectra.arrays import BoolArray, FloatArray, IntArray
from spectra.gravity import g


def envelope(
    oscillator: Oscillator,
    shape: PulseShape,
    frequency: FloatArray,
    amplitude: FloatArray,
    *,
    equation: Equation,
    factor: FloatArray | None = None,
    threads: int = 0,
) -> Envelope:
    """Compute the overturning envelope of one mechanism.

    Parameters
    ----------
    oscillator : the mechanism
    shape : of the pulse, from `records.pulses`
    frequency : of the pulses [n] [Hz]
    amplitude : of the ground, rising [m] [m/s2]
    equation : "exact" or "linearised"
    factor : amplification from the ground to the base at each frequency [n] [-]; absent: 1
    threads : number of threads, 0 for all cores

    Raises
    ------
    MechanismError : a branch that cannot rock
    ValueError : a frequency that is not positive
    """
    _check_frequency(frequency)
    fill = _envelope_kernel(oscillator, shape, equation)  # first, for it rejects what cannot rock
    times = np.ones_like(frequency) if factor is None else factor
    signs = np.array(polarities(oscillator), dtype=np.float64)
    overturned = np.empty((frequency.size, signs.size, amplitude.size), dtype=np.bool_)
    least = np.empty((frequency.size, 2))
    each = frequency, times, safe_amplitude(oscillator, shape, frequency, equation=equation)
    scan = _scan_amplitudes(oscillator, times, equation=equation, highest=float(amplitude.max()))

    def work(part: slice) -> None:
        fill(
            *(values[part] for values in each), scan[part], signs, amplitude, BISECTIONS, overturned[part], least[part]
        )

    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        list(pool.map(work, [slice(i, i + CHUNK) for i in range(0, frequency.size, CHUNK)]))
    bound = np.where(np.isfinite(least[:, 0]), least[:, 0], np.nan)
    polarity, uplift = least[:, 1].astype(np.int64), uplift_acceleration(oscillator, equation) / times
    worse = np.asarray(np.any(overturned, axis=1))
    return Envelope(shape, equation, frequency, amplitude, worse, bound, polarity, uplift, times)


@dataclass(frozen=True, repr=False)
class Envelope(ShortRepr):
    """Outcome over the amplitude of the ground at n frequencies and m amplitudes.

    frequency [n] [Hz], amplitude [m] [m/s2]
    overturned : in the worse polarity [n, m]
    lower_bound : least amplitude that overturns, nan where none up to the highest does [n] [m/s2]
    polarity : of the pulse of the lower bound, 0 where there is none [n]
    uplift : amplitude that starts rocking; 0 on joints without a threshold [n] [m/s2]
    factor : amplification of the ground motion to the mechanism's base [n] [-]
    """

    shape: PulseShape
    equation: Equation
    frequency: FloatArray
    amplitude: FloatArray
    overturned: BoolArray
    lower_bound: FloatArray
    polarity: IntArray
    uplift: FloatArray
    factor: FloatArray

    def _repr_html_(self) -> str:
        bounds = ("none" if np.isnan(each) else f"{each / g:.3g}" for each in self.lower_bound.tolist())
        frequencies = (f"{each:.3g}" for each in self.frequency.tolist())
        return html_table(("frequency [Hz]", *frequencies), ("least amplitude that overturns [g]", *bounds))


def find_critical(frequency: FloatArray, bounds: FloatArray) -> CriticalMechanism:
    """Find the mechanism with the least lower bound at each frequency.

    Parameters
    ----------
    frequency : rising [n] [Hz]
    bounds : lower bound of each of m mechanisms, nan where nothing overturns it [m, n] [m/s2]
    """
    filled = np.where(np.isnan(bounds), np.inf, bounds)
    order = np.argsort(filled, axis=0, kind="stable")
    columns = np.arange(frequency.size)
    least = filled[order[0], columns]
    second = filled[order[1], columns] if len(bounds) > 1 else np.full(frequency.size, np.inf)
    first = np.where(np.isfinite(least), order[0], -1)
    other = np.where(np.isfinite(second), order[1], -1) if len(bounds) > 1 else np.full(frequency.size, -1)
    with np.errstate(invalid="ignore"):
        margin = np.where(np.isfinite(second), second / least - 1.0, np.nan)
        near = np.isfinite(filled) & (filled <= (1.0 + TIE) * least)
    return CriticalMechanism(
        first, np.where(np.isfinite(least), least, np.nan), other, margin, near, tuple(_bands(frequency, filled, first))
    )


@dataclass(frozen=True, repr=False)
class CriticalMechanism(ShortRepr):
    """Of m mechanisms at n frequencies.

    mechanism : the one with the least bound, -1 where none has one [n]
    lower_bound : its bound, nan where there is none [n] [m/s2]
    runner_up : the second least, -1 where there is none [n]
    margin : how much more the second needs, as a share of the least, nan where there is none [n] [-]
    near : whether each mechanism is within TIE of the least [m, n]
    bands : the same along the frequency; two bounds cross between two frequencies where lines through their
        logarithms do
    """

    mechanism: IntArray
    lower_bound: FloatArray
    runner_up: IntArray
    margin: FloatArray
    near: NDArray[np.bool_]
    bands: tuple[FrequencyBand, ...]


@dataclass(frozen=True)
class FrequencyBand:
    """Frequencies [Hz] from start to end at which one mechanism is critical; None: nothing overturns."""

    mechanism: int | None
    start: float
    end: float


RunPulses = Callable[[IntArray, IntArray, FloatArray, FloatArray], None]

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
class PulseOutcomes(ShortRepr):
    """Whether each job [n] rocked and overturned, and its impacts until the end of the pulse or overturning."""

    uplifted: BoolArray
    overturned: BoolArray
    impacts: IntArray


def pulse_outcomes(
    oscillators: Sequence[Oscillator],
    shape: PulseShape,
    frequency: FloatArray,
    jobs: PulseJobs,
    *,
    equation: Equation,
    threads: int = 0,
) -> PulseOutcomes:
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
    return make_pulse_solver(oscillators, shape, frequency, equation=equation, threads=threads)(jobs)


def make_pulse_solver(
    oscillators: Sequence[Oscillator], shape: PulseShape, frequency: FloatArray, *, equation: Equation, threads: int = 0
) -> Callable[[PulseJobs], PulseOutcomes]:
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
    _check_frequency(frequency)
    each = pack_all(oscillators, equation)
    if _has_closed_form(shape, equation):
        from assess.dynamics.kernel import sine  # brings numba

        run: RunPulses = partial(sine.sine_outcomes, branches_of(each), shape.end, kernel_array(frequency, np.float64))
    else:
        run = _KERNELS[equation](each, (*pulse_polynomials(shape), kernel_array(frequency, np.float64)))

    def answer(jobs: PulseJobs) -> PulseOutcomes:
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
        return PulseOutcomes(
            found[:, columns.UPLIFTED] > 0.0,
            found[:, columns.OVERTURNED] > 0.0,
            found[:, columns.IMPACTS].astype(np.int64),
        )

    return answer


def _linearised(oscillators: Sequence[PackedOscillator], pulse: tuple[FloatArray, float, FloatArray]) -> RunPulses:
    from assess.dynamics.kernel import linearised

    return partial(linearised.pulse_linearised, branches_of(oscillators), *pulse)


def _exact(oscillators: Sequence[PackedOscillator], pulse: tuple[FloatArray, float, FloatArray]) -> RunPulses:
    from assess.dynamics.kernel import exact

    return partial(exact.pulse_exact, branches_of(oscillators), *tables_of(oscillators), TOLERANCE, *pulse)


_KERNELS = {"linearised": _linearised, "exact": _exact}


def pulse_polynomials(shape: PulseShape) -> tuple[FloatArray, float]:
    """Return the shape as polynomials of phase over each piece [n, 6], lowest power first, and its phase [rad]."""
    n = max(ceil(PIECES * (shape.end - shape.start) / (2 * pi)), 2)
    return _fit_polynomials(shape, n), (shape.end - shape.start) / n


def safe_amplitude(
    oscillator: Oscillator, shape: PulseShape, frequency: FloatArray, *, equation: Equation
) -> FloatArray:
    """Return the peak acceleration at the base too weak to overturn, whatever the phase, at each frequency [n] [m/s2].

    By the impulse: the energy E = I phi'^2 / 2 + V changes at the rate -B u_g'' phi', and |phi'| <= sqrt(2 E / I), so
    sqrt(2 E) grows by no more than the integral of |u_g''| B / sqrt(I), less what impacts dissipate. To overturn, the
    body must absorb at least the work up to phi_ov. Where an impact that turns the body about a nearer hinge adds
    energy, the next one dissipates more.
    """
    tables = [_impulsive(branch, equation) for branch in oscillator.branches]
    needed, gained, at_rest = (np.array(column) for column in zip(*tables, strict=True))
    left = np.array([branch.restitution for branch in oscillator.branches]) * np.sqrt(at_rest[::-1] / at_rest)
    theta = np.linspace(shape.start, shape.end, 2001)
    impulse = float(np.trapezoid(np.abs(shape.value(theta)), theta)) / (2.0 * np.pi * frequency)
    return np.asarray(MARGIN * needed.min() / (gained.max() * max(1.0, left.max()) * impulse))


def polarities(oscillator: Oscillator) -> tuple[int, ...]:
    """Return the signs of a pulse to run: one for a symmetric oscillator, else both."""
    return (1,) if oscillator.symmetric else (1, -1)


def uplift_acceleration(oscillator: Oscillator, equation: Equation) -> float:
    """Return the acceleration at the base that starts rocking [m/s2].

    Parameters
    ----------
    oscillator : the mechanism
    equation : "exact" or "linearised"
    """
    if equation == "linearised":
        return min(g * branch.linearised.multiplier for branch in oscillator.branches)
    return min(float(branch.restoring[0] / branch.excitation[0]) for branch in oscillator.branches)


def _check_frequency(frequency: FloatArray) -> None:
    """Raise ValueError for a frequency [n] that is not positive."""
    bad = np.flatnonzero(~(np.isfinite(frequency) & (frequency > 0.0)))
    if bad.size:
        raise ValueError(f"frequency[{bad[0]}] = {frequency[bad[0]]} Hz of a pulse; it must be a positive number")


def _has_closed_form(shape: PulseShape, equation: Equation) -> bool:
    """Return whether the motion between two events has a closed form: a sine, whole or half, linearised."""
    return equation == "linearised" and shape.name in ("sine", "half-sine")


@lru_cache(maxsize=8)
def _fit_polynomials(shape: PulseShape, pieces: int) -> FloatArray:
    """Fit the polynomials [pieces, 6], once for all mechanisms: this takes longer than the histories of one."""
    theta = np.linspace(shape.start, shape.end, pieces + 1)
    from scipy.interpolate import BPoly, PPoly

    fitted = PPoly.from_bernstein_basis(BPoly.from_derivatives(theta, shape.derivatives(theta)[:3].T))
    coefficients = np.ascontiguousarray(fitted.c[::-1].T)
    coefficients.flags.writeable = False
    return coefficients


SCAN = {"linearised": 1.01, "exact": 1.02}
"""Ratio of two successive amplitudes of the scan for the lower bound."""

SCAN_START = 0.2
"""Start of the scan on joints without a threshold of uplift, as a fraction of the largest acceleration resisted."""
BISECTIONS = 40

MARGIN = 0.99
"""Fraction of the overturning impulse: tables are curved between their nodes, and the kernel errs by 1e-7."""

CHUNK = 3
"""Frequencies given to a thread at a time: slow pulses cost more than fast ones."""


def _envelope_kernel(oscillator: Oscillator, shape: PulseShape, equation: Equation) -> Callable[..., None]:
    """Return the kernel for the envelope of this oscillator and shape."""
    from assess.dynamics.kernel import exact, linearised, sine

    one = pack(oscillator, equation)
    if _has_closed_form(shape, equation):
        return partial(sine.envelope_sine, one.branches, shape.end)
    if equation == "linearised":
        return partial(linearised.envelope_linearised, one.branches, *pulse_polynomials(shape))
    table, smooth, (span,) = tables_of([one])
    return partial(exact.envelope_exact, one.branches, table, smooth, span, TOLERANCE, *pulse_polynomials(shape))


def _scan_amplitudes(oscillator: Oscillator, factor: FloatArray, *, equation: Equation, highest: float) -> FloatArray:
    """Return the amplitudes of the ground to scan for the lower bound [n, k] [m/s2]; the last ones are `highest`."""
    lowest = (uplift_acceleration(oscillator, equation) or SCAN_START * _largest_resisted(oscillator)) / factor
    steps = ceil(log(max(highest / lowest.min(), 1.0)) / log(SCAN[equation])) + 1
    return np.minimum(lowest[:, None] * SCAN[equation] ** np.arange(steps), highest)


def _impulsive(branch: Branch, equation: Equation) -> tuple[float, float, float]:
    """Return sqrt(2 E) at overturning, the largest B / sqrt(I), and I at rest, of one branch."""
    if equation == "linearised":
        form = branch.linearised
        needed = sqrt(form.stiffness) * form.overturning
        return needed, form.excitation / sqrt(form.inertia), form.inertia
    end = np.array(min(branch.unstable, float(branch.rotation[-1])))
    gained = np.abs(branch.excitation) / np.sqrt(branch.inertia)
    return sqrt(2.0 * float(energy(branch, end))), float(gained.max()), float(branch.inertia[0])


def _largest_resisted(oscillator: Oscillator) -> float:
    """Return the largest acceleration resisted at any rotation up to overturning [m/s2]."""
    return min(
        float((branch.restoring / branch.excitation)[branch.rotation <= branch.unstable].max())
        for branch in oscillator.branches
    )


TIE = 0.05
"""Bounds within this share of the least are in no clear order: a pulse, restitution or density could change it."""


def _bands(frequency: FloatArray, bounds: FloatArray, first: IntArray) -> list[FrequencyBand]:
    """Return the bands of frequency in which one mechanism is critical."""
    changes = np.flatnonzero(np.diff(first)) + 1
    places = [_crossing(frequency, bounds, first, int(k)) for k in changes]
    edges = [float(frequency[0]), *places, float(frequency[-1])]
    members = [int(first[0]), *(int(first[k]) for k in changes)]
    return [FrequencyBand(m if m >= 0 else None, a, b) for m, a, b in zip(members, edges[:-1], edges[1:], strict=True)]


def _crossing(frequency: FloatArray, bounds: FloatArray, first: IntArray, k: int) -> float:
    """Return where two bounds cross between frequencies k - 1 and k [Hz]; halfway if one is not known at both."""
    one, other = first[k - 1], first[k]
    a, b = float(frequency[k - 1]), float(frequency[k])
    both = bounds[[other, one]][:, [k - 1, k]] if min(one, other) >= 0 else np.full((2, 2), np.inf)
    if not np.all(np.isfinite(both)):
        return 0.5 * (a + b)
    gaps = np.diff(np.log(both), axis=0)[0]
    if gaps[0] == gaps[1]:
        return 0.5 * (a + b)
    return a + (b - a) * float(gaps[0] / (gaps[0] - gaps[1]))
