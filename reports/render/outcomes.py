"""The words of an outcome where it is shown at a glance."""

from __future__ import annotations

from reports.document import Banner
from reports.language.texts import Phrase, say

_WORDS = {"pass": say("PASS"), "fail": say("FAIL"), "incomplete": say("INCOMPLETE")}
_NEAR = {
    "pass": say("PASS AT THE LIMIT"),
    "fail": say("FAIL AT THE LIMIT"),
    "incomplete": say("INCOMPLETE AT THE LIMIT"),
}


def banner_word(banner: Banner) -> Phrase:
    """Return the outcome in capitals."""
    return (_NEAR if banner.near else _WORDS)[banner.outcome]
