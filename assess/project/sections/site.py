"""The tables [site] and [building]."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StrictBool, StrictStr, model_validator

from assess.codes.context import default_period
from assess.project.quantities import (
    Count,
    Damping,
    Length,
    NotNegativeRatio,
    PositiveAcceleration,
    PositiveFrequency,
    PositiveLength,
    PositiveTime,
)
from assess.project.section import Section, quote_names, wrong
from assess.project.sections.spectra import LIMIT_STATES, NtcHazardSpectrum, SpectrumSection
from assess.project.sections.uncertain_number import UNCERTAIN


class Site(Section):
    """What the ground demands."""

    spectrum: SpectrumSection
    """a table [site.spectrum] with the code and its parameters"""
    pga: PositiveAcceleration | None = None
    """scales the spectrum's ordinates to this peak ground acceleration, corner periods fixed"""
    limit_state: StrictStr | None = None
    """what the site's own action stands for, like "SLV", "ULS" or "DBE", without a hazard over return periods"""
    vertical_ratio: NotNegativeRatio = 0.0
    """vertical over horizontal spectral acceleration, for F_V of ASCE 43-05"""

    @model_validator(mode="after")
    def _one_limit_state(self) -> Site:
        old = self.spectrum.limit_state if isinstance(self.spectrum, NtcHazardSpectrum) else None
        if old is not None and self.limit_state is not None and old != self.limit_state:
            raise wrong("limit_state", f'site.spectrum.limit_state, its old spelling, is "{old}"; give one')
        if isinstance(self.spectrum, NtcHazardSpectrum) and self.limit_state not in (None, *LIMIT_STATES):
            raise wrong(
                "limit_state", f"not one of the hazard over return periods; write one of {quote_names(LIMIT_STATES)}"
            )
        return self

    @property
    def own_limit_state(self) -> str | None:
        """The limit state that the site's own action stands for, in either spelling; None if not stated."""
        old = self.spectrum.limit_state if isinstance(self.spectrum, NtcHazardSpectrum) else None
        return self.limit_state or old


class LimitStatePeriod(Section):
    """First mode of the building at one limit state, in place of the range of softened periods."""

    period: PositiveTime
    """period of the first mode at this limit state, like "0.5 s\""""
    damping: Damping
    """its damping ratio"""
    reason: StrictStr
    """why, for the report"""


class Building(Section):
    """The structure below a mechanism; what the clauses for mechanisms above ground need."""

    height: PositiveLength | None = None
    """height above ground_elevation, like "9 m\""""
    storeys: Count | None = None
    """number of storeys"""
    ground_elevation: Length | None = None
    """elevation of the ground in the coordinates of the bodies; 0 if absent and the lowest body stands there"""
    use_class: Literal["I", "II", "III", "IV"] | None = None
    """class of use "I" to "IV", of the Italian codes"""
    school: StrictBool | None = None
    """whether the building is a school, for the targets of NTC 8.4.2"""
    period: Annotated[PositiveTime, UNCERTAIN] | None = Field(
        default_factory=lambda values: None if values.get("height") is None else default_period(values["height"])
    )
    """period of the first mode; 0.05 H^0.75 if absent"""
    damping: Damping = 0.05
    """damping ratio of the first mode"""
    natural_frequency: PositiveFrequency | None = None
    """first natural frequency for `amplification`, like "2.5 Hz"; 1 / period where that is given, else Rayleigh's"""
    limit_states: dict[Literal["SLV", "SLC"], LimitStatePeriod] = Field(default_factory=dict)
    """{ SLV = { period, damping, reason } }: the building at a limit state, for displacements by ntc2018; 1.5 to 2.0
    times its period if absent"""
    effective_height: PositiveLength | None = None
    """height above the ground of the resultant of the first mode's inertia forces, for `amplification`"""
