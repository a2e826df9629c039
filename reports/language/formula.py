"""Formulas of one line, as calculation sheets have them: x_e and x_{e,1} have an index, x^2 and x^{-1} a power."""

from __future__ import annotations

import re

_INDEX = re.compile(r"(?<=[^\W\d_])_(?:\{([^{}]+)\}|([^\W_]+(?:,[^\W_]+)*))")
_POWER = re.compile(r"\^(?:\{([^{}]+)\}|([-−]?[\w.]+))")


def mark_up(escaped: str, *, index: tuple[str, str], power: tuple[str, str]) -> str:
    """Put the given marks before and after each index and each power of an escaped formula."""
    lowered = _INDEX.sub(lambda found: f"{index[0]}{found[1] or found[2]}{index[1]}", escaped)
    return _POWER.sub(lambda found: f"{power[0]}{found[1] or found[2]}{power[1]}", lowered)
