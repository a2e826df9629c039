"""The texts of a document, before a language and a system of units are chosen.

A sentence is kept in English with named gaps, and what fills the gaps is kept whole: numbers in SI at full precision,
texts of the user letter for letter. `reports.language.locale` makes letters of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from assess.messages.message import Message, Quantity
from assess.messages.message import Term as Term  # of the report too

Kind = Literal["Figure", "Table", "Sheet"]


@dataclass(frozen=True)
class Verbatim:
    """Text that no language changes: of the user, names, paths, symbols of formulas, identifiers."""

    text: str


@dataclass(frozen=True)
class Date:
    """A day, as the project writes it; one that is not written like 2026-11-28 stands as it is."""

    text: str


@dataclass(frozen=True)
class Phrase:
    """English words written by the report, with named gaps; made by `say` and `say_count`.

    english : the entry of the catalogue, for one thing where there is a plural
    values : what fills the gaps, by name
    plural : the entry for several things, empty where nothing is counted
    number : of things
    """

    english: str
    values: Mapping[str, Text] = field(default_factory=dict, hash=False)
    plural: str = ""
    number: int = 1


@dataclass(frozen=True)
class Listing:
    """Several texts in a row: "a, b and c"; apart by semicolons where a text has a comma of its own, as a
    decimal comma.

    join : the word before the last, "" for none
    """

    texts: tuple[Text, ...]
    join: Literal["and", "or", ""] = "and"


@dataclass(frozen=True)
class Paragraph:
    """Several sentences, one after the other."""

    sentences: tuple[Text, ...]


@dataclass(frozen=True)
class Reference:
    """The title of a block of the document: "Figure 5"."""

    kind: Kind
    name: str


Text = Verbatim | Date | Term | Phrase | Message | Quantity | Listing | Paragraph | Reference


def say(english: str, /, **values: Text) -> Phrase:
    """Return words of the report. english : a literal, which is its entry in the catalogues."""
    return Phrase(english, values)


def say_count(one: str, several: str, /, number: int, **values: Text) -> Phrase:
    """Return words that depend on a number, which fills the gap {number}: "{number} wall", "{number} walls"."""
    return Phrase(one, {"number": count(number), **values}, plural=several, number=number)


def count(number: int) -> Quantity:
    """Return a whole number."""
    return Quantity(float(number), "ratio", 12)


def listing(texts: Iterable[Text], join: Literal["and", "or", ""] = "and") -> Listing:
    """Return texts in a row."""
    return Listing(tuple(texts), join)


def names(texts: Iterable[str], join: Literal["and", "or", ""] = "and") -> Listing:
    """Return names in a row, each once."""
    return Listing(tuple(Verbatim(text) for text in dict.fromkeys(texts)), join)


def quantity(value: float, dimension: str = "ratio", figures: int = 4) -> Quantity:
    """Return a number in SI with its dimension, a key of `reports.language.locale.UNITS`, and significant figures."""
    return Quantity(value, dimension, figures)


def with_figures(text: Text, figures: int) -> Text:
    """Return a number to so many significant figures; another text as it is."""
    return replace(text, figures=figures) if isinstance(text, Quantity) else text
