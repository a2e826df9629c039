"""The ways to give a design spectrum, one class each: its keys, how they go together, and the spectra of them.

The table [site.spectrum] of a project file is made of such a class, and `spectra.registry` makes it of the arguments of
Python; both check it by what it declares. Numbers are in SI, times of hazards and buildings in years.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, get_args

from assess.declaration import (
    UNCERTAIN,
    Damping,
    Evidence,
    Fault,
    IsInputFile,
    NominalLife,
    NotAKey,
    NotNegativeLength,
    Number,
    PositiveAcceleration,
    PositiveRatio,
    PositiveTime,
    PositiveYears,
    RatioToOne,
    Safe,
    Several,
)
from spectra import asce7, asce7_22, ec8, ntc, ntc_grid, nzs1170_5, ts1170_5
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum
from spectra.table import read_table, table_spectrum

THE_CODE = Evidence("defines", "either", "the code that the basis of the verdict names")
USE_CLASSES = ("IV", "III", "II", "I")
"""The classes of use from the one with the longest return periods."""
HAZARD = Evidence("defines", "down", "as stated")
CORNER = Evidence("defines", "down", "as stated", judged="it lifts long periods, which overturn a wall")
PEAK = Evidence("defines", "either", "as stated", judged="the level branch rises with it, and the soil factor falls")
GROUND = Evidence("defines", "either", "as stated", judged="soft ground lifts long periods, and strong motion little")
TOPOGRAPHY = Evidence("defines", ("T4", "T3", "T2", "T1"), "as stated", judged="S_T grows from T1 to T4")
RELIEF = Evidence("drawn", "down", "1, the top of the relief", safe=1.0)
LEVEL = Evidence("chosen", "either", "both levels stand beside each other", judged="what is asked of a wall rises too")
PHASE = Evidence("chosen", ("use", "works"), '"use"; "works" is a condition', judged="it allows a shorter nominal life")
DAMPED = Evidence("measured", "up", "5 %; above 10 % only measured, never above 30 %", safe=0.05)
DAMPED_TABLE = Evidence("defines", "down", "as stated", judged="damped more, the same ordinates mean more at 5 %")

Asce7Code = Annotated[Literal["asce7-05", "ibc2009", "asce7-10", "asce7-16"], THE_CODE]
NtcCode = Annotated[Literal["ntc2008", "ntc2018"], THE_CODE]
Asce7Level = Annotated[Literal["design", "mce"], LEVEL]
NtcSoil = Annotated[Literal["A", "B", "C", "D", "E", "S1", "S2"], GROUND]
Topography = Annotated[Literal["T1", "T2", "T3", "T4"], TOPOGRAPHY]
HazardAcceleration = Annotated[PositiveAcceleration, HAZARD]
CornerAcceleration = Annotated[PositiveAcceleration, CORNER]
CornerTime = Annotated[PositiveTime, CORNER]
PeakRatio = Annotated[PositiveRatio, PEAK]
LimitState = Literal["SLO", "SLD", "SLV", "SLC"]
LEAST_LIFE = 10.0  # nominal life of what is not a phase of construction [years] (NTC 2018, 2.4.1)
DEFAULT_STATE: LimitState = "SLV"
AT_LEAST_TWO = Several(2, form="give rows of return_period, a_g, f_0 and t_c_star")


@dataclass(frozen=True, kw_only=True)
class DesignSpectrum:
    """A way to give a design spectrum; what all of them may say.

    form : its short name
    own_keys : keys that tell it from the usual way of its code
    other_keys : keys of another way of its code, each with what is wrong about it here
    """

    form: ClassVar[str]
    own_keys: ClassVar[tuple[str, ...]] = ()
    other_keys: ClassVar[Mapping[str, str]] = {}
    damping: Annotated[Damping, DAMPED] = 0.05
    """damping ratio of the spectrum"""
    code: str

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        yield from ()

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the horizontal spectrum as its code gives it, before `damping`.

        pga : that it will be scaled to [m/s2]; it stands in for the zero-period ordinate that a table may lack
        """
        raise NotImplementedError(type(self).__name__)

    def vertical(self) -> Spectrum:
        """Return the vertical spectrum as its code gives it, before `damping`; SpectrumError for codes without one."""
        have = (code for code, (way, *_) in SPECTRA.items() if way.vertical is not DesignSpectrum.vertical)
        raise SpectrumError(f"code = {self.code} has no vertical spectrum here; {', '.join(have)} have")


@dataclass(frozen=True, kw_only=True)
class Asce7Spectrum(DesignSpectrum):
    """Design spectrum of ASCE 7 (IBC 2009 refers to 7-05), from its two design ordinates."""

    form = "asce7"
    code: Asce7Code
    """name and edition of the code; "ibc2009" has the shape of "asce7-05\""""
    s_ds: HazardAcceleration
    """design spectral acceleration at short periods, like "0.167 g"; or give s_s, s_1 and site_class"""
    s_d1: CornerAcceleration
    """design spectral acceleration at 1 s, like "0.053 g\""""
    t_l: Annotated[PositiveTime, HAZARD]
    """long-period transition period, like "6 s\""""
    hazard: Asce7Level = "design"
    """"design", or "mce": the maximum considered earthquake, 1.5 times the design spectrum"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the design spectrum of the edition."""
        return asce7.design_spectrum(s_ds=self.s_ds, s_d1=self.s_d1, t_l=self.t_l, code=self.code, hazard=self.hazard)


@dataclass(frozen=True, kw_only=True)
class Asce7MappedSpectrum(DesignSpectrum):
    """Design spectrum of ASCE 7 from the mapped accelerations of the rock and the site class."""

    form = "mapped"
    own_keys = ("s_s", "s_1", "site_class")
    other_keys = dict.fromkeys(("s_ds", "s_d1"), "follows from s_s, s_1 and site_class; remove it, or those three")
    code: Asce7Code
    """name and edition of the code; "ibc2009" has the coefficients of "asce7-05\""""
    s_s: HazardAcceleration
    """mapped spectral acceleration at short periods, like "0.25 g\""""
    s_1: CornerAcceleration
    """mapped spectral acceleration at 1 s, like "0.08 g\""""
    site_class: Annotated[Literal["A", "B", "B-unmeasured", "C", "D", "D-default", "E", "F"], GROUND]
    """site class "A" to "E"; in asce7-16 also "B-unmeasured" and "D-default\""""
    t_l: Annotated[PositiveTime, HAZARD]
    """long-period transition period, like "6 s\""""
    hazard: Asce7Level = "design"
    """"design", or "mce": the maximum considered earthquake, 1.5 times the design spectrum"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the design spectrum of the edition."""
        return asce7.mapped_spectrum(
            s_s=self.s_s, s_1=self.s_1, site_class=self.site_class, t_l=self.t_l, code=self.code, hazard=self.hazard
        )


@dataclass(frozen=True, kw_only=True)
class Asce722Spectrum(DesignSpectrum):
    """Multi-period spectrum of ASCE 7-22, from a reply of the web service of the USGS."""

    form = "asce7-22"
    other_keys = dict.fromkeys(
        ("s_s", "s_1", "site_class", "s_ds", "s_d1", "t_l"),
        "the reply in the file has the spectrum of the site; remove it (the two-period spectrum of ASCE 7-22, "
        "11.4.5.2, was not read)",
    )
    code: Annotated[Literal["asce7-22"], THE_CODE]
    """"asce7-22\""""
    file: Annotated[str | Path, IsInputFile(), Evidence("defines", "either", "as stated")]
    """reply of earthquake.usgs.gov/ws/designmaps/asce7-22.json, saved as JSON"""
    hazard: Asce7Level = "design"
    """"design", or "mce": the risk-targeted maximum considered earthquake of the reply"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Read the spectrum."""
        return asce7_22.multi_period_spectrum(Path(self.file), hazard=self.hazard)


@dataclass(frozen=True, kw_only=True)
class Ec8Spectrum(DesignSpectrum):
    """Elastic spectrum of EN 1998-1 with its recommended values."""

    form = "ec8"
    code: Annotated[Literal["ec8"], THE_CODE]
    """"ec8\""""
    a_g: Annotated[HazardAcceleration, UNCERTAIN]
    """reference peak ground acceleration on type A ground, a_gR, like "0.25 g\""""
    ground_type: Annotated[Literal["A", "B", "C", "D", "E", "S1", "S2"], GROUND]
    """ground type "A" to "E\""""
    type: Annotated[
        Literal[1, 2], Evidence("defines", "either", "as stated", judged="type 2 is higher, and shorter")
    ] = 1
    """1 where earthquakes above magnitude 5.5 govern, else 2"""
    importance_factor: Annotated[
        PositiveRatio, Evidence("code", "down", "1.0, that of importance class II, where less", safe=1.0)
    ] = 1.0
    """gamma_I: 0.8, 1.0, 1.2, 1.4 for importance classes I to IV"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of 3.2.2.2."""
        return ec8.elastic_spectrum(**self._parameters)

    def vertical(self) -> Spectrum:
        """Return the spectrum of 3.2.2.3."""
        return ec8.vertical_spectrum(**self._parameters)

    @property
    def _parameters(self) -> dict[str, Any]:
        given = {"a_g": self.a_g, "ground_type": self.ground_type, "importance_factor": self.importance_factor}
        return {**given, "spectrum_type": self.type}


NATIONAL = Evidence("defines", "either", "as stated", judged="of the national annex")


@dataclass(frozen=True, kw_only=True)
class Ec8NationalSpectrum(Ec8Spectrum):
    """Elastic spectrum of EN 1998-1 with the values that a national annex has for the ground type."""

    form = "national ec8"
    own_keys = ("s", "t_b", "t_c", "t_d")
    s: Annotated[PositiveRatio, NATIONAL]
    """soil factor S of the national annex"""
    t_b: Annotated[PositiveTime, NATIONAL]
    """T_B of the national annex, like "0.1 s\""""
    t_c: Annotated[PositiveTime, NATIONAL]
    """T_C of the national annex, like "0.4 s\""""
    t_d: Annotated[PositiveTime, NATIONAL]
    """T_D of the national annex, like "2 s\""""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of 3.2.2.2."""
        return ec8.elastic_spectrum(**self._parameters, national=ec8.GroundType(self.s, self.t_b, self.t_c, self.t_d))

    def vertical(self) -> Spectrum:
        """Refuse: a national annex has vertical values of its own, which no key gives."""
        raise SpectrumError(
            "ec8 spectrum: s, t_b, t_c, t_d: national values of the vertical spectrum (3.2.2.3) have no keys here; "
            "leave these out for the recommended ones"
        )


@dataclass(frozen=True, kw_only=True)
class Nzs1170Spectrum(DesignSpectrum):
    """Elastic site spectrum of NZS 1170.5."""

    form = "nzs1170.5"
    code: Annotated[Literal["nzs1170.5"], THE_CODE]
    """"nzs1170.5\""""
    subsoil: Annotated[Literal["A", "B", "C", "D", "E"], GROUND]
    """site subsoil class, "A" (strong rock) to "E" (very soft)"""
    z: Annotated[PositiveRatio, HAZARD]
    """hazard factor Z, like 0.13 in Auckland"""
    r: Annotated[PositiveRatio | None, Evidence("code", "down", "1.0, that of 500 years, where less", safe=1.0)] = None
    """return period factor R, 1.0 for 500 years; or give return_period"""
    return_period: Annotated[PositiveYears | None, Evidence("defines", "down", "that of the basis")] = None
    """return period, 20 to 2500 years, in place of r"""
    near_fault_distance: Annotated[
        NotNegativeLength | None,
        Evidence(
            "code",
            "up",
            "the distance to the nearest fault of Table 3.6",
            judged="N(T, D) falls with it",
            safe=Safe.ABSENT,
        ),
    ] = None
    """distance to the nearest major fault, like "8 km"; absent: none is near"""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        if (self.r is None) == (self.return_period is None):
            yield "r", "give either r, the return period factor, or return_period"

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of 3.1.1."""
        return nzs1170_5.site_spectrum(**self._parameters)

    def vertical(self) -> Spectrum:
        """Return the spectrum of 3.2."""
        return nzs1170_5.vertical_spectrum(**self._parameters)

    @property
    def return_factor(self) -> float:
        """R, as given or of the return period [-]."""
        if self.return_period is not None:
            return nzs1170_5.return_period_factor(self.return_period)
        assert self.r is not None
        return self.r

    @property
    def _parameters(self) -> dict[str, Any]:
        r = self.return_factor
        return {"subsoil": self.subsoil, "z": self.z, "r": r, "near_fault_distance": self.near_fault_distance}


NOT_READ = "the clauses of TS 1170.5 on near faults were not read; they are not built in"


@dataclass(frozen=True, kw_only=True)
class Ts1170Spectrum(DesignSpectrum):
    """Elastic site spectrum of TS 1170.5:2025, from the four values of its tables, typed."""

    form = "ts1170.5"
    other_keys: ClassVar = {
        "near_fault_distance": NOT_READ,
        **dict.fromkeys(("site_class", "return_period"), "goes with file and location; remove it, or the four values"),
    }
    code: Annotated[Literal["ts1170.5"], THE_CODE]
    """"ts1170.5\""""
    pga_site: HazardAcceleration
    """PGA of Table 3.1 or 3.2, like "0.18 g"; or give file, location, site_class and return_period"""
    s_as: HazardAcceleration
    """S_a,s of the table, the plateau, like "0.38 g\""""
    t_c: CornerTime
    """T_c of the table, where the plateau ends, like "0.52 s\""""
    t_d: CornerTime
    """T_d of the table, where the fall steepens, like "2.8 s\""""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of 3.1.2."""
        return ts1170_5.site_spectrum(pga=self.pga_site, s_as=self.s_as, t_c=self.t_c, t_d=self.t_d)


@dataclass(frozen=True, kw_only=True)
class Ts1170TableSpectrum(DesignSpectrum):
    """Elastic site spectrum by the published table of TS 1170.5:2025, a file."""

    form = "table of ts1170.5"
    own_keys = ("file", "location")
    other_keys: ClassVar = {
        "near_fault_distance": NOT_READ,
        **dict.fromkeys(("pga_site", "s_as", "t_c", "t_d"), "stands in the file; remove it here, or the file"),
    }
    code: Annotated[Literal["ts1170.5"], THE_CODE]
    """"ts1170.5\""""
    file: Annotated[str | Path, IsInputFile(), Evidence("defines", "either", "as stated")]
    """CSV of Table 3.1 or 3.2 as GNS Science publishes it"""
    location: Annotated[str, Evidence("defines", "either", "as stated")]
    """settlement, like "Kaitaia", or grid point, like "-41.3~174.8\""""
    site_class: Annotated[Literal["I", "II", "III", "IV", "V", "VI", "VII"], GROUND]
    """site class "I" to "VI\""""
    return_period: Annotated[PositiveYears, Evidence("defines", "down", "that of the basis")]
    """return period of a row: 25, 50, 100, 250, 500, 1000 or 2500 years"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of 3.1.2."""
        return ts1170_5.tabulated_spectrum(
            Path(self.file), location=self.location, site_class=self.site_class, return_period=self.return_period
        )


@dataclass(frozen=True, kw_only=True)
class NtcSpectrum(DesignSpectrum):
    """Elastic spectrum of NTC 2008 or 2018 from the hazard at one return period."""

    form = "ntc"
    other_keys: ClassVar = {
        "limit_state": "write it in [site]",
        **dict.fromkeys(
            ("nominal_life", "use_class", "phase"),
            "goes with hazard = [{ return_period, a_g, f_0, t_c_star }, …]; remove it, or a_g, f_0 and t_c_star",
        ),
    }
    code: NtcCode
    """name and edition of the code"""
    a_g: Annotated[HazardAcceleration, UNCERTAIN]
    """peak ground acceleration on rock, like "0.15 g"; or give hazard = [{ return_period, a_g, f_0, t_c_star }, …]"""
    f_0: PeakRatio
    """largest amplification of the spectrum on rock, F_0, like 2.4"""
    t_c_star: CornerTime
    """T_C*, where the level branch on rock ends, like "0.3 s\""""
    soil: NtcSoil
    """subsoil category "A" to "E\""""
    topography: Topography = "T1"
    """topographic category"""
    relief_position: Annotated[RatioToOne, RELIEF] = 1.0
    """1 at the top of the relief, 0 at its foot"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of §3.2.3.2.1."""
        return ntc.elastic_spectrum(self._on_rock, place=_place(self), code=self.code)

    def vertical(self) -> Spectrum:
        """Return the spectrum of §3.2.3.2.2."""
        return ntc.vertical_spectrum(self._on_rock, place=_place(self), code=self.code)

    @property
    def _on_rock(self) -> ntc.Hazard:
        return ntc.Hazard(self.a_g, self.f_0, self.t_c_star)


@dataclass(frozen=True, kw_only=True)
class HazardRow:
    """The hazard on rock at one return period."""

    return_period: Annotated[PositiveYears, Evidence("defines", "up", "as stated")]
    """return period, like 475: in years"""
    a_g: HazardAcceleration
    """peak ground acceleration on rock, like "0.15 g\""""
    f_0: PeakRatio
    """largest amplification of the spectrum on rock, F_0, like 2.4"""
    t_c_star: CornerTime
    """T_C*, where the level branch on rock ends, like "0.3 s\""""


@dataclass(frozen=True, kw_only=True)
class NtcOverYears(DesignSpectrum):
    """Elastic spectrum of NTC 2008 or 2018 at a limit state; what all ways to give the hazard have."""

    code: NtcCode
    """name and edition of the code"""
    nominal_life: Annotated[NominalLife, Evidence("defines", "down", "50 years, that of ordinary works")]
    """nominal life V_N, like 50: in years"""
    phase: Annotated[Literal["use", "works"], PHASE] = "use"
    """"works" for a nominal life of 5 to 10 years, that of a phase of construction"""
    use_class: Annotated[
        Literal["I", "II", "III", "IV"] | None, Evidence("defines", USE_CLASSES, "that of the use of the building")
    ] = None
    """class of use "I" to "IV"; that of [building] if absent"""
    limit_state: Annotated[LimitState | None, Evidence("defines", "either", "as [site] limit_state")] = None
    """old spelling of [site] limit_state"""
    soil: NtcSoil
    """subsoil category "A" to "E\""""
    topography: Topography = "T1"
    """topographic category"""
    relief_position: Annotated[RatioToOne, RELIEF] = 1.0
    """1 at the top of the relief, 0 at its foot"""

    def faults(self) -> Iterator[Fault]:
        """Yield the keys that do not go together."""
        if self.nominal_life < LEAST_LIFE and self.phase != "works":
            yield (
                "nominal_life",
                f"below {LEAST_LIFE:g} years only in a phase of construction (NTC 2.4.1); write "
                f'phase = "works", or {LEAST_LIFE:g} years and more',
            )

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum of §3.2.3.2.1 at the limit state."""
        return self._at_limit_state(ntc.elastic_spectrum(self._on_rock, place=_place(self), code=self.code))

    def vertical(self) -> Spectrum:
        """Return the spectrum of §3.2.3.2.2 at the limit state."""
        return self._at_limit_state(ntc.vertical_spectrum(self._on_rock, place=_place(self), code=self.code))

    def at_limit_states(self) -> dict[str, Spectrum]:
        """Return the horizontal spectrum of each limit state whose return period lies within the rows."""
        first, last = self.years[0], self.years[-1]
        years = {state: ntc.return_period(state, reference_life=self._life) for state in get_args(LimitState)}
        states = [replace(self, limit_state=state) for state, T_R in years.items() if first <= T_R <= last]
        return {each._state: each.horizontal() for each in states}

    def surface_pgas(self, *, factor: float = 1.0) -> tuple[float, ...]:
        """Return the peak ground acceleration at the surface of each row [m/s2]; factor: on all of them."""
        place = _place(self)
        scale = factor * ntc.topographic_factor(place)
        return tuple(scale * (ntc.soil_factor(row, place.soil) * row.a_g) for row in self.rows)

    @property
    def years(self) -> tuple[float, ...]:
        """The return periods of the rows [years]."""
        return tuple(row.return_period for row in self.rows if row.return_period is not None)

    @property
    def _state(self) -> str:
        return self.limit_state or DEFAULT_STATE

    @property
    def _life(self) -> float:
        if self.use_class is None:
            raise SpectrumError(f'{self.code} spectrum: use_class: missing; class of use "I" to "IV"')
        return ntc.reference_life(self.nominal_life, use_class=self.use_class)

    @property
    def rows(self) -> Sequence[ntc.Hazard]:
        """The hazard on rock at each return period, rising."""
        raise NotImplementedError(type(self).__name__)

    @property
    def _on_rock(self) -> ntc.Hazard:
        return ntc.hazard_at(self.rows, return_period=ntc.return_period(self._state, reference_life=self._life))

    def _at_limit_state(self, spectrum: Spectrum) -> Spectrum:
        """Add to the parameters of a spectrum what its return period follows from."""
        parameters: dict[str, float | str] = {"limit_state": self._state, "nominal_life": self.nominal_life}
        use = str(self.use_class)
        parameters |= {"use_class": use, "use_coefficient": ntc.USE_FACTORS[use], "reference_life": self._life}
        return replace(spectrum, parameters={**parameters, **spectrum.parameters})


@dataclass(frozen=True, kw_only=True)
class NtcHazardSpectrum(NtcOverYears):
    """Elastic spectrum of NTC 2008 or 2018 at a limit state, from the rows of a hazard."""

    form = "hazard"
    own_keys = ("hazard",)
    other_keys = dict.fromkeys(("a_g", "f_0", "t_c_star"), "stands in the rows of hazard; remove it here, or hazard")
    hazard: Annotated[tuple[HazardRow, ...], AT_LEAST_TWO, HAZARD]
    """rows { return_period, a_g, f_0, t_c_star }, rising in return period"""

    @property
    def rows(self) -> Sequence[ntc.Hazard]:
        """The hazard on rock at each return period, rising."""
        return [ntc.Hazard(row.a_g, row.f_0, row.t_c_star, row.return_period) for row in self.hazard]


@dataclass(frozen=True, kw_only=True)
class NtcGridSpectrum(NtcOverYears):
    """Elastic spectrum of NTC 2008 or 2018 by the grid of the hazard, a file, at a place and a limit state."""

    form = "grid"
    own_keys = ("grid", "latitude", "longitude")
    other_keys = dict.fromkeys(
        ("a_g", "f_0", "t_c_star", "hazard"), "follows from grid and the place; remove it, or those"
    )
    grid: Annotated[str | Path, IsInputFile(), Evidence("defines", "either", "as stated")]
    """CSV of the nodes: lon, lat, then for each return period like ag_475 [g/10], F0_475, Tc_475 [s]"""
    latitude: Annotated[float, Number("ratio", least=-90, most=90), Evidence("defines", "either", "as stated")]
    """latitude of the site in degrees, in the datum of the grid, like 42.35"""
    longitude: Annotated[float, Number("ratio", least=-180, most=180), Evidence("defines", "either", "as stated")]
    """longitude of the site in degrees, like 13.4"""

    @property
    def rows(self) -> Sequence[ntc.Hazard]:
        """The hazard on rock at each return period, by the four nodes around the site."""
        return ntc_grid.site_hazard(Path(self.grid), latitude=self.latitude, longitude=self.longitude)


@dataclass(frozen=True, kw_only=True)
class TableSpectrum(DesignSpectrum):
    """A spectrum read from a file of periods and accelerations."""

    form = "table"
    code: Annotated[Literal["table"], THE_CODE]
    """"table\""""
    damping: Annotated[Damping, DAMPED_TABLE] = 0.05
    file: Annotated[str | Path, IsInputFile(), Evidence("defines", "either", "as stated")]
    """CSV of period and acceleration, with units in the header"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Read the spectrum."""
        return read_table(Path(self.file), damping=self.damping, pga=pga)


@dataclass(frozen=True, kw_only=True)
class PointsSpectrum(DesignSpectrum):
    """A spectrum given point by point; from Python alone."""

    form = "points"
    own_keys = ("period", "acceleration")
    period: Annotated[Any, NotAKey()]
    """rising [n] [s]"""
    acceleration: Annotated[Any, NotAKey()]
    """at these periods [n] [m/s2]"""

    def horizontal(self, *, pga: float | None = None) -> Spectrum:
        """Return the spectrum linear between the points."""
        return table_spectrum(self.period, self.acceleration, damping=self.damping, pga=pga)


SPECTRA: Mapping[str, tuple[type[DesignSpectrum], ...]] = {
    **dict.fromkeys(asce7.EDITIONS, (Asce7Spectrum, Asce7MappedSpectrum)),
    "asce7-22": (Asce722Spectrum,),
    "ec8": (Ec8Spectrum, Ec8NationalSpectrum),
    "nzs1170.5": (Nzs1170Spectrum,),
    "ts1170.5": (Ts1170Spectrum, Ts1170TableSpectrum),
    **dict.fromkeys(ntc.CLAUSES, (NtcSpectrum, NtcHazardSpectrum, NtcGridSpectrum)),
    "table": (TableSpectrum,),
}
"""The ways to give each code's spectrum in a project file, the usual one first."""


def spectrum_class(code: str, keys: Collection[str]) -> type[DesignSpectrum]:
    """Return the way of a code that is told by a key among those given; else the usual one.

    Parameters
    ----------
    code : a key of `SPECTRA`
    keys : that are given
    """
    return next((way for way in SPECTRA[code] if any(key in keys for key in way.own_keys)), SPECTRA[code][0])


def _place(way: NtcSpectrum | NtcOverYears) -> ntc.SoilAndTopography:
    return ntc.SoilAndTopography(way.soil, way.topography, way.relief_position)
