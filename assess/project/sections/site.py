"""The tables [site] and [building]."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field, Tag

from assess.project.quantities import (
    Count,
    Damping,
    InputFile,
    Length,
    NotNegativeRatio,
    PositiveAcceleration,
    PositiveFrequency,
    PositiveLength,
    PositiveTime,
)
from assess.project.section import Section, listed

SPECTRA = ("asce7-05", "ibc2009", "asce7-10", "asce7-16", "table")


class Asce7Spectrum(Section):
    """Design spectrum of ASCE 7 (IBC 2009 refers to 7-05), from its two design ordinates."""

    planned: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("s_s", "s_1", "site_class"), "give s_ds, s_d1 and t_l directly"
    )

    code: Literal["asce7-05", "ibc2009", "asce7-10", "asce7-16"]
    """name and edition of the code; "ibc2009" has the shape of "asce7-05\""""
    s_ds: PositiveAcceleration
    """design spectral acceleration at short periods, like "0.167 g\""""
    s_d1: PositiveAcceleration
    """design spectral acceleration at 1 s, like "0.053 g\""""
    t_l: PositiveTime
    """long-period transition period, like "6 s\""""
    hazard: Literal["design", "mce"] = "design"
    """"design", or "mce": the maximum considered earthquake, 1.5 times the design spectrum"""
    damping: Damping = 0.05
    """damping ratio of the spectrum"""


class TableSpectrum(Section):
    """A spectrum read from a file of periods and accelerations."""

    code: Literal["table"]
    """"table\""""
    file: InputFile
    """CSV of period and acceleration, with units in the header"""
    damping: Damping = 0.05
    """damping ratio of the spectrum in the file"""


def _spectrum_tag(values: Any) -> str | None:
    code = values.get("code") if isinstance(values, dict) else None
    return None if code not in SPECTRA else "<table>" if code == "table" else "<asce7>"


SpectrumSection = Annotated[
    Annotated[Asce7Spectrum, Tag("<asce7>")] | Annotated[TableSpectrum, Tag("<table>")],
    Discriminator(
        _spectrum_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("code",), "names": listed(SPECTRA)},
    ),
]


class Site(Section):
    """What the ground demands."""

    spectrum: SpectrumSection
    """a table [site.spectrum] with the code and its parameters"""
    pga: PositiveAcceleration | None = None
    """scales the spectrum's ordinates to this peak ground acceleration, corner periods fixed"""
    vertical_ratio: NotNegativeRatio = 0.0
    """vertical over horizontal spectral acceleration, for F_V of ASCE 43-05"""


class Building(Section):
    """The structure below a mechanism; what the clauses for mechanisms above ground need."""

    height: PositiveLength
    """height above ground_elevation, like "9 m\""""
    storeys: Count | None = None
    """number of storeys"""
    ground_elevation: Length = 0.0
    """elevation of the ground in the coordinates of the bodies"""
    period: PositiveTime = Field(default_factory=lambda values: 0.05 * values["height"] ** 0.75)
    """period of the first mode; 0.05 H^0.75 if absent"""
    damping: Damping = 0.05
    """damping ratio of the first mode"""
    natural_frequency: PositiveFrequency | None = None
    """first natural frequency for `amplification`, like "2.5 Hz"; 1 / period where that is given, else Rayleigh's"""
    effective_height: PositiveLength | None = None
    """height above the ground of the resultant of the first mode's inertia forces, for `amplification`"""
