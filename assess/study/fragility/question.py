"""What is asked of the fragility of a study, and the hazard that its risk is found with, as plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from assess.results.fragility import HazardResult, MeasureResult, Method, StateResult

STATES = (StateResult("rocking"), StateResult("rotation", 0.5), StateResult("overturning"))
LEVELS: Mapping[Method, int] = {"ida": 50, "stripes": 10, "cloud": 1}
"""Intensities at which each record is run, where the project does not say."""
AVERAGE_PERIODS = tuple(round(0.1 * k, 1) for k in range(2, 21))
"""Periods of "sa-average" where the project does not say [s]."""
LARGEST_FACTOR = 10.0
"""Scale factor beyond which no record is run, where the project does not say [-]."""


@dataclass(frozen=True)
class FragilityQuestion:
    """What is asked of the fragility of every mechanism.

    measures : at the ground, the primary one first; empty: all that apply
    samples : intensities at which each record is run; None for that of the method
    largest : intensity of the primary measure up to which records are run [unit of the measure]; None: until all that
        may be scaled so far overturn
    largest_factor : scale factor beyond which no record is run [-]
    epistemic : dispersion of what is not known of mechanisms, by name [-]
    hazard : of the site in one measure; None where it is not known
    target_rate : annual rate that the risk is compared with [1/year]
    """

    measures: tuple[MeasureResult, ...] = ()
    states: tuple[StateResult, ...] = STATES
    method: Method = "ida"
    samples: int | None = None
    largest: float | None = None
    largest_factor: float = LARGEST_FACTOR
    seed: int = 1
    draws: int = 500
    epistemic: Mapping[str, float] = field(default_factory=dict)
    hazard: HazardResult | None = None
    target_rate: float | None = None

    @property
    def levels(self) -> int:
        """Intensities at which each record is run."""
        return LEVELS[self.method] if self.samples is None else self.samples
