"""What stands when a command is interrupted: the end of the one line that it then prints."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from assess.outputs.signals import Terminated

NOTHING_WRITTEN = "nothing was written"


@contextmanager
def on_interruption(what_stands: str) -> Iterator[None]:
    """Add to an interruption of the block what then stands."""
    try:
        yield
    except (Terminated, KeyboardInterrupt) as stop:
        stop.add_note(what_stands)
        raise
