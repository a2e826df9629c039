"""`assess records spectra`: response spectra of records."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import FigurePath, Jobs, check_damping, refuse_figure
from assess.cli.records.options import Catalogue, Response, Step, Unit

Places = Annotated[list[Path], typer.Argument(metavar="FILES…|FOLDER", help="Record files, or a folder of them.")]


def spectra(
    places: Places,
    damping: Annotated[
        float,
        typer.Option(metavar="NUMBER", help="Damping ratio; the spectra of a folder have 5 %.", callback=check_damping),
    ] = 0.05,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    catalogue: Catalogue = None,
    jobs: Jobs = None,
    as_csv: Annotated[
        bool, typer.Option("--csv", help="Print every period as CSV, with a column for each record.")
    ] = False,
    output: FigurePath = None,
) -> None:
    """Print the pseudo-acceleration spectra of records; those of a folder are read from its catalogue."""
    refuse_figure(output)
    from assess.cli.progress import progress
    from assess.cli.tables.response_spectra import csv_text, draw, spectra_in, table_text
    from assess.workers import process_pool
    from records.formats.header_overrides import HeaderOverrides

    with progress(), process_pool(jobs) as executor:
        overrides = HeaderOverrides(unit, step, response)
        found = spectra_in(places, damping=damping, overrides=overrides, kept=catalogue, executor=executor)
    if output is not None:
        draw(found, output)
    print((csv_text if as_csv else table_text)(found), end="")
