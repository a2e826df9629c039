"""Every number of a report is one of its results, rounded once: within half a unit of its last digit in any units."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from assess.results import Results
from reports.assessment import assessment
from reports.language.locale import Locale
from tests.support.document_numbers import is_known, misread, numbers_of, shown_numbers

LOCALES = [Locale("en", "SI"), Locale("en", "US"), Locale("it", "SI"), Locale("it", "US")]


@pytest.mark.parametrize("locale", LOCALES, ids=lambda each: f"{each.language}-{each.system}")
def test_numbers_are_within_half_a_unit_of_their_last_digit(results: Results, locale: Locale) -> None:
    document = replace(assessment(results, detail="full"), locale=locale)
    shown = list(shown_numbers(document, document.writer))
    assert len(shown) > 1000
    assert [each for each in shown if misread(each, point=locale.point)] == []


def test_numbers_are_those_of_the_results(results: Results) -> None:
    """What is not in results is counted from them, or said in a sentence as a fixed number of the method."""
    document = assessment(results, detail="full")
    known = sorted([*numbers_of(results), *_quotients_of_capacities(results)])
    strange = {
        (each.where, each.text)
        for each in shown_numbers(document, document.writer)
        if not known_or_small(each.value, known)
    }
    assert strange == set()


def _quotients_of_capacities(results: Results) -> Iterator[float]:
    """Yield by how much the capacities of a mechanism by two methods differ, which a sentence compares."""
    for mechanism in results.mechanisms:
        found = [check.capacity_pga_g for check in mechanism.checks if check.capacity_pga_g]
        yield from (one / other for one in found for other in found)


def known_or_small(value: float, known: list[float]) -> bool:
    """Return whether a number is of the results, or a small whole one: a count, or the place in a list."""
    return is_known(value, known) or (value == int(value) and 0 <= value < 1000)
