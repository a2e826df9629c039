"""What all tables of a project file share: frozen, strict about their keys, and clear about a wrong or absent one.

What pydantic finds becomes one line for the engineer: key, value, what is wrong and the remedy.
"""

from __future__ import annotations

import ast
import inspect
import json
from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from functools import cache
from itertools import pairwise
from textwrap import dedent
from typing import Any, ClassVar

from pydantic import BaseModel, ConfigDict, GetJsonSchemaHandler, ValidationError, model_validator
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema, ErrorDetails, PydanticCustomError

from assess.messages.message import escape_text

KeyPath = tuple[str | int, ...]
"""A key by its steps from the top of the file; items of lists are counted from 0."""
_LONGEST = 60  # characters of a value in an error


class ProjectSection(BaseModel):
    """One table of the project file.

    `elsewhere` are keys of another form of the same table, each with what is wrong about it here.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")
    elsewhere: ClassVar[Mapping[str, str]] = {}

    @classmethod
    def table_keys(cls) -> dict[str, FieldInfo]:
        """Return the keys as the file writes them; `from` is the alias of a field, as Python reserves the word."""
        return {field.alias or name: field for name, field in cls.model_fields.items()}

    @classmethod
    def meanings(cls) -> dict[str, str]:
        """Return what each key means: the field's description, or the sentence below it."""
        below: dict[str, str] = {}
        for table in reversed(cls.__mro__):
            below |= descriptions(table) if issubclass(table, ProjectSection) else {}
        meanings = {name: field.description or below.get(name) for name, field in cls.model_fields.items()}
        return {cls.model_fields[name].alias or name: text for name, text in meanings.items() if text}

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        found = handler(schema)
        properties = handler.resolve_ref_schema(found)["properties"]
        for key, text in cls.meanings().items():
            properties[key]["description"] = text
        return found

    @model_validator(mode="before")
    @classmethod
    def _keys_are_known(cls, values: Any) -> Any:
        if isinstance(values, dict):
            for key in values:
                if key not in cls.table_keys():
                    raise error_at(key, cls._unknown(key))
            for key, field in cls.table_keys().items():
                if field.is_required() and key not in values:
                    raise error_at(key, f"missing; {cls.meanings()[key]}")
        return values

    @classmethod
    def _unknown(cls, key: str) -> str:
        if key in cls.elsewhere:
            return cls.elsewhere[key]
        near = get_close_matches(key, cls.table_keys(), n=1)
        return (
            f'unknown key; did you mean "{near[0]}"?'
            if near
            else f"unknown key; known here: {', '.join(cls.table_keys())}"
        )

    def entries(self) -> dict[str, Any]:
        """Return every key of the table with its value, defaults included."""
        return {field.alias or name: getattr(self, name) for name, field in type(self).model_fields.items()}

    def has_key(self, key: str) -> bool:
        """Return whether the user wrote `key`, so that its default is not used."""
        return key in self.model_fields_set


@cache
def descriptions(table: type) -> dict[str, str]:
    """Return the sentence below each attribute that the class `table` itself declares.

    It is read from the source when needed; pydantic would read it at every import (0.1 s).
    """
    found = {}
    (body,) = ast.parse(dedent(inspect.getsource(table))).body
    assert isinstance(body, ast.ClassDef)
    for attribute, below in pairwise(body.body):
        match attribute, below:
            case ast.AnnAssign(target=ast.Name(name)), ast.Expr(value=ast.Constant(value=str(sentence))):
                found[name] = inspect.cleandoc(sentence)
    return found


def error_at(key: str | tuple[str | int, ...], reason: str) -> PydanticCustomError:
    """Return an error at `key`, one or more steps below the table that is being read."""
    return PydanticCustomError(
        "project", "{reason}", {"key": (key,) if isinstance(key, str) else key, "reason": reason}
    )


def quote_names(names: Mapping[str, Any] | tuple[str, ...]) -> str:
    """Write names in quotes, for a sentence."""
    return ", ".join(f'"{name}"' for name in names)


def _plain_quotes(expected: str) -> str:
    return expected.replace("'", '"')


_SENTENCES: dict[str, Callable[[Mapping[str, Any]], str]] = {
    "literal_error": lambda c: f"not allowed; write {_plain_quotes(c['expected'])}",
    "string_type": lambda c: "not a text; write it in quotes",
    "int_type": lambda c: "not a whole number; write one without decimal point",
    "greater_than": lambda c: f"must be greater than {c['gt']:.6g}",
    "greater_than_equal": lambda c: f"must be {c['ge']:.6g} or more",
    "less_than": lambda c: f"must be less than {c['lt']:.6g}",
    "less_than_equal": lambda c: f"must be {c['le']:.6g} or less",
    "model_type": lambda c: "not a table; write [KEY] with its keys below, or { key = value }",
    "dict_type": lambda c: "not a table; write [KEY.NAME] with its keys below",
    "tuple_type": lambda c: "not a list; write [ … ]",
    "too_short": lambda c: f"too few; give at least {c['min_length']}",
    "too_long": lambda c: f"too many; give at most {c['max_length']}",
    "missing": lambda c: "missing; the list is too short",
}


def error_line(error: ValidationError, *, raw: Mapping[str, Any]) -> str:
    """Return the first error as "key: value: what is wrong; remedy", and how many more the `raw` content has."""
    by_key: dict[KeyPath, ErrorDetails] = {}
    for found in error.errors(include_url=False):
        if found["type"] != "default_factory_not_called":
            by_key.setdefault(_key_in_file(found, raw), found)
    by_key = {key: found for key, found in by_key.items() if not any(_is_below(other, key) for other in by_key)}
    key, first = next(iter(by_key.items()))
    known, value = look_up(raw, key)
    parts = [key_text(key), *([value_text(value)] if known else []), _sentence(first, known=known)]
    return ": ".join(parts) + (f" (and {len(by_key) - 1} more)" if len(by_key) > 1 else "")


def key_text(key: KeyPath) -> str:
    """Write a key as users do: `mechanisms.W1.hinges.A[2]`."""
    text = "".join(f"[{step + 1}]" if isinstance(step, int) else f".{escape_text(step)}" for step in key)
    return text.lstrip(".")


def value_text(value: Any) -> str:
    """Write a value on one line, shortened if it is long."""
    text = escape_text(json.dumps(value, ensure_ascii=False, default=str))
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def _key_in_file(error: ErrorDetails, raw: Mapping[str, Any]) -> KeyPath:
    """Return the key of the error in the file, without the tags of pydantic's unions."""
    below = tuple(error.get("ctx", {}).get("key", ()))
    key: list[str | int] = []
    for step in error["loc"]:
        known, value = look_up(raw, tuple(key))
        if not (isinstance(value, Mapping | Sequence) and not isinstance(value, str)) and known:
            break
        is_tag = isinstance(step, str) and step.startswith("<") and step.endswith(">")
        if not is_tag or (isinstance(value, Mapping) and step in value):
            key.append(step)
    return (*(step for step in key if step != "[key]"), *below)


def _is_below(key: KeyPath, table: KeyPath) -> bool:
    """Whether a key lies within another, of which a fault is then the consequence: a list too short, say."""
    return len(key) > len(table) and key[: len(table)] == table


def look_up(raw: Mapping[str, Any], key: KeyPath) -> tuple[bool, Any]:
    """Whether the file holds `key`, and its value."""
    value: Any = raw
    for step in key:
        try:
            value = value[step]
        except (KeyError, IndexError, TypeError):
            return False, None
    return True, value


def _sentence(error: ErrorDetails, *, known: bool) -> str:
    context = error.get("ctx", {})
    if error["type"] == "choice":
        return f"{'not supported' if known else 'missing'}; write one of {context['names']}"
    if error["type"] == "project":
        return str(context["reason"])
    if error["type"] == "value_error":
        return str(context["error"])
    sentence = _SENTENCES.get(error["type"])
    return sentence(context) if sentence else f"{error['msg'][:1].lower()}{error['msg'][1:]}"
