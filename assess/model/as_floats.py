"""The numbers of a definition as floats, as a project file gives them."""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from numbers import Real
from typing import Any, TypeVar

D = TypeVar("D")

COUNTS = ("block", "construction", "count")
"""The whole numbers of a definition: which block, which case, how many."""


def with_floats(data: D) -> D:
    """Return a definition whose lengths, masses and the like are floats, where whole or numpy numbers were given."""
    changed = {
        field.name: as_floats(getattr(data, field.name))
        for field in fields(data)  # type: ignore[arg-type]
        if field.init and field.name not in COUNTS
    }
    return replace(data, **changed)  # type: ignore[type-var]


def as_floats(value: Any) -> Any:
    """Return a value with every number in it as a float; truth values and texts stay."""
    if isinstance(value, tuple):
        return tuple(map(as_floats, value))
    if isinstance(value, dict):
        return {key: as_floats(each) for key, each in value.items()}
    if is_dataclass(value) and not isinstance(value, type):
        return with_floats(value)
    return float(value) if isinstance(value, Real) and not isinstance(value, bool) else value
