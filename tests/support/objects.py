"""What stands within data of the program, wherever it stands."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import TypeVar

T = TypeVar("T")


def objects_in(data: object, kind: type[T]) -> Iterator[T]:
    """Yield every object of a class within data, those that stand in others of the class too."""
    if isinstance(data, kind):
        yield data
    if is_dataclass(data):
        parts: tuple[object, ...] = tuple(getattr(data, each.name) for each in fields(data))
    elif isinstance(data, dict):
        parts = tuple(data.values())
    else:
        parts = tuple(data) if isinstance(data, tuple | list) and not (data and isinstance(data[0], float)) else ()
    for each in parts:
        yield from objects_in(each, kind)
