"""The primary pulses of the records of a study."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from scipy.constants import g

from assess.results import PrimaryPulse, RecordResult
from assess.study.motions import ScaledRecord
from assess.study.study import PulseGrid
from records.primary_pulse import primary_pulses

MOST_PULSES = 3  # of a record: the best, and the next ones, which may be longer and match worse
WORTH = 0.1  # of the energy that the best pulse explains: pulses that explain less are dropped


def with_primary_pulses(
    records: Sequence[RecordResult], motions: Sequence[ScaledRecord], grid: PulseGrid | None
) -> tuple[RecordResult, ...]:
    """Return the records with the pulses of the grid's shape found in them, scaled as they are."""
    if grid is None:
        return tuple(records)
    return tuple(
        replace(record, primary_pulses=pulses_of(motion, grid)) for record, motion in zip(records, motions, strict=True)
    )


def pulses_of(motion: ScaledRecord, grid: PulseGrid) -> tuple[PrimaryPulse, ...]:
    """Return the pulses that match one motion best, each as the motion is scaled."""
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
