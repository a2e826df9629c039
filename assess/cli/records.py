"""`assess records`: commands that list, catalogue, draw, convert, select and scale records of ground motion."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from assess.cli.options import (
    TARGET,
    CatalogueOption,
    FigurePath,
    Files,
    FlatfileOption,
    JobsOption,
    Response,
    StepOption,
    Target,
    UnitOption,
    check_azimuth,
    check_damping,
    check_figure_path,
    complete_units,
    complete_words,
    first_sentence,
    flag,
    refuse_two_formats,
    with_verbosity,
    word_option,
)
from assess.cli.stderr import on_interruption, print_message, print_messages, print_note, print_warnings, progress

if TYPE_CHECKING:
    from assess.project.suites import ScaledSuite


Folder = Annotated[Path, typer.Argument(metavar="FOLDER", help="Folder of record files, with its subfolders.")]


def index(
    folder: Folder,
    flatfile: FlatfileOption = None,
    catalogue: CatalogueOption = None,
    unit: UnitOption = None,
    step: StepOption = None,
    response: Response = None,
    jobs: JobsOption = None,
    as_json: Annotated[bool, flag("--json", "Print the counts and the unreadable files as JSON.")] = False,
) -> None:
    """Catalogue the records of a folder: metadata, measures and 5 % spectra.

    Later runs read only new and changed files; an interrupted run continues where it stopped.
    """
    from assess.cli.tables.records import index_summary_json, index_summary_text
    from assess.workers import process_pool
    from records.catalogue import NAME, catalogue_candidates, open_catalogue, store_flatfile
    from records.catalogue import index as brought_up
    from records.flatfile import match_flatfile, read_flatfile
    from records.formats.header import HeaderOverrides
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
    print(
        (index_summary_json if as_json else index_summary_text)(found, place, described=described, merged=met), end=""
    )


Places = Annotated[list[Path], typer.Argument(metavar="FILES…|FOLDER", help="Record files, or a folder of them.")]


def spectra(
    places: Places,
    damping: Annotated[
        float,
        typer.Option(metavar="NUMBER", help="Damping ratio; the spectra of a folder have 5 %.", callback=check_damping),
    ] = 0.05,
    unit: UnitOption = None,
    step: StepOption = None,
    response: Response = None,
    catalogue: CatalogueOption = None,
    jobs: JobsOption = None,
    as_csv: Annotated[bool, flag("--csv", "Print every period as CSV, with a column for each record.")] = False,
    output: FigurePath = None,
) -> None:
    """Print the pseudo-acceleration spectra of records; those of a folder are read from its catalogue."""
    check_figure_path(output)
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
    unit: UnitOption = None,
    step: StepOption = None,
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
    from assess.results.provenance import stamp_of_files
    from records.plausibility import record_warning, warnings_among
    from records.processing import Processing, choose_records, process, record_text
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    processing = Processing(azimuth, rotd, baseline, low_cut, high_cut, order, trim, resample, scale)
    used = choose_records(found, component=component, rotated=processing.rotates)
    print_warnings([*map(record_warning, used), *map(str, warnings_among(used))])
    record = process(used, processing)
    stamp = stamp_of_files("records convert", files, processing, component, unit, step, to_unit)
    _write_record(record_text(record, output, unit=to_unit, stamp=stamp), output, inputs=files)
    print(f"{output}: {record.npts} samples at {record.dt:.6g} s; {'; '.join(map(str, record.processing_history))}")


def select(
    context: typer.Context,
    places: Annotated[
        list[Path],
        typer.Argument(
            metavar="PROJECT|FOLDERS…", help="A project with [records] select; or, with --target, folders and files."
        ),
    ],
    target: Annotated[Path | None, TARGET] = None,
    count: Annotated[int, typer.Option(metavar="N", min=1, max=200, help="Number of records.")] = 7,
    periods: Annotated[tuple[float, float], typer.Option(metavar="FROM TO", help="Periods over which to fit [s].")] = (
        0.1,
        2.0,
    ),
    scale_limits: Annotated[
        tuple[float, float], typer.Option(metavar="FROM TO", help="Smallest and largest scale factor.")
    ] = (0.25, 4.0),
    fit: Annotated[str, word_option('Fit the mean of the "suite", or "each" record.', "suite", "each")] = "suite",
    components: Annotated[
        str,
        word_option('Use components separately ("single"), or those of a recording "together".', "single", "together"),
    ] = "single",
    code: Annotated[
        str | None,
        typer.Option(
            "--for",
            metavar="CODE",
            autocompletion=complete_words("asce7-16", "asce43-05", "ec8", "ntc2018", "nzs1170.5"),
            help="Meet the rules of asce7-16, asce43-05, ec8, ntc2018 or nzs1170.5; --periods are 0.2 to 1.2 T.",
        ),
    ] = None,
    scale_to: Annotated[
        str, word_option('Scale each record to "spectrum", "pga" or "none".', "spectrum", "pga", "none")
    ] = "spectrum",
    several_per_event: Annotated[bool, flag("--several-per-event", "Allow several records of one earthquake.")] = False,
    magnitude: Annotated[Span, _span_option("Keep only records within these magnitudes.")] = None,
    distance: Annotated[Span, _span_option("The same of the distance [km].")] = None,
    vs30: Annotated[Span, _span_option("The same of Vs30 [m/s].")] = None,
    pga: Annotated[Span, _span_option("The same of the peak ground acceleration before scaling [g].")] = None,
    duration: Annotated[Span, _span_option("The same of the duration D5-95 [s].")] = None,
    event: Annotated[
        list[str] | None,
        typer.Option(metavar="TEXT", help="Keep only earthquakes with this in their name; may be repeated."),
    ] = None,
    flatfile: FlatfileOption = None,
    catalogue: CatalogueOption = None,
    unit: UnitOption = None,
    step: StepOption = None,
    response: Response = None,
    lock: Annotated[
        bool,
        flag("--lock", "Also write records.lock.toml beside the project (or target): files, factors, hashes."),
    ] = False,
    table: Annotated[
        Path | None,
        typer.Option(
            metavar="TABLE.csv", help="With --lock, of a template: lock a suite for each target of the table's rows."
        ),
    ] = None,
    jobs: JobsOption = None,
    as_json: Annotated[bool, flag("--json", "Print records and ground_motion as in results.json.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the records as CSV at full precision.")] = False,
    output: FigurePath = None,
) -> None:
    """Select the records that best fit a target spectrum, scale them, and check the suite against code rules.

    A project uses its own [records] select. Folders are indexed first; only new and changed files are read. A lock,
    used by [records] lock = "records.lock.toml", keeps the suite as it is whatever becomes of the mechanisms.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    check_figure_path(output)
    _refuse_without_target(context, target, places)
    if table is not None and (target is not None or not lock):
        raise typer.BadParameter("--table goes with --lock, and with the template of the table in place of --target")
    from assess.project.suites import SuiteOptions, lock_project, lock_target, select_for_target, suite_of_project
    from assess.workers import process_pool
    from records.formats.header import HeaderOverrides

    written, left_out = None, tuple[str, ...]()
    if target is None:
        with progress(), process_pool(jobs) as executor:
            if lock:
                found, written, left_out = lock_project(places[0], table=table, executor=executor)
            else:
                found = suite_of_project(places[0], executor=executor)
    else:
        spans = {"magnitude": magnitude, "distance": distance, "vs30": vs30, "pga": pga, "duration": duration}
        one_per_event, events = not several_per_event, tuple(event or ())
        options = SuiteOptions(
            count, periods, scale_limits, fit, components, scale_to, one_per_event, spans, events, code
        )
        overrides = HeaderOverrides(unit, step, response)
        with progress(), process_pool(jobs) as executor:
            selected = select_for_target(
                target, places, options, overrides=overrides, flatfile=flatfile, kept=catalogue, executor=executor
            )
        found, written = selected.suite, lock_target(target, selected) if lock else None
    _print_suite(found, output, as_json=as_json, as_csv=as_csv)
    if written is not None:
        print_note(f'{written} written; [records] lock = "{written.name}" uses it')
    print_warnings([f"{each}; so the lock has no suite for its site" for each in left_out], of="sites without a suite")


def scale(
    files: Files,
    target: Target,
    to: Annotated[
        str, word_option('Match the "spectrum" (least squares), its "pga", or "none".', "spectrum", "pga", "none")
    ] = "spectrum",
    at: Annotated[float | None, typer.Option(metavar="PERIOD", help="Match the ordinate at this period [s].")] = None,
    periods: Annotated[
        tuple[float, float], typer.Option(metavar="FROM TO", help="Periods of the least squares [s].")
    ] = (
        0.1,
        2.0,
    ),
    unit: UnitOption = None,
    step: StepOption = None,
    response: Response = None,
    as_json: Annotated[bool, flag("--json", "Print records and ground_motion as in results.json.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the records as CSV at full precision.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="DIR", help="Folder in which to write each scaled record as CSV."),
    ] = None,
) -> None:
    """Scale records to a design spectrum, its peak ground acceleration, or its ordinate at one period."""
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    if at is not None and to != "spectrum":
        raise typer.BadParameter("--at and --to exclude each other")
    from assess.cli.tables.records import suite_csv, suite_json, suite_table
    from assess.outputs.manifest import RECORDS
    from assess.outputs.writing import output_folder
    from assess.project.suites import write_scaled_files
    from assess.results.provenance import stamp_of_files
    from records.formats.header import HeaderOverrides
    from records.processing import csv_text as record_text
    from records.record import scale

    overrides = HeaderOverrides(unit, step, response)
    place = (
        nullcontext()
        if output is None
        else output_folder(output, command="assess records scale", owner=RECORDS, tell=print_message)
    )
    with place as stage:
        motions, suite = write_scaled_files(target, files, to=to, at=at, periods=periods, overrides=overrides)
        stamp = stamp_of_files("records scale", files, suite_json(suite))
        for number, motion in enumerate(motions, start=1):
            if stage is not None:
                text = record_text(scale(motion.record, motion.scaling.factor), stamp=stamp)
                name = "".join(c if c.isascii() and (c.isalnum() or c in "-._") else "-" for c in motion.record.id)
                (stage / f"{number:02d}-{name[:60]}.csv").write_text(text, encoding="utf-8")
    print((suite_json if as_json else suite_csv if as_csv else suite_table)(suite), end="")


def _list_records(
    files: Files,
    unit: UnitOption = None,
    step: StepOption = None,
    response: Response = None,
    as_json: Annotated[bool, flag("--json", "Print the records as in results.json, with their measures.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the table as CSV at full precision.")] = False,
) -> None:
    """Print time step, samples, peaks, intensities and durations of each record."""
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    from assess.cli.tables.records import records_csv, records_json, records_table
    from records.plausibility import record_warning, warnings_among
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    print_warnings([*map(record_warning, found), *map(str, warnings_among(found))])
    text = records_json if as_json else records_csv if as_csv else records_table
    print(text(found), end="")


def _write_record(text: str, path: Path, *, inputs: Sequence[Path]) -> None:
    """Write a file completely or not at all; refuse one that is read."""
    from assess.errors import OutputError
    from assess.outputs.writing import write_file

    if path.is_dir() or any(path.exists() and path.samefile(each) for each in inputs):
        raise OutputError(f"{path}: is a folder or an input file; give another name with -o")
    with write_file(path, command="assess records convert") as made:
        made.write_text(text, encoding="utf-8", newline="\n")


NOT_CRITERIA = ("places", "table", "jobs", "as_json", "as_csv", "output", "target", "lock")

OPTION_NAMES = {"code": "for"}
"""Options that are not named after their argument."""
Span = tuple[float, float] | None


def _span_option(words: str) -> Any:
    return typer.Option(metavar="FROM TO", help=words, show_default=False)


def _refuse_without_target(context: typer.Context, target: Path | None, places: Sequence[Path]) -> None:
    """Raise BadParameter for options or several places without a target; a project has its own criteria."""
    given = [
        OPTION_NAMES.get(name, name) for name in context.params if name not in NOT_CRITERIA and _is_given(context, name)
    ]
    if target is None and (given or len(places) != 1):
        what = f"--{given[0].replace('_', '-')}" if given else "several places"
        raise typer.BadParameter(f"{what} needs --target; a PROJECT has its own [records] select")


def _print_suite(found: ScaledSuite, output: Path | None, *, as_json: bool, as_csv: bool) -> None:
    """Draw the suite where a figure is requested, and print it."""
    from assess.cli.tables.records import draw_suite, suite_csv, suite_json, suite_table

    if output is not None:
        draw_suite(found, output)
    if as_json or as_csv:  # the table includes them
        print_messages(found.messages)
    print((suite_json if as_json else suite_csv if as_csv else suite_table)(found), end="")


def _is_given(context: typer.Context, name: str) -> bool:
    """Return whether an option is given on the command line."""
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"


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


records.command("list", short_help=first_sentence(_list_records))(with_verbosity(_list_records))
for command in (convert, index, spectra, select, scale):
    records.command(short_help=first_sentence(command))(with_verbosity(command))
