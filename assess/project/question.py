"""What a project asks: what decides, by which procedures with which options, and which fragility.

Where the project names no procedures, those run whose `default_run` applies at its site (`assess.codes.check`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields, replace
from itertools import chain
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from assess.codes.bases import BASES, BY_SITE, DESIGN_BASIS, Basis, IndexKind, stated_basis
from assess.codes.check import TABLE_SPECTRUM, Premise
from assess.codes.context import FreePeriod, SiteHazard
from assess.codes.en1998_1 import EC8_ELEMENT, IMPORTANCE_FACTORS, REFERENCE_YEARS
from assess.codes.ntc2018_clauses import FreeElement, free_period
from assess.codes.nzsee2017 import NZSEE2017_FACE_LOADED, ULS_YEARS, required_return_factor
from assess.codes.procedures import KNOWLEDGE_CODES, PROCEDURES, CodeOptions, default_procedures
from assess.codes.question import SOURCES, Action, Missing, Question, VerdictFacts, methods_of, missing_input
from assess.codes.sliding import ASCE43_05_SLIDING, SLIDING
from assess.errors import ProjectError, locate_errors
from assess.geometry.solid import Solid
from assess.loads.roofs_and_vaults import leans_one_way
from assess.mechanisms.wedged_block import WEDGED_KINDS
from assess.messages.message import Message, Quantity, Severity, Value, message, whole_number
from assess.project import sections
from assess.project.key_errors import key_text, value_text
from assess.project.keys import error_line
from assess.project.section import fill, plain_data
from assess.project.state_before import Before, conditions_since_before, missing_since_before, works_of
from assess.results import ResolvedValue
from assess.results.fragility import HazardResult, StateResult
from assess.risk.hazard import read_hazard
from assess.study.fragility_runs import measure
from assess.study.study import FragilityQuestion, Stripe, deciding_limit_states
from records.reading import relative_path
from spectra import ntc
from spectra.design_spectra import (
    LEAST_LIFE,
    Asce7MappedSpectrum,
    Asce7Spectrum,
    Asce722Spectrum,
    Ec8Spectrum,
    Nzs1170Spectrum,
)
from spectra.gravity import g
from spectra.spectrum import Spectrum
from spectra.ts1170_5 import NEAR_FAULT

PROVISIONAL_CLASS = "IV"  # where the class of use is not given: that of the longest return periods
LIKE = 5e-3  # of a PGA: one given to three figures is the hazard's own


def basis_of(content: sections.Content) -> Basis | None:
    """Return the basis that the project names, or that of its site's spectrum; None if neither gives one."""
    named = content.verdict.basis
    if named == "own":
        verdict = content.verdict
        return stated_basis(verdict.procedures or (), rule=verdict.rule or "all", statement=verdict.statement)
    if named is not None:
        return BASES[named]
    code = "" if content.site is None else content.site.spectrum.code
    found = BASES.get(BY_SITE.get(code, ""))
    for name in content.verdict.procedures or ():
        if found is not None and name not in found.methods:
            raise ProjectError(f'verdict.procedures: "{name}" is not accepted by {found.name}, the basis of the site')
    return found


def question_of(
    content: sections.Content, *, site_pga: float, scale: float = 1.0, before: Before | None = None
) -> Question:
    """Return what the project asks of its basis at the site's own action.

    Parameters
    ----------
    content : of the project
    site_pga : of the site's own action [m/s2]
    scale : of the spectrum by `pga` [-]
    before : the state before the works, where the project names one and it has been read
    """
    verdict, building, basis = content.verdict, content.building, basis_of(content)
    return Question(
        basis=basis,
        action=action_of(content, basis, pga_g=site_pga / g),
        limit_state=verdict.limit_state,
        procedures=verdict.procedures,
        works=works_of(content, basis, before),
        use_class=use_class_of(content),
        school=None if building is None else building.school,
        upgrading=verdict.upgrading,
        index_before=verdict.index_before,
        before=None if before is None else before.state,
        target_nbs=verdict.target_nbs,
        missing=tuple(_scaled_down_hazard(content, scale)),
        provisional=tuple(_class_of_hazard(content)),
        struck_out=tuple(content.report.struck_out.items()),
    )


def _class_of_hazard(content: sections.Content) -> Iterator[Missing]:
    """Report that the class of use, on which the return period of the site's action depends, is not given."""
    if content.site is not None and content.site.hazard is not None and use_class_of(content) is None:
        why = message("missing-class-of-hazard", {"taken": PROVISIONAL_CLASS})
        yield missing_input("building.use_class", why, 'use_class = "II"')


def _scaled_down_hazard(content: sections.Content, scale: float) -> Iterator[Missing]:
    """Report a PGA of the site below that of its own hazard, which is not the action of any limit state."""
    if content.site is None or content.site.pga is None or scale > 1.0 - LIKE:
        return
    if content.site.hazard is not None:
        yield missing_input("site.pga", message("missing-own-pga", {"share": Quantity(scale, "ratio", 3)}))


def action_of(content: sections.Content, basis: Basis | None, *, pga_g: float) -> Action:
    """Return the action of the site's own spectrum; with hazard over return periods, at the limit state chosen."""
    if content.site is None:
        return Action(pga_g, None)
    own, hazard = content.site.own_limit_state, content.site.hazard
    if hazard is not None:
        state, use_class = limit_state_of(content), use_class_of(content) or PROVISIONAL_CLASS
        life = ntc.reference_life(hazard.nominal_life, use_class=use_class)
        return Action(pga_g, state, ntc.return_period(state, reference_life=life), over_periods=True)
    years = content.site.return_period
    return Action(pga_g, own, getattr(content.site.spectrum, "return_period", None) if years is None else years)


def limit_state_of(content: sections.Content) -> str:
    """Return the limit state of the site's own spectrum, if the site gives its hazard over return periods.

    It is that of the site, else the deciding one, else the default of the basis: "SLV".
    """
    own, basis = None if content.site is None else content.site.own_limit_state, basis_of(content)
    states = (own, content.verdict.limit_state, None if basis is None else basis.default)
    return next((state for state in states if state is not None and state in ntc.EXCEEDANCE), "SLV")


def use_class_of(content: sections.Content) -> str | None:
    """Return the class of use of the hazard or of the building; raise ProjectError if they differ."""
    of_site = None if content.site is None else getattr(content.site.spectrum, "use_class", None)
    of_building = None if content.building is None else content.building.use_class
    if of_site is not None and of_building is not None and of_site != of_building:
        raise ProjectError(f'building.use_class: "{of_building}" beside site.spectrum.use_class "{of_site}"; give one')
    return of_site or of_building


NO_SOLIDS: Mapping[str, Solid | None] = {}


def facts_of(
    content: sections.Content,
    question: Question,
    names: Sequence[str],
    spectrum: Spectrum | None = None,
    *,
    solids: Mapping[str, Solid | None] = NO_SOLIDS,
) -> Mapping[str, VerdictFacts]:
    """Return by mechanism the inputs that a pass needs and that are missing, and the conditions of a pass."""
    premises = {premise for method in methods_of(question) for premise in PROCEDURES[method].premises}
    years = _fixed_return_period(content, question)
    holds = (
        *lowered_pga_conditions(content, spectrum),
        *conditions_of_works(content, question),
        *conditions_since_before(content, question),
        *_conditions_of_own_basis(content, question),
        *_unstated_return_period(content, question, years),
        *_dbe_by_asce7(content),
        *near_fault_conditions(spectrum),
        *_of_another_spectrum(spectrum, question),
        *_unstated_importance_class(content, question),
    )
    importance = (
        *(_missing_importance(content) if NZSEE2017_FACE_LOADED.name in methods_of(question) else ()),
        *_missing_importance_factor(content, question),
    )
    lacking = (
        *importance,
        *_missing_of_table(content, question),
        *_too_short_return_period(content, question, years),
        *missing_since_before(content, question),
    )
    return {
        name: (
            (
                *lacking,
                *(_missing_masonry(content, name) if Premise.SOUND_MASONRY in premises else ()),
                *_missing_wholes(content, name, solids),
            ),
            (*holds, *_conditions(content, name, solids)),
        )
        for name in names
    }


def _missing_importance(content: sections.Content) -> Iterator[Missing]:
    """Yield the importance level of the building, or the return period that its ULS asks for, where it is longer."""
    level = None if content.building is None else content.building.importance_level
    if level is None:
        yield missing_input(
            "building.importance_level", message("missing-importance-level"), "importance_level = 2", enlarges=True
        )
        return
    needed, years = required_return_factor(level), ULS_YEARS[level]
    way = None if content.site is None else content.site.spectrum.plain
    asked: dict[str, Value] = {"level": whole_number(level), "years": whole_number(round(years))}
    if not isinstance(way, Nzs1170Spectrum):
        return
    if way.return_factor < needed * (1.0 - LIKE):
        given, least = Quantity(way.return_factor, "ratio", 3), Quantity(needed, "ratio", 3)
        key, line = ("return_period", f"{years:.0f}") if way.r is None else ("r", f"{needed:.4g}")
        why = message("missing-return-period-of-level", {**asked, "given": given, "needed": least})
        yield missing_input(f"site.spectrum.{key}", why, f"{key} = {line}", enlarges=True)


def _provided_importance(content: sections.Content, question: Question) -> float | None:
    """Return gamma_I of a spectrum under EN 1998-1, stated or by its return period; None where that code is not asked.

    The rate of exceedance is taken to fall with the cube of the acceleration (2.1(4), note; from memory).
    """
    site = content.site
    if site is None or EC8_ELEMENT.name not in methods_of(question):
        return None
    way, years = site.spectrum.plain, site.return_period or REFERENCE_YEARS
    by_years = float((years / REFERENCE_YEARS) ** (1.0 / 3.0))
    return max(by_years, way.importance_factor) if isinstance(way, Ec8Spectrum) else by_years


def _importance_class(content: sections.Content) -> str | None:
    """Return the importance class under EN 1998-1, the class of use or the level of the same rank; None if neither."""
    level = None if content.building is None else content.building.importance_level
    return use_class_of(content) or (None if level is None else tuple(IMPORTANCE_FACTORS)[level - 1])


def _missing_importance_factor(content: sections.Content, question: Question) -> Iterator[Missing]:
    """Yield gamma_I where it is less than that of the building's class: the spectrum is that of a lower one."""
    given, use_class = _provided_importance(content, question), _importance_class(content)
    if given is None or use_class is None or given >= IMPORTANCE_FACTORS[use_class] * (1.0 - LIKE):
        return
    needed = IMPORTANCE_FACTORS[use_class]
    values: dict[str, Value] = {
        "class": use_class,
        "needed": Quantity(needed, "ratio", 3),
        "given": Quantity(given, "ratio", 3),
    }
    assert content.site is not None
    if isinstance(content.site.spectrum.plain, Ec8Spectrum):
        key, line = "site.spectrum.importance_factor", f"importance_factor = {needed}"
    else:
        key, line = "site.return_period", f"return_period = {REFERENCE_YEARS * needed**3:.0f}"
    yield missing_input(key, message("missing-importance-factor", values), line, enlarges=True)


def _unstated_importance_class(content: sections.Content, question: Question) -> Iterator[Message]:
    """Yield the condition that the building is of no higher class than the spectrum's gamma_I is for."""
    given = _provided_importance(content, question)
    if given is None or _importance_class(content) is not None:
        return
    classes = [each for each, needed in IMPORTANCE_FACTORS.items() if needed * (1.0 - LIKE) <= given]
    values: dict[str, Value] = {"class": classes[-1] if classes else "I", "given": Quantity(given, "ratio", 3)}
    yield message("premise-importance-class", values, severity=Severity.WARNING)


def _dbe_by_asce7(content: sections.Content) -> Iterator[Message]:
    """Yield the condition that a spectrum by ASCE 7 is the design basis earthquake that it is declared to be.

    ASCE/SEI 43-05 has that from the uniform hazard at 4e-4 or 1e-4 a year; ASCE 7 takes two thirds of its own maximum.
    """
    way = None if content.site is None else content.site.spectrum.plain
    if content.site is None or not isinstance(way, Asce7Spectrum | Asce7MappedSpectrum | Asce722Spectrum):
        return
    if content.site.own_limit_state == DESIGN_BASIS:
        yield message("dbe-by-asce7", {"hazard": way.hazard}, severity=Severity.WARNING)


def near_fault_conditions(spectrum: Spectrum | None) -> Iterator[Message]:
    """Yield the condition that no major fault is near, where the spectrum is not known to be free of it."""
    if spectrum is not None and any(each.key == NEAR_FAULT for each in spectrum.warnings):
        yield message("premise-near-fault", severity=Severity.WARNING)


def _of_another_spectrum(spectrum: Spectrum | None, question: Question) -> Iterator[Message]:
    """Yield the condition that a method applies to the site's spectrum, where it is written for that of other codes."""
    if spectrum is None or question.basis is None or question.basis.name == "own":
        return
    for method in methods_of(question):
        written = PROCEDURES[method].spectra
        if written and spectrum.code not in (*written, TABLE_SPECTRUM):
            values: dict[str, Value] = {"codes": ", ".join(written), "code": spectrum.code}
            values["method"] = PROCEDURES[method].title
            yield message("premise-other-spectrum", values, severity=Severity.WARNING)


ORDINARY_LIFE = 50.0  # years: nominal life of ordinary works (NTC 2018, 2.4.1), where the project gives none


def _fixed_return_period(content: sections.Content, question: Question) -> float | None:
    """Return the return period that the basis fixes for the site's single spectrum [years]; None where it fixes none.

    By the Italian codes it follows from limit state and class of use, that of the longest where none is given.
    """
    basis, state = question.basis, question.action.limit_state
    if basis is None or state is None or content.site is None or content.site.hazard is not None:
        return None
    if basis.index == IndexKind.ZETA_E:
        if state not in ntc.EXCEEDANCE:
            return None
        life = ntc.reference_life(ORDINARY_LIFE, use_class=use_class_of(content) or PROVISIONAL_CLASS)
        return ntc.return_period(state, reference_life=life)
    if basis.index == IndexKind.NBS:
        level = None if content.building is None else content.building.importance_level
        return None if level is None else ULS_YEARS[level]
    return next((each.years for each in basis.states if state in each.actions), None)


def _missing_of_table(content: sections.Content, question: Question) -> Iterator[Missing]:
    """Yield the return period and the damping of a spectrum given as a table, of which only the engineer knows."""
    site, basis = content.site, question.basis
    if site is None or basis is None or basis.name == "own" or site.spectrum.code != TABLE_SPECTRUM:
        return
    if site.return_period is None:
        yield missing_input("site.return_period", message("missing-return-period"), "return_period = 475")
    if not site.spectrum.has_key("damping"):
        yield missing_input("site.spectrum.damping", message("missing-damping-of-table"), "damping = 0.05")


def _too_short_return_period(content: sections.Content, question: Question, years: float | None) -> Iterator[Missing]:
    """Yield a stated return period below the one that the basis fixes: the spectrum is not that of the limit state."""
    stated = None if content.site is None else content.site.return_period
    if years is None or stated is None or stated >= years * (1.0 - LIKE):
        return
    assert question.basis is not None
    values: dict[str, Value] = {
        "state": question.action.limit_state or "",
        "years": Quantity(years, "return period", 3),
        "given": Quantity(stated, "return period", 3),
    }
    if question.basis.index != IndexKind.ZETA_E:
        why = message("missing-return-period-of-state", values)
        yield missing_input("site.return_period", why, f"return_period = {years:.0f}", enlarges=True)
    elif (use_class := use_class_of(content)) is None:
        values["taken"] = PROVISIONAL_CLASS
        why = message("missing-class-of-return-period", values)
        yield missing_input("building.use_class", why, 'use_class = "II"', enlarges=True)
    else:
        why = message("missing-return-period-of-class", {**values, "class": use_class})
        yield missing_input("site.return_period", why, f"return_period = {years:.0f}", enlarges=True)


def _unstated_return_period(content: sections.Content, question: Question, years: float | None) -> Iterator[Message]:
    """Yield the condition that a single spectrum, stated for a limit state alone, is that of its return period."""
    site, basis = content.site, question.basis
    italian = basis is not None and basis.index == IndexKind.ZETA_E
    if years is None or site is None or not italian or site.return_period is not None:
        return
    if site.spectrum.code != TABLE_SPECTRUM:
        values: dict[str, Value] = {
            "state": question.action.limit_state or "",
            "years": Quantity(years, "return period", 3),
            "class": use_class_of(content) or PROVISIONAL_CLASS,
        }
        yield message("return-period-unstated", values, severity=Severity.WARNING)


def lowered_pga_conditions(content: sections.Content, spectrum: Spectrum | None) -> tuple[Message, ...]:
    """Return the condition of a pass if `[site] pga` makes a single spectrum weaker than its own parameters do."""
    site = content.site
    if site is None or site.pga is None or spectrum is None or spectrum.factor > 1.0 - LIKE:
        return ()
    if site.hazard is not None:
        return ()  # it cannot pass at all: `_scaled_down_hazard`
    own = Quantity(site.pga / spectrum.factor / g, "ground acceleration", 3)
    values = {"given": Quantity(site.pga / g, "ground acceleration", 3), "own": own}
    return (message("pga-lowered", values, severity=Severity.WARNING),)


def conditions_of_works(content: sections.Content, question: Question) -> Iterator[Message]:
    """Yield the conditions of a pass of works on the whole building, and of those of a phase of construction."""
    zeta = question.basis is not None and question.basis.index == IndexKind.ZETA_E
    if zeta and question.works in ("improvement", "upgrading"):
        yield message("global-check", severity=Severity.WARNING)
    hazard = None if content.site is None else content.site.hazard
    if hazard is not None and hazard.nominal_life < LEAST_LIFE:
        life = Quantity(hazard.nominal_life, "return period", 3)
        yield message("phase-of-works", {"life": life}, severity=Severity.WARNING)


def _conditions_of_own_basis(content: sections.Content, question: Question) -> Iterator[Message]:
    """Yield what a pass under a basis of the engineer's own leaves out: the other procedures, or overturning."""
    if content.verdict.basis != "own":
        return
    methods = methods_of(question)
    if content.verdict.rule == "any" and len(methods) > 1:
        yield message("one-of-several", {"procedures": ", ".join(methods)}, severity=Severity.WARNING)
    if set(methods) <= {SLIDING.name, ASCE43_05_SLIDING.name}:
        yield message("sliding-alone", severity=Severity.WARNING)


def _missing_masonry(content: sections.Content, name: str) -> Iterator[Missing]:
    """Yield the masonry of a mechanism whose disintegration is not excluded, with a source."""
    for table, disintegration in _masonry(content, name).items():
        key = f"{table}.disintegration"
        if disintegration != "excluded":
            yield missing_input(key, message("missing-disintegration"), 'disintegration = "excluded"')
        if disintegration != "possible" and not content.report.source_of(key):
            why = message("missing-source", {"key": key})
            yield missing_input(SOURCES, why, f'"{key}" = "measured: …"')


OF_MANY_PARTS = ("several-classes", "many-shells")  # notes on meshes that are likely more than one rigid body


def _missing_wholes(content: sections.Content, name: str, solids: Mapping[str, Solid | None]) -> Iterator[Missing]:
    """Yield each body of a mechanism that is made of so many parts that somebody must say that they move as one."""
    section = content.mechanisms[name]
    for body in dict.fromkeys(() if section.kind == "equivalent-block" else chain(*section.blocks)):
        solid, key = solids.get(body), f"bodies.{body}"
        steps = [step for step in solid.history if step.key in OF_MANY_PARTS] if solid is not None else []
        if steps and not content.report.source_of(key):
            why = message("missing-rigid-whole", {"what": steps[0]})
            yield missing_input(SOURCES, why, f'"{key}" = "measured: …"')


def _masonry(content: sections.Content, name: str) -> Mapping[str, str | None]:
    """Return the disintegration stated for each masonry of a mechanism, by the table that states it."""
    section = content.mechanisms[name]
    if section.kind == "equivalent-block":
        return {f"mechanisms.{name}": section.disintegration}
    found: dict[str, str | None] = {}
    for body in (body for block in section.blocks for body in block):
        given = content.bodies[body]
        if isinstance(given, sections.DirectBody):
            found[f"bodies.{body}"] = given.disintegration
        else:
            found[f"materials.{given.material}"] = content.materials[given.material].disintegration
    return found


def _conditions(content: sections.Content, name: str, solids: Mapping[str, Solid | None]) -> tuple[Message, ...]:
    """Return what is not examined below a cut, what ties and anchorages are to bear, and thrusts of lone slopes."""
    section = content.mechanisms[name]
    loads = section.loads if isinstance(section, sections.ChainSection) else ()
    tied = (load.body for load in loads if load.kind == "body" and load.tied)
    plates = [f"tie {place}" for place, load in enumerate(loads, start=1) if load.kind == "tie" and load.plate]
    unexamined = [
        f"tie {place}"
        for place, load in enumerate(loads, start=1)
        if load.kind == "tie" and load.plate and load.plate.course is None and load.strength is None
    ]
    stated = getattr(section, "direction", None)
    towards = None if stated is None or isinstance(stated, str) else stated
    free = [each for each in loads if each.kind == "body" and each.thrust is None and not each.tied]
    slopes = dict.fromkeys(
        load.body
        for load in free
        if (solid := solids.get(load.body)) is not None and leans_one_way(load, solid, direction=towards)
    )
    return (
        *_unexamined_below_cut(content, name),
        *_not_drawn(content, name),
        *_not_sought(content, name),
        *(message("thrust-is-tied", {"what": body}, severity=Severity.WARNING) for body in tied),
        *([message("anchorage-computed", {"what": ", ".join(plates)}, severity=Severity.WARNING)] if plates else []),
        *([message("units-slide", {"what": ", ".join(unexamined)}, severity=Severity.WARNING)] if unexamined else []),
        *(message("slope-as-beam", {"what": body}, severity=Severity.WARNING) for body in slopes),
    )


def _unexamined_below_cut(content: sections.Content, name: str) -> Iterator[Message]:
    """Yield the condition of a mechanism of what lies above a cut, whose bodies no other examines from their base."""
    section = content.mechanisms[name]
    if not isinstance(section, sections.ChainSection) or section.cut is None:
        return
    whole = [
        each for each in content.mechanisms.values() if isinstance(each, sections.ChainSection) and each.cut is None
    ]
    from_their_base = {body for each in whole for block in each.blocks for body in block}
    bodies = [body for block in section.blocks for body in block if body not in from_their_base]
    if bodies and not content.report.source_of(f"mechanisms.{name}.cut"):
        yield message("examined-above-cut", {"bodies": ", ".join(bodies)}, severity=Severity.WARNING)


def _not_drawn(content: sections.Content, name: str) -> Iterator[Message]:
    """Yield the condition that what a mechanism by values alone states is so: nothing drawn shows it, and no source."""
    section = content.mechanisms[name]
    if isinstance(section, sections.ChainSection):
        bodies = dict.fromkeys(chain(*section.blocks))
        by_values = [each for each in bodies if isinstance(content.bodies[each], sections.DirectBody)]
        stated = [f"bodies.{body}.{key}" for body in by_values for key in ("mass", "centroid", "inertia")]
        stated += [f"mechanisms.{name}.hinges"] if by_values else []
    else:
        stated = [f"mechanisms.{name}.{key}" for key in ("p", "uplift", "radius", "elevation")]
    if keys := [key for key in stated if not content.report.source_of(key)]:
        yield message("not-drawn", {"keys": ", ".join(keys)}, severity=Severity.WARNING)


def _not_sought(content: sections.Content, name: str) -> Iterator[Message]:
    """Yield the condition that hinges or cracks form where they are stated: weaker ones are not sought."""
    section = content.mechanisms[name]
    stated: Sequence[str | tuple[str, int]] = ()
    if section.kind == "four-hinge":
        given = [key for key in ("hinges", "hinges_negative", "direction") if key in section.model_fields_set]
        stated = [key for key in given if getattr(section, key) != "minimum"]
    elif section.kind in WEDGED_KINDS:
        stated = [("wedges", number) for number in range(len(section.wedges))]
    paths = [("mechanisms", name, *((each,) if isinstance(each, str) else each)) for each in stated]
    if keys := [key_text(path) for path in paths if not content.report.source_of(".".join(map(str, path)))]:
        yield message("not-sought", {"keys": ", ".join(keys)}, severity=Severity.WARNING)


def procedures_of(content: sections.Content) -> tuple[str, ...]:
    """Return the procedures named, or all that apply at the site and check one of the limit states requested.

    Raises ProjectError for a procedure that is named and checks none of them.
    """
    named = content.analysis.procedures
    if named is None:
        code = "" if content.site is None else content.site.spectrum.code
        has_friction = any(material.friction is not None for material in content.materials.values())
        by_site = default_procedures(code, has_friction=has_friction)
        return with_methods((name for name in by_site if not _states_not_checked(name, content)), content)
    for name in named:
        if states := _states_not_checked(name, content):
            key = f"procedures.{PROCEDURES[name].options}.limit_states"
            known = ", ".join(PROCEDURES[name].limit_states)
            raise ProjectError(f"{key}: {', '.join(states)}: {name} checks {known}; add one, or leave it out")
    return with_methods(named, content)


def with_methods(names: Iterable[str], content: sections.Content) -> tuple[str, ...]:
    """Add the procedures that may decide, which run in any case."""
    deciding = () if content.site is None else methods_of(question_of(content, site_pga=0.0))
    return tuple(dict.fromkeys((*names, *deciding)))


def _states_not_checked(name: str, content: sections.Content) -> tuple[str, ...]:
    """Return the limit states requested if the procedure checks none of them, else nothing."""
    checked = PROCEDURES[name].limit_states
    if not checked:
        return ()
    states: tuple[str, ...] = getattr(content.procedures, PROCEDURES[name].options).limit_states
    return () if set(states) & set(checked) else states


def with_values_of_run(
    resolved: Mapping[str, ResolvedValue], content: sections.Content, question: Question
) -> dict[str, ResolvedValue]:
    """Add the procedures that run and the kind of works to the values, and leave out default options of other codes."""
    names = procedures_of(content)
    codes = {key: key.split(".")[1] for key in resolved if key.startswith("procedures.")}
    used = {PROCEDURES[name].options.replace("_", "-") for name in names}
    unused = {key for key, code in codes.items() if code not in used}
    kept = {key: each for key, each in resolved.items() if each.given or key not in unused}
    return {
        **kept,
        "analysis.procedures": ResolvedValue(list(names), content.analysis.procedures is not None),
        "verdict.works": ResolvedValue(question.works, content.verdict.works is not None),
    }


def options_of(content: sections.Content) -> CodeOptions:
    """Return the options of every code; the limit states that decide are among theirs."""
    section, deciding = content.procedures, deciding_limit_states(question_of(content, site_pga=0.0))
    options = {each.name: plain_data(getattr(section, each.name)) for each in fields(CodeOptions)}
    for code in KNOWLEDGE_CODES:
        checked = {*options[code].limit_states, *deciding}
        states = tuple(state for state in ("SLD", "SLV", "SLC") if state in checked)
        options[code] = replace(options[code], limit_states=states)
    return CodeOptions(**options)


def knowledge_of(content: sections.Content) -> Mapping[str, Mapping[str, str]]:
    """Return the level of knowledge by mechanism and code; raise ProjectError for an unknown mechanism."""
    found: dict[str, dict[str, str]] = {name: {} for name in content.mechanisms}
    for code in KNOWLEDGE_CODES:
        section = getattr(content.procedures, code)
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
        name: free_period(each) if isinstance(each, FreeElement) else FreePeriod(each)
        for name, each in plain_data(given).items()
    }


def _require_mechanisms(content: sections.Content, key: str, names: Iterable[str]) -> None:
    """Raise ProjectError for a name that is no mechanism."""
    for name in names:
        if name not in content.mechanisms:
            known = ", ".join(content.mechanisms)
            raise ProjectError(f"{key}: {value_text(name)}: no such mechanism; known: {known}")


def fragility_question(
    section: sections.Fragility, risk: sections.Risk, hazard: SiteHazard | None, *, folder: Path
) -> FragilityQuestion:
    """Return what is asked of fragility; `hazard`: of an Italian site, used where `risk` gives no other."""
    measures = tuple(measure(*sections.measure_of(text)) for text in section.measures or ())
    is_pga = not measures or measures[0].dimension == "ground acceleration"
    return fill(
        FragilityQuestion,
        section,
        measures=measures,
        states=tuple(map(_fragility_state, section.states)),
        largest=None if section.largest is None else float(section.largest) / (g if is_pga else 1.0),
        stripes=tuple(Stripe(float(e.intensity) / (g if is_pga else 1.0), e.records) for e in section.stripes or ()),
        hazard=_hazard_result(risk, hazard, folder),
        target_rate=risk.target,
    )


def read_fragility_question(**given: Any) -> FragilityQuestion:
    """Return what is asked of fragility by keys of [analysis.fragility] and [analysis.risk].

    Raises
    ------
    ProjectError : a project file would be refused for it; one line that names the key
    """
    own = {key: value for key, value in given.items() if key in sections.Fragility.model_fields}
    raw = {"fragility": own, "risk": {key: value for key, value in given.items() if key not in own}}
    try:
        found = sections.Analysis.model_validate(raw, context={"folder": Path()})
    except ValidationError as error:
        raise ProjectError(error_line(error, raw=raw)) from None
    assert found.fragility is not None
    assert found.risk is not None
    return fragility_question(found.fragility, found.risk, None, folder=Path())


def hazard_files(content: sections.Content) -> list[Path]:
    """Return the file of the hazard, if one is named."""
    risk = content.analysis.risk
    return [] if risk is None or risk.curve is None else [risk.curve]


def _fragility_state(value: str | float) -> StateResult:
    if isinstance(value, str):
        return StateResult("rocking") if value == "rocking" else StateResult("overturning")
    return StateResult("rotation", value)


def _hazard_result(risk: sections.Risk, site: SiteHazard | None, folder: Path) -> HazardResult | None:
    """Return the hazard: rows of the project, or a file, or the rows of an Italian site."""
    if risk.hazard is not None:
        pga = tuple(row.pga / g for row in risk.hazard)
        return HazardResult(measure("pga"), "analysis.risk.hazard", pga, tuple(row.annual_rate for row in risk.hazard))
    if risk.curve is not None:
        place = risk.site
        longitude, latitude = (None, None) if place is None else (place.longitude, place.latitude)
        with locate_errors("analysis.risk.curve"):
            found = read_hazard(risk.curve, longitude=longitude, latitude=latitude)
        intensity, annual_rate = (tuple(each.tolist()) for each in (found.curve.intensity, found.curve.annual_rate))
        own = measure(found.measure, () if found.period is None else (found.period,))
        return HazardResult(own, relative_path(risk.curve, folder), intensity, annual_rate, found.distance)
    if site is None:
        return None
    rates = tuple(1.0 / years for years in site.return_period)
    return HazardResult(measure("pga"), "site.spectrum.hazard", tuple(pga / g for pga in site.pga), rates)
