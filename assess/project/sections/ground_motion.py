"""The tables [site], [building] and [records]: the site's spectrum, the structure below, and the ground motions.

[site.spectrum] has one class for each way to give a spectrum; [records.select] says which of many records make the
suite.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal, TypeVar

from pydantic import AfterValidator, Discriminator, Field, StrictBool, StrictInt, StrictStr, Tag, model_validator

from assess.codes.context import default_period
from assess.declaration import (
    FREE,
    UNCERTAIN,
    Acceleration,
    Count,
    Damping,
    Evidence,
    Length,
    NotNegativeLength,
    NotNegativeRatio,
    PositiveAcceleration,
    PositiveFrequency,
    PositiveLength,
    PositiveRatio,
    PositiveTime,
    PositiveYears,
    Ratio,
    RatioToOne,
    Speed,
    Time,
)
from assess.project.section import (
    AccelerationUnit,
    FilePlace,
    InputFile,
    InputFiles,
    ProjectSection,
    error_at,
    quote_names,
)
from records.compliance import CodeName

ASCE7 = ("asce7-05", "ibc2009", "asce7-10", "asce7-16")
NTC = ("ntc2008", "ntc2018")
SPECTRA = (*ASCE7, "ec8", "nzs1170.5", *NTC, "table")
MAPPED = ("s_s", "s_1", "site_class")  # in place of s_ds and s_d1
LIVES = ("nominal_life", "use_class")  # of a hazard over return periods
LIMIT_STATES = ("SLO", "SLD", "SLV", "SLC")
Asce7Code = Literal["asce7-05", "ibc2009", "asce7-10", "asce7-16"]


class Damped(ProjectSection):
    """What every spectrum may say."""

    damping: Damping = 0.05
    """damping ratio of the spectrum"""


class Asce7Spectrum(Damped):
    """Design spectrum of ASCE 7 (IBC 2009 refers to 7-05), from its two design ordinates."""

    code: Asce7Code
    """name and edition of the code; "ibc2009" has the shape of "asce7-05\""""
    s_ds: PositiveAcceleration
    """design spectral acceleration at short periods, like "0.167 g"; or give s_s, s_1 and site_class"""
    s_d1: PositiveAcceleration
    """design spectral acceleration at 1 s, like "0.053 g\""""
    t_l: PositiveTime
    """long-period transition period, like "6 s\""""
    hazard: Literal["design", "mce"] = "design"
    """"design", or "mce": the maximum considered earthquake, 1.5 times the design spectrum"""


class Asce7MappedSpectrum(Damped):
    """Design spectrum of ASCE 7 from the mapped accelerations of the rock and the site class."""

    elsewhere: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("s_ds", "s_d1"), "follows from s_s, s_1 and site_class; remove it, or those three"
    )

    code: Asce7Code
    """name and edition of the code; "ibc2009" has the coefficients of "asce7-05\""""
    s_s: PositiveAcceleration
    """mapped spectral acceleration at short periods, like "0.25 g\""""
    s_1: PositiveAcceleration
    """mapped spectral acceleration at 1 s, like "0.08 g\""""
    site_class: Literal["A", "B", "B-unmeasured", "C", "D", "D-default", "E", "F"]
    """site class "A" to "E"; in asce7-16 also "B-unmeasured" and "D-default\""""
    t_l: PositiveTime
    """long-period transition period, like "6 s\""""
    hazard: Literal["design", "mce"] = "design"
    """"design", or "mce": the maximum considered earthquake, 1.5 times the design spectrum"""


class Ec8Spectrum(Damped):
    """Elastic spectrum of EN 1998-1 with its recommended values."""

    code: Literal["ec8"]
    """"ec8\""""
    a_g: PositiveAcceleration
    """reference peak ground acceleration on type A ground, a_gR, like "0.25 g\""""
    ground_type: Literal["A", "B", "C", "D", "E", "S1", "S2"]
    """ground type "A" to "E\""""
    type: Literal[1, 2] = 1
    """1 where earthquakes above magnitude 5.5 govern, else 2"""
    importance_factor: PositiveRatio = 1.0
    """gamma_I: 0.8, 1.0, 1.2, 1.4 for importance classes I to IV"""


class Nzs1170Spectrum(Damped):
    """Elastic site spectrum of NZS 1170.5."""

    code: Literal["nzs1170.5"]
    """"nzs1170.5\""""
    subsoil: Literal["A", "B", "C", "D", "E"]
    """site subsoil class, "A" (strong rock) to "E" (very soft)"""
    z: PositiveRatio
    """hazard factor Z, like 0.13 in Auckland"""
    r: PositiveRatio | None = None
    """return period factor R, 1.0 for 500 years; or give return_period"""
    return_period: PositiveYears | None = None
    """return period, 20 to 2500 years, in place of r"""
    near_fault_distance: NotNegativeLength | None = None
    """distance to the nearest major fault, like "8 km"; absent: none is near"""

    @model_validator(mode="after")
    def _one_return_period(self) -> Nzs1170Spectrum:
        if (self.r is None) == (self.return_period is None):
            raise error_at("r", "give either r, the return period factor, or return_period")
        return self


NtcCode = Literal["ntc2008", "ntc2018"]


class NtcSpectrum(Damped):
    """Elastic spectrum of NTC 2008 or 2018 from the hazard at one return period."""

    elsewhere: ClassVar[Mapping[str, str]] = {
        "limit_state": "write it in [site]",
        **dict.fromkeys(
            LIVES, "goes with hazard = [{ return_period, a_g, f_0, t_c_star }, …]; remove it, or a_g, f_0 and t_c_star"
        ),
    }

    code: NtcCode
    """name and edition of the code"""
    a_g: PositiveAcceleration
    """peak ground acceleration on rock, like "0.15 g"; or give hazard = [{ return_period, a_g, f_0, t_c_star }, …]"""
    f_0: PositiveRatio
    """largest amplification of the spectrum on rock, F_0, like 2.4"""
    t_c_star: PositiveTime
    """T_C*, where the level branch on rock ends, like "0.3 s\""""
    soil: Literal["A", "B", "C", "D", "E", "S1", "S2"]
    """subsoil category "A" to "E\""""
    topography: Literal["T1", "T2", "T3", "T4"] = "T1"
    """topographic category"""
    relief_position: RatioToOne = 1.0
    """1 at the top of the relief, 0 at its foot"""


class HazardRow(ProjectSection):
    """The hazard on rock at one return period."""

    return_period: PositiveYears
    """return period, like 475: in years"""
    a_g: PositiveAcceleration
    """peak ground acceleration on rock, like "0.15 g\""""
    f_0: PositiveRatio
    """largest amplification of the spectrum on rock, F_0, like 2.4"""
    t_c_star: PositiveTime
    """T_C*, where the level branch on rock ends, like "0.3 s\""""


class NtcHazardSpectrum(Damped):
    """Elastic spectrum of NTC 2008 or 2018 at a limit state, from the hazard over return periods."""

    elsewhere: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("a_g", "f_0", "t_c_star"), "stands in the rows of hazard; remove it here, or hazard"
    )

    code: NtcCode
    """name and edition of the code"""
    hazard: Annotated[tuple[HazardRow, ...], Field(min_length=2)]
    """rows { return_period, a_g, f_0, t_c_star }, rising in return period"""
    nominal_life: PositiveYears
    """nominal life V_N, like 50: in years"""
    use_class: Literal["I", "II", "III", "IV"] | None = None
    """class of use "I" to "IV"; that of [building] if absent"""
    limit_state: Literal["SLO", "SLD", "SLV", "SLC"] | None = None
    """old spelling of [site] limit_state"""
    soil: Literal["A", "B", "C", "D", "E", "S1", "S2"]
    """subsoil category "A" to "E\""""
    topography: Literal["T1", "T2", "T3", "T4"] = "T1"
    """topographic category"""
    relief_position: RatioToOne = 1.0
    """1 at the top of the relief, 0 at its foot"""


class TableSpectrum(Damped):
    """A spectrum read from a file of periods and accelerations."""

    code: Literal["table"]
    """"table\""""
    file: InputFile
    """CSV of period and acceleration, with units in the header"""


def _spectrum_tag(values: Any) -> str | None:
    code = values.get("code") if isinstance(values, dict) else None
    if code in ASCE7:
        return "<mapped>" if any(key in values for key in MAPPED) else "<asce7>"
    if code in NTC:
        return "<hazard>" if "hazard" in values else "<ntc>"
    return f"<{code}>" if code in SPECTRA else None


SpectrumSection = Annotated[
    Annotated[Asce7Spectrum, Tag("<asce7>")]
    | Annotated[Asce7MappedSpectrum, Tag("<mapped>")]
    | Annotated[Ec8Spectrum, Tag("<ec8>")]
    | Annotated[Nzs1170Spectrum, Tag("<nzs1170.5>")]
    | Annotated[NtcSpectrum, Tag("<ntc>")]
    | Annotated[NtcHazardSpectrum, Tag("<hazard>")]
    | Annotated[TableSpectrum, Tag("<table>")],
    Discriminator(
        _spectrum_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("code",), "names": quote_names(SPECTRA)},
    ),
]


SITE_PGA = Evidence(
    "defines",
    "down",
    "that of the spectrum, where more",
    judged="the hazard defines the case, but a PGA below that of the spectrum scales the hazard of the code down",
)
ACTION_OF = Evidence("defines", "either", "absent: incomplete where the basis fixes one")
VERTICAL_RATIO = Evidence("code", "down", "1.0 at the ground; on a floor the vertical floor spectrum, or not answered")


class SiteSection(ProjectSection):
    """What the ground demands."""

    spectrum: SpectrumSection
    """a table [site.spectrum] with the code and its parameters"""
    pga: Annotated[PositiveAcceleration | None, SITE_PGA] = None
    """scales the spectrum's ordinates to this peak ground acceleration, corner periods fixed"""
    limit_state: Annotated[StrictStr | None, ACTION_OF] = None
    """what the site's own action stands for, like "SLV", "ULS" or "DBE", without a hazard over return periods"""
    vertical_ratio: Annotated[NotNegativeRatio, VERTICAL_RATIO] = 0.0
    """vertical over horizontal spectral acceleration, for F_V of ASCE 43-05"""

    @model_validator(mode="after")
    def _one_limit_state(self) -> SiteSection:
        old = self.spectrum.limit_state if isinstance(self.spectrum, NtcHazardSpectrum) else None
        if old is not None and self.limit_state is not None and old != self.limit_state:
            raise error_at("limit_state", f'site.spectrum.limit_state, its old spelling, is "{old}"; give one')
        if isinstance(self.spectrum, NtcHazardSpectrum) and self.limit_state not in (None, *LIMIT_STATES):
            raise error_at(
                "limit_state", f"not one of the hazard over return periods; write one of {quote_names(LIMIT_STATES)}"
            )
        return self

    @property
    def own_limit_state(self) -> str | None:
        """The limit state that the site's own action stands for, in either spelling; None if not stated."""
        old = self.spectrum.limit_state if isinstance(self.spectrum, NtcHazardSpectrum) else None
        return self.limit_state or old


SOFTENED_PERIOD = Evidence("measured", "either", "the worst over 1.5 to 2.0 times the period of the elastic building")


class LimitStatePeriod(ProjectSection):
    """First mode of the building at one limit state, in place of the range of softened periods."""

    period: Annotated[PositiveTime, SOFTENED_PERIOD]
    """period of the first mode at this limit state, like "0.5 s\""""
    damping: Annotated[Damping, Evidence("measured", "up", "10 %; never above 30 %")]
    """its damping ratio"""
    reason: Annotated[StrictStr, FREE]
    """why, for the report"""


BUILDING_HEIGHT = Evidence(
    "drawn",
    "up",
    "the top of the highest body, where it is more than 10 % above that",
    judged="in a taller building a mechanism stands relatively lower",
)
STOREYS = Evidence(
    "drawn", "down", "as drawn", judged="the first mode of many storeys moves the top more than that of one"
)
GROUND_ELEVATION = Evidence(
    "drawn",
    "up",
    "0 where the lowest body stands there, else not answered",
    judged="the higher the ground, the less a mechanism stands above it",
)
USE_CLASS = Evidence(
    "defines",
    "down",
    "absent: a failing SLD makes ntc2018 incomplete",
    judged="a lower class has shorter return periods, and no SLD that decides",
)
SCHOOL = Evidence(
    "defines",
    "either",
    "absent: an improvement in class III is incomplete",
    judged="a school is to reach 0.60, another building 0.10 above the index before, which may be more or less",
)
FIRST_PERIOD = Evidence(
    "measured", "either", "the worst from it to 0.05 H^0.75; beyond 0.5 to 4 times that only a test counts"
)
FIRST_DAMPING = Evidence("measured", "up", "5 %; above 10 % only measured, never above 30 %")
FIRST_FREQUENCY = Evidence("measured", "either", "the worst from it to that of 0.05 H^0.75")
EFFECTIVE_HEIGHT = Evidence(
    "measured",
    "up",
    "Rayleigh's of the bodies as drawn",
    judged="the higher the resultant of the first mode, the less of it acts at a given height",
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
    """class of use "I" to "IV", of the Italian codes"""
    school: Annotated[StrictBool | None, SCHOOL] = None
    """whether the building is a school, for the targets of NTC 8.4.2"""
    period: Annotated[PositiveTime, UNCERTAIN, FIRST_PERIOD] | None = Field(
        default_factory=lambda values: None if values.get("height") is None else default_period(values["height"])
    )
    """period of the first mode; 0.05 H^0.75 if absent"""
    damping: Annotated[Damping, FIRST_DAMPING] = 0.05
    """damping ratio of the first mode"""
    natural_frequency: Annotated[PositiveFrequency | None, FIRST_FREQUENCY] = None
    """first natural frequency for `amplification`, like "2.5 Hz"; 1 / period where that is given, else Rayleigh's"""
    limit_states: dict[Literal["SLV", "SLC"], LimitStatePeriod] = Field(default_factory=dict)
    """{ SLV = { period, damping, reason } }: the building at a limit state, for displacements by ntc2018; 1.5 to 2.0
    times its period if absent"""
    effective_height: Annotated[PositiveLength | None, EFFECTIVE_HEIGHT] = None
    """height above the ground of the resultant of the first mode's inertia forces, for `amplification`"""


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


FILTER = Evidence(
    "action",
    "either",
    "the default",
    judged="of many suites that fit, some are kinder than a fair one",
)
SUITE_SIZE = Evidence(
    "action",
    "up",
    "as stated; of fewer than seven the largest decides",
    judged="of seven records and more the mean counts",
)


class Select(ProjectSection):
    """The best suite out of many records."""

    evidence = FILTER

    code: Annotated[CodeName | None, Evidence("action", "either", "the rules of the basis")] = Field(
        default=None, alias="for"
    )
    """code whose rules on suites are to be met, as far as they can be answered: the factor on the records, their number
    and records that break a rule by themselves are changed, or an error says which rule no suite meets"""
    count: Annotated[Count, Field(le=200), SUITE_SIZE] = 7
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


SEED = Evidence("action", "either", "the hash of target and recipe; both suites run, the worse decides")


class Synthetic(ProjectSection):
    """Artificial records that fit the site's spectrum."""

    count: Annotated[Count, Field(le=1000), SUITE_SIZE] = 7
    """how many"""
    seed: Annotated[StrictInt, Field(ge=0), SEED] = 1
    """of the random numbers: the same seed makes the same records"""
    duration: Annotated[PositiveTime, Field(ge=8, le=600), Evidence("action", "down", "25 s; 20 s for ASCE 43-05")] = (
        25.0
    )
    """length of each record, like "25 s", which NTC 2018 asks for; ASCE 43-05 asks for 20 s"""


RECORD_FILES = Evidence(
    "action", "either", "as given; of fewer than seven the largest decides, below 11 natural ones page 1 says so"
)
AS_FILES_SAY = Evidence("action", "either", "as the files of records say")
SCALE_TO = Evidence(
    "action",
    "either",
    '"spectrum"',
    judged="a record may exceed what it is scaled to by the one measure and not by the other",
)
LOCK = Evidence("action", "either", "the suite that its recipe selects")


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
    synthetic: Synthetic | None = Field(default_factory=lambda values: None if values["files"] else Synthetic())
    """{ count, seed, duration } of artificial records"""
    scale_to: Annotated[Literal["spectrum", "pga", "none"], SCALE_TO] = "spectrum"
    """scale each record to the "spectrum" (least squares), to its "pga", or "none"; levels then multiply"""
    factor: Annotated[PositiveRatio, Evidence("action", "down", "1.0, where less")] = 1.0
    """further factor on every record, like 1.05, where the mean of the suite falls short of what its code asks"""
    lock: Annotated[FilePlace | None, LOCK] = None
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
