"""The history that controls are made on: the worst record of the level nearest to the site's own PGA."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf

from scipy.constants import g

from assess.amplification.floor_motion import base_motion
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Oscillator
from assess.results import HistoryResult
from assess.short_repr import ShortRepr
from assess.study.history_levels import with_restitution_factor
from assess.study.motions import ScaledRecord
from assess.study.study import Amplified, Equation
from records.record import Record


@dataclass(frozen=True, repr=False)
class GoverningHistory(ShortRepr):
    """One history of a mechanism, with what it takes to run it again.

    found : as it is in the results; oscillator : with the restitution of that history
    motion : at the base of the mechanism; scale : on it, negative for the reversed polarity [-]
    """

    found: HistoryResult
    oscillator: Oscillator
    motion: Record
    scale: float
    equation: Equation


def governing_history(
    mechanism: Mechanism,
    histories: Sequence[HistoryResult],
    motions: Mapping[str, ScaledRecord],
    amplified: Amplified,
    *,
    equation: Equation,
    site_pga: float,
) -> GoverningHistory | None:
    """Return the worst history at the level nearest to the site's PGA; None if none rocks there.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism, whose deciding oscillator rocks.
    histories : sequence of HistoryResult
        All its histories.
    motions : mapping
        The records with their factors, by id.
    amplified : Amplified
        How the ground's motion reaches its base.
    equation : {"exact", "linearised"}
        The equation of its histories.
    site_pga : float
        [m/s2]
    """
    if not histories:
        return None
    level = min((each.level_pga_g for each in histories), key=lambda pga: abs(pga - site_pga / g))
    worst = max((each for each in histories if each.level_pga_g == level), key=_severity)
    if worst.max_rotation_rad == 0.0:
        return None
    return GoverningHistory(
        worst,
        with_restitution_factor(mechanism.variants.deciding, worst.rebound),
        base_motion(amplified.amplification, motions[worst.record].record).record,
        worst.polarity * worst.scale_factor,
        equation,
    )


def _severity(history: HistoryResult) -> float:
    return inf if history.max_rotation_ratio is None else history.max_rotation_ratio
