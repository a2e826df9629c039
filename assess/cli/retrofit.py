"""The command `retrofit`: the least works with which a project reaches a target."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import JobsOption, ProjectPath, flag, folder_option, refuse_two_formats, word_option
from assess.cli.stderr import NOTHING_WRITTEN, on_interruption, print_message, print_messages, progress

TARGETS = ("index", "ratio", "probability")


def retrofit(
    project: ProjectPath,
    target: Annotated[str, word_option("What is to be reached: index, ratio or probability.", *TARGETS)],
    reach: Annotated[float, typer.Option("--reach", metavar="NUMBER", help="Its value.")],
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary",
            metavar="KEY=RANGE",
            help="What works change: a key or a declared work, such as mechanisms.NAME.ties.count=2..6; repeat it.",
        ),
    ],
    limit_state: Annotated[
        str | None, typer.Option("--limit-state", metavar="NAME", help="In place of that of [verdict].")
    ] = None,
    price: Annotated[
        list[str] | None,
        typer.Option(
            "--price",
            metavar="KEY=PRICE",
            help="For least cost in place of steel: KEY is steel (a kg), tie (each) or a varied key (a unit); 4, or "
            "'4 EUR/kg'; before those of [analysis.retrofit] prices; repeat. none: least steel, without them.",
        ),
    ] = None,
    spacing: Annotated[
        str, typer.Option("--spacing", metavar="LENGTH", help="Largest distance between anchors.")
    ] = "3 m",
    search_records: Annotated[
        int | None,
        typer.Option(
            "--search-records",
            metavar="N",
            min=1,
            help="About how many records are searched on; the others prove (default: every second event).",
        ),
    ] = None,
    output: Annotated[
        Path | None, folder_option("Folder to write project.toml, retrofit.pdf, .html, tables and figures to.")
    ] = None,
    as_json: Annotated[bool, flag("--json", "Print every layout and what was found as JSON.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print every layout as CSV.")] = False,
    jobs: JobsOption = None,
) -> None:
    """Find the least works with which a project reaches a target, proved on records that the search did not see.

    Index is that by which the basis decides, by a static method; ratio the largest rotation of a history over the one
    that overturns; probability the share of records that overturn, at the upper end of its interval of 84 %. Works are
    ranges of keys of the file, and ties (count, area, height, force), ring_beam (mass, area), roof (factor) and base
    (width) of a mechanism. A range is 100..800 mm^2, 100..800 mm^2 by 50, or a list. The project with the least works
    is written into -o. The exit code is 1 where none is proved.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.project.project_file import load

    loaded = load(project)
    from assess.cli.tables.retrofit import retrofit_csv, retrofit_json, retrofit_text
    from assess.verbs import retrofit as find
    from assess.verbs import write_retrofit

    with on_interruption(NOTHING_WRITTEN), progress() as shown:
        found = find(
            loaded,
            target=target,
            reach=reach,
            vary=_pairs(vary, "--vary"),
            limit_state=limit_state,
            price=None if price == ["none"] else _pairs(price or (), "--price"),
            spacing=spacing,
            search_records=search_records,
            jobs=jobs or 0,
            progress=shown.count,
        )
        if output is not None:
            write_retrofit(found, output, jobs=jobs or 0, tell=print_message, progress=shown.count)
    if as_json or as_csv:
        print_messages(found.results.warnings)
    text = retrofit_json if as_json else retrofit_csv if as_csv else retrofit_text
    print(text(found.results), end="")
    if output is not None and not (as_json or as_csv):
        print(output / ("project.toml" if found.results.best is not None else "retrofit.pdf"))
    raise typer.Exit(0 if found.results.best is not None else 1)


def _pairs(texts: Sequence[str], option: str) -> dict[str, str]:
    """Return texts such as KEY=VALUE as pairs; raise BadParameter for another text, and for a key that stands twice."""
    found: dict[str, str] = {}
    for text in texts:
        key, equals, value = (part.strip() for part in text.partition("="))
        if not (key and equals and value):
            raise typer.BadParameter(f'{option} "{text}": write KEY=VALUE')
        if key in found:
            raise typer.BadParameter(f'{option} "{key}" twice; give each key once')
        found[key] = value
    return found
