"""Plain tables and messages for the terminal; the modules beside are what the groups of commands print with them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from assess.messages.message import Message, escape_text

WIDEST = 40  # characters of a cell
Item = TypeVar("Item")
TextField = tuple[str, Callable[[Item], str]]
"""A column of a table on the terminal: its heading, and its cell for an item."""


def table_of(fields: Sequence[TextField[Item]], items: Sequence[Item]) -> str:
    """Write the table of some items, a line for each, as `text_table` does."""
    return text_table([heading for heading, _ in fields], [[cell(item) for _, cell in fields] for item in items])


def text_table(header: Sequence[str], rows: Sequence[Sequence[str]], *, widest: int = WIDEST) -> str:
    """Align columns, the first to the left and the others to the right; each line ends with a line break.

    widest : characters of a cell; longer ones are cut
    """
    lines = [[on_one_line(cell, widest) for cell in row] for row in (header, *rows)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(header))]
    return "".join(_line(cells, widths) for cells in lines)


def _line(cells: Sequence[str], widths: Sequence[int]) -> str:
    first = cells[0].ljust(widths[0])
    others = (cell.rjust(width) for cell, width in zip(cells[1:], widths[1:], strict=True))
    return "  ".join((first, *others)).rstrip() + "\n"


def on_one_line(text: str, widest: int) -> str:
    """Remove control characters from `text` and cut it to what a terminal can show."""
    shown = "".join(c if c.isprintable() else " " for c in text)
    return shown if len(shown) <= widest else f"{shown[: widest - 1]}…"


def messages_text(messages: Sequence[Message]) -> str:
    """Write a line for each warning and note."""
    return "".join(f"{each.severity}: {escape_text(each.where)}: {escape_text(each.text)}\n" for each in messages)
