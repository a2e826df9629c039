"""A table of projects as CSV, and the template: the project file whose values its rows change."""

from __future__ import annotations

import csv
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from json import dumps
from pathlib import Path
from typing import Any

from assess.errors import ProjectError

Place = tuple[str | int, ...]
TITLE = "title"
COLUMN_HEADER = re.compile(r"(.*?)\s*(?:\[([^\[\]]*)\])?\s*", re.DOTALL)
WHOLE_NUMBER = re.compile(r"[+-]?\d{1,18}")
NUMBER = re.compile(r"[+-]?(\d{1,40}\.?\d{0,40}|\.\d{1,40})([eE][+-]?\d{1,3})?|[+-]?(inf|nan)")
QUANTITY = re.compile(r"\s*[+-]?(\d|\.\d|inf\b)")
DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+(\s*[^\s\d,;]\S*)?")
MOST_SHOWN = 60  # characters of a value in a message


@dataclass(frozen=True)
class KeyColumn:
    """A column of the table: its key in the template, written with dots, and the unit of its numbers, "" for none."""

    key: str
    unit: str


def read_template(path: Path) -> Mapping[str, Any]:
    """Read the tables of a template.

    Raises
    ------
    ProjectError : it is missing, no TOML, or has no mechanism
    """
    try:
        size, changed = path.stat().st_size, path.stat().st_mtime_ns
    except (OSError, ValueError):
        raise ProjectError(f"{path}: no such file; give the project file whose values the table changes") from None
    return _read_tables(path, size, changed)


@lru_cache(maxsize=4)
def _read_tables(path: Path, size: int, changed: int) -> Mapping[str, Any]:
    """Read a template of that size and time, once in each process."""
    try:
        tables = tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except (OSError, UnicodeDecodeError, ValueError, RecursionError) as error:
        reason = " ".join(str(error).split())
        raise ProjectError(f"{path}: cannot be read as TOML ({reason}); try it with `assess check` first") from None
    if not isinstance(tables.get("mechanisms"), Mapping):
        raise ProjectError(f"{path}: no table [mechanisms.NAME]; a template is a whole project file")
    return tables


def keys_of(template: Mapping[str, Any]) -> dict[str, Place]:
    """Return the keys of all single values of a template, written with dots, each with its place."""
    return {".".join(map(str, place)): place for place in _places(template, ())} | {TITLE: (TITLE,)}


def _places(value: Any, place: Place) -> Iterator[Place]:
    if isinstance(value, Mapping):
        for name, each in value.items():
            yield from _places(each, (*place, name))
    elif isinstance(value, list):
        for number, each in enumerate(value):
            yield from _places(each, (*place, number))
    else:
        yield place


def key_text(place: Place) -> str:
    """Write a key as messages on a project do: items of a list in brackets, from 1."""
    return "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in place).lstrip(".")


def columns_of(header: Sequence[str], template: Mapping[str, Any], *, skipped: Sequence[str]) -> list[KeyColumn | None]:
    """Return the columns of a table's header; None for those that are `skipped`.

    Raises
    ------
    ProjectError : a column has no name, the same as another, or one that is no key of the template
    """
    known, seen = keys_of(template), set[str]()
    found: list[KeyColumn | None] = []
    for number, cell in enumerate(header, 1):
        match = COLUMN_HEADER.fullmatch(cell.strip())
        key, unit = (match[1].strip(), (match[2] or "").strip()) if match else (cell, "")
        if not key:
            raise ProjectError(
                f"column {number}: no name; write a key of the template, such as {quote(_example_key(known))}"
            )
        if key in seen:
            raise ProjectError(f"column {number}: {quote(key)} stands there twice; give each key one column")
        seen.add(key)
        if key in skipped:
            found.append(None)
        else:
            _check_column(key, unit, known, template)
            found.append(KeyColumn(key, unit))
    return found


def _example_key(known: Mapping[str, Place]) -> str:
    return next((key for key in known if key.startswith("bodies.")), TITLE)


def _check_column(key: str, unit: str, known: Mapping[str, Place], template: Mapping[str, Any]) -> None:
    """Raise ProjectError for a key that the template does not have, and for a unit of what has none."""
    if key not in known:
        near = get_close_matches(key, known, n=1, cutoff=0.0)
        below = [each for each in known if each.startswith(f"{key}.")]
        remedy = f"name one of its values, such as {quote(below[0])}" if below else f"do you mean {quote(near[0])}?"
        raise ProjectError(
            f"column {quote(key)}: {'a table or list' if below else 'not a key'} of the template; {remedy}"
        )
    value = _value_at(template, known[key])
    if unit and (isinstance(value, bool) or not (isinstance(value, int | float) or _is_quantity(value))):
        raise ProjectError(
            f"column {quote(key)}: the template has {quote(str(value))} there, which takes no unit; leave out [{unit}]"
        )


def _value_at(tables: Any, place: Place) -> Any:
    for step in place:
        if isinstance(tables, Mapping) and step not in tables:
            return ""
        tables = tables[step]
    return tables


def _is_quantity(value: Any) -> bool:
    """Whether a value of the template is a number with its unit, as text."""
    return isinstance(value, str) and QUANTITY.match(value) is not None


def with_row(template: Mapping[str, Any], cells: Mapping[str, tuple[str, str]]) -> dict[str, Any]:
    """Return the tables of a template with the values of a row.

    Parameters
    ----------
    template : its tables
    cells : by key, the text of the cell and the unit of its column

    Raises
    ------
    ProjectError : a number has a decimal comma
    """
    tables, known = deepcopy(dict(template)), keys_of(template)
    for key, (text, unit) in cells.items():
        place = known[key]
        value = value_of(text, unit, like=_value_at(template, place), key=key)
        holder = _value_at(tables, place[:-1])
        holder[place[-1]] = value
    return tables


def value_of(text: str, unit: str, *, like: Any, key: str) -> Any:
    """Return the value of a cell, of the kind that the template has there.

    Text stays text where the template has text. Elsewhere a number is a number, with the unit of its column, and
    anything else stays as it is written: the project's own check tells whether it may stand there.
    """
    if isinstance(like, bool):
        return {"true": True, "false": False}.get(text.lower(), text)
    if not isinstance(like, int | float) and not _is_quantity(like):
        return text
    if DECIMAL_COMMA.fullmatch(text):
        raise ProjectError(f"{key}: {quote(text)}: a decimal comma; write {text.replace(',', '.')[:MOST_SHOWN]}")
    if NUMBER.fullmatch(text):
        return f"{text} {unit}" if unit else int(text) if WHOLE_NUMBER.fullmatch(text) else float(text)
    return text


def quote(text: str) -> str:
    """Write a text of the user's in quotes on one line, shortened if it is long."""
    written = dumps(text if len(text) <= MOST_SHOWN else text[: MOST_SHOWN - 1] + "…", ensure_ascii=False)
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in written)


SEPARATORS = (",", ";", "\t")
LONGEST_HEADER = 1_000_000  # characters


@dataclass(frozen=True)
class TableRow:
    """A row of the table: its cells, stripped, and the line of the file on which it begins."""

    number: int
    cells: tuple[str, ...]


def read_table(path: Path) -> Iterator[TableRow]:
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


def _lines(reader: Iterator[Sequence[str]]) -> Iterator[TableRow]:
    """Yield the rows with the line on which each begins; one in quotes may go over several."""
    begins = 1
    for cells in reader:
        stripped = tuple(cell.strip() for cell in cells)
        if any(stripped):
            yield TableRow(begins, stripped)
        begins = reader.line_num + 1  # type: ignore[attr-defined]
