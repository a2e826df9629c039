"""The list of equivalent mutants names what still stands in the sources, each with a reason."""

from __future__ import annotations

import pytest

from tests.support.places import place_of
from tools.mutate.equivalent import listed


@pytest.mark.parametrize(
    ("key", "reason"), listed().items(), ids=lambda each: each[0] if isinstance(each, tuple) else ""
)
def test_an_equivalent_mutant_can_still_be_made(key: tuple[str, str, str, str], reason: str) -> None:
    path, function, before, after = key
    lines = [line.strip() for line in place_of(path).read_text(encoding="utf-8").splitlines()]
    assert set(before.splitlines()) <= set(lines)
    assert before != after
    assert not function or f" {function.split('.')[-1]}" in "\n".join(lines)
    assert len(reason.split()) > 3
