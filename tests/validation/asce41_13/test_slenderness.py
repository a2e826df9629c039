"""ASCE 41-13 Table 11-5: a wall 4.2 m high and 0.33 m thick, h/t = 12.73, at S_X1 = 0.45 g, and the table's steps."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.asce41_13 import (
    ASCE41_13_SLENDERNESS,
    Asce41Options,
    assess_slenderness,
    permissible_slenderness,
    permitted_s_x1,
    position_of,
)
from assess.codes.check import Reason
from assess.codes.context import Building, Context, Wall
from assess.mechanisms.single_block import equivalent_block
from spectra.asce7 import design_spectrum
from spectra.ec8 import elastic_spectrum
from spectra.table import table_spectrum
from tests.support.answered import checks_of

WALL = Wall(4.2, 0.33)
SPECTRUM = design_spectrum(s_ds=1.0 * g, s_d1=0.45 * g, t_l=6.0)  # S_a(0) = 0.4 g, S_a(1 s) = 0.45 g
AT = Context(SPECTRUM, (0.4 * g,), 0.0, 0.0, None, support="spanning", wall=WALL)
BLOCK = equivalent_block("w", p=1.8, uplift=0.08, radius=2.1).oscillator


@pytest.mark.parametrize(
    ("position", "most", "verdict"),
    [
        ("first-storey", 15.0, "pass"),
        ("top-storey", 9.0, "fail"),
        ("other", 13.0, "pass"),
        ("one-storey", 13.0, "pass"),
    ],
)
def test_wall_by_its_place(position, most, verdict) -> None:
    (check,) = assess_slenderness(BLOCK, AT, options=Asce41Options(position))
    assert (check.demand, check.capacity) == pytest.approx((12.727, most), rel=1e-4)
    assert check.ratio == pytest.approx(12.727 / most, rel=1e-4)
    assert (check.verdict, check.role, check.reading) == (verdict, "comparison", "letter")


@pytest.mark.parametrize(("s_x1", "column"), [(0.0, 0), (0.24, 0), (0.2401, 1), (0.37, 1), (0.3701, 2), (3.0, 2)])
def test_columns(s_x1, column) -> None:
    rows = {"one-storey": (20, 16, 13), "first-storey": (20, 18, 15), "top-storey": (14, 14, 9), "other": (20, 16, 13)}
    for position, row in rows.items():
        assert permissible_slenderness(position, s_x1) == row[column]


@pytest.mark.parametrize(
    ("slenderness", "bound"), [(13.0, None), (13.1, 0.37), (16.0, 0.37), (16.1, 0.24), (20.1, 0.0)]
)
def test_s_x1_up_to_which_a_wall_is_permitted(slenderness, bound) -> None:
    assert permitted_s_x1("other", slenderness) == bound


def test_pga_at_capacity_is_where_the_column_ends() -> None:
    """h/t = 15 in row "other": up to S_X1 = 0.37 g, PGA = 0.37 x 0.4 / 0.45."""
    at = dataclasses.replace(AT, wall=Wall(4.95, 0.33))
    (check,) = assess_slenderness(BLOCK, at, options=Asce41Options("other"))
    assert check.capacity_pga_g == pytest.approx(0.37 * 0.4 / 0.45, rel=1e-12)


@pytest.mark.parametrize(
    ("elevation", "storeys", "place"),
    [
        (0.0, 2, "first-storey"),
        (4.2, 2, "top-storey"),
        (0.0, 1, "one-storey"),
        (0.0, None, None),
        (2.1, 4, "other"),
        (4.2, 4, "top-storey"),
    ],
)
def test_place_by_storeys_and_elevation(elevation, storeys, place) -> None:
    assert position_of(WALL, elevation, Building(8.4, storeys, 0.24, 0.05)) == place


def test_a_wall_as_high_as_the_building_is_in_the_top_storey() -> None:
    assert position_of(Wall(8.4, 0.5), 0.0, Building(8.4, 2, 0.24, 0.05)) == "top-storey"


@pytest.mark.parametrize(
    ("height", "verdict"),
    [(2.96, "pass"), (3.0, "not-answered"), (4.94, "not-answered"), (5.0, "fail")],
)
def test_without_storeys_a_wall_passes_by_the_strictest_row_and_fails_by_the_mildest(height, verdict) -> None:
    """S_X1 = 0.45 g: 9 in the top storey, 15 in the first."""
    (check,) = assess_slenderness(BLOCK, dataclasses.replace(AT, wall=Wall(height, 0.33)), options=Asce41Options())
    assert (check.verdict, check.capacity) == (verdict, 9.0)
    assert (check.reason.key == Reason.STOREY_UNKNOWN) == (verdict == "not-answered")


def test_a_place_that_nobody_gave_is_said() -> None:
    (check,) = assess_slenderness(BLOCK, AT, options=Asce41Options())
    (step,) = (step for step in check.steps if step.symbol == "max h/t")
    assert "not known" in step.remark


def test_on_a_spectrum_of_another_family_it_says_so() -> None:
    abroad = dataclasses.replace(AT, spectrum=elastic_spectrum(a_g=0.2 * g, ground_type="B"))
    (foreign,) = assess_slenderness(BLOCK, abroad, options=Asce41Options())
    assert "one of ec8" in foreign.caveat


SHORT = table_spectrum(np.array([0.0, 0.8]), np.array([0.4, 0.9]) * g)
MISSING = {
    "no geometry": ({"wall": None}, "not-applicable", Reason.NO_WALL_SIZE),
    "stands free": ({"support": "free"}, "not-applicable", Reason.NOT_SPANNING),
    "hinges": ({"support": "hinged"}, "not-applicable", Reason.NOT_SPANNING),
    "table": ({"spectrum": SHORT}, "not-answered", Reason.NOT_BY_NAME),
    "short": ({"spectrum": dataclasses.replace(SPECTRUM, longest_period=0.8)}, "not-answered", "spectrum-too-short"),
}


@pytest.mark.parametrize(("change", "verdict", "reason"), list(MISSING.values()), ids=list(MISSING))
def test_what_is_missing_is_said(change, verdict, reason) -> None:
    (check,) = checks_of(ASCE41_13_SLENDERNESS.name, BLOCK, dataclasses.replace(AT, **change))
    assert (check.verdict, check.reason.key) == (verdict, reason)


def parapet(height: float, *, base: float = 8.4) -> Context:
    """A parapet 0.33 m thick on a building of 8.4 m."""
    return dataclasses.replace(
        AT, support="free", wall=Wall(height, 0.33), elevation=base, building=Building(8.4, 2, 0.24, 0.05), rise=0.0
    )


@pytest.mark.parametrize(
    ("seismicity", "height", "verdict"),
    [("high", 0.49, "pass"), ("high", 0.5, "fail"), ("moderate", 0.82, "pass"), ("moderate", 0.83, "fail")],
)
def test_parapets_have_limits_of_their_own(seismicity, height, verdict) -> None:
    """h/t at most 1.5 in high seismicity, 2.5 in moderate."""
    (check,) = assess_slenderness(BLOCK, parapet(height), options=Asce41Options(seismicity=seismicity))
    assert (check.verdict, check.ratio) == (
        verdict,
        pytest.approx(height / 0.33 / {"high": 1.5, "moderate": 2.5}[seismicity]),
    )


def test_what_stands_free_elsewhere_is_no_parapet() -> None:
    for context in (parapet(0.4, base=4.2), dataclasses.replace(parapet(0.4), building=None)):
        (check,) = assess_slenderness(BLOCK, context, options=Asce41Options())
        assert (check.verdict, check.reason.key) == ("not-applicable", Reason.NOT_SPANNING)


@pytest.mark.parametrize(
    ("elevation", "rise", "verdict"),
    [(4.2, 4.2, "fail"), (4.2, 4.3, "not-answered"), (9.0, 4.2, "not-answered"), (0.0, 4.2, "pass")],
)
def test_supports_above_the_building_are_refused(elevation, rise, verdict) -> None:
    """Between floors of a building of 8.4 m: a wall whose upper support would be at 8.5 m hangs on nothing."""
    walled = dataclasses.replace(AT, building=Building(8.4, 2, 0.24, 0.05), elevation=elevation, rise=rise)
    (check,) = checks_of(ASCE41_13_SLENDERNESS.name, BLOCK, walled)
    assert check.verdict == verdict
    assert (check.reason.key == Reason.ABOVE_BUILDING) == (verdict == "not-answered")


@pytest.mark.parametrize(("base", "verdict"), [(8.4, "pass"), (9.0, "not-answered")])
def test_a_parapet_above_its_building_is_refused(base, verdict) -> None:
    (check,) = checks_of(ASCE41_13_SLENDERNESS.name, BLOCK, parapet(0.49, base=base))
    assert (check.verdict, check.may_pass) == (verdict, verdict == "pass")


def test_rubble_is_not_judged_and_unknown_masonry_is_a_condition() -> None:
    (rubble,) = assess_slenderness(BLOCK, AT, options=Asce41Options(masonry="rubble"))
    assert (rubble.verdict, rubble.reason.key) == ("not-applicable", Reason.RUBBLE)
    (unknown,) = assess_slenderness(BLOCK, AT, options=Asce41Options())
    assert [condition.key for condition in unknown.conditions] == ["premise-coursed"]
    (coursed,) = assess_slenderness(BLOCK, AT, options=Asce41Options(masonry="coursed"))
    assert coursed.conditions == ()


def test_a_wall_between_floors_and_a_parapet_have_premises_of_their_own() -> None:
    """Floors and roof hold a wall at both ends; a parapet has none above, and the roof holds the wall at its foot."""
    walled = dataclasses.replace(AT, building=Building(8.4, 2, 0.24, 0.05))
    (wall,) = checks_of(ASCE41_13_SLENDERNESS.name, BLOCK, walled)
    (free,) = checks_of(ASCE41_13_SLENDERNESS.name, BLOCK, parapet(0.49, base=8.4))
    assert [each.key for each in wall.conditions] == ["premise-anchorage", "premise-collar-joints", "premise-coursed"]
    assert [each.key for each in free.conditions] == [
        "premise-anchorage-foot",
        "premise-collar-joints",
        "premise-coursed",
    ]


def test_s_x1_given_by_name_answers_on_a_table() -> None:
    """S_X1 = 0.45 g at the table's PGA of 0.4 g, so half of it at 0.2 g: 0.225 g is the first column."""
    table = dataclasses.replace(AT, spectrum=SHORT, levels=(0.2 * g, 0.4 * g))
    half, whole = assess_slenderness(BLOCK, table, options=Asce41Options(position="top-storey", s_x1=0.45 * g))
    assert (half.capacity, whole.capacity) == (14.0, 9.0)
