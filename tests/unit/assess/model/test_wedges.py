"""Façades and corners with wedges as projects state them: closed forms, a body turned in space, and what is refused."""

from __future__ import annotations

from math import cos, radians, sin, sqrt, tan

import numpy as np
import pytest

import assess
from assess.errors import FallingError, GeometryError, MechanismError
from assess.mechanisms.chain import uplift_multiplier
from assess.mechanisms.partial_walls import SideWall
from assess.mechanisms.partial_walls import corner as corner_of_boxes
from assess.oscillator import multiplier
from spectra.gravity import g
from spectra.registry import spectrum
from tests.support.projects import NTC, block, project_toml, study_of, wall

DENSITY = 1900.0
HEIGHT, T_1, T_2 = 6.0, 0.5, 0.7
NORTH = assess.box(thickness=5.0, length=T_1, height=HEIGHT, density=DENSITY, base=(-2.5, -T_1 / 2, 0), name="north")
EAST = assess.box(thickness=T_2, length=4.5, height=HEIGHT, density=DENSITY, base=(-T_2 / 2, -2.75, 0), name="east")
SITE = spectrum("ntc2018", a_g=0.15 * g, f_0=2.4, t_c_star=0.3, soil="A")


def corner(angle_1=20.0, angle_2=15.0, direction=(1.0, 1.0, 0.0), *, reach=None, **more) -> assess.Block:
    wedges = [
        assess.Wedge(walls=("north",), angle=radians(angle_1)),
        assess.Wedge(walls=("east",), angle=radians(angle_2), reach=reach),
    ]
    return assess.corner([NORTH, EAST], wedges=wedges, direction=direction, **more)


@pytest.mark.parametrize("reach", [None, 1.0])
@pytest.mark.parametrize("degrees", [0.0, 30.0, 45.0, 90.0])
@pytest.mark.parametrize("angles", [(20.0, 15.0), (0.0, 30.0), (0.0, 0.0)])
def test_a_corner_has_the_multiplier_of_its_boxes_and_triangles(angles, degrees, reach) -> None:
    walls = (SideWall(thickness=T_1, density=DENSITY), SideWall(thickness=T_2, density=DENSITY, reach=reach or np.inf))
    way = radians(degrees)
    boxes = corner_of_boxes(
        walls, top=HEIGHT, height=HEIGHT, angles=(radians(angles[0]), radians(angles[1])), direction=way
    )
    found = corner(*angles, (cos(way), sin(way), 0.0), reach=reach).mechanism.positive
    assert found.mass == pytest.approx(boxes.mass, rel=1e-9)
    assert uplift_multiplier(found) == pytest.approx(uplift_multiplier(boxes), rel=1e-9)
    assert found.blocks[0].inertia == pytest.approx(boxes.blocks[0].inertia, rel=1e-9)


def by_turning(points: np.ndarray, weights: np.ndarray, direction: np.ndarray, hinge: np.ndarray, phi: float) -> float:
    """Multiplier of points turned in space about a level axis, by differences of their places."""
    axis = np.cross([0.0, 0.0, 1.0], direction)

    def turned(angle: float) -> np.ndarray:
        arms = points - hinge
        along = np.outer(arms @ axis, axis)
        return hinge + along + (arms - along) * cos(angle) + np.cross(axis, arms) * sin(angle)

    moved = (turned(phi + 1e-5) - turned(phi - 1e-5)) / 2e-5
    return float(-(weights @ -moved[:, 2]) / (weights @ (moved @ direction)))


def test_the_curve_is_that_of_masonry_turned_in_space() -> None:
    """Of the corner as cells of 25 mm, each in front of its crack, about the outermost point of its foot."""
    size, slope_1, slope_2 = 0.025, tan(radians(20.0)), tan(radians(15.0))
    s, z = np.arange(size / 2, 4.5, size), np.arange(size / 2, HEIGHT, size)
    S, Z = (each.ravel() for each in np.meshgrid(s, z, indexing="ij"))
    first, second = T_2 + slope_1 * Z > S, (S > T_1) & (T_1 + slope_2 * Z > S)
    points = np.concatenate([
        np.column_stack([-S[first], np.full(first.sum(), -T_1 / 2), Z[first]]),
        np.column_stack([np.full(second.sum(), -T_2 / 2), -S[second], Z[second]]),
    ])  # fmt: skip
    weights = np.concatenate([np.full(first.sum(), T_1), np.full(second.sum(), T_2)])
    way = np.array([1.0, 1.0, 0.0]) / sqrt(2.0)
    branch = corner().mechanism.oscillator.positive
    curve = multiplier(branch)
    for place in (0, 60, 120):
        phi = float(branch.rotation[place])
        assert curve[place] == pytest.approx(by_turning(points, weights, way, np.zeros(3), phi), abs=2e-3)
    centre = weights @ points / weights.sum()
    assert branch.overturning == pytest.approx(np.arctan2(-centre @ way, centre[2]), rel=2e-3)


def test_without_a_direction_a_corner_turns_with_its_thinner_wall() -> None:
    found = corner(direction="weakest")
    assert found.mechanism.direction == pytest.approx((0.0, 1.0, 0.0))
    others = [corner(direction=(cos(a), sin(a), 0.0)) for a in np.linspace(0.0, np.pi / 2, 9)]
    assert found.oscillator.multiplier == pytest.approx(min(each.oscillator.multiplier for each in others))


def test_a_facade_takes_the_wedges_of_both_its_side_walls() -> None:
    """Two triangles of 20 degrees behind a wall of 0.5 x 6 m, of which those in the side walls begin at its back."""
    west = assess.box(thickness=0.5, length=4.5, height=HEIGHT, density=DENSITY, base=(-4.75, -2.75, 0), name="west")
    wedges = [assess.Wedge(walls=(name,), angle=radians(20.0)) for name in ("east", "west")]
    found = assess.facade_with_wedges([NORTH, EAST, west], wedges=wedges, direction=(0, 1, 0), name="front")
    own = 5.0 * T_1 * HEIGHT
    depth = HEIGHT * tan(radians(20.0))
    wedge = (T_2 + 0.5) * HEIGHT * depth / 2.0
    stands, drives = own * T_1 / 2 + wedge * (T_1 + depth / 3.0), own * HEIGHT / 2 + wedge * 2.0 * HEIGHT / 3.0
    assert found.oscillator.multiplier == pytest.approx(stands / drives, rel=1e-9)
    assert found.oscillator.mass == pytest.approx(DENSITY * (own + wedge), rel=1e-9)


def test_a_foot_above_the_ground_leaves_what_is_below_where_it_is() -> None:
    high = corner(cut=2.0)
    walls = (SideWall(thickness=T_1, density=DENSITY), SideWall(thickness=T_2, density=DENSITY))
    boxes = corner_of_boxes(
        walls, top=HEIGHT, height=4.0, angles=(radians(20.0), radians(15.0)), direction=radians(45.0)
    )
    assert high.oscillator.multiplier == pytest.approx(uplift_multiplier(boxes), rel=1e-9)
    scene = high.scene
    assert scene is not None
    kept = sum(solid.mass for solid in (*scene.members[0], *scene.fixed))
    assert kept == pytest.approx(DENSITY * HEIGHT * (5.0 * T_1 + 4.5 * T_2), rel=1e-9)


def test_a_floor_on_a_corner_loads_it_by_what_lies_on_its_wedge() -> None:
    """A floor along the whole of a wall rests on its wedge and on what stays behind."""
    floor = assess.box(thickness=T_2, length=4.5, height=0.2, density=2500.0, base=(-T_2 / 2, -2.75, HEIGHT), name="f")
    found = corner(around=[floor], loads=[assess.BodyLoad(body="f")])
    (load,) = (each for each in found.mechanism.positive.loads if hasattr(each, "mass"))
    top = HEIGHT * tan(radians(15.0))
    assert load.mass == pytest.approx(floor.mass * top / 4.5, rel=1e-6)


ITALIAN = ("ntc2018-linear", "ntc2018-nonlinear", "dmi2008-linear", "dmi2008-nonlinear")
OTHERS = ("ntc2018-history", "dmi2008-history", "asce43-05-history", "ec8-element", "nzsee2017-face-loaded", "sliding")


def test_the_kinematic_checks_answer_and_nothing_else_does() -> None:
    block = corner()
    checks = assess.answers(block, SITE, procedures=(*ITALIAN, *OTHERS, "asce43-05-spectrum", "asce41-13-ht"))
    verdicts = {each.procedure: each.verdict for each in checks}
    assert {verdicts[name] for name in ITALIAN} <= {"pass", "fail"}
    assert {verdicts[name] for name in OTHERS} == {"not-answered"}
    assert {verdicts[name] for name in ("asce43-05-spectrum", "asce41-13-ht")} == {"not-applicable"}
    reasons = {each.reason.key for each in checks if each.procedure in OTHERS}
    assert reasons == {"histories-unknown"}
    assert all(each.demand is None and each.capacity is None for each in checks if each.procedure in OTHERS)
    linear = next(each for each in checks if each.procedure == "ntc2018-linear")
    assert linear.capacity == pytest.approx(block.oscillator.multiplier * g / 1.35, rel=1e-9)


def test_no_history_is_run() -> None:
    with pytest.raises(MechanismError, match="histories of this class are not answered"):
        _ = corner().rocking


def wedged(*walls: str, **more):
    return [assess.Wedge(walls=(name,), angle=radians(20.0), **more) for name in walls]


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: corner(direction=(-1.0, 0.2, 0.0)), "direction: turns into the building"),
        (lambda: assess.corner([NORTH, EAST], wedges=wedged("north")), "a corner is of two walls"),
        (lambda: assess.corner([NORTH, EAST], wedges=wedged("north", "south")), '"south" is not in `blocks`'),
        (lambda: assess.corner([NORTH, EAST], wedges=wedged("north", "north")), "stands in two wedges"),
        (lambda: corner(direction="sweep"), "is sought between"),
        (lambda: corner(angle_1=75.0), "measure the crack from the vertical"),
        (lambda: assess.corner([NORTH, EAST], wedges="east"), "give a list of Wedge"),
        (
            lambda: assess.facade_with_wedges([EAST], wedges=wedged("east"), direction=(0, 1, 0)),
            "name the wall that overturns too",
        ),
        (
            lambda: assess.facade_with_wedges([NORTH, EAST], wedges=wedged("east"), direction=(1, 0, 0)),
            "the wall does not run back",
        ),
        (lambda: corner(cut=7.0), "nothing of its bodies lies above"),
    ],
)
def test_what_is_refused(make, told: str) -> None:
    with pytest.raises((MechanismError, GeometryError), match=told):
        make()


def test_a_corner_that_a_thrust_pushes_over_is_falling() -> None:
    push = assess.ForceLoad(force=60e3, direction=(1, 1, 0), at=(-0.3, -0.3, 5.9))
    with pytest.raises(FallingError, match="already falling"):
        corner(loads=[push])


def test_a_pass_is_on_the_condition_that_the_cracks_are_as_stated(tmp_path) -> None:
    bodies = {
        "north": wall(5.0, T_1, HEIGHT, base=[-2.5, -0.25, 0]),
        "east": wall(T_2, 4.5, HEIGHT, base=[-0.35, -2.75, 0]),
    }
    wedges = [{"walls": [name], "angle": "20 deg"} for name in bodies]
    stated = block(["north", "east"], kind="corner", wedges=wedges)
    source = {"sources": {"mechanisms.corner.wedges[2]": "measured: survey of 3 May"}}
    study = study_of(
        tmp_path, project_toml(site={"spectrum": NTC}, bodies=bodies, mechanisms={"corner": stated}, report=source)
    )
    (told,) = (each for each in study.facts["corner"][1] if each.key == "not-sought")
    assert told.text.endswith(": mechanisms.corner.wedges[1]")
