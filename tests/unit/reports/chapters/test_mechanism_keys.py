"""Keys of the project file belong to the mechanism with the longest name that they begin with."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results import Results
from reports.project_values import split_key, starred_key


@pytest.mark.parametrize(
    ("key", "owner", "rest", "starred"),
    [
        ("mechanisms.wall", "wall", "", "mechanisms.*"),
        ("mechanisms.wall.sides", "wall", "sides", "mechanisms.*.sides"),
        ("mechanisms.wall.a.sides", "wall.a", "sides", "mechanisms.*.sides"),
        ("mechanisms.walls.sides", "", "mechanisms.walls.sides", "mechanisms.walls.sides"),
        ("mechanisms", "", "mechanisms", "mechanisms"),
        ("materials.wall.density", "", "materials.wall.density", "materials.wall.density"),
    ],
)
def test_a_key_is_split_after_the_longest_name(results: Results, key: str, owner: str, rest: str, starred: str) -> None:
    wall, parapet = results.mechanisms
    named = replace(results, mechanisms=(replace(wall, name="wall"), replace(parapet, name="wall.a")))
    assert split_key(named, key) == (owner, rest)
    assert starred_key(named, key) == (owner, starred)
