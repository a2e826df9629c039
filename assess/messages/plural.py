"""Nouns with their number."""

from __future__ import annotations


def count_noun(number: int, noun: str) -> str:
    """Write a number with its noun in the singular or plural: 1 wall, 2 walls.

    Parameters
    ----------
    number : of things
    noun : in the singular, with a plural in -s
    """
    return f"{number} {noun}{'' if number == 1 else 's'}"
