"""What mechanisms and procedures are called in the report: titles, numbers, and lists as "M1, M3 to M5 and M8"."""

from __future__ import annotations

import re
from collections.abc import Iterable

from assess.codes.check import Check
from assess.codes.procedures import PROCEDURES
from assess.results import MechanismResult, Results
from reports.language.texts import Text, Verbatim, listing, say


def mechanism_title(mechanism: MechanismResult) -> str:
    """Return the mechanism's label, or its name where it has none."""
    return mechanism.label or mechanism.name


def mechanism_number(results: Results, name: str) -> str:
    """Return the number of a mechanism by its name: "M1" for the first of the results."""
    place = next(place for place, each in enumerate(results.mechanisms, start=1) if each.name == name)
    return f"M{place}"


def numbered_title(results: Results, name: str) -> Verbatim:
    """Return number and title of a mechanism by its name: "M1 Wall 6"."""
    found = next(each for each in results.mechanisms if each.name == name)
    return Verbatim(f"{mechanism_number(results, name)} {mechanism_title(found)}")


def procedure_title(procedure: str) -> Text:
    """Return the title of a procedure; the name itself of one that is not known."""
    return PROCEDURES[procedure].title if procedure in PROCEDURES else Verbatim(procedure)


def short_title(procedure: str) -> Text:
    """Return the short title of a procedure; the name itself of one that is not known."""
    return PROCEDURES[procedure].short_title if procedure in PROCEDURES else Verbatim(procedure)


def check_title(check: Check, among: tuple[Check, ...]) -> Text:
    """Return the title of a check's procedure, with its limit state where `among` has several of the same procedure."""
    return _with_state(procedure_title(check.procedure), check, among)


def short_check_title(check: Check, among: tuple[Check, ...]) -> Text:
    """Return the short title of a check's procedure, with its limit state as `check_title` has it."""
    return _with_state(short_title(check.procedure), check, among)


def _with_state(title: Text, check: Check, among: tuple[Check, ...]) -> Text:
    states = {other.limit_state for other in among if other.procedure == check.procedure}
    if len(states) < 2:
        return title
    return say("{procedure}, {limit_state}", procedure=title, limit_state=Verbatim(check.limit_state))


def file_stem(name: str, place: int) -> str:
    """Return a unique and safe beginning for the file names of a mechanism: its place and its name in plain letters."""
    plain = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:40].strip("-")
    return f"{place:02d}-{plain}" if plain else f"{place:02d}"


SHORTEST_RANGE = 3  # numbers in a row that become a range


def mechanism_list(results: Results, names: Iterable[str]) -> Text:
    """Return mechanisms, by their names, as numbers in order, rows of them as ranges; all of several as such."""
    wanted = set(names)
    places = [place for place, each in enumerate(results.mechanisms) if each.name in wanted]
    if len(places) == len(results.mechanisms) > 1:
        return say("all mechanisms")
    numbers = [mechanism_number(results, results.mechanisms[place].name) for place in places]
    return listing(text for run in _neighbours(places, numbers) for text in _range_texts(run))


def _neighbours(places: list[int], numbers: list[str]) -> list[list[str]]:
    """Return the numbers in groups of neighbours."""
    runs: list[list[str]] = []
    for index, (place, number) in enumerate(zip(places, numbers, strict=True)):
        if index and place == places[index - 1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return runs


def _range_texts(run: list[str]) -> list[Text]:
    if len(run) < SHORTEST_RANGE:
        return [Verbatim(number) for number in run]
    return [say("{first} to {last}", first=Verbatim(run[0]), last=Verbatim(run[-1]))]
