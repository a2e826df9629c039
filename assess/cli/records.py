"""`assess records`: what is done with files of ground motions."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.checked import known_unit, response_file, step_of_records, turn

records = typer.Typer(
    help="Read, process and convert records of ground motions.",
    no_args_is_help=False,
    invoke_without_command=True,
    rich_markup_mode=None,
)

Files = Annotated[list[Path], typer.Argument(metavar="FILES…", help="Record files, of any format known.")]
Unit = Annotated[
    str | None,
    typer.Option(
        help="Of accelerations, where a file does not say it: g, m/s2, cm/s2, gal, mm/s2.", callback=known_unit
    ),
]
Step = Annotated[
    float | None, typer.Option(help="Of time [s], where a file does not say it.", callback=step_of_records)
]
Response = Annotated[
    Path | None, typer.Option(help="StationXML of the instrument, for MiniSEED and SAC.", callback=response_file)
]


@records.callback()
def _records(context: typer.Context) -> None:
    if context.invoked_subcommand is None:
        print(context.get_help())
        raise typer.Exit(2)


@records.command("list")
def list_records(
    files: Files,
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the records as in results.json, with measures.")
    ] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV, at full precision.")] = False,
) -> None:
    """Print each record of the files: step, samples, peaks, intensities and durations."""
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")
    from assess.cli.record_table import csv_text, json_text, table_text
    from assess.cli.warning import warn
    from records.plausibility import record_warning, warnings_among
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    warn([*map(record_warning, found), *warnings_among(found)])
    text = json_text if as_json else csv_text if as_csv else table_text
    print(text(found), end="")


@records.command()
def convert(
    files: Files,
    output: Annotated[Path, typer.Option("-o", "--output", metavar="OUT", help="File to write: .csv or .at2.")],
    unit: Unit = None,
    step: Step = None,
    response: Response = None,
    component: Annotated[
        str | None, typer.Option(help="Of a file of several, as `assess records list` names it.")
    ] = None,
    azimuth: Annotated[
        float | None, typer.Option(help="Turn two horizontal components to this one [deg].", callback=turn)
    ] = None,
    rotd: Annotated[float | None, typer.Option(help="Turn two to this percentile of peaks: 50, 100.")] = None,
    baseline: Annotated[int | None, typer.Option(help="Take off the best polynomial of this degree.")] = None,
    low_cut: Annotated[float | None, typer.Option(help="Corner of the acausal Butterworth filter [Hz].")] = None,
    high_cut: Annotated[float | None, typer.Option(help="Corner of the acausal Butterworth filter [Hz].")] = None,
    order: Annotated[int, typer.Option(min=1, max=10, help="Of the filter, which runs forwards and backwards.")] = 4,
    trim: Annotated[
        tuple[float, float] | None,
        typer.Option(metavar="FROM TO", help="Keep these shares of Arias intensity: 0.01 0.99."),
    ] = None,
    resample: Annotated[float | None, typer.Option(help="New step [s], without aliasing.")] = None,
    scale: Annotated[float | None, typer.Option(help="Multiply every acceleration.")] = None,
    to_unit: Annotated[
        str | None,
        typer.Option(metavar="UNIT", help="Of the CSV written: m/s2 (if absent), g, cm/s2, gal, mm/s2."),
    ] = None,
) -> None:
    """Write one record as CSV or PEER AT2, turned, corrected, filtered, trimmed, resampled and scaled in this order."""
    if azimuth is not None and rotd is not None:
        raise typer.BadParameter("--azimuth and --rotd exclude each other")
    from assess.cli.record_conversion import Processing, chosen, processed, text_of, write
    from assess.cli.warning import warn
    from assess.results.stamp import stamp_of_files
    from records.plausibility import record_warning, warnings_among
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    wanted = Processing(azimuth, rotd, baseline, low_cut, high_cut, order, trim, resample, scale)
    used = chosen(found, component=component, turned=wanted.turns)
    warn([*map(record_warning, used), *warnings_among(used)])
    record = processed(used, wanted)
    stamp = stamp_of_files("records convert", files, wanted, component, unit, step, to_unit)
    write(text_of(record, output, unit=to_unit, stamp=stamp), output, inputs=files)
    print(f"{output}: {record.npts} samples at {record.dt:.6g} s; {'; '.join(record.processing_history)}")
