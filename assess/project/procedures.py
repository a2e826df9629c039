"""What is asked of the mechanisms: which procedures, with which options.

Where the project names no procedures, those that apply at its site are asked: the edition of the Italian code that its
spectrum is of decides, the other is left out; elsewhere DM 2008 without time histories stands beside ASCE 43-05.
Sliding is asked where a material has friction.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from scipy.constants import g

from assess.codes.asce41_13.clauses import Options as Asce41Options
from assess.codes.asce43_05.clauses import Options as Asce43Options
from assess.codes.context import FreePeriod
from assess.codes.en1998_1.clauses import Options as Ec8Options
from assess.codes.italian.edition import Options
from assess.codes.ntc2018.clauses import free_period
from assess.codes.nzsee2017.clauses import Options as Nzsee2017Options
from assess.codes.registry import LIMIT_STATES, CodeOptions
from assess.codes.verdict import methods_of
from assess.errors import ProjectError
from assess.project import sections
from assess.project.key_text import value_text
from assess.project.question import question_of
from assess.project.section import Section
from assess.results import Resolved
from assess.study.verdict import states_of

ASCE43 = ("asce43-05-spectrum", "asce43-05-spectrum-thesis", "asce43-05-history")
DMI2008 = ("dmi2008-linear", "dmi2008-nonlinear", "dmi2008-nonlinear-thesis")
AT_SITE: Mapping[str, tuple[str, ...]] = {  # by the code of the spectrum
    "ntc2008": (*ASCE43, *DMI2008, "dmi2008-history"),
    "ntc2018": (*ASCE43, "ntc2018-linear", "ntc2018-nonlinear", "ntc2018-history"),
}
ELSEWHERE = (*ASCE43, *DMI2008)
SLIDING = ("asce43-05-sliding", "sliding")  # nothing to ask where no friction is given


def procedures_of(content: sections.Content) -> tuple[str, ...]:
    """Return the procedures named, or all that apply at the site and check one of the limit states requested.

    Raises ProjectError for a procedure that is named and checks none of them.
    """
    named = content.analysis.procedures
    if named is None:
        code = "" if content.site is None else content.site.spectrum.code
        rubs = any(material.friction is not None for material in content.materials.values())
        unasked = (*AT_SITE.get(code, ELSEWHERE), *content.site_procedures, *(SLIDING if rubs else ()))
        return with_methods((name for name in unasked if not _silent(name, content)), content)
    for name in named:
        if states := _silent(name, content):
            key = f"procedures.{name.split('-')[0]}.limit_states"
            known = ", ".join(LIMIT_STATES[name])
            raise ProjectError(f"{key}: {', '.join(states)}: {name} checks {known}; add one, or leave it out")
    return with_methods(named, content)


def with_methods(names: Iterable[str], content: sections.Content) -> tuple[str, ...]:
    """Add the procedures that may decide, which run in any case."""
    deciding = () if content.site is None else methods_of(question_of(content, site_pga=0.0))
    return tuple(dict.fromkeys((*names, *deciding)))


def _silent(name: str, content: sections.Content) -> tuple[str, ...]:
    """Return the limit states requested if the procedure checks none of them, else nothing."""
    if name not in LIMIT_STATES:
        return ()
    states: tuple[str, ...] = getattr(content.procedures, name.split("-")[0]).limit_states
    return () if set(states) & set(LIMIT_STATES[name]) else states


def with_asked_procedures(resolved: Mapping[str, Resolved], content: sections.Content) -> dict[str, Resolved]:
    """Add the procedures that run to the values of the project, and leave out default options of other codes."""
    names = procedures_of(content)
    codes = {key: key.split(".")[1] for key in resolved if key.startswith("procedures.")}
    idle = {key for key, code in codes.items() if not any(name.startswith(f"{code}-") for name in names)}
    kept = {key: each for key, each in resolved.items() if each.given or key not in idle}
    return {**kept, "analysis.procedures": Resolved(list(names), content.analysis.procedures is not None)}


def options_of(content: sections.Content) -> CodeOptions:
    """Return the options of every code; the limit states that decide are among theirs."""
    section, deciding = content.procedures, states_of(question_of(content, site_pga=0.0))
    dmi2008, ntc2018 = section.dmi2008, section.ntc2018
    return CodeOptions(
        asce43_05=Asce43Options(**section.asce43_05.model_dump()),
        nzsee2017=Nzsee2017Options(**in_g(section.nzsee2017, "c_0")),
        asce41_13=Asce41Options(**in_g(section.asce41_13, "s_x1")),
        ec8=Ec8Options(**in_g(section.ec8, "alpha_s")),
        dmi2008=Options(dmi2008.confidence_factor, _states(dmi2008.limit_states, deciding)),
        ntc2018=Options(ntc2018.confidence_factor, _states(ntc2018.limit_states, deciding)),
    )


def in_g(section: Section, key: str) -> dict[str, Any]:
    """Return the options of a section, with one acceleration in g as its clause takes it."""
    options = section.model_dump()
    return {**options, key: None if options[key] is None else options[key] / g}


def _states(asked: tuple[str, ...], deciding: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(state for state in ("SLD", "SLV", "SLC") if state in (*asked, *deciding))


def knowledge_of(content: sections.Content) -> Mapping[str, Mapping[str, str]]:
    """Return the level of knowledge by mechanism and code; raise ProjectError for an unknown mechanism."""
    found: dict[str, dict[str, str]] = {name: {} for name in content.mechanisms}
    for code in ("dmi2008", "ntc2018"):
        section: sections.Italian = getattr(content.procedures, code)
        _require_mechanisms(content, f"procedures.{code}.knowledge_levels", section.knowledge_levels)
        for name, levels in found.items():
            level = section.knowledge_levels.get(name, section.knowledge_level)
            if level is not None:
                levels[code] = level
    return found


def free_periods_of(content: sections.Content) -> Mapping[str, FreePeriod]:
    """Return T_0 by mechanism; raise ProjectError for an unknown one."""
    given = content.procedures.ntc2018.free_periods
    _require_mechanisms(content, "procedures.ntc2018.free_periods", given)
    return {
        name: free_period(**each.model_dump()) if isinstance(each, sections.FreeElement) else FreePeriod(each)
        for name, each in given.items()
    }


def _require_mechanisms(content: sections.Content, key: str, names: Iterable[str]) -> None:
    """Raise ProjectError for a name that is no mechanism."""
    for name in names:
        if name not in content.mechanisms:
            known = ", ".join(content.mechanisms)
            raise ProjectError(f"{key}: {value_text(name)}: no such mechanism; known: {known}")
