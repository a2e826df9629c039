"""The tables [records], [analysis] and [procedures.CODE]."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field, StrictBool, StrictInt, model_validator

from assess.codes.asce41_13.clauses import Masonry, Position, Seismicity
from assess.project.quantities import (
    AccelerationUnit,
    Count,
    FilePlace,
    InputFile,
    InputFiles,
    PositiveAcceleration,
    PositiveLength,
    PositiveRatio,
    PositiveTime,
    Ratio,
    Share,
    unique,
)
from assess.project.section import Section, wrong
from assess.project.sections.fragility import Fragility, Risk
from assess.project.sections.italian import Dmi2008, Ntc2018
from assess.project.sections.procedure_names import Procedure
from assess.project.sections.pulses import Pulses
from assess.project.sections.select import Select
from assess.project.sections.sensitivity import Asked
from assess.project.sections.sweeps import Sweep, Sweeps
from assess.project.sections.uncertainty import Uncertainty


class Synthetic(Section):
    """Artificial records that fit the site's spectrum."""

    count: Annotated[Count, Field(le=1000)] = 7
    """how many"""
    seed: Annotated[StrictInt, Field(ge=0)] = 1
    """of the random numbers: the same seed makes the same records"""
    duration: Annotated[PositiveTime, Field(ge=8, le=600)] = 25.0
    """length of each record, like "25 s", which NTC 2018 asks for; ASCE 43-05 asks for 20 s"""


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
            raise wrong("files", f'{folders[0]} is a folder; add `select`, or write a pattern like "records/*.AT2"')
        if self.select is not None and not self.files:
            raise wrong("select", "there are no files to choose from; add files")
        if self.select is not None and self.select.code is not None and self.synthetic is not None:
            raise wrong("synthetic", "beside select.for, which makes a suite of recorded motions; remove one of them")
        return self


class Analysis(Section):
    """What is asked."""

    levels: Annotated[tuple[PositiveAcceleration, ...], Field(min_length=1), AfterValidator(unique("level"))] | None = (
        None
    )
    """peak ground accelerations at which demands are compared; the site's own if absent"""
    procedures: Annotated[tuple[Procedure, ...], Field(min_length=1), AfterValidator(unique("procedure"))] | None = None
    """code procedures to apply; if absent all that apply at the site"""
    equation: Literal["exact", "linearised"] | None = None
    """equation of motion of the histories; if absent exact, and linearised for equivalent blocks"""
    scan: StrictBool = True
    """whether histories are run at rising PGA, up to a hundred levels, for their PGA at capacity; false: at the levels
    asked only, for thousands of walls: procedures by histories have no PGA at capacity then, nor the Italian a ζ_E"""
    pulses: Pulses | None = None
    """overturning envelopes: { shape, frequency = { from, to, count }, amplitude = { from, to, count } }"""
    sweep: Sweeps = ()
    """parametric studies: { key, values } or { key, from, to, count }, one or a list"""
    sensitivity: Asked = None
    """true, or { vary, thickness, density, … }: how the verdicts move with numbers that are not well known"""
    fragility: Fragility | None = None
    """a table [analysis.fragility] for `assess fragility`: { measures, states, method, samples, seed, … }"""
    risk: Risk | None = None
    """a table [analysis.risk] for `assess fragility`: the hazard of the site, { hazard | curve, site, target }"""
    uncertainty: Uncertainty | None = None
    """{ samples, seed, thickness }: how the answers spread when the numbers given as { mean, cov } vary together"""

    @property
    def sweeps(self) -> tuple[Sweep, ...]:
        """All sweeps, in order."""
        return self.sweep if isinstance(self.sweep, tuple) else (self.sweep,)


class Nzsee2017(Section):
    """Options of the face-loaded walls of NZSEE 2017, C8."""

    usable: Share | None = None
    """usable rotation over that at instability; if absent 0.6 for walls that span, 0.3 for those that stand free; a
    larger one is shown for comparison"""
    risk_factor: Annotated[Ratio, Field(ge=0.9)] = 1.0
    """risk factor R_p of the part, NZS 1170.5 Table 8.1"""
    c_0: PositiveAcceleration | None = None
    """C(0) at the site's own peak ground acceleration; needed where the spectrum is a table"""


class Asce41(Section):
    """Options of the permissible h/t of ASCE 41-13."""

    position: Position | None = None
    """row of Table 11-5: "one-storey", "first-storey", "top-storey" or "other"; if absent by [building], elevation"""
    masonry: Masonry | None = None
    """"coursed", or "rubble", which the table is not for; if absent a pass holds on condition that it is coursed"""
    seismicity: Seismicity = "high"
    """level of seismicity, on which the limit of parapets hangs: "high", h/t 1.5, or "moderate", 2.5"""
    s_x1: PositiveAcceleration | None = None
    """S_X1 at the site's own peak ground acceleration; if absent the spectrum at 1 s; needed where that is a table"""


class Ec8(Section):
    """Options of the check of non-structural elements of EN 1998-1, 4.3.5."""

    behaviour_factor: Annotated[Ratio, Field(ge=1, le=2)] | None = None
    """q_a of Table 4.4, 1 to 2; if absent 2.0 for walls that span, 1.0 for what stands free"""
    importance_factor: Annotated[Ratio, Field(ge=1)] = 1.0
    """gamma_a of the element, no less than 1: 1.5 where life depends on it"""
    alpha_s: PositiveAcceleration | None = None
    """alpha S at the site's own peak ground acceleration; needed where the spectrum is a table"""


class Asce4305(Section):
    """Options of ASCE/SEI 43-05."""

    allowable_sliding: PositiveLength | None = None
    """how far a body may slide on its base (A.1), like "0.05 m"; if absent its sliding is shown for information"""


class Procedures(Section):
    """Options of the code procedures, one table each."""

    asce43_05: Asce4305 = Field(alias="asce43-05", default_factory=Asce4305)
    """options of asce43-05-sliding"""
    dmi2008: Dmi2008 = Field(default_factory=Dmi2008)
    """options of the procedures dmi2008-…"""
    ntc2018: Ntc2018 = Field(default_factory=Ntc2018)
    """options of the procedures ntc2018-…"""
    nzsee2017: Nzsee2017 = Field(default_factory=Nzsee2017)
    """options of nzsee2017-face-loaded"""
    asce41_13: Asce41 = Field(default_factory=Asce41, alias="asce41-13")
    """options of asce41-13-ht"""
    ec8: Ec8 = Field(default_factory=Ec8)
    """options of ec8-element"""
