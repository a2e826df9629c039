"""Values of the project file, as the results hold them: by key, as cells with units, and by mechanism.

A modulus becomes "6.89 GPa", and a list of tables one value for each of its numbers.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from assess.messages.message import Quantity
from assess.results import ResolvedValue, Results
from reports.document import Cell
from reports.language.texts import Verbatim, listing
from spectra.gravity import g


def project_text(results: Results, key: str) -> str:
    """Return a resolved text of the project.

    Parameters
    ----------
    results : of a run
    key : of the project file, as "report.units"

    Returns
    -------
    Empty where it is not given.
    """
    found = results.project.get(key)
    return "" if found is None or found.value is None else str(found.value)


_FIGURES = 6

KIND_DIMENSIONS: Mapping[str, str] = {
    "length": "length",
    "area": "area",
    "mass": "mass",
    "time": "time",
    "duration": "return period",
    "speed": "velocity",
    "acceleration": "ground acceleration",
    "force": "force",
    "stress": "stress",
    "stiffness": "spring stiffness",
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
class ProjectValue:
    """One value: its key with dots, items of lists counted from 1, and its cell."""

    key: str
    cell: Cell


def project_values(key: str, resolved: ResolvedValue) -> Iterator[ProjectValue]:
    """Yield a resolved value as cells with their keys: one for each key of a table, none for what is absent."""
    yield from _values_below(key, resolved.value, "", resolved.dimensions)


MECHANISMS = "mechanisms."


def split_key(results: Results, key: str) -> tuple[str, str]:
    """Return the mechanism that a key belongs to and its key in there; empty and the whole key for no one's."""
    rest = key.removeprefix(MECHANISMS) if key.startswith(MECHANISMS) else ""
    names = [each.name for each in results.mechanisms]
    found = [name for name in names if rest == name or rest.startswith((f"{name}.", f"{name}["))]
    owner = max(found, key=len, default="")
    return (owner, rest.removeprefix(owner).removeprefix(".")) if owner else ("", key)


def starred_key(results: Results, key: str) -> tuple[str, str]:
    """Return the mechanism that a key belongs to, and the key with * in its place; empty and the key for no one's."""
    owner, rest = split_key(results, key)
    return (owner, f"{MECHANISMS}*.{rest}".removesuffix(".")) if owner else ("", key)


def _values_below(key: str, value: object, path: str, kinds: Mapping[str, str]) -> Iterator[ProjectValue]:
    if isinstance(value, Mapping):
        for name, below in value.items():
            yield from _values_below(f"{key}.{name}", below, _joined(path, name), kinds)
    elif isinstance(value, list | tuple) and any(isinstance(each, Mapping | list | tuple) for each in value):
        for place, below in enumerate(value):
            yield from _values_below(f"{key}[{place + 1}]", below, _joined(path, str(place)), kinds)
    elif value not in (None, "", [], ()):
        yield ProjectValue(key, _cell(value, kinds.get(path, "")))


def _joined(path: str, name: str) -> str:
    return f"{path}.{name}" if path else name


def _cell(value: object, kind: str) -> Cell:
    """Return one value, or a list of plain ones."""
    if isinstance(value, list | tuple):
        return listing([_text(each, kind) for each in value], "")
    return value if isinstance(value, bool) else _text(value, kind)


def _text(value: object, kind: str) -> Quantity | Verbatim:
    if isinstance(value, int) or not isinstance(value, float):
        return Verbatim(str(value))
    number = value / g if kind == "acceleration" else float(value)
    return Quantity(number, KIND_DIMENSIONS[kind or "ratio"], _FIGURES)
