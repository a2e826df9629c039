"""What is refused must be worth refusing: projects that an honest engineer writes keep their pass."""

from __future__ import annotations

import pytest

from assess.codes.verdict import Decision
from tests.support.honest_projects import HONEST
from tools.adversary.trials import answer


@pytest.mark.parametrize("name", HONEST)
def test_an_honest_project_passes(name: str) -> None:
    found = answer(HONEST[name])
    assert found is not None
    assert found.outcome == Decision.PASS


def test_there_are_forty_of_them() -> None:
    assert len(HONEST) >= 40
