"""`assess diff`: what changed between two runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.checked import share


def diff(
    before: Annotated[Path, typer.Argument(metavar="A", help="results.json of the earlier run, or its folder.")],
    after: Annotated[Path, typer.Argument(metavar="B", help="results.json of the later run, or its folder.")],
    tolerance: Annotated[
        float,
        typer.Option(
            metavar="SHARE", help="Numbers that differ by no more of their size, 0 to 1, are one.", callback=share
        ),
    ] = 1e-6,
    exit_code: Annotated[bool, typer.Option("--exit-code", help="End with 1 where anything differs.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the changes as JSON.")] = False,
    as_csv: Annotated[
        bool, typer.Option("--csv", help="Print the changes as one CSV table, at full precision.")
    ] = False,
) -> None:
    """List what changed between two runs, as before and after a retrofit; verdicts first.

    Results of `assess run` or `assess envelope`, or the folders of projects that have been run.
    """
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")
    from assess.cli.diff_table import changes_text, csv_text, json_text
    from assess.cli.reading import results_at
    from assess.results.diff import changes

    first, second = results_at(before), results_at(after)
    with first.believed(), second.believed():
        found = changes(first.results, second.results, tolerance=tolerance)
        text = (json_text if as_json else csv_text if as_csv else changes_text)(found)
    print(text, end="")
    raise typer.Exit(1 if exit_code and found else 0)
