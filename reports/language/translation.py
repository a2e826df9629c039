"""A document in another language: every text that the program wrote is looked up in the catalogue of that language.

What the catalogue does not know stays English; texts of the user stay as they are; numbers keep their points.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import lru_cache, partial
from itertools import accumulate
from textwrap import fill

from reports.document import Document
from reports.language.catalogue import ENGLISH, Catalogue, catalogue
from reports.language.document_texts import map_texts
from reports.language.template import Template, words
from reports.language.verbatim import Masks, is_mark, masks

_IDENTIFIER = re.compile(r"[^\s\d_./*-]*[\d_./*-]\S*")  # a word with digits or signs in it

_LONGER = 4  # letters by which a line of a figure may grow
_STOP = re.compile(r"[.:]”? ")


def translate_document(document: Document) -> Document:
    """Return the document in its language; itself where that is English."""
    if document.language == ENGLISH:
        return document
    say = partial(_translate, document.language, document.verbatim)
    return replace(map_texts(document, say), words=catalogue(document.language).furniture)


def _keeps_brackets(gaps: dict[int, str]) -> bool:
    """Return whether no gap closes a bracket that opens before it, as "7) and b (2 of 7" in a list of "a (2 of 7)"."""
    return all(_closed(part) for part in gaps.values())


def _closed(text: str) -> bool:
    depths = accumulate({"(": 1, ")": -1}.get(letter, 0) for letter in text)
    return min(depths, default=0) >= 0


def _translate(language: str, verbatim: frozenset[str], text: str) -> str:
    """Return a text in the language; the translator need not be sent to the processes that draw figures."""
    return _translator(language, verbatim).translate(text)


@lru_cache(maxsize=2)
def _translator(language: str, verbatim: frozenset[str]) -> Translator:
    return Translator(catalogue(language), verbatim)


class Translator:
    """One language for one document, with what has been looked up in it. unknown : what no entry fits."""

    def __init__(self, known: Catalogue, verbatim: frozenset[str]) -> None:
        self.catalogue, self.verbatim = known, verbatim
        self.masks: Masks = masks(verbatim, spared="\n".join((*known.english, *known.unchanged)))
        self.texts: dict[str, str] = {}
        self.parts: dict[str, str | None] = {}
        self.unknown: dict[str, None] = {}

    def translate(self, text: str) -> str:
        """Return the text in the language, or in English where no entry fits."""
        if text not in self.texts:
            own = text.strip() in self.verbatim
            self.texts[text] = text if own else self.masks.around(self._best, text)
        return self.texts[text]

    def _best(self, text: str) -> str:
        """Return a text with marks for those of the user: what is known of it in the language, the rest in English."""
        whole = self._whole(text)
        if whole is not None:
            return whole
        for each in self.catalogue.candidates(text):
            gaps = each.match(text)
            if gaps is not None:
                return each.fill({gap: self._best(part) for gap, part in gaps.items()})
        self.unknown[text] = None
        return text

    def _whole(self, text: str) -> str | None:
        """Return the text in the language where everything in it is known; else None."""
        if text not in self.parts:
            self.parts[text] = None  # what contains itself is not known
            self.parts[text] = self._looked_up(text)
        return self.parts[text]

    def _looked_up(self, text: str) -> str | None:
        if text in self.verbatim or text.strip('"') in self.verbatim:
            return text
        if text in self.catalogue.exact:
            return self.catalogue.exact[text]
        if self._wordless(text):
            return text
        lines = self._lines(text) if "\n" in text else None
        if lines is not None:
            return lines
        pairs = (*self.catalogue.candidates(text), *self.catalogue.phrases)
        found = next((filled for each in pairs if (filled := self._filled(each, text)) is not None), None)
        return self._paragraph(text) if found is None else found

    def _filled(self, each: Template, text: str) -> str | None:
        """Return the translation of a template that fits, where its gaps are known and each keeps its own brackets."""
        for gaps in filter(_keeps_brackets, each.matches(text)):
            parts = {gap: found for gap, part in gaps.items() if (found := self._whole(part)) is not None}
            if len(parts) == len(gaps):
                return each.fill(parts)
        return None

    def _lines(self, text: str) -> str | None:
        """Return a text of several lines: part by part, else as one, folded again."""
        for at in (place for place, letter in enumerate(text) if letter == "\n"):
            first, rest = self._whole(text[:at]), self._whole(text[at + 1 :])
            if first is not None and rest is not None:
                return f"{first}\n{rest}"
        plain = self._whole(text.replace("\n", " "))
        return None if plain is None else fill(plain, max(map(len, text.split("\n"))) + _LONGER)

    def _paragraph(self, text: str) -> str | None:
        """Return two sentences and more that are known one by one."""
        for stop in _STOP.finditer(text):
            first, rest = self._whole(text[: stop.end() - 1]), self._whole(text[stop.end() :])
            if first is not None and rest is not None:
                return f"{first} {rest}"
        return None

    def _wordless(self, text: str) -> bool:
        """Return whether there is nothing to translate: numbers, units, signs, identifiers and texts of the user."""
        plain = "".join(letter for letter in text if not is_mark(letter))
        return all(
            self.catalogue.unchanged.issuperset(words(part)) or _IDENTIFIER.fullmatch(part.rstrip(".,;:)"))
            for part in plain.split()
        )
