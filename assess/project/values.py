"""The values of a project file that no declaration reads: texts, paths, units, geographic coordinates, items."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Annotated, Any, TypeVar

from pydantic import AfterValidator, BeforeValidator, Field, PlainValidator, StrictStr, ValidationInfo, WithJsonSchema

from assess.declaration import Evidence, Several
from assess.project.units import KINDS, si_value
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

T = TypeVar("T")
PATTERN_MARK = "pattern of"
"""Stands in the schema of a marked key, with its kind and form, until `with_quantity_patterns` has replaced it."""
LONGEST_LINE = 200  # characters
LONGEST_PARAGRAPH = 1000  # characters
REORDERING = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Characters that show a text in another order than it is written."""


def _one_unit(kind: str, value: Any) -> Any:
    """Read a unit alone, such as "mm", as one of it; a number is the size of the unit in SI already."""
    return si_value(f"1 {value}" if isinstance(value, str) else value, KINDS[kind])


def length_of_unit(text: str) -> float:
    """Return the length [m] of a unit such as "mm"; raise ValueError if it is not a unit of length."""
    length = float(_one_unit("length", text))
    if not 0.0 < length < float("inf"):
        raise ValueError("not a unit of length; write one like mm")
    return length


LengthUnit = Annotated[
    float,
    BeforeValidator(lambda value: _one_unit("length", value)),
    Field(gt=0),
    WithJsonSchema(
        {"type": ["number", "string"], "description": 'a unit of length like "mm"', PATTERN_MARK: ["length", "unit"]}
    ),
]


def _acceleration_unit(text: str) -> str:
    try:
        factor_of(text, known=ACCELERATION_UNITS)
    except ColumnError as error:
        raise ValueError(str(error)) from None
    return text


AccelerationUnit = Annotated[StrictStr, AfterValidator(_acceleration_unit)]


def _folder(info: ValidationInfo) -> Path:
    return Path((info.context or {}).get("folder", "."))


def _an_input_file(value: Any, info: ValidationInfo) -> Path:
    path = _folder(info) / _path_text(value)
    if not path.is_file():
        raise ValueError(f"no such file ({path}); paths are relative to the project file")
    return path


def _path_text(value: Any) -> str:
    if not isinstance(value, str | Path) or not str(value) or "\0" in str(value):
        raise ValueError("not a path; write it in quotes, relative to the project file")
    return str(value)


InputFile = Annotated[
    Path,
    BeforeValidator(_an_input_file),
    WithJsonSchema({"type": "string", "description": "path relative to the project file"}),
]


def _a_path(value: Any, info: ValidationInfo) -> Path:
    return _folder(info) / _path_text(value)


FilePlace = Annotated[
    Path,
    BeforeValidator(_a_path),
    WithJsonSchema({"type": "string", "description": "path relative to the project file"}),
]
"""A file that may not exist yet."""


def _matching(pattern: Any, folder: Path) -> list[Path]:
    """Return the files that a name or pattern matches, sorted; a file or folder of that exact name comes first."""
    text = _path_text(pattern)
    if (folder / text).is_file() or (folder / text).is_dir():
        return [folder / text]
    found = sorted(path for path in map(Path, _glob(text, folder)) if path.is_file())
    if not found:
        raise ValueError(f'"{text}" matches no file in {folder}; paths are relative to the project file')
    return found


def _glob(pattern: str, folder: Path) -> list[str]:
    from glob import escape, glob

    return glob(str(Path(escape(str(folder))) / pattern), recursive=True)


def _files(value: Any, info: ValidationInfo) -> tuple[Path, ...]:
    if not isinstance(value, list | tuple) or not value:
        raise ValueError('not a list of files; write files = ["records/*.AT2"], or leave the key out')
    found = [path for pattern in value for path in _matching(pattern, _folder(info))]
    return tuple(dict.fromkeys(found))


InputFiles = Annotated[
    tuple[Path, ...],
    BeforeValidator(_files),
    WithJsonSchema(
        {
            "type": "array",
            "items": {"type": "string"},
            "minItems": 1,
            "description": "paths, patterns (*, ?, **) or folders relative to the project file",
        }
    ),
]


def _fits_in(most: int, *, line_breaks: bool) -> Callable[[str], str]:
    """Return a check that a text has at most so many characters, each of which can be printed."""

    def check(text: str) -> str:
        if len(text) > most:
            raise ValueError(f"{len(text)} characters; write at most {most}")
        for place, character in enumerate(text, start=1):
            if character == "\n":
                if not line_breaks:
                    raise ValueError("a line break; write it on one line")
            elif character in REORDERING or unicodedata.category(character) in ("Cc", "Cs"):
                raise ValueError(f"character {place} is U+{ord(character):04X}, which cannot be printed; remove it")
        return text

    return check


def text_of_date(value: Any) -> Any:
    """Return a date of TOML as its text, and all else unchanged."""
    return value.isoformat() if isinstance(value, date) else value


def _text_or_number(value: Any) -> Any:
    return str(value) if isinstance(value, int) and not isinstance(value, bool) and abs(value) < 10**9 else value


TextLine = Annotated[StrictStr, AfterValidator(_fits_in(LONGEST_LINE, line_breaks=False))]
"""A text of one line."""
Paragraph = Annotated[StrictStr, AfterValidator(_fits_in(LONGEST_PARAGRAPH, line_breaks=True))]
"""A text of a few lines."""
DateText = Annotated[TextLine, BeforeValidator(text_of_date)]
"""A date as TOML has them, or in the user's own words."""
NumberText = Annotated[
    TextLine,
    BeforeValidator(_text_or_number),
    WithJsonSchema({"type": ["string", "integer"], "maxLength": LONGEST_LINE}),
]
"""A number that nothing is calculated with, kept as a text."""


def _geographic_coordinates(value: Any) -> Any:
    if isinstance(value, str):
        return value
    if not (isinstance(value, list | tuple) and len(value) == 2 and all(map(_is_number, value))):
        raise ValueError("not a place; write [latitude, longitude] in degrees, like [42.351, 13.401], or a text")
    for number, name, most in zip(value, ("latitude", "longitude"), (90.0, 180.0), strict=True):
        if not abs(number) <= most:
            raise ValueError(f"{number:.6g} is no {name}; write one within -{most:.0f} and {most:.0f} degrees")
    return (float(value[0]), float(value[1]))


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


GeographicCoordinates = Annotated[
    TextLine | tuple[float, float],
    BeforeValidator(_geographic_coordinates),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "string", "maxLength": LONGEST_LINE},
                {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
            ]
        }
    ),
]
"""Latitude and longitude [deg], or the user's text."""


def _as_list(value: Any) -> Any:
    """Write a key alone as a list of one, and numbers as texts."""
    listed = value if isinstance(value, list | tuple) else [value]
    return tuple(_text_or_number(each) for each in listed)


CHECKLIST = Evidence(
    "free", "none", "nothing", judged='what is not examined makes the index "at most" and changes no outcome of what is'
)
"""Of the keys that say what is examined of the list of possible mechanisms."""
STRUCK_OUT = Evidence(
    "chosen",
    "up",
    "what it would come to stands beside the verdict; without a reason the file is refused",
    judged="a mechanism that is struck out fails no more: it counts as not examined, and a pass depends on its reason",
)
_AN_ITEM = {"type": ["string", "integer"]}
ItemKeys = Annotated[
    tuple[TextLine, ...],
    BeforeValidator(_as_list),
    Several(most=30, unlike="item"),
    WithJsonSchema({"anyOf": [_AN_ITEM, {"type": "array", "items": _AN_ITEM}]}),
]
"""Items of the list of possible mechanisms: one or several, by key, or by number for churches."""


def number_or_text(remedy: str) -> PlainValidator:
    """Return a check that a value is a number or a text, which is read where it is known what it measures."""

    def check(value: Any) -> Any:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise ValueError(f"not a number or a quantity; {remedy}")
        return value

    return PlainValidator(check)


WRITTEN_QUANTITY_SCHEMA = WithJsonSchema({"type": ["number", "string"]})
WrittenQuantity = Annotated[int | float | str, number_or_text("write it as without scatter"), WRITTEN_QUANTITY_SCHEMA]
