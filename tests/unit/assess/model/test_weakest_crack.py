"""The weakest crack of a block that is known, against Housner's block and what is found level by level."""

from __future__ import annotations

from dataclasses import replace
from math import radians

import pytest

from assess.errors import MechanismError
from assess.mechanisms.chain import uplift_multiplier
from assess.mechanisms.mechanism import CutAngle
from assess.mechanisms.single_block import SingleBlock
from assess.model.assembly import on_rigid_hinges
from assess.model.weakest_crack import SLIVER, find_weakest_crack
from assess.project.build import build_with_cases
from assess.project.project_file import load
from tests.support.projects import project_toml, write_project

WALL = SingleBlock(blocks=(("wall",),), direction=(1.0, 0.0, 0.0), sides="one")


@pytest.fixture(scope="module")
def bodies(tmp_path_factory):
    built = build_with_cases(load(write_project(tmp_path_factory.mktemp("wall"), project_toml())))
    return built.bodies_at(built.project.content)


def test_it_is_no_stronger_than_any_other_crack(bodies):
    """Nor than the foot, from which a rigid wall of thickness t and height h rocks at t / h."""
    found = find_weakest_crack("wall", WALL, bodies)
    assert 0.0 < found.multiplier <= 0.6 / 4.0
    for elevation in (0.5, 1.5, 2.5):
        for angle in (0.0, 20.0, 50.0):
            cracked = replace(WALL, cut=CutAngle((0.3, 0.0, elevation), radians(angle)))
            other = uplift_multiplier(on_rigid_hinges("wall", cracked, bodies)[0].positive)
            assert found.multiplier <= other * (1.0 + 1e-9)


def test_an_end_of_what_is_looked_at_is_told_and_no_sliver_is_found(bodies):
    """The higher the part, the weaker: of a plain wall the crack begins at its foot."""
    tried = []
    found = find_weakest_crack("wall", WALL, bodies, progress=tried.append)
    assert "the foot" in found.ends
    assert SLIVER <= found.share < 1.0
    assert tried == list(range(1, len(tried) + 1))


def test_a_block_without_geometry_has_none(bodies):
    with pytest.raises(MechanismError, match="no geometry to be cracked"):
        find_weakest_crack("wall", WALL, {"wall": replace(bodies["wall"], solid=None)})
