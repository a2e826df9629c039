"""The table [verdict]: what decides."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field, StrictStr, model_validator

from assess.codes.bases import BASES
from assess.project.quantities import NotNegativeLength, PositiveRatio, unique
from assess.project.section import Section, quote_names, wrong
from assess.project.sections.procedure_names import READINGS, Procedure

BasisName = Literal["ntc2018", "dmi2008", "nzsee2017", "asce41-13", "asce43-05", "ec8", "own"]


class VerdictSection(Section):
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
                    raise wrong(key, 'missing; basis = "own" takes procedures, rule and statement')
            return self
        for key in ("rule", "statement"):
            if self.has_key(key):
                raise wrong(key, 'only of basis = "own"; remove it')
        for name in self.procedures or ():
            if name in READINGS:
                raise wrong("procedures", f'"{name}" is a reading of the thesis, which never decides; remove it')
            if self.basis is not None and name not in BASES[self.basis].methods:
                known = quote_names(BASES[self.basis].methods)
                raise wrong("procedures", f'"{name}" is not accepted by {self.basis}; write of {known}')
        if self.basis is not None and self.limit_state is not None:
            states = tuple(state.name for state in BASES[self.basis].chosen)
            if self.limit_state not in states:
                raise wrong(
                    "limit_state", f"not one that may be chosen in {self.basis}; write one of {quote_names(states)}"
                )
        return self
