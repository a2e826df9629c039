"""For developers: sentences of a report that a language has no entry for, one a line.

python -m reports.untranslated it RESULTS.json …
"""

from __future__ import annotations

from assess.results import Results
from reports.assessment import assessment, of_envelopes
from reports.catalogue import catalogue
from reports.translation import Speech
from reports.wording import reworded


def untranslated(results: Results, *, language: str) -> tuple[str, ...]:
    """The sentences and parts of sentences of both reports, figures drawn, that the catalogue does not know."""
    found: dict[str, None] = {}
    for document in (assessment(results), of_envelopes(results)):
        speech = Speech(catalogue(language), document.verbatim)
        for figure in reworded(document, speech.said).figures:
            figure.draw()
        found |= speech.unknown
    return tuple(found)
