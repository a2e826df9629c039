"""What decides: the tables [verdict], [site] and [building] as the question that the verdict answers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from scipy.constants import g

from assess.codes.bases import BASES, BY_SITE
from assess.codes.basis import Basis, Premise
from assess.codes.verdict import (
    Action,
    Missing,
    Question,
)
from assess.codes.verdict.question import SOURCES, missing_input
from assess.errors import ProjectError
from assess.messages.message import Message, Quantity, Severity, message
from assess.project import sections
from assess.project.sources import source_of
from spectra import ntc
from spectra.spectrum import Spectrum

LIKE = 5e-3  # of a PGA: one given to three figures is the hazard's own
Facts = tuple[tuple[Missing, ...], tuple[Message, ...]]
"""What the pass of a mechanism needs and is not given, and what it depends on."""


def basis_of(content: sections.Content) -> Basis | None:
    """Return the basis that the project names, or that of its site's spectrum; None if neither gives one."""
    named = content.verdict.basis
    if named == "own":
        return own_basis(content.verdict)
    if named is not None:
        return BASES[named]
    code = "" if content.site is None else content.site.spectrum.code
    found = BASES.get(BY_SITE.get(code, ""))
    for name in content.verdict.procedures or ():
        if found is not None and name not in found.methods:
            raise ProjectError(f'verdict.procedures: "{name}" is not accepted by {found.name}, the basis of the site')
    return found


def question_of(content: sections.Content, *, site_pga: float, scale: float = 1.0) -> Question:
    """Return what the project asks of its basis at the site's own action; scale: of the spectrum by `pga` [-]."""
    asked, building, basis = content.verdict, content.building, basis_of(content)
    return Question(
        basis=basis,
        action=action_of(content, basis, pga_g=site_pga / g),
        limit_state=asked.limit_state,
        procedures=asked.procedures,
        works=asked.works,
        use_class=use_class_of(content),
        school=None if building is None else building.school,
        upgrading=asked.upgrading,
        index_before=asked.index_before,
        target_nbs=asked.target_nbs,
        missing=tuple(_scaled_down(content, scale)),
    )


def _scaled_down(content: sections.Content, scale: float) -> Iterator[Missing]:
    """Report a PGA of the site below that of its own hazard, which is not the action of any limit state."""
    if content.site is None or content.site.pga is None or scale > 1.0 - LIKE:
        return
    if isinstance(content.site.spectrum, sections.NtcHazardSpectrum):
        yield missing_input("site.pga", message("missing-own-pga", {"share": Quantity(scale, "ratio", 3)}))


def action_of(content: sections.Content, basis: Basis | None, *, pga_g: float) -> Action:
    """Return the action of the site's own spectrum; with hazard over return periods, at the limit state chosen."""
    if content.site is None:
        return Action(pga_g, None)
    own, spectrum = content.site.own_limit_state, content.site.spectrum
    if isinstance(spectrum, sections.NtcHazardSpectrum):
        state, use_class = limit_state_of(content), use_class_of(content)
        if use_class is None:
            return Action(pga_g, state, over_periods=True)
        life = ntc.reference_life(spectrum.nominal_life, use_class=use_class)
        return Action(pga_g, state, ntc.return_period(state, reference_life=life), over_periods=True)
    years = spectrum.return_period if isinstance(spectrum, sections.Nzs1170Spectrum) else None
    return Action(pga_g, own, years)


def limit_state_of(content: sections.Content) -> str:
    """Return the limit state of the site's own spectrum, if the site gives its hazard over return periods.

    It is that of the site, else the deciding one, else the default of the basis: "SLV".
    """
    own, basis = None if content.site is None else content.site.own_limit_state, basis_of(content)
    asked = (own, content.verdict.limit_state, None if basis is None else basis.default)
    return next((state for state in asked if state is not None and state in ntc.EXCEEDANCE), "SLV")


def use_class_of(content: sections.Content) -> str | None:
    """Return the class of use of the hazard or of the building; raise ProjectError if they differ."""
    spectrum = None if content.site is None else content.site.spectrum
    of_site = spectrum.use_class if isinstance(spectrum, sections.NtcHazardSpectrum) else None
    of_building = None if content.building is None else content.building.use_class
    if of_site is not None and of_building is not None and of_site != of_building:
        raise ProjectError(f'building.use_class: "{of_building}" beside site.spectrum.use_class "{of_site}"; give one')
    return of_site or of_building


def facts_of(
    content: sections.Content, question: Question, names: Sequence[str], spectrum: Spectrum | None = None
) -> Mapping[str, Facts]:
    """Return by mechanism the inputs that a pass needs and that are missing, and the conditions of a pass."""
    premises = () if question.basis is None else question.basis.premises
    holds = of_pga(content, spectrum)
    return {
        name: (tuple(_missing(content, name, premises)), (*holds, *_conditions(content, name, premises)))
        for name in names
    }


def of_pga(content: sections.Content, spectrum: Spectrum | None) -> tuple[Message, ...]:
    """Return the condition of a pass if `[site] pga` makes a single spectrum weaker than its own parameters do."""
    site = content.site
    if site is None or site.pga is None or spectrum is None or spectrum.factor > 1.0 - LIKE:
        return ()
    if isinstance(site.spectrum, sections.NtcHazardSpectrum):
        return ()  # it cannot pass at all: `_scaled_down`
    own = Quantity(site.pga / spectrum.factor / g, "ground acceleration", 3)
    values = {"given": Quantity(site.pga / g, "ground acceleration", 3), "own": own}
    return (message("pga-lowered", values, severity=Severity.WARNING),)


def _missing(content: sections.Content, name: str, premises: Sequence[Premise]) -> Iterator[Missing]:
    """Yield the masonry of a mechanism whose disintegration is not excluded, with a source."""
    if Premise.SOUND_MASONRY not in premises:
        return
    for table, said in _masonry(content, name).items():
        key = f"{table}.disintegration"
        if said != "excluded":
            yield missing_input(key, message("missing-disintegration"), 'disintegration = "excluded"')
        if said != "possible" and not source_of(content, key):
            why = message("missing-source", {"key": key})
            yield missing_input(SOURCES, why, f'"{key}" = "measured: …"')


def _masonry(content: sections.Content, name: str) -> Mapping[str, str | None]:
    """Return the disintegration stated for each masonry of a mechanism, by the table that states it."""
    section = content.mechanisms[name]
    if isinstance(section, sections.EquivalentBlock):
        return {f"mechanisms.{name}": section.disintegration}
    found: dict[str, str | None] = {}
    for body in (body for block in section.blocks for body in block):
        given = content.bodies[body]
        if isinstance(given, sections.DirectBody):
            found[f"bodies.{body}"] = given.disintegration
        else:
            found[f"materials.{given.material}"] = content.materials[given.material].disintegration
    return found


def _conditions(content: sections.Content, name: str, premises: Sequence[Premise]) -> tuple[Message, ...]:
    """Return the premises of the basis that cannot be verified here, and the thrusts that ties are stated to take."""
    keys = (f"premise-{premise.value}" for premise in premises if premise != Premise.SOUND_MASONRY)
    own = tuple(message(key, severity=Severity.WARNING) for key in keys)
    section = content.mechanisms[name]
    loads = section.loads if isinstance(section, sections.Chained) else ()
    tied = (load.body for load in loads if isinstance(load, sections.BodyLoad) and load.tied)
    return (*own, *(message("thrust-is-tied", {"what": body}, severity=Severity.WARNING) for body in tied))


def own_basis(section: sections.VerdictSection) -> Basis:
    """Return the basis that a project states itself, with its own procedures and rule."""
    from assess.codes.bases.own import own

    return own(section.procedures or (), rule=section.rule or "all", statement=section.statement)
