"""The motion at the base of a mechanism in the results."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.constants import g

from assess.amplification.floor_motion import BaseMotion, ModalFilter
from assess.results import (
    AmplificationResult,
    CarriedMotion,
    Factor,
)
from assess.study.motions import ScaledRecord
from assess.study.oscillator_results import floats
from assess.study.study import Amplified
from records.record import Record
from records.response import response_spectrum

SHORTEST_PERIOD, LONGEST_DRAWN = 0.05, 4.0  # s, of the spectra of a filtered motion
UNAMPLIFIED = AmplificationResult("none", ())


def amplification_result(
    amplified: Amplified, motions: Sequence[ScaledRecord] = (), base: Sequence[BaseMotion] = ()
) -> AmplificationResult:
    """Return how the ground motions reach the base of a mechanism; `base`: the motions as they act there."""
    filtered = isinstance(amplified.amplification, ModalFilter) and len(base) > 0
    most = max(range(len(base)), key=lambda place: base[place].factor) if filtered else 0
    return AmplificationResult(
        method=amplified.method,
        factors=tuple(Factor(each.record.id, each.factor) for each in base),
        height_m=amplified.height,
        said=(*amplified.description, *amplified.assumptions),
        motion=base_motion_result(motions[most], base[most].record) if filtered else None,
    )


def base_motion_result(motion: ScaledRecord, base: Record) -> CarriedMotion:
    """Return a motion scaled to the target, at the ground and at the base, sampled as the latter."""
    ground, scale = motion.record, motion.scaling.factor
    period = np.geomspace(SHORTEST_PERIOD, LONGEST_DRAWN, 120)
    return CarriedMotion(
        record=ground.id,
        time_s=floats(base.time),
        ground_acceleration_g=floats(scale / g * np.interp(base.time, ground.time, ground.acceleration, right=0.0)),
        base_acceleration_g=floats(scale / g * base.acceleration),
        period_s=floats(period),
        ground_spectrum_g=floats(scale / g * response_spectrum(ground, period)),
        base_spectrum_g=floats(scale / g * response_spectrum(base, period)),
    )
