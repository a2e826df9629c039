"""The overturning envelopes of a study's mechanisms, and the critical mechanism at each frequency."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.dynamics.critical import Critical, find_critical
from assess.dynamics.envelope import Envelope, envelope
from assess.oscillator import Oscillator, linearise
from assess.results import CriticalBand, CriticalResult, EnvelopeResult, PrimaryPulse, RecordResult
from assess.study.motions import ScaledRecord
from assess.study.study import Equation, PulseGrid
from records.primary_pulse import primary_pulses
from records.pulses import SHAPES
from spectra.arrays import FloatArray

Progress = Callable[[str, int, int], None]

DEFAULT_GRID = PulseGrid(SHAPES["sine"], np.linspace(0.2, 10.0, 100), np.linspace(0.0, 3.0 * g, 100))
MOST_PULSES = 3
WORTH = 0.1  # of the energy that the best pulse explains: others that explain less are none
"""Primary pulses of a record that are kept: the best, and the next ones, which may be longer and worse."""


@dataclass(frozen=True)
class EnvelopeCase:
    """A mechanism as envelopes see it.

    factor : amplification to its base at given frequencies [n] [Hz] -> [n]; case : of a sweep, in words, else empty
    """

    name: str
    oscillator: Oscillator
    equation: Equation
    factor: Callable[[FloatArray], FloatArray]
    case: str = ""


def map_envelopes(
    rockers: Sequence[EnvelopeCase], grid: PulseGrid | None, *, jobs: int, progress: Progress
) -> dict[str, EnvelopeResult]:
    """The envelope of every mechanism by name; none where no grid of pulses is asked for."""
    if grid is None:
        return {}
    found = {}
    for count, rocker in enumerate(rockers):
        progress("overturning envelopes", count, len(rockers))
        made = envelope(
            rocker.oscillator,
            grid.shape,
            grid.frequency,
            grid.amplitude,
            equation=rocker.equation,
            factor=rocker.factor(grid.frequency),
            threads=jobs,
        )
        found[rocker.name] = replace(envelope_result(made, rocker.oscillator), case=rocker.case)
    progress("overturning envelopes", len(rockers), len(rockers))
    return found


def envelope_result(made: Envelope, oscillator: Oscillator) -> EnvelopeResult:
    """The envelope in the units of results."""
    form = min((linearise(branch) for branch in oscillator.branches), key=lambda form: form.multiplier)
    bound = made.lower_bound / g
    above = made.amplitude[None, :] > made.lower_bound[:, None]  # never where there is no bound
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
    """Which of the mechanisms is critical at each frequency; None without mechanisms."""
    if not found:
        return None
    names = list(found)
    frequency = np.array(next(iter(found.values())).frequency_hz)
    bounds = np.array([[np.nan if b is None else b for b in each.lower_bound_g] for each in found.values()])
    order = find_critical(frequency, bounds)
    return CriticalResult(
        frequency_hz=tuple(frequency.tolist()),
        mechanism=_named(order.mechanism, names),
        lower_bound_g=none_for_nan(order.lower_bound),
        runner_up=_named(order.runner_up, names),
        margin=none_for_nan(order.margin),
        near=tuple(tuple(name for name, is_near in zip(names, row, strict=True) if is_near) for row in order.near.T),
        bands=_bands(order, names),
    )


def _bands(order: Critical, names: Sequence[str]) -> tuple[CriticalBand, ...]:
    return tuple(
        CriticalBand(None if band.mechanism is None else names[band.mechanism], band.start, band.end)
        for band in order.bands
    )


def _named(index: NDArray[np.int64], names: Sequence[str]) -> tuple[str | None, ...]:
    return tuple(names[i] if i >= 0 else None for i in index)


def with_primary_pulses(
    records: Sequence[RecordResult], motions: Sequence[ScaledRecord], grid: PulseGrid | None
) -> tuple[RecordResult, ...]:
    """The records with the pulses of the grid's shape found in them, scaled as they are."""
    if grid is None:
        return tuple(records)
    return tuple(
        replace(record, primary_pulses=pulses_of(motion, grid)) for record, motion in zip(records, motions, strict=True)
    )


def pulses_of(motion: ScaledRecord, grid: PulseGrid) -> tuple[PrimaryPulse, ...]:
    """The best pulses within one motion, each as the motion is scaled."""
    found = primary_pulses(motion.record, shape=grid.shape, count=MOST_PULSES)
    return tuple(
        PrimaryPulse(
            shape=pulse.shape.name,
            frequency_hz=pulse.frequency,
            amplitude_g=pulse.amplitude * motion.scaling.factor / g,
            start_s=pulse.start,
            polarity=pulse.polarity,
            energy_share=pulse.energy_share,
        )
        for pulse in found
        if pulse.energy_share >= WORTH * found[0].energy_share
    )


def none_for_nan(values: FloatArray) -> tuple[float | None, ...]:
    """Numbers [n], None for nan."""
    return tuple(None if np.isnan(value) else float(value) for value in values)
