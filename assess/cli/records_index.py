"""`assess records index`: the catalogue of a folder, brought up to date."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.records import Response, Step, Unit

Folder = Annotated[Path, typer.Argument(metavar="FOLDER", help="Folder of record files, with all below it.")]
Flatfile = Annotated[
    Path | None, typer.Option(metavar="CSV", help="PEER flatfile: magnitude, distance, Vs30, NGA number.")
]
Catalogue = Annotated[
    Path | None, typer.Option(metavar="FILE", help="Where the catalogue is, if not in the folder itself.")
]


def index(
    folder: Folder,
    flatfile: Flatfile = None,
    catalogue: Catalogue = None,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    jobs: Annotated[
        int | None, typer.Option("--jobs", metavar="N", min=1, help="Processor cores to use; all if absent.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print counts and unreadable files as JSON.")] = False,
) -> None:
    """Read the records of a folder once into a catalogue beside them: metadata, measures, 5 % spectra.

    Later runs read only files that are new or have changed; one that was stopped goes on where it ended.
    """
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    from assess.cli.index_table import json_text, table_text
    from assess.cli.progress import progress
    from records.catalogue import NAME, candidates, opened, take
    from records.flatfile import read_flatfile
    from records.formats.stated import Stated
    from records.indexing import files_below
    from records.indexing import index as brought_up

    recordings = None if flatfile is None else read_flatfile(flatfile)
    next(files_below(folder), None)  # a folder that is none is told before a catalogue is made
    place = catalogue or folder / NAME
    with (
        progress() as said,
        opened(place) as connection,
        ProcessPoolExecutor(jobs or os.cpu_count(), mp_context=get_context("spawn")) as executor,
    ):
        if recordings is not None:
            take(connection, recordings)
        found = brought_up(
            folder,
            connection,
            stated=Stated(unit, step, response),
            executor=executor if jobs != 1 else None,
            progress=lambda done, total: said.count("records", done, total),
        )
        described = sum(one.magnitude is not None for one in candidates(connection))
    print((json_text if as_json else table_text)(found, place, described=described), end="")
