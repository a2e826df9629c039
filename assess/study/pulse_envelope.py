"""The overturning envelope of one oscillator under pulses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assess.dynamics import envelope as pulses
from assess.dynamics.envelope import Envelope
from assess.dynamics.packing import Equation
from assess.oscillator import Oscillator
from records.pulses import Shape, shape
from spectra.arrays import FloatArray


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
        If no pulse has that name.
    MechanismError
        If a branch cannot rock.
    ValueError
        If a frequency is not positive.
    """
    return pulses.envelope(
        oscillator,
        shape(pulse) if isinstance(pulse, str) else pulse,
        np.array(frequency, dtype=np.float64),
        np.array(amplitude, dtype=np.float64),
        equation=equation,
        threads=threads,
    )
