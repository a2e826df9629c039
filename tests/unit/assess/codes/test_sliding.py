"""Sliding as a check: which hinge, what verdict, and what it does not claim."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import sliding
from assess.codes.context import Context
from assess.codes.en1998_1 import Ec8Options
from assess.mechanisms.single_block import equivalent_block
from assess.oscillator import HingeForces, Pressure
from spectra.asce7 import design_spectrum
from tests.support.answered import HINGE, checks_of

ROCKER = equivalent_block("w", p=1.8, uplift=0.18, radius=2.4).oscillator
SPECTRUM = design_spectrum(s_ds=0.5 * g, s_d1=0.25 * g, t_l=6.0)
HEAVY = equivalent_block("h", p=1.0, uplift=1.2, radius=9.0).oscillator
LEVELS = tuple(level * g for level in (0.05, 0.2, 0.35, 0.6))


def hinge(needed: float, *, friction: float | None = 0.3, name: str = "A", **more) -> HingeForces:
    """A hinge that carries 1000 N and starts to rock at 0.4 g."""
    branch, start = "negative" if "'" in name else "positive", Pressure(1000.0, -1000.0 * needed)
    given = {"hinge": name, "branch": branch, "friction": friction, "horizontal": start.shear, "starting": start}
    return replace(HINGE, **{**given, **more})


def checks(*hinges: HingeForces, amplification: float = 1.0):
    context = Context(SPECTRUM, LEVELS, 0.0, 0.0, None, hinges=hinges, amplification=amplification)
    return sliding.assess_sliding(ROCKER, context)


def test_it_fails_only_where_the_level_reaches_the_acceleration_that_slides() -> None:
    """Needs 0.5 at 0.4 g, has 0.3: slides at 0.24 g."""
    found = checks(hinge(0.5))
    assert [check.verdict for check in found] == ["pass", "pass", "fail", "fail"]
    assert [check.demand for check in found] == pytest.approx([0.0625, 0.25, 0.4375, 0.5], rel=1e-12)
    assert {check.capacity for check in found} == {0.3}
    assert found[0].capacity_pga_g == pytest.approx(0.24, rel=1e-12)
    assert "slides before it rocks, at hinge A" in found[-1].reason.text
    assert "from PGA 0.24 g upwards" in found[0].reason.text


def test_amplified_at_its_base_it_slides_at_less() -> None:
    found = checks(hinge(0.5), amplification=2.0)
    assert [check.verdict for check in found] == ["pass", "fail", "fail", "fail"]
    assert found[0].capacity_pga_g == pytest.approx(0.12, rel=1e-12)
    assert found[0].uplift_pga_g == pytest.approx(np.tan(0.18) / 2, rel=1e-9)


def test_above_the_ground_the_motion_of_the_ground_fails_it_and_cannot_pass_it() -> None:
    context = Context(SPECTRUM, LEVELS, 0.0, 8.0, None, hinges=(hinge(0.5),))
    found = checks_of("sliding", ROCKER, context)
    assert [check.verdict for check in found] == ["not-answered", "not-answered", "fail", "fail"]
    raised = checks_of("sliding", ROCKER, replace(context, transfer="by a factor"))
    assert [check.verdict for check in raised] == ["pass", "pass", "fail", "fail"]


@pytest.mark.parametrize(("friction", "held"), [(0.3, [False, True]), (0.6, [False, False]), (None, [False, False])])
def test_a_pass_by_rocking_of_what_slides_first_holds_where_it_is_kept_from_sliding(friction, held) -> None:
    """Needs 0.5 at 0.4 g: with 0.3 it slides at 0.24 g, with 0.6 it rocks first."""
    context = Context(SPECTRUM, (0.2 * g, 0.35 * g), 0.0, 0.0, None, hinges=(hinge(0.5, friction=friction),))
    options = Ec8Options(behaviour_factor=2.0)
    found = checks_of("ec8-element", HEAVY, context, options)
    assert {check.verdict for check in found} == {"pass"}
    assert ["held-from-sliding" in [each.key for each in check.conditions] for check in found] == held


def test_what_slides_before_it_would_rock_is_not_said_not_to_rock() -> None:
    """Its joint needs 0.5 at 0.4 g, 1.25 per g: with 0.1 it slides from 0.08 g on, before it rocks at 0.18 g."""
    context = Context(SPECTRUM, (0.05 * g, 0.15 * g), 0.0, 0.0, None, hinges=(hinge(0.5, friction=0.1),))
    found = checks_of("asce43-05-spectrum", ROCKER, context)
    assert [check.reason.key for check in found if check.ratio == 0.0] == ["no-rocking", "slides-instead"]


def test_where_it_rocks_first_it_passes_at_every_level() -> None:
    found = checks(hinge(0.29))
    assert {check.verdict for check in found} == {"pass"}
    assert {check.capacity_pga_g for check in found} == {None}
    assert found[-1].ratio == pytest.approx(0.29 / 0.3, rel=1e-12)


def test_the_hinge_that_uses_its_friction_up_most_is_the_answer() -> None:
    """B needs less than A', but its faces are smoother."""
    *_, worst = checks(hinge(0.2), hinge(0.1, friction=0.05, name="B"), hinge(0.25, name="A'"))
    assert (worst.demand, worst.capacity, worst.branch) == (pytest.approx(0.1), 0.05, "positive")
    *_, behind = checks(hinge(0.2), hinge(0.25, name="A'"))
    assert behind.branch == "negative"


@pytest.mark.parametrize(
    ("hinges", "said"),
    [
        ((), "an equivalent block has no geometry"),
        ((hinge(0.2), hinge(0.2, friction=None, name="B")), "friction at hinge B is not known; give materials.stone"),
        ((hinge(0.2, starting=Pressure(-1500.0, 100.0)),), "hinge A would need a tension of 1500 N"),
    ],
)
def test_what_it_cannot_know_it_does_not_claim(hinges: tuple[HingeForces, ...], said: str) -> None:
    for check in checks(*hinges):
        assert (check.verdict, check.ratio) == ("not-answered", None)
        assert said in check.reason.text


def test_the_top_of_a_wall_is_held_and_decides_nothing_but_its_sheet_says_with_what() -> None:
    top = hinge(
        0.0, name="C", held=True, friction=None, starting=Pressure(0.0, -700.0), horizontal=-700.0, single=False
    )
    found = checks(hinge(0.2, single=False), top)
    assert {check.verdict for check in found} == {"pass"}
    steps = {step.symbol: step.value for step in found[0].steps}
    assert (steps["H_C"], steps["μ_C"]) == (-700.0, None)
    assert "statically indeterminate" in found[0].caveat


def test_without_friction_it_fails_at_any_level() -> None:
    assert {(check.verdict, check.ratio) for check in checks(hinge(0.2, friction=0.0))} == {("fail", None)}


def test_the_sheet_can_be_redone_by_hand() -> None:
    check = checks(hinge(0.5))[1]
    steps = {step.symbol: step.value for step in check.steps}
    share = steps["a"] / steps["a_r"]
    assert steps["T_a"] == pytest.approx(share * steps["T_A"], rel=1e-12)
    assert steps["μ_d"] == pytest.approx(abs(steps["T_a"]) / steps["N_a"], rel=1e-12)
    assert check.ratio == pytest.approx(steps["μ_d"] / steps["μ"], rel=1e-12)
    assert all(step.formula and step.substituted and step.unit for step in check.steps)


def test_more_demand_never_lowers_the_ratio_and_more_friction_never_raises_it() -> None:
    rng = np.random.default_rng(3)
    for _ in range(200):
        normal, shear = rng.uniform(0.5, 2.0, 2), rng.uniform(-1.0, 1.0, 2)
        ends = {"resting": Pressure(normal[0], shear[0]), "starting": Pressure(normal[1], shear[1])}
        ratios = []
        for mu in (0.2, 0.5):
            found = checks(hinge(0.2, friction=mu, **ends))
            ratios.append([check.ratio for check in found])
            assert ratios[-1] == sorted(ratios[-1])
            for check in found:
                slides_at = check.capacity_pga_g
                assert (check.verdict == "fail") == (slides_at is not None and check.level_pga_g > slides_at)
        assert all(more <= less for less, more in zip(*ratios, strict=True))
