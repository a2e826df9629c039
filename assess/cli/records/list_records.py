"""`assess records list`: the records of files with their measures."""

from __future__ import annotations

from typing import Annotated

import typer

from assess.cli.options import refuse_both
from assess.cli.records.options import Files, Response, Step, Unit


def list_records(
    files: Files,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the records as in results.json, with their measures.")
    ] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV at full precision.")] = False,
) -> None:
    """Print time step, samples, peaks, intensities and durations of each record."""
    refuse_both(as_json=as_json, as_csv=as_csv)
    from assess.cli.stderr import print_warnings
    from assess.cli.tables.records import csv_text, json_text, table_text
    from records.plausibility import record_warning, warnings_among
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    print_warnings([*map(record_warning, found), *map(str, warnings_among(found))])
    text = json_text if as_json else csv_text if as_csv else table_text
    print(text(found), end="")
