"""Lines on stderr besides errors: warnings, notes, and with --verbose what is done."""

from __future__ import annotations

import logging
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from assess.messages.message import Message

MAX_LINES = 5
QUIET, USUAL, VERBOSE = logging.ERROR, logging.INFO, logging.DEBUG
LEVELS = {"error": logging.ERROR, "warning": logging.WARNING, "note": logging.INFO}
LOG = logging.getLogger("assess.cli")


class _Stderr(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        print(record.getMessage(), file=sys.stderr)


def begin() -> None:
    """Let what the commands say go to stderr, as much as is usual."""
    LOG.handlers, LOG.propagate = [_Stderr()], False
    LOG.setLevel(USUAL)


def print_warnings(warnings: Sequence[str]) -> None:
    """Print a line for each warning that is not empty, the first few of many."""
    found = [warning for warning in warnings if warning]
    more = [f"and {len(found) - MAX_LINES} more records with warnings"] if len(found) > MAX_LINES else []
    for text in (*found[:MAX_LINES], *more):
        LOG.warning("assess: warning: %s", _on_one_line(text))


def print_message(message: Message) -> None:
    """Print a message on one line."""
    where, text = _on_one_line(message.where), _on_one_line(message.text)
    LOG.log(LEVELS[message.severity], "assess: %s: %s: %s", message.severity, where, text)


def print_messages(messages: Sequence[Message]) -> None:
    """Print messages as the tables of results do, which JSON and CSV leave out."""
    for each in messages:
        LOG.log(LEVELS[each.severity], "%s: %s: %s", each.severity, _on_one_line(each.where), _on_one_line(each.text))


def print_note(text: str) -> None:
    """Print a note on what was found or done."""
    LOG.info("assess: note: %s", _on_one_line(text))


def print_detail(text: str) -> None:
    """Print, with --verbose only, a line on what is being done."""
    LOG.debug("assess: %s", _on_one_line(text))


def is_verbose() -> bool:
    """Whether --verbose was given."""
    return LOG.isEnabledFor(VERBOSE)


def is_quiet() -> bool:
    """Whether --quiet was given."""
    return not LOG.isEnabledFor(USUAL)


def _on_one_line(text: str) -> str:
    from assess.project.key_text import escape_text  # which imports pydantic

    return escape_text(text)
