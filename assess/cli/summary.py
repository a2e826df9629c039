"""`assess summary`: one row for each mechanism of one or several runs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import refuse_both


def summary(
    runs: Annotated[
        list[Path], typer.Argument(metavar="RUN…", help="results.json of each run, or its folder, or its project's.")
    ],
    as_json: Annotated[bool, typer.Option("--json", help="Print the rows as JSON.")] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the rows as CSV at full precision.")] = False,
) -> None:
    """Print one row for each mechanism of one or several runs, with the answer that decides it.

    A mechanism with several limit states shows the one that fails, else one that is not answered, else that with the
    largest ratio of demand to capacity. p and lambda are those of the side that rocks first.
    """
    refuse_both(as_json=as_json, as_csv=as_csv)
    from assess.cli.stderr import print_message
    from assess.cli.tables.runs import Row, csv_text, json_text, rows_of, table_text
    from assess.outputs.found_results import open_results

    rows: list[Row] = []
    for run in runs:
        found = open_results(run, tell=print_message)
        with found.blame_changes():
            rows += rows_of(str(run), found.results)
    print((json_text if as_json else csv_text if as_csv else table_text)(rows), end="")
