"""How mechanisms respond to motions: amplification up to the base, time histories, overturning envelopes of pulses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.check import BranchName
from assess.messages.message import Message
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class HistoryTrace(ShortRepr):
    """A rocking history at the steps of its motion: signed rotation, ground acceleration.

    base_acceleration_g: motion at the base of the mechanism; None where that is the ground motion.
    """

    time_s: Floats
    rotation_rad: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats | None = None


@dataclass(frozen=True, repr=False)
class HistoryResult(ShortRepr):
    """The largest rocking response to one record at one level, in the worse polarity.

    max_rotation_rad: signed; it, its ratio and its time are None where the record overturned the mechanism.
    overturning_time_s: last passage of phi_ov. branch: of the largest rotation. rebound: factor on the restitution of
    the mechanism with which this history was worst, 1 if no range was run [-]. twin_ratios, twin_times_s: largest
    |rotation| / phi_ov and its time in each of the nine runs, the record as it is and its eight twins (see
    docs/verdict.md), None where that run overturned; twin_impacts: their impacts. Empty where the record was run alone.
    The number of impacts is a result only where all nine agree.
    """

    record: str
    polarity: int
    level_pga_g: float
    scale_factor: float
    amplification: float
    max_rotation_rad: float | None
    max_rotation_ratio: float | None
    time_of_max_s: float | None
    impacts: int
    overturned: bool
    overturning_time_s: float | None
    trace: HistoryTrace | None
    branch: BranchName
    rebound: float = 1.0
    twin_ratios: tuple[float | None, ...] = ()
    twin_times_s: tuple[float | None, ...] = ()
    twin_impacts: tuple[int, ...] = ()


@dataclass(frozen=True, repr=False)
class SuiteResult(ShortRepr):
    """Statistics of all records at one level.

    mean_ratio: None where a record overturned; max_ratio: of the records that did not overturn. median_ratio,
    p84_ratio: not exceeded by 50 % and 84 % of the records, an overturned one counting as the largest; None where that
    record overturned. figures: to how many significant figures, one at least, these stand in the nine runs of the
    records.
    """

    level_pga_g: float
    n: int
    overturned: int
    mean_ratio: float | None
    max_ratio: float | None
    median_ratio: float | None = None
    p84_ratio: float | None = None
    figures: int = 4


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


@dataclass(frozen=True, repr=False)
class AmplificationFactor(ShortRepr):
    """The factor by which a record is amplified up the building [-]."""

    record: str
    factor: float


@dataclass(frozen=True, repr=False)
class CarriedMotion(ShortRepr):
    """The record that is amplified most, scaled to the target, at the ground and at the base of the mechanism.

    Response spectra [k]: of 5 % damping.
    """

    record: str
    time_s: Floats
    ground_acceleration_g: Floats
    base_acceleration_g: Floats
    period_s: Floats
    ground_spectrum_g: Floats
    base_spectrum_g: Floats


@dataclass(frozen=True, repr=False)
class AmplificationResult(ShortRepr):
    """The amplification of the ground motion up to the mechanism.

    height_m: of its base above the ground, None where nothing is amplified; said: description of the method, with its
    numbers and assumptions; motion: present if the motion is filtered, not only multiplied.
    """

    method: str
    factors: tuple[AmplificationFactor, ...]
    height_m: float | None = None
    said: tuple[Message | str, ...] = ()
    motion: CarriedMotion | None = None
