"""Text of the program within Markdown."""

from __future__ import annotations

import re
from collections.abc import Iterable

SPECIAL = re.compile(r"(`[^`]+`)|([\\`*_{}\[\]<>$#])")


def escape(text: str) -> str:
    """Return a sentence as Markdown that shows it as it stands; what is between backquotes stays code."""
    return SPECIAL.sub(lambda found: found[1] or f"\\{found[2]}", text)


def heading_link(heading: str) -> str:
    """Return the link to a heading of the page, as code hosts and Sphinx name it."""
    return "#" + re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def contents(headings: Iterable[str]) -> str:
    """Return a paragraph that leads to each heading of the page."""
    return " · ".join(f"[{each}]({heading_link(each)})" for each in headings) + "\n"


def capital(text: str) -> str:
    """Return a text with a capital at its beginning."""
    return text[:1].upper() + text[1:]


def cell(text: str) -> str:
    """Return Markdown as the cell of a table: one line, its bars escaped."""
    return " ".join(text.split()).replace("|", "\\|")
