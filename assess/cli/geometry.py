"""`assess geometry`: the parts of model files."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from assess.cli.options import refuse_two_formats

if TYPE_CHECKING:
    from assess.geometry.mesh import InventoryEntry


class UpAxis(StrEnum):
    """The axis of a file that points up."""

    Y = "y"
    Z = "z"


def geometry(
    files: Annotated[list[Path], typer.Argument(metavar="FILES…", help="Model files of any known format.")],
    unit: Annotated[
        str | None,
        typer.Option(
            "--unit",
            "--mesh-unit",
            metavar="UNIT",
            help="Unit of the coordinates, such as mm (`mesh_unit` of a project).",
        ),
    ] = None,
    up: Annotated[
        UpAxis | None, typer.Option("--up", "--mesh-up", help="Axis that points up (`mesh_up` of a project).")
    ] = None,
    element: Annotated[
        str | None, typer.Option(metavar="NAME", help="Only these elements: name, GlobalId, class or pattern.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print the parts as JSON.")] = False,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV at full precision.")] = False,
) -> None:
    """List the parts of model files: name, class, storey, size, volume, position, closed or why not, thin direction.

    The thin direction is the usual `direction` of a wall's mechanism. A broken part or an unreadable file has its own
    line; the exit code is 2 if nothing could be listed.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    scale = _length_of_unit(unit)
    from assess.cli.tables.geometry import csv_text, json_text, table_text
    from assess.errors import GeometryError

    listed = [_entries(file, scale, up, element) for file in files]
    wrong = [each for each in listed if isinstance(each, GeometryError)]
    if len(wrong) == len(listed) == 1:
        raise wrong[0]
    text = json_text if as_json else csv_text if as_csv else table_text
    print(text(list(zip(files, listed, strict=True))), end="")
    raise typer.Exit(2 if len(wrong) == len(listed) else 0)


def _entries(
    file: Path, scale: float | None, up: UpAxis | None, element: str | None
) -> tuple[InventoryEntry, ...] | Exception:
    """Return the parts of a file, or what is wrong with it."""
    from assess.errors import GeometryError
    from assess.geometry.mesh import inventory

    try:
        return inventory(file, scale=scale, up=None if up is None else up.value, element=element)
    except GeometryError as problem:
        return problem


def _length_of_unit(unit: str | None) -> float | None:
    """Return the length of a unit [m], given as the project file's `mesh_unit`."""
    if unit is None:
        return None
    from assess.project.section import length_of_unit

    try:
        return length_of_unit(unit)
    except ValueError as problem:
        raise typer.BadParameter(f"--unit {unit!r}: {problem}") from None
