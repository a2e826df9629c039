"""Nouns with their number, and lists of names."""

from __future__ import annotations

from collections.abc import Sequence


def count_noun(number: int, noun: str, several: str = "") -> str:
    """Write a number with its noun in the singular or plural: 1 wall, 2 walls.

    Parameters
    ----------
    number : of things
    noun : in the singular
    several : its plural, "" for one in -s
    """
    return f"{number} {noun if number == 1 else several or f'{noun}s'}"


def first_names(names: Sequence[str], most: int) -> str:
    """Write the first of many names with commas, and an ellipsis for the others.

    Parameters
    ----------
    names : at least one
    most : how many are written
    """
    return ", ".join(names[:most]) + (", …" if len(names) > most else "")
