"""The comparison of results by `make same` sees every number, also in sentences, and names of two words."""

from __future__ import annotations

from typing import Any

import pytest

from tools.same.compare import differences


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ({"x": 1.0}, {"x": 1.0 + 2.0**-52}),
        ({"x": 0.0}, {"x": -0.0}),
        ({"x": 1}, {"x": 1.0}),
        ({"x": None}, {"x": "a reason"}),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        ({"names": ["W1", "W2"]}, {"names": ["W1"]}),
        ({"verdict": "not met"}, {"verdict": "met in part"}),
        ({"name": "tie 1"}, {"name": "bar 1"}),
        ({"text": "it overturns at 0.21 g"}, {"text": "it overturns at 0.31 g"}),
        ({"substituted": "1.2 · 3.4 / 5"}, {"substituted": "1.2 · 3.5 / 5"}),
    ],
)
def test_more_than_words_changed(before: Any, after: Any) -> None:
    assert [each.words for each in differences(before, after)].count(False) >= 1


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ({"text": "it overturns at 0.21 g"}, {"text": "overturned at 0.21 g"}),
        ({"assumptions": ["one told so"]}, {"assumptions": ["said plainly", "and once more"]}),
    ],
)
def test_words_alone_changed(before: Any, after: Any) -> None:
    assert all(each.words for each in differences(before, after))


def test_equal_results_have_no_difference() -> None:
    assert not list(differences({"x": [1.0, float("nan")], "t": "a b"}, {"x": [1.0, float("nan")], "t": "a b"}))
