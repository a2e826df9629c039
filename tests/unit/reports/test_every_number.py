"""Every number of a report is one of its results, rounded once: within half a unit of its last digit in any units."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results import Results
from reports.assessment import assessment
from reports.language.locale import Locale
from tests.support.document_numbers import misread, shown_numbers, strange_numbers

LOCALES = [Locale("en", "SI"), Locale("en", "US"), Locale("it", "SI"), Locale("it", "US")]


@pytest.mark.parametrize("locale", LOCALES, ids=lambda each: f"{each.language}-{each.system}")
def test_numbers_are_within_half_a_unit_of_their_last_digit(results: Results, locale: Locale) -> None:
    document = replace(assessment(results, detail="full"), locale=locale)
    shown = list(shown_numbers(document, document.writer))
    assert len(shown) > 1000
    assert [each for each in shown if misread(each, point=locale.point)] == []


def test_numbers_are_those_of_the_results(results: Results) -> None:
    assert strange_numbers(results) == set()
