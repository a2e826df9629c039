"""`assess records convert`: one record processed and written in another format."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.completions import acceleration_units
from assess.cli.records.options import Files, Response, Step, Unit, check_azimuth


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
            autocompletion=acceleration_units,
            help="Unit of a CSV file: m/s2 (default), g, cm/s2, gal, mm/s2.",
        ),
    ] = None,
) -> None:
    """Write one record as CSV or PEER AT2, after rotation, correction, filtering, trimming, resampling and scaling."""
    if azimuth is not None and rotd is not None:
        raise typer.BadParameter("--azimuth and --rotd exclude each other")
    from assess.cli.stderr import print_warnings
    from assess.results.stamp import stamp_of_files
    from records.conversion import Processing, choose_records, process, text_of
    from records.plausibility import record_warning, warnings_among
    from records.reading import read_records

    found = [record for file in files for record in read_records(file, unit=unit, step=step, response=response)]
    wanted = Processing(azimuth, rotd, baseline, low_cut, high_cut, order, trim, resample, scale)
    used = choose_records(found, component=component, turned=wanted.turns)
    print_warnings([*map(record_warning, used), *map(str, warnings_among(used))])
    record = process(used, wanted)
    stamp = stamp_of_files("records convert", files, wanted, component, unit, step, to_unit)
    _write(text_of(record, output, unit=to_unit, stamp=stamp), output, inputs=files)
    print(f"{output}: {record.npts} samples at {record.dt:.6g} s; {'; '.join(map(str, record.processing_history))}")


def _write(text: str, path: Path, *, inputs: Sequence[Path]) -> None:
    """Write a file completely or not at all; refuse one that is read."""
    from assess.errors import OutputError
    from assess.outputs.single import write_file

    if path.is_dir() or any(path.exists() and path.samefile(each) for each in inputs):
        raise OutputError(f"{path}: is a folder or an input file; give another name with -o")
    with write_file(path, command="assess records convert") as made:
        made.write_text(text, encoding="utf-8", newline="\n")
