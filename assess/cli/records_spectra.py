"""`assess records spectra`: response spectra of records."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.arguments import Jobs
from assess.cli.checked import damping_ratio
from assess.cli.figures import FigurePath, refuse_figure
from assess.cli.processes import processes
from assess.cli.records import Response, Step, Unit
from assess.cli.records_index import Catalogue

Places = Annotated[list[Path], typer.Argument(metavar="FILES…|FOLDER", help="Record files, or a folder of them.")]


def spectra(
    places: Places,
    damping: Annotated[
        float, typer.Option(help="Damping ratio; a folder has 5 % spectra.", callback=damping_ratio)
    ] = 0.05,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    catalogue: Catalogue = None,
    jobs: Jobs = None,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print every period, a column for each record.")] = False,
    output: FigurePath = None,
) -> None:
    """Print pseudo-acceleration spectra of records; those of a folder come from its catalogue."""
    refuse_figure(output)
    from assess.cli.spectra_table import csv_text, drawn, found_in, table_text
    from records.formats.header_overrides import HeaderOverrides

    with processes(jobs) as executor:
        overrides = HeaderOverrides(unit, step, response)
        found = found_in(places, damping=damping, overrides=overrides, kept=catalogue, executor=executor)
    if output is not None:
        drawn(found, output)
    print((csv_text if as_csv else table_text)(found), end="")
