"""The site's elastic spectrum, the records scaled to it, and their suite beside its target and the rules of codes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.messages.message import Message, Term
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class EquivalentPeriods(ShortRepr):
    """The shortest and longest equivalent period of a mechanism's branches, at the allowable rotation."""

    mechanism: str
    shortest_s: float
    longest_s: float


@dataclass(frozen=True, repr=False)
class RemainingCandidates(ShortRepr):
    """The number of candidates left after a step of the selection."""

    step: str
    number: int


@dataclass(frozen=True, repr=False)
class SelectionResult(ShortRepr):
    """How the suite was chosen; misfit: of its mean spectrum to the target [-]; greedy_misfit: before exchanges [-]."""

    fit: Literal["suite", "each"]
    components: Literal["single", "together"]
    one_per_event: bool
    least_factor: float
    largest_factor: float
    remaining: tuple[RemainingCandidates, ...]
    misfit: float
    greedy_misfit: float | None


@dataclass(frozen=True, repr=False)
class RequirementResult(ShortRepr):
    """A requirement of a code on the suite, the value found, and the verdict; from_s, to_s: range of periods.

    caveat: why the clause was not checked against the printed standard; empty if it was. remark: the English of
    `remarks`.
    """

    code: str
    clause: str
    what: str
    value: float | None
    sense: Literal[">=", "<="]
    limit: float
    unit: str
    verdict: Literal["met", "not met", "not answered"]
    from_s: float | None
    to_s: float | None
    remark: str
    caveat: str
    remarks: tuple[Term | Message, ...] = ()


@dataclass(frozen=True, repr=False)
class GroundMotionResult(ShortRepr):
    """The suite of records compared with its target, 5 % damping.

    from_s, to_s: range of periods over which it was scaled and chosen; source: of that range, in words. mean_g,
    geometric_mean_g, target_g [k]: at period_s; misfit: of the mean to the target over the range, mean squared
    difference of natural logarithms [-]. selection: None if all records of the project are used. lock: file that the
    records and factors are taken from, empty if the suite is not locked; made_for: the code whose
    rules it was made to meet, empty if none.
    """

    from_s: float
    to_s: float
    source: str
    equivalent_periods: tuple[EquivalentPeriods, ...]
    period_s: Floats
    target_g: Floats
    mean_g: Floats
    geometric_mean_g: Floats
    misfit: float
    selection: SelectionResult | None
    requirements: tuple[RequirementResult, ...]
    lock: str = ""
    made_for: str = ""


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
class PrimaryPulseResult(ShortRepr):
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
    primary_pulses: tuple[PrimaryPulseResult, ...] = ()
    date: str = ""
    magnitude: float | None = None
    distance_km: float | None = None
    vs30_m_per_s: float | None = None
    nga: int | None = None
    processing: tuple[Message | str, ...] = ()
