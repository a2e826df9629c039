"""Text that a spreadsheet would run as a formula, and how it is written so that it does not.

The one place that knows which text that is; whatever writes CSV or a workbook asks here.
"""

from __future__ import annotations

import re

SIGNS = ("=", "+", "-", "@", "\t", "\r")
_AFTER_SEMICOLON = re.compile(r"(;\s*)(?=[\"'\s]*[=+\-@])")
_PARTS = re.compile(r"([,;]\s*)(?=[\"'\s]*[=+\-@])")  # where a spreadsheet may begin a cell within a line of text
_MARKED = re.compile(r"([,;]\s*)'(?=[\"'\s]*[=+\-@])")


def is_formula(text: str) -> bool:
    """Whether a cell of `text` would be run; a lone dash, as tables print it, is not."""
    return text != "-" and text.lstrip(" \n\v\f").startswith(SIGNS)


def harmless_cell(text: str, *, shown: str) -> str:
    """`text`, as it is `shown`, for a cell between commas: behind an apostrophe where it or a part of it would run.

    A spreadsheet in a language of decimal commas parts the cells at semicolons.
    """
    return _AFTER_SEMICOLON.sub(r"\1'", f"'{shown}" if is_formula(text) else shown)


def mark_formulas(line: str) -> str:
    """A line of free text, with an apostrophe before each part that a spreadsheet would take for a cell and run."""
    return _PARTS.sub(r"\1'", line)


def unmark_formulas(line: str) -> str:
    """The text of which `mark_formulas` made `line`."""
    return _MARKED.sub(r"\1", line)
