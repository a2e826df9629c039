"""`assess diff`: what changed between two runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import check_share, refuse_both


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
    exit_code: Annotated[bool, typer.Option("--exit-code", help="Exit with code 1 if anything differs.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the changes as JSON.")] = False,
    as_csv: Annotated[
        bool, typer.Option("--csv", help="Print the changes as one CSV table at full precision.")
    ] = False,
) -> None:
    """List the changes between two runs, such as before and after a retrofit, verdicts first.

    Compares results of `assess run` or `assess envelope`, or the folders of projects that have been run.
    """
    refuse_both(as_json=as_json, as_csv=as_csv)
    from assess.cli.stderr import print_message
    from assess.cli.tables.diff import changes_text, csv_text, json_text
    from assess.outputs.found_results import open_results
    from assess.results.diff import changes

    first, second = (open_results(each, tell=print_message) for each in (before, after))
    with first.blame_changes(), second.blame_changes():
        found = changes(first.results, second.results, tolerance=tolerance)
        text = (json_text if as_json else csv_text if as_csv else changes_text)(found)
    print(text, end="")
    raise typer.Exit(1 if exit_code and found else 0)
