"""The tables [procedures.dmi2008] and [procedures.ntc2018]."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Discriminator, Field, Tag

from assess.project.quantities import (
    Name,
    PositiveDensity,
    PositiveLength,
    PositiveStress,
    PositiveTime,
    Ratio,
    unique,
)
from assess.project.section import Section

Level = Literal["LC1", "LC2", "LC3"]


class Italian(Section):
    """What both Italian procedures may say."""

    knowledge_level: Level | None = None
    """level of knowledge, which gives the confidence factor where crushing is modelled: LC1 1.35, LC2 1.20, LC3 1.00;
    1.35 wherever it is not"""
    knowledge_levels: dict[Name, Level] = Field(default_factory=dict)
    """{ MECHANISM = "LC2" }: of single mechanisms, in place of knowledge_level"""
    confidence_factor: Annotated[Ratio, Field(ge=1)] | None = None
    """FC in place of the code's: a larger one decides, a lower one is shown for comparison"""


class Dmi2008(Italian):
    """Options of the Italian procedure of DM 2008 with Circolare 617/2009."""

    limit_states: Annotated[
        tuple[Literal["SLD", "SLV"], ...], Field(min_length=1), AfterValidator(unique("limit state"))
    ] = ("SLV",)
    """limit states to check: "SLD" by dmi2008-linear, "SLV" by all"""


class FreeElement(Section):
    """A wall that vibrates between its supports before it lifts off: its period follows by C8.7.1.7."""

    length: PositiveLength
    """height of the wall that is free, like "2 m\""""
    thickness: PositiveLength
    """thickness of the wall"""
    young_modulus: PositiveStress
    """Young's modulus, reduced for cracks, like "0.8 GPa\""""
    density: PositiveDensity
    """density of the masonry"""
    support: Literal["cantilever", "supported"] = "cantilever"
    """"cantilever", or "supported" at both ends"""


FreePeriod = Annotated[
    Annotated[PositiveTime, Tag("<time>")] | Annotated[FreeElement, Tag("<element>")],
    Discriminator(lambda value: "<element>" if isinstance(value, dict | FreeElement) else "<time>"),
]


class Ntc2018(Italian):
    """Options of the Italian procedure of NTC 2018 with Circolare 7/2019."""

    limit_states: Annotated[
        tuple[Literal["SLD", "SLV", "SLC"], ...], Field(min_length=1), AfterValidator(unique("limit state"))
    ] = ("SLV",)
    """limit states to check: "SLD" by ntc2018-linear, "SLC" by ntc2018-nonlinear and -history, "SLV" by all"""
    free_periods: dict[Name, FreePeriod] = Field(default_factory=dict)
    """{ MECHANISM = "0.2 s" }: period before uplift of those that vibrate freely, as parapets and pinnacles do; or in
    place of the period { length, thickness, young_modulus, density, support }"""
