"""The keys of the project file that would answer a check which is not answered, by its reason."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from assess.codes.check import Check, Family, Outcome, Reason
from assess.codes.families import FAMILIES
from assess.codes.verdict.question import Missing, missing_input
from assess.messages.message import Message, message

Line = tuple[str, str]
"""A key, with the mechanism's name for {}, and a line of TOML."""

FILTER: Line = ("mechanisms.{}.amplification", 'amplification = { method = "modal-filter" }')
HEIGHT: Line = ("building.height", 'height = "9 m"')
STOREYS: Line = ("building.storeys", "storeys = 2")
GROUND: Line = ("building.ground_elevation", "ground_elevation = 0.0")
BASE: Line = ("mechanisms.{}.base_elevation", "")
SEAT: Line = ("mechanisms.{}.loads", '# in the load: seat = "0.12 m"')
RECORDS: Line = ("records.files", 'files = ["records/*.AT2"]')
TABLE: Line = ("site.spectrum.file", "")

AT_HEIGHT: Mapping[Family, tuple[Line, ...]] = {
    Family.LINEAR: (HEIGHT, STOREYS),
    Family.DISPLACEMENT: (HEIGHT, STOREYS),
    Family.ELEMENT: (HEIGHT,),
    Family.PART: (HEIGHT,),
    Family.HISTORY: (FILTER,),
    Family.ENERGY: (FILTER,),
    Family.FRICTION: (FILTER,),
}
REMEDIES: Mapping[Reason, tuple[Line, ...]] = {
    Reason.SCALAR_MOTION: (FILTER,),
    Reason.GROUND_UNKNOWN: (GROUND,),
    Reason.GROUND_CONTRADICTED: (BASE,),
    Reason.STOREY_UNKNOWN: (HEIGHT, STOREYS),
    Reason.ABOVE_BUILDING: (HEIGHT, GROUND),
    Reason.SEAT_UNKNOWN: (SEAT,),
    Reason.TOO_FEW_RECORDS: (RECORDS,),
    Reason.SPECTRUM_TOO_SHORT: (TABLE,),
}


def missing_keys(mechanism: str, checks: Sequence[Check]) -> tuple[Missing, ...]:
    """Return the keys that would answer these checks of a mechanism; its own table where no key is known.

    A reason that names its key has it in `where`.

    Parameters
    ----------
    mechanism : its name
    checks : those that are not answered

    Returns
    -------
    tuple of Missing
    """
    return tuple(missing for check in checks for missing in _of(mechanism, check))


def _of(mechanism: str, check: Check) -> tuple[Missing, ...]:
    return tuple(missing for reason in _reasons(check) for missing in _by_reason(mechanism, check, reason))


def _by_reason(mechanism: str, check: Check, reason: Message) -> tuple[Missing, ...]:
    why = message("missing-of-mechanism", {"mechanism": mechanism, "procedure": check.procedure, "reason": reason})
    if reason.where:  # of the whole project, as a suite of records is, said once for all mechanisms
        own = reason.where.startswith("mechanisms.")
        line = str(reason.values.get("toml", ""))
        return (missing_input(reason.where, why if own else reason, line, reasons=(reason,)),)
    lines = _lines(check, reason)
    if not lines:
        return (missing_input(f"mechanisms.{mechanism}", why, reasons=(reason,)),)
    return tuple(missing_input(key.format(mechanism), why, toml, reasons=(reason,)) for key, toml in lines)


def _reasons(check: Check) -> tuple[Message, ...]:
    """Return why a check is not answered, or why one that fails cannot pass at a lower target; nothing of one that is.

    Further reasons whose key is known are among the remarks.
    """
    if check.verdict == Outcome.NOT_ANSWERED:
        return (check.reason, *(each for each in check.remarks if each.where or _known(each)))
    low = (each for each in check.remarks if _known(each))
    return tuple(low)[:1]


def _known(reason: Message) -> bool:
    return reason.key == Reason.GROUND_MOTION or reason.key in REMEDIES


def _lines(check: Check, reason: Message) -> tuple[Line, ...]:
    if reason.key == Reason.GROUND_MOTION:
        return AT_HEIGHT.get(FAMILIES[check.procedure], ())
    return next((lines for key, lines in REMEDIES.items() if key == reason.key), ())
