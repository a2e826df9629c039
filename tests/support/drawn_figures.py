"""What stands on a drawn figure: words that went through no locale, and marks beyond its sheet."""

from __future__ import annotations

import re
from collections.abc import Container

from matplotlib.figure import Figure
from matplotlib.text import Text

from reports.language.locale import Locale

WORD = re.compile(r"[A-Za-z]{4,}")


class Bracketed(Locale):
    """A language in which each entry stands in brackets."""

    def word(self, english: str) -> str:
        """Return an entry in brackets."""
        return f"⟦{english}⟧"


def fixed_words(figure: Figure, *, but: Container[str] = ()) -> set[str]:
    """Return the words of a figure drawn by `Bracketed` that stand outside all brackets, `but` some whole texts."""
    figure.draw_without_rendering()
    found = set()
    for each in figure.findobj(Text):
        text = each.get_text() if each.get_visible() and each.get_text() not in but else ""
        while "⟦" in text:
            text = re.sub(r"⟦[^⟦⟧]*⟧", " ", text)
        found |= {*WORD.findall(text)}
    return found
