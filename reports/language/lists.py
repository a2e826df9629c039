"""Names joined to an English list."""

from __future__ import annotations

from collections.abc import Iterable

MANY = 6  # names in a list


def join_names(names: Iterable[str]) -> str:
    """Join names with commas and "and"."""
    every = list(names)
    return f"{', '.join(every[:-1])} and {every[-1]}" if len(every) > 1 else "".join(every)


def list_names(names: list[str]) -> str:
    """Join names with commas and "and"; of many only the first ones, and the number of the others."""
    return join_names([*names[:MANY], f"{len(names) - MANY} others"] if len(names) > MANY + 1 else names)
