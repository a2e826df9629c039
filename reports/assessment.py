"""The assessment as a document: its chapters in order, with every number taken from the results."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import count
from typing import Literal

from assess.results import SCHEMA_VERSION, Results
from assess.results.fragility import FragilityResults
from assess.results.inputs import Resolved
from assess.results.verification import VerificationResults
from reports.chapters import (
    annex_envelopes,
    annex_histories,
    annex_inputs,
    annex_sheets,
    annex_suite,
    assumptions,
    comparison,
    data_tables,
    declaration,
    fragility,
    fragility_data,
    front_matter,
    key_plan,
    mechanism_page,
    recommendations,
    scope,
    sensitivity,
    signatures,
    site,
    uncertainty,
    verdict,
    verification,
)
from reports.document import Document, Section
from reports.figures.building import building_of
from reports.language.catalogue import ENGLISH
from reports.language.locale import Locale
from reports.language.texts import say
from reports.project_text import project_text
from reports.titles import file_stem

Detail = Literal["main", "full"]


def assessment(results: Results, *, detail: Detail | None = None) -> Document:
    """Return the report of one run. detail: of the project if None; "full" adds the annexes."""
    return Document(
        title=front_matter.title(results),
        subject=say("Seismic assessment of masonry by rocking dynamics"),
        author=front_matter.author(results),
        program=f"{results.program.name} {results.program.version}",
        paper=_paper(results),
        facts=front_matter.facts(results),
        sections=_numbered([*_main(results), *(_annexes(results) if is_full(results, detail) else ())]),
        data=tuple(data_tables.tables(results)),
        running=front_matter.running_head(results),
        logo=front_matter.logo(results),
        stamp=results.stamp,
        date=front_matter.date(results),
        locale=locale_of(results),
    )


def is_full(results: Results, detail: Detail | None) -> bool:
    """Return whether the report has annexes."""
    return (detail or project_text(results, "report.detail")) == "full"


def _main(results: Results) -> Iterator[Section]:
    """Yield the sections that are signed."""
    yield from verdict.sections(results)
    building = building_of(results)
    yield from key_plan.sections(results, building)
    yield from scope.sections(results)
    yield from assumptions.sections(results)
    yield from site.sections(results)
    for place, each in enumerate(results.mechanisms, start=1):
        yield from mechanism_page.sections(results, each, file_stem(each.name, place), building)
    yield from comparison.sections(results)
    yield from sensitivity.sections(results)
    yield from uncertainty.sections(results)
    yield from recommendations.sections(results)
    yield from declaration.sections(results)
    yield from signatures.sections(results)


def _annexes(results: Results) -> Iterator[Section]:
    """Yield what a reviewer needs to redo the calculation."""
    yield from annex_sheets.sections(results)
    yield from sensitivity.others(results)
    yield from uncertainty.others(results)
    yield from annex_histories.sections(results)
    yield from annex_envelopes.sections(results)
    yield from annex_suite.sections(results)
    yield from annex_inputs.sections(results)


def _numbered(sections: list[Section]) -> tuple[Section, ...]:
    """Return the sections with the number of each chapter that has no mark of its own, as annexes and mechanisms do."""
    numbers = map(str, count(1))
    bare = (section.level == 0 and not section.mark for section in sections)
    return tuple(replace(each, mark=next(numbers)) if own else each for each, own in zip(sections, bare, strict=True))


def envelope_report(results: Results) -> Document:
    """Return the report of `assess envelope`: the critical mechanisms, and the envelope of each."""
    return replace(
        assessment(results),
        subject=say("Overturning envelopes of masonry by rocking dynamics"),
        sections=_numbered([*annex_envelopes.report(results), *annex_inputs.sections(results)]),
        data=tuple(annex_envelopes.data(results)),
    )


def fragility_report(results: FragilityResults) -> Document:
    """Return the report of `assess fragility`: all mechanisms, the pages of each, method, records and inputs.

    Parameters
    ----------
    results : of `assess fragility`
    """
    run = without_answers(results)
    inputs = (replace(each, mark="", starts_page=False) for each in annex_inputs.sections(run))
    return replace(
        assessment(run),
        subject=say("Fragility of masonry by rocking dynamics"),
        sections=_numbered([*fragility.sections(results), *inputs]),
        data=tuple(fragility_data.tables(results)),
    )


def verification_report(results: VerificationResults, language: str | None = None) -> Document:
    """Return the annex of `assess verify`: outcome, program, theory, every solved case, and what is not covered.

    Parameters
    ----------
    results : of `assess verify`
    language : in place of the project's
    """
    project = {**results.project}
    run = Results(
        SCHEMA_VERSION, results.program, results.inputs, (), project, None, (), (), None, (), (), report=results.report
    )  # fmt: skip
    named = bool(project_text(run, "title"))
    return replace(
        assessment(run),
        title=front_matter.title(run) if named else say("Verification of the program by solved cases"),
        subject=say("Verification of the program by solved cases (NTC 2018, 10.2)"),
        sections=_numbered(verification.sections(results)),
        data=(),
        locale=locale_of(run, language),
    )


def without_answers(results: FragilityResults) -> Results:
    """Return the results of a run with the project and the front matter of `results`, and no mechanism."""
    project = {"title": Resolved(results.title or None, bool(results.title)), **results.project}
    return Results(
        SCHEMA_VERSION, results.program, results.inputs, results.warnings, project, None, (), (), None, (), (),
        stamp=results.stamp, report=results.report,
    )  # fmt: skip


def locale_of(results: Results, language: str | None = None) -> Locale:
    """Return the language and the units that the project asks its report in.

    Parameters
    ----------
    results : of a run
    language : in place of the project's
    """
    system: Literal["SI", "US"] = "US" if project_text(results, "report.units") == "US" else "SI"
    return Locale(language or project_text(results, "report.language") or ENGLISH, system)


def _paper(results: Results) -> Literal["A4", "letter"]:
    return "letter" if project_text(results, "report.paper").lower() == "letter" else "A4"
