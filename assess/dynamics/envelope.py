"""Overturning envelopes: which pulses, by frequency and amplitude, overturn a mechanism (thesis 3.3.1, 3.4.1).

The outcome is not monotone in amplitude: above the least pulse that overturns there can be safe islands, which the map
shows. The lower bound is sought by a scan in steps of 1 %, then bisection between the last pulse that the mechanism
stands and the first that overturns it; a band of overturning thinner than a step can be missed.

Both polarities are run, the worse counts: for one-sided rocking the polarity that first presses the body to its support
needs less than the other, by up to 2.5 times, and the plot of the thesis shows the other one only. A mechanism that is
the same both ways needs one.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import ceil, log

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.dynamics.packing import Equation, packed
from assess.dynamics.pulse_response import PulseJobs, closed, prepared
from assess.dynamics.sine.kernel import sine_bounds
from assess.oscillator import Branch, Oscillator, linearise
from records.pulses import Shape

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]

SCAN = {"linearised": 1.01, "exact": 1.02}
"""Ratio of two amplitudes of the scan for the lower bound."""
FROM = 0.2
"""Of the peak acceleration that is resisted at most: where the scan begins on joints without a threshold of uplift."""
BISECTIONS = 40
CHUNK = 25
"""Frequencies given to a thread at a time."""


@dataclass(frozen=True)
class Envelope:
    """Outcome over the amplitude of the ground at n frequencies and m amplitudes.

    frequency [n] [Hz], amplitude [m] [m/s2]
    overturned : in the worse polarity [n, m]
    lower_bound : least amplitude that overturns, nan where none up to the highest does [n] [m/s2]
    polarity : of the pulse of the lower bound, 0 where there is none [n]
    uplift : amplitude that starts rocking; 0 on joints without a threshold [n] [m/s2]
    factor : amplification of the ground motion to the mechanism's base [n] [-]
    """

    shape: Shape
    equation: Equation
    frequency: FloatArray
    amplitude: FloatArray
    overturned: BoolArray
    lower_bound: FloatArray
    polarity: IntArray
    uplift: FloatArray
    factor: FloatArray


def envelope(
    oscillator: Oscillator,
    shape: Shape,
    frequency: FloatArray,
    amplitude: FloatArray,
    *,
    equation: Equation,
    factor: FloatArray | None = None,
    threads: int = 0,
) -> Envelope:
    """The envelope of one mechanism; factor: of the ground's amplitude at its base, at each frequency [n]."""
    times = np.ones_like(frequency) if factor is None else factor
    falls = _falls(oscillator, shape, frequency, equation=equation, threads=threads)
    overturned = np.any(falls(amplitude[None, :] * times[:, None]), axis=0)
    bound, polarity = lower_bounds(
        oscillator, shape, frequency, equation=equation, factor=times, highest=float(amplitude.max()), threads=threads
    )
    uplift = threshold(oscillator, equation) / times
    return Envelope(shape, equation, frequency, amplitude, np.asarray(overturned), bound, polarity, uplift, times)


def _falls(
    oscillator: Oscillator, shape: Shape, frequency: FloatArray, *, equation: Equation, threads: int
) -> Callable[[FloatArray], BoolArray]:
    """What tells for amplitudes at the base [n, k] or [polarities, n, k] whether each polarity that differs overturns
    the oscillator: [polarities, n, k]."""
    answer = prepared([oscillator], shape, frequency, equation=equation, threads=threads)
    signs = np.array(polarities(oscillator))[:, None, None]

    def falls(amplitude: FloatArray) -> BoolArray:
        signed = np.moveaxis(signs * amplitude, 0, 1)  # all of one frequency together
        of = np.broadcast_to(np.arange(frequency.size, dtype=np.int64)[:, None, None], signed.shape)
        found = answer(PulseJobs(np.zeros(signed.size, dtype=np.int64), of.ravel(), signed.ravel()))
        return np.moveaxis(found.overturned.reshape(signed.shape), 1, 0)

    return falls


def lower_bounds(
    oscillator: Oscillator,
    shape: Shape,
    frequency: FloatArray,
    *,
    equation: Equation,
    factor: FloatArray,
    highest: float,
    threads: int = 0,
) -> tuple[FloatArray, IntArray]:
    """Least amplitude of the ground that overturns at each frequency [n] [m/s2], up to `highest`, and its polarity.

    factor : of the ground's amplitude at the mechanism's base [n]. nan and 0 where no amplitude overturns.
    """
    lowest = (threshold(oscillator, equation) or FROM * _resisted(oscillator)) / factor
    if closed(shape, equation):
        bounds = _closed(oscillator, shape, frequency, lowest * factor, highest * factor, threads=threads) / factor
    else:
        falls = _falls(oscillator, shape, frequency, equation=equation, threads=threads)
        bounds = _scanned(falls, lowest, factor, ratio=SCAN[equation], highest=highest)
    worst, least = bounds.argmin(axis=0), bounds.min(axis=0)
    polarity = np.where(np.isfinite(least), np.array(polarities(oscillator))[worst], 0)
    return np.where(np.isfinite(least), least, np.nan), polarity.astype(np.int64)


def _closed(
    oscillator: Oscillator,
    shape: Shape,
    frequency: FloatArray,
    lowest: FloatArray,
    highest: FloatArray,
    *,
    threads: int,
) -> FloatArray:
    """Bounds at the base between two amplitudes at each frequency [polarities, n], inf where nothing overturns."""
    branch, signs = packed(oscillator, "linearised").branches, polarities(oscillator)
    bounds = np.empty((len(signs), frequency.size))

    def work(part: tuple[int, slice]) -> None:
        row, some = part
        limits = lowest[some], highest[some]
        ratio, sign = SCAN["linearised"], float(signs[row])
        sine_bounds(branch, shape.end, frequency[some], *limits, ratio, sign, BISECTIONS, bounds[row, some])

    parts = [(row, slice(i, i + CHUNK)) for row in range(len(signs)) for i in range(0, frequency.size, CHUNK)]
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        list(pool.map(work, parts))
    return bounds


def _scanned(
    falls: Callable[[FloatArray], BoolArray], lowest: FloatArray, factor: FloatArray, *, ratio: float, highest: float
) -> FloatArray:
    """Bounds of the ground's amplitude [polarities, n], inf where nothing overturns."""
    steps = ceil(log(max(highest / lowest.min(), 1.0)) / log(ratio))
    scan = np.minimum(lowest[:, None] * ratio ** np.arange(steps + 1), highest)
    down = falls(scan * factor[:, None])
    first, rows = down.argmax(axis=2), np.arange(factor.size)
    high, low = scan[rows, first], np.where(first > 0, scan[rows, np.maximum(first - 1, 0)], 0.0)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        fell = falls((middle * factor)[:, :, None])[:, :, 0]
        low, high = np.where(fell, low, middle), np.where(fell, middle, high)
    return np.where(down.any(axis=2), high, np.inf)


def polarities(oscillator: Oscillator) -> tuple[int, ...]:
    """Signs of a pulse that differ in what they do: one for an oscillator that is the same both ways."""
    return (1,) if oscillator.negative is not None and alike(*oscillator.branches) else (1, -1)


def threshold(oscillator: Oscillator, equation: Equation) -> float:
    """Acceleration at the base that starts rocking [m/s2]."""
    if equation == "linearised":
        return min(g * linearise(branch).multiplier for branch in oscillator.branches)
    return min(float(branch.restoring[0] / branch.excitation[0]) for branch in oscillator.branches)


def _resisted(oscillator: Oscillator) -> float:
    """The largest acceleration that any rotation holds [m/s2]."""
    return min(float((branch.restoring / branch.excitation).max()) for branch in oscillator.branches)


def alike(one: Branch, other: Branch) -> bool:
    """Whether two branches are the same to the last digit."""
    columns = ("rotation", "inertia", "restoring", "excitation")
    return one is other or (
        one.restitution == other.restitution
        and all(np.array_equal(getattr(one, name), getattr(other, name)) for name in columns)
    )
