"""The words of the renderers themselves: heads of sheets and signatures, the verdict, the foot of a page."""

from __future__ import annotations

from collections.abc import Mapping

from reports.document import Banner, Document
from reports.language.texts import Text, Verbatim, say

CONTENTS = say("Contents")
SHEET_HEADS: tuple[Text, ...] = (say("Symbol"), say("Meaning; clause"), say("Formula; numbers"), say("Value"))
SIGNATURE_HEADS: tuple[Text, ...] = (Verbatim(""), say("Name"), say("Signature"), say("Place and date"))
STAMP = say("stamp")
YES, NO = say("yes"), say("no")
_VERDICTS: Mapping[tuple[str, bool], Text] = {
    ("pass", False): say("PASS"),
    ("fail", False): say("FAIL"),
    ("incomplete", False): say("INCOMPLETE"),
    ("pass", True): say("PASS AT THE LIMIT"),
    ("fail", True): say("FAIL AT THE LIMIT"),
    ("incomplete", True): say("INCOMPLETE"),
}


def verdict_word(banner: Banner) -> Text:
    """Return the outcome in capitals."""
    return _VERDICTS[banner.outcome, banner.near]


def origin(document: Document) -> Text:
    """Return the program, and the stamp of the results."""
    program = Verbatim(document.program)
    if not document.stamp:
        return program
    return say("{program}, stamp {stamp}", program=program, stamp=Verbatim(document.stamp))
