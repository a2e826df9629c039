"""The commands that read the results of earlier runs: `report`, `summary`, `diff`."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import Language, check_share, flag, refuse_two_formats
from assess.cli.stderr import ProgressDisplay, on_interruption, print_message, progress

if TYPE_CHECKING:
    from assess.results import Results
    from reports.assessment import Form


class DetailOption(StrEnum):
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
    png: Annotated[bool, flag("--png", "Also write the figures as PNG files at 200 dpi.")] = False,
    language: Annotated[
        Language | None, typer.Option("--language", help="Language of the report (default: that of the project).")
    ] = None,
    detail: Annotated[
        DetailOption | None,
        typer.Option("--detail", help="The main part, or the full report with its annexes (default: as the project)."),
    ] = None,
) -> None:
    """Rewrite the report from the results of `assess run`, `envelope` or `fragility`, without analysis.

    Replaces the PDF, the HTML page, tables and figures in the folder of the results, or writes them to another.
    """
    from assess.outputs.manifest import FRAGILITY

    if results.name == FRAGILITY:
        _report_fragility(results, output or results.parent, png=png, language=language)
        return
    from assess.outputs.manifest import ENVELOPES, RESULTS
    from assess.results.json import open_results
    from reports.assessment import envelope_report, locale_of, write_all, write_document

    read = open_results(results, tell=print_message)
    found, folder = read.results, output or read.path.parent
    chosen = language or _language_of(found, source=results)
    only_envelopes = found.critical is not None and not any(mechanism.checks for mechanism in found.mechanisms)
    owner, stem = (ENVELOPES, "envelopes") if only_envelopes else (RESULTS, "report")
    with _output(folder, source=read.path, owner=owner, stem=stem) as (stage, shown), read.blame_changes():
        if only_envelopes:
            document = replace(envelope_report(found), locale=locale_of(found, chosen))
            pdf = write_document(document, stage, name="envelopes.pdf", figures=_forms(png), progress=shown.step)
        else:
            pdf = write_all(
                found,
                stage,
                language=chosen,
                detail=detail.value if detail else None,
                figures=_forms(png),
                progress=shown.step,
            )
    print(folder / pdf.relative_to(stage))


def summary(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN…", help="results.json of each run, or its folder, or its project's.")
    ],
    as_json: Annotated[bool, flag("--json", "Print the rows as JSON.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the rows as CSV at full precision.")] = False,
) -> None:
    """Print one row for each mechanism of one or several runs, with the answer that decides it.

    A mechanism with several limit states shows the one that fails, else one that is not answered, else that with the
    largest ratio of demand to capacity. p and lambda are those of the side that rocks first.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.cli.tables.results import (
        MechanismRow,
        mechanism_rows,
        mechanisms_csv,
        mechanisms_json,
        mechanisms_table,
    )
    from assess.results.json import open_results

    rows: list[MechanismRow] = []
    for run in runs:
        found = open_results(run, tell=print_message)
        with found.blame_changes():
            rows += mechanism_rows(str(run), found.results)
    print((mechanisms_json if as_json else mechanisms_csv if as_csv else mechanisms_table)(rows), end="")


def diff(
    before: Annotated[Path, typer.Argument(metavar="A", help="results.json of the earlier run, or its folder.")],
    after: Annotated[Path, typer.Argument(metavar="B", help="results.json of the later run, or its folder.")],
    tolerance: Annotated[
        float,
        typer.Option(
            metavar="SHARE",
            help="Relative difference, 0 to 1, up to which numbers count as equal.",
            callback=check_share,
        ),
    ] = 1e-6,
    exit_code: Annotated[bool, flag("--exit-code", "Exit with code 1 if anything differs.")] = False,
    as_json: Annotated[bool, flag("--json", "Print the changes as JSON.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the changes as one CSV table at full precision.")] = False,
) -> None:
    """List the changes between two runs, such as before and after a retrofit, verdicts first.

    Compares results of `assess run` or `assess envelope`, or the folders of projects that have been run.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.cli.tables.results import changes_csv, changes_json, changes_text
    from assess.results.diff import differences
    from assess.results.json import open_results

    first, second = (open_results(each, tell=print_message) for each in (before, after))
    with first.blame_changes(), second.blame_changes():
        found = differences(first.results, second.results, tolerance=tolerance)
        text = (changes_json if as_json else changes_csv if as_csv else changes_text)(found)
    print(text, end="")
    raise typer.Exit(1 if exit_code and found else 0)


def _report_fragility(path: Path, folder: Path, *, png: bool, language: Language | None) -> None:
    """Rewrite the report of `assess fragility` from its results at `path`."""
    from assess.outputs.manifest import FRAGILITY
    from assess.results.json import open_fragility
    from reports.assessment import fragility_report, locale_of, results_without_mechanisms, write_document

    found = open_fragility(path, tell=print_message)
    plain = results_without_mechanisms(found)
    chosen = language or _language_of(plain, source=path)
    with _output(folder, source=path, owner=FRAGILITY, stem="fragility") as (stage, shown):
        document = replace(fragility_report(found), locale=locale_of(plain, chosen))
        pdf = write_document(document, stage, name="fragility.pdf", figures=_forms(png), progress=shown.step)
    print(folder / pdf.relative_to(stage))


@contextmanager
def _output(folder: Path, *, source: Path, owner: str, stem: str) -> Iterator[tuple[Path, ProgressDisplay]]:
    """Give a temporary folder for a report, and its progress; results from elsewhere are copied beside it."""
    from assess.outputs.writing import output_folder

    copied = (owner,) if folder.resolve() != source.parent.resolve() else ()
    expected = (f"{stem}.pdf", f"{stem}.html", "tables.xlsx", *copied)
    with (
        output_folder(folder, command="assess report", owner=owner, expected=expected, tell=print_message) as stage,
        on_interruption(f"nothing was written into {folder}"),
        progress() as shown,
    ):
        yield stage, shown
        for copy in copied:
            (stage / copy).write_bytes(source.read_bytes())


def _forms(png: bool) -> tuple[Form, ...]:
    return ("svg", "png") if png else ("svg",)


def _language_of(results: Results, *, source: Path) -> str:
    """Return the language of results, English by default; raise ResultsError for one without a catalogue."""
    from assess.errors import ResultsError
    from reports.language.locale import ENGLISH, languages
    from reports.project_values import project_text

    language = project_text(results, "report.language")
    if language in ("", *languages()):
        return language or ENGLISH
    known, named = " or ".join(f'"{each}"' for each in languages()), json.dumps(language)[:40]
    raise ResultsError(
        f"{source}: project.report.language: {named}: no such language; write {known}, or give --language"
    )
