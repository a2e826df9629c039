"""The tables [site], [building] and [records]: the site's spectrum, the structure below, and the ground motions.

[site.spectrum] is made of the ways to give a spectrum (`spectra.design_spectra`); [records.select] says which of many
records make the suite.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Field, StrictBool, StrictStr, model_validator

from assess.codes.asce43_05 import VERTICAL_RATIO
from assess.codes.context import StatedFirstMode, default_period
from assess.declaration import (
    UNCERTAIN,
    BuildingDamping,
    Count,
    Drawn,
    Evidence,
    IsRange,
    Length,
    NotNegativeRatio,
    Number,
    PositiveAcceleration,
    PositiveFrequency,
    PositiveLength,
    PositiveRatio,
    PositiveTime,
    PositiveYears,
    Range,
    Safe,
    Tried,
)
from assess.messages.message import Term
from assess.project.key_errors import error_at, quote_names
from assess.project.section import DeclaredSection, ProjectSection, plain_data, table_of
from assess.project.tables import table_by_code
from assess.project.values import AccelerationUnit, FilePlace, InputFile, InputFiles
from records.compliance import CodeName
from records.selection import CandidateFilters
from records.synthetic import SUITE_SIZE, ArtificialRecords
from spectra import ntc
from spectra.design_spectra import SPECTRA, USE_CLASSES, NtcOverYears, Nzs1170Spectrum, spectrum_class

LIMIT_STATES = tuple(ntc.EXCEEDANCE)  # of a hazard over return periods
if TYPE_CHECKING:
    SpectrumSection = DeclaredSection
else:
    SpectrumSection = table_by_code(SPECTRA, spectrum_class)


SITE_PGA = Evidence(
    "defines",
    "down",
    "that of the spectrum, where more",
    judged="the hazard defines the case, but a PGA below that of the spectrum scales the hazard of the code down",
)
ACTION_OF = Evidence("defines", "either", "absent: incomplete where the basis fixes one")
RETURN_PERIOD = Evidence(
    "defines",
    "up",
    "absent: incomplete for a table, a condition by the Italian codes",
    judged="one that is shorter than that of the limit state leaves the verdict incomplete",
)
OF_VERTICAL = Evidence("code", "down", "1.0", safe=VERTICAL_RATIO)


class SiteSection(ProjectSection):
    """What the ground demands."""

    spectrum: SpectrumSection
    """a table [site.spectrum] with the code and its parameters"""
    pga: Annotated[PositiveAcceleration | None, SITE_PGA] = None
    """scales the spectrum's ordinates to this peak ground acceleration, corner periods fixed"""
    limit_state: Annotated[StrictStr | None, ACTION_OF] = None
    """what the site's own action stands for, like "SLV", "ULS" or "DBE", without a hazard over return periods"""
    return_period: Annotated[PositiveYears | None, RETURN_PERIOD] = None
    """return period of a single spectrum, like 475: in years; of `hazard` and of nzs1170.5 see [site.spectrum]"""
    vertical_ratio: Annotated[NotNegativeRatio, OF_VERTICAL] = VERTICAL_RATIO
    """vertical over horizontal spectral acceleration of the ground, for F_V and A_v of ASCE 43-05"""

    @model_validator(mode="after")
    def _one_limit_state(self) -> SiteSection:
        old = getattr(self.spectrum, "limit_state", None)
        if old is not None and self.limit_state is not None and old != self.limit_state:
            raise error_at("limit_state", f'site.spectrum.limit_state, its old spelling, is "{old}"; give one')
        if self.hazard is not None and self.limit_state not in (None, *LIMIT_STATES):
            raise error_at(
                "limit_state", f"not one of the hazard over return periods; write one of {quote_names(LIMIT_STATES)}"
            )
        if self.return_period is not None and self.hazard is not None:
            raise error_at("return_period", "of a hazard over return periods the limit state gives it; remove it")
        if self.return_period is not None and isinstance(self.spectrum.plain, Nzs1170Spectrum):
            code = self.spectrum.code
            raise error_at("return_period", f'of code = "{code}" it stands in [site.spectrum]; remove it here')
        return self

    @property
    def own_limit_state(self) -> str | None:
        """The limit state that the site's own action stands for, in either spelling; None if not stated."""
        return self.limit_state or getattr(self.spectrum, "limit_state", None)

    @property
    def hazard(self) -> NtcOverYears | None:
        """The hazard over return periods that its spectrum follows from; None if that is given otherwise."""
        way = self.spectrum.plain
        return way if isinstance(way, NtcOverYears) else None


BUILDING_HEIGHT = Evidence(
    "drawn",
    "up",
    "the top of the highest body, where it is more than 10 % above that",
    judged="in a taller building a mechanism stands relatively lower",
    safe=Drawn("height"),
)
STOREYS = Evidence(
    "defines", "down", "as drawn", judged="the first mode of many storeys moves the top more than that of one"
)
GROUND_ELEVATION = Evidence(
    "drawn",
    "up",
    "the foot of the lowest body, where that is lower",
    judged="the higher the ground, the less a mechanism stands above it",
    safe=Drawn("ground"),
)
USE_CLASS = Evidence(
    "defines",
    USE_CLASSES,
    "absent: a failing SLD makes ntc2018 incomplete",
    judged="a lower class has shorter return periods, and no SLD that decides",
)
IMPORTANCE_LEVEL = Evidence(
    "defines",
    "down",
    "absent: nzsee2017 is incomplete",
    judged="a higher level has a longer return period",
)
SCHOOL = Evidence(
    "defines",
    "either",
    "absent: an improvement in class III is incomplete",
    judged="a school is to reach 0.60, another building 0.10 above the index before, which may be more or less",
)
FIRST_PERIOD = Evidence(
    "measured",
    "either",
    "the worst from it to 0.05 H^0.75; beyond 0.5 to 4 times that only a test counts",
    safe=Range((Tried(Safe.ABSENT, "0.05 H^0.75"),), up_to="period"),
)
FIRST_DAMPING = Evidence("measured", "up", "5 %; above 10 % only measured, never above 30 %", safe=0.05)
FIRST_FREQUENCY = Evidence(
    "measured",
    "either",
    "the worst from it to that of 0.05 H^0.75, and Rayleigh's",
    safe=Range((Tried(Safe.ABSENT, str(Term("that of the building's period, or Rayleigh's"))),), up_to="frequency"),
)
EFFECTIVE_HEIGHT = Evidence(
    "measured",
    "up",
    "two thirds of the height as drawn",
    judged="the higher the resultant of the first mode, the less of it acts at a given height",
    safe=Drawn("resultant"),
)


class BuildingSection(ProjectSection):
    """The structure below a mechanism; what the clauses for mechanisms above ground need."""

    height: Annotated[PositiveLength | None, BUILDING_HEIGHT] = None
    """height above ground_elevation, like "9 m\""""
    storeys: Annotated[Count | None, STOREYS] = None
    """number of storeys"""
    ground_elevation: Annotated[Length | None, GROUND_ELEVATION] = None
    """elevation of the ground in the coordinates of the bodies; 0 if absent and the lowest body stands there"""
    use_class: Annotated[Literal["I", "II", "III", "IV"] | None, USE_CLASS] = None
    """class of use "I" to "IV", of the Italian codes, and importance class of EN 1998-1; if absent a hazard over return
    periods is read as for IV, with which the verdict is provisional"""
    importance_level: Annotated[int | None, Number(least=1, most=4), IMPORTANCE_LEVEL] = None
    """importance level 1 to 4 of NZS 1170.0, for nzsee2017: ULS at 100, 500, 1000 or 2500 years; by EN 1998-1 the
    importance class of that rank where no use_class is given"""
    school: Annotated[StrictBool | None, SCHOOL] = None
    """whether the building is a school, for the targets of NTC 8.4.2"""
    period: Annotated[PositiveTime, UNCERTAIN, FIRST_PERIOD] | None = Field(
        default_factory=lambda values: None if values.get("height") is None else default_period(values["height"])
    )
    """period of the first mode; 0.05 H^0.75 if absent"""
    damping: Annotated[BuildingDamping, FIRST_DAMPING] = 0.05
    """damping ratio of the first mode"""
    natural_frequency: Annotated[PositiveFrequency | None, FIRST_FREQUENCY] = None
    """first natural frequency for `amplification`, like "2.5 Hz"; 1 / period where that is given, else Rayleigh's"""
    limit_states: dict[Literal["SLV", "SLC"], StatedFirstMode] = Field(default_factory=dict)
    """{ SLV = { period, damping, reason } }: the building at a limit state, for displacements by ntc2018; 1.5 to 2.0
    times its period if absent"""
    effective_height: Annotated[PositiveLength | None, EFFECTIVE_HEIGHT] = None
    """height above the ground of the resultant of the first mode's inertia forces, for `amplification`; if absent
    Rayleigh's, else that of the linear mode of Circolare 7/2019, C7.2.10, with which the verdict is provisional"""

    @model_validator(mode="after")
    def _can_be(self) -> BuildingSection:
        if self.height is not None and self.effective_height is not None and self.effective_height > self.height:
            raise error_at("effective_height", f"above the building, height = {self.height:.4g} m")
        for name, state in self.limit_states.items():
            if self.period is not None and state.period < self.period:
                reason = f"shorter than that of the elastic building, {self.period:.4g} s: damage softens it"
                raise error_at(("limit_states", name, "period"), reason)
        return self


FILTER = Evidence(
    "action",
    "either",
    "the default",
    judged="of many suites that fit, some are kinder than a fair one",
)


class Recipe(DeclaredSection):
    """How a suite is selected; which records may be in it stands beside."""

    evidence = FILTER

    code: Annotated[CodeName | None, Evidence("action", "either", "the rules of the basis")] = Field(
        default=None, alias="for"
    )
    """code whose rules on suites are to be met, as far as they can be answered: the factor on the records, their number
    and records that break a rule by themselves are changed, or an error says which rule no suite meets"""
    count: Annotated[int, Number(least=1, most=200), SUITE_SIZE] = 7
    """how many records; with components = "together" how many recordings"""
    periods: Annotated[tuple[PositiveTime, PositiveTime], IsRange()] | None = None
    """[from, to] over which spectra are to fit; 0.2 times the least to 1.2 times the largest equivalent period of the
    mechanisms if absent, and with `for` the range of the code"""
    weights: tuple[tuple[PositiveTime, NotNegativeRatio], ...] = ()
    """[[period, weight], …], between them linear in log period; equal if absent"""
    scale_limits: Annotated[tuple[PositiveRatio, PositiveRatio], IsRange()] = (0.25, 4.0)
    """[least, largest] scale factor"""
    one_per_event: StrictBool = True
    """whether no two records may be of one earthquake"""
    fit: Literal["suite", "each"] = "suite"
    """what is to fit best: the mean spectrum of the "suite", or "each" record"""
    components: Literal["single", "together"] = "single"
    """each component a "single" record, or the components of a recording kept "together" with one factor"""


if TYPE_CHECKING:
    SelectKeys = Recipe
else:
    SelectKeys = table_of(CandidateFilters, base=Recipe)


class Select(SelectKeys):
    """The best suite out of many records."""


RECORD_FILES = Evidence(
    "action", "either", "as given; of fewer than seven the largest decides, below 11 natural ones page 1 says so"
)
AS_FILES_SAY = Evidence("action", "either", "as the files of records say")
SCALE_TO = Evidence(
    "action",
    "either",
    '"spectrum"',
    judged="a record may exceed what it is scaled to by the one measure and not by the other",
    safe=Safe.ABSENT,
)
LOCK = Evidence("action", "either", "the suite that its recipe selects")


def _made_without_files(values: Mapping[str, Any]) -> Any:
    return None if values["files"] else table_of(ArtificialRecords)()


class Records(ProjectSection):
    """The ground motions: from files, artificial, or both; artificial ones where nothing is said."""

    files: Annotated[InputFiles, RECORD_FILES] = ()
    """record files of any format known, names or patterns relative to the project file; their horizontal components;
    with `select` also folders"""
    select: Select | None = None
    """{ count, periods, scale_limits, one_per_event, … }: the best suite out of `files`; all of them if absent"""
    flatfile: Annotated[InputFile | None, AS_FILES_SAY] = None
    """PEER flatfile in CSV, with magnitude, distance and Vs30 of the recordings, for `select`"""
    unit: Annotated[AccelerationUnit | None, AS_FILES_SAY] = None
    """unit of acceleration, only for files that do not say theirs"""
    step: Annotated[PositiveTime | None, AS_FILES_SAY] = None
    """time step, only for files that do not say theirs"""
    response: Annotated[InputFile | None, AS_FILES_SAY] = None
    """StationXML of the instruments, for MiniSEED and SAC files in counts"""
    synthetic: ArtificialRecords | None = Field(default_factory=_made_without_files)
    """{ count, seed, duration } of artificial records"""
    scale_to: Annotated[Literal["spectrum", "pga", "none"], SCALE_TO] = "spectrum"
    """scale each record to the "spectrum" (least squares), to its "pga", or "none"; levels then multiply"""
    factor: Annotated[PositiveRatio, Evidence("action", "down", "1.0, where less", safe=1.0)] = 1.0
    """further factor on every record, like 1.05, where the mean of the suite falls short of what its code asks"""
    lock: Annotated[FilePlace | None, LOCK] = None
    """file like "records.lock.toml", written by `assess records select PROJECT --lock`: its records and factors are
    used, and the other keys here say how it is made"""

    @property
    def selection(self) -> Select | None:
        """What the suite is selected by; nothing is selected for a locked one."""
        return self.select if self.lock is None else None

    @property
    def made(self) -> ArtificialRecords | None:
        """The artificial records that are made; those of a lock are its own."""
        return plain_data(self.synthetic) if self.lock is None else None

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
