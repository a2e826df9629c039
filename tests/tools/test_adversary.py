"""A sample of what a reviewing authority would try: `make adversary` tries all of it."""

from __future__ import annotations

from copy import deepcopy
from dataclasses import replace
from functools import cache

import pytest

from assess.codes.verdict import Decision
from tools.adversary.projects import PROJECTS
from tools.adversary.trials import (
    SILENT,
    TOLD,
    Trial,
    answer,
    geometry,
    histories,
    is_told,
    outcome_of,
    pairs,
    sample,
    trials,
    with_trial,
)

SHARES = {"trials": 75, "pairs": 30, "geometry": 30, "histories": 8}
"""Trials of the sample: some ten seconds, and as many for those by histories."""


def test_every_project_fails_as_it_is() -> None:
    found = {name: answer(tables) for name, tables in PROJECTS.items()}
    assert {name: None if each is None else each.outcome for name, each in found.items()} == dict.fromkeys(
        PROJECTS, Decision.FAIL
    )


@pytest.mark.parametrize("kind", SHARES)
def test_no_value_buys_an_outcome_in_silence(kind: str) -> None:
    found = {str(trial): outcome_of(trial) for trial in _drawn()[kind]}
    assert [name for name, (word, _) in found.items() if word == SILENT] == []


@pytest.mark.parametrize("name", PROJECTS)
def test_a_condition_that_a_project_has_whatever_is_typed_tells_nothing(name: str) -> None:
    """Under a hardly felt action it passes, or lacks what it lacks anyhow: what is then named would hide any trial."""
    weak = deepcopy(PROJECTS[name])
    spectrum = weak["site"]["spectrum"]
    spectrum.update({key: 1e-3 if key == "z" else "0.001 g" for key in ("a_g", "s_ds", "z") if key in spectrum})
    spectrum.update({"s_d1": "0.0005 g"} if "s_d1" in spectrum else {})
    found = answer(weak)
    assert found is not None
    assert found.outcome != Decision.FAIL
    assert not [each for each in found.named if each.startswith("condition ")]


def test_pairs_are_at_two_keys_of_one_table() -> None:
    for pair in _drawn()["pairs"]:
        one, other = pair.paths
        assert one != other
        assert one[:-1] == other[:-1]


@cache
def _drawn() -> dict[str, list[Trial]]:
    singles = list(trials())
    return {
        "trials": sample(singles, SHARES["trials"], seed=1),
        "pairs": pairs(singles, SHARES["pairs"], seed=1),
        "geometry": sample(list(geometry()), SHARES["geometry"], seed=1),
        "histories": sample(list(histories()), SHARES["histories"], seed=1),
    }


@pytest.mark.parametrize(
    ("project", "path", "value"),
    [
        ("ntc-two-block", ("mechanisms", "wall", "crack"), 0.1),
        ("ntc-free", ("mechanisms", "wall", "direction"), [1, 3, 0]),
        ("ntc-upstairs", ("building", "height"), 300.0),
        ("ntc-wall", ("mechanisms", "wall", "loads", 1, "at"), [-2.9, 4.5]),
    ],
)
def test_what_once_bought_a_pass_no_longer_does(project: str, path: tuple[str | int, ...], value: object) -> None:
    """A crack next to the floor, a wall along its length, a building too high, a tie in the air."""
    trial = Trial(project, path, value, "")
    after = answer(with_trial(PROJECTS[project], trial))
    assert after is not None
    assert after.outcome != Decision.PASS


def test_an_improvement_that_nothing_names_is_silent() -> None:
    before, trial = answer(PROJECTS["ntc-free"]), Trial("ntc-free", ("building", "storeys"), 3, "drawn")
    assert before is not None
    bought = replace(before, outcome=Decision.PASS)
    assert bought.improves(before)
    assert not is_told(trial, before, bought)
    assert is_told(trial, before, replace(bought, named=frozenset({"building.storeys"})))
    assert TOLD != SILENT
