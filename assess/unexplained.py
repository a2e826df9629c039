"""What differs between two runs though nothing that `assess diff` compares does: curves, histories, spectra, steps.

They follow from what is compared, and are left out where that differs. A file that was changed by hand or by a fault
is another matter: where nothing else is told of a mechanism or a table, each of its parts is compared number by number.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from typing import Any, NamedTuple

from assess.results import Results

TABLES = ("spectrum", "records", "ground_motion", "critical", "comparison", "sweeps", "sensitivity", "warnings")
"""Parts of the results beside the mechanisms, but for what is compared whole."""

Same = Callable[[Any, Any], bool]


class Difference(NamedTuple):
    """The first of the values of one part that differ; place: in that part; many: how many do."""

    part: str
    place: str
    many: int
    before: Any
    after: Any


def of_mechanism(one: Any, other: Any, alike: Same) -> Iterator[Difference]:
    """The parts of a mechanism that differ."""
    for field in fields(one):
        yield from _of_part(field.name, getattr(one, field.name), getattr(other, field.name), alike)


def of_tables(before: Results, after: Results, alike: Same, *, without: frozenset[str]) -> Iterator[Difference]:
    """The parts of the results beside the mechanisms that differ, but for those named."""
    for name in TABLES:
        if name not in without:
            yield from _of_part(name, getattr(before, name), getattr(after, name), alike)


def _of_part(part: str, one: Any, other: Any, alike: Same) -> Iterator[Difference]:
    found = list(_leaves(part, one, other, alike))
    if found:
        yield Difference(part, found[0][0], len(found), *found[0][1:])


def _leaves(place: str, one: Any, other: Any, alike: Same) -> Iterator[tuple[str, Any, Any]]:
    """The places at which two values differ, from 1 in lists; a list of another length is one of them."""
    if one == other:
        return
    first, second = _opened(one), _opened(other)
    if first is None or second is None or first.keys() != second.keys():
        if first is not None and second is not None:
            yield f"{place}: entries", len(first), len(second)
        elif not alike(one, other):
            yield place, _told(one), _told(other)
        return
    for key in first:
        yield from _leaves(
            f"{place}[{key}]" if isinstance(key, int) else f"{place}.{key}", first[key], second[key], alike
        )


def _opened(value: Any) -> Mapping[str | int, Any] | None:
    """What a value holds by its keys; None of a single one."""
    if is_dataclass(value):
        return {field.name: getattr(value, field.name) for field in fields(value)}
    if isinstance(value, list | tuple):
        return dict(enumerate(value, start=1))
    return value if isinstance(value, Mapping) else None


def _told(value: Any) -> Any:
    """A number or text as it is, of more than that whether there is any."""
    return value if value is None or isinstance(value, int | float | str) else "present"
