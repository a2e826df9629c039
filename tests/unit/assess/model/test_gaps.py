"""Gaps between bodies that a mechanism takes to be joined."""

from __future__ import annotations

import pytest

from assess.geometry.boolean import shortest_distance
from assess.geometry.solid import polyhedron
from assess.model.bodies import gaps_at_hinge, gaps_in_block
from tests.support.projects import project_toml, study_of, wall
from tests.support.solids import solid_box


def gaps(tmp_path, base: list[float], mechanism: str) -> list[str]:
    bodies = {"a": wall(0.5, 3, 4, material="m"), "b": wall(0.5, 3, 4, material="m", base=base)}
    text = project_toml(site=None, materials={"m": {"density": 2000}}, bodies=bodies, mechanisms={"m": mechanism})
    return [notice.text for notice in study_of(tmp_path, text).messages if notice.key in ("gap", "blocks-apart")]


ONE_BLOCK = 'kind = "single-block"\nblocks = [["a", "b"]]'
TWO_BLOCKS = 'kind = "two-block"\nblocks = ["a", "b"]'


@pytest.mark.parametrize(("foot", "told"), [(4.0, False), (3.6, False), (3.4, True), (2.0, True)])
def test_an_upper_block_beside_the_lower_one_leaves_the_verdict_incomplete(tmp_path, foot, told):
    """Of a wall 0.5 m thick a crack may rise by as much; a block that begins farther below stands beside it."""
    bodies = {"a": wall(0.5, 3, 4, material="m"), "b": wall(0.5, 3, 4, material="m", base=[0.5, 0, foot])}
    text = project_toml(site=None, materials={"m": {"density": 2000}}, bodies=bodies, mechanisms={"m": TWO_BLOCKS})
    keys = [notice.key for notice in study_of(tmp_path, text + "\ndirection = [1, 0, 0]").messages]
    assert ("blocks-beside" in keys) is told


def test_bodies_of_one_block_that_touch_nowhere_are_told(tmp_path):
    (text,) = gaps(tmp_path, [0, 3.5, 0], ONE_BLOCK)
    assert text == (
        'bodies "a" and "b" do not touch: they are 0.5 m apart, although they form one block: close the gap, or add '
        "the body that joins them to the block"
    )
    assert gaps(tmp_path, [0, 3, 0], ONE_BLOCK) == []
    assert gaps(tmp_path, [0, 3.009, 0], ONE_BLOCK) == []  # as thick as a joint


def test_blocks_that_do_not_meet_at_their_hinge_are_told(tmp_path):
    (text,) = gaps(tmp_path, [0, 0, 4.5], TWO_BLOCKS)
    assert text.startswith(
        'block 2 is in the air: its body nearest to block 1, with which it has a hinge, is "b", 0.5 m'
    )
    assert gaps(tmp_path, [0, 0, 4], TWO_BLOCKS) == []
    assert gaps(tmp_path, [0, 0, 3.5], TWO_BLOCKS) == []  # an overlap, told as such


def test_a_block_need_only_hang_together() -> None:
    row = [solid_box(base=(x, 0, 0), name=f"{x}") for x in (0.0, 1.0, 2.0, 3.0)]
    assert list(gaps_in_block([row[0], row[3], row[1], row[2]])) == []
    apart = [solid_box(base=(x, 0, 0), name=f"{x}") for x in (0.0, 7.0, 1.0, 3.5)]
    assert [(each["one"], each["other"], str(each["distance"])) for each in gaps_in_block(apart)] == [
        ("1.0", "3.5", "1.5 m"),
        ("7.0", "3.5", "2.5 m"),
    ]


def test_a_beam_above_its_posts_is_told() -> None:
    beam = solid_box((5.0, 1.0, 0.5), (2.0, 0.0, 2.0), name="beam")
    (said,) = gaps_at_hinge([solid_box(name="post")], [beam])
    assert (said["one"], said["other"], str(said["distance"])) == ("post", "beam", "1 m")
    assert list(gaps_at_hinge([solid_box(), solid_box(base=(0, 0, 1.0))], [beam])) == []


@pytest.mark.parametrize(
    ("at", "distance"), [((1.5, 0, 0), 0.5), ((2, 2, 2), 3**0.5), ((1, 0, 0), 0.0), ((0.5, 0, 0), 0.0)]
)
def test_the_gap_of_two_cubes(at: tuple[float, float, float], distance: float) -> None:
    assert shortest_distance(solid_box(), solid_box(base=at)) == pytest.approx(distance, rel=1e-9, abs=1e-9)
    assert shortest_distance(solid_box(), solid_box(base=at), limit=0.1) == pytest.approx(
        min(distance, 0.1), rel=1e-9, abs=1e-9
    )


def test_a_body_within_another_is_not_apart() -> None:
    inner = solid_box(base=(0, 0, 0.25))
    small = polyhedron(inner.vertices * 0.5, inner.triangles, density=1.0, name="small")
    assert shortest_distance(solid_box(), small) == 0.0


@pytest.mark.parametrize("apart", [0.0, 0.02, 0.3])
def test_the_gap_of_fine_meshes(apart: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their vertices are looked at where they are clearly apart, their faces where they are near."""
    monkeypatch.setattr("assess.geometry.boolean.MANY_PAIRS", 100)
    beside = solid_box(base=(1.0 + apart, 0.1, 0), name="beside")  # of the faces; the corners are farther apart
    corners = (apart**2 + 0.1**2) ** 0.5
    assert shortest_distance(solid_box(), beside) == pytest.approx(
        corners if apart > 0.05 else apart, rel=1e-9, abs=1e-9
    )
    assert shortest_distance(solid_box(), beside, limit=0.01) == pytest.approx(min(apart, 0.01), abs=1e-9)
