"""A document as its project asks for it."""

from __future__ import annotations

from reports.document import Document
from reports.translation import translated
from reports.us_axes import in_us_axes
from reports.us_units import in_us_units
from reports.us_words import in_us_words


def as_asked(document: Document) -> Document:
    """The document in the language and then in the units that it is to be written in.

    The catalogue knows the sentences as the program says them, in SI; units are changed in any language.
    """
    return _in_units(translated(document))


def _in_units(document: Document) -> Document:
    return in_us_axes(in_us_words(in_us_units(document))) if document.units == "US" else document
