"""A repr of one line for frozen data that hold long arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Sized
from dataclasses import fields, is_dataclass
from enum import Enum
from html import escape
from typing import Any

LONGEST = 160  # characters of the fields that are shown
LONGEST_TEXT = 40  # characters of a text
FEW = 3  # numbers of a tuple that are shown one by one
SCALARS = (float, int, str, type(None))


def html_table(*rows: Sequence[Any]) -> str:
    """Return a small table for a notebook; the first cell of each row heads it, numbers have four figures."""
    cells = (
        "".join(
            f"<{tag}>{escape(f'{value:.4g}' if isinstance(value, float) else str(value))}</{tag}>"
            for tag, value in zip(("th", *("td" for _ in row[1:])), row, strict=True)
        )
        for row in rows
    )
    return f"<table>{''.join(f'<tr>{each}</tr>' for each in cells)}</table>"


class ShortRepr:
    """Base of dataclasses (`repr=False`) whose repr counts the items of arrays and names nested data."""

    __slots__ = ()

    def __repr__(self) -> str:
        shown, length = [], 0
        for each in fields(self):  # type: ignore[arg-type]
            shown.append(f"{each.name}={_brief(getattr(self, each.name))}")
            length += len(shown[-1]) + 2
            if length > LONGEST:
                shown[-1] = "…"
                break
        return f"{type(self).__name__}({', '.join(shown)})"


def _brief(value: Any) -> str:
    """Return a value in a few characters: numbers to six figures, long texts cut, arrays and tables by their size."""
    if isinstance(value, Enum):
        return repr(value.value)
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, str):
        return repr(value if len(value) <= LONGEST_TEXT else f"{value[: LONGEST_TEXT - 1]}…")
    if is_dataclass(value):
        return f"{type(value).__name__}(…)"
    if isinstance(value, tuple) and len(value) <= FEW and all(isinstance(each, SCALARS) for each in value):
        return f"({', '.join(_brief(each) for each in value)}{',' if len(value) == 1 else ''})"
    if hasattr(value, "shape"):
        return f"array{list(value.shape)}"
    if isinstance(value, Sized):
        noun = ("key" if isinstance(value, Mapping) else "item") + ("" if len(value) == 1 else "s")
        return f"<{len(value)} {noun}>"
    return value.__name__ if callable(value) and hasattr(value, "__name__") else repr(value)
