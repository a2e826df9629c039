"""A document in the units and the language of its project."""

from __future__ import annotations

from reports.document import Document
from reports.figures.us_axes import in_us_axes
from reports.language.measures import in_units
from reports.language.translation import translate_document
from reports.language.us_units import in_us_units


def localise(document: Document) -> Document:
    """Return the document in the units and the language that it is to be written in.

    Units of tables are recognised by their English headings: so tables come first, then the language, then the
    numbers in sentences and figures.
    """
    if document.units == "SI":
        return in_units(translate_document(document), "SI")
    return in_us_axes(in_units(translate_document(in_us_units(document)), "US"))
