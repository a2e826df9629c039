"""Options that are checked when they are typed, so that a wrong one is refused also where no file needs it."""

from __future__ import annotations

from pathlib import Path

import typer


def known_unit(unit: str | None) -> str | None:
    """A unit of acceleration."""
    if unit is not None:
        from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

        try:
            factor_of(unit, known=ACCELERATION_UNITS)
        except ColumnError as error:
            raise typer.BadParameter(str(error)) from None
    return unit


def step_of_records(step: float | None) -> float | None:
    """A time step [s] that a record can have."""
    if step is not None:
        from records.reading import COARSEST, FINEST

        if not FINEST <= step <= COARSEST:
            raise typer.BadParameter(f"time step {step:g} s; records have {FINEST:g} to {COARSEST:g} s")
    return step


def response_file(path: Path | None) -> Path | None:
    """A file of an instrument's response."""
    if path is not None and not path.is_file():
        raise typer.BadParameter(f"{path}: no such file; give the StationXML of the instrument")
    return path


def turn(azimuth: float | None) -> float | None:
    """An azimuth [deg] of at most one turn."""
    if azimuth is not None and not abs(azimuth) <= 360.0:
        raise typer.BadParameter(f"{azimuth:g} deg; it must be from -360 to 360")
    return azimuth


def share(number: float) -> float:
    """A number from 0 to 1."""
    if not 0.0 <= number <= 1.0:
        raise typer.BadParameter(f"{number:g}; it must be from 0 to 1")
    return number


def damping_ratio(damping: float) -> float:
    """A damping ratio."""
    if not 0.0 <= damping < 1.0:
        raise typer.BadParameter(f"{damping:g}; it must be from 0 to below 1")
    return damping
