"""The heads of the table in which a report is signed."""

from __future__ import annotations

from reports.document import NOTHING
from reports.language.texts import Text, say

SIGNATURE_HEADS: tuple[Text, ...] = (NOTHING, say("Name"), say("Signature"), say("Place and date"))
