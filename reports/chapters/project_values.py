"""Values of the project file in words: "6.89 GPa" for a modulus, and one entry for each number of a list of tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from scipy.constants import g

from assess.messages.message import Quantity
from assess.results import Resolved
from reports.document import Cell
from reports.language.texts import Verbatim, listing, say

_FIGURES = 6
DIMENSIONS: Mapping[str, str] = {
    "length": "length",
    "mass": "mass",
    "time": "time",
    "duration": "return period",
    "speed": "velocity",
    "acceleration": "ground acceleration",
    "force": "force",
    "stress": "stress",
    "stiffness per area": "stiffness",
    "density": "density",
    "mass per area": "area density",
    "moment of inertia": "inertia",
    "angle": "angle",
    "frequency": "frequency",
    "rate": "angular frequency",
    "ratio": "ratio",
}
"""The dimension in which each kind of quantity of the project file is shown; accelerations are in g."""


@dataclass(frozen=True)
class Entry:
    """One value: its key with dots, items of lists counted from 1, and its cell."""

    key: str
    cell: Cell


def entries(key: str, resolved: Resolved) -> Iterator[Entry]:
    """Yield a resolved value as cells with their keys: one for each key of a table, none for what is absent."""
    yield from _entries(key, resolved.value, "", resolved.dimensions)


def _entries(key: str, value: object, way: str, kinds: Mapping[str, str]) -> Iterator[Entry]:
    if isinstance(value, Mapping):
        for name, held in value.items():
            yield from _entries(f"{key}.{name}", held, _below(way, name), kinds)
    elif isinstance(value, list | tuple) and any(isinstance(each, Mapping | list | tuple) for each in value):
        for place, held in enumerate(value):
            yield from _entries(f"{key}[{place + 1}]", held, _below(way, str(place)), kinds)
    elif value not in (None, "", [], ()):
        yield Entry(key, _cell(value, kinds.get(way, "")))


def _below(way: str, name: str) -> str:
    return f"{way}.{name}" if way else name


def _cell(value: object, kind: str) -> Cell:
    """Return one value, or a list of plain ones."""
    if isinstance(value, list | tuple):
        return listing([_text(each, kind) for each in value], "")
    return value if isinstance(value, bool) else _text(value, kind)


def _text(value: object, kind: str) -> Quantity | Verbatim:
    if isinstance(value, int) or not isinstance(value, float):
        return Verbatim(str(value))
    number = value / g if kind == "acceleration" else float(value)
    return Quantity(number, DIMENSIONS.get(kind, "ratio"), _FIGURES)


GIVEN, DEFAULT = say("given"), say("default")
