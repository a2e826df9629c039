"""Rocking time histories, and the statistics of a suite of them."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.check import BranchName
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class Trace(ShortRepr):
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
    trace: Trace | None
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
