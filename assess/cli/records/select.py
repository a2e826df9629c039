"""`assess records select`: the suite of records that best fits a target spectrum."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.completions import of_words
from assess.cli.options import FigurePath, Jobs, refuse_both, refuse_figure
from assess.cli.records.options import TARGET, Catalogue, Flatfile, Response, Step, Unit

if TYPE_CHECKING:
    from assess.project.suites import Suite

OWN = ("places", "jobs", "as_json", "as_csv", "output", "target", "lock")
OPTIONS = {"code": "for"}
"""Options that are not named after their argument."""
Span = tuple[float, float] | None


def _span(words: str) -> typer.models.OptionInfo:
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
            autocompletion=of_words("suite", "each"),
        ),
    ] = "suite",
    components: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Use components separately ("single"), or those of a recording "together".',
            autocompletion=of_words("single", "together"),
        ),
    ] = "single",
    code: Annotated[
        str | None,
        typer.Option(
            "--for",
            metavar="CODE",
            autocompletion=of_words("asce7-16", "asce43-05", "ec8", "ntc2018", "nzs1170.5"),
            help="Meet the rules of asce7-16, asce43-05, ec8, ntc2018 or nzs1170.5; --periods are 0.2 to 1.2 T.",
        ),
    ] = None,
    scale_to: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Scale each record to "spectrum", "pga" or "none".',
            autocompletion=of_words("spectrum", "pga", "none"),
        ),
    ] = "spectrum",
    several_per_event: Annotated[
        bool, typer.Option("--several-per-event", help="Allow several records of one earthquake.")
    ] = False,
    magnitude: Annotated[Span, _span("Keep only records within these magnitudes.")] = None,
    distance: Annotated[Span, _span("The same of the distance [km].")] = None,
    vs30: Annotated[Span, _span("The same of Vs30 [m/s].")] = None,
    pga: Annotated[Span, _span("The same of the peak ground acceleration before scaling [g].")] = None,
    duration: Annotated[Span, _span("The same of the duration D5-95 [s].")] = None,
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
    refuse_both(as_json=as_json, as_csv=as_csv)
    refuse_figure(output)
    _refuse_without_target(context, target, places)
    from assess.cli.progress import progress
    from assess.cli.stderr import print_note
    from assess.project.suites import Wanted, lock_project, lock_target, of_project, of_target
    from assess.workers import process_pool
    from records.formats.header_overrides import HeaderOverrides

    written = None
    if target is None:
        with progress(), process_pool(jobs) as executor:
            if lock:
                found, written = lock_project(places[0], executor=executor)
            else:
                found = of_project(places[0], executor=executor)
    else:
        spans = {"magnitude": magnitude, "distance": distance, "vs30": vs30, "pga": pga, "duration": duration}
        one_per_event, events = not several_per_event, tuple(event or ())
        wanted = Wanted(count, periods, scale_limits, fit, components, scale_to, one_per_event, spans, events, code)
        overrides = HeaderOverrides(unit, step, response)
        with progress(), process_pool(jobs) as executor:
            selected = of_target(
                target, places, wanted, overrides=overrides, flatfile=flatfile, kept=catalogue, executor=executor
            )
        found, written = selected.suite, lock_target(target, selected) if lock else None
    _print_suite(found, output, as_json=as_json, as_csv=as_csv)
    if written is not None:
        print_note(f'{written} written; [records] lock = "{written.name}" uses it')


def _refuse_without_target(context: typer.Context, target: Path | None, places: Sequence[Path]) -> None:
    """Raise BadParameter for options or several places without a target; a project has its own criteria."""
    given = [OPTIONS.get(name, name) for name in context.params if name not in OWN and _is_given(context, name)]
    if target is None and (given or len(places) != 1):
        what = f"--{given[0].replace('_', '-')}" if given else "several places"
        raise typer.BadParameter(f"{what} needs --target; a PROJECT has its own [records] select")


def _print_suite(found: Suite, output: Path | None, *, as_json: bool, as_csv: bool) -> None:
    """Draw the suite where a figure is requested, and print it."""
    from assess.cli.stderr import print_messages
    from assess.cli.tables.suite import csv_text, draw, json_text, table_text

    if output is not None:
        draw(found, output)
    if as_json or as_csv:  # the table includes them
        print_messages(found.messages)
    print((json_text if as_json else csv_text if as_csv else table_text)(found), end="")


def _is_given(context: typer.Context, name: str) -> bool:
    """Return whether an option is given on the command line."""
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"
