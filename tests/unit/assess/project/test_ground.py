"""Where the ground is, how high each mechanism stands over it, and what is said where nobody knows."""

from __future__ import annotations

from pathlib import Path

import pytest

from assess.cli.tables.project import description
from assess.codes.check import Outcome, Reason
from assess.project.project_file import load
from assess.study.amplification import BY_BODIES, BY_BUILDING, BY_MECHANISM, BY_TABLE, UNKNOWN, HeightAboveGround
from assess.study.mechanism_results import parameters
from tests.support.projects import ASCE7, box_toml, mechanism_toml, results_of, study_of, tables_toml

HEAD = tables_toml(site={"spectrum": ASCE7}, materials={"m": {"density": 2000}})
BUILDING = '[building]\nheight = "9 m"\n'
TABLE = '[mechanisms.t]\nkind = "equivalent-block"\np = 1.6\nuplift = 0.14\nradius = 2.84\n'


def wall(at: float, *, height: float = 3.0, name: str = "wall") -> str:
    return box_toml(name, (0.3, 4, height), (0, 0, at))


def height_of(folder: Path, *tables: str, name: str = "m") -> HeightAboveGround:
    return study_of(folder, HEAD, *tables).heights[name]


@pytest.mark.parametrize("at", [0.0, 0.5, -0.5])
def test_the_lowest_body_near_0_stands_on_the_ground(tmp_path: Path, at: float) -> None:
    found = height_of(tmp_path, wall(at), mechanism_toml())
    assert (found.base, found.source, found.unknown) == (at, BY_BODIES, ())
    assert not found.above


def test_the_rounding_of_a_file_of_millimetres_is_no_height(tmp_path: Path) -> None:
    assert height_of(tmp_path, wall(-8.6e-8), "[building]\nground_elevation = 0\n", mechanism_toml()).base == 0.0


@pytest.mark.parametrize("at", [0.51, 8.0, 120.0, -2.0])
def test_a_lowest_body_far_from_0_does_not_tell(tmp_path: Path, at: float) -> None:
    found = height_of(tmp_path, wall(at), mechanism_toml())
    assert found.source == UNKNOWN
    assert [each.key for each in found.unknown] == [Reason.GROUND_UNKNOWN]


def test_the_building_tells(tmp_path: Path) -> None:
    found = height_of(
        tmp_path, wall(120.0), '[building]\nheight = "9 m"\nground_elevation = "112 m"\n', mechanism_toml()
    )
    assert (found.base, found.support, found.above, found.source) == (8.0, 8.0, True, BY_BUILDING)
    zero = height_of(tmp_path, wall(8.0), '[building]\nground_elevation = "0 m"\n', mechanism_toml())
    assert (zero.base, zero.source) == (8.0, BY_BUILDING)


def test_a_base_elevation_replaces_the_geometry(tmp_path: Path) -> None:
    found = height_of(tmp_path, wall(0.0), mechanism_toml('base_elevation = "8 m"'))
    assert (found.base, found.above, found.source) == (8.0, True, BY_MECHANISM)
    alone = height_of(tmp_path, wall(120.0), mechanism_toml('base_elevation = "0 m"'))
    assert (alone.base, alone.above, alone.unknown) == (0.0, False, ())
    both = study_of(tmp_path, HEAD, wall(8.0), mechanism_toml("base_elevation = 8"), mechanism_toml(name="n")).heights
    assert (both["m"].source, both["n"].source) == (BY_MECHANISM, UNKNOWN)


def test_an_elevation_of_a_table_is_one_over_the_ground(tmp_path: Path) -> None:
    found = height_of(tmp_path, TABLE, "elevation = 4\n", name="t")
    assert (found.base, found.above, found.source) == (4.0, True, BY_TABLE)
    assert height_of(tmp_path, wall(8.0), mechanism_toml(), TABLE, name="t").source == UNKNOWN
    assert height_of(tmp_path, wall(8.0), mechanism_toml(), TABLE, "elevation = 4\n", name="t").source == BY_TABLE


def test_a_body_that_is_only_a_load_tells_nothing(tmp_path: Path) -> None:
    roof = wall(11.0, height=0.3, name="roof")
    load_ = 'loads = [{ kind = "body", body = "roof", share = 0.5 }]'
    low = wall(0.0, name="low")
    assert height_of(tmp_path, wall(8.0), roof, mechanism_toml(load_)).source == UNKNOWN
    assert height_of(tmp_path, wall(8.0), roof, low, mechanism_toml(load_)).source == BY_BODIES
    as_load = 'loads = [{ kind = "body", body = "low", at = [0, 0, 9], bearing = false }]'
    assert height_of(tmp_path, wall(8.0), low, mechanism_toml(as_load)).source == UNKNOWN


def test_what_holds_a_wall_twice_is_between_its_supports(tmp_path: Path) -> None:
    spanning = mechanism_toml("crack = 5.5", kind="two-block")
    found = height_of(tmp_path, wall(4.0), BUILDING, "ground_elevation = 0\n", spanning)
    assert (found.base, found.support) == (4.0, pytest.approx(5.5))


@pytest.mark.parametrize(("height", "at", "above"), [(9.0, 0.5, False), (9.0, 0.51, True), (20.0, 0.99, False)])
def test_a_plinth_is_ground(tmp_path: Path, height: float, at: float, above: bool) -> None:
    building = f"[building]\nheight = {height}\nground_elevation = 0\n"
    assert height_of(tmp_path, wall(at), building, mechanism_toml()).above is above


def test_every_check_waits_for_the_ground(tmp_path: Path) -> None:
    rest = '[records.synthetic]\ncount = 1\nduration = "8 s"\n[analysis]\nprocedures = ["asce43-05-spectrum"]\n'
    (found,) = results_of(tmp_path, HEAD, wall(8.0), mechanism_toml(), rest).mechanisms
    applied = [check for check in found.checks if check.verdict != Outcome.NOT_APPLICABLE]
    assert applied
    assert {(check.verdict, check.reason.key) for check in applied} == {(Outcome.NOT_ANSWERED, Reason.GROUND_UNKNOWN)}
    assert "ground_elevation" in applied[0].reason.text
    assert "base_elevation" in applied[0].reason.text
    known = results_of(tmp_path, HEAD, wall(8.0), mechanism_toml("base_elevation = 0"), rest).mechanisms[0]
    assert all(check.reason.key != Reason.GROUND_UNKNOWN for check in known.checks)
    assert (known.base_elevation_m, known.input_height_m, known.above_ground) == (0.0, 0.0, False)


def test_motion_is_carried_to_the_base_elevation(tmp_path: Path) -> None:
    floor = 'amplification = { method = "ec8" }\nbase_elevation = "4.5 m"'
    made = study_of(tmp_path, HEAD, wall(0.0), BUILDING, mechanism_toml(floor))
    assert made.amplified["m"].height == 4.5


def test_check_prints_the_heights_and_where_they_are_from(tmp_path: Path) -> None:
    tables = (wall(0.0), mechanism_toml('base_elevation = "8 m"'))
    made = study_of(tmp_path, HEAD, *tables)
    text = description(load(tmp_path), parameters(made), (), made.messages)
    assert "ground      base 8 m over the ground, held at 8 m: above the ground; by its base_elevation\n" in text
    unknown = study_of(tmp_path, HEAD, wall(8.0), mechanism_toml())
    text = description(load(tmp_path), parameters(unknown), (), unknown.messages)
    assert "not known where the ground is: give building.ground_elevation" in text


def test_check_prints_a_squat_mechanism(tmp_path: Path) -> None:
    squat = "[bodies.wall]\nmaterial = 'm'\nbox = { thickness = 9, length = 20, height = 2 }\n"
    made = study_of(tmp_path, HEAD, squat, mechanism_toml())
    text = description(load(tmp_path), parameters(made), (), made.messages)
    assert "stops at its first impact" in text
    assert "direction   towards 0 deg from +x\n" in text


@pytest.mark.parametrize(
    ("drawn", "building", "given", "contradicted"),
    [
        (8.0, "ground_elevation = 0.0", 0.0, True),  # the file says twice where the ground is
        (8.0, "ground_elevation = 0.0", 7.5, False),
        (8.0, "ground_elevation = 0.0", 12.0, False),  # higher than drawn is on the safe side
        (8.0, "", 0.0, False),  # drawn alone
        (0.0, "ground_elevation = 0.0", 6.0, False),
    ],
)
def test_a_base_elevation_that_contradicts_the_ground_is_not_taken(tmp_path, drawn, building, given, contradicted):
    found = height_of(tmp_path, BUILDING + building + "\n", wall(drawn), mechanism_toml(f"base_elevation = {given}"))
    assert [each.key for each in found.unknown] == ([Reason.GROUND_CONTRADICTED] if contradicted else [])


def test_a_gable_on_a_drawn_wall_is_not_drawn_alone(tmp_path: Path) -> None:
    below = wall(0.0, height=8.0, name="below") + mechanism_toml(name="b", blocks=["below"])
    found = height_of(tmp_path, below, wall(8.0), mechanism_toml("base_elevation = 0"))
    assert [each.key for each in found.unknown] == [Reason.GROUND_CONTRADICTED]
