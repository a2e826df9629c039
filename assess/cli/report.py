"""`assess report`: the report rewritten from results.json, envelopes.json or fragility.json."""

from __future__ import annotations

import json
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer


class Language(StrEnum):
    """Languages in which a report can be written."""

    ENGLISH = "en"
    ITALIAN = "it"


class Detail(StrEnum):
    """How much of a report is written."""

    MAIN = "main"
    FULL = "full"


def report(
    results: Annotated[
        Path,
        typer.Argument(
            metavar="RESULTS.json",
            help="results.json of an earlier run, or its folder; or envelopes.json or fragility.json.",
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="Output folder (default: that of RESULTS.json)."),
    ] = None,
    png: Annotated[bool, typer.Option("--png", help="Also write the figures as PNG files at 200 dpi.")] = False,
    language: Annotated[
        Language | None, typer.Option("--language", help="Language of the report (default: that of the project).")
    ] = None,
    detail: Annotated[
        Detail | None,
        typer.Option("--detail", help="The main part, or the full report with its annexes (default: as the project)."),
    ] = None,
) -> None:
    """Rewrite the report from the results of `assess run`, `envelope` or `fragility`, without analysis.

    Replaces the PDF, the HTML page, tables and figures in the folder of the results, or writes them to another.
    """
    from assess.cli.stderr import print_message
    from assess.outputs.manifest import FRAGILITY

    if results.name == FRAGILITY:
        rewrite_fragility(results, output or results.parent, png=png, language=language)
        return
    from assess.outputs.found_results import open_results

    read = open_results(results, tell=print_message)
    found = read.results
    from assess.cli.interruption import on_interruption
    from assess.cli.progress import progress
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import ENVELOPES, RESULTS
    from reports.assessment import envelope_report, locale_of
    from reports.project_text import project_text
    from reports.writing import Form, write_all, write_document

    chosen = language or _language_of(project_text(found, "report.language"), source=results)
    folder = output or read.path.parent
    alone = found.critical is not None and not any(mechanism.checks for mechanism in found.mechanisms)
    name, stem = (ENVELOPES, "envelopes") if alone else (RESULTS, "report")
    copied = (name,) if folder.resolve() != read.path.parent.resolve() else ()
    wanted = (f"{stem}.pdf", f"{stem}.html", "tables.xlsx", *copied)
    figures: tuple[Form, ...] = ("svg", "png") if png else ("svg",)
    with (
        output_folder(folder, command="assess report", owner=name, wanted=wanted, tell=print_message) as stage,
        on_interruption(f"nothing was written into {folder}"),
        progress() as shown,
        read.blame_changes(),
    ):
        if alone:
            envelopes = replace(envelope_report(found), locale=locale_of(found, chosen))
            pdf = write_document(envelopes, stage, name="envelopes.pdf", figures=figures, progress=shown.step)
        else:
            pdf = write_all(
                found,
                stage,
                language=chosen,
                detail=detail.value if detail else None,
                figures=figures,
                progress=shown.step,
            )
        for copy in copied:
            (stage / copy).write_bytes(read.path.read_bytes())
    print(folder / pdf.relative_to(stage))


def rewrite_fragility(path: Path, folder: Path, *, png: bool, language: Language | None) -> None:
    """Rewrite the report of `assess fragility` from its results at `path`."""
    from assess.cli.interruption import on_interruption
    from assess.cli.progress import progress
    from assess.cli.stderr import print_message
    from assess.outputs.folder import output_folder
    from assess.outputs.found_results import open_fragility
    from assess.outputs.manifest import FRAGILITY
    from reports.assessment import fragility_report, locale_of, without_answers
    from reports.project_text import project_text
    from reports.writing import Form, write_document

    found = open_fragility(path, tell=print_message)
    plain = without_answers(found)
    chosen = language or _language_of(project_text(plain, "report.language"), source=path)
    copied = (FRAGILITY,) if folder.resolve() != path.parent.resolve() else ()
    wanted = ("fragility.pdf", "fragility.html", "tables.xlsx", *copied)
    figures: tuple[Form, ...] = ("svg", "png") if png else ("svg",)
    with (
        output_folder(folder, command="assess report", owner=FRAGILITY, wanted=wanted, tell=print_message) as stage,
        on_interruption(f"nothing was written into {folder}"),
        progress() as shown,
    ):
        document = replace(fragility_report(found), locale=locale_of(plain, chosen))
        pdf = write_document(document, stage, name="fragility.pdf", figures=figures, progress=shown.step)
        for copy in copied:
            (stage / copy).write_bytes(path.read_bytes())
    print(folder / pdf.relative_to(stage))


def _language_of(language: str, *, source: Path) -> str:
    """Return the language of results, English by default; raise ResultsError for one without a catalogue."""
    from assess.errors import ResultsError
    from reports.language.catalogue import ENGLISH, languages

    if language in ("", *languages()):
        return language or ENGLISH
    known, said = " or ".join(f'"{each}"' for each in languages()), json.dumps(language)[:40]
    raise ResultsError(
        f"{source}: project.report.language: {said}: no such language; write {known}, or give --language"
    )
