"""What is refused must be worth refusing: projects that an honest engineer writes keep their pass."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path

import pytest

from assess.codes.verdict import Decision
from assess.project.build import build_to_decide
from assess.project.project_file import load_tree
from assess.study.run import find_verdict
from tests.support.honest_projects import HONEST
from tools.adversary.trials import answer


@pytest.mark.parametrize("name", HONEST)
def test_an_honest_project_passes(name: str) -> None:
    found = answer(HONEST[name])
    assert found is not None
    assert found.outcome == Decision.PASS


def test_there_are_forty_of_them() -> None:
    assert len(HONEST) >= 40


@pytest.mark.parametrize(
    ("level", "spectrum", "outcome", "keys"),
    [
        (None, {"r": 1.0}, "incomplete", ["building.importance_level"]),
        (1, {"r": 1.0}, "pass", []),
        (2, {"r": 1.0}, "pass", []),
        (2, {"return_period": "500 years"}, "pass", []),
        (3, {"r": 1.0}, "incomplete", ["site.spectrum.r"]),
        (3, {"return_period": "500 years"}, "incomplete", ["site.spectrum.return_period"]),
        (3, {"return_period": "1000 years"}, "pass", []),
        (4, {"r": 1.3}, "incomplete", ["site.spectrum.r"]),
        (4, {"r": 1.8}, "pass", []),
    ],
)
def test_the_return_period_is_that_of_the_importance_level(level, spectrum, outcome, keys) -> None:
    """ULS at 100, 500, 1000 and 2500 years, R = 0.5, 1, 1.3 and 1.8: a wall that passes at R = 1.8."""
    project = deepcopy(HONEST["NZ wall"])
    project["building"]["importance_level"] = level
    project["site"]["spectrum"] = {"code": "nzs1170.5", "z": 0.07, "subsoil": "C", **spectrum}
    if level is None:
        del project["building"]["importance_level"]
    found = find_verdict(build_to_decide(load_tree(project, Path("project.toml"), sha256="")), jobs=1)
    assert (found.outcome, [each.key for each in found.missing]) == (outcome, keys)
