"""A sentence with gaps, {0}, {1}, …, in one language and in another."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

_GAP = re.compile(r"\{(\d+)\}")
_LETTER = "[A-Za-zÀ-ÖØ-öø-ÿ]"  # no Greek, no indices: those are symbols
_WORD = re.compile(f"(?<!{_LETTER}){_LETTER}{{2,}}(?!{_LETTER})")


@dataclass(frozen=True)
class Template:
    """A pair of sentences. fixed : what stands before, between and after the gaps; gaps : their numbers in order."""

    fixed: tuple[str, ...]
    gaps: tuple[int, ...]
    other: str

    @property
    def word(self) -> str:
        """The longest whole word between the gaps, by which a sentence is looked up; empty where there is none."""
        return max(words("\ue000".join(self.fixed)), key=len, default="")

    @property
    def size(self) -> int:
        """The number of fixed letters: of two templates that fit, the longer one is more specific."""
        return sum(map(len, self.fixed))

    def match(self, text: str) -> dict[int, str] | None:
        """Return the contents of each gap of `text`, as short as possible, at least one letter; None if it differs.

        Leftmost pieces first: a text of any length is read once.
        """
        first, *between, last = self.fixed
        if not text.startswith(first) or not text.endswith(last):
            return None
        found: dict[int, str] = {}
        start, end = len(first), len(text) - len(last)
        for gap, piece in zip(self.gaps, between, strict=False):
            place = text.find(piece, start + 1, end)
            if place < 0:
                return None
            found[gap] = text[start:place]
            start = place + len(piece)
        found[self.gaps[-1]] = text[start:end]
        return found if start < end else None

    def matches(self, text: str) -> Iterator[dict[int, str]]:
        """Yield every way in which a template of two gaps fits, like "{0} and {1}"; of others the one of `match`."""
        found = self.match(text)
        while found is not None:
            yield found
            found = self._next(text, found) if len(self.gaps) == 2 else None

    def _next(self, text: str, last: dict[int, str]) -> dict[int, str] | None:
        """Return the next way to divide a text over two gaps."""
        first, middle, end = self.fixed
        start, stop = len(first), len(text) - len(end)
        place = text.find(middle, start + len(last[self.gaps[0]]) + 1, stop)
        rest = place + len(middle)
        return {self.gaps[0]: text[start:place], self.gaps[1]: text[rest:stop]} if place >= 0 and rest < stop else None

    def fill(self, parts: dict[int, str]) -> str:
        """Return the sentence of the other language with its gaps filled."""
        return _GAP.sub(lambda gap: parts[int(gap[1])], self.other)


def template(one: str, other: str) -> Template:
    """Return the pair of a sentence with gaps and its translation.

    Raises ValueError where the two do not have the same gaps, or two gaps touch.
    """
    gaps = tuple(map(int, _GAP.findall(one)))
    if set(gaps) != set(map(int, _GAP.findall(other))) or len(set(gaps)) < len(gaps):
        raise ValueError(f'"{one}": its gaps are not those of "{other}"; give each gap once, and all in both')
    fixed = tuple(_GAP.split(one)[::2])
    if "" in fixed[1:-1]:
        raise ValueError(f'"{one}": two gaps touch; put a letter between them')
    return Template(fixed, gaps, other)


def has_gaps(text: str) -> bool:
    """Return whether a sentence has gaps."""
    return _GAP.search(text) is not None


def words(text: str) -> tuple[str, ...]:
    """Return the words of a text, of two letters and more."""
    return tuple(_WORD.findall(text))
