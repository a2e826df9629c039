"""Every key of a project file, with who vouches for its value and which way it helps a wall.

The marks stand where the keys are declared (`assess.declaration.Evidence`); here they are gathered for the manual, for
the tests, and for whoever asks what a verdict hangs on.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import NoneType
from typing import Annotated, Any, get_args, get_origin

from pydantic import Tag
from pydantic.fields import FieldInfo

from assess.declaration import BOUNDS, Evidence, Number
from assess.project.section import OrValue, ProjectSection, UncertainNumber, field_marks
from assess.project.sections.content import Content
from assess.project.units import QuantityKind

Table = type[ProjectSection]
Place = tuple[str, str, Table | None]
"""Where a value stands, the form of the table that it is, and that table; None for what is no table."""


@dataclass(frozen=True)
class Key:
    """A key of the project file.

    path : such as `mechanisms.NAME.loads[].force`; NAME is a name that the user chooses
    forms : of a table with several, those that have it, such as "tie"; empty where all do
    field : as its table declares it
    evidence : None where nobody has said who vouches for it
    """

    path: str
    forms: tuple[str, ...]
    field: FieldInfo
    evidence: Evidence | None

    def __str__(self) -> str:
        return f"{self.path} ({', '.join(self.forms)})" if self.forms else self.path

    @property
    def dimension(self) -> str:
        """The name of the quantity that it holds, such as "length"; empty where it holds none, or several."""
        kinds = {mark.name for mark in field_marks(self.field) if isinstance(mark, QuantityKind)}
        return kinds.pop() if len(kinds) == 1 else ""

    @property
    def bounds(self) -> dict[str, float]:
        """The bounds of its number [SI], by their names in `assess.declaration.BOUNDS`."""
        numbers = [mark for mark in field_marks(self.field) if isinstance(mark, Number)]
        stated = [(name, getattr(each, name)) for name in BOUNDS for each in numbers]
        return {name: bound for name, bound in stated if bound is not None}

    @property
    def required(self) -> bool:
        """Whether it must be given."""
        return self.field.is_required()

    @property
    def default(self) -> Any:
        """What is taken where it is absent; None for nothing, and for what follows from other keys."""
        return None if self.required or self.field.default_factory is not None else self.field.default


def every_key() -> tuple[Key, ...]:
    """Return every key of the project file that holds a value, in the order of its tables.

    The last are those of a number that scatters, { mean, cov }, below any KEY that may.
    """
    return (*_keys_of("", {"": Content}), *_keys_of("KEY", {"": UncertainNumber}))


def meaning_of(key: str) -> str:
    """Return the sentence of the manual on a key of a project, as on `site.limit_state`; empty where there is none."""
    tables: list[Table] = [Content]
    text, steps = "", iter(key.split("."))
    for step in steps:
        name = step.partition("[")[0]
        holding = [table for table in tables if name in table.table_keys()]
        if not holding:
            break
        text = next((said for table in holding if (said := table.meanings().get(name))), "")
        places = [place for table in holding for place in places_below("", table.table_keys()[name].annotation)]
        if any(path.startswith(".NAME") for path, _, _ in places):
            next(steps, None)
        tables = [table for _, _, table in places if table is not None]
    return text


def places_below(path: str, annotation: Any, form: str = "") -> Iterator[Place]:
    """Yield what a key may hold: each table, and each value that is none, with its place and form.

    Parameters
    ----------
    path : of the key
    annotation : its type
    form : of the table that it is, where a union tells its tables apart
    """
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        tags = [mark.tag.strip("<>").removesuffix("Section") for mark in parts[1:] if isinstance(mark, Tag)]
        yield from places_below(path, parts[0], tags[0] if tags else form)
    elif isinstance(annotation, type) and issubclass(annotation, ProjectSection):
        yield path, form, annotation
    elif origin is dict:
        yield from places_below(f"{path}.NAME", parts[1], form)
    elif origin is tuple and _holds_tables(parts):
        for part in parts:
            yield from () if part is Ellipsis else places_below(f"{path}[]", part, form)
    elif parts and _holds_tables(parts):
        for part in parts:
            yield from places_below(path, part, form)
    elif annotation is not NoneType:
        yield path, form, None


def _holds_tables(annotations: tuple[Any, ...]) -> bool:
    return any(table is not None for part in annotations for _, _, table in places_below("", part))


def _keys_of(path: str, tables: Mapping[str, Table]) -> Iterator[Key]:
    """Yield the keys of the forms of a table, each followed by those of the tables that it holds."""
    for name in dict.fromkeys(name for table in tables.values() for name in table.table_keys()):
        having = {form: table.table_keys()[name] for form, table in tables.items() if name in table.table_keys()}
        values: dict[str, list[Key]] = {}
        below: dict[str, dict[Table, list[str]]] = {}
        for form, field in having.items():
            evidence = tables[form].evidence_of_keys().get(name)
            places = list(places_below(f"{path}.{name}".lstrip("."), field.annotation))
            several = len({table for _, _, table in places if table is not None}) > 1
            for place, inner, table in places:
                if table is None:
                    values.setdefault(place, []).append(Key(place, (form,), field, evidence))
                else:
                    for mark in field_marks(field):
                        if isinstance(mark, OrValue):
                            said = next(iter(table.evidence_of_keys().values()), None)
                            values.setdefault(place, []).append(Key(place, (form,), mark.field, said))
                    below.setdefault(place, {}).setdefault(table, []).append((several and inner) or form)
        for keys in values.values():
            yield from _merge_alike(keys, tuple(tables))
        for place, held in below.items():
            yield from _keys_of(place, {", ".join(dict.fromkeys(forms)): table for table, forms in held.items()})


def _merge_alike(keys: list[Key], forms: tuple[str, ...]) -> Iterator[Key]:
    """Yield one key for the forms of a table that say the same of it; forms : all that the table has."""
    left = list(keys)
    while left:
        first, alike = left[0], _statement_of(left[0])
        same = tuple(dict.fromkeys(each.forms[0] for each in left if _statement_of(each) == alike))
        left = [each for each in left if _statement_of(each) != alike]
        yield Key(first.path, () if same == forms else same, first.field, first.evidence)


def _statement_of(key: Key) -> tuple[Any, ...]:
    return key.dimension, key.bounds, key.required, key.default, key.evidence
