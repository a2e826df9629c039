"""`assess report`: the report again from results.json."""

from __future__ import annotations

import json
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer


class Language(StrEnum):
    """The languages that a report can be written in."""

    ENGLISH = "en"
    ITALIAN = "it"


def report(
    results: Annotated[Path, typer.Argument(metavar="RESULTS.json", help="The results.json of an earlier run.")],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="Where to write; beside RESULTS.json if absent."),
    ] = None,
    png: Annotated[bool, typer.Option("--png", help="Write the figures as PNG files too, 200 dots per inch.")] = False,
    language: Annotated[
        Language | None, typer.Option("--language", help="Language of the report; that of the project if absent.")
    ] = None,
) -> None:
    """Write the report again from results.json, or from the envelopes.json of `assess envelope`, without analysis."""
    from assess.cli.reading import results_at

    read = results_at(results)
    found = read.results
    from assess.cli.progress import progress
    from assess.cli.warning import tell
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import ENVELOPES, RESULTS
    from reports.assessment import envelope_report, project_text
    from reports.writing import Form, write_all, write_document

    spoken = language or _known(project_text(found, "report.language"), source=results)
    folder = output or read.path.parent
    alone = found.critical is not None and not any(mechanism.checks for mechanism in found.mechanisms)
    name, stem = (ENVELOPES, "envelopes") if alone else (RESULTS, "report")
    copied = (name,) if folder.resolve() != read.path.parent.resolve() else ()
    wanted = (f"{stem}.pdf", f"{stem}.html", "tables.xlsx", *copied)
    figures: tuple[Form, ...] = ("svg", "png") if png else ("svg",)
    with (
        output_folder(folder, command="assess report", owner=name, wanted=wanted, tell=tell) as stage,
        progress() as said,
        read.believed(),
    ):
        if alone:
            envelopes = replace(envelope_report(found), language=spoken)
            pdf = write_document(envelopes, stage, name="envelopes.pdf", figures=figures, progress=said.step)
        else:
            pdf = write_all(found, stage, language=spoken, figures=figures, progress=said.step)
        for copy in copied:
            (stage / copy).write_bytes(read.path.read_bytes())
    print(folder / pdf.relative_to(stage))


def _known(language: str, *, source: Path) -> str:
    """The language of results, English where they have none. Raises ResultsError for one without a catalogue."""
    from assess.errors import ResultsError
    from reports.language.catalogue import ENGLISH, languages

    if language in ("", *languages()):
        return language or ENGLISH
    known, said = " or ".join(f'"{each}"' for each in languages()), json.dumps(language)[:40]
    raise ResultsError(
        f"{source}: project.report.language: {said}: no such language; write {known}, or give --language"
    )
