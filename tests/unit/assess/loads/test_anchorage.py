"""The anchorage of ties, way by way, against arithmetic by hand."""

from __future__ import annotations

from math import inf, pi

import numpy as np
import pytest
import shapely

import assess
from assess.errors import AssessError
from assess.loads.anchorage import (
    Anchorage,
    Plate,
    PlateSite,
    arch_strength,
    bar_strength,
    bearing_strength,
    bending_strength,
    bond_strength,
    cones_meet,
    courses_under,
    round_cone,
    shear_strength,
    sliding_surface,
    thread_strength,
    weakest_cone,
)

SQUARE = Plate(width=0.3, height=0.3)
RUBBLE = {"f_v0": 0.02e6, "gamma_M": 2.0, "FC": 1.35}


@pytest.mark.parametrize(("sigma_n", "mu", "kilonewtons"), [(0.0, 0.4, 16.0), (0.05e6, 0.4, 32.0), (0.05e6, 0.0, 16.0)])
def test_a_plate_on_rubble_punches_at_16_and_at_32_kn(sigma_n: float, mu: float, kilonewtons: float) -> None:
    """2 (0.3 + 0.3 + 1.2) 0.6 = 2.16 m2; x 0.02 MPa / 2.7 = 16.0 kN; x (0.02 + 0.4 x 0.05) MPa / 2.7 = 32.0 kN."""
    surface = weakest_cone([(SQUARE, 0.0, 0.0)], 0.6)[0]
    assert surface == pytest.approx(2.16, rel=1e-9)
    assert surface * shear_strength(mu=mu, sigma_n=sigma_n, **RUBBLE) / 1e3 == pytest.approx(kilonewtons, rel=1e-6)


def test_a_bar_of_20_mm_of_s235_yields_at_70_kn() -> None:
    """pi 10^2 = 314.2 mm2, x 235 / 1.05 = 70.3 kN; in a thread of 245 mm2 of 360 MPa 0.9 x 245 x 360 / 1.25 = 63.5."""
    assert bar_strength(A=pi * 0.01**2, f_y=235e6) == pytest.approx(70.3e3, rel=1e-3)
    assert thread_strength(A_s=245e-6, f_u=360e6) == pytest.approx(63.504e3, rel=1e-9)


def test_a_plate_of_300_mm_needs_13_mm_for_100_kn() -> None:
    """p = 100 / 0.09 = 1111 kPa, m = p 0.13^2 / 2 = 9.39 kN; t_p = sqrt(9.39e3 x 4 x 1.05 / 235e6) = 12.95 mm."""
    assert bending_strength(A_p=0.09, t_p=0.01295, f_y=235e6, c=0.13) == pytest.approx(100e3, rel=2e-3)
    assert bending_strength(A_p=0.09, t_p=0.01295, f_y=235e6, c=0.0) == inf


def test_bearing_arch_and_bond() -> None:
    """0.09 m2 0.5 MPa / 2.7 = 16.67 kN; 0.5 / 2.7 x 0.6^2 x 1.5 / 4 = 25 kN; pi 0.05 x 0.8 x 0.3 MPa / 2.7 = 13.96."""
    by = {"gamma_M": 2.0, "FC": 1.35}
    assert bearing_strength(A_b=0.09, f_h=0.5e6, **by) == pytest.approx(16.667e3, rel=1e-4)
    assert arch_strength(f_h=0.5e6, t=0.6, h_s=1.5, s=4.0, **by) == pytest.approx(25e3, rel=1e-9)
    assert bond_strength(d=0.05, l=0.8, f_b=0.3e6, **by) == pytest.approx(13.963e3, rel=1e-4)


def test_the_cone_of_a_round_plate_has_the_outline_pi_d_plus_t() -> None:
    assert weakest_cone([(Plate(diameter=0.3), 0.0, 0.0)], 0.6)[0] == pytest.approx(pi * 0.9 * 0.6, rel=1e-3)
    assert round_cone(0.3, 0.6) == pytest.approx(pi * 0.9 * 0.6, rel=1e-12)


def test_two_plates_whose_cones_meet_punch_as_one() -> None:
    """0.3 x 0.3 m, 0.5 m apart, 0.6 m deep. They are 0.2 m apart and meet at a depth of 0.1 m.

    Above it each has 4 (0.3 + 2 x), together 2.4 + 16 x: over 0.1 m 0.24 + 0.08 = 0.32 m2. Below it their outline is
    that of one of 0.8 x 0.3 m, 2.2 + 8 x: over 0.5 m from 0.1 to 0.6 1.1 + 4 (0.36 - 0.01) = 2.5 m2. In all 2.82, where
    two alone have 4.32.
    """
    pair = [(SQUARE, 0.0, 0.0), (SQUARE, 0.5, 0.0)]
    assert weakest_cone(pair, 0.6)[0] == pytest.approx(2.82, rel=2e-3)
    assert cones_meet(*pair, 0.6)
    apart = [(SQUARE, 0.0, 0.0), (SQUARE, 1.6, 0.0)]
    assert weakest_cone(apart, 0.6)[0] == pytest.approx(2 * 2.16, rel=1e-9)
    assert not cones_meet(*apart, 0.6)


def test_a_cone_at_the_top_of_a_wall_has_no_side_there() -> None:
    """The plate ends at the top: three sides, (0.3 + 2 x) + 2 (0.3 + x), over 0.6 m 0.54 + 0.72 = 1.26 m2."""
    wall = shapely.box(-5, -5, 5, 0.15)
    assert weakest_cone([(SQUARE, 0.0, 0.0)], 0.6, wall)[0] == pytest.approx(1.26, rel=1e-4)


def test_near_an_edge_it_runs_straight_out_where_that_is_shorter() -> None:
    """0.3 m of wall beyond the plate: a bottom of 0.3 + 2 x and sides of 0.6 + x, over 0.6 m 0.54 + 1.08 = 1.62 m2.

    The cone itself has all its sides to a depth of 0.3 m, 0.36 + 0.36, and below it 0.9 + 4 x, 0.27 + 0.54: 1.71 with
    the parts of both sides that the edge cuts off.
    """
    wall = shapely.box(-5, -5, 5, 0.45)
    assert weakest_cone([(SQUARE, 0.0, 0.0)], 0.6, wall)[0] == pytest.approx(1.62, rel=1e-4)
    assert weakest_cone([(SQUARE, 0.0, 0.0)], 0.6, shapely.box(-5, -5, 5, 5))[0] == pytest.approx(2.16, rel=1e-4)


def test_at_a_corner_two_sides_are_left_however_far_it_is() -> None:
    """0.4 m wide, 0.8 m below the top and d from an end, 0.55 m deep, on average over the depth.

    Two sides, to the top and to the end: (0.4 + 0.8 + 0.275) + (0.4 + d + 0.275) = 2.15 + d, least up to d = 1.65,
    where all four have 4 x 0.4 + 4 x 0.55 = 3.8. Three sides, without that to the end, have
    2 (0.4 + d + 0.275) + 0.4 + 0.55 = 2.3 + 2 d, never less than two.
    """
    plate, wall = Plate(width=0.4, height=0.4), shapely.box(-4.5, 0, 4.5, 7.8)
    ends = np.linspace(0.3, 2.0, 35)
    found = [weakest_cone([(plate, 4.3 - d, 6.8)], 0.55, wall)[0] for d in ends]
    assert found == pytest.approx(list(np.minimum(2.15 + ends, 3.8) * 0.55), rel=1e-4)


def test_an_opening_far_beside_a_plate_is_run_out_to_as_an_end_is() -> None:
    """A window higher than the cone, 1.2 m beside a plate 0.8 m below the top: 2.15 + 1.2 m, by the test above."""
    wall = shapely.box(-4.5, 0, 4.5, 7.8) - shapely.box(3.0, 5.5, 4.0, 7.6)
    plate = Plate(width=0.4, height=0.4)
    assert weakest_cone([(plate, 1.6, 6.8)], 0.55, wall)[0] < 3.6 * 0.55
    open_to_top = shapely.box(-4.5, 0, 4.5, 7.8) - shapely.box(3.0, 5.5, 4.0, 8.0)
    assert weakest_cone([(plate, 1.6, 6.8)], 0.55, open_to_top)[0] == pytest.approx(3.35 * 0.55, rel=1e-4)


def test_between_two_edges_two_sides_are_left() -> None:
    """A pier 1.2 m wide: above and below the plate it is cut across, 2 x 1.2 m, where four sides have 3.8 m."""
    pier = shapely.box(-0.6, -9, 0.6, 9)
    assert weakest_cone([(Plate(width=0.4, height=0.4), 0.0, 0.0)], 0.55, pier)[0] == pytest.approx(
        2.4 * 0.55, rel=1e-4
    )


def test_an_opening_takes_the_sides_that_would_lie_in_it() -> None:
    """An opening as wide as the cone at its end, just under the plate: what is left are three sides, as at a top."""
    wall = shapely.box(-5, -5, 5, 5) - shapely.box(-5, -3, 5, -0.15)
    assert weakest_cone([(SQUARE, 0.0, 0.0)], 0.6, wall)[0] == pytest.approx(1.26, rel=1e-4)


FULL = {
    "width": 0.3, "height": 0.3, "thickness": 0.015, "yield_stress": 235e6, "nut": 0.05,
    "thread_area": 245e-6, "tensile_strength": 360e6, "shear_strength": 0.02e6, "bearing_strength": 1e6,
    "far_strength": 80e3,
}  # fmt: skip
IN_PLACE = PlateSite(0.6, 0.09, (2.16, 2.16), 1, (0.05e6, 0.05e6), 3.0, at_end=False)


def anchored(site: PlateSite = IN_PLACE, stated: float | None = None, **changes: object) -> Anchorage:
    return Anchorage(Plate(**{**FULL, **changes}), site, 314e-6, 235e6, stated)  # type: ignore[arg-type]


def test_the_least_way_gives_the_strength_and_its_name() -> None:
    """Thread 63.5; plate 0.09 x 0.015^2 x 235e6 / (2.1 x 0.125^2) = 145.0; bearing 33.3; punching 16.0 kN."""
    found = anchored()
    assert {link.name: round(link.strength or 0, -1) for link in found.links if link.name != "between"} == {
        "thread": 63500, "plate": 145030, "bearing": 33330, "punching": 16000, "far end": 80000,
    }  # fmt: skip
    assert (found.strength, found.governing) == (pytest.approx(16e3, rel=1e-9), "punching")


def test_weight_above_counts_with_what_a_falling_wall_leaves_of_it() -> None:
    """0.6 x 0.05 MPa x 0.4 = 0.012 MPa beside 0.02: 25.6 kN; a stress that is stated counts as it is: 32 kN."""
    assert anchored(friction=0.4).strength == pytest.approx(25.6e3, rel=1e-9)
    assert anchored(friction=0.4, normal_stress=0.05e6).strength == pytest.approx(32e3, rel=1e-9)


@pytest.mark.parametrize(
    ("height", "n", "kilonewtons"),
    [
        # one course: 0.6 x 2 x 0.3 = 0.36 m2, x 0.02 MPa / 2.7
        (0.15, 1, 2.667),
        # two: 0.6 (0.6 + 2 x 0.1) = 0.48 m2
        (0.3, 2, 3.556),
        # not quite three, of which it presses on the third: 0.6 (0.6 + 4 x 0.1) = 0.6 m2
        (0.44, 3, 4.444),
    ],
)
def test_units_under_a_plate_slide_on_their_beds(height: float, n: int, kilonewtons: float) -> None:
    found = anchored(height=height, course=0.15, overlap=0.1)
    (sliding,) = [link.strength for link in found.links if link.name == "sliding"]
    assert courses_under(height, 0.15) == n
    assert sliding == pytest.approx(kilonewtons * 1e3, rel=1e-3)
    assert (found.governing, found.strength) == ("sliding", sliding)


def test_at_the_top_of_a_wall_no_bed_above_the_units_rubs() -> None:
    assert sliding_surface(a=0.3, t=0.6, n=2, o=0.1, beds=1.0) == pytest.approx(0.6 * 0.5, rel=1e-12)


def test_units_that_slide_need_both_sizes_and_are_not_examined_without() -> None:
    assert "sliding" not in [link.name for link in anchored().links]
    plate = Plate(**{**FULL, "course": 0.15})  # type: ignore[arg-type]
    assert [key for key, _ in plate.faults()] == ["overlap"]


def test_a_group_shares_its_cone() -> None:
    group = PlateSite(0.6, 0.09, (2.16, 2.82), 2, (0.0, 0.0), 3.0, at_end=False)
    assert anchored(group).strength == pytest.approx(2.82 / 2 * 0.02e6 / 2.7, rel=1e-9)


def test_what_is_not_given_is_not_answered() -> None:
    found = anchored(bearing_strength=None, nut=None)
    assert found.strength is None
    assert found.governing is None
    assert found.missing == ("plate.nut", "plate.bearing_strength")
    assert anchored(bearing_strength=None, stated=12e3).strength == 12e3
    low = anchored(bearing_strength=None, stated=90e3)
    assert (low.strength, low.governing, low.missing) == (pytest.approx(16e3), "punching", ())


def test_the_wall_between_ties_is_asked_for_where_they_are_far_apart() -> None:
    def between(bay: float, *, at_end: bool, **changes: object) -> float | None:
        found = anchored(PlateSite(0.6, 0.09, (2.16, 2.16), 1, (0.0, 0.0), bay, at_end=at_end), **changes)
        return next(link.strength for link in found.links if link.name == "between")

    assert between(3.0, at_end=False) == inf
    assert between(4.0, at_end=True) is None
    assert between(4.0, at_end=True, between=30e3) == 30e3
    assert between(4.0, at_end=False) == pytest.approx(1e6 / 2.7 * 0.36 * 1.5 / 4.0)


def test_an_injected_end_has_the_lesser_of_bond_and_cone() -> None:
    """Bond 13.96 kN (above), cone pi (0.05 + 0.8) 0.8 x 0.02 MPa / 2.7 = 15.8 kN; 0.4 m: 6.98 and 4.19 kN."""
    injected = {"far_strength": None, "hole": 0.05, "bond_strength": 0.3e6}
    for embedment, expected in ((0.8, 13.963e3), (0.4, 4.189e3)):
        found = anchored(embedment=embedment, **injected)
        assert found.links[-1].strength == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"width": None}, "width"),
        ({"diameter": 0.3}, "width"),
        ({"nut": 0.16}, "nut"),
        ({"hole": 0.05}, "embedment"),
    ],
)
def test_keys_of_a_plate_that_do_not_go_together(changes: dict[str, object], key: str) -> None:
    plate = Plate(**{**FULL, **changes})  # type: ignore[arg-type]
    assert key in [name for name, _ in plate.faults()]


def test_python_hears_of_them_too() -> None:
    wall = assess.box(thickness=0.6, length=4.0, height=6.0, density=2000.0)
    tie = assess.TieLoad(force=1e3, at=[0, 0, 5], anchor=[-9, 0, 5], plate=Plate(**FULL))  # type: ignore[arg-type]
    with pytest.raises(AssessError, match="of a tie that stretches"):
        assess.single_block(wall, direction=[1, 0, 0], loads=[tie])


@pytest.mark.parametrize(
    ("key", "most"),
    [
        ("shear_strength", 0.5e6),
        ("normal_stress", 1e6),
        ("bearing_strength", 50e6),
        ("friction", 1.0),
        ("between", 1e6),
        ("far_strength", 1e6),
        ("embedment", 2.0),
        ("hole", 0.2),
    ],
)
def test_what_no_wall_bears_is_refused(key: str, most: float) -> None:
    """Taken up to the most that masonry can have; a little more is an error of its own key."""
    wall = assess.box(thickness=0.6, length=4.0, height=6.0, density=2000.0)
    far = {"far_strength": None, "hole": 0.05, "embedment": 0.5, "bond_strength": 0.3e6}

    def build(value: float) -> None:
        plate = Plate(**{**FULL, **(far if key in far and key != "far_strength" else {}), key: value})  # type: ignore[arg-type]
        assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[stretching(plate)])

    build(most)
    with pytest.raises(AssessError, match=key):
        build(1.01 * most)


def stretching(plate: Plate, *, area: float = 314e-6) -> assess.TieLoad:
    return assess.TieLoad(
        at=[0.3, 0, 4], anchor=[-9.7, 0, 4], length=10.0, area=area, young_modulus=210e9, yield_stress=235e6,
        fracture_strain=0.1, plate=plate,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("square_millimetres", "taken"), [(20_000, False), (491, False), (489, True), (124, True), (121, False)]
)
def test_a_bar_goes_with_its_thread(square_millimetres: float, *, taken: bool) -> None:
    """A thread of 245 mm2 is that of a bar of 122.5 to 490 mm2; of 200 cm2 it is not."""
    wall = assess.box(thickness=0.6, length=4.0, height=6.0, density=2000.0)
    tie = stretching(Plate(**FULL), area=square_millimetres * 1e-6)  # type: ignore[arg-type]
    if taken:
        assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[tie])
    else:
        with pytest.raises(AssessError, match=r"area = .* where the thread of its plate has 245 mm"):
            assess.single_block(wall, direction=[1, 0, 0], sides="one", loads=[tie])
