"""`assess geometry --doctor`: the defects of model files as a table for the terminal, as CSV and as JSON."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from assess.cli.tables import on_one_line
from assess.geometry.doctor import Diagnosis, diagnose, find_overlaps
from assess.geometry.formats.mesh_file import Element
from assess.geometry.mesh import InventoryEntry
from assess.messages.message import count_noun, escape_text, first_names
from assess.model.part_kinds import reason_by_class

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
        entries = _entries(file, found)
        defects = [each for entry in entries for each in diagnose(entry)]
        for each in (*defects, *(overlap for overlap, _ in _overlaps(entries))):
            values = (str(file), each.element, each.defect, each.cure, each.mended or None, each.moved)
            yield dict(zip(KEYS, values, strict=True))


def _overlaps(entries: tuple[InventoryEntry, ...]) -> tuple[tuple[Diagnosis, float], ...]:
    """Return the overlaps of what may be masonry: furniture, rooms and services are drawn in one another's space."""
    return find_overlaps([entry for entry in entries if reason_by_class(entry.element) is None])


def _entries(file: Path, found: Any) -> tuple[InventoryEntry, ...]:
    """Return the parts of a file; one of the name of the file where it cannot be read."""
    if isinstance(found, Exception):
        reason = str(found).removeprefix(f"{file}: ")
        return (InventoryEntry(file.name, Element(names=(file.name,)), why_not=reason),)
    return tuple(found)


def _file_table(file: Path, entries: tuple[InventoryEntry, ...]) -> str:
    defects = [each for entry in entries for each in diagnose(entry)]
    overlaps = _overlaps(entries)
    lost = [entry.element.shown for entry in entries if entry.why_not]
    mended = {each.element for each in defects if each.mended}
    moved = sum(abs(each.moved) for each in defects if each.moved)
    told = [
        count_noun(len(entries), "part"),
        f"{len(lost)} not usable" + (f" ({first_names(lost, LISTED)})" if lost else ""),
        f"{len(mended)} mended" + (f", which moved {moved:.3g} m3" if mended else ""),
        count_noun(len(overlaps), "overlap") + (f" of {sum(v for _, v in overlaps):.3g} m3" if overlaps else ""),
    ]
    rows = [
        *(_row(each, lost) for each in defects),
        *(_row(each, lost) for each, _ in overlaps),
    ]
    table = _left_table([HEADER, *rows]) if rows else ""
    return f"{escape_text(str(file))}\n{table}{', '.join(told)}\n"


LISTED = 5  # names of parts that are not usable, in the last line


def _left_table(rows: Sequence[Sequence[str]]) -> str:
    """Align columns to the left, as they hold sentences."""
    cells = [[on_one_line(cell, WIDEST) for cell in row] for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(HEADER))]
    lines = ("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) for row in cells)
    return "".join(f"{line.rstrip()}\n" for line in lines)


def _row(each: Diagnosis, lost: Sequence[str]) -> Sequence[str]:
    mended = each.mended or ("not usable" if each.element in lost else "no")
    return each.element, mended, "-" if each.moved is None else f"{each.moved:.3g}", each.defect, each.cure
