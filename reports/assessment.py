"""The assessment as a document: its chapters in order, with every number taken from the results."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Literal

from assess.results import Results
from reports.chapters import (
    assumptions,
    check_tables,
    comparisons,
    cover,
    envelopes,
    inputs,
    interface_variants,
    limits,
    literature,
    mechanism,
    other_levels,
    parameters,
    sensitivity,
    site,
    structure,
    summary,
)
from reports.chapters.inputs import project_text
from reports.document import Document, Section, Signatures, Text, nonempty
from reports.language.catalogue import ENGLISH
from reports.language.verbatim import verbatim
from reports.mechanism_title import mechanism_title
from reports.references import resolve_references

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
    document = Document(
        title=project_text(results, "title") or "Rocking assessment",
        subject="Seismic assessment of masonry by rocking dynamics",
        author=project_text(results, "engineer"),
        program=f"{results.program.name} {results.program.version}",
        paper=_paper(results),
        facts=_facts(results),
        sections=tuple(_chapters(results)),
        data=(
            check_tables.verdicts(results),
            inputs.values(results),
            comparisons.comparison(results),
            site.ordinates(results),
            parameters.curves(results),
            check_tables.pga_curves(results),
            *sensitivity.data(results),
            *envelopes.data(results),
        ),
        language=project_text(results, "report.language") or ENGLISH,
        verbatim=verbatim(results),
        units=_units(results),
        stamp=results.stamp,
    )
    return resolve_references(document)


def _chapters(results: Results) -> list[Section]:
    """Return the chapters in order, with those of the mechanisms between the assumptions and the comparison."""
    chapters = [cover.section(results), summary.section(results), *structure.section(results), *site.section(results)]
    chapters.append(assumptions.section(results))
    earlier = interface_variants.earlier_variants(results)
    stems = {each.name: file_stem(each.name, place) for place, each in enumerate(results.mechanisms, start=1)}
    for each in results.mechanisms:
        name = stems[each.name]
        chapters += mechanism.chapter(results, each, name, twin=stems.get(earlier.get(each.name, ""), ""))
        chapters += sensitivity.chapter(results, each.name, called=mechanism_title(each), name=name)
    chapters += [
        *other_levels.chapter(results),
        *comparisons.chapter(results),
        *envelopes.critical_chapter(results),
        limits.section(results),
    ]
    return [*chapters, literature.section(results), _signatures(results), inputs.annex(results)]


def envelope_report(results: Results) -> Document:
    """Return the report of `assess envelope`: the critical mechanisms, and the envelope of each."""
    chapters = envelopes.critical_chapter(results)
    for place, each in enumerate(results.mechanisms, start=1):
        chapters += envelopes.chapter(each, results.records, file_stem(each.name, place), level=0)
    warned = nonempty(inputs.warnings(results)) or [Text(("The run gave no warnings.",))]
    chapters += [Section("Warnings", 0, tuple(warned)), inputs.annex(results)]
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


def file_stem(name: str, place: int) -> str:
    """Return a unique and safe beginning for the file names of a mechanism: its place and its name in plain letters."""
    plain = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:40].strip("-")
    return f"{place:02d}-{plain}" if plain else f"{place:02d}"


def _paper(results: Results) -> Literal["A4", "letter"]:
    return "letter" if project_text(results, "report.paper").lower() == "letter" else "A4"


def _units(results: Results) -> Literal["SI", "US"]:
    return "US" if project_text(results, "report.units") == "US" else "SI"


def _signatures(results: Results) -> Section:
    statement = (
        "The results above follow from the inputs and assumptions listed in this report. They become an "
        "assessment through the judgement of the engineer who signs it."
    )
    places = (
        ("Engineer", project_text(results, "engineer")),
        ("Checker", project_text(results, "checker")),
    )
    return Section("Signatures", 0, (Text((statement,)), Signatures(places)))
