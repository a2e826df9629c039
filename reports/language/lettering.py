"""Lines of text: hidden characters shown as their code, and cuts to a length."""

from __future__ import annotations

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
