"""The font of the report, and characters that it cannot show."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from reports.language.lettering import character_code, visible

FAMILY = "DejaVu Sans"
_FILES = {"regular": "DejaVuSans.ttf", "bold": "DejaVuSans-Bold.ttf", "italic": "DejaVuSans-Oblique.ttf"}


def font_file(face: str) -> Path:
    """Return the path of the font `face` ("regular", "bold", "italic"), as matplotlib ships it."""
    import matplotlib  # late: a fifth of a second, and tables in CSV draw no letters

    return Path(matplotlib.get_data_path()) / "fonts" / "ttf" / _FILES[face]


@cache
def _glyphs() -> frozenset[int]:
    from matplotlib.ft2font import FT2Font

    faces = [FT2Font(str(font_file(face))) for face in _FILES]
    return frozenset.intersection(*(frozenset(face.get_charmap()) for face in faces))


def printable(text: str) -> str:
    """Return `visible` text with characters that the font lacks, or a PDF font cannot map, shown as their code too."""
    if text.isascii() and text.isprintable():
        return text
    known = _glyphs()
    return "".join(
        mark if ord(mark) in known and ord(mark) <= 0xFFFF else character_code(mark) for mark in visible(text)
    )
