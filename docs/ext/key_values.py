"""What a key of the project file may hold, in words: its unit, its choices, its bounds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import WithJsonSchema
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from assess.declaration import Number, Scatters
from assess.project.units import QuantityKind
from docs.ext.markdown import capital, heading_link
from docs.ext.schema_tables import Table, form, is_table, title

PLAIN: dict[Any, str] = {
    str: "text",
    int: "whole number",
    float: "number",
    bool: "`true` or `false`",
    Path: "path, relative to the project file",
    Any: "any value",
}
BOUNDS = {"above": "above", "least": "at least", "below": "below", "most": "at most"}
"""The bounds of a number by their names in `assess.declaration.BOUNDS`, in words."""


def value_words(field: FieldInfo) -> str:
    """Return what a key may hold, as Markdown."""
    words = _words(field.annotation, tuple(field.metadata))
    marks = _flat((*field.metadata, *_nested(field.annotation)))
    return f"{words}; or `{{ mean, cov }}`" if any(isinstance(mark, Scatters) for mark in marks) else words


def default_words(field: FieldInfo) -> str:
    """Return what is taken where the key is absent, as Markdown."""
    if field.is_required():
        return "**required**"
    value = field.default
    if value is None or value is PydanticUndefined or value in ("", ()):
        return "–"
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    if isinstance(value, str | int):
        return f"`{_toml(value)}`"
    if isinstance(value, tuple):
        return f"`[{', '.join(map(_toml, value))}]`"
    kind = next((mark for mark in _flat(field.metadata) if isinstance(mark, QuantityKind)), None)
    unit = f" {symbol(kind)}" if kind is not None and symbol(kind) else ""
    return f"{value:g}{unit}" if isinstance(value, float) else "–"


def _words(annotation: Any, marks: tuple[Any, ...] = ()) -> str:
    if get_origin(annotation) is Annotated:
        inner, *more = get_args(annotation)
        return _words(inner, (*marks, *more))
    marks = tuple(_flat(marks))
    if is_table(annotation):
        return f"table: {_link(annotation, title(annotation))}"
    for mark in marks:
        if isinstance(mark, QuantityKind):
            return _quantity(mark) + _bounds(marks)
    for mark in marks:
        if isinstance(mark, WithJsonSchema) and "description" in (mark.json_schema or {}):
            return str(mark.json_schema["description"]) if mark.json_schema else ""
    return _form(annotation) + _bounds(marks)


def _form(annotation: Any) -> str:
    """Return the words of a type without marks of its own."""
    origin, arguments = get_origin(annotation), get_args(annotation)
    if origin is Literal:
        return " or ".join(f"`{_toml(each)}`" for each in arguments)
    if origin is tuple:
        several = arguments[-1] is Ellipsis
        each = _words(arguments[0])
        return f"list of {each}" if several else f"list of {len(arguments)}: {each}"
    if origin is dict:
        return f"for each name: {_words(arguments[1])}"
    if origin in (Union, UnionType):
        return _tables_by_form(arguments) or " or ".join(
            dict.fromkeys(_words(each) for each in arguments if each is not NoneType)
        )
    return PLAIN.get(annotation, "value")


def _tables_by_form(arguments: tuple[Any, ...]) -> str:
    """Return the forms of a table by the key that tells them apart; "" unless all have it."""
    tables = [get_args(each)[0] if get_origin(each) is Annotated else each for each in arguments]
    forms = [form(each) if is_table(each) else None for each in tables]
    if len(tables) < 3 or None in forms[1:]:
        return ""
    named = [title(each) if each_form is None else each_form[1] for each, each_form in zip(tables, forms, strict=True)]
    links = [_link(each, name) for name, each in zip(named, tables, strict=True)]
    key = next(each[0] for each in forms if each is not None)
    return f"table, by its `{key}`: {'; '.join(links)}"


def _link(table: Table, name: str) -> str:
    """Return a link to the heading of a table on its page."""
    return f"[{name}]({heading_link(capital(title(table)))})"


def _quantity(kind: QuantityKind) -> str:
    if kind.name == "ratio":
        return "number"
    return f"{kind.name} [{symbol(kind)}]"


def symbol(kind: QuantityKind) -> str:
    """Return the SI unit of a quantity as the page writes it; "" for none."""
    return "" if kind.symbol == "no unit" else kind.symbol.replace("^2", "²").replace("^3", "³")


def _bounds(marks: Iterable[Any]) -> str:
    said = [
        f"{word} {bound:.4g}"
        for mark in marks
        if isinstance(mark, Number)
        for name, word in BOUNDS.items()
        if (bound := getattr(mark, name)) is not None
    ]
    return f", {', '.join(said)}" if said else ""


def _flat(marks: Iterable[Any]) -> Iterator[Any]:
    """Yield marks, and those that fields among them hold."""
    for mark in marks:
        if isinstance(mark, FieldInfo):
            yield from _flat(mark.metadata)
        else:
            yield mark


def _nested(annotation: Any) -> Iterator[Any]:
    """Yield the marks of a union's members."""
    for each in get_args(annotation):
        if get_origin(each) is Annotated:
            yield from get_args(each)[1:]


def _toml(value: Any) -> str:
    return f'"{value}"' if isinstance(value, str) else str(value)
