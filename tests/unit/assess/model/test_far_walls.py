"""The far walls of ties as mechanisms of their own, against virtual work by hand."""

from __future__ import annotations

from dataclasses import replace
from math import dist, pi
from typing import Any

import numpy as np
import pytest
from scipy.constants import g

import assess
from assess.errors import AssessError
from assess.loads.anchorage import Anchorage, Plate
from assess.loads.far_wall import FarWall, SiteAction, action_at
from assess.loads.load import Tie

T, L, H, RHO, Z = 0.6, 2.4, 5.0, 2000.0, 4.0  # of the far wall: within 1.5 m of a tie in its middle; height of the tie
W = T * L * H * RHO * g
BAR = {"area": 314e-6, "young_modulus": 210e9, "yield_stress": 235e6, "fracture_strain": 0.1}
FULL: dict[str, Any] = {
    "width": 0.3, "height": 0.3, "thickness": 0.015, "yield_stress": 235e6, "nut": 0.05, "thread_area": 245e-6,
    "tensile_strength": 360e6, "shear_strength": 0.2e6, "bearing_strength": 5e6, "far_strength": 500e3,
    "between": 500e3, "confidence": 1.0,
}  # fmt: skip


def tie(pga: float = 0.03, *, y: float = 0.0, z: float = Z, anchor_z: float | None = None, **plate: Any) -> Any:
    """A tie of the wall at x = 0 to the middle of the far wall at x = -10."""
    far = z if anchor_z is None else anchor_z
    return assess.TieLoad(
        at=[0.3, y, z], anchor=[-10.0, y, far], length=10.3, plate=Plate(**{**FULL, **plate}), evidence="tests",
        site=SiteAction(pga), **BAR,
    )  # fmt: skip


def far(*, length: float = L, height: float = H, thickness: float = T, density: float = RHO) -> Any:
    return assess.box(
        thickness=thickness, length=length, height=height, density=density, base=[-10.0, 0, 0], name="rear"
    )


def anchorages(*ties: Any, around: Any = (), **changes: Any) -> list[Anchorage]:
    wall = assess.box(thickness=0.6, length=9.0, height=6.0, density=2000.0, name="front")
    rear = [far(**changes)] if changes.get("thickness", T) else []
    block = assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=ties, around=[*rear, *around])
    found = [load for load in block.mechanism.positive.loads if isinstance(load, Tie)]
    assert all(each.anchorage is not None and each.strength == each.anchorage.strength for each in found)
    return [each.anchorage for each in found if each.anchorage is not None]


def wall_of(*ties: Any, **changes: Any) -> FarWall:
    found = anchorages(*ties, **changes)[0].far_wall
    assert found is not None
    return found


def by_hand(alpha: float, z_c: float = 0.0, *, height: float = H, length: float = L) -> float:
    """N (Z - z_c) = W_c (t / 2 - alpha h_c / 2) of a box above a crack."""
    h = height - z_c
    return T * length * h * RHO * g * (T - alpha * h) / 2.0 / (Z - z_c)


def test_a_box_holds_what_virtual_work_says() -> None:
    """Far below the multiplier 0.12 the foot is the weakest crack: W (0.3 - 0.03 x 2.5) / 4 = 7.94 kN."""
    (found,) = anchorages(tie(0.03))
    assert found.far_wall is not None
    assert found.far_wall.multiplier == pytest.approx(T / H, rel=1e-9)
    assert found.far_wall.strength == pytest.approx(by_hand(0.03), rel=1e-9)
    assert found.far_wall.strength == pytest.approx(W * (0.3 - 0.075) / 4, rel=1e-9)
    assert (found.governing, found.strength) == ("far wall", found.far_wall.strength)


def test_without_any_shaking_it_holds_w_b_over_h():
    found = wall_of(tie(0.0))
    assert found.strength == pytest.approx(W * 0.3 / 4.0, rel=1e-9)


@pytest.mark.parametrize("times", [0.5, 2.0, 5.0])
def test_a_heavier_wall_holds_more_in_proportion(times: float):
    assert wall_of(tie(0.03), density=times * RHO).strength == pytest.approx(times * by_hand(0.03), rel=1e-9)


def test_a_wall_without_end_heavier_leaves_the_other_ways():
    (found,) = anchorages(tie(0.03))
    assert found.far_wall is not None
    heavy = replace(found.far_wall, stabilising=1e15, overturning=1e13)
    alone = replace(found, far_wall=None)
    assert replace(found, far_wall=heavy).strength == alone.strength
    assert replace(found, far_wall=heavy).governing == alone.governing


@pytest.mark.parametrize("share", [0.9, 0.999, 1.0, 1.2])
def test_towards_its_own_multiplier_it_holds_nothing(share: float):
    """On a high building all cracks have the acceleration of the ground; the foot is the weakest of them."""
    tall = replace(tie(share * T / H), site=SiteAction(share * T / H, ground=0.0, height=1e6))
    (found,) = anchorages(tall)
    assert found.far_wall is not None
    assert found.far_wall.strength == pytest.approx(max(W * 0.3 * (1.0 - share) / 4.0, 0.0), rel=1e-4, abs=1e-6)
    assert found.far_wall_holds is (share < 0.99)
    assert (found.strength is None) is (share > 0.99)
    assert ("a far wall that holds" in found.missing) is (share > 0.99)


def test_the_crack_is_the_weakest_of_those_below_the_anchor():
    """The action grows with the height of the crack, on 6 m that are drawn: alpha = 0.1 (1 + 1.5 z / 6)."""
    found = wall_of(tie(0.1))
    cracks = [Z * number / 12 for number in range(12)]
    values = [by_hand(0.1 * (1 + 1.5 * z / 6.0), z) for z in cracks]
    assert found.strength == pytest.approx(min(values), rel=1e-6)
    assert found.crack == pytest.approx(cracks[values.index(min(values))], abs=1e-9)
    assert found.crack > 0.0


def test_the_level_of_knowledge_raises_the_action():
    assert wall_of(tie(0.03, confidence=1.35)).strength == pytest.approx(by_hand(0.0405), rel=1e-9)
    assert action_at(pga=0.1, FC=1.2, Z=3.0, H=6.0) == pytest.approx(0.21)
    assert action_at(pga=0.1, FC=1.0, Z=-1.0, H=6.0) == 0.1
    assert action_at(pga=0.1, FC=1.0, Z=9.0, H=6.0) == 0.25


def test_two_ties_share_it_by_their_heights():
    """4 m and 3 m above the foot: N (4 + 3) = W (0.3 - 0.075)."""
    one, other = anchorages(tie(0.03, y=0.5), tie(0.03, y=-0.5, z=3.0))
    assert one.far_wall is not None
    assert other.far_wall is not None
    assert one.far_wall.strength == pytest.approx(W * 0.225 / 7.0, rel=1e-9)
    assert one.far_wall.ties == 2
    assert other.far_wall.strength == pytest.approx(one.far_wall.strength, rel=1e-9)


def test_a_tie_of_another_mechanism_shares_it_and_the_same_one_counts_once():
    two = replace(tie(0.03, y=0.5), others=(tie(0.03, y=0.5), tie(0.03, y=-0.5)))
    assert wall_of(two).strength == pytest.approx(W * 0.225 / 8.0, rel=1e-9)


def test_a_tie_of_a_neighbouring_wall_shares_it_and_one_that_pulls_the_other_way_does_not():
    """It is as if one wall were tied by both; what pulls it outwards from behind is no support to count on."""
    both = wall_of(tie(y=-1.0), tie(y=1.0))
    assert both.ties == 2
    assert wall_of(replace(tie(y=-1.0), neighbours=(tie(y=1.0),))) == both
    behind = replace(tie(y=1.0), at=(-20.0, 1.0, Z))
    assert wall_of(replace(tie(y=-1.0), neighbours=(behind,))) == wall_of(tie(y=-1.0))


def test_of_a_long_wall_it_turns_a_strip_of_3_m():
    """Two ties 2 m apart hold 5 m of it together, two 4 m apart 3 m each."""
    assert wall_of(tie(0.03), length=9.0).strength == pytest.approx(by_hand(0.03, length=3.0), rel=1e-9)
    near = wall_of(tie(0.03, y=1.0), tie(0.03, y=-1.0), length=9.0)
    assert near.strength == pytest.approx(by_hand(0.03, length=5.0) / 2.0, rel=1e-9)
    apart = wall_of(tie(0.03, y=2.0), tie(0.03, y=-2.0), length=9.0)
    assert apart.strength == pytest.approx(by_hand(0.03, length=3.0), rel=1e-9)
    at_end = wall_of(tie(0.03, y=4.0), length=9.0)
    assert at_end.strength == pytest.approx(by_hand(0.03, length=2.0), rel=1e-9)


def test_a_tie_that_rises_pulls_with_its_level_part_and_lifts():
    """From 5 m at x = 0.3 down to 4 m at x = -10: 10.3 / 10.348 of N pulls at 4 m, 1 / 10.348 lifts, 0.3 m behind."""
    found = wall_of(tie(0.03, z=5.0, anchor_z=4.0))
    length = (10.3**2 + 1.0) ** 0.5
    arm = (10.3 * 4.0 + 1.0 * 0.3) / length
    assert found.levers == pytest.approx(arm, rel=1e-9)
    assert found.strength == pytest.approx(W * 0.225 / arm, rel=1e-9)


def floor(thickness: float = 0.3, *, to: float = -9.7) -> Any:
    """A slab 3 m above the ground from the tied wall to x = `to`."""
    size, middle = -0.3 - to, (to - 0.3) / 2.0
    return assess.box(thickness=size, length=L, height=thickness, density=2400.0, base=[middle, 0, 2.85], name="floor")


def side() -> Any:
    """A side wall from the far wall to the tied one, beside the strip, which floors as long as that touch."""
    return assess.box(thickness=9.4, length=0.3, height=6.0, density=2000.0, base=[-5.0, L / 2 + 0.15, 0], name="side")


def test_what_touches_its_inner_face_stops_it_below_that():
    """From 2.85 to 3.15 m: of cracks a third of a metre apart that at 3 is the first with it in the lowest tenth."""
    found = wall_of(tie(0.03), around=[floor(), side()])
    assert found.crack == pytest.approx(3.0)
    assert found.strength == pytest.approx(by_hand(0.03 * (1 + 1.5 * 3.0 / 6.0), 3.0), rel=1e-6)


def test_held_above_the_anchor_it_is_no_mechanism():
    high = assess.box(thickness=9.4, length=L, height=0.4, density=2400.0, base=[-5.0, 0, 4.5], name="roof")
    (found,) = anchorages(tie(0.2), around=[high, side()])
    assert found.far_wall is None
    assert "far wall" not in [link.name for link in found.links]


def test_what_reaches_the_tied_wall_alone_stops_it_not():
    """Both walls are shaken in one sense: it would push the tied wall outwards."""
    assert wall_of(tie(0.03), around=[floor()]) == wall_of(tie(0.03))


@pytest.mark.parametrize("at_z", [3.0, 0.5])
def test_a_tie_that_falls_steeply_from_its_anchor_presses_it_down(at_z: float) -> None:
    """Above the cracks at which its pull has no lever nothing turns."""
    steep = assess.TieLoad(
        at=[-8.8, 0.0, at_z], anchor=[-10.0, 0.0, 4.9], length=dist([-8.8, at_z], [-10.0, 4.9]),
        plate=Plate(**FULL), evidence="tests", site=SiteAction(0.03), **BAR,
    )  # fmt: skip
    wall = assess.box(thickness=0.6, length=9.0, height=6.0, base=[-9.1, 0, 0], density=2000.0, name="front")
    block = assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[steep], around=[far()])
    (load,) = (each for each in block.mechanism.positive.loads if isinstance(each, Tie))
    assert load.anchorage is not None
    found = load.anchorage.far_wall
    assert found is None or found.levers > 0.0


def shelf(length: float = L, *, thickness: float = 0.1, z: float = 4.2) -> Any:
    """A strip of stone on its inner face that touches nothing else."""
    return assess.box(
        thickness=thickness, length=length, height=0.1, density=2000.0, base=[-9.7 + thickness / 2, 0, z], name="shelf"
    )


def test_what_reaches_nothing_beyond_stops_it_not():
    """A shelf, and one that another touches, hold nothing; where that one stands on the ground, they do."""
    free = wall_of(tie(0.03))
    assert wall_of(tie(0.03), around=[shelf()]) == free
    for z, height, held in ((4.2, 0.1, False), (0.0, 5.0, True)):
        post = assess.box(thickness=0.2, length=L, height=height, density=2000.0, base=[-9.5, 0, z], name="post")
        (found,) = anchorages(tie(0.03), around=[shelf(), post])
        assert (found.far_wall is None) is held
        assert found.far_end.held_by == (("shelf",) if held else ())


def test_what_covers_less_than_what_turns_stops_it_not():
    narrow = assess.box(thickness=9.4, length=1.0, height=0.4, density=2400.0, base=[-5.0, 0, 4.5], name="roof")
    assert wall_of(tie(0.03), around=[narrow]) == wall_of(tie(0.03))
    whole = assess.box(thickness=9.4, length=L, height=0.4, density=2400.0, base=[-5.0, 0, 4.5], name="roof")
    (found,) = anchorages(tie(0.03), around=[whole, side()])
    assert (found.far_end.unexamined, found.far_end.held_by) == ("held", ("roof",))


@pytest.mark.parametrize("x", [-9.2, -10.6])
def test_an_anchor_in_the_air_beside_a_wall_is_refused(x: float):
    """The wall is from x = -9.7 to -10.3: half a metre in front of it, and through it."""
    in_air = replace(tie(), anchor=[x, 0, Z], length=0.3 - x)
    with pytest.raises(
        AssessError, match=r'meets the wall "rear" from \[-9.7, 0, 4\] to \[-10.3, 0, 4\]; move `anchor`'
    ):
        anchorages(in_air)
    assert anchorages(replace(tie(), anchor=[-8.5, 0, Z], length=8.8))[0].far_end.unexamined == "no wall"


def test_a_wall_that_stands_on_it_is_told():
    """Its upper part, half as thick again, stands on it as a body of its own."""
    upper = assess.box(thickness=0.9, length=L, height=2.0, density=2000.0, base=[-10.0, 0, H], name="upper")
    (found,) = anchorages(tie(0.03), around=[upper])
    assert (found.far_end.body, found.far_end.stack) == ("rear", ("upper",))
    (found,) = anchorages(tie(0.03, z=5.5), around=[upper])
    assert (found.far_end.body, found.far_end.stack) == ("upper", ("rear",))


def test_a_floor_that_bears_on_it_counts_where_it_hurts():
    """Let in by 0.2 m it bears there: its weight would help where nothing shakes, and drives where the ground does."""
    bearing = floor(to=-9.9)
    load = assess.BodyLoad(body="floor", share=None)
    found = wall_of(tie(0.09), load, around=[bearing])
    bare = wall_of(tie(0.09))
    assert found.strength < bare.strength
    assert found.overturning > bare.overturning
    light = wall_of(tie(0.0), load, around=[bearing])
    assert light.strength == pytest.approx(wall_of(tie(0.0)).strength, rel=1e-9)


def test_no_body_at_the_anchor_or_no_site_is_not_examined():
    assert anchorages(tie(), thickness=0.0)[0].far_wall is None
    assert anchorages(tie(), thickness=0.0)[0].far_end.unexamined == "no wall"
    (found,) = anchorages(replace(tie(), site=None))
    assert (found.far_wall, found.far_end.body, found.far_end.unexamined) == (None, "rear", "no site")


def test_a_bar_or_a_floor_that_holds_the_anchor_is_no_far_wall():
    bar = assess.box(thickness=10.0, length=0.02, height=0.02, density=7850.0, base=[-5.0, 0, 3.99], name="bar")
    (found,) = anchorages(tie(), thickness=0.0, around=[bar])
    assert found.far_wall is None


def test_it_may_be_named():
    assert wall_of(tie(far_wall="rear")).body == "rear"
    with pytest.raises(AssessError, match=r'far_wall = "back": no body .*; choose of rear'):
        anchorages(tie(far_wall="back"))
    off = assess.box(thickness=0.6, length=2.0, height=5.0, density=2000.0, base=[-12.0, 0, 0], name="other")
    with pytest.raises(AssessError, match="the anchor does not lie in it"):
        anchorages(tie(far_wall="other"), around=[off])


def test_a_hole_longer_than_the_wall_is_thick_is_refused():
    injected = {"far_strength": None, "hole": 0.05, "bond_strength": 0.3e6}
    wall_of(tie(embedment=0.6, **injected))
    with pytest.raises(AssessError, match=r'embedment = 0.7 m: the wall "rear" is 0.6 m thick'):
        anchorages(tie(embedment=0.7, **injected))


INJECTED = {"far_strength": None, "hole": 0.05, "bond_strength": 1e6, "embedment": 0.6}


def far_cone(*ties: Any, **changes: Any) -> float:
    cone = anchorages(*ties, **changes)[0].far_end.cone
    assert cone is not None
    return cone


def test_the_cone_of_an_injected_end_is_whole_far_from_edges_and_neighbours():
    """pi (0.05 + 0.6) 0.6 m2."""
    assert far_cone(tie(**INJECTED), length=9.0) == pytest.approx(pi * 0.65 * 0.6, rel=1e-3)
    assert anchorages(tie())[0].far_end.cone is None


def test_the_top_of_its_wall_and_neighbours_cut_the_cone_of_an_injected_end():
    """Of a hole that touches the top the circle of radius r = 0.025 + y at a depth y loses 2 acos(0.025 / r) r.

    Two holes 0.4 m apart share one outline: each has more than half of its own cone, and less than all.
    """
    y = (np.arange(2000) + 0.5) / 2000 * 0.6
    r = 0.025 + y
    by_arcs = float(np.mean(2.0 * (pi - np.arccos(0.025 / r)) * r)) * 0.6
    at_top = far_cone(tie(z=H - 0.025, **INJECTED), length=9.0)
    assert at_top == pytest.approx(by_arcs, rel=2e-2)
    assert at_top <= by_arcs * 1.001
    near = far_cone(tie(y=0.2, **INJECTED), tie(y=-0.2, **INJECTED), length=9.0)
    assert pi * 0.65 * 0.3 < near < 0.9 * pi * 0.65 * 0.6


def test_a_pretension_that_it_cannot_hold_is_refused():
    held = replace(tie(0.03), force=5e3)
    assert anchorages(held)[0].far_wall_holds
    with pytest.raises(AssessError, match=r"a pretension of 5 kN, above .* \(far wall\)"):
        anchorages(replace(held, site=SiteAction(0.08)))
    with pytest.raises(AssessError, match=r'the wall "rear" .* turns inwards by itself at 0.12 g, .* hold that wall'):
        anchorages(replace(held, site=SiteAction(0.2)))
