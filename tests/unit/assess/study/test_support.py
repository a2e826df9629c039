"""What a drawing must have for a pass: blocks that do not overlap and touch, and what holds the top of a wall."""

from __future__ import annotations

import pytest
from scipy.constants import g

from assess.mechanisms.mechanism import multipliers_of_ties
from assess.project.build import build
from assess.project.project_file import load
from assess.study.checks import decide
from tests.support.projects import EC8, NTC, block, project_toml, wall

TWO = block(kind="two-block", direction=[1, 0, 0])
BUILDING = {"height": "3 m", "ground_elevation": 0.0, "use_class": "II", "storeys": 1}
DENSITY = 2000.0


def facts(tmp_path, mechanism, *, bodies=None, building=BUILDING):
    """Return the keys that are missing and the conditions of the only mechanism, whose checks are of no concern."""
    text = project_toml(
        site={"limit_state": "SLV", "spectrum": NTC},
        building=building,
        materials={"m": {"density": DENSITY, "disintegration": "excluded"}},
        bodies=bodies or {"wall": wall(0.4, 5.0, 3.0, material="m")},
        mechanisms={"wall": mechanism},
    )
    file = tmp_path / "project.toml"
    file.write_text(text, encoding="utf-8")
    study = build(load(file))

    class Unchecked:
        name, checks = "wall", ()

    (decided,) = decide(study, [Unchecked]).mechanisms
    return [each.key for each in decided.missing], {each.key: each.values for each in decided.conditions}


def test_a_wall_of_two_blocks_passes_if_its_top_is_held_with_this_force(tmp_path):
    """0.4 x 3 m cracked at mid-height, without load: H = W/5 at lambda = 8/15, by the moments of its halves.

    The upper half turns back about B, at the back face: lambda W/2 0.75 m + W/2 0.2 m = H 1.5 m. The whole wall about
    A, at the front face: lambda W 1.5 m = W 0.2 m + H 3 m. So 0.75 lambda = 0.4, and H = W (0.25 lambda + 0.2/3).
    """
    missing, conditions = facts(tmp_path, TWO | {"crack": 1.5})
    weight = DENSITY * 0.4 * 5.0 * 3.0 * g
    assert conditions["top-held"]["force"].value == pytest.approx(weight / 5.0, rel=1e-9)
    assert conditions["top-held"]["foot"].value == pytest.approx(weight / 3.0, rel=1e-9)  # lambda W less H
    assert not [key for key in missing if key.endswith((".loads", ".height"))]


@pytest.mark.parametrize(
    ("building", "more", "missing"),
    [
        (BUILDING, {}, []),
        (None, {}, ["building.height"]),
        (BUILDING | {"height": "2.5 m"}, {}, ["mechanisms.wall.loads"]),
        (None, {"loads": [{"kind": "overburden", "force": "20 kN"}]}, []),
        (None, {"loads": [{"kind": "mass", "mass": 500, "at": [0.0, 1.0]}]}, ["building.height"]),
    ],
)
def test_a_wall_of_two_blocks_needs_what_can_hold_its_top(tmp_path, building, more, missing):
    found, conditions = facts(tmp_path, TWO | {"crack": 1.5} | more, building=building)
    assert [key for key in found if key.endswith((".loads", ".height"))] == missing
    assert ("top-held" in conditions) == (not missing)


@pytest.mark.parametrize(("foot", "missing"), [(1.5, False), (1.49, False), (1.48, True), (1.52, True)])
def test_blocks_that_overlap_or_hang_in_the_air_leave_the_verdict_incomplete(tmp_path, foot, missing):
    """Blocks of 1.5 m: 1 cm in common is 0.7 % of one, 2 cm is 1.3 %; a joint is 1 cm thick."""
    bodies = {
        "low": wall(0.4, 5.0, 1.5, material="m"),
        "high": wall(0.4, 5.0, 1.5, material="m", base=[0.0, 0.0, foot]),
    }
    two = block("low", "high", kind="two-block", direction=[1, 0, 0])
    found, _ = facts(tmp_path, two, bodies=bodies, building=BUILDING | {"height": "3.1 m"})
    assert ("mechanisms.wall.blocks" in found) == missing


@pytest.mark.parametrize(("aside", "missing"), [(5.0, False), (5.009, False), (5.02, True), (4.0, False)])
def test_a_gap_within_a_block_leaves_the_verdict_incomplete_and_an_overlap_does_not(tmp_path, aside, missing):
    """Two walls 5 m long in a row, as one block; a joint is 1 cm thick."""
    bodies = {
        "one": wall(0.4, 5.0, 3.0, material="m"),
        "other": wall(0.4, 5.0, 3.0, material="m", base=[0.0, aside, 0.0]),
    }
    found, _ = facts(tmp_path, block(["one", "other"], direction=[1, 0, 0]), bodies=bodies)
    assert ("mechanisms.wall.blocks" in found) == missing


SHOWN = {"until": "collapse", "strength": "20 kN", "length": "4 m", "fracture_strain": 0.05}


@pytest.mark.parametrize(
    ("height", "more", "source", "held"),
    [
        (1.6, SHOWN, True, {"positive"}),
        (1.5, SHOWN, True, {"positive"}),
        (1.4, SHOWN, True, set()),  # below the centre of mass
        (1.6, SHOWN, False, set()),
        (1.6, {}, True, set()),
        (1.6, SHOWN | {"until": "5 mm"}, True, set()),  # it breaks before the wall has turned by 4 mrad
    ],
)
def test_a_tie_holds_a_gable_at_or_above_its_centre_of_mass_in_one_direction(tmp_path, height, more, source, held):
    """The centre of mass of a wall of 3 m is at 1.5 m; the tie pulls backwards, and is slack as the wall falls back."""
    tie = {"kind": "tie", "force": "5 kN", "at": [-0.2, height], "anchor": [-4.0, height], **more}
    text = project_toml(
        site={"limit_state": "ULS", "spectrum": EC8},
        materials={"m": {"density": DENSITY}},
        bodies={"wall": wall(0.4, 5.0, 3.0, material="m")},
        mechanisms={"wall": block(direction=[1, 0, 0], loads=[tie])},
        report={"sources": {"mechanisms.wall.loads[1]": "measured: pull-out test"} if source else {}},
    )
    file = tmp_path / "project.toml"
    file.write_text(text, encoding="utf-8")
    (mechanism,) = build(load(file)).mechanisms
    resisted = 5e3 * height / (DENSITY * 0.4 * 5.0 * 3.0 * g * 1.5)  # of 5 kN at its height over W at the middle
    assert multipliers_of_ties(mechanism) == pytest.approx(dict.fromkeys(held, resisted), rel=1e-9)
