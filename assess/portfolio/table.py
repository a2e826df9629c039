"""A table of projects as CSV: its header, and its rows one at a time."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from assess.errors import ProjectError

SEPARATORS = (",", ";", "\t")
LONGEST_HEADER = 1_000_000  # characters


@dataclass(frozen=True)
class Line:
    """A row of the table: its cells, stripped, and the line of the file on which it begins."""

    number: int
    cells: tuple[str, ...]


def read_table(path: Path) -> Iterator[Line]:
    """Yield the header and then the rows of a table that are not empty, without holding them.

    Cells are separated by comma, semicolon or tab, whichever the header has most of.

    Raises
    ------
    ProjectError : the file cannot be read, is not UTF-8, or breaks the rules of quotes
    """
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            header = file.readline(LONGEST_HEADER)
            if not header.strip():
                raise ProjectError(f"{path}: line 1: no header; write the keys of the template there")
            separator = max(SEPARATORS, key=header.count)
            file.seek(0)
            yield from _lines(csv.reader(file, delimiter=separator))
    except UnicodeDecodeError as error:
        byte = f"byte {error.object[error.start]:#04x}"
        raise ProjectError(f"{path}: {byte} is not UTF-8; save the table as CSV in UTF-8") from None
    except csv.Error as error:
        raise ProjectError(f"{path}: not a table as CSV ({error}); save it again from the spreadsheet") from None
    except OSError as error:
        raise ProjectError(f"{path}: cannot be read ({error.strerror}); give a table as CSV") from None


def _lines(reader: Iterator[Sequence[str]]) -> Iterator[Line]:
    """Yield the rows with the line on which each begins; one in quotes may go over several."""
    begins = 1
    for cells in reader:
        stripped = tuple(cell.strip() for cell in cells)
        if any(stripped):
            yield Line(begins, stripped)
        begins = reader.line_num + 1  # type: ignore[attr-defined]
