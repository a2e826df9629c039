"""One difference between two runs, and when two values count as equal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isclose
from typing import Any, Literal, get_args

Kind = Literal[
    "verdict", "mechanism", "capacity", "ratio", "envelope", "history", "parameter", "sweep", "sensitivity",
    "uncertainty", "other", "suite", "site", "project", "input", "warning", "program",
]  # fmt: skip
KINDS: tuple[Kind, ...] = get_args(Kind)
TOLERANCE = 1e-6  # relative: differences of rounding
ZERO = 1e-12  # numbers nearer to 0 are 0


@dataclass(frozen=True)
class Change:
    """One difference.

    kind : subject; where : the mechanism or file; what : the procedure, parameter or key
    before, after : values as in results.json, None where a run has none; unit : of numbers, empty if dimensionless
    """

    kind: Kind
    where: str
    what: str
    before: Any
    after: Any
    unit: str = ""

    @property
    def relative(self) -> float | None:
        """after / before - 1 of two numbers; None if either is not a number or `before` is 0."""
        if not (is_number(self.before) and is_number(self.after)) or self.before == 0:
            return None
        return float(self.after / self.before - 1.0)


def same(one: Any, other: Any, *, tolerance: float) -> bool:
    """Return whether two values of a results file are equal but for rounding; lists and tables item by item."""
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(one[key], other[key], tolerance=tolerance) for key in one)
    if isinstance(one, list | tuple) and isinstance(other, list | tuple):
        items = zip(one, other, strict=False)
        return len(one) == len(other) and all(same(a, b, tolerance=tolerance) for a, b in items)
    if is_number(one) and is_number(other):
        return isclose(one, other, rel_tol=tolerance, abs_tol=ZERO)
    return type(one) is type(other) and bool(one == other)


def is_number(value: Any) -> bool:
    """Return whether a value is a number; True and False are not."""
    return isinstance(value, int | float) and not isinstance(value, bool)
