"""`assess records select` and `scale`: suites of records for a target spectrum."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import (
    TARGET,
    Catalogue,
    FigurePath,
    Files,
    Flatfile,
    Jobs,
    Response,
    Step,
    Target,
    Unit,
    check_figure_path,
    complete_words,
    refuse_two_formats,
)

if TYPE_CHECKING:
    from assess.project.suites import ScaledSuite


NOT_CRITERIA = ("places", "jobs", "as_json", "as_csv", "output", "target", "lock")

OPTION_NAMES = {"code": "for"}
"""Options that are not named after their argument."""
Span = tuple[float, float] | None


def _span_option(words: str) -> typer.models.OptionInfo:
    option: typer.models.OptionInfo = typer.Option(metavar="FROM TO", help=words, show_default=False)
    return option


def select(
    context: typer.Context,
    places: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROJECT|FOLDERS…", help="A project with [records] select; or, with --target, folders and files."
        ),
    ],
    target: Annotated[Path | None, TARGET] = None,
    count: Annotated[int, typer.Option(metavar="N", min=1, max=200, help="Number of records.")] = 7,
    periods: Annotated[tuple[float, float], typer.Option(metavar="FROM TO", help="Periods over which to fit [s].")] = (
        0.1,
        2.0,
    ),
    scale_limits: Annotated[
        tuple[float, float], typer.Option(metavar="FROM TO", help="Smallest and largest scale factor.")
    ] = (0.25, 4.0),
    fit: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Fit the mean of the "suite", or "each" record.',
            autocompletion=complete_words("suite", "each"),
        ),
    ] = "suite",
    components: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Use components separately ("single"), or those of a recording "together".',
            autocompletion=complete_words("single", "together"),
        ),
    ] = "single",
    code: Annotated[
        str | None,
        typer.Option(
            "--for",
            metavar="CODE",
            autocompletion=complete_words("asce7-16", "asce43-05", "ec8", "ntc2018", "nzs1170.5"),
            help="Meet the rules of asce7-16, asce43-05, ec8, ntc2018 or nzs1170.5; --periods are 0.2 to 1.2 T.",
        ),
    ] = None,
    scale_to: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Scale each record to "spectrum", "pga" or "none".',
            autocompletion=complete_words("spectrum", "pga", "none"),
        ),
    ] = "spectrum",
    several_per_event: Annotated[
        bool, typer.Option("--several-per-event", help="Allow several records of one earthquake.")
    ] = False,
    magnitude: Annotated[Span, _span_option("Keep only records within these magnitudes.")] = None,
    distance: Annotated[Span, _span_option("The same of the distance [km].")] = None,
    vs30: Annotated[Span, _span_option("The same of Vs30 [m/s].")] = None,
    pga: Annotated[Span, _span_option("The same of the peak ground acceleration before scaling [g].")] = None,
    duration: Annotated[Span, _span_option("The same of the duration D5-95 [s].")] = None,
    event: Annotated[
        list[str] | None,
        typer.Option(metavar="TEXT", help="Keep only earthquakes with this in their name; may be repeated."),
    ] = None,
    flatfile: Flatfile = None,
    catalogue: Catalogue = None,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    lock: Annotated[
        bool,
        typer.Option(
            "--lock", help="Also write records.lock.toml beside the project (or target): files, factors, hashes."
        ),
    ] = False,
    jobs: Jobs = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print records and ground_motion as in results.json.")
    ] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the records as CSV at full precision.")] = False,
    output: FigurePath = None,
) -> None:
    """Select the records that best fit a target spectrum, scale them, and check the suite against code rules.

    A project uses its own [records] select. Folders are indexed first; only new and changed files are read. A lock,
    used by [records] lock = "records.lock.toml", keeps the suite as it is whatever becomes of the mechanisms.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    check_figure_path(output)
    _refuse_without_target(context, target, places)
    from assess.cli.stderr import print_note, progress
    from assess.project.suites import SuiteOptions, lock_project, lock_target, select_for_target, suite_of_project
    from assess.workers import process_pool
    from records.formats.header import HeaderOverrides

    written = None
    if target is None:
        with progress(), process_pool(jobs) as executor:
            if lock:
                found, written = lock_project(places[0], executor=executor)
            else:
                found = suite_of_project(places[0], executor=executor)
    else:
        spans = {"magnitude": magnitude, "distance": distance, "vs30": vs30, "pga": pga, "duration": duration}
        one_per_event, events = not several_per_event, tuple(event or ())
        wanted = SuiteOptions(
            count, periods, scale_limits, fit, components, scale_to, one_per_event, spans, events, code
        )
        overrides = HeaderOverrides(unit, step, response)
        with progress(), process_pool(jobs) as executor:
            selected = select_for_target(
                target, places, wanted, overrides=overrides, flatfile=flatfile, kept=catalogue, executor=executor
            )
        found, written = selected.suite, lock_target(target, selected) if lock else None
    _print_suite(found, output, as_json=as_json, as_csv=as_csv)
    if written is not None:
        print_note(f'{written} written; [records] lock = "{written.name}" uses it')


def _refuse_without_target(context: typer.Context, target: Path | None, places: Sequence[Path]) -> None:
    """Raise BadParameter for options or several places without a target; a project has its own criteria."""
    given = [
        OPTION_NAMES.get(name, name) for name in context.params if name not in NOT_CRITERIA and _is_given(context, name)
    ]
    if target is None and (given or len(places) != 1):
        what = f"--{given[0].replace('_', '-')}" if given else "several places"
        raise typer.BadParameter(f"{what} needs --target; a PROJECT has its own [records] select")


def _print_suite(found: ScaledSuite, output: Path | None, *, as_json: bool, as_csv: bool) -> None:
    """Draw the suite where a figure is requested, and print it."""
    from assess.cli.stderr import print_messages
    from assess.cli.tables.suites import draw_suite, suite_csv, suite_json, suite_table

    if output is not None:
        draw_suite(found, output)
    if as_json or as_csv:  # the table includes them
        print_messages(found.messages)
    print((suite_json if as_json else suite_csv if as_csv else suite_table)(found), end="")


def _is_given(context: typer.Context, name: str) -> bool:
    """Return whether an option is given on the command line."""
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"


def scale(
    files: Files,
    target: Target,
    to: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Match the "spectrum" (least squares), its "pga", or "none".',
            autocompletion=complete_words("spectrum", "pga", "none"),
        ),
    ] = "spectrum",
    at: Annotated[float | None, typer.Option(metavar="PERIOD", help="Match the ordinate at this period [s].")] = None,
    periods: Annotated[
        tuple[float, float], typer.Option(metavar="FROM TO", help="Periods of the least squares [s].")
    ] = (
        0.1,
        2.0,
    ),
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print records and ground_motion as in results.json.")
    ] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the records as CSV at full precision.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="Folder in which to write each scaled record as CSV."),
    ] = None,
) -> None:
    """Scale records to a design spectrum, its peak ground acceleration, or its ordinate at one period."""
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    if at is not None and to != "spectrum":
        raise typer.BadParameter("--at and --to exclude each other")
    from assess.cli.stderr import print_message
    from assess.cli.tables.suites import suite_csv, suite_json, suite_table
    from assess.outputs.manifest import RECORDS
    from assess.outputs.writing import output_folder
    from assess.project.suites import write_scaled_files
    from assess.results.provenance import stamp_of_files
    from records.formats.header import HeaderOverrides
    from records.processing import csv_text as record_text
    from records.record import scale

    overrides = HeaderOverrides(unit, step, response)
    place = (
        nullcontext()
        if output is None
        else output_folder(output, command="assess records scale", owner=RECORDS, tell=print_message)
    )
    with place as stage:
        motions, suite = write_scaled_files(target, files, to=to, at=at, periods=periods, overrides=overrides)
        stamp = stamp_of_files("records scale", files, suite_json(suite))
        for number, motion in enumerate(motions, start=1):
            if stage is not None:
                text = record_text(scale(motion.record, motion.scaling.factor), stamp=stamp)
                name = "".join(c if c.isascii() and (c.isalnum() or c in "-._") else "-" for c in motion.record.id)
                (stage / f"{number:02d}-{name[:60]}.csv").write_text(text, encoding="utf-8")
    print((suite_json if as_json else suite_csv if as_csv else suite_table)(suite), end="")
