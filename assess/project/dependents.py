"""Which mechanisms a key of the project file changes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from assess.project.keys import Key
from assess.project.section import Section
from assess.project.sections.content import Content
from assess.project.sections.loads import BodyLoad, OverburdenLoad


def dependents(content: Content, path: Key, *, beside: Mapping[str, tuple[str, ...]] | None = None) -> tuple[str, ...]:
    """Return the mechanisms that the value at `path` changes: those that use the body or material, or all of them.

    beside : by mechanism, the bodies that touch it and so affect its direction and sides
    """
    touching = beside or {}
    table, *names = path
    if table == "mechanisms":
        return tuple(name for name in content.mechanisms if name == names[0])
    used = {name: _bodies(mechanism, content) for name, mechanism in content.mechanisms.items()}
    if table == "bodies":
        return tuple(
            name
            for name, bodies in used.items()
            if names[0] in (*bodies, *touching.get(name, ())) or _carries_bodies(content.mechanisms[name])
        )
    if table == "materials":
        of = {name for name, body in content.bodies.items() if getattr(body, "material", None) == names[0]}
        return tuple(name for name, bodies in used.items() if bodies & of)
    return tuple(content.mechanisms)


def _bodies(mechanism: Section, content: Content) -> set[str]:
    """Return the bodies named anywhere in the table of a mechanism: as blocks, floors, overburden."""
    return set(_texts(mechanism)) & set(content.bodies)


def _carries_bodies(mechanism: Section) -> bool:
    """Whether bodies load the mechanism: what they rest on besides may be any other body of the project."""
    loads = getattr(mechanism, "loads", ())
    return any(isinstance(load, BodyLoad) or (isinstance(load, OverburdenLoad) and load.bodies) for load in loads)


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Section | Mapping | tuple):
        table = value.entries() if isinstance(value, Section) else value
        for item in table.values() if isinstance(table, Mapping) else table:
            yield from _texts(item)
