"""The overturning envelopes of a study's mechanisms, and the critical mechanism at each frequency."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.dynamics.critical import Critical, find_critical
from assess.dynamics.envelope import Envelope, envelope
from assess.oscillator import Oscillator
from assess.results import CriticalBand, CriticalResult, EnvelopeResult
from assess.short_repr import ShortRepr
from assess.study.progress import Progress
from assess.study.study import Equation, PulseGrid
from records.pulses import SHAPES
from spectra.arrays import FloatArray

DEFAULT_GRID = PulseGrid(SHAPES["sine"], np.linspace(0.2, 10.0, 100), np.linspace(0.0, 3.0 * g, 100))


@dataclass(frozen=True, repr=False)
class EnvelopeCase(ShortRepr):
    """A mechanism whose envelope is sought.

    factor : amplification to its base at given frequencies [n] [Hz] -> [n]
    case : the case of a sweep in words, else empty
    """

    name: str
    oscillator: Oscillator
    equation: Equation
    factor: Callable[[FloatArray], FloatArray]
    case: str = ""


def map_envelopes(
    cases: Sequence[EnvelopeCase], grid: PulseGrid | None, *, jobs: int, progress: Progress
) -> dict[str, EnvelopeResult]:
    """Return the envelope of every mechanism by name; empty without a grid of pulses."""
    if grid is None:
        return {}
    found = {}
    for count, case in enumerate(cases):
        progress("overturning envelopes", count, len(cases))
        made = envelope(
            case.oscillator,
            grid.shape,
            grid.frequency,
            grid.amplitude,
            equation=case.equation,
            factor=case.factor(grid.frequency),
            threads=jobs,
        )
        found[case.name] = replace(envelope_result(made, case.oscillator), case=case.case)
    progress("overturning envelopes", len(cases), len(cases))
    return found


def envelope_result(made: Envelope, oscillator: Oscillator) -> EnvelopeResult:
    """Return the envelope in the units of results."""
    form = min((branch.linearised for branch in oscillator.branches), key=lambda form: form.multiplier)
    bound = made.lower_bound / g
    above = made.amplitude[None, :] > made.lower_bound[:, None]  # nowhere, if nothing overturns
    return EnvelopeResult(
        shape=made.shape.name,
        gamma=made.shape.gamma,
        nu_rad=made.shape.nu,
        equation=made.equation,
        frequency_hz=tuple(made.frequency.tolist()),
        amplitude_g=tuple((made.amplitude / g).tolist()),
        overturned=tuple(tuple(row) for row in made.overturned.tolist()),
        lower_bound_g=none_for_nan(bound),
        polarity=tuple(made.polarity.tolist()),
        islands=tuple((above & ~made.overturned).sum(axis=1).tolist()),
        uplift_g=tuple((made.uplift / g).tolist()),
        factor=tuple(made.factor.tolist()),
        omega=tuple((2 * np.pi * made.frequency / form.p).tolist()),
        lower_bound_ratio=none_for_nan(bound * made.factor / form.multiplier),
    )


def critical_result(found: dict[str, EnvelopeResult]) -> CriticalResult | None:
    """Return which mechanism is critical at each frequency; None without mechanisms."""
    if not found:
        return None
    names = list(found)
    frequency = np.array(next(iter(found.values())).frequency_hz)
    bounds = np.array([[np.nan if b is None else b for b in each.lower_bound_g] for each in found.values()])
    order = find_critical(frequency, bounds)
    return CriticalResult(
        frequency_hz=tuple(frequency.tolist()),
        mechanism=_names(order.mechanism, names),
        lower_bound_g=none_for_nan(order.lower_bound),
        runner_up=_names(order.runner_up, names),
        margin=none_for_nan(order.margin),
        near=tuple(tuple(name for name, is_near in zip(names, row, strict=True) if is_near) for row in order.near.T),
        bands=_bands(order, names),
    )


def _bands(order: Critical, names: Sequence[str]) -> tuple[CriticalBand, ...]:
    return tuple(
        CriticalBand(None if band.mechanism is None else names[band.mechanism], band.start, band.end)
        for band in order.bands
    )


def _names(index: NDArray[np.int64], names: Sequence[str]) -> tuple[str | None, ...]:
    """Return the names of mechanisms by index, None for a negative one."""
    return tuple(names[i] if i >= 0 else None for i in index)


def none_for_nan(values: FloatArray) -> tuple[float | None, ...]:
    """Return numbers [n], None in place of nan."""
    return tuple(None if np.isnan(value) else float(value) for value in values)
