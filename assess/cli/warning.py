"""What commands have no other place to tell: lines on stderr."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from assess.messages.message import Message
from assess.project.messages import printable

TOLD = 5  # lines


def warn(doubts: Sequence[str]) -> None:
    """A line for each doubt that is not "", the first few of many."""
    told = [doubt for doubt in doubts if doubt]
    more = [f"and {len(told) - TOLD} more such records"] if len(told) > TOLD else []
    for text in (*told[:TOLD], *more):
        print(f"assess: warning: {printable(text)}", file=sys.stderr)


def tell(message: Message) -> None:
    """A line for a message."""
    print(f"assess: {message.severity}: {printable(message.where)}: {printable(message.text)}", file=sys.stderr)
