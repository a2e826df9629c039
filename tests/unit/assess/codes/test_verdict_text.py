"""Words of verdicts where a number is not known."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from assess.codes.verdict import building_index_text, number_text, target_text


@pytest.mark.parametrize(("target", "text"), [(None, ""), (0.65, "0.65"), (1.0, "1"), (0.12345, "0.123")])
def test_the_target_of_an_index(target: float | None, text: str) -> None:
    assert target_text(SimpleNamespace(target=target)) == text


def test_an_index_that_is_not_known_has_no_text() -> None:
    assert building_index_text(SimpleNamespace(index=None)) == ""


@pytest.mark.parametrize(
    ("value", "number", "text"), [(1.0, 3, "1.00"), (0.98765, 3, "0.988"), (12.3456, 4, "12.35"), (0.5, 2, "0.50")]
)
def test_figures_keep_their_zeros(value: float, number: int, text: str) -> None:
    assert number_text(value, number) == text
