"""An edition of the Italian procedures: how it is cited, and its options."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass


@dataclass(frozen=True)
class Edition:
    """Code, name and caveat of an edition, and its clauses of the multiplier, the equivalent oscillator and FC."""

    code: str
    name: str
    caveat: str
    multiplier: str
    oscillator: str
    confidence: str


@dataclass(frozen=True)
class Options:
    """Options of an edition.

    confidence_factor : FC [-] in place of that of the level of knowledge; one below it is shown and never decides
    limit_states : to check
    behaviour_factor : q of the linear check at SLV [-]
    """

    confidence_factor: float | None = None
    limit_states: tuple[str, ...] = ("SLV",)
    behaviour_factor: float = 2.0

    def among(self, known: Container[str]) -> tuple[str, ...]:
        """Return the limit states asked for that a procedure knows."""
        return tuple(state for state in self.limit_states if state in known)
