"""Docstrings of numpydoc without types, as the program writes them: sentences, and lists of `name : what it is`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

HEADING = re.compile(r"^(.+)\n-{3,}$", re.MULTILINE)
ITEM = re.compile(r"^(\w[\w, ]*?(?: \[[^\]]*\])*) : (.+)$")


@dataclass(frozen=True)
class DocstringSection:
    """A part of a docstring under one heading, "" for what comes first.

    paragraphs : its sentences; items : names with what they are
    """

    title: str
    paragraphs: tuple[str, ...]
    items: tuple[tuple[str, str], ...]


def split(text: str) -> tuple[DocstringSection, ...]:
    """Return the parts of a docstring."""
    first, *rest = HEADING.split(text)
    titled = [("", first), *zip(rest[::2], rest[1::2], strict=True)]
    return tuple(_section(title, body) for title, body in titled if body.strip())


def _section(title: str, body: str) -> DocstringSection:
    paragraphs: list[str] = []
    items: list[tuple[str, str]] = []
    for block in re.split(r"\n\s*\n", body.strip("\n")):
        found = tuple(_items(block))
        if ITEM.match(block.split("\n")[0]):
            items += found
        else:
            paragraphs.append(" ".join(block.split()))
    return DocstringSection(title, tuple(paragraphs), tuple(items))


def _items(block: str) -> Iterator[tuple[str, str]]:
    """Yield the names of a list; a line that names nothing goes on with the one above."""
    name, words = "", ""
    for line in block.split("\n"):
        match = ITEM.match(line)
        if match:
            if name:
                yield name, words
            name, words = match[1], match[2]
        else:
            words = f"{words} {line.strip()}"
    if name:
        yield name, words
