"""`assess records select`: the suite of records that fits a target."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.arguments import Jobs
from assess.cli.figures import FigurePath, refuse_figure
from assess.cli.processes import processes
from assess.cli.records import Response, Step, Unit
from assess.cli.records_index import Catalogue, Flatfile

OWN = ("places", "jobs", "as_json", "as_csv", "output", "target")
Span = tuple[float, float] | None
Target = Annotated[
    Path | None,
    typer.Option(metavar="FILE", help="A project, for its site's spectrum, or a CSV of period and ordinate."),
]


def _span(words: str) -> typer.models.OptionInfo:
    option: typer.models.OptionInfo = typer.Option(metavar="FROM TO", help=words, show_default=False)
    return option


def select(
    context: typer.Context,
    places: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROJECT|FOLDERS…", help="A project with [records] select; or with --target folders, files."
        ),
    ],
    target: Target = None,
    count: Annotated[int, typer.Option(min=1, max=200, help="How many records.")] = 7,
    periods: Annotated[tuple[float, float], typer.Option(metavar="FROM TO", help="Periods to fit over [s].")] = (
        0.1,
        2.0,
    ),
    scale_limits: Annotated[
        tuple[float, float], typer.Option(metavar="FROM TO", help="Least and largest scale factor.")
    ] = (0.25, 4.0),
    fit: Annotated[str, typer.Option(help="What fits best: the mean of the suite, or each record.")] = "suite",
    components: Annotated[str, typer.Option(help="Components single, or of a recording together.")] = "single",
    scale_to: Annotated[str, typer.Option(help="How each is scaled: spectrum, pga or none.")] = "spectrum",
    several_per_event: Annotated[
        bool, typer.Option("--several-per-event", help="Allow several records of one earthquake.")
    ] = False,
    magnitude: Annotated[Span, _span("Magnitude.")] = None,
    distance: Annotated[Span, _span("Distance [km].")] = None,
    vs30: Annotated[Span, _span("Vs30 [m/s].")] = None,
    pga: Annotated[Span, _span("Peak ground acceleration before scaling [g].")] = None,
    duration: Annotated[Span, _span("Duration D5-95 [s].")] = None,
    event: Annotated[
        list[str] | None, typer.Option(metavar="TEXT", help="Part of an earthquake's name; repeat it.")
    ] = None,
    flatfile: Flatfile = None,
    catalogue: Catalogue = None,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    jobs: Jobs = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print records and ground_motion as in results.json.")
    ] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the records as CSV, at full precision.")] = False,
    output: FigurePath = None,
) -> None:
    """Choose the records that fit a target spectrum best, scale them, and say what codes ask of the suite.

    A project's own [records] select decides for it; folders are indexed first, and only what changed is read.
    """
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")
    refuse_figure(output)
    given = [name for name in context.params if name not in OWN and _typed(context, name)]
    if target is None and (given or len(places) != 1):
        what = f"--{given[0].replace('_', '-')}" if given else "several places"
        raise typer.BadParameter(f"{what} needs --target; a PROJECT has its own [records] select")
    from assess.cli.description import warned
    from assess.cli.suite_table import csv_text, drawn, json_text, table_text
    from assess.project.suites import Wanted, of_project, of_target
    from records.formats.header_overrides import HeaderOverrides

    if target is None:
        with processes(jobs) as executor:
            found = of_project(places[0], executor=executor)
    else:
        spans = {"magnitude": magnitude, "distance": distance, "vs30": vs30, "pga": pga, "duration": duration}
        one_per_event, events = not several_per_event, tuple(event or ())
        wanted = Wanted(count, periods, scale_limits, fit, components, scale_to, one_per_event, spans, events)
        overrides = HeaderOverrides(unit, step, response)
        with processes(jobs) as executor:
            found = of_target(
                target, places, wanted, overrides=overrides, flatfile=flatfile, kept=catalogue, executor=executor
            )
    if output is not None:
        drawn(found, output)
    if as_json or as_csv:  # the table ends with them
        print(warned(found.notices), end="", file=sys.stderr)
    print((json_text if as_json else csv_text if as_csv else table_text)(found), end="")


def _typed(context: typer.Context, name: str) -> bool:
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"
