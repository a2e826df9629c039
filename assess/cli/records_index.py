"""`assess records index`: the catalogue of a folder, brought up to date."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.arguments import Jobs
from assess.cli.processes import processes
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
    jobs: Jobs = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print counts and unreadable files as JSON.")] = False,
) -> None:
    """Read the records of a folder once into a catalogue beside them: metadata, measures, 5 % spectra.

    Later runs read only files that are new or have changed; one that was stopped goes on where it ended.
    """
    from assess.cli.index_table import json_text, table_text
    from assess.cli.progress import progress
    from assess.cli.warning import warn
    from records.catalogue import NAME, candidates, open_catalogue, store_flatfile
    from records.flatfile import read_flatfile
    from records.flatfile_match import match_flatfile
    from records.formats.header_overrides import HeaderOverrides
    from records.indexing import index as brought_up
    from records.plausibility import candidate_warning
    from records.record_files import files_below

    table = None if flatfile is None else read_flatfile(flatfile)
    next(files_below(folder), None)  # a folder that is none is told before a catalogue is made
    place = catalogue or folder / NAME
    with (
        progress() as said,
        open_catalogue(place) as connection,
        processes(jobs) as executor,
    ):
        if table is not None:
            store_flatfile(connection, table.recordings)
        found = brought_up(
            folder,
            connection,
            overrides=HeaderOverrides(unit, step, response),
            executor=executor,
            progress=lambda done, total: said.count("records", done, total),
        )
        listed = candidates(connection)
    described = sum(one.magnitude is not None for one in listed)
    met = None if table is None else match_flatfile(listed, table)
    warn(["" if met is None else met.warning, *(candidate_warning(one) for one in listed)])
    print((json_text if as_json else table_text)(found, place, described=described, merged=met), end="")
