"""What a project file refuses of a load or a mechanism is refused from Python too, at the same key and for the same
reason.
"""

from __future__ import annotations

from math import inf, nan
from pathlib import Path
from typing import Any, get_args

import pytest

import assess
from assess.declaration import Evidence, NotAKey, annotations_of, descriptions, marks_of
from assess.errors import MechanismError, ProjectError, other_faults
from assess.interfaces.contact import Interface
from assess.interfaces.section import Shape
from assess.loads.load import LOADS, LoadDefinition
from assess.project.project_file import load
from tests.support.projects import block, project_toml, wall, write_project

BODIES = {"wall": wall(), "floor": wall(4.0, 3.0, 0.2, base=[0, 0, 4]), "roof": wall(4.0, 3.0, 0.3, base=[0, 0, 4])}
MASS = {"kind": "mass", "mass": 900.0, "at": [0.0, 4.0]}
FORCE = {"kind": "force", "force": [1e3, -2e3], "at": [0.0, 4.0]}
PUSH = {"kind": "force", "force": 1e3, "at": [0.0, 4.0], "direction": [1.0, 0.0]}
TIE = {"kind": "tie", "force": 3e3, "at": [0.0, 3.0], "direction": [-1.0, 0.0]}
OVERBURDEN = {"kind": "overburden", "force": 1e4}
FLOOR = {"kind": "body", "body": "floor"}
VAULT = {**FLOOR, "role": "vault"}
ABOVE_0 = "must be greater than 0"
NO_POINT = "not a point; write [x, y, z], or [distance along the direction, elevation]"
NO_DIRECTION = "not a direction; write [x, y, z], or [along the direction of motion, up]"
NO_FORCE = "not a force; write [along the direction, up], or a size with direction"
NO_DISPLACEMENT = 'not a displacement; write that of its point at which it ends, or "collapse"'
ONLY_THRUST = 'only a roof or a vault has a thrust; write role = "roof" or "vault", or remove it'
TWO_BLOCK = {"kind": "two-block", "crack": 2.0}
SWEEP = {"direction": "sweep"}
DEPENDS = ' depend on the direction, which is "sweep"; give three numbers, or the direction'

FAULTS: list[tuple[dict[str, Any], dict[str, Any], str, str]] = [
    # bounds
    (MASS, {"mass": -3.0}, "mass", ABOVE_0),
    (MASS, {"mass": 0.0}, "mass", ABOVE_0),
    (MASS, {"seat": -0.1}, "seat", ABOVE_0),
    (MASS, {"block": -1}, "block", "must be 0 or more"),
    (MASS, {"block": 5}, "block", "must be 2 or less"),
    (MASS, {"block": 1}, "block", "must be 0 or less, counted from 0 at the base"),
    (PUSH, {"force": -5e3}, "force", "must be greater than 0; turn its direction instead"),
    (TIE, {"force": -3e4}, "force", ABOVE_0),
    (TIE, {"fracture_strain": 0.0}, "fracture_strain", ABOVE_0),
    (TIE, {"until": -0.1}, "until", f'{ABOVE_0}; write the displacement of its point at which it ends, or "collapse"'),
    (FLOOR, {"share": 1.5}, "share", "must be 1 or less"),
    (FLOOR, {"tolerance": 0.0}, "tolerance", ABOVE_0),
    (VAULT, {"construction": 6}, "construction", "must be 5 or less"),
    (VAULT, {"fill": 0.0}, "fill", ABOVE_0),
    # words and names
    (MASS, {"block": 0.5}, "block", "not a whole number; write one without decimal point"),
    (FLOOR, {"body": 3}, "body", "not a text; write it in quotes"),
    (FLOOR, {"role": "rooof"}, "role", 'not allowed; write "floor", "roof" or "vault"'),
    (VAULT, {"vault": "groin"}, "vault", 'not allowed; write "barrel" or "quadripartite"'),
    (
        FORCE,
        {"until": "colapse"},
        "until",
        NO_DISPLACEMENT,
    ),
    (TIE, {"until": [1.0]}, "until", NO_DISPLACEMENT),
    (TIE, {"until": " collapse"}, "until", NO_DISPLACEMENT),
    (FLOOR, {"role": 3}, "role", 'not allowed; write "floor", "roof" or "vault"'),
    (TIE, {"direction": 5}, "direction", NO_DIRECTION),
    (PUSH, {"force": True}, "force", NO_FORCE),
    (PUSH, {"force": "x"}, "force", NO_FORCE),
    (OVERBURDEN, {"through": "top"}, "through", 'not allowed; write "joint" or "fixed"'),
    (FLOOR, {"body": " "}, "body", "an empty name; write a name"),
    # places, directions, forces
    (MASS, {"at": [4.0]}, "at", NO_POINT),
    (MASS, {"at": 5.0}, "at", NO_POINT),
    (MASS, {"at": "top"}, "at", NO_POINT),
    (TIE, {"anchor": [1.0, 2.0, 3.0, 4.0], "direction": None}, "anchor", NO_POINT),
    (
        TIE,
        {"direction": [1.0]},
        "direction",
        NO_DIRECTION,
    ),
    (TIE, {"direction": [0.0, 0.0]}, "direction", "no direction; write [-1, 0, 0] for a pull towards -x"),
    (
        FORCE,
        {"force": [1.0, 2.0, 3.0]},
        "force",
        NO_FORCE,
    ),
    # keys that exclude or need each other
    (
        MASS,
        {"bearing": False, "seat": 0.1},
        "seat",
        "only what bears on the block has a seat; remove it, or write bearing = true",
    ),
    (PUSH, {"direction": None}, "direction", "missing; a force given by its size needs one, or write force = [x, z]"),
    (FORCE, {"direction": [1.0, 0.0]}, "direction", "beside components of the force; remove one of them"),
    (TIE, {"anchor": [-3.0, 3.0]}, "anchor", "give either anchor or direction, the way the tie pulls"),
    (TIE, {"direction": None}, "anchor", "give either anchor or direction, the way the tie pulls"),
    (OVERBURDEN, {"force": None}, "force", "give either force, or the bodies that press"),
    (OVERBURDEN, {"bodies": ["floor"]}, "force", "give either force, or the bodies that press"),
    (
        OVERBURDEN,
        {"through": "joint", "eccentricity": 0.1},
        "through",
        'a load through the joint presses where the joint does; remove eccentricity, or write "fixed"',
    ),
    (OVERBURDEN, {}, "kind", "is for two-block mechanisms; use a mass or a force"),
    (FLOOR, {"thrust": 1e4}, "thrust", ONLY_THRUST),
    (FLOOR, {"tied": True}, "tied", ONLY_THRUST),
    (FLOOR, {"tied": False}, "tied", ONLY_THRUST),
    (FLOOR, {"fill": 80.0}, "fill", 'only of a vault; write role = "vault", or remove it'),
    (
        VAULT,
        {"construction": 2, "mass": 500.0},
        "construction",
        "beside mass, which leaves nothing for it to say; remove one of them",
    ),
    (
        VAULT,
        {"tied": True, "thrust": 1e3},
        "tied",
        "beside thrust, which leaves nothing for it to say; remove one of them",
    ),
    (FLOOR, {"body": "wall"}, "body", "it is part of a block, or a load of this block already; name another body"),
]
OF_MECHANISMS: list[tuple[list[dict[str, Any]], dict[str, Any], str, str]] = [
    ([MASS], SWEEP, "loads[1].at", f"two numbers{DEPENDS}"),
    ([{**MASS, "at": [0.0, 0.0, 4.0]}, FORCE], SWEEP, "loads[2].force", f"two numbers{DEPENDS}"),
    (
        [{**OVERBURDEN, "eccentricity": 0.1}],
        TWO_BLOCK | SWEEP,
        "loads[1].eccentricity",
        'an eccentricity depends on the direction, which is "sweep"; give three numbers, or the direction',
    ),
    ([FLOOR, FLOOR], {}, "loads[2].body", "it is part of a block, or a load of this block already; name another body"),
    (
        [FLOOR, {**FLOOR, "block": 0}],
        TWO_BLOCK,
        "loads[2].body",
        "it is listed twice; give each of the entries its block, or keep one without",
    ),
    (
        [MASS],
        {"cut": {"point": [0.0, 0.0, 1.0], "angle": 2.1}},
        "cut.angle",
        "not between -90 deg and 90 deg; measure the crack from the horizontal",
    ),
]
RIGID_STIFF = 'is for flexible interfaces; write model = "flexible", or remove it'
BOW_TIE = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]
OF_JOINTS = 'must be greater than 0 and 2 TPa/m or less; of a stiffer joint say model = "rigid"'
OF_MASONRY = 'must be greater than 0 and 50 MPa or less, beyond which there is no masonry; "inf" is the rigid reading'
NO_WAY = 'not a direction; write [1, 0, 0] for +x, [0, -1, 0] for -y, or "sweep" for the weakest'
NO_CRACK = 'not a crack; write an elevation, or one of "sorrentino", "minimum"'
NO_RESTITUTION = 'not a known restitution; write a number in [0, 1], "thesis", "housner", "sorrentino" or "momentum"'
OF_KEYS: list[tuple[dict[str, Any], str, str]] = [
    # joints
    ({"interface": {"stiffness": 1e10}}, "interface.stiffness", RIGID_STIFF),
    ({"interface": {"course_thickness": 0.02}}, "interface.course_thickness", RIGID_STIFF),
    ({"interface": {"model": "flexible"}}, "interface.stiffness", "give either stiffness or course_thickness"),
    ({"interface": {"model": "flexible", "stiffness": -1e9}}, "interface.stiffness", OF_JOINTS),
    ({"interface": {"model": "flexible", "stiffness": 3e12}}, "interface.stiffness", OF_JOINTS),
    ({"interface": {"strength": 0.0}}, "interface.strength", OF_MASONRY),
    ({"interface": {"strength": 6e7}}, "interface.strength", OF_MASONRY),
    (
        {"interface": {"model": "stiff"}},
        "interface.model",
        'not allowed; write "rigid", "flexible", "semi-flexible" or "flexible-thesis"',
    ),
    ({"interface": {"shape": {}}}, "interface.shape.rectangle", "one shape is needed, not 0"),
    (
        {"interface": {"shape": {"circle": 1.0, "rectangle": [1.0, 2.0]}}},
        "interface.shape",
        "one shape is needed, not 2",
    ),
    ({"interface": {"shape": {"circle": 0.0}}}, "interface.shape.circle", ABOVE_0),
    (
        {"interface": {"shape": {"annulus": [1.0, 1.5]}}},
        "interface.shape.annulus",
        "the hole, 1.5 m, must be smaller than the outside, 1 m",
    ),
    (
        {"interface": {"shape": {"polygon": BOW_TIE}}},
        "interface.shape.polygon",
        "its sides cross or touch one another at [0.5, 0.5] m; list its corners in order around the outline",
    ),
    ({"interface": {"shape": {"polygon": BOW_TIE[:2]}}}, "interface.shape.polygon", "too few; give at least 3"),
    (
        {"interface": {"shape": {"polygon": [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]}}},
        "interface.shape.polygon",
        "no area, its corners lie on a line; give corners that enclose one",
    ),
    (TWO_BLOCK | {"interfaces": {"D": {}}}, "interfaces.D", "no such hinge; known: A, B, C"),
    (TWO_BLOCK | {"interfaces": {"E": {}}}, "interfaces.E", "no such hinge; known: A, B, C"),
    (
        {"interface": {"model": 1}},
        "interface.model",
        'not allowed; write "rigid", "flexible", "semi-flexible" or "flexible-thesis"',
    ),
    # which way, how far, how often
    ({"direction": 5}, "direction", NO_WAY),
    ({"direction": [1.0, 0.0]}, "direction", NO_WAY),
    ({"direction": [1.0, 0.0, 0.5]}, "direction", "not horizontal; its third number, the vertical one, must be 0"),
    ({"direction": [0.0, 0.0, 0.0]}, "direction", "no direction; write [1, 0, 0] for +x"),
    ({"sides": "three"}, "sides", 'not allowed; write "one" or "two"'),
    (
        {"restitution": 1.5},
        "restitution",
        "outside [0, 1]; restitution is velocity after over velocity before the impact",
    ),
    ({"restitution": "newton"}, "restitution", NO_RESTITUTION),
    ({"restitution": True}, "restitution", NO_RESTITUTION),
    (TWO_BLOCK | {"crack": "middle"}, "crack", NO_CRACK),
    (TWO_BLOCK | {"crack": True}, "crack", NO_CRACK),
    (TWO_BLOCK | {"crack": [1.0]}, "crack", NO_CRACK),
]
OWN_REMEDIES: list[tuple[dict[str, Any], dict[str, Any], str, str]] = [
    # the project file names units and its own tables, Python what it takes
    (MASS, {"mass": nan}, "mass", "not a finite number"),
    (TIE, {"strength": inf}, "strength", "not a finite number"),
    (MASS, {"at": [nan, 4.0]}, "at", "not a finite number"),
    (TIE, {"anchor": [nan, 3.0], "direction": None}, "anchor", "not a finite number"),
    (TIE, {"direction": [inf, 0.0]}, "direction", "not a finite number"),
    (PUSH, {"direction": [nan, 1.0, 0.0]}, "direction", "not a finite number"),
    (FLOOR, {"body": "flor"}, "body", 'no such body; known: "wall", "floor", "roof"'),
    (
        OVERBURDEN | {"force": None},
        {"bodies": ["wall"]},
        "bodies",
        'no body beside the wall; known: "wall", "floor", "roof"',
    ),
    (MASS, {"mass": [1.0]}, "mass", "not a number"),
    (MASS, {"mass": True}, "mass", "not a number"),
    (MASS, {"bearing": "yes"}, "bearing", "not a truth value"),
    (MASS, {"bearing": 1}, "bearing", "not a truth value"),
    (FLOOR, {"share": "all"}, "share", "not a number"),
    (OVERBURDEN, {"bodies": "floor", "force": None}, "bodies", "not a list"),
]
RIGHT: list[tuple[list[dict[str, Any]], dict[str, Any]]] = [
    ([MASS, FORCE, PUSH, TIE, FLOOR], {}),
    ([{**MASS, "at": [0.0, 0.0, 4.0]}], SWEEP),
    ([{**FLOOR, "role": "roof", "tied": False}], {}),
    ([OVERBURDEN, {**TIE, "until": "collapse", "block": 1}], TWO_BLOCK),
]


def refusals(loads: list[dict[str, Any]], mechanism: dict[str, Any], folder: Path) -> tuple[str, str]:
    """Return what the project file and what Python say of loads; empty where they take them."""
    stated = [{key: value for key, value in each.items() if value is not None} for each in loads]
    kind = mechanism.get("kind", "single-block")
    more = {"direction": [1, 0, 0], "sides": "one"} | mechanism | {"loads": stated}
    text = project_toml(bodies=BODIES, mechanisms={"m": block(**{**more, "kind": kind})})
    by_file = by_python = ""
    try:
        load(write_project(folder, text))
    except ProjectError as error:
        first = str(error).removesuffix(f" (and {len(other_faults(error))} more)")
        by_file = first.removeprefix(f"{folder / 'project.toml'}: mechanisms.m.")
    bodies = {name: assess.box(**each["box"], density=1800.0, name=name) for name, each in BODIES.items()}
    make = assess.two_block if kind == "two-block" else assess.single_block
    given = {key: value for key, value in more.items() if key not in ("kind", "loads", "cut")}
    if "cut" in more:
        given["cut"] = assess.CutAngle(**more["cut"])
    if "interface" in more:
        given["interface"] = _interface(more["interface"])
    if "interfaces" in more:
        given["interfaces"] = {name: _interface(each) for name, each in more["interfaces"].items()}
    stated_in_python = [LOADS[each["kind"]](**{key: each[key] for key in each if key != "kind"}) for each in stated]
    try:
        make(bodies["wall"], name="m", around=(bodies["floor"], bodies["roof"]), loads=stated_in_python, **given)
    except MechanismError as error:
        by_python = str(error).removeprefix('mechanism "m": ')
    return by_file, by_python


def test_hinges_are_finite_and_their_joints_named_from_python():
    """Both raised errors of numpy or of Python, far from what was given."""
    body = assess.box(thickness=0.6, length=3.0, height=4.0, density=1800.0, name="wall")
    for place in ((nan, 0.0), (inf, 0.0)):
        with pytest.raises(MechanismError, match="not a finite number"):
            assess.single_block(body, name="m", direction=(1, 0, 0), sides="one", hinge=place)
    with pytest.raises(MechanismError, match="interfaces"):
        assess.two_block(body, name="m", direction=(1, 0, 0), crack=2.0, interfaces={1: Interface()})  # type: ignore[dict-item]


def _interface(keys: dict[str, Any]) -> Interface:
    shape = {"shape": Shape(**keys["shape"])} if "shape" in keys else {}
    return Interface(**(keys | shape))


@pytest.mark.parametrize(("sound", "fault", "key", "said"), FAULTS)
def test_a_load_is_refused_for_one_reason(sound, fault, key, said, tmp_path):
    mechanism = TWO_BLOCK if sound["kind"] == "overburden" and key != "kind" else {}
    for refusal in refusals([sound | fault], mechanism, tmp_path):
        assert refusal.startswith(f"loads[1].{key}")
        assert refusal.endswith(f": {said}")


@pytest.mark.parametrize(("loads", "mechanism", "key", "said"), OF_MECHANISMS)
def test_a_mechanism_is_refused_for_one_reason(loads, mechanism, key, said, tmp_path):
    for refusal in refusals(loads, mechanism, tmp_path):
        assert refusal.startswith(key)
        assert refusal.endswith(f": {said}")


@pytest.mark.parametrize(("mechanism", "key", "said"), OF_KEYS)
def test_a_key_of_a_mechanism_is_refused_for_one_reason(mechanism, key, said, tmp_path):
    for refusal in refusals([], mechanism, tmp_path):
        assert refusal.startswith(key)
        assert refusal.endswith(f": {said}")


@pytest.mark.parametrize(("sound", "fault", "key", "said"), OWN_REMEDIES)
def test_a_load_is_refused_with_what_each_door_takes(sound, fault, key, said, tmp_path):
    mechanism = TWO_BLOCK if sound["kind"] == "overburden" else {}
    for refusal in refusals([sound | fault], mechanism, tmp_path):
        assert refusal.startswith(f"loads[1].{key}")
        assert f": {said}" in refusal


@pytest.mark.parametrize(
    ("sound", "fault", "key"),
    [(MASS, {"mass": 1e15}, "mass"), (FLOOR, {"tolerance": 1e-10}, "tolerance"), (TIE, {"strength": 1e-7}, "strength")],
)
def test_a_number_of_no_structure_is_refused(sound, fault, key, tmp_path):
    """Beyond the range of its dimension; each door writes the number and its unit in its own way."""
    for refusal in refusals([sound | fault], {}, tmp_path):
        assert refusal.startswith(f"loads[1].{key}")
        assert "outside 1e-" in refusal


def test_a_word_that_is_no_direction_is_refused_for_one_reason(tmp_path):
    by_file, by_python = refusals([], {"direction": "x"}, tmp_path)
    assert by_file.partition(": not")[2] == by_python.partition(": not")[2] != ""


@pytest.mark.parametrize(("loads", "mechanism"), RIGHT)
def test_what_is_right_is_taken_by_both(loads, mechanism, tmp_path):
    assert refusals(loads, mechanism, tmp_path) == ("", "")


@pytest.mark.parametrize("kind", get_args(LoadDefinition))
def test_every_key_of_a_load_says_what_it_is_and_who_vouches_for_it(kind):
    sentences = descriptions(kind)
    for key, annotation in annotations_of(kind).items():
        marks = [type(mark) for mark in marks_of(annotation)]
        assert sentences.get(key), f"{kind.__name__}.{key}: write a sentence below it"
        assert marks.count(Evidence) == (NotAKey not in marks), f"{kind.__name__}.{key}: one Evidence in its annotation"
