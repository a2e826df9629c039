"""How long work tells its caller how far it is."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[str, int, int], None]
"""Called with the stage of the work, the number of its parts done, and their total."""


def silent(stage: str, done: int, total: int) -> None:
    """Report nothing."""
