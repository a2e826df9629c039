"""A document as its project asks for it."""

from __future__ import annotations

from reports.document import Document
from reports.translation import translated
from reports.us_axes import in_us_axes
from reports.us_units import in_us_units
from reports.us_words import in_us_words


def as_asked(document: Document) -> Document:
    """The document in the units and the language that it is to be written in.

    Tables tell their units by their English headings, and the catalogue of a language has its sentences in SI: so
    tables first, then the language, then the quantities in sentences and figures.
    """
    if document.units == "SI":
        return translated(document)
    return in_us_axes(in_us_words(translated(in_us_units(document))))
