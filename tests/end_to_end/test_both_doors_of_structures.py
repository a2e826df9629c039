"""What a project file refuses of a body, its masonry and the building is refused from Python for the same reason."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, nan
from pathlib import Path
from typing import Any

import pytest

import assess
from assess.errors import AssessError, ProjectError, other_faults
from assess.project.project_file import load
from tests.support.projects import project_toml, wall, write_project

ABOVE_0 = "must be greater than 0"
NOT_NEGATIVE = "must be 0 or more"
NO_MASONRY = "must be greater than 0 and 50 MPa or less, beyond which there is no masonry"
NO_DAMPING = "must be greater than 0 and 0.3 or less; 0.05 is 5 % of critical"
SIZES = {"thickness": 0.6, "length": 3.0, "height": 4.0}
MASONRY = {"density": 1800.0}
BUILDING = {"height": 9.0}


def box(**keys: Any) -> None:
    assess.box(**{**keys, "density": 1800.0})


def masonry(**keys: Any) -> None:
    body = assess.box(**SIZES, density=assess.Material(name="brick", **keys), name="wall")
    assess.single_block(body, direction=(1.0, 0.0, 0.0), sides="one")


def building(**keys: Any) -> None:
    assess.building(**keys)


PLACES: dict[Callable[..., None], tuple[str, dict[str, Any], Callable[[dict[str, Any]], str]]] = {
    box: ("bodies.wall.box", SIZES, lambda keys: project_toml(bodies={"wall": wall(**keys)})),
    masonry: ("materials.brick", MASONRY, lambda keys: project_toml(materials={"brick": keys})),
    building: ("building", BUILDING, lambda keys: project_toml(building=keys)),
}
"""By what makes it in Python: where the file has it, what is right of it, and a project with these keys."""
FAULTS: list[tuple[Callable[..., None], dict[str, Any], str]] = [
    (box, {"thickness": 0.0}, ABOVE_0),
    (box, {"length": -3.0}, ABOVE_0),
    (masonry, {"density": -1800.0}, ABOVE_0),
    (masonry, {"young_modulus": 0.0}, ABOVE_0),
    (masonry, {"compressive_strength": 6e7}, NO_MASONRY),
    (masonry, {"compressive_strength": -1e6}, NO_MASONRY),
    (masonry, {"tensile_strength": -1.0}, NOT_NEGATIVE),
    (masonry, {"friction": -0.1}, NOT_NEGATIVE),
    (building, {"height": 0.0}, ABOVE_0),
    (building, {"storeys": 0}, "must be 1 or more"),
    (building, {"period": -0.2}, ABOVE_0),
    (building, {"damping": 0.5}, NO_DAMPING),
    (building, {"damping": 5.0}, NO_DAMPING),
]
OTHER_REMEDIES: list[tuple[Callable[..., None], dict[str, Any], str]] = [
    # the project file names units, Python what it takes
    (box, {"thickness": True}, "not a number"),
    (box, {"height": 1e12}, "outside 1e-09 to 1e+08"),
    (box, {"height": nan}, "not a finite number"),
    (box, {"thickness": inf}, "not a finite number"),
    (masonry, {"friction": "rough"}, "not a number"),
    (masonry, {"density": 1e-4}, "outside 0.001 to 100000"),
    (building, {"storeys": 2.5}, "not a whole number"),
    (building, {"height": True}, "not a number"),
]


def refusals(make: Callable[..., None], fault: dict[str, Any], folder: Path) -> tuple[str, str]:
    """Return what the project file and what Python say, each from the key on."""
    place, sound, text = PLACES[make]
    (key,) = fault
    by_file = by_python = ""
    try:
        load(write_project(folder, text(sound | fault)))
    except ProjectError as error:
        by_file = str(error).removesuffix(f" (and {len(other_faults(error))} more)").partition(f"{place}.")[2]
    try:
        make(**(sound | fault))
    except AssessError as error:
        by_python = key + str(error).partition(key)[2]
    return by_file, by_python


@pytest.mark.parametrize(("make", "fault", "said"), FAULTS)
def test_a_structure_is_refused_for_one_reason(make, fault, said, tmp_path):
    for refusal in refusals(make, fault, tmp_path):
        assert refusal.startswith(next(iter(fault)))
        assert refusal.endswith(f": {said}")


@pytest.mark.parametrize(("make", "fault", "said"), OTHER_REMEDIES)
def test_a_structure_is_refused_with_what_each_door_takes(make, fault, said, tmp_path):
    for refusal in refusals(make, fault, tmp_path):
        assert refusal.startswith(next(iter(fault)))
        assert said in refusal


@pytest.mark.parametrize("make", PLACES)
def test_what_is_right_is_taken_by_both(make, tmp_path):
    _, sound, text = PLACES[make]
    load(write_project(tmp_path, text(sound)))
    make(**sound)
