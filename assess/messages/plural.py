"""Numbers with their nouns."""

from __future__ import annotations


def count_noun(number: int, noun: str) -> str:
    """1 wall, 2 walls."""
    return f"{number} {noun}{'' if number == 1 else 's'}"
