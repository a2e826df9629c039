"""Sentences of a report that a language has no entry for."""

from __future__ import annotations

from assess.results import Results
from reports.assessment import assessment, of_envelopes
from reports.language.catalogue import catalogue
from reports.language.document_texts import reworded
from reports.language.translation import Speech
from reports.language.us_units import in_us_units


def untranslated(results: Results, *, language: str) -> tuple[str, ...]:
    """The sentences and parts of sentences of both reports, figures drawn, that the catalogue does not know."""
    found: dict[str, None] = {}
    whole = assessment(results)
    for document in (whole, in_us_units(whole), of_envelopes(results)):
        speech = Speech(catalogue(language), document.verbatim)
        for figure in reworded(document, speech.said).figures:
            figure.draw()
        found |= speech.unknown
    return tuple(found)
