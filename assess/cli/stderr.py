"""Warnings and messages of commands, printed on stderr."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from assess.messages.message import Message
from assess.project.key_text import escape_text

MAX_LINES = 5


def print_warnings(warnings: Sequence[str]) -> None:
    """Print a line for each warning that is not empty, the first few of many."""
    found = [warning for warning in warnings if warning]
    more = [f"and {len(found) - MAX_LINES} more records with warnings"] if len(found) > MAX_LINES else []
    for text in (*found[:MAX_LINES], *more):
        print(f"assess: warning: {escape_text(text)}", file=sys.stderr)


def print_message(message: Message) -> None:
    """Print a message on one line."""
    print(
        f"assess: {message.severity}: {escape_text(message.where)}: {escape_text(message.text)}",
        file=sys.stderr,
    )
