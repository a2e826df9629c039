"""The numbers of a text file, parsed with the line of what is wrong."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import isfinite
from pathlib import Path

import numpy as np

from assess.messages.message import Message
from records.errors import RecordError
from records.formats.layout import check_layout
from spectra.arrays import FloatArray
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

TOUCHING = re.compile(r"(?<=[0-9.])(?=[-+])")
BATCH = 20_000  # lines that are turned into numbers at once
NUMERIC = re.compile(r"[\s0-9.eEdD+-]+")


def text_lines(path: Path) -> list[str]:
    """Return the lines of the file at `path`, Latin-1, without their ends and the mark by which DOS ends a text.

    Lines end with a line feed, or with carriage returns where there is none, as on old Macintoshes.
    """
    text = path.read_bytes().rstrip(b"\x1a").decode("latin-1")
    return [line.rstrip("\r") for line in text.split("\n" if "\n" in text else "\r")]


def numbers(lines: Sequence[str], *, first: int, path: Path) -> FloatArray:
    """Return all numbers in `lines` [n]; blanks separate them, and a sign ends the number before it.

    `first` is the number of the first of these lines in the file, from 1. RecordError names the line of a field that
    is not a number.
    """
    parts = [_parsed("\n".join(lines[i : i + BATCH])) for i in range(0, len(lines), BATCH)]
    held = [part for part in parts if part is not None]
    if len(held) < len(parts):
        raise RecordError(f"{path}: {_first_bad(lines, first=first)}")
    return np.concatenate([np.empty(0), *held])


def _parsed(text: str) -> FloatArray | None:
    """Return all numbers in a text; None where a field is not a number."""
    for separated in (text.split(), TOUCHING.sub(" ", text).split()):
        try:
            return np.array(separated, dtype=np.float64)
        except ValueError:
            continue
    return None


def uniform_numbers(lines: Sequence[str], *, first: int, path: Path) -> tuple[FloatArray, Message | None]:
    """Return all numbers in `lines`, and a warning about uneven columns; refuse one printed otherwise."""
    values = numbers(lines, first=first, path=path)
    return values, check_layout(lines, first=first, path=path)


def numeric_end(lines: Sequence[str], start: int) -> int:
    """Return the index of the first line from `start` on that does not look like numbers alone or blank."""
    return next((i for i in range(start, len(lines)) if not NUMERIC.fullmatch(lines[i])), len(lines))


def count(text: str, *, name: str, line: int, path: Path) -> int:
    """Return a count of samples of at most nine digits."""
    if not re.fullmatch(r"\d{1,9}", text.strip()):
        raise RecordError(
            f'{path}: line {line}: {name} = "{text.strip()[:20]}"; it must be a count of samples below 1e9'
        )
    return int(text)


def positive_number(text: str, *, name: str, line: int, path: Path) -> float:
    """Return a finite number above zero."""
    value = number(text)
    if value is None or value <= 0.0:
        raise RecordError(f'{path}: line {line}: {name} = "{text.strip()[:20]}"; it must be a number above zero')
    return value


def number(text: str, *, unknown: Sequence[float] = ()) -> float | None:
    """Return the finite number in `text`; None where it is not one, or one of those that mean `unknown`."""
    try:
        value = float(text)
    except ValueError:
        return None
    return value if isfinite(value) and value not in unknown else None


def acceleration_factor(unit: str, *, line: int, path: Path) -> float:
    """Return what accelerations in `unit` are multiplied by for m/s2."""
    try:
        return factor_of(unit, known=ACCELERATION_UNITS)
    except ColumnError as error:
        raise RecordError(f"{path}: line {line}: {error}") from None


def _first_bad(lines: Sequence[str], *, first: int) -> str:
    """Say where the first field is that is not a number."""
    for at, line in enumerate(lines, start=first):
        for field in TOUCHING.sub(" ", line).split():
            try:
                float(field)
            except ValueError:
                return f'line {at}: "{field[:20]}" is not a number'
    return "the accelerations are not all numbers"
