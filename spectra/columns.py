"""Text files of two columns of numbers with their units in the header: `period [s], acceleration [g]`.

Columns are separated by semicolons, tabs, commas or blanks; with semicolons a decimal comma is understood. Blank
lines and lines that begin with # are skipped. Spectrum tables and record files are both read through here.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, islice, takewhile
from pathlib import Path

import numpy as np

from spectra.arrays import FloatArray, refuse_other_digits
from spectra.gravity import g

TIME_UNITS: Mapping[str, float] = {"s": 1.0, "ms": 1e-3}
ACCELERATION_UNITS: Mapping[str, float] = {"m/s2": 1.0, "g": g, "cm/s2": 0.01, "gal": 0.01, "mm/s2": 1e-3}

SEPARATORS = (";", "\t", ",")
BRACKETS = re.compile(r"\[([^\]]*)\]|\(([^)]*)\)")
DECIMAL_COMMA = re.compile(r"[0-9],[0-9]")
PIECE = 1_000_000  # characters
BATCH = 50_000  # lines that are turned into numbers at once
CONTROL = re.compile(r"[\x00-\x08\x0e-\x1f\x7f]")


class ColumnError(ValueError):
    """A file of columns cannot be read; the text says which file and line, what is wrong and the remedy."""


@dataclass(frozen=True)
class Columns:
    """The two columns of a file.

    header : label of each column as written, "" where the file has no header
    values : one row for each line of numbers, as written [n, 2]
    comments : the lines with # above both
    """

    header: tuple[str, str]
    values: FloatArray
    comments: tuple[str, ...] = ()

    @property
    def units(self) -> tuple[str | None, str | None]:
        """Text in brackets in each label, None where there is none."""
        return unit_of(self.header[0]), unit_of(self.header[1])


def read_columns(path: Path) -> Columns:
    """Return the header and the numbers of the file at `path`.

    Raises ColumnError for a file that is empty, is not text, has a line that is not two numbers, or no numbers.
    """
    text = decode(path.read_bytes(), where=str(path))
    lines = _content_lines(text)
    top = next(lines, None)
    if top is None:
        raise ColumnError(f"{path}: the file is empty; two columns of numbers are expected")
    separator = separator_of(top[1])
    first = split(top[1], separator)
    header = ("", "") if is_row(first) else _header(first, where=f"{path}: line {top[0]}")
    rows = chain([top], lines) if is_row(first) else lines
    values = [_numbers(batch, separator, path=path) for batch in iter(lambda: list(islice(rows, BATCH)), [])]
    if not values:
        raise ColumnError(f"{path}: no numbers below the header; the file is cut short")
    comments = takewhile(lambda line: not line.strip() or line.lstrip().startswith("#"), _iterate_lines(text))
    return Columns(header, np.concatenate(values), tuple(comments))


def decode(data: bytes, *, where: str) -> str:
    """Decode a text file, UTF-8 or Latin-1.

    Parameters
    ----------
    data : content of the file
    where : its name, for errors

    Raises
    ------
    ColumnError : the content is not text
    """
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    if CONTROL.search(text):
        raise ColumnError(
            f"{where}: not a text file; two columns of numbers with their units in the header are expected"
        )
    return text


def csv_rows(lines: Iterable[str], *, separator: str = ",") -> Iterator[tuple[int, list[str]]]:
    """Yield the rows of a table in CSV, each with the number of the line on which it begins.

    Parameters
    ----------
    lines : of the table; a row of which a cell is in quotes may go over several
    separator : between cells

    Raises
    ------
    ColumnError : the rules of quotes are broken, as by one that is never closed and swallows the rows below
    """
    reader, begins = csv.reader(lines, delimiter=separator, strict=True), 1
    while True:
        try:
            cells = next(reader, None)
        except csv.Error as error:
            remedy = "close each quote that opens a cell, and double one that stands within it"
            raise ColumnError(f"line {begins}: not a table in CSV ({error}); {remedy}") from None
        if cells is None:
            return
        yield begins, cells
        begins = reader.line_num + 1


def separator_of(line: str) -> str | None:
    """Return the first of semicolon, tab and comma that `line` holds; None for blanks."""
    return next((mark for mark in SEPARATORS if mark in line.strip()), None)


def split(line: str, separator: str | None) -> list[str]:
    """Split a line into fields, stripped; decimal commas become points where semicolons separate.

    Parameters
    ----------
    line : text without its end
    separator : as `separator_of` finds it; None for blanks
    """
    if separator is None:
        return line.split()
    text = line.replace(",", ".") if separator == ";" else line
    return [field.strip() for field in text.split(separator)]


def is_row(fields: Sequence[str]) -> bool:
    """Return whether every field is a number."""
    try:
        _array(fields)
    except ValueError:
        return False
    return bool(fields)


def unit_of(label: str) -> str | None:
    """Return the unit in brackets or parentheses in a column's label, None where there is none."""
    found = BRACKETS.search(label)
    return None if found is None else (found[1] or found[2] or "").strip() or None


def factor_of(unit: str, *, known: Mapping[str, float]) -> float:
    """Return the factor that converts a unit to SI.

    Parameters
    ----------
    unit : as written, like "cm/s^2"
    known : factors by unit

    Raises
    ------
    ColumnError : the unit is unknown; lists those known
    """
    name = unit.strip().lower().replace(" ", "").replace("²", "2").replace("**", "").replace("^", "")
    name = name.replace("sec", "s").replace("/s/s", "/s2")
    if name not in known:
        raise ColumnError(f'unit "{unit}" is not known; choose one of {", ".join(known)}')
    return known[name]


def _iterate_lines(text: str) -> Iterator[str]:
    """Yield the lines of a text, a piece at a time, for a long file has millions of them."""
    start = 0
    while start < len(text):
        end = text.find("\n", start + PIECE) + 1 or len(text)
        yield from text[start:end].splitlines()
        start = end


def _content_lines(text: str) -> Iterator[tuple[int, str]]:
    """Return the line number and content of every line that is neither blank nor a comment."""
    lines = enumerate(_iterate_lines(text), start=1)
    return ((number, line) for number, line in lines if line.strip() and not line.lstrip().startswith("#"))


def _header(fields: list[str], *, where: str) -> tuple[str, str]:
    """Return both labels of a header line; labels separated by blanks keep their bracketed unit apart."""
    if len(fields) > 2:
        fields = _rejoin_units(fields)
    if len(fields) != 2:
        raise ColumnError(
            f"{where}: {len(fields)} columns in the header; two are expected, like: period [s], acceleration [g]"
        )
    return fields[0], fields[1]


def _rejoin_units(fields: list[str]) -> list[str]:
    """Return fields with each lone `[unit]` put back onto the label before it."""
    joined: list[str] = []
    for field in fields:
        if joined and field[:1] in ("[", "("):
            joined[-1] = f"{joined[-1]} {field}"
        else:
            joined.append(field)
    return joined


def _numbers(rows: list[tuple[int, str]], separator: str | None, *, path: Path) -> FloatArray:
    """Return the numbers of all rows [n, 2]."""
    fields = [split(line, separator) for _, line in rows]
    for (number, line), row in zip(rows, fields, strict=True):
        if len(row) != 2:
            remedy = _decimal_comma_remedy(line) or "two are expected"
            raise ColumnError(f'{path}: line {number}: "{line.strip()[:40]}" has {len(row)} columns; {remedy}')
    try:
        return _array(*fields)
    except ValueError:
        number, line = next(at for at, row in zip(rows, fields, strict=True) if not is_row(row))
        remedy = _decimal_comma_remedy(line) or "write one for each column, without units"
        raise ColumnError(f'{path}: line {number}: "{line.strip()[:40]}" is not two numbers; {remedy}') from None


def _decimal_comma_remedy(line: str) -> str:
    """Return what to do about a line with decimal commas; empty where there is none."""
    return "two are expected, and decimal commas only between semicolons" if DECIMAL_COMMA.search(line) else ""


def _array(*rows: Sequence[str]) -> FloatArray:
    """Return the numbers in rows of as many texts [n, k]."""
    for text in chain.from_iterable(rows):
        refuse_other_digits(text)
    return np.array(rows, dtype=np.float64)
