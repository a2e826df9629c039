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

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil, log

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.dynamics.packing import Equation
from assess.dynamics.pulse_response import PulseJobs, prepared
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
    tried = np.broadcast_to(amplitude, (frequency.size, amplitude.size))
    overturned = falls(tried * times[:, None])
    bound, polarity = _lower_bounds(falls, tried, overturned, oscillator, equation, times)
    uplift, worse = threshold(oscillator, equation) / times, np.asarray(np.any(overturned, axis=0))
    return Envelope(shape, equation, frequency, amplitude, worse, bound, polarity, uplift, times)


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


def _lower_bounds(
    falls: Callable[[FloatArray], BoolArray],
    tried: FloatArray,
    overturned: BoolArray,
    oscillator: Oscillator,
    equation: Equation,
    factor: FloatArray,
) -> tuple[FloatArray, IntArray]:
    """Least amplitude of the ground that overturns at each frequency [n] [m/s2], and its polarity.

    It is sought up to the highest of the amplitudes `tried` [n, m] already, which `overturned` [polarities, n, m].
    """
    highest = float(tried.max())
    lowest = (threshold(oscillator, equation) or FROM * _resisted(oscillator)) / factor
    ratio = SCAN[equation]
    steps = max(ceil(log(highest / lowest.min()) / log(ratio)), 0)
    scan = np.minimum(lowest[:, None] * ratio ** np.arange(steps + 1), highest)
    down, scan = np.dstack([falls(scan * factor[:, None]), overturned]), np.hstack([scan, tried])
    order = np.argsort(scan, axis=1, kind="stable")
    down, scan = np.take_along_axis(down, order[None], axis=2), np.take_along_axis(scan, order, axis=1)
    first, rows = down.argmax(axis=2), np.arange(factor.size)
    high, low = scan[rows, first], np.where(first > 0, scan[rows, np.maximum(first - 1, 0)], 0.0)
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        fell = falls((middle * factor)[:, :, None])[:, :, 0]
        low, high = np.where(fell, low, middle), np.where(fell, middle, high)
    bounds = np.where(down.any(axis=2), high, np.inf)
    worst, least = bounds.argmin(axis=0), bounds.min(axis=0)
    polarity = np.where(np.isfinite(least), np.array(polarities(oscillator))[worst], 0)
    return np.where(np.isfinite(least), least, np.nan), polarity.astype(np.int64)


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
    """Whether two branches are the same to the last digit."""
    columns = ("rotation", "inertia", "restoring", "excitation")
    return one is other or (
        one.restitution == other.restitution
        and all(np.array_equal(getattr(one, name), getattr(other, name)) for name in columns)
    )
