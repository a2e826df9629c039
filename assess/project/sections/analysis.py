"""The tables [records], [analysis], [procedures.CODE] and [report]."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import AfterValidator, Field, StrictInt, model_validator
from pydantic_core import PydanticCustomError

from assess.project.quantities import (
    AccelerationUnit,
    Count,
    InputFile,
    InputFiles,
    PositiveAcceleration,
    PositiveLength,
    PositiveTime,
    Ratio,
    unique,
)
from assess.project.section import Section, listed, wrong
from assess.project.sections.pulses import Pulses
from assess.project.sections.select import Select
from assess.project.sections.sweeps import Sweep, Sweeps

Procedure = Literal[
    "asce43-05-spectrum",
    "asce43-05-spectrum-thesis",
    "asce43-05-history",
    "dmi2008-linear",
    "dmi2008-nonlinear",
    "dmi2008-nonlinear-thesis",
    "asce43-05-sliding",
    "sliding",
]
PROCEDURES: tuple[Procedure, ...] = get_args(Procedure)
OF_FRICTION: tuple[Procedure, ...] = ("asce43-05-sliding", "sliding")  # nothing to ask where no friction is given


SOURCES = ("measured", "literature", "assumed")


def _begins_with_its_kind(text: str) -> str:
    if text.partition(":")[0].strip() not in SOURCES:
        raise PydanticCustomError(
            "project", "{reason}", {"reason": f"begin with {listed(SOURCES)}, then a colon and the source"}
        )
    return text


Source = Annotated[str, AfterValidator(_begins_with_its_kind)]


class Synthetic(Section):
    """Artificial records that fit the site's spectrum."""

    count: Annotated[Count, Field(le=1000)] = 7
    """how many"""
    seed: Annotated[StrictInt, Field(ge=0)] = 1
    """of the random numbers: the same seed makes the same records"""
    duration: Annotated[PositiveTime, Field(ge=8, le=600)] = 20.0
    """length of each record, like "20 s\""""


class Records(Section):
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

    @model_validator(mode="after")
    def _select_has_files(self) -> Records:
        folders = [path for path in self.files if path.is_dir()]
        if self.select is None and folders:
            raise wrong("files", f'{folders[0]} is a folder; add `select`, or write a pattern like "records/*.AT2"')
        if self.select is not None and not self.files:
            raise wrong("select", "there are no files to choose from; add files")
        return self


class Analysis(Section):
    """What is asked."""

    levels: Annotated[tuple[PositiveAcceleration, ...], Field(min_length=1), AfterValidator(unique("level"))] | None = (
        None
    )
    """peak ground accelerations at which demands are compared; the site's own if absent"""
    procedures: Annotated[tuple[Procedure, ...], Field(min_length=1), AfterValidator(unique("procedure"))] = PROCEDURES
    """procedures to apply; if absent all, those of sliding only where a material has friction"""
    equation: Literal["exact", "linearised"] | None = None
    """equation of motion of the histories; if absent exact, and linearised for equivalent blocks"""
    pulses: Pulses | None = None
    """overturning envelopes: { shape, frequency = { from, to, count }, amplitude = { from, to, count } }"""
    sweep: Sweeps = ()
    """parametric studies: { key, values } or { key, from, to, count }, one or a list"""

    @property
    def sweeps(self) -> tuple[Sweep, ...]:
        """Every sweep, in order."""
        return self.sweep if isinstance(self.sweep, tuple) else (self.sweep,)


class Dmi2008(Section):
    """Options of the Italian procedure (NTC 2008 with Circolare 617/2009)."""

    confidence_factor: Annotated[Ratio, Field(ge=1)] = 1.0
    """FC of the level of knowledge: LC1 1.35, LC2 1.20, LC3 1.00"""
    limit_states: Annotated[
        tuple[Literal["SLD", "SLV"], ...], Field(min_length=1), AfterValidator(unique("limit state"))
    ] = ("SLV",)
    """limit states to check"""


class Asce4305(Section):
    """Options of ASCE/SEI 43-05."""

    allowable_sliding: PositiveLength | None = None
    """how far a body may slide on its base (A.1), like "0.05 m"; if absent its sliding is shown for information"""


class Procedures(Section):
    """Options of the code procedures, one table each."""

    asce43_05: Asce4305 = Field(alias="asce43-05", default_factory=Asce4305)
    """options of asce43-05-sliding"""
    dmi2008: Dmi2008 = Field(default_factory=Dmi2008)
    """options of dmi2008-linear and dmi2008-nonlinear"""


class Report(Section):
    """How the report looks."""

    units: Literal["SI"] = "SI"
    """units of the report"""
    paper: Literal["A4", "letter"] = "A4"
    """paper size"""
    sources: dict[str, Source] = Field(default_factory=dict)
    """where values come from: a key of this file, or the beginning of one, with "measured: …", "literature: …" or
    "assumed: …\""""
