"""The texts of the front matter, as pydantic types: short enough for a page, and nothing that a page cannot show."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable
from datetime import date
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, StrictStr, WithJsonSchema

from assess.project.quantities import unique

LONGEST_LINE = 200  # characters
LONGEST_PARAGRAPH = 1000  # characters
REORDERING = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Characters that show a text in another order than it is written."""


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


def _text_or_date(value: Any) -> Any:
    return value.isoformat() if isinstance(value, date) else value


def _text_or_number(value: Any) -> Any:
    return str(value) if isinstance(value, int) and not isinstance(value, bool) and abs(value) < 10**9 else value


Line = Annotated[StrictStr, AfterValidator(_fits_in(LONGEST_LINE, line_breaks=False))]
"""A text of one line."""

Paragraph = Annotated[StrictStr, AfterValidator(_fits_in(LONGEST_PARAGRAPH, line_breaks=True))]
"""A text of a few lines."""

DateText = Annotated[Line, BeforeValidator(_text_or_date)]
"""A date as TOML has them, or in the user's own words."""

NumberText = Annotated[
    Line, BeforeValidator(_text_or_number), WithJsonSchema({"type": ["string", "integer"], "maxLength": LONGEST_LINE})
]
"""A number that nothing is calculated with, kept as a text."""


def _place_on_earth(value: Any) -> Any:
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


Coordinates = Annotated[
    Line | tuple[float, float],
    BeforeValidator(_place_on_earth),
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


def _listed(value: Any) -> Any:
    """Write a key alone as a list of one, and numbers as texts."""
    listed = value if isinstance(value, list | tuple) else [value]
    return tuple(_text_or_number(each) for each in listed)


_AN_ITEM = {"type": ["string", "integer"]}
ItemKeys = Annotated[
    tuple[Line, ...],
    BeforeValidator(_listed),
    Field(max_length=30),
    AfterValidator(unique("item")),
    WithJsonSchema({"anyOf": [_AN_ITEM, {"type": "array", "items": _AN_ITEM}]}),
]
"""Items of the list of possible mechanisms: one or several, by key, or by number for churches."""
