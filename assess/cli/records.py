"""`assess records`: commands that list, catalogue, draw and convert records of ground motion; suites have their own
file.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import (
    Catalogue,
    FigurePath,
    Files,
    Flatfile,
    Jobs,
    Response,
    Step,
    Unit,
    check_azimuth,
    check_damping,
    check_figure_path,
    complete_units,
    first_sentence,
    refuse_two_formats,
    with_verbosity,
)
from assess.cli.suites import scale, select


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
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.cli.stderr import print_warnings
    from assess.cli.tables.records import records_csv, records_json, records_table
    from records.plausibility import record_warning, warnings_among
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    print_warnings([*map(record_warning, found), *map(str, warnings_among(found))])
    text = records_json if as_json else records_csv if as_csv else records_table
    print(text(found), end="")


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
    from assess.cli.stderr import on_interruption, print_warnings, progress
    from assess.cli.tables.records import index_json, index_text
    from assess.workers import process_pool
    from records.catalogue import NAME, catalogue_candidates, open_catalogue, store_flatfile
    from records.flatfile import match_flatfile, read_flatfile
    from records.formats.header import HeaderOverrides
    from records.indexing import index as brought_up
    from records.plausibility import candidate_warning
    from records.reading import files_below

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
        listed = catalogue_candidates(connection)
    described = sum(one.magnitude is not None for one in listed)
    met = None if table is None else match_flatfile(listed, table)
    print_warnings(
        ["" if met is None or met.warning is None else met.warning.text, *(candidate_warning(one) for one in listed)]
    )
    print((index_json if as_json else index_text)(found, place, described=described, merged=met), end="")


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
    check_figure_path(output)
    from assess.cli.stderr import progress
    from assess.cli.tables.records import draw_spectra, read_spectra, spectra_csv, spectra_table
    from assess.workers import process_pool
    from records.formats.header import HeaderOverrides

    with progress(), process_pool(jobs) as executor:
        overrides = HeaderOverrides(unit, step, response)
        found = read_spectra(places, damping=damping, overrides=overrides, kept=catalogue, executor=executor)
    if output is not None:
        draw_spectra(found, output)
    print((spectra_csv if as_csv else spectra_table)(found), end="")


def convert(
    files: Files,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="OUT", help="File to write, .csv or .at2.")],
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    component: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="Component of a file with several, as named by `assess records list`."),
    ] = None,
    azimuth: Annotated[
        float | None,
        typer.Option(
            metavar="DEGREES",
            help="Rotate two horizontal components to this azimuth, from north.",
            callback=check_azimuth,
        ),
    ] = None,
    rotd: Annotated[
        float | None,
        typer.Option(metavar="50|100", help="Rotate two horizontal components to this percentile of peaks."),
    ] = None,
    baseline: Annotated[
        int | None, typer.Option(metavar="DEGREE", help="Remove the best-fit polynomial of this degree.")
    ] = None,
    low_cut: Annotated[
        float | None, typer.Option(metavar="HZ", help="Lower corner of the acausal Butterworth filter.")
    ] = None,
    high_cut: Annotated[
        float | None, typer.Option(metavar="HZ", help="Upper corner of the acausal Butterworth filter.")
    ] = None,
    order: Annotated[
        int,
        typer.Option(metavar="NUMBER", min=1, max=10, help="Order of the filter, which runs forwards and backwards."),
    ] = 4,
    trim: Annotated[
        tuple[float, float] | None,
        typer.Option(
            metavar="FROM TO", help="Keep the part between these shares of Arias intensity, such as 0.01 0.99."
        ),
    ] = None,
    resample: Annotated[float | None, typer.Option(metavar="SECONDS", help="New time step, without aliasing.")] = None,
    scale: Annotated[float | None, typer.Option(metavar="FACTOR", help="Factor applied to every acceleration.")] = None,
    to_unit: Annotated[
        str | None,
        typer.Option(
            metavar="UNIT",
            autocompletion=complete_units,
            help="Unit of a CSV file: m/s2 (default), g, cm/s2, gal, mm/s2.",
        ),
    ] = None,
) -> None:
    """Write one record as CSV or PEER AT2, after rotation, correction, filtering, trimming, resampling and scaling."""
    if azimuth is not None and rotd is not None:
        raise typer.BadParameter("--azimuth and --rotd exclude each other")
    from assess.cli.stderr import print_warnings
    from assess.results.provenance import stamp_of_files
    from records.plausibility import record_warning, warnings_among
    from records.processing import Processing, choose_records, process, record_text
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    wanted = Processing(azimuth, rotd, baseline, low_cut, high_cut, order, trim, resample, scale)
    used = choose_records(found, component=component, turned=wanted.turns)
    print_warnings([*map(record_warning, used), *map(str, warnings_among(used))])
    record = process(used, wanted)
    stamp = stamp_of_files("records convert", files, wanted, component, unit, step, to_unit)
    _write_record(record_text(record, output, unit=to_unit, stamp=stamp), output, inputs=files)
    print(f"{output}: {record.npts} samples at {record.dt:.6g} s; {'; '.join(map(str, record.processing_history))}")


def _write_record(text: str, path: Path, *, inputs: Sequence[Path]) -> None:
    """Write a file completely or not at all; refuse one that is read."""
    from assess.errors import OutputError
    from assess.outputs.writing import write_file

    if path.is_dir() or any(path.exists() and path.samefile(each) for each in inputs):
        raise OutputError(f"{path}: is a folder or an input file; give another name with -o")
    with write_file(path, command="assess records convert") as made:
        made.write_text(text, encoding="utf-8", newline="\n")


records = typer.Typer(
    help="List, process, convert, select and scale records of ground motion.",
    no_args_is_help=False,
    invoke_without_command=True,
    rich_markup_mode=None,
)


@records.callback()
def _records(context: typer.Context) -> None:
    if context.invoked_subcommand is None:
        print(context.get_help())
        raise typer.Exit(2)


records.command("list", short_help=first_sentence(list_records))(with_verbosity(list_records))

for command in (convert, index, spectra, select, scale):
    records.command(short_help=first_sentence(command))(with_verbosity(command))
