"""What must hold for every procedure in the registry."""

from __future__ import annotations

import dataclasses
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import g

from assess.codes.asce41_13 import Asce41Options
from assess.codes.asce43_05 import Asce4305Options
from assess.codes.check import Reason
from assess.codes.context import Building, Context, Wall
from assess.codes.histories import SuiteResponse
from assess.codes.procedures import PROCEDURES, CodeOptions, apply_procedure, with_options
from assess.errors import ProcedureError
from assess.geometry.planar import planar_body_from_values
from assess.loads.load import Force
from assess.mechanisms.hinge_forces import hinge_forces
from assess.mechanisms.mechanism import Face
from assess.mechanisms.single_block import equivalent_block, single_block
from spectra.asce7 import design_spectrum
from spectra.ec8 import elastic_spectrum as ec8
from spectra.nzs1170_5 import site_spectrum as nzs1170_5
from spectra.table import table_spectrum
from tests.support.answered import ratio_of

LEVELS = tuple(level * g for level in (0.05, 0.2, 0.35, 0.6))
SUITES = tuple(SuiteResponse(level, (0.01, 0.02, 0.1, 0.2, 0.3), "positive") for level in LEVELS)
EVERY = pytest.mark.parametrize("name", PROCEDURES)
BY_SIZE = "asce41-13-ht"  # judges the wall's size, not its rocking
OWN_PERIODS = (BY_SIZE, "nzsee2017-face-loaded")  # clauses with periods or heights of their own, which do not scale
HOMES = {
    "nzsee2017-face-loaded": nzs1170_5(subsoil="C", z=0.4, r=1.0),
    "ec8-element": ec8(a_g=0.2 * g, ground_type="B"),
}


FRICTION = 0.15  # less than the uplift multiplier of the wall: it slides before it rocks
ROCKING = pytest.mark.parametrize("name", [name for name in PROCEDURES if not name.endswith("sliding")])


def site(*, stretch=1.0, levels=LEVELS):
    spectrum = design_spectrum(s_ds=0.5 * g, s_d1=0.25 * g * stretch, t_l=6.0 * stretch)
    house = Building(height=8.0, storeys=None, period=0.24, damping=0.05)
    block = equivalent_block("w", p=1.8, uplift=0.18, radius=2.4, mass=5000.0)
    stands = dataclasses.replace(block, faces=((Face(friction=FRICTION),),) * 2)
    forces = hinge_forces(stands)
    return Context(
        spectrum,
        levels,
        0.0,
        0.0,
        house,
        SUITES,
        SUITES,
        support="spanning",
        wall=Wall(4.0, 0.28),
        hinges=forces,
        rise=4.0,
        crushing=True,  # with LC3 the Italian FC is 1, so that the suites of the levels serve
        knowledge={"dmi2008": "LC3", "ntc2018": "LC3"},
    )


def wall(*, size=1.0):
    block = equivalent_block("w", p=1.8 / np.sqrt(size), uplift=0.18, radius=2.4 * size, mass=5000.0)
    return block.oscillator


def answers(name, rocker=None, context=None, *, size=1.0):
    """What the procedure itself says, whether or not it may be asked."""
    return procedure_of(name, size=size)(rocker or wall(size=size), context or site())


def procedure_of(name, *, size=1.0):
    known = Asce41Options(position="other")  # of a wall whose storey nobody gave, nothing between is answered
    return with_options(name, CodeOptions(asce43_05=Asce4305Options(allowable_sliding=0.02 * size), asce41_13=known))


@EVERY
def test_every_level_is_answered_in_order(name):
    assert [check.level_pga_g for check in answers(name)] == pytest.approx([level / g for level in LEVELS])
    assert {check.procedure for check in answers(name)} == {name}


@EVERY
def test_verdict_agrees_with_demand_and_capacity(name):
    for check in answers(name):
        assert check.verdict == ("pass" if check.ratio is not None and check.ratio <= 1 else "fail")
        if check.demand is not None:
            assert check.ratio == pytest.approx(check.demand / check.capacity, rel=1e-12)


@EVERY
def test_demand_does_not_fall_as_the_ground_shakes_harder(name):
    ratios = list(map(ratio_of, answers(name)))
    assert ratios == sorted(ratios)


@EVERY
def test_demand_meets_capacity_at_the_pga_of_collapse(name):
    if name.endswith("-history"):
        pytest.skip("its PGA at collapse comes from a scan of time histories, not from a formula")
    at_collapse = answers(name)[0].capacity_pga_g * g
    below, above = answers(name, context=site(levels=(at_collapse * (1 - 1e-6), at_collapse * (1 + 1e-6))))
    assert (below.verdict, above.verdict) == ("pass", "fail")


@EVERY
def test_a_wall_twice_as_large_under_a_spectrum_of_longer_periods_fares_the_same(name):
    """Froude: lengths times k, times times sqrt(k), accelerations and angles unchanged."""
    if name in OWN_PERIODS:
        pytest.skip("the clause has periods of its own")
    k = 2.0
    for small, large in zip(answers(name), answers(name, context=site(stretch=np.sqrt(k)), size=k), strict=True):
        assert large.verdict == small.verdict
        assert large.capacity_pga_g == (small.capacity_pga_g and pytest.approx(small.capacity_pga_g, rel=1e-7))
        assert large.ratio == (small.ratio and pytest.approx(small.ratio, rel=1e-7))


@ROCKING
def test_the_worse_branch_is_the_answer(name):
    leaning = planar_body_from_values(mass=1000.0, centroid=(0.1, 2.0), inertia=900.0, name="w")
    towards = single_block("w", leaning, hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0))
    upright = single_block(
        "w", dataclasses.replace(leaning, centroid=(0.0, 2.0)), hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0)
    )
    for one, plain in zip(answers(name, towards.oscillator), answers(name, upright.oscillator), strict=True):
        assert one.branch == "positive"
        if one.capacity_pga_g is not None and not name.endswith("-history") and name != BY_SIZE:
            assert one.capacity_pga_g < plain.capacity_pga_g


@st.composite
def walls_and_sites(draw):
    """A wall, its restitution, a spectrum with a short or a long plateau, levels, vertical motion or none."""
    slender, radius = draw(st.floats(0.05, 0.8)), draw(st.floats(0.2, 8.0))
    p = np.sqrt(g / (radius * draw(st.floats(1.2, 1.4))))
    kept = (draw(st.sampled_from([0.0, 0.3, 0.9, 1.0])),) * 2
    plateau = draw(st.floats(0.2, 1.5)) * g
    spectrum = design_spectrum(s_ds=plateau, s_d1=plateau * draw(st.sampled_from([0.3, 1.0, 3.0])), t_l=8.0)
    times = draw(st.lists(st.floats(0.2, 8.0), min_size=12, max_size=12, unique=True))
    levels = tuple(sorted(each * slender * g for each in times))
    rocker = equivalent_block("w", p=p, uplift=slender, radius=radius, restitution=kept).oscillator
    return rocker, Context(spectrum, levels, draw(st.sampled_from([0.0, 0.7])), 0.0, None)


@pytest.mark.parametrize("name", [name for name in PROCEDURES if not name.endswith("-history")])
@given(case=walls_and_sites())
def test_pass_is_the_same_as_a_level_below_the_pga_at_capacity(name, case):
    checks = [check for check in answers(name, *case) if check.verdict in ("pass", "fail")]
    for check in checks:
        capable = np.inf if check.capacity_pga_g is None and name == BY_SIZE else check.capacity_pga_g
        assert (check.verdict == "pass") == (check.level_pga_g <= capable * (1 + 1e-9))
    rotations = [np.inf if check.rotation_ratio is None else check.rotation_ratio for check in checks]
    assert all(check.rotation_ratio is None for check in checks) or rotations == sorted(rotations)


@EVERY
def test_a_spectrum_that_ends_early_claims_nothing_it_cannot_know(name):
    period = np.array([0.0, 0.1, 0.4, 0.8, 1.5])
    spectrum = table_spectrum(period, np.array([0.4, 1.0, 1.0, 0.5, 0.27]) * g)
    levels = (0.1 * g, 0.5 * g, 4.0 * g)
    suites = tuple(dataclasses.replace(SUITES[0], pga=level) for level in levels)
    checks = answers(name, wall(size=3.0), dataclasses.replace(site(levels=levels), spectrum=spectrum, suites=suites))
    assert checks[0].verdict in ("pass", "not-answered")
    for check in checks:
        assert check.verdict != "not-applicable"
        assert "table" in check.reason.text or check.verdict != "not-answered"


def test_the_ground_alone_can_fail_a_mechanism_above_it_but_not_pass_it():
    raised = dataclasses.replace(site(levels=(0.05 * g, 1.5 * g)), elevation=4.0)
    for name in ("dmi2008-linear", "dmi2008-nonlinear", "ntc2018-linear", "ntc2018-nonlinear"):
        low, high = apply_procedure(name, procedure_of(name), wall(), raised)
        assert (low.verdict, high.verdict) == ("not-answered", "fail")
        assert low.reason.key == Reason.GROUND_MOTION
        assert "[building]" in low.reason.text


@EVERY
def test_every_step_is_traceable(name):
    for check in answers(name):
        assert check.steps
        for step in check.steps:
            assert step.symbol
            assert step.description
            assert step.clause
            assert step.formula
            assert step.substituted
            assert step.unit


@EVERY
def test_curve_passes_through_the_point_of_collapse(name):
    check = answers(name)[-1]
    curve = check.pga_curve
    if not curve.rotation_ratio or name.endswith("-history"):
        pytest.skip("no curve from a formula")
    at = np.interp(check.capacity_rotation_ratio, curve.rotation_ratio, curve.pga_g)
    assert at == pytest.approx(check.capacity_pga_g, rel=2e-4)  # linear between points of the curve


def test_readings_of_the_thesis_are_named_so_and_spectra_of_another_family_are_told():
    for name in PROCEDURES:
        home = dataclasses.replace(site(), spectrum=HOMES.get(name, site().spectrum))
        at_home, abroad = answers(name, context=home), answers(name)
        assert {check.reading for check in at_home} == {"thesis" if name.endswith("-thesis") else "letter"}
        assert {check.role for check in at_home} == {"comparison"}  # what decides is found at the end of a run
        assert not any("here on one of" in check.caveat for check in at_home)
        assert all("here on one of" in check.caveat for check in abroad) == (name in HOMES)


@EVERY
def test_a_wider_base_never_makes_an_answer_worse(name):
    """Walls of one height and mass, thicker and thicker, on their base or between floors."""
    if name.endswith("-history"):
        pytest.skip("its histories are given")
    house = Building(height=8.0, storeys=2, period=0.24, damping=0.05)
    for support, elevation in (("free", 0.0), ("spanning", 0.0), ("spanning", 4.0)):
        before = None
        for t in (0.2, 0.3, 0.45, 0.7, 1.0):
            body = planar_body_from_values(
                mass=5000.0, centroid=(0.0, 2.0), inertia=5000.0 * (t**2 + 16.0) / 12.0, name="w"
            )
            rocker = single_block("w", body, hinge=(t / 2, 0.0), hinge_negative=(-t / 2, 0.0)).oscillator
            context = dataclasses.replace(
                site(),
                elevation=elevation,
                floor_spectrum=dataclasses.replace(site().spectrum, factor=1.7),
                building=house,
                support=support,
                wall=Wall(4.0, t),
                rise=4.0 * (support == "spanning"),
            )
            checks = answers(name, rocker, context)
            assert before is None or not any(worse(now, then) for now, then in zip(checks, before, strict=True))
            before = checks


BADNESS = {"pass": 0, "not-answered": 1, "not-applicable": 1, "fail": 2}


def worse(now, before):
    """Whether an answer is worse than another: by its outcome, or by its ratio of demand to capacity."""
    return BADNESS[now.verdict] > BADNESS[before.verdict] or ratio_of(now) > ratio_of(before) * (1 + 1e-9)


@pytest.mark.parametrize("name", [name for name in PROCEDURES if not name.endswith(("-history", "sliding"))])
def test_more_restoring_never_makes_an_answer_worse(name):
    """A force that holds the wall back, larger and larger, on the ground and between floors."""
    inertia = 5000.0 * (0.45**2 + 16.0) / 12.0
    body = planar_body_from_values(mass=5000.0, centroid=(0.0, 2.0), inertia=inertia, name="w")
    for support in ("free", "spanning"):
        where = dataclasses.replace(site(), support=support, rise=4.0 * (support == "spanning"))
        before = None
        for force in (0.0, 200.0, 500.0, 1000.0, 2000.0, 4000.0):
            loads = (
                (Force("held", (-force, 0.0), (0.0, 4.0)),) if force else ()
            )  # at the top of a wall that rocks one way
            held = single_block("w", body, sides="one", hinge=(0.225, 0.0), loads=loads).oscillator
            checks = answers(name, held, where)
            assert before is None or not any(worse(now, then) for now, then in zip(checks, before, strict=True))
            before = checks


@EVERY
@pytest.mark.parametrize("elevation", [0.0, 4.0])
def test_a_lower_action_never_makes_an_answer_worse(name, elevation):
    """What may only fail included: the weaker the ground, the less there is to fail."""
    house = Building(height=8.0, storeys=2, period=0.24, damping=0.05)
    levels = tuple(np.geomspace(0.01, 2.0, 25) * g)
    shares = np.minimum(np.geomspace(0.01, 2.0, 25), 0.99)
    suites = tuple(
        SuiteResponse(level, (*((share,) * 6), None if share > 0.9 else share), "positive")
        for level, share in zip(levels, shares, strict=True)
    )
    where = dataclasses.replace(
        site(levels=levels), suites=suites, incremental=(), elevation=elevation, building=house, rise=0.0
    )
    checks = [
        check for check in apply_procedure(name, procedure_of(name), wall(), where) if check.verdict != "not-applicable"
    ]
    assert not any(worse(weak, strong) for weak, strong in pairwise(checks))


@pytest.mark.parametrize("name", [name for name in PROCEDURES if name.endswith("-history")])
@given(turned=st.lists(st.floats(0.0, 0.8), min_size=7, max_size=7))
def test_a_record_that_turns_farther_never_makes_an_answer_better(name, turned):
    first, *others = turned
    before = None
    for farther in (first, 1.1 * first, 1.2 * first, None):
        suite = SuiteResponse(LEVELS[0], (farther, *others), "positive")
        where = dataclasses.replace(site(levels=LEVELS[:1]), suites=(suite,), incremental=(), extra_suites=(suite,))
        checks = answers(name, context=where)
        assert before is None or not any(worse(then, now) for then, now in zip(before, checks, strict=True))
        before = checks


def test_unknown_procedure_lists_the_known_ones():
    with pytest.raises(ProcedureError, match="asce43-05-spectrum"):
        with_options("ntc1900", CodeOptions())


def test_fewer_than_five_records_decide_nothing():
    few = dataclasses.replace(site(), suites=(SuiteResponse(LEVELS[0], (0.1, 0.2), "positive"),), incremental=())
    (check,) = answers("asce43-05-history", context=few)
    assert (check.verdict, check.reason.key) == ("not-answered", Reason.TOO_FEW_RECORDS)
    assert check.rotation_ratio == pytest.approx(0.15)


def test_one_record_that_overturns_fails_the_level():
    fallen = dataclasses.replace(site(), suites=(SuiteResponse(LEVELS[0], (0.1, None, 0.0, 0.0, 0.0), "negative"),))
    (check,) = answers("asce43-05-history", context=fallen)
    assert (check.verdict, check.demand, check.branch) == ("fail", None, "negative")


def test_histories_by_the_linearised_equation_lift_off_at_its_own_multiplier():
    stocky = equivalent_block("w", p=3.36, uplift=0.54, radius=0.62).oscillator
    for linearised, uplift in ((False, np.tan(0.54)), (True, 0.54)):
        context = dataclasses.replace(site(), linearised=linearised)
        assert answers("asce43-05-history", stocky, context)[0].uplift_pga_g == pytest.approx(uplift, rel=1e-9)


@pytest.mark.parametrize("name", ["dmi2008-nonlinear", "ntc2018-nonlinear", "dmi2008-history", "ntc2018-history"])
def test_displacement_and_acceleration_of_the_curve_follow_from_the_numbers_printed(name):
    worked = [step for check in answers(name) for step in check.steps if step.symbol in ("d0*", "a_s*", "a(d_SLV)")]
    assert worked
    for step in worked:
        over, under = (
            [float(number) for number in part.strip("() ").split(" · ")] for part in step.substituted.split("/")
        )
        assert step.value == pytest.approx(np.prod(over) / np.prod(under), rel=1e-4)  # five figures are printed


def test_the_spectrum_method_says_why_a_body_that_lifts_off_has_no_lasting_rotation():
    damped = dataclasses.replace(wall().positive, restitution=0.3)
    rocker = dataclasses.replace(wall(), positive=damped, negative=None)
    lifts = answers("asce43-05-spectrum", rocker)[0].uplift_pga_g
    check = answers("asce43-05-spectrum", rocker, site(levels=(1.02 * lifts * g,)))[0]
    assert (check.demand, check.reason.key) == (0.0, Reason.NO_LASTING)
    resting = next(step for step in check.steps if step.symbol == "θ_dem")
    asked, least = (each.value for each in resting.at)
    assert asked == pytest.approx(1.02 * lifts, rel=1e-3)
    curve = check.pga_curve
    assert asked <= least <= min(curve.pga_g[1:]) * (1 + 1e-3)
