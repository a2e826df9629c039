"""Arguments and options that the commands on records share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.completions import acceleration_units


def check_unit(unit: str | None) -> str | None:
    """Return a unit of acceleration; raise BadParameter for one that is not known."""
    if unit is not None:
        from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

        try:
            factor_of(unit, known=ACCELERATION_UNITS)
        except ColumnError as error:
            raise typer.BadParameter(str(error)) from None
    return unit


def check_step(step: float | None) -> float | None:
    """Return a time step [s]; raise BadParameter for one that no record has."""
    if step is not None:
        from records.reading import COARSEST, FINEST

        if not FINEST <= step <= COARSEST:
            raise typer.BadParameter(f"time step {step:g} s; records have {FINEST:g} to {COARSEST:g} s")
    return step


def check_response_file(path: Path | None) -> Path | None:
    """Return the file of an instrument's response; raise BadParameter where there is none."""
    if path is not None and not path.is_file():
        raise typer.BadParameter(f"{path}: no such file; give the StationXML of the instrument")
    return path


def check_azimuth(azimuth: float | None) -> float | None:
    """Return an azimuth [deg]; raise BadParameter beyond one turn."""
    if azimuth is not None and not abs(azimuth) <= 360.0:
        raise typer.BadParameter(f"{azimuth:g} deg; it must be from -360 to 360")
    return azimuth


Files = Annotated[list[Path], typer.Argument(metavar="FILES…", help="Record files of any known format.")]
Unit = Annotated[
    str | None,
    typer.Option(
        metavar="UNIT",
        help="Unit of acceleration where a file does not state it: g, m/s2, cm/s2, gal, mm/s2.",
        callback=check_unit,
        autocompletion=acceleration_units,
    ),
]
Step = Annotated[
    float | None, typer.Option(metavar="SECONDS", help="Time step where a file does not state it.", callback=check_step)
]
Response = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE", help="StationXML of the instrument, for MiniSEED and SAC files.", callback=check_response_file
    ),
]
Flatfile = Annotated[
    Path | None, typer.Option(metavar="CSV", help="PEER flatfile with magnitude, distance, Vs30 and NGA number.")
]
Catalogue = Annotated[
    Path | None, typer.Option(metavar="FILE", help="Path of the catalogue (default: in the folder itself).")
]
TARGET = typer.Option(metavar="FILE", help="A project, for its site's spectrum, or a CSV of period and ordinate.")
Target = Annotated[Path, TARGET]
