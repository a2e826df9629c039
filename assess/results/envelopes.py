"""Overturning envelopes of pulses, and the critical mechanism at each frequency."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class EnvelopeResult(ShortRepr):
    """Which pulses of the ground overturn a mechanism, in the worse polarity, by n frequencies and m amplitudes.

    gamma, nu_rad: of a mavroeidis-papageorgiou pulse, else None. overturned [n][m]: one row for each frequency.
    lower_bound_g [n]: least amplitude that overturns, None if none up to the highest does; polarity [n]: of that pulse,
    0 if there is none. islands [n]: number of amplitudes above the bound that do not overturn. uplift_g [n]: amplitude
    that starts rocking, 0 on joints without a threshold. factor [n]: amplification from the ground to the mechanism's
    base. omega [n]: 2 pi f / p; lower_bound_ratio [n]: factor times bound over g lambda, both of the linearised branch
    that uplifts first, for dimensionless plots. case: the case of a swept mechanism; empty for others.
    """

    shape: str
    gamma: float | None
    nu_rad: float | None
    equation: Literal["exact", "linearised"]
    frequency_hz: Floats
    amplitude_g: Floats
    overturned: tuple[tuple[bool, ...], ...]
    lower_bound_g: tuple[float | None, ...]
    polarity: tuple[int, ...]
    islands: tuple[int, ...]
    uplift_g: Floats
    factor: Floats
    omega: Floats
    lower_bound_ratio: tuple[float | None, ...]
    case: str = ""


@dataclass(frozen=True, repr=False)
class CriticalBand(ShortRepr):
    """Frequencies at which one mechanism is critical; None where nothing overturns."""

    mechanism: str | None
    from_hz: float
    to_hz: float


@dataclass(frozen=True, repr=False)
class CriticalResult(ShortRepr):
    """The mechanism that the weakest pulse overturns, at each of n frequencies.

    mechanism [n]: None where nothing overturns; lower_bound_g [n]: its bound. runner_up [n]: the second; margin [n]:
    of its bound over the least, as a share of the least. near [n]: all with bounds within five percent of the least.
    """

    frequency_hz: Floats
    mechanism: tuple[str | None, ...]
    lower_bound_g: tuple[float | None, ...]
    runner_up: tuple[str | None, ...]
    margin: tuple[float | None, ...]
    near: tuple[tuple[str, ...], ...]
    bands: tuple[CriticalBand, ...]
