"""Letters of a line: hidden characters shown as their code, cuts to a length, index and power in formulas."""

from __future__ import annotations

import re
import unicodedata

_HIDDEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def visible(text: str) -> str:
    """Return `text` on one line, with control, format and unassigned characters shown as their code: ⟨U+0007⟩."""
    if text.isprintable():
        return text
    spaced = " ".join(text.split()) if any(mark in text for mark in "\n\r\t\v\f") else text
    return "".join(character_code(mark) if unicodedata.category(mark) in _HIDDEN else mark for mark in spaced)


def truncate(text: str, limit: int) -> str:
    """Cut `text` to `limit` characters, with an ellipsis at the end."""
    return text if len(text) <= limit else text[: limit - 1].rstrip() + "…"


def truncate_middle(text: str, limit: int) -> str:
    """Cut `text` in the middle to `limit` characters: names of components differ at their ends."""
    kept = limit - 1
    return text if len(text) <= limit else f"{text[: kept // 2].rstrip()}…{text[-(kept - kept // 2) :].lstrip()}"


def character_code(mark: str) -> str:
    """Return the code of a character in brackets: ⟨U+0007⟩."""
    return f"⟨U+{ord(mark):04X}⟩"


_INDEX_MARK = re.compile(r"(?<=[^\W\d_])_(?:\{([^{}]+)\}|([^\W_]+(?:,[^\W_]+)*))")
_POWER_MARK = re.compile(r"\^(?:\{([^{}]+)\}|([-−]?[\w.]+))")


def mark_up(escaped: str, *, index: tuple[str, str], power: tuple[str, str]) -> str:
    """Put the given marks before and after each index and each power of an escaped formula."""
    lowered = _INDEX_MARK.sub(lambda found: f"{index[0]}{found[1] or found[2]}{index[1]}", escaped)
    return _POWER_MARK.sub(lambda found: f"{power[0]}{found[1] or found[2]}{power[1]}", lowered)
