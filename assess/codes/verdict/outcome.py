"""Pass, fail or incomplete, and the worst of several."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum


class Decision(StrEnum):
    """The outcome of a limit state, of a mechanism and of the building."""

    PASS = "pass"
    FAIL = "fail"
    INCOMPLETE = "incomplete"


def worst(outcomes: Iterable[Decision]) -> Decision:
    """Return the worst of several: fail, then incomplete, then pass; incomplete where there are none."""
    found = set(outcomes)
    if Decision.FAIL in found:
        return Decision.FAIL
    return Decision.INCOMPLETE if Decision.INCOMPLETE in found or not found else Decision.PASS
