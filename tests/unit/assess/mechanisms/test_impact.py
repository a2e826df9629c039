"""What an impact keeps where loads move with the mechanism, and where it stops, by momenta worked out by hand."""

from __future__ import annotations

from math import atan2, sin

import pytest

from assess.errors import MechanismError
from assess.loads.load import Force, PointMass
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from tests.support.bodies import planar_box

T, H, LENGTH, RHO = 0.6, 4.0, 2.0, 1800.0
M = RHO * T * H * LENGTH
J = M * (T**2 + H**2) / 12.0
HALF = T / 2.0
LONG = {"length": LENGTH, "density": RHO}
WALL = planar_box(T, H, **LONG)


def kept_by_hand(*masses):
    """Angular momentum about the new hinge (-HALF, 0) before the impact, over the inertia about it after.

    masses : (m, x, z, bearing). One unit of clockwise rotation about (HALF, 0) gives the velocity (z, HALF - x); a
    mass that does not bear has its horizontal part alone.
    """
    before, after = J + M * ((H / 2.0) ** 2 - HALF**2), J + M * ((H / 2.0) ** 2 + HALF**2)
    for m, x, z, bearing in masses:
        before += m * z * z + bearing * m * -(x + HALF) * (HALF - x)
        after += m * z * z + bearing * m * (x + HALF) ** 2
    return before / after


@pytest.mark.parametrize("bearing", [True, False])
@pytest.mark.parametrize("x", [0.0, 0.2])
def test_momentum_is_kept_where_a_load_moves(bearing, x):
    mass = PointMass("roof", 2000.0, (x, 3.8), bearing)
    found = single_block("w", WALL, loads=(mass,))
    assert found.restitution[0] == pytest.approx(kept_by_hand((2000.0, x, 3.8, bearing)), rel=1e-12)
    assert found.restitution[1] == pytest.approx(kept_by_hand((2000.0, -x, 3.8, bearing)), rel=1e-12)
    assert found.restitution_source.startswith("momentum kept over the mechanism")


def test_a_mass_that_does_not_bear_takes_part_in_the_impact():
    """Housner's value of the plain block knows nothing of it; it is printed beside."""
    mass = PointMass("roof", 0.35 * M, (0.0, 3.8), False)
    plain = 1.0 - 1.5 * sin(atan2(T, H)) ** 2
    found = single_block("w", WALL, loads=(mass,))
    assert found.restitution[0] == pytest.approx(kept_by_hand((0.35 * M, 0.0, 3.8, False)), rel=1e-12)
    assert found.restitution[0] > plain
    assert f'"thesis" would give {plain:.3f}' in found.restitution_source
    asked = single_block("w", WALL, loads=(mass,), restitution=("thesis", "thesis"))
    assert asked.restitution[0] == pytest.approx(plain, rel=1e-12)
    assert f'"momentum" would give {found.restitution[0]:.3f}' in asked.restitution_source


def test_forces_alone_leave_the_rule_of_the_thesis():
    thrust = Force("thrust", (500.0, -2000.0), (0.0, 3.8))
    found = single_block("w", WALL, loads=(thrust,))
    assert found.restitution == single_block("w", WALL).restitution
    assert found.restitution_source == "Housner 1963, Mehrotra eq. 3.44"


def test_well_above_the_plain_block_is_told_with_the_reason():
    stocky = planar_box(1.6, H, **LONG)
    plain = single_block("w", stocky)
    heavy = single_block("w", stocky, loads=(PointMass("bell", 20000.0, (0.0, 6.0), False),))
    assert heavy.restitution[0] > plain.restitution[0] + 0.03
    (told,) = [text for text in map(str, heavy.warnings) if "restitution" in text]
    assert f"above the {plain.restitution[0]:.3f} of the same blocks without bell" in told
    light = single_block("w", stocky, loads=(PointMass("bell", 20.0, (0.0, 6.0), False),))
    assert not light.warnings


def test_what_slides_on_its_seat_passes_on_no_horizontal_momentum():
    """Both ends are printed where they differ: a bearing mass of the same weight, at the middle of a stocky block."""
    stocky, m, z = planar_box(2.0, H, **LONG), 30000.0, 4.0
    block, half = RHO * 2.0 * H * LENGTH, 1.0
    inertia = block * (2.0**2 + H**2) / 12.0
    before = inertia + block * ((H / 2.0) ** 2 - half**2) - m * half**2
    after = inertia + block * ((H / 2.0) ** 2 + half**2) + m * half**2
    found = single_block("w", stocky, loads=(PointMass("floor", m, (0.0, z), True),))
    assert f"{before / after:.3g} if the loads slide on their seats" in found.restitution_source
    assert found.restitution[0] == pytest.approx((before + m * z * z) / (after + m * z * z), rel=1e-12)


def two_block_by_hand(t, h, crack, m=0.0, at=0.0, *, unit=RHO * LENGTH):
    """What 3.46 and momentum keep of a wall t x h cracked at `crack`, with a bearing mass m in its middle at `at`.

    For a unit rate of the lower block, clockwise about its toe (t/2, 0), the upper one turns back by r = crack/(h -
    crack) about the other edge of the crack, so that its top stays on the vertical: (x', z') of each centre and of the
    mass, which is on the upper block. The branch after the impact is the mirror image, turning the other way.
    """
    r, low, up = crack / (h - crack), crack, h - crack
    edge = (crack, t)  # x', z' of the edge (-t/2, crack) of the lower block, about which the upper one turns

    def of_upper(z):
        return edge[0] - r * (z - crack), edge[1] + r * t / 2.0

    rows = [
        (unit * t * low, unit * t * low * (t**2 + low**2) / 12.0, low / 2.0, (low / 2.0, t / 2.0), 1.0),
        (unit * t * up, unit * t * up * (t**2 + up**2) / 12.0, crack + up / 2.0, of_upper(crack + up / 2.0), -r),
        (m, 0.0, at, of_upper(at), -r),
    ]
    by_momentum = sum(M * (x * x - z * z) + J * w * w for M, J, _, (x, z), w in rows)  # mirrored: x' as before, z' not
    after = sum(M * (x * x + z * z) + J * w * w for M, J, _, (x, z), w in rows)
    about = [sum(M * (height * x + side * t / 2.0 * z) + J * w for M, J, height, (x, z), w in rows) for side in (-1, 1)]
    return about[0] / about[1], by_momentum / after


def test_two_blocks_keep_by_346_and_by_momentum_what_statements_of_impulse_say():
    """errata: wall 0.4 x 4 m, crack at 2.2 m: 3.46 0.93201, projection 0.77276; at 2.4 m 0.93939 and 0.79630."""
    assert two_block_by_hand(0.4, 4.0, 2.2) == pytest.approx((0.93201, 0.77276), abs=1e-5)
    assert two_block_by_hand(0.4, 4.0, 2.4) == pytest.approx((0.93939, 0.79630), abs=1e-5)


@pytest.mark.parametrize("m", [1e-6, 500.0, 5000.0])
def test_two_blocks_with_a_load_keep_346_times_what_the_load_changes_by_momentum(m):
    t, h, crack = 0.4, 4.0, 2.2
    lower, upper = planar_box(t, crack, **LONG), planar_box(t, h - crack, base=crack, **LONG)
    floor = PointMass("floor", m, (0.0, 3.0), True, 1)
    found = two_block("w", lower, upper, loads=(floor,))
    (thesis, bare), (_, loaded) = two_block_by_hand(t, h, crack), two_block_by_hand(t, h, crack, m, 3.0)
    assert found.restitution == pytest.approx((thesis * loaded / bare,) * 2, rel=1e-9)
    assert found.restitution_source.startswith("angular momentum about the new base hinge")
    assert f'"momentum" would give {loaded:.3f}' in found.restitution_source
    if m < 1.0:
        assert found.restitution == pytest.approx(two_block("w", lower, upper).restitution, rel=1e-6)


def test_two_blocks_with_a_floor_are_not_refused():
    """3.46 about one base hinge would add energy to some, and none is added."""
    floor = PointMass("floor", 30000.0, (0.0, 2.4), True, 1)
    found = two_block("w", planar_box(T, 2.2, **LONG), planar_box(T, 1.8, base=2.2, **LONG), loads=(floor,))
    assert 0.0 <= found.restitution[0] < 1.0
    assert '"momentum" would give' in found.restitution_source


def test_no_default_is_refused():
    """Hinges that differ: the thesis' rule for two blocks may add energy; then momentum is kept instead."""
    lower, upper = planar_box(T, 2.2, **LONG), planar_box(T, 1.8, base=2.2, **LONG)
    front, back = ((0.3, 0.0), (-0.1, 2.2), (0.3, 4.0)), ((0.1, 0.0), (0.3, 2.2), (-0.3, 4.0))
    found = two_block("w", lower, upper, hinges=front, hinges_negative=back)
    assert all(each >= 0.0 for each in found.restitution)
    with pytest.raises(MechanismError, match="would add energy"):
        two_block("w", lower, upper, hinges=front, hinges_negative=back, restitution=("thesis", "thesis"))


def test_a_squat_block_stops_and_everything_else_is_given():
    """1 - 3/2 sin^2 of a block five times as wide as high is negative."""
    squat = planar_box(20.0, H, **LONG)
    signed = 1.0 - 1.5 * sin(atan2(20.0, H)) ** 2
    found = single_block("w", squat)
    assert signed < 0.0
    assert found.restitution == (0.0, 0.0)
    assert found.stopped == pytest.approx(signed, rel=1e-12)
    assert any(
        f"restitution {signed:.3g} (Housner 1963, Mehrotra eq. 3.44): a" in text for text in map(str, found.warnings)
    )
    given = single_block("w", squat, restitution=(0.2, 0.2))
    assert given.stopped is None
    assert given.restitution == (0.2, 0.2)


def test_one_branch_that_stops_is_enough():
    """The impulse law of two hinges is the same both ways; a number given for one leaves the other to the law."""
    found = single_block("w", planar_box(20.0, H, **LONG), restitution=(0.2, None))
    assert found.restitution == (0.2, 0.0)
    assert found.stopped is not None


def test_the_rebound_of_a_one_sided_block_has_a_range():
    found = single_block("w", WALL, sides="one")
    assert found.rebounds == (1.0, 0.5, 1.5)
    assert "the worst of 0.5, 1 and 1.5 times it" in found.restitution_source
    assert single_block("w", WALL, sides="one", restitution=(0.3, 0.3)).rebounds == (1.0,)
    assert single_block("w", WALL).rebounds == (1.0,)


def test_where_the_formula_gives_no_rebound_there_is_none():
    """3.45 is positive for a block wider than high: cos^2 alpha falls below I / (2 M R^2)."""
    found = single_block("w", planar_box(8.0, H, **LONG), sides="one")
    assert found.restitution == (0.0, 0.0)
    assert found.rebounds == (1.0,)
    assert any("no rebound" in text for text in map(str, found.warnings))


def test_a_chain_to_one_side_rebounds_as_a_slender_block_or_not_at_all():
    """3.45 of a block whose slenderness goes to 0, with I_O = 4/3 M R^2: (1 - 0)^2 (1 - 2 * 3/4) = -0.5."""
    found = two_block("w", planar_box(T, 2.2, **LONG), planar_box(T, 1.8, base=2.2, **LONG), sides="one")
    thin = single_block("w", planar_box(1e-4, H, **LONG), sides="one")
    assert found.restitution[0] == pytest.approx(thin.restitution[0], rel=1e-6) == 0.5
    assert found.rebounds == (1.0, 0.0, 0.5, 1.5)
    assert found.stopped is None
    assert any("no formula is published" in text for text in map(str, found.warnings))


def test_a_given_restitution_that_takes_more_energy_than_the_rule_is_warned_of():
    """For a slender wall momentum keeps 1 - 3/2 sin^2 alpha; a number well below it flatters every history."""
    by_rule = single_block("w", WALL).restitution[0]
    low = single_block("w", WALL, restitution=(by_rule - 0.05, by_rule - 0.05))
    assert any("takes more energy" in text for text in map(str, low.warnings))
    near = single_block("w", WALL, restitution=(by_rule - 0.02, by_rule - 0.02))
    assert not any("takes more energy" in text for text in map(str, near.warnings))
    assert not single_block("w", WALL, sides="one", restitution=(0.1, 0.1)).warnings
