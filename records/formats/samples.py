"""The numbers of a text file, parsed with the line of what is wrong, and whether all are printed alike.

Programs print accelerations with one format, so that every number has the same decimals and every line the same
columns. A number that is printed otherwise has lost characters, and so has a line whose columns are elsewhere.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import isfinite
from pathlib import Path
from typing import NamedTuple, TypeVar

import numpy as np

from assess.messages.message import Message, warning, whole_number
from records.errors import RecordError
from spectra.arrays import FloatArray, plain_float
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

TOUCHING = re.compile(r"(?<=[0-9.])(?=[-+])")
LINES_AT_ONCE = 20_000
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
    parts = [_parse_numbers("\n".join(lines[i : i + LINES_AT_ONCE])) for i in range(0, len(lines), LINES_AT_ONCE)]
    held = [part for part in parts if part is not None]
    if len(held) < len(parts):
        raise RecordError(f"{path}: {_first_bad(lines, first=first)}")
    return np.concatenate([np.empty(0), *held])


def _parse_numbers(text: str) -> FloatArray | None:
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
    if not re.fullmatch(r"[0-9]{1,9}", text.strip()):
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
        value = plain_float(text)
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
                plain_float(field)
            except ValueError:
                return f'line {at}: "{field[:20]}" is not a number'
    return "the accelerations are not all numbers"


UNIFORM = 0.99  # of the lines, from which on a format is one
FEW = 3  # lines or numbers that show a format
SHAPE = str.maketrans("123456789eDd\t", "000000000EEE ")
ZERO = re.compile(r"[-+]?(0+\.?0*|\.0+)([EeDd][-+]?\d+)?")
FIELD = re.compile(r"[-+]?\d*(\.\d*)?(E[-+]?\d+)?")
T = TypeVar("T")
Printed = tuple[int, int]  # decimals and digits of the exponent, -1 without a point or exponent


class LineFormat(NamedTuple):
    """How a line is printed: the column in which each number ends, and its decimals and digits of the exponent."""

    ends: tuple[int, ...]
    printed: tuple[Printed, ...]


def check_layout(lines: Sequence[str], *, first: int, path: Path) -> Message | None:
    """Refuse a number that is printed otherwise than all the others; return a warning about columns that are uneven.

    Files without one format get no warning, and a 0 may be printed in any way, unless it is the
    last number. `first` is the number of the first line in the file.
    """
    counts = Counter(_shapes(lines))
    forms = {shape: _line_format(shape) for shape in counts}
    usual = _most(
        ((printed, number) for shape, number in counts.items() for printed in forms[shape].printed),
        of=sum(number * len(forms[shape].printed) for shape, number in counts.items()),
    )
    if usual is None:
        return None
    for where, field in _odd_fields(lines, forms, usual):
        if not ZERO.fullmatch(field) or not any(map(str.strip, lines[where + 1 :])):
            raise RecordError(
                f'{path}: line {first + where}: "{field[:30]}" is not printed like the others, with {_words(usual)}; '
                "characters are lost, get the file again"
            )
    at = _uneven(lines, counts, forms)
    return None if at is None else warning("columns-uneven", line=whole_number(first + at))


def _shapes(lines: Sequence[str]) -> Iterator[str]:
    """Yield each line with 0 for every digit and E for every mark of an exponent."""
    for i in range(0, len(lines), LINES_AT_ONCE):
        yield from "\n".join(lines[i : i + LINES_AT_ONCE]).translate(SHAPE).split("\n")


def _line_format(shape: str) -> LineFormat:
    found = [each for each in FIELD.finditer(shape) if each[0]]
    return LineFormat(
        tuple(each.end() for each in found),
        tuple((len(each[1] or "") - 1, len(each[2].lstrip("E+-")) if each[2] else -1) for each in found),
    )


def _uneven(lines: Sequence[str], counts: Mapping[str, int], forms: Mapping[str, LineFormat]) -> int | None:
    """Return the index of the first line whose numbers end in other columns; the last line may be shorter."""
    held = sum(number for shape, number in counts.items() if forms[shape].ends)
    ends = _most(((forms[shape].ends, number) for shape, number in counts.items() if forms[shape].ends), of=held - 1)
    if ends is None:
        return None
    odd = {shape for shape, form in forms.items() if form.ends != ends[: len(form.ends)]}
    short = {shape for shape, form in forms.items() if form.ends and form.ends != ends} - odd
    last = next(i for i in range(len(lines) - 1, -1, -1) if lines[i].strip())
    found = _line_of(lines, odd)
    return _line_of(lines[:last], short) if found is None else found


def _line_of(lines: Sequence[str], shapes: set[str]) -> int | None:
    """Return the index of the first line of one of the `shapes`."""
    return next((i for i, shape in enumerate(_shapes(lines)) if shape in shapes), None) if shapes else None


def _most(counted: Iterable[tuple[T, int]], *, of: int) -> T | None:
    """Return what makes up nearly all `of` them, or all but one where they are few."""
    sums: Counter[T] = Counter()
    for thing, number in counted:
        sums[thing] += number
    return next((thing for thing, number in sums.most_common(1) if number >= max(min(UNIFORM * of, of - 1), FEW)), None)


def _odd_fields(lines: Sequence[str], forms: Mapping[str, LineFormat], usual: Printed) -> Iterator[tuple[int, str]]:
    """Yield the numbers that are not printed as usual, with the index of their line."""
    odd = {shape for shape, form in forms.items() if any(each != usual for each in form.printed)}
    for at, shape in enumerate(_shapes(lines) if odd else ()):
        if shape in odd:
            starts = (0, *forms[shape].ends)
            for start, end, printed in zip(starts, forms[shape].ends, forms[shape].printed, strict=False):
                if printed != usual:
                    yield at, lines[at][start:end].split()[-1]


def _words(usual: Printed) -> str:
    decimals, exponent = usual
    return f"{max(decimals, 0)} decimals" + ("" if exponent < 0 else f" and {exponent} digits of the exponent")
