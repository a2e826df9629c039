"""The assessment as a document: its chapters in order, with every number taken from the results."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import partial
from typing import Literal

from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import (
    assumptions,
    calculation_sheets,
    comparisons,
    cover,
    envelopes,
    histories,
    inputs,
    interface_variants,
    interfaces,
    literature,
    other_levels,
    parameters,
    sensitivity,
    sentences,
    site,
    structure,
    suite,
    summary,
    sweeps,
    tables,
)
from reports.document import Block, Document, Figure, Items, Section, Signatures, Text, nonempty
from reports.figures import amplification, capacity, comparison, history, pga_rotation, sketch, spectrum, view
from reports.figures.model import model_of_view
from reports.language.catalogue import ENGLISH
from reports.language.numerals import numeral
from reports.language.verbatim import verbatim
from reports.mechanism_title import mechanism_title
from reports.references import reference, resolve_references

LONG = 120  # characters; longer titles and names are shortened where they head something and printed once in full
_FACTS = (
    ("engineer", "Engineer"),
    ("checker", "Checker"),
    ("client", "Client"),
    ("reference", "Reference"),
    ("date", "Date"),
    ("masonry_quality", "Masonry quality"),
)


def assessment(results: Results) -> Document:
    """Return the whole report of one run, in English and SI."""
    title = project_text(results, "title") or "Rocking assessment"
    chapters = [cover.section(results), summary.section(results), *structure.section(results), *_site(results)]
    chapters.append(assumptions.section(results))
    earlier = interface_variants.earlier_variants(results)
    stems = {each.name: file_stem(each.name, place) for place, each in enumerate(results.mechanisms, start=1)}
    for mechanism in results.mechanisms:
        name = stems[mechanism.name]
        chapters += _mechanism(results, mechanism, name, twin=stems.get(earlier.get(mechanism.name, ""), ""))
        chapters += sensitivity.chapter(results, mechanism.name, called=mechanism_title(mechanism), name=name)
    chapters += [
        *other_levels.chapter(results),
        *_comparison(results),
        *envelopes.critical_chapter(results),
        _limits(results),
    ]
    chapters += [literature.section(results), _signatures(results), _annex(results)]
    document = Document(
        title=title,
        subject="Seismic assessment of masonry by rocking dynamics",
        author=project_text(results, "engineer"),
        program=f"{results.program.name} {results.program.version}",
        paper=_paper(results),
        facts=_facts(results),
        sections=tuple(chapters),
        data=(
            tables.verdicts(results),
            inputs.values(results),
            comparisons.comparison(results),
            site.ordinates(results),
            parameters.curves(results),
            tables.pga_curves(results),
            *sensitivity.data(results),
            *envelopes.data(results),
        ),
        language=project_text(results, "report.language") or ENGLISH,
        verbatim=verbatim(results),
        units=_units(results),
        stamp=results.stamp,
    )
    return resolve_references(document)


def envelope_report(results: Results) -> Document:
    """Return the report of `assess envelope`: the critical mechanisms, and the envelope of each."""
    chapters = envelopes.critical_chapter(results)
    for place, mechanism in enumerate(results.mechanisms, start=1):
        chapters += envelopes.chapter(mechanism, results.records, file_stem(mechanism.name, place), level=0)
    warned = nonempty(inputs.warnings(results)) or [Text(("The run gave no warnings.",))]
    chapters += [Section("Warnings", 0, tuple(warned)), _annex(results)]
    return replace(
        assessment(results),
        subject="Overturning envelopes of masonry by rocking dynamics",
        sections=tuple(chapters),
        data=envelopes.data(results),
    )


def _facts(results: Results) -> tuple[tuple[str, str], ...]:
    given = ((label, project_text(results, key)) for key, label in _FACTS if project_text(results, key))
    return (
        *given,
        ("Program", f"{results.program.name} {results.program.version}"),
        ("Inputs", cover.fingerprint(results)),
    )


def project_text(results: Results, key: str) -> str:
    """Return a text of the project file.

    Parameters
    ----------
    results : of a run
    key : with dots, as "report.language"

    Returns
    -------
    str
        empty where the project gives none
    """
    found = results.project.get(key)
    return "" if found is None or found.value is None else str(found.value)


def file_stem(name: str, place: int) -> str:
    """Return a unique and safe beginning for the file names of a mechanism: its place and its name in plain letters."""
    plain = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:40].strip("-")
    return f"{place:02d}-{plain}" if plain else f"{place:02d}"


def _paper(results: Results) -> Literal["A4", "letter"]:
    return "letter" if project_text(results, "report.paper").lower() == "letter" else "A4"


def _units(results: Results) -> Literal["SI", "US"]:
    return "US" if project_text(results, "report.units") == "US" else "SI"


def _annex(results: Results) -> Section:
    """The inputs, whole."""
    title, notes = project_text(results, "title"), project_text(results, "notes")
    blocks: list[Block] = []
    blocks += [Text((f"Title in full: {title}",))] if len(title) > LONG else []
    blocks += [Text((f"Notes: {notes}",))] if notes else []
    blocks += [*nonempty(inputs.inputs(results)), *nonempty(inputs.values_present(results))]
    return Section("Annex: inputs", 0, tuple(blocks), starts_page=True)


def _site(results: Results) -> list[Section]:
    blocks: list[Block] = []
    if results.spectrum is not None:
        caption = (
            f"Elastic response spectrum of the site ({results.spectrum.code}, damping {results.spectrum.damping:.3g}) "
            f"and of the records as scaled to it{_fitted(results)}."
        )
        blocks.append(Figure("spectrum", caption, partial(spectrum.draw, results.spectrum, results.records)))
        blocks += nonempty(site.site(results))
    blocks += [*nonempty(site.records(results)), *suite.blocks(results), *nonempty(site.processing_history(results))]
    return [Section("Site and ground motion", 0, tuple(blocks))] if blocks else []


def _fitted(results: Results) -> str:
    """How far artificial records are fitted, where there are any."""
    artificial = any(not record.path for record in results.records)
    return "; artificial records are fitted up to a period of 4 s" if artificial else ""


def _mechanism(results: Results, mechanism: MechanismResult, name: str, *, twin: str) -> list[Section]:
    own = [sweep for sweep in results.sweeps if sweep.mechanism == mechanism.name]
    chapters = [
        _shape(mechanism, name, twin=twin),
        sweeps.studies(own, name=name),
        _answer(results, mechanism, name),
        _histories(mechanism, name),
        *envelopes.chapter(mechanism, results.records, name, level=1),
        _sheets(results, mechanism, name),
    ]
    return [chapter for chapter in chapters if chapter.blocks]


def _shape(mechanism: MechanismResult, name: str, *, twin: str) -> Section:
    blocks = (
        Text((sentences.description(mechanism),)),
        *sweeps.weakest_direction(mechanism, name=name),
        Figure(f"{name}-sketch", sentences.sketch_caption(mechanism), partial(sketch.draw, mechanism)),
        *_view(mechanism, name, twin=twin),
        *nonempty(parameters.loads(mechanism, name=f"{name}-loads")),
        parameters.parameters(mechanism, name=f"{name}-parameters"),
        Figure(f"{name}-capacity", sentences.capacity_caption(mechanism), partial(capacity.draw, mechanism)),
        *interfaces.blocks(mechanism, name=name),
        *nonempty(parameters.hinge_forces(mechanism, name=f"{name}-hinge-forces")),
    )
    return Section(f"Mechanism: {mechanism_title(mechanism)}", 0, blocks, starts_page=True)


def _view(mechanism: MechanismResult, name: str, *, twin: str) -> list[Block]:
    """The bodies in space, once for mechanisms that differ by their interface alone.

    twin : file stem of an earlier mechanism with the same bodies, empty for none
    """
    seen = mechanism.view
    if seen is None:
        return []
    if twin:
        return [Text((f"For its bodies in space see {reference('Figure', f'{twin}-view')}.",))]
    positive = len(mechanism.drawing.displaced.hinges)
    model = model_of_view(seen, positive=positive)
    return [Figure(f"{name}-view", sentences.view_caption(seen), partial(view.draw, seen, positive), model)]


def _answer(results: Results, mechanism: MechanismResult, name: str) -> Section:
    caption = (
        "Largest rotation over peak ground acceleration by every procedure (as thesis Figs. 8.6, 8.7). Solid lines are "
        "code procedures, dashed lines readings of the thesis; large markers the allowable of each; dots and crosses "
        "single records."
    )
    blocks: list[Block] = []
    if mechanism.checks:
        blocks.append(Figure(f"{name}-pga-rotation", caption, partial(pga_rotation.draw, mechanism)))
    unlike = sentences.input_locations(mechanism)
    blocks += [Text((unlike,))] if unlike else []
    blocks += nonempty(tables.demands(mechanism, name=f"{name}-demand-capacity"))
    blocks += nonempty(tables.answers(mechanism, governing.site_pga(results), name=f"{name}-remarks"))
    return Section("Demand and capacity", 1, tuple(blocks))


def _histories(mechanism: MechanismResult, name: str) -> Section:
    blocks: list[Block] = [
        *_amplification(mechanism, name),
        *nonempty(histories.suites(mechanism, name=f"{name}-suites")),
    ]
    found = governing.history(mechanism)
    if found is not None:
        one, trace = found
        draw = partial(history.draw, mechanism, one, trace, governing.allowable(mechanism, one.level_pga_g))
        end = "it overturns" if one.overturned else f"largest φ/φₒᵥ {numeral(abs(one.max_rotation_ratio or 0.0))}"
        caption = (
            f"The governing history: {one.record}, polarity {one.polarity:+d}, at PGA {one.level_pga_g:.3g} g; {end}; "
            f"{one.impacts} impacts. Above the acceleration, below the rotation."
        )
        blocks.append(Figure(f"{name}-history", caption, draw))
    blocks += nonempty(histories.histories(mechanism, name=f"{name}-histories"))
    return Section("Time histories", 1, tuple(blocks))


def _amplification(mechanism: MechanismResult, name: str) -> list[Block]:
    """How the motion reaches a mechanism above the ground, where the histories amplify it."""
    found = mechanism.amplification
    if found.height_m is None:
        return []
    explanation = Text(sentences.amplification(mechanism))
    if found.motion is None:
        return [explanation]
    draw = partial(amplification.draw, found.motion)
    return [explanation, Figure(f"{name}-amplification", sentences.amplification_caption(mechanism), draw)]


def _sheets(results: Results, mechanism: MechanismResult, name: str) -> Section:
    label = mechanism_title(mechanism)
    made = [
        calculation_sheets.calculation_sheet(check, name=f"{name}-sheet-{place:02d}", mechanism=label)
        for place, check in enumerate(governing.worst_per_procedure(governing.at_site(results, mechanism)), start=1)
        if check.steps
    ]
    note = "One sheet for each procedure, at the site’s own action; the steps of other levels are in results.json."
    return Section("Calculation sheets", 1, (Text((note,)), *made) if made else ())


def _comparison(results: Results) -> list[Section]:
    if not results.comparison:
        return []
    names = {mechanism.name: mechanism_title(mechanism) for mechanism in results.mechanisms}
    draw = partial(comparison.draw, governing.rows_to_draw(results), names, governing.overturned_rows(results))
    caption = (
        "Demand over capacity of every mechanism by every procedure; right of the line the check fails. Open markers "
        "are readings of the thesis, a cross marks overturning, an arrow a ratio beyond the axis or the end of "
        "the spectrum."
    )
    standing = sweeps.controlling_cases(results.sweeps, names)
    unlike = sentences.unequal_inputs(results)
    blocks = (
        *standing,
        *((Text(unlike),) if unlike else ()),
        Figure("comparison", caption, draw),
        *nonempty(comparisons.capacities(results)),
        comparisons.side_by_side(results),
        *nonempty(comparisons.rotations(results)),
        *interface_variants.blocks(results, name="interfaces"),
    )
    return [Section("Comparison of the mechanisms", 0, blocks, starts_page=True)]


def _limits(results: Results) -> Section:
    return Section("Limits of the method", 0, (Items(sentences.limits(results)),))


def _signatures(results: Results) -> Section:
    statement = (
        "The results above follow from the inputs and assumptions listed in this report. They become an "
        "assessment through the judgement of the engineer who signs it."
    )
    places = (("Engineer", project_text(results, "engineer")), ("Checker", project_text(results, "checker")))
    return Section("Signatures", 0, (Text((statement,)), Signatures(places)))
