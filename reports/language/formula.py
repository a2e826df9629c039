"""Formulas of one line, as calculation sheets have them: x_e and x_{e,1} have an index, x^2 and x^{-1} a power."""

from __future__ import annotations

import re
from typing import Literal

Kind = Literal["", "index", "power"]
_INDEX = re.compile(r"(?<=[^\W\d_])_(?:\{([^{}]+)\}|([^\W_]+(?:,[^\W_]+)*))")
_POWER = re.compile(r"\^(?:\{([^{}]+)\}|([-−]?[\w.]+))")
_MARKS = re.compile("([\x01-\x03])")
_BEGINS: dict[str, Kind] = {"\x01": "index", "\x02": "power"}


def mark_up(escaped: str, *, index: tuple[str, str], power: tuple[str, str]) -> str:
    """Put the given marks before and after each index and each power of an escaped formula."""
    lowered = _INDEX.sub(lambda found: f"{index[0]}{found[1] or found[2]}{index[1]}", escaped)
    return _POWER.sub(lambda found: f"{power[0]}{found[1] or found[2]}{power[1]}", lowered)


def split_formula(text: str) -> list[tuple[str, Kind]]:
    """Split a formula without control characters into parts on the line, lowered and raised."""
    made: list[tuple[str, Kind]] = []
    kinds: list[Kind] = [""]
    for part in _MARKS.split(mark_up(text, index=("\x01", "\x03"), power=("\x02", "\x03"))):
        if part in _BEGINS:
            kinds.append(_BEGINS[part])
        elif part == "\x03":
            kinds.pop()
        elif part:
            made.append((part, kinds[-1]))
    return made
