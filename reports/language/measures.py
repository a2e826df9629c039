"""Numbers with a unit in the texts of a document: kept whole until it is written, and rounded once, in its units.

A number is a word of letters and digits between two signs that no text has (Unicode noncharacters), with its value,
unit, figures and style; a unit is another such word. `in_units` turns them into what is read, last of all, so that no
text is ever searched for numbers and texts of the user stay as they are.
"""

from __future__ import annotations

import json
import re
import struct
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Literal

from reports.document import Document
from reports.language.customary import customary
from reports.language.document_texts import map_texts
from reports.language.numerals import as_given, numeral

Units = Literal["SI", "US"]
Style = Literal["plain", "aligned", "round", "typed"]
LEAST, MOST = 3, 6  # significant figures in US units of a number shown as it was typed
_OPEN, _CLOSE = "\ufdd0", "\ufdd1"
_WORD = re.compile(rf"{_OPEN}([0-9a-f]*)_([0-9a-f]+)_?(\d*)([a-z]*){_CLOSE}")
_CUT = re.compile(rf"{_OPEN}\w*(?=…)")
_IN_SI: Mapping[str, Callable[[float, int], str]] = {
    "plain": lambda value, figures: f"{value:.{figures}g}",
    "aligned": lambda value, figures: numeral(value, digits=figures),
    "round": lambda value, figures: as_given(float(f"{value:.{figures}g}")),
    "typed": lambda value, figures: json.dumps(int(value) if value.is_integer() and abs(value) < 1e15 else value),
}
"""How a number is written in SI, by style: 4.77, 4.770, 4770, and to its last digit; in US units it is aligned, or
typed without zeros at its end."""


def measure(value: float, unit: str, *, figures: int, style: Style = "plain") -> str:
    """Return a number with its unit."""
    return f"{number(value, unit, figures=figures, style=style)} {unit_word(unit)}"


def measures(values: Sequence[float], unit: str, *, figures: int, between: str) -> str:
    """Return several numbers, with their unit once."""
    return f"{between.join(number(value, unit, figures=figures) for value in values)} {unit_word(unit)}"


def number(value: float, unit: str, *, figures: int, style: Style = "plain") -> str:
    """Return a number whose unit is given elsewhere."""
    if customary(unit) is None:
        return _IN_SI[style](float(value), figures)
    return f"{_OPEN}{struct.pack('>d', value).hex()}_{unit.encode().hex()}_{figures}{style}{_CLOSE}"


def unit_word(unit: str) -> str:
    """Return a unit alone."""
    return unit if customary(unit) is None else f"{_OPEN}_{unit.encode().hex()}{_CLOSE}"


def as_typed(value: object, unit: str) -> str:
    """Return a number, or lists of numbers, as a project file gives them, without the unit."""
    if isinstance(value, list | tuple):
        return f"[{', '.join(as_typed(each, unit) for each in value)}]"
    if isinstance(value, bool) or not isinstance(value, int | float):
        return json.dumps(value, ensure_ascii=False, default=str)
    digits = len(re.sub(r"\D", "", json.dumps(value).partition("e")[0]).lstrip("0"))
    return number(float(value), unit, figures=min(max(LEAST, digits), MOST), style="typed")


def in_units(document: Document, units: Units) -> Document:
    """Return the document with the numbers of its texts in these units."""
    return map_texts(document, partial(render_measures, units=units))


def render_measures(text: str, *, units: Units) -> str:
    """Return a text with its numbers and units as they are read."""
    if _OPEN not in text:
        return text
    return _CUT.sub("", _WORD.sub(partial(_render_measure, units=units), text))


def _render_measure(found: re.Match[str], *, units: Units) -> str:
    """Return one number or unit in words."""
    packed, unit, figures, style = found.groups()
    name = bytes.fromhex(unit).decode()
    other = customary(name) if units == "US" else None
    if not packed:
        return name if other is None else other.unit
    (value,) = struct.unpack(">d", bytes.fromhex(packed))
    if other is None:
        return _IN_SI[style](value, int(figures))
    if style == "typed":
        return as_given(float(f"{value * other.factor:.{figures}g}"))
    return numeral(value * other.factor, digits=int(figures))
