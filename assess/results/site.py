"""The site's elastic spectrum, and the records scaled to it."""

from __future__ import annotations

from dataclasses import dataclass

from assess.messages.message import Message
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class SpectrumResult(ShortRepr):
    """The site's elastic spectrum."""

    code: str
    parameters: dict[str, float | str]
    damping: float
    damping_rule: str
    clause: str
    pga_g: float
    period_s: Floats
    acceleration_g: Floats


@dataclass(frozen=True, repr=False)
class RecordSpectrum(ShortRepr):
    """The elastic response spectrum of a record after scaling, 5 % damping."""

    period_s: Floats
    acceleration_g: Floats


@dataclass(frozen=True, repr=False)
class PrimaryPulse(ShortRepr):
    """A pulse within a record, scaled as the record: the one that matches it best, or another local optimum.

    polarity: 1 or -1; energy_share: share of the integral of squared acceleration that the pulse explains [-].
    """

    shape: str
    frequency_hz: float
    amplitude_g: float
    start_s: float
    polarity: int
    energy_share: float


@dataclass(frozen=True, repr=False)
class RecordResult(ShortRepr):
    """A record as used: after scaling to the site's spectrum, before the factor of a level.

    mse: mean squared natural-log misfit to the target after scaling [-]; processing: its processing history, in
    order, where a str is a line of its file; trail: the English of it.
    """

    id: str
    path: str
    event: str
    station: str
    component: str
    dt_s: float
    npts: int
    pga_g: float
    scale_factor: float
    mse: float
    trail: tuple[str, ...]
    spectrum: RecordSpectrum
    primary_pulses: tuple[PrimaryPulse, ...] = ()
    date: str = ""
    magnitude: float | None = None
    distance_km: float | None = None
    vs30_m_per_s: float | None = None
    nga: int | None = None
    processing: tuple[Message | str, ...] = ()
