"""A key of a project file by its steps from the top, and what an error says there."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from pydantic_core import PydanticCustomError

from assess.messages.message import escape_text

KeyPath = tuple[str | int, ...]
"""A key by its steps from the top of the file; items of lists are counted from 0."""
_LONGEST = 60  # characters of a value in an error


def error_at(key: str | tuple[str | int, ...], reason: str) -> PydanticCustomError:
    """Return an error at `key`, one or more steps below the table that is being read."""
    return PydanticCustomError(
        "project", "{reason}", {"key": (key,) if isinstance(key, str) else key, "reason": reason}
    )


def errors_at(
    faults: Sequence[tuple[str | tuple[str | int, ...], str]], *, unknown: tuple[str, ...] = ()
) -> PydanticCustomError:
    """Return one error for several keys of the table that is being read, each with its reason.

    unknown : those of the keys that no table of the kind has
    """
    (key, reason), *others = faults
    more = [((each,) if isinstance(each, str) else each, text) for each, text in others]
    context = {"key": (key,) if isinstance(key, str) else key, "reason": reason, "more": more, "unknown": unknown}
    return PydanticCustomError("project", "{reason}", context)


def quote_names(names: Mapping[str, Any] | tuple[str, ...]) -> str:
    """Write names in quotes, for a sentence."""
    return ", ".join(f'"{name}"' for name in names)


def key_text(key: KeyPath) -> str:
    """Write a key as users do: `mechanisms.W1.hinges.A[2]`."""
    text = "".join(f"[{step + 1}]" if isinstance(step, int) else f".{escape_text(step)}" for step in key)
    return text.lstrip(".")


def value_text(value: Any) -> str:
    """Write a value on one line, shortened if it is long."""
    text = escape_text(json.dumps(value, ensure_ascii=False, default=str))
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def look_up(raw: Mapping[str, Any], key: KeyPath) -> tuple[bool, Any]:
    """Whether the file holds `key`, and its value.

    Parameters
    ----------
    raw : what the file says
    key : of a value or a table
    """
    value: Any = raw
    for step in key:
        try:
            value = value[step]
        except (KeyError, IndexError, TypeError):
            return False, None
    return True, value
