"""Text of the program within Markdown."""

from __future__ import annotations

import re

SPECIAL = re.compile(r"(`[^`]+`)|([\\`*_{}\[\]<>$#])")


def escape(text: str) -> str:
    """Return a sentence as Markdown that shows it as it stands; what is between backquotes stays code."""
    return SPECIAL.sub(lambda found: found[1] or f"\\{found[2]}", text)


def cell(text: str) -> str:
    """Return Markdown as the cell of a table: one line, its bars escaped."""
    return " ".join(text.split()).replace("|", "\\|")
