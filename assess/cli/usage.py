"""Errors in the use of a command, in one line."""

from __future__ import annotations

import re
from typing import Any

from typer import BadParameter

WRONG_USAGE: Any = BadParameter.__mro__[1]  # typer does not export this parent, of unknown commands and options too
PLAIN = (
    (r"Value error, ", ""),
    (r"Input should be a valid integer.*", '"{value}" is not a whole number'),
    (r"Input should be a valid number.*", '"{value}" is not a number'),
    (r"Input should be greater than or equal to (\S+)", r"{value}: must be at least \1"),
    (r"Input should be less than or equal to (\S+)", r"{value}: must be at most \1"),
    (r"\. Did you mean (.*)\?$", r"; did you mean \1?"),
    (r" \(Possible options: (.*)\)", r"; did you mean \1?"),
)
"""Patterns of the libraries' sentences, and the sentences that replace them."""


def usage_error(error: Any) -> str | None:
    """Return what is wrong with the command and where its help is; None for any other error."""
    if not isinstance(error, WRONG_USAGE):
        return None
    command = "assess" if error.ctx is None else error.ctx.command_path
    text = _plain(error)
    return f"{text} See `{command} --help`" if text.endswith("?") else f"{text}; see `{command} --help`"


def _plain(error: Any) -> str:
    """Return what is wrong, with the value where the library omits it."""
    text: str = error.format_message().rstrip(".")
    for theirs, ours in PLAIN:
        text = re.sub(theirs, ours, text)
    return text.replace("{value}", _value(error))


def _value(error: Any) -> str:
    """Return the value given, as the library that checked it kept it."""
    from assess.project.key_text import escape_text

    for cause in (error.__cause__, error.__context__):
        if hasattr(cause, "errors"):
            return escape_text(str(cause.errors()[0]["input"]))
    return "this"
