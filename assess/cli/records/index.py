"""`assess records index`: the catalogue of a folder of records, created or updated."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import Jobs
from assess.cli.records.options import Catalogue, Flatfile, Response, Step, Unit

Folder = Annotated[Path, typer.Argument(metavar="FOLDER", help="Folder of record files, with its subfolders.")]


def index(
    folder: Folder,
    flatfile: Flatfile = None,
    catalogue: Catalogue = None,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    jobs: Jobs = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the counts and the unreadable files as JSON.")] = False,
) -> None:
    """Catalogue the records of a folder: metadata, measures and 5 % spectra.

    Later runs read only new and changed files; an interrupted run continues where it stopped.
    """
    from assess.cli.interruption import on_interruption
    from assess.cli.progress import progress
    from assess.cli.stderr import print_warnings
    from assess.cli.tables.index import json_text, table_text
    from assess.workers import process_pool
    from records.catalogue import NAME, candidates, open_catalogue, store_flatfile
    from records.flatfile import read_flatfile
    from records.flatfile_match import match_flatfile
    from records.formats.header_overrides import HeaderOverrides
    from records.indexing import index as brought_up
    from records.plausibility import candidate_warning
    from records.record_files import files_below

    table = None if flatfile is None else read_flatfile(flatfile)
    next(files_below(folder), None)  # a missing folder is reported before a catalogue is created
    place = catalogue or folder / NAME
    with (
        on_interruption(f"what was read is kept in {place}; the next run goes on from there"),
        progress() as shown,
        open_catalogue(place) as connection,
        process_pool(jobs) as executor,
    ):
        if table is not None:
            store_flatfile(connection, table.recordings)
        found = brought_up(
            folder,
            connection,
            overrides=HeaderOverrides(unit, step, response),
            executor=executor,
            progress=lambda done, total: shown.count("records", done, total),
        )
        listed = candidates(connection)
    described = sum(one.magnitude is not None for one in listed)
    met = None if table is None else match_flatfile(listed, table)
    print_warnings(
        ["" if met is None or met.warning is None else met.warning.text, *(candidate_warning(one) for one in listed)]
    )
    print((json_text if as_json else table_text)(found, place, described=described, merged=met), end="")
