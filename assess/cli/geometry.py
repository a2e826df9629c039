"""`assess geometry`: the parts of model files, or their defects, as a table for the terminal, as CSV and as JSON."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import atan2, degrees
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from assess.cli.options import UpAxis, flag, refuse_two_formats
from assess.cli.tables import TextField, table_of
from assess.messages.message import escape_text

if TYPE_CHECKING:
    from assess.geometry.mesh import InventoryEntry

    Listed = Sequence[tuple[Path, Sequence[InventoryEntry] | Exception]]


PART_FIELDS: Sequence[TextField[InventoryEntry]] = (
    ("part", lambda part: part.element.shown),
    ("class", lambda part: _first(part.element.kinds)),
    ("storey", lambda part: part.element.storey),
    ("GlobalId", lambda part: part.element.identifier),
    ("t x l x h [m]", lambda part: "" if part.size is None else " x ".join(f"{each:.4g}" for each in part.size)),
    ("V [m3]", lambda part: "" if part.volume is None else f"{part.volume:.4g}"),
    ("at x, y, z [m]", lambda part: "" if part.place is None else ", ".join(map(_coordinate, part.place))),
    ("closed", lambda part: "yes" if part.closed else "no"),
    ("thin [deg]", lambda part: "" if part.thin is None else f"{_angle(part.thin):.4g}"),
)


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
    doctor: Annotated[bool, flag("--doctor", "List what is wrong, what cures it, and what was mended.")] = False,
    as_json: Annotated[bool, flag("--json", "Print the parts as JSON.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the table as CSV at full precision.")] = False,
) -> None:
    """List the parts of model files: name, class, storey, size, volume, position, closed or why not, thin direction.

    The thin direction is the usual `direction` of a wall's mechanism. A broken part or an unreadable file has its own
    line; the exit code is 2 if no file could be listed, or no part of any is usable. With --doctor: the defects, with
    the volume that mending moved.
    """
    refuse_two_formats(as_json=as_json, as_csv=as_csv)
    scale = _length_of_unit(unit)
    from assess.errors import GeometryError

    listed = [_read_entries(file, scale, up, element) for file in files]
    wrong = [each for each in listed if isinstance(each, GeometryError)]
    if len(wrong) == len(listed) == 1:
        raise wrong[0]
    found = list(zip(files, listed, strict=True))
    if doctor:
        from assess.cli.doctor import doctor_csv, doctor_json, doctor_table

        print((doctor_json if as_json else doctor_csv if as_csv else doctor_table)(found), end="")
    else:
        print((_geometry_json if as_json else _geometry_csv if as_csv else _geometry_table)(found), end="")
    entries = [(file, entry) for file, each in found if not isinstance(each, Exception) for entry in each]
    if entries and all(entry.why_not for _, entry in entries):
        file, first = entries[0]
        raise GeometryError(f"{file}: no part of it is usable ({first.element.shown}: {first.why_not})")
    raise typer.Exit(0 if entries else 2)


def _read_entries(
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
    from assess.project.values import length_of_unit

    try:
        return length_of_unit(unit)
    except ValueError as problem:
        raise typer.BadParameter(f"--unit {unit!r}: {problem}") from None


def _geometry_table(listed: Listed) -> str:
    """Write a rounded line for each part, followed by warnings."""
    return "\n".join(_file_table(file, each) for file, each in listed)


def _geometry_csv(listed: Listed) -> str:
    """Write everything at full precision under its JSON names, with a column for each component of vectors."""
    from reports.render.table_text import csv_lines

    rows = [_flat(row) for row in _properties_listed(listed)]
    return csv_lines([list(rows[0]), *(list(row.values()) for row in rows)])


def _geometry_json(listed: Listed) -> str:
    """Write a list of the parts; an unreadable file has one entry with the reason."""
    return json.dumps(_properties_listed(listed), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def _file_table(file: Path, found: Sequence[InventoryEntry] | Exception) -> str:
    if isinstance(found, Exception):
        return f"{escape_text(str(found))}\n"
    kept = [(head, cell) for head, cell in PART_FIELDS if any(map(cell, found)) or head == "part"]
    table = table_of(kept, found)
    return f"{escape_text(str(file))}\n{table}{_warnings_text(found)}"


def _warnings_text(found: Sequence[InventoryEntry]) -> str:
    """Write a line for each warning, with the parts that it concerns."""
    parts: dict[str, list[str]] = {}
    for each in found:
        for text in (each.why_not,) if each.why_not else map(str, each.warnings):
            parts.setdefault(text, []).append(each.element.shown)
    return "".join(f"{_parts_named(names)}: {escape_text(text)}\n" for text, names in parts.items())


def _parts_named(names: Sequence[str]) -> str:
    from assess.geometry.formats.mesh_file import list_names, one_line

    return one_line(names[0]) if len(names) == 1 else f"{len(names)} parts ({list_names(names)})"


def _coordinate(value: float) -> str:
    return f"{round(value, 3) + 0.0:.7g}"


def _properties_listed(listed: Listed) -> list[dict[str, Any]]:
    return [row for file, found in listed for row in _file_rows(file, found)]


def _file_rows(file: Path, found: Sequence[InventoryEntry] | Exception) -> list[dict[str, Any]]:
    """Return the properties of the parts of a file, with units in the names."""
    from assess.geometry.formats.mesh_file import Element
    from assess.geometry.mesh import InventoryEntry

    if isinstance(found, Exception):
        return [_part_properties(file, InventoryEntry(file.name, Element(), why_not=str(found)))]
    return [_part_properties(file, each) for each in found]


def _part_properties(file: Path, entry: InventoryEntry) -> dict[str, Any]:
    one = entry.element
    return {
        "file": str(file),
        "name": one.shown if one.names or one.within else None,
        "class": _first(one.kinds) or None,
        "storey": one.storey or None,
        "global_id": one.identifier or None,
        "triangles": entry.triangles,
        "size_m": entry.size and list(entry.size),
        "volume_m3": entry.volume,
        "place_m": entry.place and list(entry.place),
        "closed": entry.closed,
        "why_not": entry.why_not or None,
        "remarks": [warning.text for warning in entry.warnings],
        "thin_direction": entry.thin and [*entry.thin, 0.0],
        "thin_direction_deg": None if entry.thin is None else _angle(entry.thin),
    }


def _flat(row: dict[str, Any]) -> dict[str, Any]:
    """Split vectors into columns: size, position and direction have three numbers each."""
    names = {
        "size_m": ("thickness_m", "length_m", "height_m"),
        "place_m": ("x_m", "y_m", "z_m"),
        "thin_direction": ("thin_x", "thin_y", "thin_z"),
    }
    flat: dict[str, Any] = {}
    for key, value in row.items():
        if key in names:
            flat |= dict(zip(names[key], value or (None, None, None), strict=True))
        else:
            flat[key] = "; ".join(value) if key == "remarks" else value
    return flat


def _first(words: tuple[str, ...]) -> str:
    return words[0] if words else ""


def _angle(thin: tuple[float, float]) -> float:
    """Return the angle from +x towards +y [deg]."""
    return degrees(atan2(thin[1], thin[0]))
