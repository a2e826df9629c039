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
    """Return whether a cell of `text` would be run; a lone dash, as tables print it, is not."""
    return text != "-" and text.lstrip(" \n\v\f").startswith(SIGNS)


def harmless_cell(text: str, *, shown: str) -> str:
    """Write a text for a cell between commas, so that a spreadsheet runs no part of it: behind an apostrophe.

    A spreadsheet in a language of decimal commas splits the cells at semicolons.

    Parameters
    ----------
    text : content of the cell
    shown : the same as it is printed, in quotes if need be
    """
    return _AFTER_SEMICOLON.sub(r"\1'", f"'{shown}" if is_formula(text) else shown)


def mark_formulas(line: str) -> str:
    """Put an apostrophe before each part of a line that a spreadsheet would take for a cell and run."""
    return _PARTS.sub(r"\1'", line)


def unmark_formulas(line: str) -> str:
    """Return the text from which `mark_formulas` made `line`."""
    return _MARKED.sub(r"\1", line)
