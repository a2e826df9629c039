"""The tables [site] and [building]."""

from __future__ import annotations

from pydantic import Field

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
from assess.project.section import Section
from assess.project.sections.spectra import SpectrumSection


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
