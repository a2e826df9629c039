"""Several mechanisms by their numbers: "M1, M3 to M5 and M8"."""

from __future__ import annotations

from collections.abc import Iterable

from assess.results import Results
from reports.language.texts import Text, Verbatim, listing, say
from reports.titles import mechanism_number

SHORTEST = 3  # numbers in a row that become a range


def mechanism_list(results: Results, names: Iterable[str]) -> Text:
    """Return mechanisms, by their names, as numbers in order, rows of them as ranges; all of several as such."""
    wanted = set(names)
    places = [place for place, each in enumerate(results.mechanisms) if each.name in wanted]
    if len(places) == len(results.mechanisms) > 1:
        return say("all mechanisms")
    numbers = [mechanism_number(results, results.mechanisms[place].name) for place in places]
    return listing(text for run in _runs(places, numbers) for text in _written(run))


def _runs(places: list[int], numbers: list[str]) -> list[list[str]]:
    """Return the numbers in groups of neighbours."""
    runs: list[list[str]] = []
    for index, (place, number) in enumerate(zip(places, numbers, strict=True)):
        if index and place == places[index - 1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return runs


def _written(run: list[str]) -> list[Text]:
    if len(run) < SHORTEST:
        return [Verbatim(number) for number in run]
    return [say("{first} to {last}", first=Verbatim(run[0]), last=Verbatim(run[-1]))]
