"""Overturning envelopes: which pulses, by frequency and amplitude, overturn a mechanism (thesis 3.3.1, 3.4.1).

The outcome is not monotone in amplitude: above the least pulse that overturns there can be safe islands, which the map
shows. The lower bound is sought by a scan in steps of 1 % (exact equation: 2 %) and on the map, then by bisection
between the last pulse that the mechanism stands and the first that overturns it; a band of overturning thinner than a
step can be missed.

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
Falls = Callable[[IntArray, IntArray, FloatArray], BoolArray]

SCAN = {"linearised": 1.01, "exact": 1.02}
"""Ratio of two amplitudes of the scan for the lower bound."""
FROM = 0.2
"""Of the peak acceleration that is resisted at most: where the scan begins on joints without a threshold of uplift."""
BISECTIONS = 40
AT_ONCE = 8
"""Steps of the scan that are asked together; a frequency that fell within them is asked no more."""
SAME = 1e-12
"""Of the largest value of a table: less than this between two branches is rounding."""
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
    overturned = _mapped(falls, len(polarities(oscillator)), amplitude[None, :] * times[:, None])
    bounds = _bounds(
        oscillator, shape, frequency, equation=equation, factor=times, highest=float(amplitude.max()), threads=threads
    )
    bound, polarity = _least(_below_the_map(bounds, amplitude, overturned, falls, times), oscillator)
    uplift, worse = threshold(oscillator, equation) / times, np.asarray(np.any(overturned, axis=0))
    return Envelope(shape, equation, frequency, amplitude, worse, bound, polarity, uplift, times)


def _falls(oscillator: Oscillator, shape: Shape, frequency: FloatArray, *, equation: Equation, threads: int) -> Falls:
    """What tells whether pulses overturn the oscillator [k]: by their polarity, frequency and amplitude at the base.

    polarity [k], of [k] : indices of `polarities` and of `frequency` [n]; amplitude [k] [m/s2]
    """
    answer = prepared([oscillator], shape, frequency, equation=equation, threads=threads)
    signs = np.array(polarities(oscillator))

    def falls(polarity: IntArray, of: IntArray, amplitude: FloatArray) -> BoolArray:
        return answer(PulseJobs(np.zeros(of.size, dtype=np.int64), of, signs[polarity] * amplitude)).overturned

    return falls


def _mapped(falls: Falls, polarities: int, amplitude: FloatArray) -> BoolArray:
    """Whether amplitudes at the base [n, m] overturn [polarities, n, m]."""
    n, m = amplitude.shape
    of, polarity, place = np.indices((n, polarities, m)).reshape(3, -1)  # all of one frequency together
    return np.moveaxis(falls(polarity, of, amplitude[of, place]).reshape(n, polarities, m), 1, 0)


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
    bounds = _bounds(oscillator, shape, frequency, equation=equation, factor=factor, highest=highest, threads=threads)
    return _least(bounds, oscillator)


def _bounds(
    oscillator: Oscillator,
    shape: Shape,
    frequency: FloatArray,
    *,
    equation: Equation,
    factor: FloatArray,
    highest: float,
    threads: int,
) -> FloatArray:
    """The same of each polarity that differs [polarities, n], inf where nothing overturns."""
    lowest = (threshold(oscillator, equation) or FROM * _resisted(oscillator)) / factor
    if closed(shape, equation):
        return _closed(oscillator, shape, frequency, lowest * factor, highest * factor, threads=threads) / factor
    falls = _falls(oscillator, shape, frequency, equation=equation, threads=threads)
    both = len(polarities(oscillator))
    return _scanned(falls, both, lowest, factor, ratio=SCAN[equation], highest=highest)


def _least(bounds: FloatArray, oscillator: Oscillator) -> tuple[FloatArray, IntArray]:
    """Of bounds [polarities, n], the lower, nan where there is none, and its polarity, 0 where there is none."""
    worst, least = bounds.argmin(axis=0), bounds.min(axis=0)
    polarity = np.where(np.isfinite(least), np.array(polarities(oscillator))[worst], 0)
    return np.where(np.isfinite(least), least, np.nan), polarity.astype(np.int64)


def _below_the_map(
    bounds: FloatArray, amplitude: FloatArray, overturned: BoolArray, falls: Falls, factor: FloatArray
) -> FloatArray:
    """Bounds [polarities, n] that are never above an amplitude [m] of the map that overturns [polarities, n, m].

    The map may meet a band that the scan has stepped over.
    """
    first = overturned.argmax(axis=2)
    met = np.where(overturned.any(axis=2), amplitude[first], np.inf)
    better = np.nonzero(met < bounds)
    low = np.where(first > 0, amplitude[np.maximum(first - 1, 0)], 0.0)
    lower = bounds.copy()
    lower[better] = _between(low[better], met[better], better, falls, factor)
    return lower


def _between(
    low: FloatArray, high: FloatArray, which: tuple[IntArray, ...], falls: Falls, factor: FloatArray
) -> FloatArray:
    """By bisection, from amplitudes of the ground that stand to those that overturn [k].

    which : the polarity [k] and the frequency [k] of each, as indices
    """
    polarity, of = which
    for _ in range(BISECTIONS if of.size else 0):
        middle = 0.5 * (low + high)
        fell = falls(polarity, of, middle * factor[of])
        low, high = np.where(fell, low, middle), np.where(fell, middle, high)
    return high


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
    falls: Falls, polarities: int, lowest: FloatArray, factor: FloatArray, *, ratio: float, highest: float
) -> FloatArray:
    """Bounds of the ground's amplitude [polarities, n], inf where nothing overturns."""
    powers = ratio ** np.arange(ceil(log(max(highest / lowest.min(), 1.0)) / log(ratio)) + 1)

    def scan(of: IntArray, place: IntArray) -> FloatArray:
        return np.minimum(lowest[of] * powers[place], highest)

    first = _first(
        lambda i, of, place: falls(i, of, scan(of, place) * factor[of]), polarities, factor.size, powers.size
    )
    found = np.nonzero(first < powers.size)
    of, place = found[1], first[found]
    low = np.where(place > 0, scan(of, np.maximum(place - 1, 0)), 0.0)
    bounds = np.full(first.shape, np.inf)
    bounds[found] = _between(low, scan(of, place), found, falls, factor)
    return bounds


def _first(falls: Callable[[IntArray, IntArray, IntArray], BoolArray], polarities: int, n: int, steps: int) -> IntArray:
    """The first step of a scan that falls, of each polarity and frequency [polarities, n]; `steps` where none does.

    falls : of polarities [k], frequencies [k] and steps [k], as indices. Beyond the first step no more is asked.
    """
    first = np.full((polarities, n), steps)
    for begin in range(0, steps, AT_ONCE):
        polarity, of = np.nonzero(first == steps)
        place = np.arange(begin, min(begin + AT_ONCE, steps))
        each = np.repeat(np.arange(of.size), place.size)
        down = falls(polarity[each], of[each], np.tile(place, of.size)).reshape(of.size, place.size)
        first[polarity, of] = np.where(down.any(axis=1), begin + down.argmax(axis=1), steps)
    return first


def polarities(oscillator: Oscillator) -> tuple[int, ...]:
    """Signs of a pulse that differ in what they do: one for an oscillator that is the same both ways."""
    return (1,) if oscillator.negative is not None and alike(*oscillator.branches) else (1, -1)


def threshold(oscillator: Oscillator, equation: Equation) -> float:
    """Acceleration at the base that starts rocking [m/s2]."""
    if equation == "linearised":
        return min(g * linearise(branch).multiplier for branch in oscillator.branches)
    return min(float(branch.restoring[0] / branch.excitation[0]) for branch in oscillator.branches)


def _resisted(oscillator: Oscillator) -> float:
    """The largest acceleration that any rotation up to overturning holds [m/s2]."""
    return min(
        float((branch.restoring / branch.excitation)[branch.rotation <= branch.unstable].max())
        for branch in oscillator.branches
    )


def alike(one: Branch, other: Branch) -> bool:
    """Whether two branches are the same but for rounding, of meshes and of what is computed from them."""
    columns = ("rotation", "inertia", "restoring", "excitation")
    return one is other or (
        one.rotation.shape == other.rotation.shape
        and abs(one.restitution - other.restitution) <= SAME
        and all(_same(getattr(one, name), getattr(other, name)) for name in columns)
    )


def _same(one: FloatArray, other: FloatArray) -> bool:
    return bool(np.abs(one - other).max() <= SAME * np.abs(one).max())
