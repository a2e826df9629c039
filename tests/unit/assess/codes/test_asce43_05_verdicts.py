"""ASCE 43-05: what is allowed of the rotation that really overturns, and where the motion of a floor decides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.asce43_05 import OF_CIRCOLARE, Asce4305Options
from assess.codes.check import Reason
from assess.codes.histories import SuiteResponse
from assess.mechanisms.single_block import equivalent_block
from assess.oscillator import Branch, Oscillator
from spectra.asce7 import design_spectrum
from tests.support.answered import checks_of, context_at

SPECTRUM = design_spectrum(s_ds=0.5 * g, s_d1=0.25 * g, t_l=6.0)
WALL = equivalent_block("w", p=1.8, uplift=0.18, radius=2.4).oscillator


def on_joints(branch: Branch, share: float) -> Branch:
    """The branch as if its joints gave way: it overturns at a share of its rigid rotation."""
    return replace(branch, overturning_flexible=share * branch.overturning)


def history_checks(rocker: Oscillator, *suites: SuiteResponse):
    levels = tuple(suite.pga for suite in suites)
    return checks_of("asce43-05-history", rocker, context_at(SPECTRUM, levels, suites=suites, incremental=suites))


def test_each_record_counts_by_what_overturns_its_own_branch() -> None:
    """Maxima 0.2, 0.2, 0.2 on a branch that goes at 0.8, and 0.3, 0.3 on one that goes at 0.4: shares 0.25 and 0.75."""
    rocker = replace(WALL, positive=on_joints(WALL.positive, 0.8), negative=on_joints(WALL.positive, 0.4))
    branches = ("positive", "positive", "positive", "negative", "negative")
    suite = SuiteResponse(0.2 * g, (0.2, 0.2, 0.2, 0.3, 0.3), "negative", branches)
    (check,) = history_checks(rocker, suite)
    assert check.ratio == pytest.approx((3 * 0.25 + 2 * 0.75) / 5 / 0.5, rel=1e-12)
    assert (check.verdict, check.branch) == ("pass", "negative")
    assert check.capacity_rotation_ratio == pytest.approx(0.5 * 0.4, rel=1e-12)
    assert check.rotation_ratio / check.capacity_rotation_ratio == pytest.approx(check.ratio, rel=1e-12)
    (all_there,) = history_checks(rocker, replace(suite, branches=()))
    assert all_there.ratio == pytest.approx((3 * 0.5 + 2 * 0.75) / 5 / 0.5, rel=1e-12)
    assert all_there.verdict == "fail"


@pytest.mark.parametrize(
    ("ratio", "verdict", "reason"),
    [
        ((0.5,) * 5, "pass", Reason.WITHIN),
        ((0.51,) * 5, "fail", Reason.BEYOND),
        ((0.9, 0.9, 0.2, 0.2, 0.2), "pass", Reason.WITHIN),
        ((0.1, 0.1, 0.1, 0.1, None), "fail", Reason.RECORDS_OVERTURN),
        ((0.1, 0.1, 0.1, 0.1), "not-answered", Reason.TOO_FEW_RECORDS),
        ((None, 0.1), "not-answered", Reason.TOO_FEW_RECORDS),
        ((0.0,) * 5, "pass", Reason.NO_ROCKING),
    ],
)
def test_the_rule_of_histories(ratio, verdict, reason) -> None:
    (check,) = history_checks(WALL, SuiteResponse(0.2 * g, ratio, "positive"))
    assert (check.verdict, check.reason.key) == (verdict, reason)


def spectrum_checks(rocker: Oscillator, *levels: float, floor_ratio: float | None = 0.0, floor_by=None, **more):
    options = Asce4305Options(floor_vertical_ratio=floor_ratio, floor_spectrum=floor_by)
    return checks_of("asce43-05-spectrum", rocker, context_at(SPECTRUM, levels, **more), options)


def test_a_third_of_what_overturns_is_allowed_with_half_beside_it() -> None:
    rocker = replace(WALL, positive=on_joints(WALL.positive, 0.9), negative=on_joints(WALL.positive, 0.9))
    (check,) = spectrum_checks(rocker, 0.2 * g)
    overturns = 0.9 * WALL.positive.overturning
    found = {step.symbol: step.value for step in check.steps}
    assert check.capacity == pytest.approx(overturns / 3.0, rel=1e-12)
    assert check.capacity_rotation_ratio == pytest.approx(0.3, rel=1e-12)
    assert found["θ_1/2"] == pytest.approx(overturns / 2.0, rel=1e-12)
    assert found["PGA(θ_1/2)"] > check.capacity_pga_g
    (half,) = spectrum_checks(rocker, found["PGA(θ_1/2)"] * g)
    assert (half.verdict, half.demand) == ("fail", pytest.approx(overturns / 2.0, rel=1e-6))


def test_of_a_body_that_rocks_one_way_it_says_nothing() -> None:
    (check,) = spectrum_checks(replace(WALL, negative=None), 0.01 * g)
    assert (check.verdict, check.reason.key) == ("not-applicable", Reason.ONE_SIDED)


def test_upstairs_it_goes_by_the_floor_s_spectrum_and_without_one_it_can_only_fail() -> None:
    """A floor that doubles every ordinate halves the PGA at capacity and at uplift."""
    (ground,) = spectrum_checks(WALL, 0.05 * g)
    floor = replace(SPECTRUM, factor=2.0, code="floor")
    low, high = spectrum_checks(WALL, 0.02 * g, 2.0 * g, elevation=5.0, floor_spectrum=floor)
    assert (low.verdict, high.verdict) == ("pass", "fail")
    assert {low.input_at, high.input_at} == {"mechanism base"}
    assert low.capacity_pga_g == pytest.approx(ground.capacity_pga_g / 2.0, rel=1e-6)
    assert low.uplift_pga_g == pytest.approx(ground.uplift_pga_g / 2.0, rel=1e-12)
    assert not any(remark.key == "ground-motion" for remark in low.remarks)
    low, high = spectrum_checks(WALL, 0.02 * g, 2.0 * g, elevation=5.0)
    assert (low.verdict, low.reason.key, high.verdict) == ("not-answered", Reason.GROUND_MOTION, "fail")


def test_a_floor_s_spectrum_plays_no_part_on_the_ground() -> None:
    floor = replace(SPECTRUM, factor=2.0, code="floor")
    (with_floor,), (without,) = spectrum_checks(WALL, 0.2 * g, floor_spectrum=floor), spectrum_checks(WALL, 0.2 * g)
    assert (with_floor.demand, with_floor.input_at) == (without.demand, "ground")


def test_a_floor_with_a_peak_of_its_own_never_demands_less() -> None:
    """Peaks anywhere, of any height, over the ground's spectrum: the PGA at capacity only falls."""
    rng = np.random.default_rng(5)
    levels = tuple(rng.uniform(0.02, 0.5, 6) * g)
    plain = spectrum_checks(WALL, *levels, elevation=5.0, floor_spectrum=SPECTRUM)
    for _ in range(20):
        at, height, width = rng.uniform(0.05, 4.0), rng.uniform(0.5, 5.0), rng.uniform(0.05, 0.3)

        def ordinates(period, damping, at=at, height=height, width=width):
            peak = 1.0 + height * np.exp(-((np.log(np.maximum(period, 1e-9) / at) / width) ** 2))
            return SPECTRUM.ordinates(period, damping) * peak

        peaked = spectrum_checks(WALL, *levels, elevation=5.0, floor_spectrum=replace(SPECTRUM, ordinates=ordinates))
        for before, after in zip(plain, peaked, strict=True):
            assert after.capacity_pga_g <= before.capacity_pga_g * (1 + 1e-9)
            assert np.inf if after.demand is None else after.demand >= (before.demand or 0.0) * (1 - 1e-9)
            assert (after.verdict == "pass") == (after.level_pga_g <= after.capacity_pga_g * (1 + 1e-9))


def test_on_a_floor_a_pass_needs_the_vertical_spectrum_of_the_floor() -> None:
    """F_V = sqrt(1 + (tan 0.18 / 2)^2) = 1.00413 divides the PGA at capacity; what fails does so without it."""
    upstairs = {"elevation": 5.0, "floor_spectrum": SPECTRUM}
    (unknown,), (still,), (shaken,) = (
        spectrum_checks(WALL, 0.02 * g, floor_ratio=ratio, **upstairs) for ratio in (None, 0.0, 0.5)
    )
    assert (unknown.verdict, unknown.provisional, unknown.may_pass) == ("not-answered", "pass", False)
    assert (unknown.reason.key, unknown.reason.where) == (
        Reason.VERTICAL_UNKNOWN,
        "procedures.asce43-05.floor_vertical_ratio",
    )
    assert (still.verdict, shaken.verdict) == ("pass", "pass")
    assert still.capacity_pga_g / shaken.capacity_pga_g == pytest.approx(1.00413, rel=1e-5)
    (beyond,) = spectrum_checks(WALL, 2.0 * g, floor_ratio=None, **upstairs)
    assert beyond.verdict == "fail"


def test_another_country_s_floor_spectrum_decides_only_where_it_is_named_and_says_so() -> None:
    upstairs = {"elevation": 5.0, "floor_spectrum": replace(SPECTRUM, clause=OF_CIRCOLARE)}
    (unnamed,), (named,) = (
        spectrum_checks(WALL, 0.02 * g, floor_by=by, **upstairs) for by in (None, "circolare-7-2019")
    )
    assert (unnamed.verdict, unnamed.provisional, unnamed.may_pass) == ("not-answered", "pass", False)
    assert (unnamed.reason.key, unnamed.reason.where) == (
        Reason.FLOOR_SPECTRUM_UNNAMED,
        "procedures.asce43-05.floor_spectrum",
    )
    assert named.verdict == "pass"
    assert "floor-spectrum-of-other-code" in [each.key for each in named.conditions]
    assert named.capacity_pga_g == unnamed.capacity_pga_g
    (beyond,) = spectrum_checks(WALL, 2.0 * g, **upstairs)
    assert beyond.verdict == "fail"
    (own,) = spectrum_checks(WALL, 0.02 * g, elevation=5.0, floor_spectrum=SPECTRUM)
    assert "floor-spectrum-of-other-code" not in [each.key for each in own.conditions]


@pytest.mark.parametrize(
    ("share", "support", "conditions"),
    [(0.999, "free", ["one-component"]), (0.929, "free", ["one-component"]), (0.928, "free", []),
     (0.999, "spanning", [])],
)  # fmt: skip
def test_a_body_that_stands_free_takes_both_horizontal_components_or_says_so(share, support, conditions) -> None:
    """100 % in the plane with 40 % across are sqrt(1.16) = 1.0770 times the action, 0.9285 of it the inverse."""
    (found,) = spectrum_checks(WALL, 0.2 * g, support=support)
    (check,) = spectrum_checks(WALL, share * found.capacity_pga_g * g, support=support)
    assert (check.verdict, [each.key for each in check.conditions]) == ("pass", conditions)
    lines = [step.value for step in check.steps if step.symbol == "k_h"]
    assert lines == ([pytest.approx(1.0770330, rel=1e-7)] if support == "free" else [])


UPSTAIRS = {"elevation": 5.0, "histories_at": "mechanism base", "transfer": "by a filter"}


@pytest.mark.parametrize(
    ("capacity", "ratio", "more", "keys"),
    [
        (0.217, 0.0, {}, []),  # 1.0770 times 0.2 g
        (0.215, 0.0, {}, ["one-component"]),
        (0.2195, 1.0, {}, []),  # tan 0.18 = 0.181970: F_V = 1.016422, 1.094720 in all, 0.218944 g
        (0.2185, 1.0, {}, ["one-component"]),
        (0.201, 0.0, {"support": "spanning"}, []),
        (0.202, 1.0, {"support": "spanning"}, ["one-component"]),
        (0.204, 1.0, {"support": "spanning"}, []),
        (0.9, 1.0, UPSTAIRS, ["no-vertical-on-floor"]),
    ],
)
def test_histories_of_one_component_say_so_where_the_scan_does_not_reach_all(capacity, ratio, more, keys) -> None:
    suite, failing = (
        SuiteResponse(0.2 * g, (0.3,) * 5, "positive"),
        SuiteResponse(capacity * g, (None,) * 5, "positive"),
    )
    context = replace(context_at(SPECTRUM, (0.2 * g,), suites=(suite,), **more), vertical_ratio=ratio)
    between = tuple(SuiteResponse(capacity * g * share, (0.3,) * 5, "positive") for share in (0.999, 0.9999))
    scanned = replace(context, incremental=(suite, *between, failing))
    (check,) = checks_of("asce43-05-history", WALL, scanned)
    assert (check.verdict, [each.key for each in check.conditions]) == ("pass", keys)
