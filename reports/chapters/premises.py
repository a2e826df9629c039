"""What the verdict rests on besides the calculation: knowledge level, sound masonry, ties that last, seats."""

from __future__ import annotations

from collections.abc import Iterator

from assess.codes.check import Check
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters.mechanism_list import mechanism_list
from reports.language.texts import Listing, Text, Verbatim, names, quantity, say
from reports.project_text import project_text

FACTOR = "FC"  # symbol of the step that states the confidence factor
SOUND = ".disintegration"


def knowledge(results: Results) -> Text | None:
    """Return knowledge levels and confidence factors of the deciding checks; None where no code asks for them."""
    found: dict[tuple[str, float], list[str]] = {}
    for mechanism in results.mechanisms:
        stated = knowledge_of(results, mechanism)
        if stated is not None:
            found.setdefault(stated, []).append(mechanism.name)
    texts = [
        say(
            "{factor} for {mechanisms}",
            factor=factor_text(level, factor),
            mechanisms=mechanism_list(results, owners),
        )
        for (level, factor), owners in found.items()
    ]
    return Listing(tuple(texts), "") if texts else None


def knowledge_of(results: Results, mechanism: MechanismResult) -> tuple[str, float] | None:
    """Return knowledge level, "" if none is given, and confidence factor of the deciding check of a mechanism."""
    deciding = (check for check in governing.at_site(results, mechanism) if check.role == "deciding")
    for check in deciding:
        factors = [step.value for step in check.steps if step.symbol == FACTOR]
        if factors and isinstance(factors[0], float):
            return _level(results, check, mechanism.name), factors[0]
    return None


def factor_text(level: str, factor: float) -> Text:
    """Return a confidence factor with its knowledge level."""
    if not level:
        return say("confidence factor FC = {factor}", factor=quantity(factor, figures=3))
    return say(
        "{level}, confidence factor FC = {factor}",
        level=Verbatim(level),
        factor=quantity(factor, figures=3),
    )


def _level(results: Results, check: Check, mechanism: str) -> str:
    table = f"procedures.{check.procedure.partition('-')[0]}"
    own = results.project.get(f"{table}.knowledge_levels")
    levels = own.value if own is not None and isinstance(own.value, dict) else {}
    given = levels.get(mechanism) or project_text(results, f"{table}.knowledge_levels.{mechanism}")
    return str(given or project_text(results, f"{table}.knowledge_level"))


def premises(results: Results) -> Iterator[Text]:
    """Yield what the user vouches for and the deciding answers count on."""
    sound = [key for key in results.project if key.endswith(SOUND) and project_text(results, key) == "excluded"]
    if sound and any(knowledge_of(results, mechanism) for mechanism in results.mechanisms):
        yield say(
            "the masonry does not disintegrate, as the project states for {masonry}",
            masonry=names(key.removesuffix(SOUND).partition(".")[2] for key in sound),
        )
    tied = _with_load(results, "to collapse")
    if tied:
        yield say(
            "ties and forces of {mechanisms} last up to collapse, as the project states",
            mechanisms=mechanism_list(results, tied),
        )
    seated = [each.name for each in results.mechanisms if any(load.seat_m is not None for load in each.loads)]
    if seated:
        yield say(
            "the loads that rest on {mechanisms} have the seats that the project gives",
            mechanisms=mechanism_list(results, seated),
        )


def _with_load(results: Results, lasting: str) -> list[str]:
    """Return the mechanisms with a load that is stated to last so long."""
    return [each.name for each in results.mechanisms if any(load.lasting == lasting for load in each.loads)]
