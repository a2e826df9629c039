"""The tables [verdict], what decides, and [procedures.CODE], options of the code procedures."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import AfterValidator, Discriminator, Field, StrictStr, Tag, model_validator

from assess.codes.bases import BASES
from assess.project.section import ProjectSection, error_at, quote_names
from assess.project.values import (
    Name,
    NotNegativeLength,
    PositiveDensity,
    PositiveLength,
    PositiveRatio,
    PositiveStress,
    PositiveTime,
    Ratio,
    unique,
)

BasisName = Literal["ntc2018", "dmi2008", "nzsee2017", "asce41-13", "asce43-05", "ec8", "own"]

Procedure = Literal[
    "asce43-05-spectrum",
    "asce43-05-spectrum-thesis",
    "asce43-05-history",
    "dmi2008-linear",
    "dmi2008-nonlinear",
    "dmi2008-nonlinear-thesis",
    "nzsee2017-face-loaded",
    "asce41-13-ht",
    "ec8-element",
    "dmi2008-history",
    "ntc2018-linear",
    "ntc2018-nonlinear",
    "ntc2018-history",
    "asce43-05-sliding",
    "sliding",
]


class VerdictSection(ProjectSection):
    """What decides: the basis, the limit state, the methods, and what they are measured by."""

    basis: BasisName | None = None
    """code that decides: "ntc2018", "dmi2008", "nzsee2017", "asce41-13", "asce43-05", "ec8", or "own"; that of the
    site's spectrum if absent, which asce7 and tables do not tell"""
    limit_state: StrictStr | None = None
    """limit state that decides for the whole building, like "SLV"; the default of the basis if absent"""
    procedures: Annotated[tuple[Procedure, ...], Field(min_length=1), AfterValidator(unique("procedure"))] | None = None
    """methods that may decide, also those that the basis accepts only if named; all it accepts unnamed if absent"""
    works: Literal["none", "repair", "improvement", "upgrading"] = "none"
    """kind of work, which sets the target of the Italian index: "none" (1.0), "repair", "improvement", "upgrading\""""
    upgrading: Literal["a", "b", "c", "d", "e"] | None = None
    """case of NTC 8.4.3: "c" and "e" have the target 0.80, the others 1.0"""
    index_before: PositiveRatio | None = None
    """index before the works, which an improvement raises by 0.10"""
    target_nbs: Literal[34, 67, 100] | None = None
    """share of the new building standard to be reached in per cent, 34, 67 or 100; no default"""
    rule: Literal["all", "any"] | None = None
    """of basis = "own": whether "all" of the procedures must hold, or "any" of them"""
    statement: StrictStr = ""
    """of basis = "own": the sentence that the report prints"""
    survey_tolerance: NotNegativeLength = 0.02
    """of thicknesses and hinge positions; loads have 5 %"""

    @model_validator(mode="after")
    def _belongs_together(self) -> VerdictSection:
        if self.basis == "own":
            for key in ("procedures", "rule", "statement"):
                if not getattr(self, key):
                    raise error_at(key, 'missing; basis = "own" takes procedures, rule and statement')
            return self
        for key in ("rule", "statement"):
            if self.has_key(key):
                raise error_at(key, 'only of basis = "own"; remove it')
        for name in self.procedures or ():
            if name in READINGS:
                raise error_at("procedures", f'"{name}" is a reading of the thesis, which never decides; remove it')
            if self.basis is not None and name not in BASES[self.basis].methods:
                known = quote_names(BASES[self.basis].methods)
                raise error_at("procedures", f'"{name}" is not accepted by {self.basis}; write of {known}')
        if self.basis is not None and self.limit_state is not None:
            states = tuple(state.name for state in BASES[self.basis].chosen)
            if self.limit_state not in states:
                raise error_at(
                    "limit_state", f"not one that may be chosen in {self.basis}; write one of {quote_names(states)}"
                )
        return self


PROCEDURES: tuple[Procedure, ...] = get_args(Procedure)
READINGS: tuple[Procedure, ...] = ("asce43-05-spectrum-thesis", "dmi2008-nonlinear-thesis")
KnowledgeLevel = Literal["LC1", "LC2", "LC3"]


class Italian(ProjectSection):
    """What both Italian procedures may say."""

    knowledge_level: KnowledgeLevel | None = None
    """level of knowledge, which gives the confidence factor where crushing is modelled: LC1 1.35, LC2 1.20, LC3 1.00;
    1.35 wherever it is not"""
    knowledge_levels: dict[Name, KnowledgeLevel] = Field(default_factory=dict)
    """{ MECHANISM = "LC2" }: of single mechanisms, in place of knowledge_level"""
    confidence_factor: Annotated[Ratio, Field(ge=1)] | None = None
    """FC in place of the code's: a larger one decides, a lower one is shown for comparison"""


class Dmi2008(Italian):
    """Options of the Italian procedure of DM 2008 with Circolare 617/2009."""

    limit_states: Annotated[
        tuple[Literal["SLD", "SLV"], ...], Field(min_length=1), AfterValidator(unique("limit state"))
    ] = ("SLV",)
    """limit states to check: "SLD" by dmi2008-linear, "SLV" by all"""


class FreeElement(ProjectSection):
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


GivenFreePeriod = Annotated[
    Annotated[PositiveTime, Tag("<time>")] | Annotated[FreeElement, Tag("<element>")],
    Discriminator(lambda value: "<element>" if isinstance(value, dict | FreeElement) else "<time>"),
]


class Ntc2018(Italian):
    """Options of the Italian procedure of NTC 2018 with Circolare 7/2019."""

    limit_states: Annotated[
        tuple[Literal["SLD", "SLV", "SLC"], ...], Field(min_length=1), AfterValidator(unique("limit state"))
    ] = ("SLV",)
    """limit states to check: "SLD" by ntc2018-linear, "SLC" by ntc2018-nonlinear and -history, "SLV" by all"""
    free_periods: dict[Name, GivenFreePeriod] = Field(default_factory=dict)
    """{ MECHANISM = "0.2 s" }: period before uplift of those that vibrate freely, as parapets and pinnacles do; or in
    place of the period { length, thickness, young_modulus, density, support }"""
