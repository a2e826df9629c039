"""The share of draws in which a rule holds, against all combinations of runs; what it decides; digits that stand."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from itertools import product
from math import inf, isfinite, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.constants import g

from assess.codes import ntc2018
from assess.codes.asce43_05 import Asce4305Options as AsceOptions
from assess.codes.asce43_05_history import assess_history as assess_asce43_history
from assess.codes.bases import BASES
from assess.codes.check import Outcome, Reason
from assess.codes.context import Context
from assess.codes.histories import (
    DRAWS,
    draw_runs,
    draw_values,
    fails_below,
    interval_figures,
    is_between,
    margin_figures,
    side_figures,
    standing_figures,
)
from assess.codes.italian_limit_states import ItalianOptions
from assess.codes.verdict import Decision, Index, decide, index_of, is_near
from assess.mechanisms.single_block import equivalent_block
from spectra.asce7 import design_spectrum
from tests.support.answered import suite_of_runs

BLOCK = equivalent_block("w", p=1.6, uplift=0.1, radius=3.0).oscillator
SPECTRUM = design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0)
ASCE = partial(assess_asce43_history, options=AsceOptions())
NTC = partial(ntc2018.assess_history, options=ItalianOptions())
LEVEL = 0.2 * g


def check(assess, *runs, scan=()):
    known = {"ntc2018": "LC3"}  # FC is 1
    suites = (suite_of_runs(LEVEL, np.array(runs, dtype=float)),)
    at = Context(SPECTRUM, (LEVEL,), 0.0, 0.0, None, suites=suites, incremental=scan, crushing=True, knowledge=known)
    (found,) = assess(BLOCK, at)
    return found


def spread(values, seed: int, records: int, overturned: float = 0.0):
    """Nine runs of each record around a value, some of them overturned."""
    random = np.random.default_rng(seed)
    runs = np.clip(values + 0.4 * random.normal(size=(9, records)), 0.0, None)
    return np.where(random.random((9, records)) < overturned, inf, runs)


@pytest.mark.parametrize(("value", "overturned"), [(0.5, 0.0), (0.35, 0.02), (0.3, 0.1), (0.55, 0.0)])
def test_the_share_is_that_of_all_combinations_of_runs(value, overturned):
    """Five records: the mean of each of 9^5 combinations against one half (ASCE 43-05)."""
    runs = spread(value, 5, 5, overturned)
    exact = np.mean([sum(each) / 5 <= 0.5 for each in product(*runs.T)])
    assert 0.05 < exact < 0.95
    found = check(ASCE, *runs).numerical
    assert found.holds == pytest.approx(exact, abs=4 * sqrt(exact * (1 - exact) / DRAWS))
    assert found.standing == pytest.approx(np.mean([isfinite(sum(each)) for each in product(*runs.T)]), rel=1e-12)


def test_the_share_of_the_largest_is_a_product():
    """Fewer than seven records: the largest displacement counts, so the shares of the records multiply (NTC 7.3.5)."""
    runs = np.full((9, 4), 0.1)
    runs[:2, 0], runs[4, 1], runs[5, 2] = 0.7, inf, 0.9
    exact = (7 / 9) * (8 / 9) * (8 / 9)
    found = check(NTC, *runs).numerical
    assert found.holds == pytest.approx(exact, rel=1e-12)
    assert (found.runs, found.draws) == (9, 500)


@pytest.mark.parametrize("assess", [ASCE, NTC])
def test_none_overturns_is_counted_and_not_drawn(assess):
    """Of twenty records two have one run of nine that overturns: (8/9)^2 of the choices stand, to rounding."""
    runs = np.full((9, 20), 0.05)
    runs[3, 4], runs[7, 11] = inf, inf
    found = check(assess, *runs).numerical
    assert (found.standing, found.within) == (pytest.approx(64 / 81, rel=1e-12), 1.0)
    assert found.holds == pytest.approx(64 / 81, rel=1e-12)


@given(
    seed=st.integers(0, 10**6), value=st.floats(0.1, 0.6), over=st.floats(0.0, 0.1), assess=st.sampled_from([ASCE, NTC])
)
def test_nothing_passes_below_the_share_or_against_the_records_as_they_are(seed, value, over, assess):
    runs = spread(value, seed, 7, over)
    found, alone = check(assess, *runs), check(assess, *[runs[0]] * 9)
    assert (found.ratio, found.demand, found.capacity) == (alone.ratio, alone.demand, alone.capacity)
    assert alone.numerical.holds in (0.0, 1.0)
    assert (found.verdict == Outcome.PASS) == (found.numerical.holds >= 0.84 and alone.verdict == Outcome.PASS)
    low, high = (inf if each is None else each for each in (found.numerical.ratio_16, found.numerical.ratio_84))
    assert low <= high


def test_a_pass_that_few_draws_confirm_is_a_fail_at_the_limit():
    runs = np.full((9, 7), 0.2)
    runs[1:4, :2] = inf
    found = check(ASCE, *runs)
    assert (found.verdict, found.reason.key) == (Outcome.FAIL, Reason.NUMERICAL_SPREAD)
    assert found.ratio == pytest.approx(0.4)
    assert is_between(found)
    assert is_near(found, Index("D/C", found.ratio), 1.0, 0.0)
    assert found.numerical.ratio_84 is None


def test_the_records_as_they_are_fail_though_most_draws_hold():
    """The one run of a record that overturns is that of the record itself."""
    runs = np.full((9, 7), 0.2)
    runs[0, 0] = inf
    found = check(ASCE, *runs)
    assert found.numerical.holds >= 0.84
    assert (found.verdict, found.reason.key) == (Outcome.FAIL, Reason.RECORDS_OVERTURN)
    assert "spread-would-pass" in [each.key for each in found.remarks]
    assert is_near(found, None, 1.0, 0.0)


def test_what_fails_in_all_draws_is_not_at_the_limit():
    found = check(ASCE, *np.full((9, 7), 0.9))
    assert (found.verdict, found.numerical.holds, is_near(found, None, 1.0, 0.0)) == (Outcome.FAIL, 0.0, False)


def test_every_level_has_the_same_draw_and_more_records_do_not_change_it():
    assert (draw_runs(7, 9) == draw_runs(7, 9)).all()
    assert (draw_runs(9, 9)[:, :7] == draw_runs(7, 9)).all()
    assert draw_runs(7, 9).shape == (500, 7)
    assert set(draw_runs(7, 9).ravel()) == set(range(9))
    values = np.arange(63.0).reshape(9, 7)
    assert (draw_values(values)[3] == [values[run, n] for n, run in enumerate(draw_runs(7, 9)[3])]).all()


FALLS = (0, 1, 2, 0, 5, 8, 9)
"""p is 1, about 8/9, about 7/9 (below 0.84), 1, about 4/9, 1/9 and 0, at 0.1 to 0.7 g: the one record by itself."""
SCAN = tuple(
    suite_of_runs((place + 1) * 0.1 * g, np.where((np.arange(9) >= 9 - falls)[:, None] & (np.arange(7) == 0), inf, 0.1))
    for place, falls in enumerate(FALLS)
)


def test_capacities_are_the_last_levels_before_too_few_draws_hold():
    found = check(ASCE, *np.full((9, 7), 0.1), scan=SCAN)
    assert found.capacity_pga_g == pytest.approx(0.2)
    assert found.numerical.capacity_50_pga_g == pytest.approx(0.4)
    assert found.numerical.capacity_16_pga_g == pytest.approx(0.5)
    assert found.verdict == Outcome.PASS  # at 0.2 g


def test_a_level_that_the_records_as_they_are_fail_ends_the_capacity():
    runs = np.full((9, 7), 0.1)
    runs[0, 0] = inf
    found = check(ASCE, *np.full((9, 7), 0.1), scan=(SCAN[0], suite_of_runs(0.15 * g, runs), *SCAN[1:]))
    assert found.capacity_pga_g == pytest.approx(0.1)
    assert found.numerical.capacity_50_pga_g == pytest.approx(0.4)


def test_an_index_is_at_the_limit_where_more_draws_would_reach_the_target():
    """Italian targets below one compare zeta_E: 0.2 g of 0.2 g, where half of the draws hold to 0.4 g."""
    found = check(NTC, *np.full((9, 7), 0.1), scan=SCAN)
    index = Index("ζ_E", found.safety_index)
    assert found.safety_index == pytest.approx(1.0)
    assert not is_near(found, index, 0.8, 0.0)
    assert is_near(found, index, 2.0, 0.0)
    assert not is_near(found, index, 3.0, 0.0)


@pytest.mark.parametrize("basis", ["ntc2018", "asce43-05"])
def test_a_level_that_passes_above_a_failure_of_the_scan_fails_at_the_limit(basis):
    """At 0.2 g all draws hold, at 0.15 g none: the margin is 0.1 / 0.2, which no target of one is reached with."""
    fallen = suite_of_runs(0.15 * g, np.full((9, 7), 0.9))
    assess = NTC if basis == "ntc2018" else ASCE
    found = check(assess, *np.full((9, 7), 0.1), scan=(SCAN[0], fallen, *SCAN[1:]))
    assert (found.verdict, found.capacity_pga_g) == (Outcome.PASS, pytest.approx(0.1))
    assert [each.key for each in found.remarks] == ["fails-below"]
    assert decide(found, BASES[basis], 1.0) == Decision.FAIL
    assert is_near(found, index_of(found, BASES[basis]), 1.0, 0.0)


@pytest.mark.parametrize("basis", ["ntc2018", "asce43-05"])
def test_a_pass_without_a_scan_has_a_condition(basis):
    assess = NTC if basis == "ntc2018" else ASCE
    scanned, alone = (check(assess, *np.full((9, 7), 0.1), scan=each) for each in (SCAN, ()))
    assert "not-scanned" not in [each.key for each in scanned.conditions]
    assert "not-scanned" in [each.key for each in alone.conditions]


def test_the_last_level_that_passes_fails_nowhere_below():
    """With FC = 1.35 the PGA of the level is multiplied and divided by it."""
    for level in np.linspace(0.05, 0.5, 200):
        assert fails_below(level * g * 1.35 / g / 1.35, level) == ()


def test_without_twins_there_is_no_spread():
    bare = replace(suite_of_runs(LEVEL, np.full((9, 7), 0.2)), twins=None)
    (found,) = ASCE(BLOCK, Context(SPECTRUM, (LEVEL,), 0.0, 0.0, None, suites=(bare,)))
    assert (found.numerical, found.verdict, is_between(found)) == (None, Outcome.PASS, False)


@pytest.mark.parametrize(
    ("value", "others", "figures"),
    [
        (0.1249, (0.1249,), 4),
        (0.1249, (0.12492,), 4),
        (0.1249, (0.1251,), 3),
        (0.1249, (0.12496,), 3),
        (1234.0, (1238.8,), 3),
        (0.1249, (0.116, 0.138), 1),
        (0.1249, (0.120, 0.1249), 2),
        (0.52, (0.9,), 0),
        (52.1, (52.13, 52.14), 3),
        (0.3, (None, 0.3), 0),
        (0.0, (0.0,), 4),
        (0.0, (0.1,), 0),
    ],
)
def test_figures_are_those_within_which_all_runs_are(value, others, figures):
    assert standing_figures(value, others) == figures
    for other in others if figures else ():
        assert abs(float(f"{value:.{figures}g}") - other) <= 10.0 ** (np.floor(np.log10(value or 1)) - figures + 1)


@pytest.mark.parametrize(
    ("value", "limit", "shown"),
    [
        (0.96, 1.0, "0.96"),  # one figure would be its limit
        (1.04, 1.0, "1.04"),
        (0.9996, 1.0, "0.9996"),
        (0.94, 1.0, "0.9"),
        (1.0, 1.0, "1"),
        (0.596, 0.6, "0.596"),
        (0.52, 0.55, "0.5"),
    ],
)
def test_a_number_keeps_its_side_of_the_limit(value, limit, shown):
    assert f"{value:.{side_figures(value, 1, limit=limit)}g}" == shown


def test_ends_of_an_interval_keep_their_sides_of_the_action():
    assert interval_figures(0.247, 0.28) == 2
    assert interval_figures(0.247, 0.28, limit=0.25) == 3
    assert margin_figures(1.196, 1.387) == 2
    assert margin_figures(0.98, 1.387) == 2  # one figure stands, and would be 1
    assert margin_figures(1.196, None) == 3
