"""Numbers of a report read back: their value, and the worth of their last digit."""

from __future__ import annotations

import re
from dataclasses import dataclass

_NUMBER = re.compile(r"(−?)(\d+)(?:([.,])(\d+))?(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@dataclass(frozen=True)
class WrittenNumber:
    """A number as it is read. last_digit: what one unit of its last digit is worth, of a whole number of its zeros."""

    value: float
    last_digit: float


def read_number(text: str, *, point: str = ".") -> WrittenNumber:
    """Return the number that a text begins with; raises ValueError where it begins with none."""
    found = _NUMBER.match(text)
    if found is None or (found[3] is not None and found[3] != point):
        raise ValueError(f"{text!r} does not begin with a number")
    sign, whole, _, decimals, power = found.groups()
    scale = 10.0 ** int((power or "⁰").translate(_RAISED))
    value = float(f"{whole}.{decimals or '0'}") * scale * (-1 if sign else 1)
    zeros = len(whole) - len(whole.rstrip("0")) if decimals is None and value else 0
    return WrittenNumber(value, 10.0 ** (zeros - len(decimals or "")) * scale)
