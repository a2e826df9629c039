"""`assess records scale`: records scaled to a target spectrum."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.completions import of_words
from assess.cli.options import refuse_both
from assess.cli.records.options import Files, Response, Step, Target, Unit


def scale(
    files: Files,
    target: Target,
    to: Annotated[
        str,
        typer.Option(
            metavar="WORD",
            help='Match the "spectrum" (least squares), its "pga", or "none".',
            autocompletion=of_words("spectrum", "pga", "none"),
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
    refuse_both(as_json=as_json, as_csv=as_csv)
    if at is not None and to != "spectrum":
        raise typer.BadParameter("--at and --to exclude each other")
    from assess.cli.stderr import print_message
    from assess.cli.tables.suite import csv_text, json_text, table_text
    from assess.outputs.folder import output_folder
    from assess.outputs.manifest import RECORDS
    from assess.project.suites import write_scaled_files
    from assess.results.stamp import stamp_of_files
    from records.formats.header_overrides import HeaderOverrides
    from records.record import scale
    from records.writing import csv_text as record_text

    overrides = HeaderOverrides(unit, step, response)
    place = (
        nullcontext()
        if output is None
        else output_folder(output, command="assess records scale", owner=RECORDS, tell=print_message)
    )
    with place as stage:
        motions, suite = write_scaled_files(target, files, to=to, at=at, periods=periods, overrides=overrides)
        stamp = stamp_of_files("records scale", files, json_text(suite))
        for number, motion in enumerate(motions, start=1):
            if stage is not None:
                text = record_text(scale(motion.record, motion.scaling.factor), stamp=stamp)
                name = "".join(c if c.isascii() and (c.isalnum() or c in "-._") else "-" for c in motion.record.id)
                (stage / f"{number:02d}-{name[:60]}.csv").write_text(text, encoding="utf-8")
    print((json_text if as_json else csv_text if as_csv else table_text)(suite), end="")
