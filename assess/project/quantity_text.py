"""A quantity as it is typed: the number in front, the unit behind, in the signs that keyboards and documents have.

Nothing is evaluated: the number is split off by a regular expression, so `9**9**9 m` is a 9 and no unit.
"""

from __future__ import annotations

import re

from assess.errors import ProjectError

LONGEST = 60  # characters
NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d{1,3})?"
_NUMBER = re.compile(rf"\s*({NUMBER})\s*")
_SEPARATED = re.compile(r"([+-]?)(\d*,\d+(?:(?:[.,'_]\d+)| \d{3})*|\d+(?:[.,'_]\d+| \d{3})+)(?![.\d/])")
_GROUPED = re.compile(r"(\d{1,3}(?:,\d{3})+|\d{1,3}(?:\.\d{3})+|\d{1,3}(?:['_ ]\d{3})+)(?:[.,](\d+))?")
_FEET_AND_INCHES = re.compile(r"'[\s-]*\d|(?:ft|feet|foot)[\s-]+\d")
_PLAIN = str.maketrans({
    "−": "-", "‐": "-", "‑": "-", "–": "-", "﹣": "-", "－": "-",  # minus signs, hyphens, an en dash
    "⋅": "·", "∙": "·", "×": "·", "∕": "/", "⁄": "/",
    "º": "°", "˚": "°", "’": "'", "′": "'", "ʹ": "'", "”": '"', "″": '"', "ʺ": '"',
    "\u200b": None, "\u2060": None, "\ufeff": None,  # spaces without width
})  # fmt: skip


class QuantityError(ProjectError):
    """A quantity cannot be read; the text says what is wrong and the remedy, its caller adds the key and the value."""


def number_and_unit(text: str) -> tuple[str, str]:
    """Split a quantity into its number and its unit, both in plain signs; raise QuantityError if it has none."""
    plain = " ".join(text.translate(_PLAIN).split())
    found = _NUMBER.match(plain)
    unit = plain[found.end() :] if found else ""
    fault = "" if len(text) > LONGEST else _separated(plain) or _in_two_units(unit) or _pointless(plain)
    if fault:
        raise QuantityError(fault)
    if len(text) > LONGEST or found is None:
        raise QuantityError("not a number with a unit")
    return found[1], unit


def _separated(text: str) -> str:
    """Say what is wrong with a number that has commas or separated thousands; empty if nothing is."""
    found = _SEPARATED.match(text)
    if found is None or re.fullmatch(r"\d+\.\d+", found[2]):
        return ""
    sign, number, rest = found[1], found[2], text[found.end() :]
    grouped = _GROUPED.fullmatch(number)
    whole, point = (f"{sign}{digits}{rest}" for digits in (re.sub(r"\D", "", number), number.replace(",", ".")))
    if re.fullmatch(r"[1-9]\d{0,2},\d{3}", number):
        return f'a comma that may mean two things; write "{point}" for a decimal comma, "{whole}" for thousands'
    if re.fullmatch(r"\d*,\d+", number):
        return f'a decimal comma; write "{point if number[0] != "," else point.replace(".", "0.", 1)}"'
    if grouped is None:
        return 'more in the number than one decimal point; write it like "1250.5"'
    decimals = f".{grouped[2]}" if grouped[2] else ""
    return f'thousands set apart; write "{sign}{re.sub(r"[^0-9]", "", grouped[1])}{decimals}{rest}"'


def _pointless(text: str) -> str:
    """Say what is wrong with a number that has lost its decimal point behind a zero, like "05 m"; else empty."""
    found = re.match(r"[+-]?0+([0-9][0-9.]*)", text)
    return f'a 0 before the digits; write "{found[1]}", or "0.{found[1]}" if a point was lost' if found else ""


def _in_two_units(unit: str) -> str:
    """Say what is wrong with feet and inches in one quantity."""
    return 'feet and inches in one; write it in one of them, like "4.5 ft"' if _FEET_AND_INCHES.match(unit) else ""
