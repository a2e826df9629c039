"""The table of an office as a file: CSV from any spreadsheet, or a workbook, read row by row as text.

Workbooks are read by openpyxl, the extra `office`; this is its only door here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, datetime, time
from json import dumps
from pathlib import Path
from typing import Any
from zipfile import BadZipFile, ZipFile

from assess.errors import ProjectError
from spectra.columns import ColumnError, csv_rows

SEPARATORS = (",", ";", "\t")
LONGEST_HEADER = 1_000_000  # characters
WORKBOOKS = (".xlsx", ".xlsm")
MOST_PARTS, MOST_UNZIPPED, MOST_COLUMNS = 2_000, 200_000_000, 2_000  # of a workbook: files, bytes, columns
MOST_SHOWN = 60  # characters of a value in a message
DECIMAL_COMMA = re.compile(r"([+-]?[0-9]+),([0-9]+)(?![0-9.,])")
THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2}(\.[0-9]{3})+(?![0-9])|.*\.[0-9]*,|.*,[0-9]*[.,]")


@dataclass(frozen=True)
class TableRow:
    """A row of the table.

    number : of the line of the file on which it begins
    cells : stripped
    decimal_comma : whether its numbers have decimal commas
    """

    number: int
    cells: tuple[str, ...]
    decimal_comma: bool = False


def read_table(path: Path, *, decimal_comma: bool = False) -> Iterator[TableRow]:
    """Yield the header and then the rows of a table that are not empty, without holding them.

    Of a workbook the first sheet is read. Cells of CSV are separated by comma, semicolon or tab, whichever the header
    has most of; between semicolons numbers have decimal commas, as in languages whose spreadsheets write them so.

    Raises
    ------
    ProjectError : the file cannot be read, is not UTF-8, or breaks the rules of quotes
    """
    if path.suffix.lower() in WORKBOOKS:
        yield from _rows_of_workbook(path, decimal_comma)
        return
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            header = file.readline(LONGEST_HEADER)
            if not header.strip():
                raise ProjectError(f"{path}: line 1: no header; write the keys of the template there")
            separator = max(SEPARATORS, key=header.count)
            file.seek(0)
            for begins, cells in csv_rows(file, separator=separator):
                stripped = tuple(cell.strip() for cell in cells)
                if any(stripped):
                    yield TableRow(begins, stripped, decimal_comma or separator == ";")
    except UnicodeDecodeError as error:
        byte = f"byte {error.object[error.start]:#04x}"
        raise ProjectError(f"{path}: {byte} is not UTF-8; save the table as CSV in UTF-8") from None
    except ColumnError as error:
        raise ProjectError(f"{path}: {error}") from None
    except OSError as error:
        raise ProjectError(f"{path}: cannot be read ({error.strerror}); give a table as CSV") from None


def point_for_comma(text: str) -> str:
    """Return a number, with its unit or without, with a decimal point in place of its decimal comma.

    Raises
    ------
    ProjectError : a point in it may part thousands
    """
    if THOUSANDS.match(text):
        raise ProjectError(
            f"{quote(text)}: a point that may part thousands; write the number without it, as 1250 or 1,25"
        )
    return DECIMAL_COMMA.sub(r"\1.\2", text, count=1)


def quote(text: str) -> str:
    """Write a text of the user's in quotes on one line, shortened if it is long."""
    written = dumps(text if len(text) <= MOST_SHOWN else text[: MOST_SHOWN - 1] + "…", ensure_ascii=False)
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in written)


def _rows_of_workbook(path: Path, decimal_comma: bool) -> Iterator[TableRow]:
    """Yield the rows of the first sheet of a workbook; of formulas the values that it was saved with."""
    try:
        from openpyxl import load_workbook
    except ImportError:
        raise ProjectError(
            f"{path}: reading workbooks needs openpyxl, which is not installed; install the extra office "
            '(pip install ".[office]"), or save the table as CSV'
        ) from None
    try:
        with ZipFile(path) as archive:
            parts = archive.infolist()
            if len(parts) > MOST_PARTS or sum(part.file_size for part in parts) > MOST_UNZIPPED:
                raise ProjectError(
                    f"{path}: unzipped it is larger than {MOST_UNZIPPED // 1_000_000} MB; save it as CSV"
                )
        book = load_workbook(path, read_only=True, data_only=True)
        try:
            sheet = book.worksheets[0]
            for number, row in enumerate(sheet.iter_rows(values_only=True, max_col=MOST_COLUMNS), 1):
                cells = tuple(_text_of(value) for value in row)
                if any(cells):
                    yield TableRow(number, cells, decimal_comma)
        finally:
            book.close()
    except ProjectError:
        raise
    except OSError as error:
        raise ProjectError(f"{path}: cannot be read ({error.strerror}); give a workbook or a table as CSV") from None
    except (BadZipFile, KeyError, ValueError, IndexError, TypeError, AttributeError, SyntaxError) as error:
        raise ProjectError(
            f"{path}: no workbook that can be read ({quote(str(error))}); save the table as CSV"
        ) from None


def _text_of(value: Any) -> str:
    """Return the value of a cell as it would stand in CSV: numbers with all their digits, dates as 2026-01-31."""
    match value:
        case None:
            return ""
        case bool():
            return str(value).lower()
        case float() if value.is_integer() and abs(value) < 1e15:
            return str(int(value))
        case datetime() if value.time() == time():
            return value.date().isoformat()
        case datetime() | date() | time():
            return value.isoformat()
    return str(value).strip()
