"""The overturning envelope of one oscillator under pulses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assess.dynamics import envelope as pulses
from assess.dynamics.envelope import Envelope
from assess.dynamics.packing import Equation
from assess.oscillator import Oscillator
from records.errors import RecordError
from records.pulses import Shape, shape
from spectra.arrays import FloatArray

TINY = 5e-324  # the least number above 0


def envelope(
    oscillator: Oscillator,
    pulse: str | Shape,
    *,
    frequency: Sequence[float] | FloatArray,
    amplitude: Sequence[float] | FloatArray,
    equation: Equation = "exact",
    threads: int = 0,
) -> Envelope:
    """Find which pulses of a grid overturn an oscillator, in the worse polarity, and the least that does.

    Parameters
    ----------
    oscillator : Oscillator
        The branches of the mechanism, or of a rigid block.
    pulse : str or Shape
        Name of a pulse of `records.pulses.SHAPES`, or a shape made by `records.pulses.shape`.
    frequency : array
        Rising frequencies of the pulse [n] [Hz].
    amplitude : array
        Rising peak accelerations [m] [m/s2].
    equation : {"exact", "linearised"}
        The equation of motion.
    threads : int
        Number of threads; 0 for all cores. The results do not depend on it.

    Returns
    -------
    Envelope
        Outcome of each pulse [n, m], and at each frequency the least amplitude that overturns [n] [m/s2].

    Raises
    ------
    RecordError
        If no pulse has that name, or frequencies or amplitudes are not finite, positive and rising.
    MechanismError
        If a branch cannot rock.
        If frequencies or amplitudes are not finite, positive and rising.
    """
    return pulses.envelope(
        oscillator,
        shape(pulse) if isinstance(pulse, str) else pulse,
        _rising("frequency", frequency, least=TINY),
        _rising("amplitude", amplitude, least=0.0),
        equation=equation,
        threads=threads,
    )


def _rising(name: str, given: Sequence[float] | FloatArray, *, least: float) -> FloatArray:
    """Return an axis of the grid; raise RecordError where it is not finite, rising, or within its bounds."""
    values = np.atleast_1d(np.array(given, dtype=np.float64))
    if values.ndim != 1 or not values.size or not np.isfinite(values).all():
        raise RecordError(f"{name}: give one finite number or more")
    if values[0] < least or values[-1] <= 0.0 or (np.diff(values) <= 0.0).any():
        raise RecordError(f"{name}: {values[0]:g} to {values[-1]:g}: give rising numbers above 0")
    return values
