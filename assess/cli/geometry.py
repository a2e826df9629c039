"""`assess geometry`: the parts of model files."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from assess.geometry.inventory import Entry


class Axis(StrEnum):
    """The axis of a file that points up."""

    Y = "y"
    Z = "z"


def geometry(
    files: Annotated[list[Path], typer.Argument(metavar="FILES…", help="Model files, of any format known.")],
    unit: Annotated[
        str | None, typer.Option("--unit", "--mesh-unit", metavar="UNIT", help="Of coordinates, as `mesh_unit`: mm.")
    ] = None,
    up: Annotated[Axis | None, typer.Option("--up", "--mesh-up", help="The axis that points up, as `mesh_up`.")] = None,
    element: Annotated[
        str | None, typer.Option(metavar="NAME", help="Only these, as `element`: name, GlobalId, class, pattern.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the parts as JSON.")] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV, at full precision.")] = False,
) -> None:
    """Print the parts of model files: name, class, storey, size, volume, place, closed or why not, thin direction.

    The thin direction is what `direction` of a wall's mechanism takes. A broken part, or a file that cannot be read,
    has a line of its own among the others; ends with 2 if nothing could be listed.
    """
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")
    scale = _length(unit)
    from assess.cli.geometry_table import csv_text, json_text, table_text
    from assess.errors import GeometryError

    listed = [_entries(file, scale, up, element) for file in files]
    wrong = [each for each in listed if isinstance(each, GeometryError)]
    if len(wrong) == len(listed) == 1:
        raise wrong[0]
    text = json_text if as_json else csv_text if as_csv else table_text
    print(text(list(zip(files, listed, strict=True))), end="")
    raise typer.Exit(2 if len(wrong) == len(listed) else 0)


def _entries(file: Path, scale: float | None, up: Axis | None, element: str | None) -> tuple[Entry, ...] | Exception:
    """The parts of a file, or what is wrong with it."""
    from assess.errors import GeometryError
    from assess.geometry.inventory import inventory

    try:
        return inventory(file, scale=scale, up=None if up is None else up.value, element=element)
    except GeometryError as problem:
        return problem


def _length(unit: str | None) -> float | None:
    """The length of a unit [m], as the project file's `mesh_unit`."""
    if unit is None:
        return None
    from assess.project.quantities import length_of_unit

    try:
        return length_of_unit(unit)
    except ValueError as problem:
        raise typer.BadParameter(f"--unit {unit!r}: {problem}") from None
