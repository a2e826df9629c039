"""What an Italian check of one limit state lacks: a level of knowledge, a seat, the action of that limit state."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from assess.codes.check import Reason
from assess.codes.context import Context
from assess.codes.families import ITALIAN
from assess.messages.message import Message, Value, message

ORDER = ("SLO", "SLD", "SLV", "SLC")  # by rising action


@dataclass(frozen=True)
class MissingInput:
    """Why a check is not answered, and whether its numbers are those of the safe value of what is missing."""

    reason: Message
    safe: bool


def missing_inputs(procedure: str, state: str, context: Context) -> tuple[MissingInput, ...]:
    """Return everything that a check by an Italian procedure lacks; nothing for any other procedure."""
    code = ITALIAN.get(procedure)
    return () if code is None else tuple(_lacking(code, state, context))


def _lacking(code: str, state: str, context: Context) -> Iterator[MissingInput]:
    if context.crushing and code not in context.knowledge:
        key, toml = f"procedures.{code}.knowledge_level", 'knowledge_level = "LC1"'
        yield MissingInput(_reason(Reason.KNOWLEDGE_UNKNOWN, {"toml": toml}, where=key), safe=True)
    if state == "SLC" and context.open_seats:
        names = dict.fromkeys(each.what for each in context.open_seats)
        values: dict[str, Value] = {"what": ", ".join(names), "toml": 'seat = "0.12 m"'}
        yield MissingInput(_reason(Reason.SEAT_UNKNOWN, values), safe=False)
    if context.hazard is not None and state not in context.hazard.spectra:
        yield MissingInput(_reason(Reason.HAZARD_TOO_SHORT, {"state": state}, where="site.spectrum.hazard"), safe=False)
    declared = context.limit_state
    if context.hazard is None and declared is not None and declared in ORDER and declared != state:
        values = {"state": state, "declared": declared}
        stronger = ORDER.index(declared) >= ORDER.index(state)
        yield MissingInput(_reason(Reason.OTHER_LIMIT_STATE, values, where="site.spectrum.hazard"), safe=stronger)


def _reason(reason: Reason, values: dict[str, Value], *, where: str = "") -> Message:
    return message(reason, values, where=where)
