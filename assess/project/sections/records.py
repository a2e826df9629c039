"""The tables [records] and [records.select]: the ground motions, and which of many records make the suite."""

from __future__ import annotations

from typing import Annotated, Literal, TypeVar

from pydantic import (
    AfterValidator,
    Field,
    StrictBool,
    StrictInt,
    StrictStr,
    model_validator,
)

from assess.project.section import ProjectSection, error_at
from assess.project.values import (
    Acceleration,
    AccelerationUnit,
    Count,
    FilePlace,
    InputFile,
    InputFiles,
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


class Synthetic(ProjectSection):
    """Artificial records that fit the site's spectrum."""

    count: Annotated[Count, Field(le=1000)] = 7
    """how many"""
    seed: Annotated[StrictInt, Field(ge=0)] = 1
    """of the random numbers: the same seed makes the same records"""
    duration: Annotated[PositiveTime, Field(ge=8, le=600)] = 25.0
    """length of each record, like "25 s", which NTC 2018 asks for; ASCE 43-05 asks for 20 s"""


class Records(ProjectSection):
    """The ground motions: from files, artificial, or both; artificial ones where nothing is said."""

    files: InputFiles = ()
    """record files of any format known, names or patterns relative to the project file; their horizontal components;
    with `select` also folders"""
    select: Select | None = None
    """{ count, periods, scale_limits, one_per_event, … }: the best suite out of `files`; all of them if absent"""
    flatfile: InputFile | None = None
    """PEER flatfile in CSV, with magnitude, distance and Vs30 of the recordings, for `select`"""
    unit: AccelerationUnit | None = None
    """unit of acceleration, only for files that do not say theirs"""
    step: PositiveTime | None = None
    """time step, only for files that do not say theirs"""
    response: InputFile | None = None
    """StationXML of the instruments, for MiniSEED and SAC files in counts"""
    synthetic: Synthetic | None = Field(default_factory=lambda values: None if values["files"] else Synthetic())
    """{ count, seed, duration } of artificial records"""
    scale_to: Literal["spectrum", "pga", "none"] = "spectrum"
    """scale each record to the "spectrum" (least squares), to its "pga", or "none"; levels then multiply"""
    factor: PositiveRatio = 1.0
    """further factor on every record, like 1.05, where the mean of the suite falls short of what its code asks"""
    lock: FilePlace | None = None
    """file like "records.lock.toml", written by `assess records select PROJECT --lock`: its records and factors are
    used, and the other keys here say how it is made"""

    @property
    def selection(self) -> Select | None:
        """What the suite is selected by; nothing is selected for a locked one."""
        return self.select if self.lock is None else None

    @property
    def made(self) -> Synthetic | None:
        """The artificial records that are made; those of a lock are its own."""
        return self.synthetic if self.lock is None else None

    @property
    def further_factor(self) -> float:
        """The factor on every record; those of a lock include it."""
        return self.factor if self.lock is None else 1.0

    @model_validator(mode="after")
    def _select_has_files(self) -> Records:
        folders = [path for path in self.files if path.is_dir()]
        if self.select is None and folders:
            raise error_at("files", f'{folders[0]} is a folder; add `select`, or write a pattern like "records/*.AT2"')
        if self.select is not None and not self.files:
            raise error_at("select", "there are no files to choose from; add files")
        if self.select is not None and self.select.code is not None and self.synthetic is not None:
            raise error_at(
                "synthetic", "beside select.for, which makes a suite of recorded motions; remove one of them"
            )
        return self
