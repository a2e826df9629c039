"""`assess geometry --doctor`: the defects of model files as a table for the terminal, as CSV and as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from assess.cli.tables import on_one_line
from assess.geometry.doctor import Diagnosis, diagnose
from assess.geometry.formats.mesh_file import Element
from assess.geometry.mesh import InventoryEntry
from assess.messages.message import count_noun, escape_text

if TYPE_CHECKING:
    from assess.cli.geometry import Listed

HEADER = ("element", "mended", "moved [m3]", "defect", "cure")
WIDEST = 200  # characters of a cell: sentences are read whole


def doctor_table(listed: Listed) -> str:
    """Write a line for each defect, and for each file how many of its parts are sound."""
    return "\n".join(_file_table(file, _entries(file, found)) for file, found in listed)


def doctor_csv(listed: Listed) -> str:
    """Write a line for each defect at full precision."""
    from reports.render.table_text import csv_lines

    rows = list(_rows(listed))
    return csv_lines([list(KEYS), *(list(row.values()) for row in rows)])


def doctor_json(listed: Listed) -> str:
    """Write a list of the defects."""
    return json.dumps(list(_rows(listed)), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


KEYS = ("file", "element", "defect", "cure", "mended", "volume_moved_m3")


def _rows(listed: Listed) -> Iterator[dict[str, Any]]:
    for file, found in listed:
        for entry in _entries(file, found):
            for each in diagnose(entry):
                values = (str(file), each.element, each.defect, each.cure, each.mended or None, each.moved)
                yield dict(zip(KEYS, values, strict=True))


def _entries(file: Path, found: Any) -> tuple[InventoryEntry, ...]:
    """Return the parts of a file; one of the name of the file where it cannot be read."""
    if isinstance(found, Exception):
        reason = str(found).removeprefix(f"{file}: ")
        return (InventoryEntry(file.name, Element(names=(file.name,)), why_not=reason),)
    return tuple(found)


def _file_table(file: Path, entries: tuple[InventoryEntry, ...]) -> str:
    defects = [each for entry in entries for each in diagnose(entry)]
    lost = sum(1 for entry in entries if entry.why_not)
    mended = {each.element for each in defects if each.mended}
    moved = sum(abs(each.moved) for each in defects if each.moved)
    told = [count_noun(len(entries), "part"), f"{lost} not usable", f"{len(mended)} mended, which moved {moved:.3g} m3"]
    table = _left_table([HEADER, *map(_row, defects)]) if defects else ""
    return f"{escape_text(str(file))}\n{table}{', '.join(told)}\n"


def _left_table(rows: Sequence[Sequence[str]]) -> str:
    """Align columns to the left, as they hold sentences."""
    cells = [[on_one_line(cell, WIDEST) for cell in row] for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(HEADER))]
    lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in cells)
    return "".join(f"{line.rstrip()}\n" for line in lines)


def _row(each: Diagnosis) -> Sequence[str]:
    return each.element, each.mended or "no", "-" if each.moved is None else f"{each.moved:.3g}", each.defect, each.cure
