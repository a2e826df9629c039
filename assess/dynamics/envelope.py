"""Overturning envelopes: which pulses, by frequency and amplitude, overturn a mechanism (thesis 3.3.1, 3.4.1).

The outcome is not monotone in amplitude: above the weakest overturning pulse there can be safe islands, which the map
shows. The lower bound is found by a scan in steps of 1 % (exact equation: 2 %) and on the map, then by bisection
between the last pulse that the mechanism survives and the first that overturns it; a band of overturning thinner than a
step can be missed.

Both polarities are run and the worse one counts: in one-sided rocking the polarity that first presses the body against
its support needs up to 2.5 times less than the other, and the thesis plots only the other. A symmetric mechanism needs
one polarity.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from math import ceil, log, sqrt

import numpy as np
from scipy.constants import g

from assess.dynamics.kernel import exact, linearised, sine
from assess.dynamics.packing import Equation, pack, tables_of
from assess.dynamics.pulse_response import TOLERANCE, check_frequency, has_closed_form, pulse_polynomials
from assess.oscillator import Branch, Oscillator, energy
from assess.short_repr import ShortRepr
from records.pulses import Shape
from spectra.arrays import BoolArray, FloatArray, IntArray

SCAN = {"linearised": 1.01, "exact": 1.02}
"""Ratio of two successive amplitudes of the scan for the lower bound."""
FROM = 0.2
"""Start of the scan on joints without a threshold of uplift, as a fraction of the largest acceleration resisted."""
BISECTIONS = 40
MARGIN = 0.99
"""Fraction of the overturning impulse: tables are curved between their nodes, and the kernel errs by 1e-7."""
CHUNK = 3
"""Frequencies given to a thread at a time: slow pulses cost more than fast ones."""


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
    check_frequency(frequency)
    fill = _filling(oscillator, shape, equation)  # first, for it rejects what cannot rock
    times = np.ones_like(frequency) if factor is None else factor
    signs = np.array(polarities(oscillator), dtype=np.float64)
    overturned = np.empty((frequency.size, signs.size, amplitude.size), dtype=np.bool_)
    least = np.empty((frequency.size, 2))
    each = frequency, times, safe_amplitude(oscillator, shape, frequency, equation=equation)
    scan = _scan(oscillator, times, equation=equation, highest=float(amplitude.max()))

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


def _filling(oscillator: Oscillator, shape: Shape, equation: Equation) -> Callable[..., None]:
    """Return the kernel for the envelope of this oscillator and shape."""
    one = pack(oscillator, equation)
    if has_closed_form(shape, equation):
        return partial(sine.envelope_sine, one.branches, shape.end)
    if equation == "linearised":
        return partial(linearised.envelope_linearised, one.branches, *pulse_polynomials(shape))
    table, smooth, (span,) = tables_of([one])
    return partial(exact.envelope_exact, one.branches, table, smooth, span, TOLERANCE, *pulse_polynomials(shape))


def _scan(oscillator: Oscillator, factor: FloatArray, *, equation: Equation, highest: float) -> FloatArray:
    """Return the amplitudes of the ground to scan for the lower bound [n, k] [m/s2]; the last ones are `highest`."""
    lowest = (uplift_acceleration(oscillator, equation) or FROM * _resisted(oscillator)) / factor
    steps = ceil(log(max(highest / lowest.min(), 1.0)) / log(SCAN[equation])) + 1
    return np.minimum(lowest[:, None] * SCAN[equation] ** np.arange(steps), highest)


def safe_amplitude(oscillator: Oscillator, shape: Shape, frequency: FloatArray, *, equation: Equation) -> FloatArray:
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


def _impulsive(branch: Branch, equation: Equation) -> tuple[float, float, float]:
    """Return sqrt(2 E) at overturning, the largest B / sqrt(I), and I at rest, of one branch."""
    if equation == "linearised":
        form = branch.linearised
        needed = sqrt(form.stiffness) * form.overturning
        return needed, form.excitation / sqrt(form.inertia), form.inertia
    end = np.array(min(branch.unstable, float(branch.rotation[-1])))
    gained = np.abs(branch.excitation) / np.sqrt(branch.inertia)
    return sqrt(2.0 * float(energy(branch, end))), float(gained.max()), float(branch.inertia[0])


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


def _resisted(oscillator: Oscillator) -> float:
    """Return the largest acceleration resisted at any rotation up to overturning [m/s2]."""
    return min(
        float((branch.restoring / branch.excitation)[branch.rotation <= branch.unstable].max())
        for branch in oscillator.branches
    )
