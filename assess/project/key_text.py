"""One line for the engineer from what pydantic found: key, value, what is wrong and the remedy."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

_LONGEST = 60
Key = tuple[str | int, ...]

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
    by_key: dict[Key, ErrorDetails] = {}
    for found in error.errors(include_url=False):
        if found["type"] != "default_factory_not_called":
            by_key.setdefault(_key(found, raw), found)
    by_key = {key: found for key, found in by_key.items() if not any(_below(other, key) for other in by_key)}
    key, first = next(iter(by_key.items()))
    known, value = look_up(raw, key)
    parts = [key_text(key), *([value_text(value)] if known else []), _sentence(first, known=known)]
    return ": ".join(parts) + (f" (and {len(by_key) - 1} more)" if len(by_key) > 1 else "")


def key_text(key: Key) -> str:
    """Write a key as users do: `mechanisms.W1.hinges.A[2]`."""
    text = "".join(f"[{step + 1}]" if isinstance(step, int) else f".{escape_text(step)}" for step in key)
    return text.lstrip(".")


def value_text(value: Any) -> str:
    """Write a value on one line, shortened if it is long."""
    text = escape_text(json.dumps(value, ensure_ascii=False, default=str))
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def escape_text(text: str) -> str:
    """Escape line breaks and control characters, so that the text stays on one line."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def _key(error: ErrorDetails, raw: Mapping[str, Any]) -> Key:
    """Return the key of the error in the file, without the tags of pydantic's unions."""
    below = tuple(error.get("ctx", {}).get("key", ()))
    key: list[str | int] = []
    for step in error["loc"]:
        known, value = look_up(raw, tuple(key))
        if not (isinstance(value, Mapping | Sequence) and not isinstance(value, str)) and known:
            break
        if not (isinstance(step, str) and step.startswith("<") and step.endswith(">") and step not in _names(value)):
            key.append(step)
    return (*(step for step in key if step != "[key]"), *below)


def _below(key: Key, table: Key) -> bool:
    """Whether a key lies within another, of which a fault is then the consequence: a list too short, say."""
    return len(key) > len(table) and key[: len(table)] == table


def _names(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, Mapping) else {}


def look_up(raw: Mapping[str, Any], key: Key) -> tuple[bool, Any]:
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


def _plain_quotes(expected: str) -> str:
    return expected.replace("'", '"')
