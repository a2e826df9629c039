"""Cracks and ends of ties that are dragged: where they are, and what the file says when they have moved."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, radians, tan
from pathlib import Path

import numpy as np
import pytest

from assess.project.build import build
from assess.project.dragged import Crack, crack_entry, crack_of, end_value, tie_ends
from assess.project.site_and_structure import definitions_of
from assess.results import MechanismResult
from assess.study.mechanism_results import parameters
from tests.support.projects import block, load_project, project_toml

ALONG = (0.6, 0.8, 0.0)
TIE = {"kind": "tie", "force": "10 kN", "both": True}


def stated(folder: Path, **mechanism) -> tuple[object, MechanismResult, dict]:
    """A wall as it is stated, as it is found, and as the file has it."""
    text = project_toml(mechanisms={"wall": block(direction=(*ALONG[:2], 0), sides="two", **mechanism)})
    project = load_project(folder, text)
    (result,) = parameters(build(project))
    return definitions_of(project.content)["wall"], result, dict(project.raw["mechanisms"]["wall"])


def moved(before: Crack, **changes) -> Crack:
    return replace(before, **changes)


def written_crack(folder: Path, written: dict, **changes) -> tuple[str, object]:
    definition, result, table = stated(folder, **written)
    before = crack_of(definition, result)
    assert before is not None
    key, value = crack_entry("wall", before, moved(before, **changes), written=table, along=ALONG)
    assert key[:2] == ("mechanisms", "wall")
    return key[2], value


def test_a_level_crack_is_an_elevation_until_it_is_turned(tmp_path):
    definition, result, _ = stated(tmp_path, cut="1 m")
    crack = crack_of(definition, result)
    assert crack is not None
    assert (crack.point[2], crack.angle, crack.aside, crack.turns) == (1.0, 0.0, 0.0, True)
    assert written_crack(tmp_path, {"cut": "1 m"}, point=(*crack.point[:2], 1.5)) == ("cut", "1.5 m")
    key, value = written_crack(tmp_path, {"cut": "1 m"}, angle=radians(20.0))
    assert (key, value["angle"]) == ("cut", "20.00 deg")


def test_what_stays_of_a_crack_stays_as_it_is_written(tmp_path):
    cut = {"point": ["0 m", "10 cm", "4 ft"], "angle": "10 deg"}
    assert written_crack(tmp_path, {"cut": cut}, angle=radians(20.0)) == ("cut", cut | {"angle": "20.00 deg"})


NORMAL = (0.3, -0.2, 2.0)  # falls towards the direction by its dot product 0.02, and to the left by -0.36


def test_a_crack_by_its_normal_turns_in_the_plane_of_motion(tmp_path):
    """The part of the normal aside of the motion stays, and the rest is inclined as the crack is."""
    cut = {"point": [0, 0, 1.5], "normal": list(NORMAL)}
    definition, result, _ = stated(tmp_path, cut=cut)
    crack = crack_of(definition, result)
    assert crack is not None
    assert crack.angle == pytest.approx(atan2(0.3 * 0.6 - 0.2 * 0.8, 2.0))
    assert np.sin(crack.aside) == pytest.approx((-0.3 * 0.8 - 0.2 * 0.6) / np.linalg.norm(NORMAL))
    key, value = written_crack(tmp_path, {"cut": cut}, angle=0.3)
    assert key == "cut"
    assert value["point"] == [0, 0, 1.5]
    normal = np.array(value["normal"])
    assert np.linalg.norm(normal) == pytest.approx(1.0, abs=1e-4)
    assert normal @ ALONG / normal[2] == pytest.approx(tan(0.3), abs=2e-4)
    assert normal @ [-0.8, 0.6, 0.0] == pytest.approx(np.sin(crack.aside), abs=1e-4)
    _, value = written_crack(tmp_path, {"cut": cut}, point=(0.0, 0.0, 1.75))
    assert value == {"point": [0, 0, 1.75], "normal": list(NORMAL)}


@pytest.mark.parametrize("given", [{}, {"crack": "minimum"}, {"crack": "2 m"}])
def test_a_wall_of_two_blocks_has_a_level_crack(tmp_path, given):
    given = given | {"loads": [{"kind": "overburden", "force": "200 kN", "eccentricity": 0}]}
    definition, result, _ = stated(tmp_path, kind="two-block", **given)
    crack = crack_of(definition, result)
    assert crack is not None
    (hinge,) = (each.at[1] for each in result.drawing.hinges if each.name == "B")
    assert crack.point[2] == pytest.approx(hinge, abs=1e-3)
    assert not crack.turns
    to = (*crack.point[:2], 2.5)
    assert written_crack(tmp_path, {"kind": "two-block", **given}, point=to) == ("crack", "2.5 m")


def test_a_wall_of_stated_hinges_has_no_crack_to_move(tmp_path):
    hinges = {"A": [0.3, 0], "B": [-0.3, 2], "C": [0.3, 4]}
    definition, result, _ = stated(tmp_path, kind="two-block", hinges=hinges)
    assert crack_of(definition, result) is None


def test_ends_of_ties_are_in_space(tmp_path):
    """By three numbers as they are, by two in the middle of the wall across the motion, which passes the origin."""
    loads = [
        {"kind": "mass", "mass": "100 kg", "at": [0, 0, 4]},
        TIE | {"at": [0.1, 0.2, 3.5], "anchor": [-3, -4, 3.5]},
        TIE | {"at": [0.2, 3], "direction": [-1, 0]},
    ]
    definition, result, _ = stated(tmp_path, loads=loads)
    ends = tie_ends("wall", definition, result)
    place = ("mechanisms", "wall", "loads")
    assert ends[*place, 1, "at"] == (0.1, 0.2, 3.5)
    assert ends[*place, 1, "anchor"] == (-3.0, -4.0, 3.5)
    assert ends[*place, 2, "at"] == pytest.approx((0.12, 0.16, 3.0), abs=1e-6)
    assert len(ends) == 3
    assert set(tie_ends("wall", definition, None)) == {(*place, 1, "at"), (*place, 1, "anchor")}


def test_an_end_is_written_as_it_was_given():
    assert end_value((1.23456, 2.0, 3.0), [0, 0, 0], ALONG) == [1.2346, 2.0, 3.0]
    assert end_value((0.6, 0.8, 3.0), [0, "3 m"], ALONG) == [1.0, 3.0]
