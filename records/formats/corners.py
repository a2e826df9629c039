"""What a filter of the source says of the step: nothing is left of a motion far beyond the filter's corners."""

from __future__ import annotations

import numpy as np

from assess.messages.message import Message, Quantity, warning
from spectra.arrays import FloatArray

ABOVE, BELOW = 1.3, 0.6  # times the corners, beyond which hardly anything is left
HIGH_SHARE = 5e-3  # of the power of accelerations; 7e-4 at most in fifteen filtered records of ESM, ITACA and PEER
LOW_SHARE = 0.25  # of the power of displacements; 0.06 at most in the same


def filter_warning(samples: FloatArray, dt: float, *, low: float | None, high: float | None) -> Message | None:
    """Return a warning where a motion [n] at a step [s] goes on beyond the corners [Hz] of its filter.

    With another step a motion has other frequencies. None is a corner that is not known.
    """
    odd = nyquist_warning(high, dt)
    if odd or not (low or high) or samples.size < 2:
        return odd
    size = 2 * samples.size  # with zeros behind it
    f, power = np.fft.rfftfreq(size, dt), np.abs(np.fft.rfft(samples - np.mean(samples), size)) ** 2
    if high and float(np.sum(power[f > ABOVE * high])) > HIGH_SHARE * float(np.sum(power)):
        return warning("filter-above", corner=Quantity(high, "frequency", 6), step=Quantity(dt, "time", 6))
    moved = power[1:] / f[1:] ** 4
    if low and float(np.sum(moved[f[1:] < BELOW * low])) > LOW_SHARE * float(np.sum(moved)):
        return warning("filter-below", corner=Quantity(low, "frequency", 6), step=Quantity(dt, "time", 6))
    return None


def nyquist_warning(corner: float | None, dt: float) -> Message | None:
    """Return a warning about a filter's upper corner [Hz] that a step [s] cannot hold."""
    if corner is None or corner <= 1.02 * 0.5 / dt:
        return None
    corners = {"corner": Quantity(corner, "frequency", 6), "most": Quantity(0.5 / dt, "frequency", 6)}
    return warning("filter-beyond-step", step=Quantity(dt, "time", 6), **corners)
