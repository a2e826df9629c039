"""Which block a floor loads: by its contact with the blocks as cut, against the same loads written by hand."""

from __future__ import annotations

from functools import partial
from math import sqrt

import pytest

from assess.errors import GeometryError, MechanismError, ProjectError
from assess.study.mechanism_results import parameters
from assess.study.run import run_study
from tests.support import projects
from tests.support.projects import block, project_toml, tables_toml, wall

SITE = tables_toml(
    site={"limit_state": "SLV", "spectrum": {"code": "asce7-16", "s_ds": "0.9 g", "s_d1": "0.4 g", "t_l": 6}},
    building={"height": 4},
    analysis={"procedures": ["asce43-05-spectrum", "dmi2008-nonlinear", "ntc2018-linear"]},
)
MASS = 2000 * 5 * 3 * 0.3 * (4.95 - 2.65) / (4.95 - 0.2)  # a beam from 0.2 m, the middle of its contact, to 4.95 m
WEIGHT = 2000 * 0.5 * 3 * 4
BODY = '{ kind = "body", body = "floor" }'


def mass_at(floor: float) -> float:
    """The mass on the block, less that of the 0.1 m of the beam that lie in it: its masonry counts there."""
    return MASS - 2000 * 0.1 * 3 * min(0.3, 4.0 - floor)


def by_hand(floor: float, block: int) -> str:
    """The floor as a mass, written by hand."""
    return f'{{ kind = "mass", mass = {mass_at(floor)!r}, at = [0.2, {floor}], block = {block} }}'


def floored(*, floor, kind="two-block", sides="two", parts=None, middle=2.65):
    """A floor from a wall, of the `parts` given, to another wall."""
    parts = parts or {"wall": wall(0.5, 3, 4, material="m")}
    return project_toml(
        site=None,
        materials={"m": {"density": 2000}},
        bodies=parts
        | {
            "other": wall(0.5, 3, 6, material="m", base=[5, 0, 0]),
            "floor": wall(5, 3, 0.3, material="m", base=[middle, 0, floor]),
        },
        mechanisms={"m": block(*parts, kind=kind, direction=[1, 0, 0], sides=sides)},
    )


def study_of(folder, mechanism, *, floor=4.0, kind="two-block", sides="two", head="", project=floored):
    return projects.study_of(folder, head + project(floor=floor, kind=kind, sides=sides) + mechanism)


def mechanism_of(folder, mechanism, **other):
    (found,) = study_of(folder, mechanism, **other).mechanisms
    return found


def figures(study):
    (result,) = parameters(study)
    return [
        (each.p_eq_per_s, each.slenderness_rad, each.uplift_multiplier, each.overturning_rad, each.restitution)
        for each in (result.oscillator, result.oscillator_negative)
        if each is not None
    ]


@pytest.mark.parametrize("sides", ["one", "two"])
@pytest.mark.parametrize("crack", ["", 'crack = "sorrentino"', 'crack = "minimum"', "crack = 2.5"])
def test_a_floor_on_a_wall_is_the_mass_written_by_hand(tmp_path, crack, sides):
    body = study_of(tmp_path, f"{crack}\nloads = [{BODY}]", sides=sides)
    hand = study_of(tmp_path, f"{crack}\nloads = [{by_hand(4.0, 1)}]", sides=sides)
    (found,) = body.mechanisms
    assert [(each.name, each.block) for each in found.positive.loads] == [("floor", 1)]
    assert figures(body) == [pytest.approx(each, rel=1e-6) for each in figures(hand)]


def test_checks_of_a_wall_under_a_floor_are_those_of_the_mass_written_by_hand(tmp_path):
    answers = []
    for each in (BODY, by_hand(4.0, 1)):
        (result,) = run_study(study_of(tmp_path, f"loads = [{each}]", head=SITE)).mechanisms
        answers.append([(check.procedure, check.ratio, check.verdict) for check in result.checks])
    assert len(answers[0]) == 3
    for one, other in zip(*answers, strict=True):
        assert one == (other[0], pytest.approx(other[1], rel=1e-6), other[2])


def test_the_crack_under_a_floor_is_that_under_the_overburden_at_its_contact(tmp_path):
    """By hand: n = N/W, xi = 1/2 + 0.2/0.5 for the worse face, h_c/h = sqrt(1+n) / (sqrt(1+n) + sqrt((1-xi) n))."""
    n, away = MASS / WEIGHT, 0.5 + 0.2 / 0.5
    height = 4.0 * sqrt(1 + n) / (sqrt(1 + n) + sqrt((1 - away) * n))
    body = mechanism_of(tmp_path, f"loads = [{BODY}]")
    pressed = mechanism_of(tmp_path, 'loads = [{ kind = "overburden", bodies = ["floor"] }]')
    assert body.positive.hinges[1][1] == pytest.approx(height, rel=1e-9)
    assert pressed.positive.hinges[1][1] == pytest.approx(height, rel=1e-9)


@pytest.mark.parametrize(("floor", "block"), [(1.5, 0), (2.1, 0), (2.5, 1), (3.9, 1)])
def test_the_block_is_the_one_under_the_floor_as_cut(tmp_path, floor, block):
    body = study_of(tmp_path, f"crack = 2.2\nloads = [{BODY}]", floor=floor)
    hand = study_of(tmp_path, f"crack = 2.2\nloads = [{by_hand(floor, block)}]")
    assert body.mechanisms[0].positive.loads[0].block == block
    assert figures(body) == [pytest.approx(each, rel=1e-6) for each in figures(hand)]
    assert not [text for text in map(str, body.mechanisms[0].warnings) if "crack is at" in text]


def test_two_bodies_of_a_wall_are_told_apart_by_the_contact(tmp_path):
    lower, upper = wall(0.5, 3, 2.5, material="m"), wall(0.5, 3, 1.5, material="m", base=[0, 0, 2.5])
    two = partial(floored, parts={"wall": lower, "upper": upper})
    for floor, place in ((1.5, 0), (4.0, 1)):
        parted = study_of(tmp_path, f"loads = [{BODY}]", floor=floor, project=two)
        cracked = study_of(tmp_path, f"crack = 2.5\nloads = [{BODY}]", floor=floor)
        assert parted.mechanisms[0].positive.loads[0].block == place
        assert figures(parted) == [pytest.approx(each, rel=1e-9) for each in figures(cracked)]


OVER = '{ kind = "overburden", force = "20 kN" }'


def test_a_floor_below_the_crack_does_not_hold_it_down(tmp_path):
    """At 1.5 m it is below the crack of the overburden alone, which is by eq. 3.27 where that is."""
    alone = mechanism_of(tmp_path, f"loads = [{OVER}]")
    beside = mechanism_of(tmp_path, f"loads = [{BODY}, {OVER}]", floor=1.5)
    assert beside.positive.loads[0].block == 0
    assert beside.positive.hinges[1][1] == pytest.approx(alone.positive.hinges[1][1], rel=1e-12)


def test_of_two_cracks_that_agree_with_their_loads_the_weaker_counts(tmp_path):
    """At 2.8 m the floor is above the crack that it holds down, and below the one that it does not."""
    alone = mechanism_of(tmp_path, f"loads = [{OVER}]").positive.hinges[1][1]
    held = f"loads = [{BODY.replace('}', ', block = 1 }')}, {OVER}]"
    lower = mechanism_of(tmp_path, f"crack = 2.634\n{held}", floor=2.8)
    chosen = study_of(tmp_path, f"loads = [{BODY}, {OVER}]", floor=2.8)
    assert chosen.mechanisms[0].positive.hinges[1][1] == pytest.approx(alone, rel=1e-12)
    assert alone > 2.8 > lower.positive.hinges[1][1]
    assert figures(chosen)[0][2] < figures(study_of(tmp_path, f"crack = 2.634\n{held}", floor=2.8))[0][2]


def test_the_search_looks_on_both_sides_of_a_floor(tmp_path):
    """The least of the multipliers of cracks that are given, each with the floor on the block under it."""
    lines = f"loads = [{BODY}, {OVER}]"
    found = mechanism_of(tmp_path, f'crack = "minimum"\n{lines}', floor=2.8, sides="one").positive.hinges[1][1]
    near, *others = (
        figures(study_of(tmp_path, f"crack = {z}\n{lines}", floor=2.8, sides="one"))[0][2]
        for z in (found, found - 0.1, found + 0.1, 2.77, 1.0)
    )
    assert near < min(others)


def test_a_floor_alone_below_the_top_leaves_eq_3_27_without_a_load(tmp_path):
    with pytest.raises(MechanismError, match="puts the crack at the very top"):
        mechanism_of(tmp_path, f"loads = [{BODY}]", floor=1.5)


def test_a_block_against_the_contact_is_refused_unless_the_place_is_given(tmp_path):
    given = BODY.replace("}", ", block = 0 }")
    with pytest.raises(GeometryError, match='load "floor": block = 0, yet it touches block 1; remove block, or give'):
        mechanism_of(tmp_path, f"crack = 2.2\nloads = [{given}]")
    placed = mechanism_of(tmp_path, f"crack = 2.2\nloads = [{given.replace(' }', ', at = [0.1, 2.0] }')}]")
    assert (placed.positive.loads[0].block, placed.positive.loads[0].at) == (0, (0.1, 2.0))
    assert any("block 0 is given, yet it touches block 1" in text for text in map(str, placed.warnings))


def test_a_crack_through_the_contact_asks_for_the_block(tmp_path):
    with pytest.raises(GeometryError, match=r"the crack at z = 2\.2 m runs through its contact.*give block"):
        mechanism_of(tmp_path, f"crack = 2.2\nloads = [{BODY}]", floor=2.205)
    for place in (0, 1):
        given = BODY.replace("}", f", block = {place} }}")
        (mass,) = mechanism_of(tmp_path, f"crack = 2.2\nloads = [{given}]", floor=2.205).positive.loads
        assert (mass.block, mass.mass) == (place, pytest.approx(mass_at(2.205), rel=1e-9))


def test_a_floor_that_pushes_against_two_blocks_asks_for_one(tmp_path):
    pushing = partial(floored, middle=2.75)
    with pytest.raises(GeometryError, match="it pushes against blocks 0 and 1; give block"):
        mechanism_of(tmp_path, f"crack = 2.2\nloads = [{BODY}]", floor=2.1, project=pushing)
    (mass,) = mechanism_of(tmp_path, f"crack = 2.2\nloads = [{BODY}]", floor=2.3, project=pushing).positive.loads
    assert (mass.block, mass.bearing) == (1, False)


def test_a_body_twice_among_the_loads_needs_its_blocks(tmp_path):
    with pytest.raises(ProjectError, match="it is listed twice; give each of the entries its block"):
        mechanism_of(tmp_path, f"crack = 2.2\nloads = [{BODY}, {BODY.replace('}', ', block = 1 }')}]")


def test_a_floor_below_the_cut_of_a_block_is_no_load_of_it_and_that_is_said(tmp_path):
    above = mechanism_of(tmp_path, f"cut = 2.2\nloads = [{BODY}]", floor=2.5, kind="single-block")
    assert above.positive.loads[0].mass == pytest.approx(mass_at(2.5), rel=1e-9)
    with pytest.raises(GeometryError, match="touches nothing of the block: it stands on what the cut leaves still"):
        mechanism_of(tmp_path, f"cut = 2.2\nloads = [{BODY}]", floor=1.5, kind="single-block")


UPON = "box = { thickness = 3, length = 1, height = 0.2, base = [2, 0, 3.5] }"  # on the beam
BETWEEN = "profile = [[-0.4, 3], [0, 3], [0, 3.5], [2, 3.5], [2, 3.7], [-0.4, 3.7]]\nlength = 1"  # on pier and beam


def portal(folder, floor, loads):
    text = project_toml(
        f"loads = [{loads}]",
        site=None,
        materials={"m": {"density": 2000}},
        bodies={
            "left": wall(0.8, 1, 3, material="m", base=[0, 0, 0]),
            "beam": wall(4, 1, 0.5, material="m", base=[2, 0, 3]),
            "right": wall(0.8, 1, 3, material="m", base=[4, 0, 0]),
            "floor": f'material = "m"\n{floor}',
        },
        mechanisms={
            "m": block("left", "beam", "right", kind="four-hinge", direction=[1, 0, 0], sides="one")
            | {"hinges": {"A": [0.4, 0], "B": [0, 3], "C": [4, 3], "D": [4.4, 0]}}
        },
    )
    return projects.study_of(folder, text)


def test_a_floor_on_a_portal_is_on_the_block_that_it_touches(tmp_path):
    body = portal(tmp_path, UPON, BODY)
    hand = portal(tmp_path, UPON, '{ kind = "mass", mass = 1200, at = [2, 3.5], block = 1 }')
    assert body.mechanisms[0].positive.loads[0].block == 1
    assert figures(body) == [pytest.approx(each, rel=1e-9) for each in figures(hand)]


def test_a_floor_on_two_blocks_is_shared_between_them_by_statics(tmp_path):
    mechanism = portal(tmp_path, BETWEEN, BODY).mechanisms[0]
    left, beam = mechanism.positive.loads
    area, arms = 0.4 * 0.7 + 2 * 0.2, (-0.2, 1.0)
    centre = (0.4 * 0.7 * -0.2 + 2 * 0.2 * 1.0) / area
    part = (arms[1] - centre) / (arms[1] - arms[0])
    assert (left.block, beam.block) == (0, 1)
    assert left.mass == pytest.approx(2000 * area * part, rel=1e-9)
    assert beam.mass == pytest.approx(2000 * area * (1 - part), rel=1e-9)
    (alone,) = (each := portal(tmp_path, BETWEEN, BODY.replace("}", ", block = 1 }")).mechanisms[0]).positive.loads
    assert alone.mass == pytest.approx(beam.mass, rel=1e-12)
    assert any(
        "it bears on block 0 too, and no load puts that part of it there" in text for text in map(str, each.warnings)
    )


def test_what_is_of_one_block_is_refused_for_a_floor_on_two(tmp_path):
    with pytest.raises(GeometryError, match="it bears on blocks 0 and 1, and share is of one"):
        portal(tmp_path, BETWEEN, BODY.replace("}", ", share = 0.5 }"))
