"""The pulses of one frequency that overturn, and the weakest of them."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from assess.kernel import compiled
from spectra.arrays import BoolArray, FloatArray

Overturns = Callable[[Any, float], bool]
Search = Callable[..., None]


def make_search(overturns: Overturns) -> Search:
    """Return the search for the pulses of one frequency that overturn, by the equation that `overturns` solves."""

    @compiled
    def bisect(job: Any, low: float, high: float, factor: float, bisections: int) -> float:
        """Return the least overturning amplitude of the ground between `low`, which does not overturn, and `high`.

        factor: from the amplitude of the ground to that at the base, with the sign of the polarity.
        """
        for _ in range(bisections):
            middle = 0.5 * (low + high)
            if overturns(job, middle * factor):
                high = middle
            else:
                low = middle
        return high

    @compiled
    def search(job: Any, factor: float, safe: float, scan: FloatArray, signs: FloatArray, amplitude: FloatArray,
               bisections: int, overturned: BoolArray, least: FloatArray) -> None:  # fmt: skip
        """Fill `overturned` [polarities, m], and `least` with the least overturning amplitude (inf if none), its sign.

        factor: from the amplitude of the ground to that at the base; safe: an amplitude at the base that cannot
        overturn [m/s2]; scan [k], amplitude [m]: of the ground, rising [m/s2]; signs [polarities].

        The scan ends at the first step that overturns in any polarity: the other polarities need more.
        """
        bound, sign = math.inf, 0.0
        for q in range(len(signs)):
            for m in range(len(amplitude)):
                base = amplitude[m] * factor
                overturned[q, m] = base > safe and overturns(job, signs[q] * base)
        for k in range(len(scan)):
            if scan[k] * factor > safe:
                for q in range(len(signs)):
                    if overturns(job, signs[q] * (scan[k] * factor)):
                        edge = bisect(job, scan[k - 1] if k > 0 else 0.0, scan[k], signs[q] * factor, bisections)
                        if edge < bound:
                            bound, sign = edge, signs[q]
            if sign != 0.0 or scan[k] == scan[-1]:
                break
        for q in range(len(signs)):  # the map may show a band that the scan stepped over
            for m in range(len(amplitude)):
                if overturned[q, m]:
                    if amplitude[m] < bound:
                        low = amplitude[m - 1] if m > 0 else 0.0
                        bound, sign = bisect(job, low, amplitude[m], signs[q] * factor, bisections), signs[q]
                    break
        least[0], least[1] = bound, sign

    return search
