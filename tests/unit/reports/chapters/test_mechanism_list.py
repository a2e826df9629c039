"""Mechanisms in a sentence are numbers in order, long rows of them as ranges."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results import Results
from reports.mechanisms import mechanism_list
from tests.support.letters import letters


@pytest.mark.parametrize(
    ("places", "said"),
    [
        ([], ""),
        ([3], "M3"),
        ([2, 1], "M1 and M2"),
        ([1, 2, 3], "M1 to M3"),
        ([5, 3, 4, 1, 8], "M1, M3 to M5 and M8"),
        ([1, 1, 4], "M1 and M4"),
        ([1, 2, 3, 4, 5, 6, 7, 8], "all mechanisms"),
    ],
)
def test_numbers_are_in_order_and_rows_are_ranges(results: Results, places: list[int], said: str) -> None:
    eight = replace(results, mechanisms=tuple(replace(results.mechanisms[0], name=f"w{n}") for n in range(1, 9)))
    assert letters(mechanism_list(eight, [f"w{place}" for place in places])) == said
    assert letters(mechanism_list(eight, (f"w{place}" for place in places))) == said  # names may come once


def test_the_only_mechanism_keeps_its_number(results: Results) -> None:
    one = replace(results, mechanisms=results.mechanisms[:1])
    assert letters(mechanism_list(one, ["wall-6"])) == "M1"
