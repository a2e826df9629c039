"""The table [records.select]: which of many records make the suite."""

from __future__ import annotations

from typing import Annotated, Literal, TypeVar

from pydantic import AfterValidator, Field, StrictBool, StrictStr

from assess.project.section import ProjectSection
from assess.project.values import (
    Acceleration,
    Count,
    Length,
    NotNegativeRatio,
    PositiveRatio,
    PositiveTime,
    Ratio,
    Speed,
    Time,
)
from records.compliance import CodeName

T = TypeVar("T", bound=tuple[float, float])


def _rising(ends: T) -> T:
    if ends[0] > ends[1]:
        raise ValueError("the first is larger than the second; write [from, to]")
    return ends


Magnitudes = Annotated[tuple[Ratio, Ratio], AfterValidator(_rising)]
Lengths = Annotated[tuple[Length, Length], AfterValidator(_rising)]
Speeds = Annotated[tuple[Speed, Speed], AfterValidator(_rising)]
Accelerations = Annotated[tuple[Acceleration, Acceleration], AfterValidator(_rising)]
Times = Annotated[tuple[Time, Time], AfterValidator(_rising)]
Periods = Annotated[tuple[PositiveTime, PositiveTime], AfterValidator(_rising)]
Factors = Annotated[tuple[PositiveRatio, PositiveRatio], AfterValidator(_rising)]


class Select(ProjectSection):
    """The best suite out of many records."""

    code: CodeName | None = Field(default=None, alias="for")
    """code whose rules on suites are to be met, as far as they can be answered: the factor on the records, their number
    and records that break a rule by themselves are changed, or an error says which rule no suite meets"""
    count: Annotated[Count, Field(le=200)] = 7
    """how many records; with components = "together" how many recordings"""
    periods: Periods | None = None
    """[from, to] over which spectra are to fit; 0.2 times the least to 1.2 times the largest equivalent period of the
    mechanisms if absent, and with `for` the range of the code"""
    weights: tuple[tuple[PositiveTime, NotNegativeRatio], ...] = ()
    """[[period, weight], …], between them linear in log period; equal if absent"""
    scale_limits: Factors = (0.25, 4.0)
    """[least, largest] scale factor"""
    one_per_event: StrictBool = True
    """whether no two records may be of one earthquake"""
    fit: Literal["suite", "each"] = "suite"
    """what is to fit best: the mean spectrum of the "suite", or "each" record"""
    components: Literal["single", "together"] = "single"
    """each component a "single" record, or the components of a recording kept "together" with one factor"""
    magnitude: Magnitudes | None = None
    """[from, to]; a record whose magnitude is not known is left out, as below"""
    distance: Lengths | None = None
    """[from, to], like ["0 km", "50 km"]"""
    vs30: Speeds | None = None
    """[from, to], like ["360 m/s", "800 m/s"]"""
    pga: Accelerations | None = None
    """[from, to], before scaling"""
    duration: Times | None = None
    """[from, to] of D5-95"""
    events: tuple[StrictStr, ...] = ()
    """parts of the names of the earthquakes allowed; all if absent"""
