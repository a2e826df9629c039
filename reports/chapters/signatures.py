"""The last page of the main part: what is signed, and by whom."""

from __future__ import annotations

from assess.results import Results
from reports.chapters.front_matter import author, checker, client, engineer, reference
from reports.document import Block, Facts, Prose, Section, Signatures
from reports.language.texts import Text, Verbatim, say


def sections(results: Results) -> list[Section]:
    """Return the statement with the places to sign."""
    leader = engineer(results) or author(results)
    places: list[tuple[Text, Text]] = [(say("Engineer"), Verbatim(leader))]
    if author(results) not in ("", leader):
        places.insert(0, (say("Author"), Verbatim(author(results))))
    places.append((say("Checked by"), Verbatim(checker(results))))
    if client(results):
        places.append((say("Received for the client"), Verbatim(client(results))))
    blocks: tuple[Block, ...] = (Prose((statement(results),)), *_identity(results), Signatures(tuple(places)))
    return [Section(say("Signatures"), 0, blocks)]


def statement(results: Results) -> Text:
    """Return what is signed."""
    return say(
        "The undersigned have examined the data, the choice of the mechanisms and the results of this report, and "
        "judge them fit for the purpose stated. The results hold for the inputs listed here and for no others."
    )


def _identity(results: Results) -> tuple[Facts, ...]:
    """Return what identifies the issue that is signed."""
    matter = results.report
    said = (
        (say("Office"), matter.office),
        (say("Licence number"), matter.licence_number),
        (say("Reference"), reference(results)),
        (say("Revision"), matter.revisions[-1].number if matter.revisions else ""),
        (say("Stamp of the results"), results.stamp),
    )
    pairs = tuple((label, Verbatim(text)) for label, text in said if text)
    return (Facts(pairs),) if pairs else ()
