"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from assess.errors import AssessError
from assess.results import SCHEMA_VERSION, Results
from assess.results.fragility import FragilityResults
from assess.results.provenance import ResolvedValue
from assess.results.verification import VerificationResults
from assess.workers import available_cores
from reports.chapters import (
    annex_envelopes,
    annex_histories,
    annex_inputs,
    annex_sheets,
    assumptions,
    before_and_after,
    comparison,
    data_tables,
    declaration,
    fragility,
    fragility_tables,
    front_matter,
    key_plan,
    mechanism_page,
    recommendations,
    scope,
    sensitivity,
    site,
    suite,
    uncertainty,
    verdict,
    verification,
)
from reports.document import Document, Section
from reports.figures.key_plan import building_of
from reports.governing import by_own_code
from reports.language.locale import ENGLISH, Locale
from reports.language.texts import Phrase, Text, say
from reports.mechanisms import file_stem, numbered_title
from reports.project_values import project_text
from reports.render.html import write_html
from reports.render.pdf import write_pdf
from reports.render.spreadsheet import write_xlsx
from reports.render.table_text import plain_tables, program_and_stamp, write_csv
from reports.render.vector import document_processes, svg_picture, trace_figures, write_png, write_svg

if TYPE_CHECKING:
    from matplotlib.figure import Figure


Form = Literal["svg", "png"]


def write_all(
    results: Results,
    folder: Path,
    *,
    language: str | None = None,
    detail: Detail | None = None,
    figures: Sequence[Form] = ("svg",),
    jobs: int = 0,
    progress: Callable[[str], None] | None = None,
) -> Path:
    """Write report.pdf, report.html, tables.xlsx, tables/*.csv and figures/* into the empty `folder`; return the PDF.

    Parameters
    ----------
    results : of a run
    folder : an empty one
    language : "en" or "it"; that of the project if None
    detail : "main", or "full" with the annexes; that of the project if None
    figures : forms in which they are written
    jobs : processes to use, 0 for as many as there are cores; the files are the same
    progress : called with the name of each stage as it begins
    """
    document = replace(assessment(results, detail=detail), locale=locale_of(results, language))
    return write_document(document, folder, name="report.pdf", figures=figures, jobs=jobs, progress=progress)


def write_document(
    document: Document,
    folder: Path,
    *,
    name: str,
    figures: Sequence[Form] = ("svg",),
    jobs: int = 0,
    progress: Callable[[str], None] | None = None,
) -> Path:
    """Write a document in its locale into the empty `folder` in every form; return the PDF.

    Parameters
    ----------
    document : of any chapters
    folder : an empty one
    name : of the PDF
    figures, jobs, progress : as of `write_all`
    """
    report_stage = progress or (lambda _: None)
    for part in ("tables", "figures"):
        (folder / part).mkdir(exist_ok=True)
    creator = document.locale.text(program_and_stamp(document))
    with document_processes(jobs or available_cores(), document) as submit:
        report_stage("figures")
        drawings = trace_figures(document, submit)
        tables = submit(_write_tables, folder)
        report_stage("report")
        path = write_pdf(document, folder / name, drawings=drawings)
        pictures = {figure: svg_picture(drawing.result()) for figure, drawing in drawings.items()}
        for figure in pictures if "svg" in figures else ():
            write_svg(pictures[figure], folder / "figures" / f"{figure}.svg", creator=creator)
        pngs = [submit(_write_png, place, folder / "figures", creator) for place in _places(document, figures)]
        write_html(document, path.with_suffix(".html"), pictures=pictures)
        report_stage("tables")
        for each in (tables, *pngs):
            each.result()
    return path


def write_pages(document: Document, folder: Path, *, name: str, jobs: int = 0) -> Path:
    """Write a document in its locale into `folder` as PDF and HTML alone; return the PDF.

    Parameters
    ----------
    document : of any chapters
    folder : to write into
    name : of the PDF
    jobs : processes to use, 0 for as many as there are cores; the files are the same
    """
    with document_processes(jobs or available_cores(), document) as submit:
        drawings = trace_figures(document, submit)
        path = write_pdf(document, folder / name, drawings=drawings)
        pictures = {figure: svg_picture(drawing.result()) for figure, drawing in drawings.items()}
    write_html(document, path.with_suffix(".html"), pictures=pictures)
    return path


Detail = Literal["main", "full"]
WORKSHEETS: tuple[tuple[Phrase, tuple[str, ...]], ...] = (
    (say("Verdict"), ("verdict", "before-and-after", "ties", "tie-links", "checklist", "answers", "lacking")),
    (say("Checks"), ("verdicts",)),
    (say("Comparison"), ("levels", "pga-at-capacity", "rotations", "comparison")),
    (say("Mechanisms"), ("page-parameters", "parameters", "loads", "interfaces", "hinge-forces")),
    (say("Fragility"), ("fragility", "curves", "islands", "measures", "rates")),
    (say("Curves"), ("capacity-curves", "pga-rotation-curves")),
    (say("Histories"), ("suites", "responses", "histories", "amplification")),
    (say("Records"), ("suite-records", "suite-rules", "requirements", "selection", "equivalent-periods", "processing",
                      "spectra")),
    (say("Envelopes"), ("envelopes", "critical-bands", "primary-pulses")),
    (
        say("Sensitivity"),
        ("controls", "controls-in-full", "influences", "sensitivity", "uncertainty", "uncertainty-inputs",
         "uncertainty-means", "uncertainty-influences", "uncertainty-samples"),
    ),
    (
        say("Inputs"),
        ("site", "hazard", "calculated", "actions", "methods", "rules", "assumed", "materials", "sources", "values",
         "values-set", "inputs", "warnings", "revisions"),
    ),
)  # fmt: skip
"""The worksheets, with the tables on each; with the two that all workbooks have, at most 12 of a run."""


def assessment(results: Results, *, detail: Detail | None = None) -> Document:
    """Return the report of one run. detail: of the project if None; "full" adds the annexes."""
    return Document(
        title=front_matter.title(results),
        subject=say("Seismic assessment of masonry by rocking dynamics"),
        author=front_matter.author(results),
        program=f"{results.program.name} {results.program.version}",
        paper="letter" if project_text(results, "report.paper").lower() == "letter" else "A4",
        facts=front_matter.facts(results),
        sections=_numbered(
            [
                *_main_sections(by_own_code(results)),
                *(_annex_sections(results) if is_full(results, detail) else ()),
                *verification.annex_sections(results),
            ]
        ),
        data=tuple(data_tables.tables(results)),
        worksheets=WORKSHEETS,
        parts=_parts((each.name, numbered_title(results, each.name)) for each in results.mechanisms),
        running=front_matter.running_head(results),
        logo=front_matter.logo(results),
        stamp=results.stamp,
        date=front_matter.date(results),
        locale=locale_of(results),
    )


def is_full(results: Results, detail: Detail | None) -> bool:
    """Return whether the report has annexes."""
    return (detail or project_text(results, "report.detail")) == "full"


def envelope_report(results: Results) -> Document:
    """Return the report of `assess envelope`: the critical mechanisms, and the envelope of each."""
    return replace(
        assessment(results),
        subject=say("Overturning envelopes of masonry by rocking dynamics"),
        sections=_numbered([*annex_envelopes.report_sections(results), *annex_inputs.sections(results)]),
        data=tuple(annex_envelopes.data_tables(results)),
    )


def fragility_report(results: FragilityResults) -> Document:
    """Return the report of `assess fragility`: all mechanisms, the pages of each, method, records and inputs.

    Parameters
    ----------
    results : of `assess fragility`
    """
    run = results_without_mechanisms(results)
    inputs = (replace(each, mark="", starts_page=False) for each in annex_inputs.sections(run))
    return replace(
        assessment(run),
        subject=say("Fragility of masonry by rocking dynamics"),
        sections=_numbered([*fragility.sections(results), *inputs]),
        data=tuple(fragility_tables.data_tables(results)),
        parts=_parts((each.name, fragility_tables.numbered_name(results, each)) for each in results.mechanisms),
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


def results_without_mechanisms(results: FragilityResults) -> Results:
    """Return the results of a run with the project and the front matter of `results`, and no mechanism."""
    project = {"title": ResolvedValue(results.title or None, bool(results.title)), **results.project}
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


def report_figure(name: str, results: Results, *, mechanism: str | None = None) -> Figure:
    """Return a figure of the report, in its language and units.

    Parameters
    ----------
    name : of a mechanism "sketch", "place", "view", "capacity", "pga-rotation", "history", "envelope", "moment",
        "contact", "directions", "amplification", "sensitivity", "sweep-01", "uncertainty-01-distribution",
        "uncertainty-01-influences"; of the whole run "key-plan", "spectrum", "suite", "capacities", "curves",
        "comparison", "critical". Results without histories have no figure of one, and so on.
    results : of a run
    mechanism : name of the mechanism; it may be left out for figures of the whole run, and where there is only one

    Returns
    -------
    matplotlib.figure.Figure
        a new figure at each call

    Raises
    ------
    AssessError : for a name that these results have no figure of, and for an unknown mechanism; the known ones are
        listed
    """
    document = assessment(results, detail="full")
    names = figure_names(document, results, mechanism)
    if name not in names:
        of = "of the run" if mechanism is None else f'of mechanism "{mechanism}"'
        more = "; figures of a mechanism need its name" if mechanism is None else ""
        raise AssessError(f'there is no figure "{name}" {of}; known are {", ".join(names)}{more}')
    figure = next(each for each in document.figures if each.name == names[name])
    return figure.draw(document.writer)


def figure_names(document: Document, results: Results, mechanism: str | None) -> dict[str, str]:
    """Return the names of the figures of the run, or of one mechanism, each with its name in the document.

    Raises AssessError for an unknown mechanism.
    """
    stems = {each.name: f"{file_stem(each.name, place)}-" for place, each in enumerate(results.mechanisms, start=1)}
    if mechanism is not None and mechanism not in tuple(stems):
        raise AssessError(f'there is no mechanism "{mechanism}"; known are {", ".join(stems)}')
    if mechanism is None and len(stems) > 1:
        return {each.name: each.name for each in document.figures if not each.name.startswith(tuple(stems.values()))}
    prefixes = tuple(stems.values()) if mechanism is None else (stems[mechanism],)
    own = [each.name for each in document.figures if each.name.startswith(prefixes)]
    found = {name.removeprefix(next(stem for stem in prefixes if name.startswith(stem))): name for name in own}
    if mechanism is None:
        found |= {each.name: each.name for each in document.figures if each.name not in own}
    return found


def _write_tables(document: Document, folder: Path) -> None:
    plain = plain_tables(document)
    write_csv(document, folder / "tables", plain)
    write_xlsx(document, folder / "tables.xlsx", plain)


def _places(document: Document, forms: Sequence[Form]) -> range:
    """Return the places of the figures of which there is to be a PNG file."""
    return range(len(document.figures) if "png" in forms else 0)


def _write_png(document: Document, place: int, folder: Path, creator: str) -> None:
    figure = document.figures[place]
    write_png(figure.draw(document.writer), folder / f"{figure.name}.png", creator)


def _main_sections(results: Results) -> Iterator[Section]:
    """Yield the sections that are signed."""
    yield from verdict.sections(results)
    building = building_of(results)
    yield from key_plan.sections(results, building)
    yield from before_and_after.sections(results)
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
    yield from declaration.signature_sections(results)


def _annex_sections(results: Results) -> Iterator[Section]:
    """Yield what a reviewer needs to redo the calculation."""
    yield from annex_sheets.sections(results)
    yield from sensitivity.annex_sections(results)
    yield from uncertainty.annex_sections(results)
    yield from annex_histories.sections(results)
    yield from annex_envelopes.sections(results)
    yield from suite.sections(results)
    yield from annex_inputs.sections(results)


def _parts(mechanisms: Iterable[tuple[str, Text]]) -> tuple[tuple[str, Text], ...]:
    """Return how the names of the tables of each mechanism begin, with its title. mechanisms: (name, title) of each."""
    return tuple((file_stem(name, place), title) for place, (name, title) in enumerate(mechanisms, start=1))


def _numbered(sections: list[Section]) -> tuple[Section, ...]:
    """Return the sections with the number of each chapter that has no mark of its own, as annexes and mechanisms do."""
    numbers = map(str, count(1))
    bare = (section.level == 0 and not section.mark for section in sections)
    return tuple(replace(each, mark=next(numbers)) if own else each for each, own in zip(sections, bare, strict=True))
