"""The report's letters: which characters its font can show, and how the others are shown."""

from __future__ import annotations

import unicodedata
from functools import cache
from pathlib import Path

FAMILY = "DejaVu Sans"
_FILES = {"regular": "DejaVuSans.ttf", "bold": "DejaVuSans-Bold.ttf", "italic": "DejaVuSans-Oblique.ttf"}
_HIDDEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def font_file(face: str) -> Path:
    """Path of the font `face` ("regular", "bold", "italic"), as matplotlib ships it."""
    import matplotlib  # late: a fifth of a second, and tables in CSV draw no letters

    return Path(matplotlib.get_data_path()) / "fonts" / "ttf" / _FILES[face]


@cache
def _glyphs() -> frozenset[int]:
    from matplotlib.ft2font import FT2Font

    faces = [FT2Font(str(font_file(face))) for face in _FILES]
    return frozenset.intersection(*(frozenset(face.get_charmap()) for face in faces))


def visible(text: str) -> str:
    """`text` on one line with control, format and unassigned characters shown as their code: ⟨U+0007⟩."""
    if text.isprintable():
        return text
    spaced = " ".join(text.split()) if any(mark in text for mark in "\n\r\t\v\f") else text
    return "".join(_code(mark) if unicodedata.category(mark) in _HIDDEN else mark for mark in spaced)


def printable(text: str) -> str:
    """`visible`, and characters that the report's font lacks or a PDF font cannot map shown as their code too."""
    if text.isascii() and text.isprintable():
        return text
    known = _glyphs()
    return "".join(mark if ord(mark) in known and ord(mark) <= 0xFFFF else _code(mark) for mark in visible(text))


def shortened(text: str, limit: int) -> str:
    """`text`, cut to `limit` characters with an ellipsis at the end where it is longer."""
    return text if len(text) <= limit else text[: limit - 1].rstrip() + "…"


def abridged(text: str, limit: int) -> str:
    """`text`, cut in the middle to `limit` characters where it is longer: names of components differ at their ends."""
    kept = limit - 1
    return text if len(text) <= limit else f"{text[: kept // 2].rstrip()}…{text[-(kept - kept // 2) :].lstrip()}"


def _code(mark: str) -> str:
    return f"⟨U+{ord(mark):04X}⟩"
