"""The tables of the project file, as the classes of its schema give them: what the reference of keys is made of."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any, get_args

from pydantic.fields import FieldInfo

from assess.project.evidence import places_below
from assess.project.section import ProjectSection
from assess.project.sections.content import Content

Table = type[ProjectSection]


@dataclass(frozen=True)
class Place:
    """A table and where the file writes it, such as `mechanisms.NAME.loads[]`; `page` is the first step of that."""

    table: Table
    path: str

    @property
    def page(self) -> str:
        return re.split(r"[.\[]", self.path)[0] or "project"


@cache
def places() -> tuple[Place, ...]:
    """Return every table of the project file once, where it is reached first, in the order of the schema."""
    found: dict[Table, Place] = {Content: Place(Content, "")}
    for key, field in Content.table_keys().items():
        for place in _below(key, field.annotation):
            _collect(place, found)
    return tuple(found.values())


def _collect(place: Place, found: dict[Table, Place]) -> None:
    if place.table in found:
        return
    found[place.table] = place
    for key, field in place.table.table_keys().items():
        for below in _below(f"{place.path}.{key}", field.annotation):
            _collect(below, found)


def _below(path: str, annotation: Any) -> Iterator[Place]:
    """Yield the tables that a value may be, or hold."""
    for place, _, table in places_below(path, annotation):
        if table is not None:
            yield Place(table, place)


def is_table(annotation: Any) -> bool:
    """Return whether a type is that of a table."""
    return isinstance(annotation, type) and issubclass(annotation, ProjectSection)


def title(table: Table) -> str:
    """Return what a table is, for a heading: the first sentence of its class up to its first pause."""
    sentence = inspect.cleandoc(table.__doc__ or "").split("\n")[0].rstrip(".")
    return re.split(r"[:;(]|,(?![^{]*\})", sentence)[0].strip()


def form(table: Table) -> tuple[str, str] | None:
    """Return the key whose value tells the forms of a table apart, with that value; None if there is but one form."""
    for key in ("kind", "code", "method"):
        field = table.table_keys().get(key)
        if field is not None and field.is_required():
            return key, " or ".join(f'"{each}"' for each in get_args(field.annotation))
    return None


def keys(table: Table) -> dict[str, FieldInfo]:
    """Return the keys of a table, those that must be given first."""
    known = table.table_keys()
    return dict(sorted(known.items(), key=lambda item: not item[1].is_required()))
