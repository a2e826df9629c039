"""Sentences of a report that a language has no entry for."""

from __future__ import annotations

from assess.results import Results
from reports.assessment import assessment, envelope_report
from reports.language.catalogue import catalogue
from reports.language.document_texts import map_texts
from reports.language.translation import Translator
from reports.language.us_units import in_us_units


def missing_sentences(results: Results, *, language: str) -> tuple[str, ...]:
    """Return the sentences and parts of sentences of both reports, figures drawn, that the catalogue lacks."""
    found: dict[str, None] = {}
    whole = assessment(results)
    for document in (whole, in_us_units(whole), envelope_report(results)):
        translator = Translator(catalogue(language), document.verbatim)
        for figure in map_texts(document, translator.translate).figures:
            figure.draw()
        found |= translator.unknown
    return tuple(found)
