"""The keys of a project file that hold numbers: found, looked up, and given another value."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache, reduce
from typing import Any, get_args

from pydantic.fields import FieldInfo

from assess.errors import ProjectError
from assess.project.bare_numbers import is_number
from assess.project.key_text import escape_text, value_text
from assess.project.section import Section
from assess.project.sections.content import Content
from assess.project.sections.uncertain_number import Uncertain
from assess.project.units import Kind

_NOT_SWEPT = (("analysis", "sweep"), ("analysis", "sensitivity"), ("analysis", "uncertainty"), ("format",), ("report",))
Key = tuple[str | int, ...]
Given = int | float | str
Marks = tuple[Kind | None, Uncertain | None]
UNMARKED: Marks = (None, None)


@dataclass(frozen=True)
class Place:
    """What stands at a key: the value as it was read, what it measures where that is known, whether it may scatter."""

    path: Key
    value: Any
    kind: Kind | None
    uncertain: Uncertain | None = None

    @property
    def is_number(self) -> bool:
        """Whether the key holds a number or could."""
        return self.kind is not None or is_number(self.value)


def places_of(content: Content) -> dict[str, Place]:
    """Return every key of the project, with dots and items of lists counted from 0, defaults included."""
    return {".".join(map(str, place.path)): place for place in _places((), content, UNMARKED)}


def _places(path: Key, value: Any, marks: Marks) -> Iterator[Place]:
    """Yield every key below `path` that may be swept."""
    if path in _NOT_SWEPT:
        return
    if path:
        yield Place(path, value, *marks)
    if isinstance(value, Section):
        below = _marks_of(type(value))
        for name, item in value.entries().items():
            yield from _places((*path, name), item, below[name])
    elif isinstance(value, Mapping):
        for name, item in value.items():
            yield from _places((*path, name), item, UNMARKED)
    elif isinstance(value, tuple):
        for index, item in enumerate(value):
            yield from _places((*path, index), item, marks)


@cache
def _marks_of(table: type[Section]) -> Mapping[str, Marks]:
    """Return the marks of every key of a table, which follow from its class."""
    return {name: _marks(field) for name, field in table.table_keys().items()}


def _marks(field: FieldInfo) -> Marks:
    """Return the quantity that a key holds and whether it may scatter, from its type; None if that is not unique."""
    found = (*field.metadata, *_metadata(field.annotation))
    kinds = {each for each in found if isinstance(each, Kind)}
    uncertain = next((each for each in found if isinstance(each, Uncertain)), None)
    return (kinds.pop() if len(kinds) == 1 else None), uncertain


def _metadata(annotation: Any) -> Iterator[Any]:
    yield from getattr(annotation, "__metadata__", ())
    for part in get_args(annotation):
        yield from _metadata(part)


def place_of(key: str, places: Mapping[str, Place], *, where: str) -> Place:
    """Return the place that a sweep names; raise ProjectError if it does not exist or holds no number."""
    place = places.get(key) or places.get(count_from_0(key))
    if place is not None and (place.is_number or isinstance(place.value, Section)):
        return place
    what = "unknown key" if place is None else "holds no number"
    raise ProjectError(f"{where}.key: {value_text(key)}: {what}; {_remedy(key, places)}")


def _remedy(key: str, places: Mapping[str, Place]) -> str:
    """Say what to write instead of a key that does not exist or holds no number."""
    table, _, last = key.rpartition(".")
    above = places.get(table)
    if last == "angle" and table.endswith(".cut") and above is not None and isinstance(above.value, float):
        return f'its cut is level: write cut = {{ point = [0, 0, {above.value:.6g}], angle = "0 deg" }} first'
    near = get_close_matches(key, [name for name, place in places.items() if place.is_number], n=1)
    remedy = f'did you mean "{escape_text(near[0])}"?' if near else 'name one like "bodies.NAME.box.height"'
    return remedy + (" (loads.0 or loads[1] is the first of a list)" if ".loads" in key else "")


def count_from_0(key: str) -> str:
    """Write a key with dots and items counted from 0; errors print them in brackets, counted from 1."""
    return re.sub(r"\[([1-9][0-9]{0,3})\]", lambda found: f".{int(found[1]) - 1}", key)


def with_value(node: Any, path: Sequence[str | int], value: Any, resolved: Any) -> Any:
    """Return a copy of `node` with `value` at `path`; tables absent from the file are filled in from `resolved`."""
    if not path:
        return value
    step, *rest = path
    if isinstance(resolved, tuple):
        items = list(node) if isinstance(node, list) else list(_plain(resolved))
        items[int(step)] = with_value(items[int(step)], rest, value, resolved[int(step)])
        return items
    table = dict(node) if isinstance(node, Mapping) else {} if node is None else dict(_plain(resolved))
    table[str(step)] = with_value(table.get(str(step)), rest, value, _below(resolved, step))
    return table


def _below(value: Any, step: str | int) -> Any:
    """Take one step down into validated content."""
    return value.entries()[str(step)] if isinstance(value, Section) else value[step]


def _plain(value: Any) -> Any:
    """Write validated content as a file would hold it."""
    if isinstance(value, Section):
        return {key: _plain(item) for key, item in value.entries().items() if item is not None}
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, tuple) else value


def value_at(content: Content, path: Key) -> Any:
    """Return the validated value at a key."""
    return reduce(_below, path, content)


def one_number(value: Any) -> bool:
    """Whether a key holds a number, or a table that spreads one number over its keys, like restitution."""
    if isinstance(value, Section):
        return all(is_number(item) for _, item in value)
    return is_number(value)
