"""The tables [procedures.dmi2008] and [procedures.ntc2018]."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Literal, Self

from pydantic import AfterValidator, Discriminator, Field, Tag, model_validator

from assess.project.quantities import (
    Name,
    PositiveDensity,
    PositiveLength,
    PositiveStress,
    PositiveTime,
    Ratio,
    unique,
)
from assess.project.section import Section, wrong

KNOWLEDGE: Mapping[str | None, float] = {"LC1": 1.35, "LC2": 1.20, "LC3": 1.00}
"""FC of the levels of knowledge, Table C8.5.IV of Circolare 7/2019 (617/2009: C8A.1.1)."""


class Italian(Section):
    """What both Italian procedures may say."""

    knowledge_level: Literal["LC1", "LC2", "LC3"] | None = None
    """level of knowledge, which gives the confidence factor: LC1 1.35, LC2 1.20, LC3 1.00"""
    confidence_factor: Annotated[Ratio, Field(ge=1)] = Field(
        default_factory=lambda values: KNOWLEDGE.get(values.get("knowledge_level"), 1.0)
    )
    """FC; that of knowledge_level if absent, or 1.0"""

    @model_validator(mode="after")
    def _one_factor(self) -> Self:
        if self.knowledge_level is not None and self.confidence_factor != KNOWLEDGE[self.knowledge_level]:
            raise wrong("confidence_factor", f"{self.knowledge_level} has another one; remove it or knowledge_level")
        return self


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
