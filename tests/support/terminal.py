"""A terminal as a test sees it: what a command writes on stderr there."""

from __future__ import annotations

import os
import pty
import re
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TextIO

ROOT = Path(__file__).parents[2]


@dataclass
class Screen:
    """What has been written to a terminal; `seen` is set as soon as it contains `awaited`."""

    awaited: str = "\0"
    text: str = ""
    seen: threading.Event = field(default_factory=threading.Event)

    def read(self, master: int) -> None:
        """Read until the other end is closed."""
        while True:
            try:
                found = os.read(master, 4096)
            except OSError:
                found = b""
            if not found:
                break
            self.text += found.decode(errors="replace")
            if self.awaited in self.text:
                self.seen.set()
        self.seen.set()

    @property
    def plain(self) -> str:
        """The text without what moves the cursor and sets colours."""
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", self.text)


@contextmanager
def terminal(screen: Screen) -> Iterator[TextIO]:
    """Give the writing end of a terminal, whose text the screen collects."""
    master, slave = pty.openpty()
    reader = threading.Thread(target=screen.read, args=(master,), daemon=True)
    reader.start()
    try:
        with os.fdopen(slave, "w") as stream:
            yield stream
    finally:
        reader.join(10)
        os.close(master)
