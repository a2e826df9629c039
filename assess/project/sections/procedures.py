"""The tables [verdict], what decides, and [procedures.CODE], options of the code procedures."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import StrictStr, model_validator

from assess.codes.asce41_13 import Asce41Options
from assess.codes.asce43_05 import Asce4305Options
from assess.codes.bases import BASES
from assess.codes.dmi2008 import Dmi2008Options
from assess.codes.en1998_1 import Ec8Options
from assess.codes.ntc2018 import Ntc2018Options
from assess.codes.nzsee2017 import Nzsee2017Options
from assess.codes.procedures import THESIS_READINGS
from assess.declaration import FREE, Evidence, NotNegativeLength, PositiveRatio, Safe, Several
from assess.project.key_errors import error_at, quote_names
from assess.project.section import ProjectSection, default_table
from assess.project.values import InputFile

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
ProcedureNames = Annotated[tuple[Procedure, ...], Several(1, unlike="procedure")]
PROCEDURES: tuple[Procedure, ...] = get_args(Procedure)
BasisName = Literal["ntc2018", "dmi2008", "nzsee2017", "asce41-13", "asce43-05", "ec8", "own"]


BASIS = Evidence("chosen", "either", "that of the site's code; asce7 and tables have none")
DECIDING_STATE = Evidence("chosen", "either", "the default of the basis; beside it the others that it lets one choose")
METHODS = Evidence(
    "chosen", "either", "all that the basis accepts unnamed; beside them the others that can be computed"
)
WORKS = Evidence(
    "chosen",
    ("none", "upgrading", "improvement", "local", "repair"),
    '"none"; its target stands beside',
    judged="targets fall from 1.0 over 0.80 and 0.10 above the index before to none",
)
UPGRADING = Evidence(
    "chosen", ("a", "b", "d", "c", "e"), "a target of 1.0 stands beside", judged="cases c and e have the target 0.80"
)
INDEX_BEFORE = Evidence(
    "measured",
    "down",
    "absent: an improvement is incomplete",
    judged="the target of an improvement is 0.10 above it",
    safe=Safe.ABSENT,
)
BEFORE = Evidence("defines", "either", "absent: an improvement is incomplete")
TARGET_NBS = Evidence("chosen", (100, 67, 34), "absent: incomplete; the grade stands beside")
RULE = Evidence(
    "chosen",
    ("all", "any"),
    '"all"; "any" is a condition',
    judged="one of several methods holds sooner than all of them",
)
SURVEY_TOLERANCE = Evidence(
    "clamped", "down", "20 mm, where less", judged="with a smaller one fewer answers are at the limit"
)


class VerdictSection(ProjectSection, title="VerdictSection"):
    """What decides: the basis, the limit state, the methods, and what they are measured by."""

    basis: Annotated[BasisName | None, BASIS] = None
    """code that decides: "ntc2018", "dmi2008", "nzsee2017", "asce41-13", "asce43-05", "ec8", or "own"; that of the
    site's spectrum if absent, which asce7 and tables do not tell"""
    limit_state: Annotated[StrictStr | None, DECIDING_STATE] = None
    """limit state that decides for the whole building, like "SLV"; the default of the basis if absent"""
    procedures: Annotated[ProcedureNames | None, METHODS] = None
    """methods that may decide, also those that the basis accepts only if named; all it accepts unnamed if absent"""
    works: Annotated[Literal["none", "local", "improvement", "upgrading", "repair"] | None, WORKS] = None
    """kind of work, which sets the target of the Italian index: "none" (1.0), "local" (none; old spelling "repair"),
    "improvement", "upgrading"; if absent "none", and "local" where a state before is given and a tie is new"""
    upgrading: Annotated[Literal["a", "b", "c", "d", "e"] | None, UPGRADING] = None
    """case of NTC 8.4.3: "c" and "e" have the target 0.80, the others 1.0"""
    index_before: Annotated[PositiveRatio | None, INDEX_BEFORE] = None
    """index before the works, as measured, which an improvement raises by 0.10, and which local works do not lower"""
    before: Annotated[InputFile | None, BEFORE] = None
    """results.json of the state before the works, by the same hazard; its index stands for index_before"""
    target_nbs: Annotated[Literal[34, 67, 100] | None, TARGET_NBS] = None
    """share of the new building standard to be reached in per cent, 34, 67 or 100; no default"""
    rule: Annotated[Literal["all", "any"] | None, RULE] = None
    """of basis = "own": whether "all" of the procedures must hold, or "any" of them"""
    statement: Annotated[StrictStr, FREE] = ""
    """of basis = "own": the sentence that the report prints"""
    survey_tolerance: Annotated[NotNegativeLength, SURVEY_TOLERANCE] = 0.02
    """of thicknesses and hinge positions; loads have 5 %"""

    @model_validator(mode="after")
    def _belongs_together(self) -> VerdictSection:
        if self.before is not None and self.index_before is not None:
            raise error_at("index_before", "beside before, whose results have the index; remove one of the two")
        if self.basis == "own":
            for key in ("procedures", "rule", "statement"):
                if not getattr(self, key):
                    raise error_at(key, 'missing; basis = "own" takes procedures, rule and statement')
            return self
        for key in ("rule", "statement"):
            if self.has_key(key):
                raise error_at(key, 'only of basis = "own"; remove it')
        for name in self.procedures or ():
            if name in THESIS_READINGS:
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


class Procedures(ProjectSection):
    """Options of the code procedures, one table each."""

    asce43_05: Asce4305Options = default_table(Asce4305Options, alias="asce43-05")
    """options of asce43-05-sliding"""
    dmi2008: Dmi2008Options = default_table(Dmi2008Options)
    """options of the procedures dmi2008-…"""
    ntc2018: Ntc2018Options = default_table(Ntc2018Options)
    """options of the procedures ntc2018-…"""
    nzsee2017: Nzsee2017Options = default_table(Nzsee2017Options)
    """options of nzsee2017-face-loaded"""
    asce41_13: Asce41Options = default_table(Asce41Options, alias="asce41-13")
    """options of asce41-13-ht"""
    ec8: Ec8Options = default_table(Ec8Options)
    """options of ec8-element"""
