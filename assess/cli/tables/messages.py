"""Warnings and notes as lines for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from assess.messages.message import Message
from assess.project.key_text import escape_text


def messages_text(messages: Sequence[Message]) -> str:
    """Write a line for each warning and note."""
    return "".join(f"{each.severity}: {escape_text(each.where)}: {escape_text(each.text)}\n" for each in messages)
